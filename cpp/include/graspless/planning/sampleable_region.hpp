// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "graspless/export.hpp"

namespace graspless::planning {

/// A region of start or goal states whose draws may fail, as those of inverse kinematics do.
class GRASPLESS_API SampleableRegion : public ompl::base::GoalSampleableRegion {
 public:
  using ompl::base::GoalSampleableRegion::GoalSampleableRegion;
  ~SampleableRegion() override;

  /// Draws one state; false when this draw found none.
  virtual bool try_sample(ompl::base::State* state) const = 0;

  /// Draws a goal that makes a valid pair with `start` by construction; false when this draw found
  /// none or the region knows no such way.
  virtual bool try_sample_partner(const ompl::base::State* start, ompl::base::State* goal) const;

  /// OMPL's form: draws until one succeeds, a thousand times at most; the state is left as it was
  /// otherwise.
  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override;
  double distanceGoal(const ompl::base::State* state) const override;
};

}  // namespace graspless::planning
