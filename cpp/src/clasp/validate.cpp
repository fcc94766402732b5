// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "graspless/clasp/clasp.hpp"
#include "graspless/geometry/pose.hpp"

#include "scene/names.hpp"

namespace graspless::clasp {
namespace {

void check_loops(const Problem& problem) {
  const auto count = static_cast<int>(problem.object.loops().found.size());
  std::set<int> given;
  for (std::size_t i = 0; i < problem.loops.size(); ++i) {
    const int loop = problem.loops[i];
    const std::string name = "loops[" + std::to_string(i) + "]: ";
    if (loop < 0 || loop >= count) {
      throw std::invalid_argument(name + "there is no loop " + std::to_string(loop) + "; object '" +
                                  problem.object.name() + "' has " + std::to_string(count) +
                                  (count == 1 ? " loop" : " loops") + ", counted from 0");
    }
    if (given.insert(loop).second) continue;
    throw std::invalid_argument(name + "loop " + std::to_string(loop) +
                                " is given twice; each may occur only once");
  }
}

void check_marks(const Problem& problem) {
  for (std::size_t i = 0; i < problem.marks.size(); ++i) {
    const Eigen::Vector3d& mark = problem.marks[i];
    if (mark.allFinite() && mark.cwiseAbs().maxCoeff() <= geometry::kMaxLength) continue;
    throw std::invalid_argument("marks[" + std::to_string(i) + "] must be finite, within 1e4 m");
  }
}

void check_pull(const Problem& problem) {
  if (!problem.pull_W) return;
  const double length = problem.pull_W->norm();
  if (length >= geometry::kMinLength && length <= geometry::kMaxLength) return;
  std::ostringstream text;
  text << "pull_W must be a direction whose length lies in [" << geometry::kMinLength << ", "
       << geometry::kMaxLength << "], not " << length;
  throw std::invalid_argument(text.str());
}

void check_obstacles(const Problem& problem) {
  collision::require_obstacles(problem.obstacles, scene::taken_names(problem.robot, {"object"}),
                               "a link, another obstacle or 'object'");
}

}  // namespace

void validate(const Problem& problem) {
  validate(problem.hand, problem.robot);
  robot::require_configuration(problem.robot, problem.q_start, "q_start");
  geometry::require_pose(problem.X_WO, "X_WO");
  check_obstacles(problem);
  check_loops(problem);
  check_marks(problem);
  check_pull(problem);
}

void validate(const Options& options) {
  planning::require_in_range("options.", options);
  validate(options.stability);
  validate(options.certificate);
}

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::clasp
