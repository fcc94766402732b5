// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "graspless/planning/sampleable_region.hpp"

#include "slide/motions.hpp"
#include "slide/query.hpp"

/// Regions from which the planner samples: C_s of Eq. (3), C_g of Eq. (4), and goals that fit a
/// start.
namespace graspless::slide {

class GRASPLESS_API StartRegion : public planning::SampleableRegion {
 public:
  StartRegion(const ompl::base::SpaceInformationPtr& si, Query& query);
  bool try_sample(ompl::base::State* state) const override;

 private:
  Query& query_;
  std::vector<std::int32_t> inside_;  ///< contact points far enough inside the outline
  mutable int refused_ = 0;           ///< draws in a row whose nearest configuration is not valid
};

class GRASPLESS_API GoalRegion : public planning::SampleableRegion {
 public:
  GoalRegion(const ompl::base::SpaceInformationPtr& si, Query& query, Motions& motions);
  bool try_sample(ompl::base::State* state) const override;
  bool try_sample_partner(const ompl::base::State* start, ompl::base::State* goal) const override;
  bool isStartGoalPairValid(const ompl::base::State* start,
                            const ompl::base::State* goal) const override;

 private:
  std::optional<Planar> draw_object_pose(const ContactSpace::Carried& carried) const;

  Query& query_;
  Motions& motions_;
};

}  // namespace graspless::slide
