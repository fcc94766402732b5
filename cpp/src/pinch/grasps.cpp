// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/grasps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "pinch/face_measure.hpp"
#include "pinch/press.hpp"
#include "pinch/walls.hpp"

namespace graspless::pinch {

using Eigen::AngleAxisd, Eigen::Isometry3d, Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr double kTilts[] = {0, kPi / 6, -kPi / 6, kPi / 3, -kPi / 3, kPi / 2, -kPi / 2};
constexpr std::size_t kFacesPerDirection = 2;
constexpr double kApart = 0.02;        // between faces of one direction [m]
constexpr double kLever = 0.05;        // costs as much as a coefficient of friction of 1 [m]
constexpr double kUprightTilt = 0.3;   // cost of an approach along the support
constexpr double kSameHeight = 0.008;  // [m]
constexpr double kSpare = 0.002;  // to the least height of contacts, where the object is higher [m]

std::string slippery(double needed, double allowed) {
  char text[128];
  std::snprintf(
      text, sizeof text,
      "no two faces are opposite each other: a coefficient of friction of %.2f is needed, "
      "at most %.2f is allowed",
      needed, allowed);
  return text;
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
    return bearing(std::move(faces), result);
  }

 private:
  /// Faces at which the pads hold the object, or all if nobody knows how hard the hand presses.
  std::vector<Faces> bearing(std::vector<Faces> faces, Grasps& result) const {
    const Press press(problem_, options_, jaw_);
    if (!press.unknown().empty()) return faces;
    const Vector2d com = problem_.object.com().head<2>();
    for (Faces& pair : faces) {
      const Pads pads{problem_.hand.pad_friction, press.at(pair.width), options_.patch};
      const Vector2d closing = (pair.second - pair.first).normalized();
      const double across = std::abs(closing.dot(com - pair.middle())) - pair.width / 2;
      pair.offset = std::max(0.0, across);  // of a centre of mass that is not between the fingers
      pair.max_mass = largest_mass(pair, pads);
      pair.offset = 0;
    }
    const Faces best =
        *std::max_element(faces.begin(), faces.end(),
                          [](const Faces& a, const Faces& b) { return a.max_mass < b.max_mass; });
    const double mass = problem_.object.mass();
    keep(faces, [&](const Faces& pair) { return pair.max_mass >= mass; });
    if (!faces.empty()) return faces;
    return refuse(result, Status::too_heavy,
                  too_heavy("faces that are", best.lever, best, press.at(best.width), mass));
  }

  static std::vector<Faces> refuse(Grasps& result, Status status, const std::string& reason) {
    result.status = status;
    result.reason = reason;
    return {};
  }

  template <class Predicate>
  static void keep(std::vector<Faces>& faces, const Predicate& fits) {
    faces.erase(
        std::remove_if(faces.begin(), faces.end(), [&](const Faces& pair) { return !fits(pair); }),
        faces.end());
  }

  const Problem& problem_;
  const Options& options_;
  const Jaw& jaw_;
};

/// Rotation of the hand, in S: Z_H down and tilted about Y_H, Y_H along the closing direction or
/// against it.
Eigen::Matrix3d rotation(const Vector2d& closing_S, int roll, double tilt) {
  const Vector3d y = (roll == 0 ? 1 : -1) * Vector3d(closing_S.x(), closing_S.y(), 0);
  const Vector3d z = AngleAxisd(tilt, y) * Vector3d(-Vector3d::UnitZ());
  Eigen::Matrix3d R;
  R << y.cross(z), y, z;
  return R;
}

/// Heights of the contacts between two bounds: that of the faces, or the nearest to the best one,
/// and above.
std::vector<double> heights(const Faces& faces, double best, double least, double most) {
  if (faces.height) {
    return *faces.height < least ? std::vector<double>{} : std::vector<double>{*faces.height};
  }
  const double middle = std::clamp(best, least, most);
  std::vector<double> found{middle};
  for (const double height : {(middle + most) / 2, most}) {
    if (height > found.back() + kSameHeight) found.push_back(height);
  }
  return found;
}

/// Drops faces that lean too much where a pad touches them, by the test of check().
void drop_leaning(std::vector<Faces>& faces, const Problem& problem, const Options& options,
                  Grasps& result) {
  double least = std::numeric_limits<double>::infinity();
  const auto leans = [&](const Faces& pair) {
    const Vector2d closing = (pair.second - pair.first).normalized();
    const geometry::Polygon& outline = problem.object.outline();
    const auto first = steepest_around(outline, pair.first, -closing),
               second = steepest_around(outline, pair.second, closing);
    if (!first || !second) return true;
    const double slope = std::max(std::abs(*first), std::abs(*second));
    least = std::min(least, slope);
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

std::string in_mm(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f mm", 1000 * length);
  return text;
}

std::string too_heavy(const std::string& held_by, double away, const Faces& best, double press,
                      double mass) {
  char text[256];
  std::snprintf(text, sizeof text,
                "held by %s %.0f mm from the centre of mass, the pads bear %.2f kg at %.3g N a "
                "finger; it weighs %.2f kg",
                held_by.c_str(), 1000 * away, *best.max_mass, press, mass);
  return text;
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
  const Isometry3d& X_WS = problem.support.X_WS();
  const Isometry3d X_SO = X_WS.inverse() * problem.X_WO_start;
  const double thickness = problem.object.thickness(),
               above = has_walls ? options.patch : options.clearance, most = thickness - above,
               best = options.height.value_or(thickness / 2), spare = options.height ? 0 : kSpare;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Faces& pair : faces) {
    const std::optional<Grip> grip = jaw.at_width(pair.width);
    if (!grip) continue;
    const Vector2d closing_O(std::cos(pair.yaw), std::sin(pair.yaw));
    const Vector2d closing_S =
        (X_SO.linear() * Vector3d(closing_O.x(), closing_O.y(), 0)).head<2>().normalized();
    const Vector3d p_S = X_SO * Vector3d(pair.middle().x(), pair.middle().y(), 0);
    for (const double tilt : kTilts) {
      for (const int roll : {0, 1}) {
        const Eigen::Matrix3d R_SH = rotation(closing_S, roll, tilt);
        const Vector3d down_H = -R_SH.row(2).transpose();
        const double least =
            options.clearance + jaw.reach(*grip, down_H) - down_H.dot(grip->contact_H);
        lowest = std::min(lowest, least);
        if (least > most) continue;
        for (const double height : heights(pair, best, std::min(least + spare, most), most)) {
          Isometry3d X_SH = Isometry3d::Identity();
          X_SH.linear() = R_SH;
          X_SH.translation() = Vector3d(p_S.x(), p_S.y(), height) - R_SH * grip->contact_H;
          const double off = has_walls ? 0 : std::abs(height - best) / kLever;
          result.all.push_back({pair, height, tilt, X_WS * X_SH,
                                cost(pair) + kUprightTilt * std::abs(tilt) / (kPi / 2) + off});
        }
      }
    }
  }
  if (result.all.empty() && result.status == Status::solved) {
    result.status = Status::too_flat;
    result.reason = in_mm(thickness) + " high; the fingers touch its faces " + in_mm(lowest) +
                    " or more over the support, which takes a height of " + in_mm(lowest + above);
  }
  std::stable_sort(result.all.begin(), result.all.end(),
                   [](const Grasp& a, const Grasp& b) { return a.cost < b.cost; });
  return result;
}

}  // namespace graspless::pinch
