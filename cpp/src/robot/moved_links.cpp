// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/moved_links.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace graspless::robot {

std::vector<int> moved_links(const Robot& robot, const std::vector<int>& joints, int link,
                             const Eigen::VectorXd& q) {
  std::vector<int> links;
  for (; link >= 0; link = robot.parent(link)) {
    const Eigen::Matrix<double, 6, Eigen::Dynamic> J = robot.jacobian(link, q);
    if (J(Eigen::all, joints).isZero()) break;
    links.push_back(link);
  }
  std::reverse(links.begin(), links.end());
  return links;
}

std::optional<Span> span_of(const Robot& robot, const std::vector<int>& arm, int frame,
                            const Eigen::VectorXd& q) {
  const auto slides = [&](int joint) { return robot.step_weights()[joint] > 1; };
  if (std::any_of(arm.begin(), arm.end(), slides)) return std::nullopt;
  const int base = moved_links(robot, arm, frame, q).front();
  return Span{base, robot.pose(base, q).translation(), robot.reach(frame)(arm).maxCoeff()};
}

std::string beyond(const Robot& robot, const Span& span, const std::string& frame,
                   const std::string& what, double away) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "the object is out of the arm's reach: " << frame
      << " gets at most " << span.most << " m from '" << robot.frame_names()[span.base] << "', and "
      << what << " is " << away << " m from it";
  return out.str();
}

}  // namespace graspless::robot
