// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Supports and objects in depth images.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/ray_image.hpp"
#include "graspless/geometry/shape.hpp"
#include "graspless/perception/camera.hpp"
#include "graspless/perception/options.hpp"

namespace graspless::perception {

/// A depth image and the camera that took it.
struct View {
  DepthImage depth;                                        ///< [m]; 0 or not finite: none
  Eigen::Matrix3d K = Camera{}.K;                          ///< camera matrix [pixels]
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();  ///< pose of the optical frame
};

enum class Status { found, no_depth, not_metres, no_support, camera_below };

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::found, "found", "At least one support was found; there may be no objects."},
      Choice{Status::no_depth, "no_depth", "Too few pixels have a depth."},
      Choice{Status::not_metres, "not_metres", "The depths are too large to be in metres."},
      Choice{Status::no_support, "no_support",
             "No plane is large and level enough to be a support."},
      Choice{Status::camera_below, "camera_below",
             "The only large planes are seen from below: X_WC is wrong, or the camera is under the "
             "table."}};
}

/// Reason why a support ends at an edge.
enum class EdgeLabel { real, image_border, occluded };

/// Table of the values: name and text.
constexpr auto choices(EdgeLabel) {
  using planning::Choice;
  return std::array{
      Choice{EdgeLabel::real, "real",
             "The support ends: rays just beyond the edge pass its plane and end lower."},
      Choice{EdgeLabel::image_border, "image_border",
             "The image ends. The support may extend further."},
      Choice{EdgeLabel::occluded, "occluded",
             "Something hides what is beyond, or there is no depth. The support may extend "
             "further."}};
}

/// A level or tilted plane that objects lie on. Its frame S has z out of the plane and x to the
/// right of the first camera that sees it.
struct Support {
  std::string name;              ///< support_0, the largest, support_1, ...
  geometry::Polygon polygon;     ///< in S [m]
  std::vector<EdgeLabel> edges;  ///< one per edge of the polygon
  Eigen::Isometry3d X_WS;
  double height_error;     ///< standard error of the plane's height at its centre [m]
  double angle_error;      ///< standard error of its tilt [rad]
  double noise;            ///< standard deviation of the depth that was measured on it [m]
  double least_thickness;  ///< least thickness of an object that would have been seen [m]
};

/// Something that stands on a support or lies on it. Its frame O has its origin in the support's
/// plane below the centroid of the outline, z out of the plane, and x along its longest extent.
struct Object {
  std::string name;           ///< object_0, object_1, ... from the nearest to the first camera
  std::string support;        ///< name of the support
  geometry::Polygon outline;  ///< projection of what was seen onto the support, in O [m]
  Eigen::Isometry3d X_WO;
  double thickness;         ///< height of the top above the support [m]
  double thickness_error;   ///< standard error of the thickness [m]
  bool is_flat;             ///< true if all that was seen of the top is equally high
  double position_error;    ///< standard error of the outline's position along the support [m]
  double yaw_error;         ///< standard error of the direction of x [rad]
  Eigen::Matrix3Xd points;  ///< p_OP of all pixels of the object [m]
  /// Rays of each camera that saw it, around it. They tell holes from rims and from edges of what
  /// was seen.
  std::vector<geometry::RayImage> rays;
  bool touches_border;  ///< true if the image cuts the object off
  std::vector<std::string> warnings;
};

/// Space over a support that no ray reached.
struct Unseen {
  std::string behind;      ///< name of the object that hides it; empty: a patch without depth
  geometry::Convex shape;  ///< in W
};

/// Result of perceive().
struct Scene {
  Status status = Status::no_depth;
  std::string reason;  ///< result, or why there is none and what to do; one sentence or two
  std::vector<Support> supports;  ///< from the largest to the smallest
  std::vector<Object> objects;
  std::vector<Unseen> unseen;
  std::vector<std::string> warnings;  ///< doubts about what was found, one sentence each
  /// Time at which the images were taken [s since 1970]; set by the caller, nothing if unknown.
  std::optional<double> stamp = std::nullopt;
  explicit operator bool() const { return status == Status::found; }
};

/// Finds supports and objects in depth images of a still scene, taken by one or several cameras.
/// Finding nothing is a status. Throws std::invalid_argument that names the field if there is no
/// view, or a camera, pose or option is not valid. The same seed gives the same scene.
GRASPLESS_API Scene perceive(const std::vector<View>& views, const Options& options = {});

}  // namespace graspless::perception
