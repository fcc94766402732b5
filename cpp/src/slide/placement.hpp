// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <random>

#include "graspless/slide/slide.hpp"

#include "slide/contact.hpp"

/// The geometry of IsPairValid: what an object pose near the edge is worth (Section IV-C).
namespace graspless::slide {

/// How the object lies on the support.
struct Placement {
  bool sticks_out = false;         ///< whether any point does
  double overhang = 0;             ///< u: the farthest of P_out from the line of `edge` [m]
  Eigen::Vector2d out_center;      ///< geometric centre of P_out, in S
  geometry::Polygon::Edge edge{};  ///< the edge nearest to out_center
  bool com_inside = false;         ///< the centre of mass is com_margin inside Q
};

Placement placement(const Problem& problem, const Options& options, const Planar& object_S);

/// Whether the centre of mass, seen along gravity, lies `margin` inside the polygon.
bool is_com_inside(const Problem& problem, const Planar& object_S, double margin);

/// H_g: perpendicular to the edge in the plane of Q, the finger plane vertical, between the faces
/// of the object at the centre of P_out, `back` outwards of it. Two rolls: 0 and 1.
Eigen::Isometry3d grasp_pose(const Problem& problem, const Placement& placement, int roll,
                             double back = 0);

/// An object pose that is valid by construction: over a random edge, at a random yaw, sticking out
/// by between u* and what the margin of the centre of mass leaves. Nothing when this draw leaves no
/// room between the two.
std::optional<Planar> draw_graspable_pose(const Problem& problem, const Options& options,
                                          std::mt19937_64& rng);

}  // namespace graspless::slide
