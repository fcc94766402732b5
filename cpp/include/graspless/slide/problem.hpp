// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/obstacle.hpp"
#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/band.hpp"
#include "graspless/geometry/height_map.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/shape.hpp"
#include "graspless/planning/fields.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::slide {

/// An object that lies or stands on a support: a prism over its outline. Slides take thin ones
/// only. Its frame O has z up, the underside in the plane z = 0.
class GRASPLESS_API Object {
 public:
  /// Creates an object from its outline in O's x-y plane [m] and its thickness [m]. The contact
  /// points form a grid of `spacing` [m]. The centre of mass is the centroid of the outline, at
  /// half the thickness. Throws std::invalid_argument unless it is thin.
  static Object from_polygon(const std::string& name, const geometry::Polygon& outline,
                             double thickness, double spacing = 0.006);
  /// The same for an object of any height, which may be pinched.
  static Object prism(const std::string& name, const geometry::Polygon& outline, double thickness,
                      double spacing = 0.006);
  /// Creates an object from points on its top surface, (3 x n) in O [m]: P_o of the paper. The
  /// outline is their alpha shape. The thickness is their median height unless given. The centre of
  /// mass is their mean, at half the thickness. Throws std::invalid_argument on values that are not
  /// finite, fewer than three points, points on a line, or a thick object: heights that spread by
  /// more than 10 mm (5th to 95th percentile), or a thickness over half the width.
  static Object from_cloud(const std::string& name, const Eigen::Matrix3Xd& p_OP,
                           double thickness = 0);

  const std::string& name() const { return name_; }
  const Eigen::Matrix2Xd& points() const { return top_->points; }  ///< contact points, x-y in O [m]
  const geometry::Polygon& outline() const { return outline_; }
  /// Distance of each of points() to the outline [m].
  const Eigen::VectorXd& depths() const { return top_->depths; }
  /// Subset of points() that contains the farthest point in every direction: of neighbours with the
  /// same x, the first and the last along y.
  const Eigen::Matrix2Xd& outermost() const { return top_->outermost; }
  /// Mean distance of points() from a point in O [m]: that of a body whose mean and root mean
  /// square distances have the same ratio from everywhere, which is within 3 % for plates.
  double mean_distance(const Eigen::Vector2d& p_O) const {
    return top_->ratio * std::sqrt(top_->variance + (p_O - top_->middle).squaredNorm());
  }
  /// Largest lever of friction on the underside, relative to mean_distance(): 1 of a flat one. A
  /// hollow one may bear on two places of its outline, between which the middle of points() lies.
  double lever() const { return lever_; }
  /// Distance between neighbouring points(): the square root of the outline's area per point [m].
  double spacing() const { return spacing_; }
  double thickness() const { return thickness_; }  ///< of its highest part [m]
  /// Height of the face on which a finger presses [m]: the thickness of a prism. With heights, that
  /// of the level part of the top that has the most points(), or the thickness if nothing is level.
  double top() const { return face_height_; }
  /// True if the object has heights at a point, and all that is within `radius` of it is as high as
  /// that face, within 2.5 mm. So is a prism everywhere.
  bool has_face_at(const Eigen::Vector2d& p_O, double radius) const;
  /// Largest height within `radius` of a point [m]: the thickness of a prism.
  double height_near(const Eigen::Vector2d& p_O, double radius) const;
  bool is_thin() const;        ///< true if the thickness is at most 3/4 of the least width
  double least_width() const;  ///< across an edge of the outline [m]
  const Eigen::Vector3d& com() const { return com_; }  ///< in O [m]
  double mass() const { return mass_; }                ///< [kg]
  /// True if the underside may be hollow: the object may rest on the rim of its outline alone.
  bool is_hollow() const { return is_hollow_; }
  /// Heights within the outline, if they are known: the object is a prism otherwise.
  const std::optional<geometry::HeightMap>& heights() const { return heights_; }
  /// Prisms over the convex parts of the outline, or columns of the heights, in O, for collision
  /// checking.
  const std::vector<geometry::PlacedShape>& shapes() const { return shapes_; }
  const collision::Solid& solid() const { return solid_; }

