// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/fingertip/problem.hpp"
#include "graspless/mechanics/contact.hpp"
#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::fingertip {

/// Where a fingertip may press.
struct Location {
  Eigen::Vector3d p_OC, n_O, t_O;  // t_O: the face's first grid axis, the cone's first edge
  Eigen::Vector3d center_O;        // of the sphere
  int face;
};

/// Fingers on locations: indices in ascending order, then -1. Fingers are equal, so a placement is
/// a set.
using Placement = std::array<std::int32_t, mechanics::kMaxFingers>;
constexpr Placement kNoFingers = {-1, -1, -1, -1};

int num_fingers(const Placement& placement);
Placement with(const Placement& placement, int location);     // keeps the order
Placement without(const Placement& placement, int location);  // the kept fingers of a regrasp

/// The points of an object's grid: cell-centred on each face's bounding rectangle, inside the face.
/// With location_spacing, none nearer than half of it to another that faces alike.
std::vector<Location> grid_locations(const Object& object, double radius, const Options& options);
/// How many grid_locations() would look at: no fewer than it returns.
double num_grid_points(const Object& object, const Options& options);
/// The location on the surface within kStartTolerance of a point; empty: there is none, or the
/// sphere would touch the object elsewhere, too.
std::optional<Location> location_at(const Object& object, double radius,
                                    const Eigen::Vector3d& p_O);

/// The lattice of locations on the object's surface at which the sphere does not touch the object
/// elsewhere.
class Locations {
 public:
  Locations(const Object& object, const Fingers& fingers, const Options& options);

  int size() const { return static_cast<int>(all_.size()); }
  const Location& operator[](int i) const { return all_[i]; }
  const mechanics::FingerWrenches& wrenches(int i) const { return wrenches_[i]; }
  /// Where each finger starts; empty: anywhere.
  const std::vector<int>& start() const { return start_; }
  // The spheres do not overlap (touching is allowed), and are no farther apart than fingers reach.
  bool are_apart(int a, int b) const;

 private:
  std::vector<Location> all_;
  std::vector<int> start_;
  std::vector<mechanics::FingerWrenches> wrenches_;
  double min_distance2_ = 0, max_distance2_ = 0;
};

/// How fast a sphere's centre moves with the object's twist [m per unit of time].
double sphere_speed(const mechanics::Vector6d& twist_O, const Location& location);

}  // namespace graspless::fingertip
