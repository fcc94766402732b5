// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/robot.hpp"

#include <fstream>
#include <iterator>

#include "graspless/clasp/hand.hpp"

#include "cpp/paths.hpp"
#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

using robot::Robot;

std::string text_of(const std::string& path) {
  std::ifstream file(checkout_file(path));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Laws that every robot fulfils.
void require_consistent(const Robot& robot) {
  const Eigen::VectorXd q = robot.clamp(Eigen::VectorXd::Zero(robot.dof()));
  require(robot.is_within(q), "a clamped configuration is within the limits");
  require((robot.max_velocity().array() > 0).all(), "limits of velocity are positive");
  robot::Poses X_WL;
  robot.forward(q, X_WL);
  require(X_WL.size() == robot.frame_names().size(), "every link has a pose");
  for (std::size_t i = 0; i < X_WL.size(); ++i) {
    require(X_WL[i].matrix().allFinite(), "poses are finite");
    require(robot.reach(static_cast<int>(i)).size() == robot.dof(),
            "a reach has one value a joint");
  }
}

}  // namespace

void read_urdf(Bytes bytes) {
  accepts([&] { require_consistent(Robot::from_urdf(bytes.rest(), {})); });
}

void read_srdf(Bytes bytes) {
  static const std::string urdf = text_of("tests/fuzz/seeds/arms.urdf");
  Robot::Options options;
  options.srdf = bytes.rest();
  accepts([&] {
    const Robot robot = Robot::from_urdf(urdf, options);
    for (const std::string& name : robot.state_names()) {
      require(robot.is_within(robot.state(name)), "a state is within the limits");
    }
    for (const std::string& name : robot.group_names()) {
      for (const int joint : robot.group(name)) {
        require(joint >= 0 && joint < robot.dof(), "a group names joints");
      }
    }
  });
}

void read_hand(Bytes bytes) {
  static const Robot robot = Robot::from_urdf_file(urdf_file("wam_t42.urdf"));
  accepts([&] {
    const clasp::Hand hand = clasp::hand_from_yaml(bytes.rest());
    require(hand.forward_H.allFinite() && hand.sideways_H.allFinite(), "directions are finite");
    validate(hand, robot);
  });
}

}  // namespace graspless::fuzz