  /// Returns a copy with another centre of mass, in O [m]. Throws std::invalid_argument unless it
  /// is finite and within the object's bounding box.
  Object with_com(const Eigen::Vector3d& com_O) const;
  /// Returns a copy with another mass [kg]. Throws std::invalid_argument unless it is positive.
  Object with_mass(double mass) const;
  /// Returns a copy that is as high as a map, in O, and no longer a prism. Throws
  /// std::invalid_argument unless the map is valid and nowhere higher than the thickness.
  Object with_heights(const geometry::HeightMap& heights_O) const;
  /// Returns a copy whose underside may be hollow, or is flat.
  Object with_hollow(bool is_hollow) const;
  /// Returns a copy scaled in its plane. Thickness and mass stay the same.
  Object scaled(double scale) const;

 private:
  Object(std::string name, Eigen::Matrix2Xd points, geometry::Polygon outline, double thickness,
         const Eigen::Vector2d& com);
  /// Shared by copies: a fine grid takes hundreds of megabytes.
  struct Top {
    Eigen::VectorXd depths;
    Eigen::Matrix2Xd outermost, points;
    Eigen::Vector2d middle;  // mean of the points [m]
    double variance, ratio;  // mean square distance from it [m^2]; mean distance over its root
  };
  static Top top_of(const geometry::Polygon& outline, Eigen::Matrix2Xd points);
  std::string name_;
  geometry::Polygon outline_;
  std::shared_ptr<const Top> top_;
  double spacing_;
  double thickness_, face_height_;
  Eigen::Vector3d com_;
  double mass_ = 0.05, lever_ = 1;
  bool is_hollow_ = false;
  std::optional<geometry::HeightMap> heights_;
  std::vector<geometry::PlacedShape> shapes_;
  collision::Solid solid_;
};

/// Returns the centre of mass of point masses at `points` (3 x n) [m]. Throws std::invalid_argument
/// unless there is one mass per point, none is negative, and their sum is positive.
GRASPLESS_API Eigen::Vector3d center_of_mass(const Eigen::Matrix3Xd& points,
                                             const Eigen::VectorXd& masses);

/// A flat surface to slide on: a polygon in the plane z = 0 of its frame S (z up, out of the
/// surface).
class GRASPLESS_API Support {
 public:
  /// `slab`: thickness of the table top [m]. `band_width`: width of P_g, the band along the edges
  /// where slides may end [m]. `friction`: coefficient of friction between object and support.
  /// `usable_edges`: indices of the edges over which objects may stick out; by default all. Beyond
  /// the others nobody knows what there is. Throws std::invalid_argument unless all lengths are
  /// positive, X_WS is a rigid pose tilted by at most 60 degrees, and the indices are those of at
  /// least one edge, each once.
  Support(const geometry::Polygon& polygon, const Eigen::Isometry3d& X_WS, double slab = 0.04,
          double band_width = 0.06, double friction = 0.3,
          const std::optional<std::vector<int>>& usable_edges = std::nullopt);

  /// Q and P_g of the paper, in S.
  const geometry::Polygon& polygon() const { return goal_band_.polygon(); }
  const geometry::Band& goal_band() const { return goal_band_; }
  const Eigen::Isometry3d& X_WS() const { return X_WS_; }
  double slab() const { return slab_; }
  double friction() const { return friction_; }
  /// True if objects may stick out over an edge of the polygon.
  bool is_usable(int edge) const { return is_usable_[static_cast<std::size_t>(edge)]; }
  bool has_unusable_edges() const;
  Eigen::Vector3d normal_W() const { return X_WS_.linear().col(2); }
  /// Prisms over the convex parts of the polygon, below z = 0, in S.
  const std::vector<geometry::PlacedShape>& shapes() const { return shapes_; }
  const collision::Solid& solid() const { return solid_; }

 private:
  geometry::Band goal_band_;
  Eigen::Isometry3d X_WS_;
  double slab_, friction_;
  std::vector<bool> is_usable_;  // one per edge
  std::vector<geometry::PlacedShape> shapes_;
  collision::Solid solid_;
};

/// Model of how the sliding finger yields when it presses on the object.
enum class FingerModel { none, flexure, impedance, rigid_guarded };

