// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// A link L and the joint that connects it to its parent P.
struct Link {
  int parent = -1;         // index of P; -1 for the root
  std::string joint_name;  // empty for the root
  int joint = -1;  // index in q of the joint that moves it, its own or the mimicked one; -1: fixed
  bool is_mimic = false;  // the joint has no value of its own
  bool prismatic = false;
  double multiplier = 1;  // joint value = multiplier * q[joint] + offset
  double offset = 0;      // [rad or m]
  Eigen::Vector3d axis_L = Eigen::Vector3d::UnitZ();
  Eigen::Isometry3d X_PJ =
      Eigen::Isometry3d::Identity();  // of the joint; of L itself where it is fixed
  Eigen::Matrix3d R_JL = Eigen::Matrix3d::Identity();  // at joint value 0: axes are turned onto z
  int axis = 2;                   // coordinate axis of J about or along which the joint moves
  double sign = 1;                // -1: against it
  bool is_axis_turned = false;    // R_JL is not the identity
  bool is_parent_turned = false;  // R_PJ is not the identity
};

struct Robot::Model {
  std::string urdf;  // as it was read
  Robot::Options options;
  std::string name;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::vector<Link> links;  // depth first, so that a parent comes before its children
  std::vector<std::string> frame_names;
  std::vector<std::string> joint_names;
  Eigen::VectorXd lower, upper, max_velocity, max_effort;
  Eigen::VectorXd hard_lower, hard_upper;  // without the soft limits

  std::vector<std::vector<int>>
      paths;  // the links from the root (left out) to each link (included)
  std::vector<std::vector<int>> movers;  // the links of each path that a joint moves

  std::vector<LinkShape> shapes;
  std::set<std::pair<int, int>> ignored_pairs;
  std::vector<Eigen::VectorXd> reach;
  std::map<std::string, std::vector<int>> groups;
  Eigen::VectorXd step_weights;
  std::map<std::string, Eigen::VectorXd> states;
  std::map<std::string, std::set<int>> state_joints;              // joints that a state names
  std::map<std::string, std::string> group_faults, state_faults;  // by name; errors once used
  std::vector<std::string> warnings;
};

/// Places a link on its parent: X_WL = X_WP X_PJ X_JL(q).
void place(const Link& link, const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WP,
           Eigen::Isometry3d& X_WL);

/// Reads names, links, joints, limits and shapes. Throws like Robot::from_urdf().
Robot::Model read_urdf(const std::string& xml, const Robot::Options& options);

/// Reads groups, group states and disabled collisions into a model that read_urdf() made.
void read_srdf(const std::string& xml, Robot::Model& model);

/// Returns the part of Robot::ignored_pairs() that follows from the tree alone.
std::set<std::pair<int, int>> neighbours(const Robot::Model& model);

/// Robot::reach() of every link.
std::vector<Eigen::VectorXd> reach_bounds(const Robot::Model& model);

}  // namespace graspless::robot
