// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/pinch/options.hpp"
#include "graspless/robot/robot.hpp"
#include "graspless/slide/problem.hpp"

namespace graspless::pinch {

using LinkShapes = std::vector<robot::LinkShape>;

/// Shapes of links, for their extents along directions of one frame.
class Shapes {
 public:
  /// The shapes at q, in the hand's frame H.
  Shapes(const slide::Problem& problem, const LinkShapes& shapes, const Eigen::VectorXd& q);
  /// Largest coordinate along a direction of any length, from the origin of H [m].
  double extent(const Eigen::Vector3d& direction_H) const;
  /// Interval of the coordinates along the unit vector `axis_H` of those points that are outermost
  /// along `direction_H` [m].
  std::pair<double, double> outermost(const Eigen::Vector3d& direction_H,
                                      const Eigen::Vector3d& axis_H) const;

 private:
  std::vector<geometry::PlacedShape> shapes_;  // in H
};

/// Largest extent of several along a direction [m].
double extent(const std::vector<Shapes>& all, const Eigen::Vector3d& direction_H);

/// The fingers at one closing, with two plane faces between them.
struct Grip {
  double gap;                 ///< distance between the faces [m]
  Eigen::Vector3d contact_H;  ///< midway between the contacts with the faces
  double pad;                 ///< length of the contacts along X_H [m]
  double end;                 ///< of flat pads, beyond the contact; infinite if they are round [m]
  Eigen::VectorXd q;          ///< all joints, the arm at home
};

/// The opening of a hand between that with which it comes to the object, and its closed state.
class Jaw {
 public:
  /// With contacts as far from the ends of the pads, and open as far, as `options` say.
  explicit Jaw(const slide::Problem& problem, const Options& options = {});

  double opening() const { return open_.gap; }      ///< with which the hand comes [m]
  double widest() const { return widest_; }         ///< opening of the open hand [m]
  double least_gap() const { return closed_.gap; }  ///< of the closed hand; may be negative [m]
  const Grip& open() const { return open_; }
  /// The hand, closed until its fingers are `width` apart; nothing if it opens or closes less.
  std::optional<Grip> at_width(double width) const;
  /// By how much the hand must come aside of where it closes on two faces, along Y_H, so that each
  /// finger keeps `margin` from its face [m]. 0 unless one jaw opens less than the other.
  double shift(const Grip& grip, double width, double margin) const;
  /// The hand at a configuration of all joints.
  Grip at(const Eigen::VectorXd& q) const;
  /// Distance between the fingers at a configuration of all joints [m].
  double gap(const Eigen::VectorXd& q) const { return at(q).gap; }
  /// Box around each finger of the hand that comes to the object, in H [m].
  std::array<Eigen::AlignedBox3d, 2> open_fingers() const;
  /// The fingers of the hand that comes to the object, and at some grips.
  std::vector<Shapes> fingers(const std::vector<Grip>& grips) const;
  /// By how much the fingers move apart or together per unit of each joint of the hand, when it has
  /// closed by a share from 0 to 1 [m/rad or 1]: at their outermost points or at the contacts,
  /// whichever move more. They differ if the faces are not parallel. 0 for joints of the arm.
  Eigen::VectorXd gap_rates(double closing) const;
  /// Distance between the fingers of the hand that has closed by a share from 0 to 1 [m].
  double gap_at(double closing) const { return closed_by(closing).gap; }

 private:
  /// Rates of the distance between the contacts, by all joints [m/rad or 1].
  Eigen::VectorXd contact_rates(const Grip& grip) const;
  Grip closed_by(double closing) const { return at(q_open_ + closing * (q_closed_ - q_open_)); }

  const slide::Problem& problem_;
  double depth_;
  LinkShapes own_, others_;           // of hand.sliding_finger, and of the other hand.fingers
  LinkShapes own_face_, other_face_;  // the parts of both that hold the object
  Eigen::VectorXd q_open_, q_closed_;
  double side_;  // 1 if the sliding finger is on the positive side of Y_H, or -1
  double widest_;
  Grip open_, closed_;
};

}  // namespace graspless::pinch
