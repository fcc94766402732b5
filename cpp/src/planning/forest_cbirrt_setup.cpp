// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ForestCBiRRT: OMPL's planner interface except solve().

#include <ompl/base/SpaceInformation.h>
#include <ompl/tools/config/SelfConfig.h>

#include "graspless/planning/forest_cbirrt.hpp"

#include "planning/forest.hpp"
#include "planning/root_components.hpp"
#include "text.hpp"

namespace graspless::planning {

namespace ob = ompl::base;

ForestCBiRRT::ForestCBiRRT(const ob::SpaceInformationPtr& si) : ob::Planner(si, "ForestCBiRRT") {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.directed = true;
  declareParam<double>("range", this, &ForestCBiRRT::set_range, &ForestCBiRRT::range,
                       "0.:1.:10000.");
  declareParam<double>("root_scale", this, &ForestCBiRRT::set_root_scale, &ForestCBiRRT::root_scale,
                       "1:10000");
}

ForestCBiRRT::~ForestCBiRRT() = default;

void ForestCBiRRT::set_start_region(std::shared_ptr<const ob::GoalSampleableRegion> region) {
  start_region_ = std::move(region);
}

void ForestCBiRRT::set_root_scale(double root_scale) {
  require(root_scale > 0, "root_scale", root_scale, "must be positive");
  root_scale_ = root_scale;
}

void ForestCBiRRT::set_range(double range) {
  require(range >= 0, "range", range, "must not be negative");
  range_ = range;
}

void ForestCBiRRT::setup() {
  ob::Planner::setup();
  if (range_ == 0) ompl::tools::SelfConfig(si_, getName()).configurePlannerRange(range_);
  if (!sampler_) sampler_ = si_->allocStateSampler();
  if (start_forest_) return;
  start_forest_ = std::make_unique<Forest>(si_);
  goal_forest_ = std::make_unique<Forest>(si_);
  components_ = std::make_unique<RootComponents>();
  next_ = start_forest_.get();
}

void ForestCBiRRT::clear() {
  ob::Planner::clear();
  start_forest_.reset();
  goal_forest_.reset();
  components_.reset();
  refused_.clear();
  num_pairs_ = 0;
  setup_ = false;
}

std::size_t ForestCBiRRT::num_start_roots() const {
  return start_forest_ ? start_forest_->roots().size() : 0;
}
std::size_t ForestCBiRRT::num_goal_roots() const {
  return goal_forest_ ? goal_forest_->roots().size() : 0;
}
std::size_t ForestCBiRRT::num_nodes() const {
  return start_forest_ ? static_cast<std::size_t>(start_forest_->size() + goal_forest_->size()) : 0;
}

void ForestCBiRRT::getPlannerData(ob::PlannerData& data) const {
  ob::Planner::getPlannerData(data);
  if (!start_forest_) return;
  for (const Forest* forest : {start_forest_.get(), goal_forest_.get()}) {
    const bool is_start = forest == start_forest_.get();
    for (int i = 0; i < forest->size(); ++i) {
      const ob::PlannerDataVertex vertex(forest->state(i)),
          parent(forest->state(forest->parent(i)));
      if (forest->parent(i) == i) {
        is_start ? data.addStartVertex(vertex) : data.addGoalVertex(vertex);
      } else {
        is_start ? data.addEdge(parent, vertex) : data.addEdge(vertex, parent);
      }
    }
  }
}

}  // namespace graspless::planning
