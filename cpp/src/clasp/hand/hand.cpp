// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Validation of a hand on its robot.
#include "graspless/clasp/hand.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "clasp/hand/palm.hpp"
#include "text.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

constexpr double kMinSegment = 1e-4;  // length of a segment of a curve [m]
constexpr double kMaxPalm = 0.25;     // width of a palm [m]

std::string text(const Vector3d& v) {
  return "(" + figure(v.x()) + ", " + figure(v.y()) + ", " + figure(v.z()) + ")";
}

/// Runs a lookup by name and prefixes its error message with the field.
template <typename Function>
auto with_field(const std::string& field, Function function) {
  try {
    return function();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(field + ": " + error.what());
  }
}

std::vector<int> joints(const std::string& field, const std::string& group,
                        const robot::Robot& robot) {
  const std::vector<int> found = with_field(field, [&] { return robot.group(group); });
  if (!found.empty()) return found;
  throw std::invalid_argument(field + " '" + group + "' is a group without joints");
}

void check_groups(const Hand& hand, const robot::Robot& robot) {
  const std::vector<int> arm = joints("hand.arm", hand.arm, robot);
  for (const int joint : joints("hand.hand", hand.hand, robot)) {
    if (std::find(arm.begin(), arm.end(), joint) == arm.end()) continue;
    throw std::invalid_argument("hand.arm '" + hand.arm + "' and hand.hand '" + hand.hand +
                                "' share the joint '" + robot.joint_names()[joint] + "'");
  }
}

void check_pre_shape(const std::string& field, const std::string& name, const Hand& hand,
                     const robot::Robot& robot) {
  const Eigen::VectorXd open = with_field(field, [&] { return robot.state(name); });
  const Eigen::VectorXd closed =
      with_field("hand.closed", [&] { return robot.state(hand.closed); });
  for (const int joint : robot.group(hand.hand)) {
    if (std::abs(closed[joint] - open[joint]) > 1e-6) return;
  }
  throw std::invalid_argument(field + " '" + name + "' and hand.closed '" + hand.closed +
                              "' are the same for every joint of '" + hand.hand + "'");
}

void check_states(const Hand& hand, const robot::Robot& robot) {
  check_pre_shape("hand.open", hand.open, hand, robot);
  std::set<std::string> names{hand.open};
  for (std::size_t i = 0; i < hand.pre_shapes.size(); ++i) {
    const std::string &name = hand.pre_shapes[i],
                      field = "hand.pre_shapes[" + std::to_string(i) + "]";
    if (!names.insert(name).second)
      throw std::invalid_argument(field + " is '" + name + "' again; each may occur only once");
    check_pre_shape(field, name, hand, robot);
  }
}

/// The arm must move the frame H.
void check_frame(const Hand& hand, const robot::Robot& robot) {
  const int frame = with_field("hand.frame", [&] { return robot.frame(hand.frame); });
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
    with_field(node + ".link", [&] { return robot.frame(finger.nodes[i].link); });
    const Vector3d& p = finger.nodes[i].p_L;
    if (!p.allFinite() || p.norm() > 1) {
      throw std::invalid_argument(
          node + ".point must be finite and within 1 m of its link's frame, not " + text(p));
    }
  }
}

/// Consecutive corners of a curve must not coincide when the hand is open.
void check_curve(const Hand& hand, const robot::Robot& robot, const std::string& field,
                 const Finger& finger) {
  const Eigen::VectorXd open = robot.state(hand.open);
  std::vector<Vector3d> corners_W;
  for (auto node = finger.nodes.rbegin(); node != finger.nodes.rend(); ++node) {
    corners_W.push_back(node_position(robot, *node, open));
  }
  for (const CurveNode& node : hand.thumb.nodes)
    corners_W.push_back(node_position(robot, node, open));
  const auto refuse = [&](std::size_t a, std::size_t b) {
    throw std::invalid_argument(
        field + ": corners " + std::to_string(a) + " and " + std::to_string(b) +
        " of the curve from its tip to the thumb's coincide at the state '" + hand.open + "'");
  };
  for (std::size_t i = 1; i < corners_W.size(); ++i) {
    if ((corners_W[i] - corners_W[i - 1]).norm() < kMinSegment) refuse(i - 1, i);
  }
  if ((corners_W.back() - corners_W.front()).norm() < kMinSegment) refuse(0, corners_W.size() - 1);
}

