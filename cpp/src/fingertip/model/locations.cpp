// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Locations of fingertips: a cell-centred grid of points on each face, those that the sphere can
// reach, and placements as sets of them.
#include "fingertip/model/locations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "graspless/collision/world.hpp"
#include "graspless/watch.hpp"

#include "mechanics/contacts/wrenches.hpp"

namespace graspless::fingertip {
namespace {

// The sphere is tested a little smaller, so as not to touch the face that it presses on; more than
// the collision checker's own uncertainty.
constexpr double kShrink = 1e-3;
constexpr double kMinShrink = 2e-6;  // [m]
constexpr double kSlack = 1e-9;      // by the object's size

/// Which locations' spheres touch the object nowhere else.
std::vector<Location> reachable(std::vector<Location> all, const Object& object, double radius) {
  if (object.is_convex()) return all;
  const double shrink = std::max(kShrink * radius, std::min(kMinShrink, radius / 2));
  collision::World world;
  const int body = world.add_body("object", object.solid());
  const int sphere = world.add_body(
      "fingertip", {{geometry::Sphere{radius - shrink}, Eigen::Isometry3d::Identity()}});
  world.add_pair(body, sphere);
  const auto touches = [&](const Location& location) {
    poll();
    world.set_pose(sphere, Eigen::Isometry3d(Eigen::Translation3d(location.center_O)));
    return world.collides();
  };
  all.erase(std::remove_if(all.begin(), all.end(), touches), all.end());
  return all;
}

std::vector<mechanics::FingerWrenches> wrenches_of(const std::vector<Location>& all,
                                                   const Object& object, const Fingers& fingers,
                                                   const Options& options) {
  mechanics::ContactSet set;
  set.com_O = object.com();
  set.wrench_scale = mechanics::wrench_scale(object.mass(), object.inertia());
  set.cone_edges = options.cone_edges;
  set.fingers.resize(1);
  const auto at_friction = [&](double friction) {
    set.fingers[0].friction = friction;
    return mechanics::wrenches_of_fingers(set).front();
  };
  std::vector<mechanics::FingerWrenches> wrenches;
  wrenches.reserve(all.size());
  for (const Location& at : all) {
    poll();
    set.fingers[0] = {at.p_OC, at.n_O, fingers.friction.lower, fingers.max_normal_force, at.t_O};
    wrenches.push_back(at_friction(fingers.friction.lower));
    if (fingers.friction.upper > fingers.friction.lower) {
      wrenches.back().jam_generators = at_friction(fingers.friction.upper).generators;
    }
  }
  return wrenches;
}

constexpr double kEdge = 1e-9;  // points this near to a triangle lie in it, by the object's size

/// A face laid out in its grid axes.
struct Rectangle {
  Eigen::Vector2d lower, size;
};

Eigen::Vector2d in_face(const Face& face, const Eigen::Vector3d& p_O) {
  return {face.first_O.dot(p_O), face.second_O.dot(p_O)};
}

Rectangle bounds(const Face& face, const geometry::Mesh& mesh) {
  Eigen::AlignedBox2d box;
  for (const int t : face.triangles) {
    for (int k = 0; k < 3; ++k) box.extend(in_face(face, mesh.vertices.col(mesh.triangles(k, t))));
  }
  return {box.min(), box.sizes()};
}

/// Cells along a side of this length [m].
double num_cells(double length, const Options& options) {
  if (options.location_spacing <= 0) return options.locations_per_side;
  return std::max(1.0, std::ceil(length / options.location_spacing - 1e-9));
}

bool is_inside(const Eigen::Vector2d& p, const std::array<Eigen::Vector2d, 3>& corners,
               double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d side = corners[(k + 1) % 3] - corners[k];
    const Eigen::Vector2d to_p = p - corners[k];
    // The grid axes are right-handed about the inward normal: seen so, triangles run clockwise.
    if (side.y() * to_p.x() - side.x() * to_p.y() < -tolerance * side.norm()) return false;
  }
  return true;
}

bool is_inside(const Eigen::Vector2d& p, const Face& face, const geometry::Mesh& mesh,
               double tolerance) {
  for (const int t : face.triangles) {
    poll();
    std::array<Eigen::Vector2d, 3> corners;
    for (int k = 0; k < 3; ++k) {
      corners[k] = in_face(face, mesh.vertices.col(mesh.triangles(k, t)));
    }
    if (is_inside(p, corners, tolerance)) return true;
  }
  return false;
}

/// Where locations are already, in cells as wide as they must be apart. Curved meshes have more
/// faces than their surface has room for locations.
class Taken {
 public:
  explicit Taken(double apart) : apart_(apart) {}

