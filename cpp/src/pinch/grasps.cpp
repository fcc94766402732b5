// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/grasps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pinch/face_measure.hpp"
#include "pinch/poses.hpp"

namespace graspless::pinch {

using Eigen::AngleAxisd, Eigen::Isometry3d, Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr std::size_t kFacesPerDirection = 2;
constexpr double kApart = 0.02;  // between faces of one direction [m]

std::string slippery(double needed, double allowed) {
  return text_of(
      "no two faces are opposite each other: a coefficient of friction of %.2f is needed, "
      "at most %.2f is allowed",
      needed, allowed);
}

/// Narrows the faces down, and notes what the nearest of the rejected ones lack.
class Selection {
 public:
  Selection(const Problem& problem, const Options& options, const Jaw& jaw)
      : problem_(problem), options_(options), jaw_(jaw) {}

  std::vector<Faces> run(Grasps& result) {
    const Vector2d com = problem_.object.com().head<2>();
    std::vector<Faces> faces = opposite_faces(problem_.object.outline(), com, jaw_.open().pad);
    const auto least = [&](auto value) {
      double found = std::numeric_limits<double>::infinity();
      for (const Faces& pair : faces) found = std::min(found, value(pair));
      return found;
    };
    const double friction = least([](const Faces& pair) { return pair.friction; });
    keep(faces, [&](const Faces& pair) { return pair.friction <= options_.friction; });
    if (faces.empty())
      return refuse(result, Status::too_slippery, slippery(friction, options_.friction));
    const double narrowest = least([](const Faces& pair) { return pair.width; });
    const double opening = jaw_.opening() - 2 * options_.margin;
    keep(faces,
         [&](const Faces& pair) { return pair.width <= opening && pair.width > jaw_.least_gap(); });
    if (faces.empty()) {
      return refuse(result, Status::too_wide,
                    narrowest > opening
                        ? in_mm(narrowest) + " wide where it is narrowest, the hand opens " +
                              in_mm(jaw_.opening()) + " and needs " + in_mm(options_.margin) +
                              " on each side"
                        : in_mm(narrowest) + " wide, the closed fingers stay " +
                              in_mm(jaw_.least_gap()) + " apart");
    }
    const double lever = least([](const Faces& pair) { return pair.lever; });
    keep(faces, [&](const Faces& pair) { return pair.lever <= options_.max_lever; });
    if (faces.empty()) {
      return refuse(result, Status::too_slippery,
                    "the faces that fit the hand are " + in_mm(lever) +
                        " or more from the centre of mass, at most " + in_mm(options_.max_lever) +
                        " is allowed");
    }
    return faces;
  }

 private:
  const Problem& problem_;
  const Options& options_;
  const Jaw& jaw_;
};

/// Drops faces that lean too much where a pad touches them, by the test of check(), and counts the
/// friction that the others need there.
void drop_leaning(std::vector<Faces>& faces, const Problem& problem, const Options& options,
                  Grasps& result) {
  double least = std::numeric_limits<double>::infinity();
  const auto leans = [&](Faces& pair) {
    const Vector2d closing = (pair.second - pair.first).normalized();
    const geometry::Polygon& outline = problem.object.outline();
    const auto first = steepest_around(outline, pair.first, -closing),
               second = steepest_around(outline, pair.second, closing);
    if (!first || !second) return true;
    const double slope = std::max(std::abs(*first), std::abs(*second));
    least = std::min(least, slope);
    pair.friction = std::max(pair.friction, least_friction(slope));
    return !is_held(slope, options.friction);
  };
  faces.erase(std::remove_if(faces.begin(), faces.end(), leans), faces.end());
  if (faces.empty() && result.status == Status::solved) {
    result.status = Status::too_slippery;
    result.reason = slippery(least, options.friction);
  }
}

/// The best faces of each direction and height, best first.
std::vector<Faces> thinned(std::vector<Faces> faces) {
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Faces& a, const Faces& b) { return cost(a) < cost(b); });
  std::vector<Faces> kept;
  for (const Faces& pair : faces) {
    std::size_t same = 0;
    bool is_near = false;
    for (const Faces& other : kept) {
      if (other.yaw != pair.yaw || other.height != pair.height) continue;
      ++same;
      is_near = is_near || (other.middle() - pair.middle()).norm() < kApart;
    }
    if (same < kFacesPerDirection && !is_near) kept.push_back(pair);
  }
  return kept;
}

}  // namespace

double cost(const Faces& faces) {
  return faces.friction + faces.load + std::hypot(faces.lever, faces.offset) / kLever;
}

std::string in_mm(double length) { return text_of("%.0f mm", 1000 * length); }

std::vector<Faces> refuse(Grasps& result, Status status, const std::string& reason) {
  result.status = status;
  result.reason = reason;
  return {};
}

std::string too_heavy(const std::string& held_by, double away, const Faces& best, double press,
                      double mass) {
  return text_of(
      "held by %s %.0f mm from the centre of mass, the pads bear %.2f kg at %.3g N a finger; it "
      "weighs %.2f kg",
      held_by.c_str(), 1000 * away, *best.max_mass, press, mass);
}

Faces weighed(Faces faces, const Problem& problem, double height) {
  const Vector3d down = problem.X_WO_start.linear().transpose() * -Vector3d::UnitZ(),
                 closing(std::cos(faces.yaw), std::sin(faces.yaw), 0),
                 middle(faces.middle().x(), faces.middle().y(), height),
                 arm = problem.object.com() - middle, torque = arm.cross(down);
  const double twist = torque.dot(closing);
  faces.lever = std::abs(twist);
  faces.offset = (torque - twist * closing).norm();
  faces.drop = arm.dot(down);
  return faces;
}

Grasps find_grasps(const Problem& problem, const Options& options, const Jaw& jaw) {
  Grasps result;
  const bool has_walls = problem.object.heights().has_value();
  std::vector<Faces> faces = thinned(has_walls ? select_walls(problem, options, jaw, result)
                                               : Selection(problem, options, jaw).run(result));
  if (has_walls && !faces.empty())
    faces = measured_walls(std::move(faces), problem, options, jaw, result);
  if (!has_walls) drop_leaning(faces, problem, options, result);
  result.num_faces = faces.size();
  Poses poses(problem, options, jaw);
  for (const Faces& pair : faces) poses.add(pair);
  poses.finish(result);
  return result;
}

}  // namespace graspless::pinch