/// Table of the values: name and text.
constexpr auto choices(FingerModel) {
  using planning::Choice;
  return std::array{
      Choice{FingerModel::none, "none",
             "Rigid, on an arm that holds its position: depth 0, and at most 3 mm, which a pad "
             "gives way."},
      Choice{FingerModel::flexure, "flexure",
             "Bends about one flexure: the contact moves ahead of the commanded tip. Depth 5 to 25 "
             "mm."},
      Choice{
          FingerModel::impedance, "impedance",
          "Rigid, on an arm under impedance control: the wrist gives way without turning, so the "
          "contact is below the commanded tip. Depth 0.5 to 1.5 times press_force / "
          "wrist_stiffness."},
      Choice{FingerModel::rigid_guarded, "rigid_guarded",
             "Rigid, on an arm that moves down until it touches and then holds press_force: depth "
             "0."}};
}

/// Description of the hand: names from the robot's URDF and SRDF, and the pad that slides. fields()
/// describes them. The default stiffness presses with 9 N at a depth of 15 mm.
struct Hand {
  std::string arm = "arm";
  std::string fingertip = "left_fingertip";
  std::vector<std::string> sliding_finger = {"left_finger"};
  std::vector<std::string> fingers = {"left_finger", "right_finger"};
  std::string grasp_frame = "grasp";
  std::string open = "open";
  std::string closed = "closed";
  FingerModel finger_model = FingerModel::flexure;
  double flexure_length = 0.11;
  double tip_radius = 0.005;
  double flexure_stiffness = 4.6;
  double wrist_stiffness = 0;
  double press_force = 9;
  double pad_width = 0.032;
  double pad_friction = 1.16;
};

/// Table of the members: name, unit, text and range.
inline auto fields(const Hand&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"arm", &Hand::arm, "", "Group of joints that carry the hand, base to wrist."},
      Field{"fingertip", &Hand::fingertip, "",
            "Frame F: X along the line contact, Z out of the tip, Y towards the other finger."},
      Field{"sliding_finger", &Hand::sliding_finger, "",
            "Links that may press into object and support."},
      Field{"fingers", &Hand::fingers, "", "Links that close on the object."},
      Field{"grasp_frame", &Hand::grasp_frame, "",
            "Frame H: origin between the open tips, Z out of the hand, Y from finger to finger."},
      Field{"open", &Hand::open, "", "State of the hand's joints while it slides and reaches."},
      Field{"closed", &Hand::closed, "",
            "State that the hand closes towards, until it touches the object."},
      Field{"finger_model", &Hand::finger_model, "",
            "Model of how the sliding finger yields when it presses on the object."},
      Field{"flexure_length", &Hand::flexure_length, "m", "Distance from the flexure to the tip.",
            Range::left_open(0, 1)},
      Field{"tip_radius", &Hand::tip_radius, "m", "Radius of the pad that rolls on the object.",
            Range::left_open(0, 0.1)},
      Field{"flexure_stiffness", &Hand::flexure_stiffness, "Nm/rad", "Stiffness of the flexure.",
            Range::left_open(0, 1000)},
      Field{"wrist_stiffness", &Hand::wrist_stiffness, "N/m",
            "Stiffness of the arm's impedance control in translation. finger_model impedance needs "
            "it.",
            Range::closed(0, 1e5)},
      Field{"press_force", &Hand::press_force, "N",
            "Normal force that a finger without a flexure presses with.",
            Range::left_open(0, 1000)},
      Field{"pad_width", &Hand::pad_width, "m", "Length of the line contact.",
            Range::left_open(0, 0.2)},
      Field{"pad_friction", &Hand::pad_friction, "",
            "Coefficient of friction between pad and object.", Range::left_open(0, 10)});
}

using collision::Obstacle;  // neither the arm nor the sliding object may touch one

/// The task: slide `object` from X_WO_start to an edge of `support` and grasp it there.
struct Problem {
  robot::Robot robot;
  Hand hand;
  Object object;
  Support support;
  Eigen::Isometry3d X_WO_start;  ///< flat on the support
  std::vector<Obstacle> obstacles;
  Eigen::VectorXd q_home;  ///< configuration at the start, all joints [rad or m]
};

/// Throws std::invalid_argument that names the field, its value and what is allowed: unknown links,
/// groups or states; a q_home outside the joint limits; an object that is not flat on the support
/// (2 mm, 1 degree) or whose centre of mass is off it; finger dimensions out of range.
GRASPLESS_API void validate(const Problem& problem);

}  // namespace graspless::slide
