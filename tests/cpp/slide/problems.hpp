// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "graspless/geometry/point_cloud.hpp"
#include "graspless/scene/scene.hpp"
#include "graspless/slide/slide.hpp"

#include "geometry/polygons.hpp"
#include "robot/robots.hpp"

/// Problems of the paper: its tables in the WAM's base frame (the top in z = 0), its objects.
namespace graspless::slide {

using geometry::columns;

using robot::kr5, robot::wam;

inline geometry::Polygon disc(double radius, int n, const Eigen::Vector2d& center) {
  std::vector<Eigen::Vector2d> v;
  for (int i = 0; i < n; ++i) {
    v.push_back(center +
                radius * Eigen::Vector2d(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n)));
  }
  return geometry::Polygon(columns(v));
}

inline const std::vector<Support>& tables() {
  const Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();
  static const std::vector<Support> all{
      Support(geometry::Polygon(columns({{.3, -.35}, {1, -.35}, {1, .35}, {.3, .35}})), X_WS),
      Support(disc(.35, 100, {.65, 0}), X_WS),
      Support(geometry::Polygon(columns({{.30, -.45}, {.98, 0}, {.30, .45}})), X_WS),
      Support(geometry::Polygon(columns({{.35, -.6}, {.75, -.6}, {.75, .6}, {.35, .6}})), X_WS)};
  return all;
}

inline const std::vector<Object>& objects() {
  const auto triangle = columns({{0, .075}, {-.065, -.0375}, {.065, -.0375}});
  static const std::vector<Object> all{
      Object::from_polygon("square", geometry::square(.1), .005),
      Object::from_polygon("circle", disc(.055, 48, {0, 0}), .005),
      Object::from_polygon("triangle", geometry::Polygon(triangle), .005)};
  return all;
}

inline Eigen::Isometry3d flat(double x, double y, double yaw) {
  return Eigen::Translation3d(x, y, 0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

/// A pose, in S, of the object wholly on the table.
inline Eigen::Isometry3d random_pose(const Support& table, const Object& object,
                                     std::mt19937_64& rng) {
  std::uniform_real_distribution<double> yaw(0, 2 * M_PI);
  while (true) {
    const Eigen::Vector2d p = geometry::random_point(table.polygon(), rng);
    const Eigen::Isometry3d X_SO = flat(p.x(), p.y(), yaw(rng));
    bool on_table = true;
    for (const auto& v : object.outline().vertices().colwise()) {
      on_table =
          on_table && table.polygon().contains((X_SO * Eigen::Vector3d(v.x(), v.y(), 0)).head<2>());
    }
    if (on_table) return X_SO;
  }
}

inline Problem make_problem(const Support& table, const Object& object,
                            const Eigen::Isometry3d& X_SO) {
  return Problem{wam(), Hand{}, object, table, table.X_WS() * X_SO, {}, wam().state("home")};
}

inline Problem simple_problem() {
  return make_problem(tables()[0], objects()[0], flat(0.65, 0.1, 0.3));
}

inline planning::Budget seeded(std::uint64_t seed, double seconds = 20) {
  planning::Budget budget;
  budget.seed = seed;
  budget.seconds = seconds;
  return budget;
}

/// True if nothing of the robot touches at q and all links that its arm moves relative to each
/// other are more than `clearance` [m] apart.
inline bool are_links_apart(const robot::Robot& robot, const Eigen::VectorXd& q, double clearance) {
  scene::Scene scene(robot);
  scene.keep_links_apart(clearance, robot.group("arm"), {});
  return scene.is_free(q);
}

/// Bends the wrist of the WAM at home until the base of the hand is `apart` [m] from the forearm.
inline Eigen::VectorXd bent_home(double apart) {
  Eigen::VectorXd q = wam().state("home");
  const std::vector<int> arm = wam().group("arm");
  q[arm[4]] = -1.536;
  q[arm[5]] = 1.5;
  q[arm[6]] = 0.84;
  while (are_links_apart(wam(), q, apart)) q[arm[5]] += 1e-4;
  return q;
}

}  // namespace graspless::slide
