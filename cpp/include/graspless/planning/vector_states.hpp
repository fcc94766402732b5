// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Conversions between Eigen vectors and OMPL states of a box of configurations.
#pragma once

#include <memory>
#include <random>

#include <Eigen/Core>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include "graspless/planning/path.hpp"

namespace graspless::planning {

inline Eigen::Map<const Eigen::VectorXd> vector(const ompl::base::State* state, Eigen::Index n) {
  return {state->as<ompl::base::RealVectorStateSpace::StateType>()->values, n};
}
inline Eigen::Map<Eigen::VectorXd> vector(ompl::base::State* state, Eigen::Index n) {
  return {state->as<ompl::base::RealVectorStateSpace::StateType>()->values, n};
}

inline std::shared_ptr<ompl::base::RealVectorStateSpace> make_box(const Eigen::VectorXd& lower,
                                                                  const Eigen::VectorXd& upper) {
  const auto n = static_cast<unsigned>(lower.size());
  auto space = std::make_shared<ompl::base::RealVectorStateSpace>(n);
  ompl::base::RealVectorBounds bounds(n);
  for (unsigned i = 0; i < n; ++i) {
    bounds.setLow(i, lower[i]);
    bounds.setHigh(i, upper[i]);
  }
  space->setBounds(bounds);
  return space;
}

inline void draw_uniform(std::mt19937_64& rng, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper, ompl::base::State* state) {
  auto q = vector(state, lower.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = std::uniform_real_distribution<double>(lower[i], upper[i])(rng);
  }
}

inline Path to_path(const ompl::base::PathPtr& path, Eigen::Index n) {
  Path out;
  for (const auto* state : path->as<ompl::geometric::PathGeometric>()->getStates()) {
    out.emplace_back(vector(state, n));
  }
  return out;
}

}  // namespace graspless::planning