void check_names(const Hand& hand) {
  std::set<std::string> names;
  for (const Finger& finger : hand.fingers) {
    if (names.insert(finger.name).second) continue;
    throw std::invalid_argument("hand.fingers has '" + finger.name + "' twice");
  }
}

void check_tip(const Hand& hand, const robot::Robot& robot, const std::string& field,
               const Finger& finger) {
  const CurveNode& tip = finger.nodes.back();
  if (a_joint_changes(hand, robot, [&](const auto& q) { return node_position(robot, tip, q); }))
    return;
  throw std::invalid_argument(field + ": its tip, on link '" + tip.link +
                              "', is moved by no joint of the group '" + hand.hand + "'");
}

/// Corners that with_palm_corners() would add.
std::string advice(const Hand& hand, const robot::Robot& robot) {
  const Hand made = with_palm_corners(hand, robot);
  std::string found;
  const auto compare = [&](const std::string& field, const Finger& given, const Finger& now) {
    const CurveNode& corner = now.nodes.front();
    if (corner.link == given.nodes.front().link && corner.p_L == given.nodes.front().p_L) return;
    found += (found.empty() ? "; begin " : ", and ") + field + " with {link: " + corner.link +
             ", point: " + text(corner.p_L) + "}";
  };
  for (std::size_t i = 0; i < hand.fingers.size(); ++i)
    compare("hand.fingers." + hand.fingers[i].name, hand.fingers[i], made.fingers[i]);
  compare("hand.thumb", hand.thumb, made.thumb);
  return found;
}

/// The first nodes of finger and thumb must be close to each other in the palm, and no joint of the
/// hand may move one against the other.
void check_meeting(const Hand& hand, const robot::Robot& robot, const std::string& field,
                   const Finger& finger) {
  const CurveNode &first = finger.nodes.front(), &thumbs = hand.thumb.nodes.front();
  const auto distance = [&](const Eigen::VectorXd& q) {
    return Eigen::Matrix<double, 1, 1>(
        (node_position(robot, first, q) - node_position(robot, thumbs, q)).norm());
  };
  const double apart = distance(robot.state(hand.open))[0];
  if (apart > kMaxPalm) {
    throw std::invalid_argument(field + " does not meet the thumb: their first nodes, on links '" +
                                first.link + "' and '" + thumbs.link + "', are " + figure(apart) +
                                " m apart; a palm is at most " + figure(kMaxPalm) + " m wide");
  }
  if (!a_joint_changes(hand, robot, distance)) return;
  throw std::invalid_argument(field + " does not meet the thumb: joints of the group '" +
                              hand.hand + "' move its first node, on link '" + first.link +
                              "', against the thumb's, on link '" + thumbs.link +
                              "'; nodes run from the palm to the tip" + advice(hand, robot));
}

}  // namespace

void require_names(const Hand& hand, const robot::Robot& robot) {
  check_groups(hand, robot);
  check_states(hand, robot);
  check_frame(hand, robot);
  check_directions(hand);
  if (hand.fingers.empty()) {
    throw std::invalid_argument("hand.fingers must name at least one finger besides the thumb");
  }
  check_names(hand);
  check_nodes("hand.thumb", hand.thumb, robot);
  for (const Finger& finger : hand.fingers)
    check_nodes("hand.fingers." + finger.name, finger, robot);
}

void validate(const Hand& hand, const robot::Robot& robot) {
  require_names(hand, robot);
  for (const Finger& finger : hand.fingers) {
    const std::string field = "hand.fingers." + finger.name;
    check_tip(hand, robot, field, finger);
    check_meeting(hand, robot, field, finger);
    check_curve(hand, robot, field, finger);
    for (const std::string& pre_shape : hand.pre_shapes) {
      Hand shaped = hand;
      shaped.open = pre_shape;
      check_curve(shaped, robot, field, finger);
    }
  }
}

}  // namespace graspless::clasp
