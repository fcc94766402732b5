// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "graspless/slide/slide.hpp"

#include "slide/contact.hpp"

/// Geometry of IsPairValid() (Section IV-C.1): overhang, centre of mass and grasp of an object pose
/// near an edge.
namespace graspless::slide {

/// Position of the object relative to the support's edge.
struct Placement {
  bool sticks_out = false;  ///< true if P_out is not empty
  double overhang = 0;  ///< u: largest distance of P_out, or of its part, from the line of `edge`
                        ///< [m]; 0 if a point of P_out is nearest to an edge that is not usable
  /// Geometric centre of P_out, in S [m]. If that is not on the object, as with several parts or a
  /// ring: of the largest part, or its point nearest to that part's centre.
  Eigen::Vector2d out_center;
  geometry::Polygon::Edge edge{};  ///< the edge nearest to out_center
  double height = 0;               ///< of the object, near out_center [m]
  /// The centre of mass is at least com_margin inside Q; over a hollow underside, also inside the
  /// part of the rim that is on Q.
  bool com_inside = false;
  std::string fault = "overhang";  ///< what is wrong if the overhang is too small
};

GRASPLESS_API Placement placement(const Problem& problem, const Options& options,
                                  const Planar& object_S);

/// Least distance of the contact from the object's outline at the start of a slide [m]:
/// options.rim_margin, at most half of the largest that the object allows. Minus infinity for 0.
double rim_margin(const Object& object, const Options& options);

/// Radius around a contact in which a slide needs the object's top face, at least: half of the part
/// of the pad that must bear, by options.pad_spread [m].
double face_radius(const Hand& hand, const Options& options);

/// True if the finger may press there: the top face is level, and nothing beside it meets the pad.
bool can_press_at(const Problem& problem, const Options& options, const Eigen::Vector2d& p_O);

/// Indices of those of P_o on which the finger may press: not within rim_margin() of the outline,
/// and on the object's top face, under the whole pad if there are such points.
std::vector<std::int32_t> contact_points(const Problem& problem, const Options& options);

/// Centre of mass, projected along gravity onto the support, in S [m].
Eigen::Vector2d com_foot(const Problem& problem, const Planar& object_S);

/// True if the centre of mass, projected along gravity, lies at least `margin` [m] inside the
/// polygon.
bool is_com_inside(const Problem& problem, const Planar& object_S, double margin);

/// True if so it does; over a hollow underside, also inside the part of the rim that is on the
/// support.
GRASPLESS_API bool is_supported(const Problem& problem, const Planar& object_S, double margin);

/// H_g: perpendicular to the edge in the plane of Q, with the finger plane vertical, half the
/// object's height there above the support at the centre of P_out, moved outwards by `back` [m].
/// `roll` 0 or 1 chooses which finger is on top.
GRASPLESS_API Eigen::Isometry3d grasp_pose(const Problem& problem, const Placement& placement,
                                           int roll, double back = 0);

/// Indices of the support's edges over which objects may stick out, in proportion to their length.
GRASPLESS_API std::discrete_distribution<int> usable_edges(const Support& support);

/// Draws an object pose that is valid by construction: over an edge, at a random yaw, with an
/// overhang between u* and the largest that keeps the centre of mass inside. Returns nothing if
/// this draw leaves no such overhang.
GRASPLESS_API std::optional<Planar> draw_graspable_pose(const Problem& problem,
                                                        const Options& options,
                                                        const geometry::Polygon::Edge& edge,
                                                        std::mt19937_64& rng);

}  // namespace graspless::slide
