// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "pinch/grasps.hpp"
#include "pinch/press.hpp"
#include "pinch/wall_measure.hpp"
#include "pinch/walls.hpp"

namespace graspless::pinch {
namespace {

constexpr double kLevelStep = 0.004;  // between heights of contacts that are tried [m]
constexpr double kAside = 0.35;       // of the width of a finger: it is round
constexpr int kLevels = 10;

/// Least height of the contacts of a hand that comes from straight above [m].
double lowest_contact(const Options& options, const Jaw& jaw) {
  const std::optional<Grip> grip = jaw.at_width(jaw.opening() / 2);
  const Grip& at = grip ? *grip : jaw.open();
  return options.clearance + extent(jaw.fingers({at}), Eigen::Vector3d::UnitZ()) - at.contact_H.z();
}

/// Heights of contacts, from the top down to `least`.
std::vector<double> levels(const Problem& problem, const Options& options, double least) {
  std::vector<double> found;
  double height = problem.object.thickness() - options.patch;
  for (int k = 0; k < kLevels && height >= least; ++k, height -= kLevelStep)
    found.push_back(height);
  return found;
}

/// Space that the fingers take beside a wall, if the hand comes from straight above and closes.
class Room {
 public:
  Room(const geometry::HeightMap& map, const Jaw& jaw)
      : map_(map), jaw_(jaw), fingers_(jaw.open_fingers()) {}

  /// By how much the object is too high where a finger goes [m]; may be negative.
  double missing(const Faces& wall) const {
    const std::optional<Grip> grip = jaw_.at_width(wall.width);
    if (!grip) return std::numeric_limits<double>::infinity();
    const Eigen::Vector2d across(std::cos(wall.yaw), std::sin(wall.yaw)),
        along(-across.y(), across.x());
    double highest = -std::numeric_limits<double>::infinity();
    for (const Eigen::AlignedBox3d& finger : fingers_) {
      const double side = finger.center().y() > grip->contact_H.y() ? 1 : -1,
                   reach = finger.max().z() - grip->contact_H.z(), thick = finger.sizes().y(),
                   farthest = std::max(finger.max().y(), -finger.min().y());
      for (double y = wall.width / 2 + map_.cell; y <= farthest; y += map_.cell) {
        const double round = std::min(1.0, (y - wall.width / 2) / (thick / 2));  // of the fingertip
        for (const double x : {-kAside, 0.0, kAside}) {
          const double height =
              map_.at(wall.middle() + side * y * across + x * finger.sizes().x() * along);
          highest = std::max(highest, height + round * reach - *wall.height);
        }
      }
    }
    return highest;
  }
  double from() const { return jaw_.opening() / 2; }
  double to() const { return std::max(fingers_[0].max().y(), fingers_[1].max().y()); }
  double depth(const Faces& wall) const {
    return fingers_[0].max().z() - jaw_.at_width(wall.width)->contact_H.z();
  }

