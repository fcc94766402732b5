// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "graspless/fingertip/problem.hpp"

namespace graspless::fingertip {

/// An edge of the convex hull that the object can be tumbled over, seen from the face it stands on.
struct TumbleEdge {
  int to;                  // the face that it comes to stand on
  Eigen::Vector3d p_O;     // a point on the edge
  Eigen::Vector3d axis_O;  // along the edge, unit: a right-hand turn about it tumbles
  double angle;            // [rad]
};

/// A face of the convex hull that the object may stand on.
struct ContactState {
  Eigen::Vector3d n_O;  // into the object, unit
  double offset;        // n_O . p of its points [m]
  bool is_stable;       // the centre of mass lies over it, seen along n_O
  std::vector<TumbleEdge> edges;
};

/// The contact states of an object on a floor: one a face of its convex hull, with edges between
/// faces that meet.
class ContactStates {
 public:
  explicit ContactStates(const Object& object);

  int size() const { return static_cast<int>(all_.size()); }
  const ContactState& operator[](int i) const { return all_[i]; }

  /// The face that lies flush on a plane, to `tolerance` [m]; -1 when none does.
  int standing(const Eigen::Isometry3d& X_WO, const Plane& plane, double tolerance) const;

  /// Least number of tumbles from each face to `goal`; -1 where it cannot be reached.
  std::vector<int> tumbles_to(int goal) const;

 private:
  Eigen::Matrix3Xd corners_O_;
  std::vector<ContactState> all_;
};

/// A path through the states: the edges tumbled over, in order.
using TumbleSequence = std::vector<const TumbleEdge*>;

/// All sequences of exactly `tumbles` edges from one face to another that never go straight back,
/// at most `limit` of them. `states` must outlive them.
std::vector<TumbleSequence> tumble_sequences(const ContactStates& states, int from, int to,
                                             int tumbles, int limit);

/// The object's pose after a tumble.
Eigen::Isometry3d tumbled(const Eigen::Isometry3d& X_WO, const TumbleEdge& edge);

}  // namespace graspless::fingertip
