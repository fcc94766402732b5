// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contacts between a hand and an object that moves under a load.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/mechanics/contact.hpp"
#include "graspless/robot/robot.hpp"

#include "clasp/stability/distance.hpp"
#include "clasp/stability/load_step.hpp"

namespace graspless::clasp {

constexpr double kMetre = 1000;   // [mm]
constexpr double kArm = 20;       // length that makes lengths of angles [mm]
constexpr double kReach = 0.025;  // a point farther from a shape never meets it [m]

/// The hand at one configuration.
struct Posture {
  robot::Poses X_WL, X_LW;                   // of each link
  std::vector<mechanics::Matrix6Xd> twists;  // of each link by each joint, at W's origin, in mm
  Eigen::Vector3d center_W;                  // of the finger curves
};

/// Points, coordinate by coordinate.
struct Points {
  explicit Points(const Eigen::Matrix3Xd& p) : x(p.row(0)), y(p.row(1)), z(p.row(2)) {}
  Eigen::Vector3d operator[](Eigen::Index i) const { return {x[i], y[i], z[i]}; }

  Eigen::ArrayXd x, y, z;
};

/// Points of the object, each with a body that it may touch, body by body.
struct NearPoints {
  /// Points of a body.
  struct Range {
    std::size_t body;
    Eigen::Index begin, size;
  };
  /// Some of these, in a ball of this radius about their middle [m].
  struct Block {
    Range points;
    Eigen::Vector3d middle_W;
    double radius;
  };

  NearPoints(Eigen::Matrix3Xd p_W, std::vector<Range> ranges, Eigen::ArrayXd distance);

  Eigen::Matrix3Xd p_W;  ///< before the object moves [m]
  std::vector<Range> ranges;
  std::vector<Block> blocks;
  Eigen::ArrayXd distance;  ///< from the body when it was last measured [m]
  Points measured_W;        ///< where the points were then
};

/// Contacts of the object at one pose. A distance is measured where a move may be longer than its
/// lower bound, and a normal is computed where a move may be longer than the distance. Refers to
/// its arguments; what it measures is kept in `points`.
class PosedContacts final : public LoadContacts {
 public:
  /// `moved`: motion of the object since `points.p_W`, in W.
  PosedContacts(NearPoints& points, const Eigen::Isometry3d& moved, const std::vector<Body>& bodies,
                const Posture& hand);

  const LoadContact* at(Eigen::Index point) override;
  std::vector<const LoadContact*> near(const mechanics::Vector6d& move,
                                       const Eigen::VectorXd& yield) override;

 private:
  void measure(Eigen::Index point, const Body& body);
  const LoadContact* contact(Eigen::Index point, const Body& body);
  bool may_pass(Eigen::Index point, const Body& body, const Eigen::Vector3d& motion_W) const;

  NearPoints& points_;
  const std::vector<Body>& bodies_;
  const Posture& hand_;
  Points p_W_;
  std::vector<Eigen::Vector3d> middles_W_;  // of the blocks
  std::vector<double> least_;               // bound on the gaps of each block [mm]
  Eigen::ArrayXd gap_;  // or a lower bound [mm]; infinite where no step closes it
  std::vector<char> is_measured_;
  std::unordered_map<Eigen::Index, LoadContact> contacts_;
};

}  // namespace graspless::clasp