 private:
  const geometry::HeightMap& map_;
  const Jaw& jaw_;
  std::array<Eigen::AlignedBox3d, 2> fingers_;
};

template <class Number>
const Faces& least_of(const std::vector<Faces>& faces, const Number& number) {
  return *std::min_element(faces.begin(), faces.end(),
                           [&](const Faces& a, const Faces& b) { return number(a) < number(b); });
}

/// Walls that fit between the fingers, with faces that are opposite each other.
std::vector<Faces> thin_walls(std::vector<Faces> faces, const Options& options, const Jaw& jaw,
                              Grasps& result) {
  const auto friction = [](const Faces& wall) { return wall.friction; };
  const double slope = friction(least_of(faces, friction));
  keep(faces, [&](const Faces& wall) { return wall.friction <= options.friction; });
  if (faces.empty()) {
    return refuse(result, Status::too_slippery,
                  text_of("the walls lean or bend: a coefficient of friction of %.2f is "
                          "needed, at most %.2f is allowed",
                          slope, options.friction));
  }
  const auto width = [](const Faces& wall) { return wall.width; };
  const double thinnest = width(least_of(faces, width));
  const double opening = jaw.opening() - 2 * options.margin;
  keep(faces,
       [&](const Faces& wall) { return wall.width <= opening && wall.width > jaw.least_gap(); });
  if (faces.empty()) {
    const std::string wall = "the wall is " + in_mm(thinnest) + " thick where it is thinnest, ";
    return refuse(result, Status::too_wide,
                  thinnest > opening
                      ? wall + "the hand opens " + in_mm(jaw.opening()) + " and needs " +
                            in_mm(options.margin) + " on each side"
                      : wall + "the closed fingers stay " + in_mm(jaw.least_gap()) + " apart");
  }
  return faces;
}

/// Walls at which the pads hold the object, with the part of its load that they bear.
std::vector<Faces> bearing_walls(std::vector<Faces> faces, const Problem& problem,
                                 const Options& options, const Jaw& jaw, Grasps& result) {
  const Press press(problem, options, jaw);
  if (!press.unknown().empty()) {
    return refuse(result, Status::unknown_force,
                  "what the pads bear is unknown: the URDF has no effort limit for joint '" +
                      press.unknown() +
                      "', which closes the hand, and options.grip_force "
                      "is not given");
  }
  for (Faces& wall : faces) {
    const Pads pads{problem.hand.pad_friction, press.at(wall.width), options.patch};
    wall.max_mass = largest_mass(weighed(wall, problem, *wall.height), pads);
    wall.load = problem.object.mass() / *wall.max_mass;
  }
  const Faces best = least_of(faces, [](const Faces& wall) { return wall.load; });
  keep(faces, [](const Faces& wall) { return wall.load <= 1; });
  if (!faces.empty()) return faces;
  const double away = 1000 * std::hypot(best.lever, best.offset);
  if (std::isinf(best.load)) {
    return refuse(
        result, Status::too_heavy,
        text_of("no wall that fits the hand is upright and was seen on both sides down to %.0f mm "
                "below the contacts, which is needed to hold it %.0f mm from its centre of mass: a "
                "view from another side may help",
                1000 * options.patch, away));
  }
  return refuse(result, Status::too_heavy,
                too_heavy("a wall that is", std::hypot(best.lever, best.offset), best,
                          press.at(best.width), problem.object.mass()));
}

}  // namespace

std::vector<Faces> measured_walls(std::vector<Faces> faces, const Problem& problem,
                                  const Options& options, const Jaw& jaw, Grasps& result) {
  const auto is_off = [&](Faces& wall) {
    Eigen::Matrix<double, 3, 2> contacts_O;
    contacts_O.topRows<2>() << wall.first, wall.second;
    contacts_O.row(2).setConstant(*wall.height);
    const WallMeasure measure = measure_wall(*problem.object.heights(), contacts_O, options.patch);
    wall.friction = std::max(measure.friction[0], measure.friction[1]);
    wall.rise = measure.rise;
    const double cell = problem.object.heights()->cell;
    return !measure.is_wall || !fits(measure, 0, cell) || !fits(measure, 1, cell);
  };
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_off), faces.end());
  if (faces.empty()) {
    return refuse(result, Status::too_flat,
                  "the walls are ragged: none rises " + in_mm(options.patch) +
                      " above its contacts, and keeps its faces, all along the pads");
  }
  faces = thin_walls(std::move(faces), options, jaw, result);
  return faces.empty() ? faces : bearing_walls(std::move(faces), problem, options, jaw, result);
}

std::vector<Faces> select_walls(const Problem& problem, const Options& options, const Jaw& jaw,
                                Grasps& result) {
  const double length = std::max(jaw.open().pad, 2 * options.patch),
               least = lowest_contact(options, jaw);
  std::vector<Faces> faces = walls(*problem.object.heights(), problem.object.com(), length,
                                   levels(problem, options, least), options.patch);
  if (faces.empty()) {
    return refuse(result, Status::too_flat,
                  in_mm(problem.object.thickness()) + " high; no wall of " + in_mm(length) +
                      " length rises " + in_mm(options.patch) + " above contacts that are " +
                      in_mm(least) + " or more over the support");
  }
  faces = thin_walls(std::move(faces), options, jaw, result);
  if (!faces.empty()) faces = bearing_walls(std::move(faces), problem, options, jaw, result);
  if (faces.empty()) return faces;
  const Room room(*problem.object.heights(), jaw);
  const Faces widest = least_of(faces, [&](const Faces& wall) { return room.missing(wall); });
  keep(faces, [&](const Faces& wall) { return room.missing(wall) <= 0; });
  if (!faces.empty()) return faces;
  return refuse(
      result, Status::no_room,
      text_of("the open fingers go %.0f to %.0f mm beside the middle of a wall and %.0f mm below "
              "its contacts: the object is %.0f mm too high there",
              1000 * room.from(), 1000 * room.to(), 1000 * room.depth(widest),
              1000 * room.missing(widest)));
}

}  // namespace graspless::pinch
