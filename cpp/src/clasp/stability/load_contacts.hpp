// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contacts between a hand and an object that moves under a load.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
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

/// Points of the object, each with a body that it may touch, body by body.
struct NearPoints {
  static constexpr Eigen::Index kBlock = 16;
  using Values = Eigen::Array<double, kBlock, 1>;
  /// Points of a body.
  struct Range {
    std::size_t body;
    Eigen::Index begin, size;
  };
  /// What is known of the distances of points from a body that does not move [m].
  struct Known {
    Eigen::Array<double, kBlock, 3> at_W;  // where each was measured
    Values distance;                       // infinite if there is no point
  };
  /// Neighbours among the points of a body, in a ball of this radius about their middle [m].
  struct Block {
    std::size_t body;
    Eigen::Index size;
    std::array<Eigen::Index, kBlock> points;
    Eigen::Vector3d middle_W;
    double radius;
    Known first, last;          // before the object moves, and when they were last measured
    double least_first, least;  // bounds on the distances before it moves, and at the pose `moved`
    Eigen::Isometry3d moved;    // motion of the object since p_W
  };
  /// Where a point is.
  struct Place {
    std::size_t block;
    Eigen::Index index;
  };

  /// `distance`: of each point from its body, at most [m].
  NearPoints(Eigen::Matrix3Xd p_W, const std::vector<Range>& ranges,
             const Eigen::ArrayXd& distance);

  Eigen::Matrix3Xd p_W;  ///< before the object moves [m]
  std::vector<Block> blocks;
  std::vector<Place> places;  ///< of the points
};

/// Contacts of the object at one pose. A distance is measured where a move may be longer than its
/// lower bound, and a normal is computed where a move may be longer than the distance. Refers to
/// its arguments; what it measures is kept in `points` for other poses, also of other loads.
class PosedContacts final : public LoadContacts {
 public:
  /// `moved`: motion of the object since `points.p_W`, in W.
  PosedContacts(NearPoints& points, const Eigen::Isometry3d& moved, const std::vector<Body>& bodies,
                const Posture& hand);

  const LoadContact* at(Eigen::Index point) override;
  std::vector<const LoadContact*> near(const mechanics::Vector6d& move,
                                       const Eigen::VectorXd& yield) override;

 private:
  using Values = NearPoints::Values;
  /// The points of a block at this pose.
  struct Posed {
    Eigen::Array<double, NearPoints::kBlock, 3> p_W;
    Eigen::Array<double, NearPoints::kBlock, 3> n_W;  // normals, if the body has an axis
    Values distance;                                  // or a lower bound [m]
    Values gap;  // or a lower bound [mm]; infinite where no step closes it
    std::array<bool, NearPoints::kBlock> is_measured{};
  };
  /// A rigid motion relative to a body: v + w x p [mm].
  struct Motion {
    Eigen::Vector3d v, w;
    Eigen::Vector3d operator*(const Eigen::Vector3d& p_W) const { return v + w.cross(p_W); }
  };

  /// The middle of a block at this pose.
  struct Middle {
    Eigen::Vector3d p_W, n_W;  // n_W: normal, if the body has an axis
    double bends;              // bound on the differences of normals in the block
    double least;              // bound on the gaps [mm]
  };

  Middle middle_of(const NearPoints::Block& block) const;
  Posed& posed(std::size_t block);
  static void place_known(const NearPoints::Block& block, Posed& posed);
  static void place_around(const Axis& axis_W, Posed& posed);
  void keep_bounds(std::size_t block, const Posed& posed);
  void measure(NearPoints::Block& block, Posed& posed, Eigen::Index i);
  const LoadContact* contact(const NearPoints::Block& block, const Posed& posed, Eigen::Index i);
  bool may_pass(const Body& body, const Posed& posed, Eigen::Index i,
                const Eigen::Vector3d& motion_W) const;
  void find(std::size_t block, const Motion& motion, std::vector<const LoadContact*>& found);

  NearPoints& points_;
  const std::vector<Body>& bodies_;
  const Posture& hand_;
  Eigen::Isometry3d moved_;
  std::vector<std::optional<Axis>> axes_W_;  // of the bodies
  std::vector<Middle> middles_;              // of the blocks
  std::vector<int> posed_;                   // index in poses_; -1: none yet
  std::deque<Posed> poses_;
  std::unordered_map<Eigen::Index, LoadContact> contacts_;
};

}  // namespace graspless::clasp
