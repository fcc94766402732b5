// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/fingertip/fingertip.hpp"

#include <cmath>
#include <limits>

#include "fuzz/plan.hpp"
#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

using namespace fingertip;

/// A box, or a tetrahedron on the floor. `height`: of O over the floor.
Object object(Bytes& bytes, double* height) {
  const double mass = bytes.number(0.1, 2);
  const Eigen::Vector3d size = bytes.vector(0.02, 0.1);
  if (!bytes.chance(4)) {
    *height = size.z() / 2;
    return Object::box("box", size, mass);
  }
  geometry::Mesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << 0, size.x(), 0, bytes.number(-0.05, 0.1),  //
      0, 0, size.y(), bytes.number(-0.05, 0.1),               //
      0, 0, 0, size.z();
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 0, 1,  //
      2, 1, 3, 2,                //
      1, 3, 2, 3;
  *height = 0;
  return Object::from_mesh("tetrahedron", mesh, mass);
}

Motion path(Bytes& bytes, const Eigen::Isometry3d& X_WO, const Eigen::Vector3d& edge) {
  const int segments = bytes.whole(1, 5);
  const int kind = bytes.whole(0, 2);
  if (kind == 0) {
    const double x = bytes.number(0, 0.1), y = bytes.number(0, 0.1);
    return slide_path(X_WO, {x, y, 0}, segments);
  }
  const bool tumble = kind == 1;
  const Eigen::Vector3d axis = tumble ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  return turn_path(X_WO, edge, axis, bytes.number(0, M_PI / 2), segments);
}

Motion lattice(Bytes& bytes, const Eigen::Isometry3d& X_WO) {
  Lattice lattice;
  lattice.X_WO_start = lattice.X_WO_goal = X_WO;
  for (int i = 0; i < 3; ++i) {
    const int count = bytes.whole(1, 4);
    const double step = bytes.number(0.01, 0.3);
    lattice.counts[static_cast<std::size_t>(i)] = count;
    lattice.upper[i] = step * (count - 1);
    const double moved = step * bytes.whole(0, 3);
    if (i < 2) lattice.X_WO_goal.translation()[i] += moved;
    if (i == 2) lattice.X_WO_goal.rotate(Eigen::AngleAxisd(moved, Eigen::Vector3d::UnitZ()));
  }
  return lattice;
}

Motion goal(Bytes& bytes, const Eigen::Isometry3d& X_WO, const Eigen::Vector3d& edge) {
  Goal goal;
  goal.X_WO_start = goal.X_WO_goal = X_WO;
  if (bytes.chance(2)) {
    goal.X_WO_goal = Eigen::Translation3d(edge) *
                     Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()) *
                     Eigen::Translation3d(-edge) * X_WO;
  }
  const double x = bytes.number(-0.1, 0.1), y = bytes.number(-0.1, 0.1);
  goal.X_WO_goal.pretranslate(Eigen::Vector3d(x, y, 0));
  goal.slide_step = bytes.number(0.01, 0.1);
  goal.turn_step = bytes.number(0.1, 1);
  goal.max_tumbles = bytes.whole(0, 3);
  return goal;
}

Motion motion(Bytes& bytes, const Eigen::Isometry3d& X_WO, const Eigen::Vector3d& edge) {
  const int kind = bytes.whole(0, 3);
  if (kind == 0) return lattice(bytes, X_WO);
  if (kind == 1) return goal(bytes, X_WO, edge);
  return path(bytes, X_WO, edge);
}

Fingers fingers(Bytes& bytes) {
  Fingers fingers;
  fingers.count = bytes.whole(1, 3);
  fingers.radius = bytes.number(0.002, 0.01);
  fingers.max_normal_force = bytes.number(1, 20);
  const double friction = bytes.number(0.1, 1);
  fingers.friction = {friction, friction};
  if (bytes.chance(4)) fingers.friction.upper = bytes.number(0.1, 1.2);
  if (bytes.chance(4)) fingers.max_span = bytes.number(0.02, 0.2);
  return fingers;
}

Options search_options(Bytes& bytes) {
  Options options;
  options.search = static_cast<Search>(bytes.whole(0, 2));
  options.locations_per_side = bytes.whole(1, 4);
  if (bytes.chance(4)) options.location_spacing = bytes.number(0.01, 0.05);
  options.samples_per_arc = bytes.whole(1, 3);
  options.cone_edges = bytes.whole(3, 8);
  options.min_stability = bytes.number(0.01, 1);
  options.regrasp_cost = bytes.number(0.1, 100);
  options.stability_weight = bytes.number(0, 0.1);
  options.max_regrasps = bytes.whole(0, 3);
  options.threads = bytes.whole(1, 2);
  options.explain = bytes.chance(8);
  return options;
}

std::vector<Plane> planes(Bytes& bytes) {
  std::vector<Plane> planes{Plane{}};
  if (bytes.chance(4)) {
    planes.push_back({"wall", Eigen::Vector3d::UnitX(), -bytes.number(0.01, 0.1)});
  }
  return planes;
}

}  // namespace

void plan_fingertip(Bytes bytes) {
  accepts([&] {
    const Options options = search_options(bytes);
    const planning::Budget budget = small_budget(bytes, 3000);
    double height = 0;
    Object moved = object(bytes, &height);
    const Eigen::Isometry3d X_WO(Eigen::Translation3d(0, 0, height));
    const Eigen::Vector3d edge(moved.hull().row(0).maxCoeff(), 0, 0);
    Problem problem{moved, fingers(bytes), planes(bytes), {}, motion(bytes, X_WO, edge), {}};
    problem.friction.lower = problem.friction.upper = bytes.number(0.1, 1);
    if (bytes.chance(4)) problem.friction.upper = bytes.number(0.1, 1.2);
    if (bytes.chance(4)) problem.gravity_W = bytes.vector(-10, 10);
    require_plan(problem, options, budget);
  });
}

}  // namespace graspless::fuzz
