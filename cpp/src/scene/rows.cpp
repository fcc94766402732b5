// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/rows.hpp"

#include <algorithm>
#include <sstream>

namespace graspless::scene {

bool is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double tolerance) {
  return (a.translation() - b.translation()).norm() <= tolerance &&
         Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() <= tolerance;
}

std::string wrong_names(const robot::Robot& robot, const std::vector<std::string>& names) {
  const std::vector<std::string>& own = robot.joint_names();
  if (names == own) return "";
  const bool same = std::is_permutation(names.begin(), names.end(), own.begin(), own.end());
  return same ? "joint names are not in the robot's order" : "joint names are not the robot's";
}

void check_rows(const robot::Robot& robot, Eigen::VectorXd before, double same,
                const std::vector<Eigen::VectorXd>& rows,
                const std::function<void(std::size_t row, const std::string& what)>& fault) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Eigen::Index joint = 0;
    const Eigen::VectorXd moved = (rows[row] - before).cwiseAbs();
    const Eigen::VectorXd& weights = robot.step_weights();
    const double step = moved.cwiseProduct(weights).maxCoeff(&joint);
    if (row == 0 && step > same) fault(row, "does not continue the segment before it");
    if (step > kLongestStep) {
      std::ostringstream text;
      text << "joint '" << robot.joint_names()[joint] << "' moves by " << moved[joint]
           << (weights[joint] > 1 ? " m" : " rad") << " between rows";
      fault(row, text.str());
    }
    if (!robot.is_within(rows[row], 1e-6)) fault(row, "leaves the joint limits");
    before = rows[row];
  }
}

}  // namespace graspless::scene
