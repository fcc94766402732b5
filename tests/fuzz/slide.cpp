// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/slide.hpp"

#include <cmath>
#include <memory>

#include "cpp/paths.hpp"
#include "fuzz/plan.hpp"
#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

using namespace slide;

/// A regular polygon with corners at random distances.
geometry::Polygon around(Bytes& bytes, double radius) {
  const int corners = bytes.whole(3, 10);
  Eigen::Matrix2Xd vertices(2, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    vertices.col(i) =
        bytes.number(0.5 * radius, radius) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return geometry::Polygon(vertices);
}

Object object(Bytes& bytes) {
  const geometry::Polygon outline = around(bytes, bytes.number(0.02, 0.1));
  const double thickness = bytes.number(0.001, 0.01);
  Object object = Object::from_polygon("card", outline, thickness, bytes.number(0.005, 0.03));
  if (bytes.chance(4)) object = object.with_com(bytes.vector(-0.02, 0.02));
  if (bytes.chance(4)) object = object.with_mass(bytes.number(0.01, 1));
  return object;
}

Support support(Bytes& bytes) {
  Eigen::Isometry3d X_WS(Eigen::Translation3d(0.65, bytes.number(-0.1, 0.1), 0));
  if (bytes.chance(4))
    X_WS.rotate(Eigen::AngleAxisd(bytes.number(0, 0.5), Eigen::Vector3d::UnitY()));
  const geometry::Polygon polygon = around(bytes, 0.5);
  return Support(polygon, X_WS, bytes.number(0.01, 0.06), bytes.number(0.03, 0.1),
                 bytes.number(0, 1));
}

Options search_options(Bytes& bytes) {
  Options options;
  options.search = bytes.chance(2) ? Search::paper : Search::fast;
  if (bytes.chance(2)) return options;
  options.pitch = bytes.number(0.6, 1);
  options.pitch_tolerance = bytes.number(0.05, 0.2);
  options.min_depth = bytes.number(0.001, 0.01);
  options.max_depth = bytes.number(0.01, 0.03);
  options.root_scale = bytes.number(1, 200);
  options.min_overhang = bytes.number(0, 0.04);
  options.lift_height = bytes.number(0.02, 0.1);
  options.range = bytes.number(0.05, 0.5);
  options.resolution = bytes.number(0.005, 0.01);
  return options;
}

collision::Obstacle obstacle(Bytes& bytes) {
  collision::Obstacle box;
  box.name = "box";
  box.shapes.push_back({geometry::Box{bytes.vector(0.02, 0.2)}, Eigen::Isometry3d::Identity()});
  box.X_WB.translation() = bytes.vector(-1, 1);
  return box;
}

}  // namespace

void plan_slide(Bytes bytes) {
  static const auto wam = robot::Robot::from_urdf_file(urdf_file("wam_t42.urdf"));
  accepts([&] {
    const Options options = search_options(bytes);
    const planning::Budget budget = small_budget(bytes, 300);
    const Support table = support(bytes);
    Problem problem{wam, Hand{}, object(bytes), table, table.X_WS(), {}, wam.state("home")};
    problem.X_WO_start.translate(
        Eigen::Vector3d(bytes.number(-0.3, 0.3), bytes.number(-0.3, 0.3), 0));
    problem.X_WO_start.rotate(Eigen::AngleAxisd(bytes.number(-3, 3), Eigen::Vector3d::UnitZ()));
    if (bytes.chance(4)) problem.obstacles.push_back(obstacle(bytes));
    if (bytes.chance(4)) problem.q_home[bytes.whole(0, wam.dof() - 1)] += bytes.number(-1, 1);
    if (bytes.chance(4)) {
      const auto models = choices(FingerModel{});
      problem.hand.finger_model = models[static_cast<std::size_t>(bytes.whole(0, 3))].value;
      problem.hand.wrist_stiffness = bytes.number(0, 2000);
    }
    if (bytes.chance(4)) problem.hand.flexure_length = bytes.number(0.05, 0.2);
    require_plan(problem, options, budget);
  });
}

}  // namespace graspless::fuzz
