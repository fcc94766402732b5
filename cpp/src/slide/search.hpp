// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/SpaceInformation.h>

#include "graspless/planning/forest_cbirrt.hpp"

#include "slide/regions.hpp"

namespace graspless::slide {

/// OMPL objects of one query: ForestCBiRRT (Algorithm 1) over the arm's joints.
struct SlideSearch {
  std::shared_ptr<ompl::base::ProblemDefinition> problem;
  std::shared_ptr<planning::ForestCBiRRT> planner;
};

/// Makes the state space of the arm's joints. A state is valid if it presses on the support without
/// collision.
GRASPLESS_API ompl::base::SpaceInformationPtr make_space(Query& query);

/// Makes the planner between two regions of that space, with the relaxed contact constraint of
/// Section IV-C.3. Without `starts`, the start states of `problem` are the roots. The query must
/// outlive it.
GRASPLESS_API SlideSearch
make_search(Query& query, const ompl::base::SpaceInformationPtr& si,
            std::shared_ptr<const ompl::base::GoalSampleableRegion> starts,
            std::shared_ptr<ompl::base::GoalSampleableRegion> goals);

}  // namespace graspless::slide
