// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "graspless/export.hpp"

namespace graspless::planning {

/// A region of start or goal states in which sampling may fail, as inverse kinematics does.
class GRASPLESS_API SampleableRegion : public ompl::base::GoalSampleableRegion {
 public:
  using ompl::base::GoalSampleableRegion::GoalSampleableRegion;
  ~SampleableRegion() override;

  /// Samples one state; false if this sample failed.
  virtual bool try_sample(ompl::base::State* state) const = 0;

  /// Samples a goal that forms a valid pair with `start` by construction, and returns the cost of
  /// the pair: cheaper pairs are connected first. Nothing if this sample failed, if it would cost
  /// `max_cost` or more, or if the region cannot construct such goals (the default).
  virtual std::optional<double> try_sample_partner(const ompl::base::State* start,
                                                   ompl::base::State* goal, double max_cost) const;

  /// OMPL's interface: samples until one succeeds, at most 1000 times. If none does, the state
  /// keeps its value.
  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override;
  double distanceGoal(const ompl::base::State* state) const override;
};

}  // namespace graspless::planning