  /// Takes a place, unless one near by and facing alike is taken.
  bool take(const Location& location) {
    if (apart_ <= 0) return true;
    const Eigen::Vector3i cell = (location.p_OC / apart_).array().floor().cast<int>();
    for (int i = 0; i < 27; ++i) {
      const auto near =
          cells_.find(key(cell + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
      if (near == cells_.end()) continue;
      for (const Location& other : near->second) {
        const bool is_near = (other.p_OC - location.p_OC).norm() < apart_;
        if (is_near && other.n_O.dot(location.n_O) > kAlike) return false;
      }
    }
    cells_[key(cell)].push_back(location);
    return true;
  }

 private:
  static constexpr double kAlike = 0.9;  // cosine between normals
  using Key = std::array<int, 3>;
  static Key key(const Eigen::Vector3i& cell) { return {cell.x(), cell.y(), cell.z()}; }
  double apart_;
  std::map<Key, std::vector<Location>> cells_;
};

constexpr double kSamePlace = 1e-9;  // by the object's size

/// Index of each finger's location at the start. One that is not among the locations is added.
std::vector<int> add_start(const Object& object, const Fingers& fingers,
                           std::vector<Location>& all) {
  std::vector<int> start;
  for (const Eigen::Vector3d& p_O : fingers.start) {
    const Location at = location_at(object, fingers.radius, p_O).value();  // by validate()
    const auto is_it = [&](const Location& other) {
      return other.face == at.face && (other.p_OC - at.p_OC).norm() <= kSamePlace * object.size();
    };
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    start.push_back(static_cast<int>(found - all.begin()));
    if (found == all.end()) all.push_back(at);
  }
  return start;
}

}  // namespace

int num_fingers(const Placement& placement) {
  int count = 0;
  while (count < mechanics::kMaxFingers && placement[count] >= 0) ++count;
  return count;
}

Placement with(const Placement& placement, int location) {
  Placement result = placement;
  int i = num_fingers(placement);
  for (; i > 0 && result[i - 1] > location; --i) {
    result[i] = result[i - 1];
  }
  result[i] = location;
  return result;
}

Placement without(const Placement& placement, int location) {
  Placement result = kNoFingers;
  std::remove_copy(placement.begin(), placement.end(), result.begin(), location);
  return result;
}

Locations::Locations(const Object& object, const Fingers& fingers, const Options& options)
    : all_(reachable(grid_locations(object, fingers.radius, options), object, fingers.radius)),
      start_(add_start(object, fingers, all_)),
      wrenches_(wrenches_of(all_, object, fingers, options)) {
  const double apart = 2 * fingers.radius - kSlack * object.size();
  const double span = fingers.max_span + kSlack * object.size();
  min_distance2_ = apart > 0 ? apart * apart : 0;
  max_distance2_ = span * span;
}

bool Locations::are_apart(int a, int b) const {
  const double distance2 = ((*this)[a].center_O - (*this)[b].center_O).squaredNorm();
  return distance2 >= min_distance2_ && distance2 <= max_distance2_;
}

double num_grid_points(const Object& object, const Options& options) {
  double count = 0;
  for (const Face& face : object.faces()) {
    const Rectangle r = bounds(face, object.mesh());
    count += num_cells(r.size.x(), options) * num_cells(r.size.y(), options);
  }
  return count;
}

std::vector<Location> grid_locations(const Object& object, double radius, const Options& options) {
  std::vector<Location> all;
  Taken taken(options.location_spacing / 2);
  for (std::size_t f = 0; f < object.faces().size(); ++f) {
    const Face& face = object.faces()[f];
    const Rectangle r = bounds(face, object.mesh());
    const double columns = num_cells(r.size.x(), options), rows = num_cells(r.size.y(), options);
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        poll();
        const Eigen::Vector2d p = r.lower + Eigen::Vector2d((i + 0.5) / columns * r.size.x(),
                                                            (j + 0.5) / rows * r.size.y());
        if (!is_inside(p, face, object.mesh(), kEdge * object.size())) continue;
        const Eigen::Vector3d p_O =
            p.x() * face.first_O + p.y() * face.second_O + face.offset * face.n_O;
        const Location location{p_O, face.n_O, face.first_O, p_O - radius * face.n_O,
                                static_cast<int>(f)};
        if (taken.take(location)) all.push_back(location);
      }
    }
  }
  return all;
}

std::optional<Location> location_at(const Object& object, double radius,
                                    const Eigen::Vector3d& p_O) {
  std::optional<Location> nearest;
  double least = kStartTolerance;
  for (std::size_t f = 0; f < object.faces().size(); ++f) {
    poll();
    const Face& face = object.faces()[f];
    const double height = face.n_O.dot(p_O) - face.offset;
    if (!(std::abs(height) <= least)) continue;
    if (!is_inside(in_face(face, p_O), face, object.mesh(), kEdge * object.size())) continue;
    const Eigen::Vector3d on_face = p_O - height * face.n_O;
    least = std::abs(height);
    nearest =
        Location{on_face, face.n_O, face.first_O, on_face - radius * face.n_O, static_cast<int>(f)};
  }
  if (!nearest || reachable({*nearest}, object, radius).empty()) return std::nullopt;
  return nearest;
}

double sphere_speed(const mechanics::Vector6d& twist_O, const Location& location) {
  const Eigen::Vector3d omega_O = twist_O.tail<3>();
  return (twist_O.head<3>() + omega_O.cross(location.center_O)).norm();
}

}  // namespace graspless::fingertip
