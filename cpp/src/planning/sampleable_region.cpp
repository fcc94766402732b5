// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/sampleable_region.hpp"

#include <limits>

namespace graspless::planning {

SampleableRegion::~SampleableRegion() = default;

std::optional<double> SampleableRegion::try_sample_partner(const ompl::base::State*,
                                                           ompl::base::State*, double) const {
  return std::nullopt;
}

void SampleableRegion::sampleGoal(ompl::base::State* state) const {
  constexpr int kAttempts = 1000;
  for (int i = 0; i < kAttempts; ++i) {
    if (try_sample(state)) return;
  }
}

unsigned int SampleableRegion::maxSampleCount() const {
  return std::numeric_limits<unsigned int>::max();
}

double SampleableRegion::distanceGoal(const ompl::base::State*) const {
  return std::numeric_limits<double>::infinity();  // the region can only be sampled
}

}  // namespace graspless::planning
