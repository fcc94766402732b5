// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must hold of a hand on its robot.
#include "graspless/clasp/hand.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

constexpr double kShortest = 1e-4;  // of a stretch of a curve [m]

std::string text(const Vector3d& v) {
  return "(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         ")";
}

/// Runs a look-up by name and puts the field before what it throws.
template <typename Function>
auto located(const std::string& field, Function function) {
  try {
    return function();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(field + ": " + error.what());
  }
}

std::vector<int> joints(const std::string& field, const std::string& group,
                        const robot::Robot& robot) {
  const std::vector<int> found = located(field, [&] { return robot.group(group); });
  if (!found.empty()) return found;
  throw std::invalid_argument(field + " '" + group + "' is a group without joints");
}

void check_groups(const Hand& hand, const robot::Robot& robot) {
  const std::vector<int> arm = joints("hand.arm", hand.arm, robot);
  for (const int joint : joints("hand.hand", hand.hand, robot)) {
    if (std::find(arm.begin(), arm.end(), joint) == arm.end()) continue;
    throw std::invalid_argument("hand.arm '" + hand.arm + "' and hand.hand '" + hand.hand +
                                "' share the joint '" +
                                robot.joint_names()[static_cast<std::size_t>(joint)] + "'");
  }
}

/// Whether moving any joint of the group alone moves the point, at the open state.
bool moves(const Hand& hand, const robot::Robot& robot, const std::string& group,
           const CurveNode& node) {
  const int frame = robot.frame(node.link);
  const Eigen::VectorXd q = robot.state(hand.open);
  const Vector3d p_W = robot.pose(frame, q) * node.p_L;
  for (const int joint : robot.group(group)) {
    Eigen::VectorXd moved = q;
    moved[joint] += 0.1;
    if ((robot.pose(frame, moved) * node.p_L - p_W).norm() > 1e-6) return true;
  }
  return false;
}

void check_states(const Hand& hand, const robot::Robot& robot) {
  const Eigen::VectorXd open = located("hand.open", [&] { return robot.state(hand.open); });
  const Eigen::VectorXd closed = located("hand.closed", [&] { return robot.state(hand.closed); });
  for (const int joint : robot.group(hand.hand)) {
    if (std::abs(closed[joint] - open[joint]) > 1e-6) return;
  }
  throw std::invalid_argument("hand.open '" + hand.open + "' and hand.closed '" + hand.closed +
                              "' are the same for every joint of '" + hand.hand + "'");
}

/// The arm must carry H: where it turns, forward and sideways turn.
void check_frame(const Hand& hand, const robot::Robot& robot) {
  const int frame = located("hand.frame", [&] { return robot.frame(hand.frame); });
  const Eigen::VectorXd q = robot.state(hand.open);
  Eigen::VectorXd moved = q;
  moved[robot.group(hand.arm).back()] += 0.1;
  if (!robot.pose(frame, moved).isApprox(robot.pose(frame, q), 1e-9)) return;
  throw std::invalid_argument("hand.frame '" + hand.frame + "' is not carried by the group '" +
                              hand.arm + "': its last joint does not move it");
}

void check_unit(const std::string& field, const Vector3d& v) {
  if (v.allFinite() && std::abs(v.norm() - 1) < 1e-6) return;
  throw std::invalid_argument(field + " must be a unit vector, not " + text(v));
}

void check_directions(const Hand& hand) {
  check_unit("hand.forward", hand.forward_H);
  check_unit("hand.sideways", hand.sideways_H);
  if (std::abs(hand.forward_H.dot(hand.sideways_H)) < 1e-6) return;
  throw std::invalid_argument("hand.sideways " + text(hand.sideways_H) +
                              " must be orthogonal to hand.forward " + text(hand.forward_H));
}

void check_nodes(const std::string& field, const Finger& finger, const robot::Robot& robot) {
  if (finger.nodes.size() < 2) {
    throw std::invalid_argument(field +
                                " must have at least 2 nodes, from the palm to the tip, not " +
                                std::to_string(finger.nodes.size()));
  }
  for (std::size_t i = 0; i < finger.nodes.size(); ++i) {
    const std::string node = field + ".nodes[" + std::to_string(i) + "]";
    located(node + ".link", [&] { return robot.frame(finger.nodes[i].link); });
    const Vector3d& p = finger.nodes[i].p_L;
    if (!p.allFinite() || p.norm() > 1) {
      throw std::invalid_argument(
          node + ".point must be finite and within 1 m of its link's frame, not " + text(p));
    }
  }
}

/// No two corners that follow each other on a curve may coincide while the hand is open.
void check_curve(const Hand& hand, const robot::Robot& robot, const std::string& field,
                 const Finger& finger) {
  robot::Poses X_WL;
  robot.forward(robot.state(hand.open), X_WL);
  std::vector<CurveNode> curve(finger.nodes.rbegin(), finger.nodes.rend());
  curve.insert(curve.end(), hand.thumb.nodes.begin(), hand.thumb.nodes.end());
  const auto p_W = [&](const CurveNode& node) -> Vector3d {
    return X_WL[static_cast<std::size_t>(robot.frame(node.link))] * node.p_L;
  };
  const auto refuse = [&](std::size_t a, std::size_t b) {
    throw std::invalid_argument(
        field + ": corners " + std::to_string(a) + " and " + std::to_string(b) +
        " of the curve from its tip to the thumb's coincide at the state '" + hand.open + "'");
  };
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if ((p_W(curve[i]) - p_W(curve[i - 1])).norm() < kShortest) refuse(i - 1, i);
  }
  if ((p_W(curve.back()) - p_W(curve.front())).norm() < kShortest) refuse(0, curve.size() - 1);
}

void check_names(const Hand& hand) {
  std::set<std::string> names;
  for (const Finger& finger : hand.fingers) {
    if (names.insert(finger.name).second) continue;
    throw std::invalid_argument("hand.fingers has '" + finger.name + "' twice");
  }
}

/// At least one of the two ends of a curve must move when the hand closes.
void check_tip(const Hand& hand, const robot::Robot& robot, const std::string& field,
               const Finger& finger) {
  if (moves(hand, robot, hand.hand, finger.nodes.back())) return;
  throw std::invalid_argument(field + ": its tip, on link '" + finger.nodes.back().link +
                              "', is moved by no joint of the group '" + hand.hand + "'");
}

}  // namespace

void validate(const Hand& hand, const robot::Robot& robot) {
  check_groups(hand, robot);
  check_states(hand, robot);
  check_frame(hand, robot);
  check_directions(hand);
  if (hand.fingers.empty()) {
    throw std::invalid_argument("hand.fingers must name at least one finger besides the thumb");
  }
  check_names(hand);
  check_nodes("hand.thumb", hand.thumb, robot);
  for (const Finger& finger : hand.fingers) {
    const std::string field = "hand.fingers." + finger.name;
    check_nodes(field, finger, robot);
    check_tip(hand, robot, field, finger);
    check_curve(hand, robot, field, finger);
  }
}

}  // namespace graspless::clasp
