// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/mechanics/contact.hpp"

#include "clasp/stability/distance.hpp"

namespace graspless::clasp {

/// Point of the object's surface that a finger touches or nearly touches.
struct Touch {
  Eigen::Vector3d p_W, n_W;  ///< unit normal of the finger, into the object
  double gap;                ///< [m]
};

/// Opening between the tips of the two fingers of an open hand: the longest part of the line from
/// tip to tip that is in no link of them [m].
double opening(const robot::Robot& robot, const Hand& hand);

/// Test of pinches for many configurations of one problem, whose hand has one finger besides the
/// thumb. Not thread-safe.
class PinchTester {
 public:
  explicit PinchTester(const Problem& problem);

  Pinch test(const Eigen::VectorXd& q, double friction, const StabilityOptions& options);
  /// Nearest points of finger and thumb to the object, and all within 1 mm of the nearest; empty if
  /// the object is far away.
  std::array<std::vector<Touch>, 2> touches(const Eigen::VectorXd& q) const;

 private:
  /// Shapes of the links of a finger.
  using Side = std::vector<Body>;

  /// Triangle of the object's surface in W, and the distance of its centre from a finger [m].
  struct NearFacet : Facet {
    double gap;
  };

  Side side(const Finger& finger, const Finger& other) const;
  double press(const std::array<std::vector<Touch>, 2>& touches, const Eigen::VectorXd& q) const;
  std::vector<Touch> touches_of(const Side& side, const robot::Poses& X_WL,
                                const Eigen::Vector3d& middle_W) const;
  std::vector<NearFacet> facets_near(const Gap& gap, const Eigen::Vector3d& middle_W) const;

  Problem problem_;
  std::array<Side, 2> sides_;
  double reach_;               // radius about the middle of the tips in which contacts count [m]
  Eigen::Vector3d mean_O_;     // of the object's points [m]
  mechanics::Matrix6d scale_;  // of wrenches about the mean
};

/// The ends of the contacts along a bar as fingers that press with 1 N on each side, in W.
mechanics::ContactSet pinch_contacts(const std::array<std::vector<Touch>, 2>& touches,
                                     const Eigen::Vector3d& mean_W, const Eigen::Vector3d& along_W,
                                     double friction);

}  // namespace graspless::clasp
