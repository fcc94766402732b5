// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/height_map.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::slide {

/// An object that lies or stands on a support: a prism over its outline. Slides take thin ones
/// only. Its frame O has z up, the underside in the plane z = 0.
class GRASPLESS_API Object {
 public:
  /// A copy shares the points. Moving copies, so that no object is left empty.
  Object(const Object&) = default;
  Object& operator=(const Object&) = default;

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
  /// more than 10 mm (5th to 95th percentile), or a thickness over 3/4 of the width.
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
  /// of the level part of the top that has the most points(), above all near the centre of mass, or
  /// the thickness if nothing is level.
  double top() const { return face_height_; }
  /// True if the object has heights at a point, all that is within `radius` of it is as high as
  /// that face, within 2.5 mm, and nothing within `clear` is higher. So is a prism everywhere.
  bool has_face_at(const Eigen::Vector2d& p_O, double radius, double clear) const;
  /// Largest height within `radius` of a point [m]: the thickness of a prism.
  double height_near(const Eigen::Vector2d& p_O, double radius) const;
  bool is_thin() const;        ///< true if the thickness is at most 3/4 of the least width
  double least_width() const;  ///< across an edge of the outline [m]
  const Eigen::Vector3d& com() const { return com_; }  ///< in O [m]
  double mass() const { return mass_; }                ///< [kg]; 0.05 unless with_mass() sets it
  /// True if the underside may be hollow: the object may rest on the rim of its outline alone.
  bool is_hollow() const { return is_hollow_; }
  /// Heights within the outline, if they are known: the object is a prism otherwise.
  const std::optional<geometry::HeightMap>& heights() const { return heights_; }
  /// Prisms over the convex parts of the outline, or columns of the heights, in O, for collision
  /// checking.
  const std::vector<geometry::PlacedShape>& shapes() const { return shapes_; }
  const collision::Solid& solid() const { return solid_; }

  /// Returns a copy with another centre of mass, in O [m]. Throws std::invalid_argument unless it
  /// is finite, within the convex hull of the outline, and at a height from 0 to the thickness.
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

}  // namespace graspless::slide
