// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// check(): virtual linking of every curve at every row, by the double integral.
#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "clasp/check/checker.hpp"
#include "clasp/parameters.hpp"

namespace graspless::clasp {
namespace {

/// Arc sine of the cosine between two normals; 0 if one vanishes.
double arc(const Eigen::Vector3d& m, const Eigen::Vector3d& n) {
  const double length = m.norm() * n.norm();
  return length > 0 ? std::asin(std::clamp(m.dot(n) / length, -1.0, 1.0)) : 0;
}

/// Signed solid angle of the segments (a, a2) and (b, b2), divided by 4 pi.
double pair_integral(const Eigen::Vector3d& a, const Eigen::Vector3d& a2, const Eigen::Vector3d& b,
                     const Eigen::Vector3d& b2) {
  const Eigen::Vector3d r13 = b - a, r14 = b2 - a, r23 = b - a2, r24 = b2 - a2;
  const double side = (b2 - b).cross(a2 - a).dot(r13);
  const Eigen::Vector3d n1 = r13.cross(r14), n2 = r14.cross(r24), n3 = r24.cross(r23),
                        n4 = r23.cross(r13);
  const double area = arc(n1, n2) + arc(n2, n3) + arc(n3, n4) + arc(n4, n1);
  return side == 0 ? 0 : std::copysign(area, side) / (4 * M_PI);
}

/// min(1, |VLk|), eq. (2).
double linking_of(const Eigen::Matrix3Xd& loop, const Eigen::Matrix3Xd& curve) {
  double length = 0;
  for (Eigen::Index i = 1; i < curve.cols(); ++i)
    length += (curve.col(i) - curve.col(i - 1)).norm();
  const double chord = (curve.col(0) - curve.col(curve.cols() - 1)).norm();
  return std::min(1.0, (1 - chord / (length + chord)) * std::abs(double_integral(loop, curve)));
}

}  // namespace

double double_integral(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  double sum = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      sum +=
          pair_integral(a.col(i), a.col((i + 1) % a.cols()), b.col(j), b.col((j + 1) % b.cols()));
    }
  }
  return sum;
}

Eigen::Matrix3Xd curve_in_world(const Problem& problem, int finger, const Eigen::VectorXd& q) {
  const auto& down = problem.hand.fingers[finger].nodes;
  const auto& up = problem.hand.thumb.nodes;
  std::vector<CurveNode> nodes(down.rbegin(), down.rend());
  nodes.insert(nodes.end(), up.begin(), up.end());
  robot::Poses X_WL;
  problem.robot.forward(q, X_WL);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto link = static_cast<std::size_t>(problem.robot.frame(nodes[i].link));
    points.col(i) = X_WL[link] * nodes[i].p_L;
  }
  return points;
}

void PlanChecker::check_linking(const Segment& segment) {
  const Eigen::Matrix3Xd loop = loop_W();
  for (std::size_t row = 0; row < segment.positions.size(); ++row) {
    poll();
    for (int i = 0; i < segment.virtual_linking.rows(); ++i) {
      const double stated = segment.virtual_linking(i, static_cast<Eigen::Index>(row));
      const double found = linking_of(loop, curve_in_world(problem_, i, segment.positions[row]));
      if (std::abs(stated - found) <= kTolerance) continue;
      fault(at(segment, row), "virtual linking of curve ", i, " is ", found, ", not ", stated);
    }
  }
}

/// The closed hand meets the threshold. A threshold given by the user must be met before the hand
/// closes. With a derived threshold, every curve must be linked before.
void PlanChecker::check_threshold() {
  const double required = derived(options_, problem_, plan_.loop).min_linking;
  if (!(std::abs(plan_.min_linking - required) <= kTolerance))
    fault("plan", "min_linking is ", plan_.min_linking, ", not ", required);
  const double reached = reach().virtual_linking.rightCols(1).minCoeff();
  if (!(options_.min_linking > 0 ? reached >= required - kTolerance : reached > 0))
    fault("reach", "ends with a virtual linking of ", reached, ", below min_linking ", required);
  const double kept = close().virtual_linking.rightCols(1).minCoeff();
  if (!(kept >= required - kTolerance))
    fault("close", "ends with a virtual linking of ", kept, ", below min_linking ", required);
}

}  // namespace graspless::clasp
