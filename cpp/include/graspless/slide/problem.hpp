// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/obstacle.hpp"
#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/band.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/shape.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::slide {

/// A thin flat object. Its frame O has z up, the underside in the plane z = 0.
class GRASPLESS_API Object {
 public:
  /// From an outline in O's x-y plane [m] and a thickness [m]; the contact points are a grid of
  /// `spacing` [m]. The centre of mass is the area's, half way up.
  static Object from_polygon(const std::string& name, const geometry::Polygon& outline,
                             double thickness, double spacing = 0.006);
  /// From points on the top surface, in O (3 x n) [m], P_o of the paper. The outline is their alpha
  /// shape, the thickness their median height unless given; the centre of mass is their mean, half
  /// way up. Throws std::invalid_argument on values that are not finite, fewer than three points, a
  /// line, or a thick object: heights that spread (5 to 95 %) by over 10 mm, or half the width.
  static Object from_cloud(const std::string& name, const Eigen::Matrix3Xd& p_OP,
                           double thickness = 0);

  const std::string& name() const { return name_; }
  const Eigen::Matrix2Xd& points() const { return points_; }  ///< contact points, x-y in O [m]
  const geometry::Polygon& outline() const { return outline_; }
  const Eigen::VectorXd& depths() const { return depths_; }  ///< of points() inside outline() [m]
  double thickness() const { return thickness_; }
  const Eigen::Vector3d& com() const { return com_; }  ///< in O [m]
  double mass() const { return mass_; }                ///< [kg]
  /// Prisms over the convex parts of the outline, in O: the object to the collision checker.
  const std::vector<geometry::PlacedShape>& shapes() const { return shapes_; }
  const collision::Solid& solid() const { return solid_; }

  /// The same object with another centre of mass (in O). Throws unless it is finite and within the
  /// outline's bounding box.
  Object with_com(const Eigen::Vector3d& com_O) const;
  /// The same object with another mass [kg]. Throws unless it is positive.
  Object with_mass(double mass) const;
  /// The same object scaled in the plane; thickness and mass stay.
  Object scaled(double scale) const;

 private:
  Object(std::string name, Eigen::Matrix2Xd points, geometry::Polygon outline, double thickness,
         const Eigen::Vector2d& com);
  std::string name_;
  Eigen::Matrix2Xd points_;
  geometry::Polygon outline_;
  Eigen::VectorXd depths_;
  double thickness_;
  Eigen::Vector3d com_;
  double mass_ = 0.05;
  std::vector<geometry::PlacedShape> shapes_;
  collision::Solid solid_;
};

/// The mean of points (3 x n) weighted by their masses: the centre of mass of a mass distribution.
/// Throws std::invalid_argument unless there is one mass a point, none negative, with a positive
/// sum.
GRASPLESS_API Eigen::Vector3d center_of_mass(const Eigen::Matrix3Xd& points,
                                             const Eigen::VectorXd& masses);

/// A flat surface to slide on: a polygon in the plane z = 0 of its frame S (z up, out of the
/// surface).
class GRASPLESS_API Support {
 public:
  /// `slab` is how thick the top is [m]; `band_width` how far from the edges P_g reaches [m];
  /// `friction` that of the object on it. Throws std::invalid_argument unless they are positive and
  /// X_WS is a rigid pose tilted by less than 60 degrees.
  Support(const geometry::Polygon& polygon, const Eigen::Isometry3d& X_WS, double slab = 0.04,
          double band_width = 0.06, double friction = 0.3);

  const geometry::Polygon& polygon() const {
    return goal_band_.polygon();
  }                                                               ///< Q of the paper, in S
  const geometry::Band& goal_band() const { return goal_band_; }  ///< P_g of the paper, in S
  const Eigen::Isometry3d& X_WS() const { return X_WS_; }
  double slab() const { return slab_; }
  double friction() const { return friction_; }
  Eigen::Vector3d normal_W() const { return X_WS_.linear().col(2); }
  /// Prisms over the convex parts of the polygon, below z = 0, in S.
  const std::vector<geometry::PlacedShape>& shapes() const { return shapes_; }
  const collision::Solid& solid() const { return solid_; }

 private:
  geometry::Band goal_band_;
  Eigen::Isometry3d X_WS_;
  double slab_, friction_;
  std::vector<geometry::PlacedShape> shapes_;
  collision::Solid solid_;
};

/// How the sliding finger gives way under the press.
enum class FingerModel {
  none,     ///< not at all: the contact stays at the commanded tip, as in the paper
  flexure,  ///< it turns about one flexure behind the tip: the contact runs ahead of the commanded
            ///< tip
};

/// What the planner must know of a hand. Links and groups are the robot's.
struct Hand {
  std::string arm = "arm";                   ///< group of joints that carry the hand, base to wrist
  std::string fingertip = "left_fingertip";  ///< frame F: X along the line contact, Z out of the
                                             ///< tip, Y towards the other finger
  std::vector<std::string> sliding_finger = {
      "left_finger"};  ///< links that may press into object and support
  std::vector<std::string> fingers = {"left_finger",
                                      "right_finger"};  ///< links that close on the object
  std::string grasp_frame = "grasp";  ///< frame H: origin between the open tips, Z out of the hand,
                                      ///< Y from finger to finger
  std::string open = "open";          ///< state of the hand's joints while it slides and reaches
  std::string closed = "closed";      ///< state towards which it closes; it stops at contact
  FingerModel finger_model = FingerModel::flexure;
  double flexure_length = 0.11;    ///< from the flexure to the tip [m]
  double tip_radius = 0.005;       ///< of the pad that rolls on the object [m]
  double flexure_stiffness = 4.6;  ///< [Nm/rad]: presses with 9 N at a depth of 15 mm
  double pad_width = 0.032;        ///< of the line contact [m]
  double pad_friction = 1.16;      ///< of the pad on the object
};

using collision::Obstacle;  // in the way of the arm and of the sliding object

/// What is given: slide `object` from X_WO_start to the edge of `support` and grasp it there.
struct Problem {
  robot::Robot robot;
  Hand hand;
  Object object;
  Support support;
  Eigen::Isometry3d X_WO_start;  ///< flat on the support
  std::vector<Obstacle> obstacles;
  Eigen::VectorXd q_home;  ///< where the robot stands, all joints
};

/// Throws std::invalid_argument that names the field, the value and the choices: unknown links,
/// groups or states; a home of the wrong size or outside its limits; an object that does not lie
/// flat on the support (2 mm, 1 degree) or whose centre of mass is off it; finger figures that are
/// not positive.
GRASPLESS_API void validate(const Problem& problem);

}  // namespace graspless::slide
