// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Planners to compare the clasp planner with.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/problem.hpp"
#include "graspless/planning/budget.hpp"

namespace graspless::benchmarks {

/// How the peer searches.
struct GraspRrtOptions {
  double max_step = 0.2;              ///< of an extension, of any joint [rad]
  double approach_probability = 0.1;  ///< share of the iterations that try to approach
  double friction = 0.5;
  double min_quality = 0.003;  ///< of a grasp that is good enough: the epsilon of its wrenches
};

/// A grasp of that planner, and what it is around.
struct Grasp {
  bool found = false;
  Eigen::VectorXd q;         ///< all joints, the hand closed [rad or m]
  double quality = 0;        ///< epsilon: torques count by the object's size
  Eigen::Matrix3Xd p_OC;     ///< contacts [m]
  std::vector<int> linking;  ///< of every closed finger curve, with the loop it is most linked
  bool envelops = false;     ///< some finger curve is linked with a loop of the object
  int approaches = 0, grasps = 0;  ///< tried; of these closed on something
  std::int64_t nodes = 0;
  double seconds = 0;
};

/// A plain Grasp-RRT after Vahrenkamp, Asfour and Dillmann 2012: a tree in the arm's joints; now
/// and then a node's hand approaches a point of the object's surface, closes, and the contacts are
/// scored by the ball of wrenches that they resist. Knows nothing of loops. One iteration of the
/// budget is one of its loop.
Grasp grasp_rrt(const clasp::Problem& problem, const GraspRrtOptions& options,
                const planning::Budget& budget);

}  // namespace graspless::benchmarks
