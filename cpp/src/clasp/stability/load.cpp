// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Load that forces a hand open. Lengths in the linear programs are mm, so that coefficients are of
// one size.
#include "clasp/stability/load.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "graspless/watch.hpp"

#include "clasp/free_space/link_spheres.hpp"
#include "mechanics/lp/program.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using mechanics::kInfinity;
using mechanics::Vector6d;

constexpr double kMetre = 1000;      // [mm]
constexpr double kSpacing = 0.0015;  // of points on a triangle [m]
constexpr double kCellSize = 0.002;  // of space, for each of which one point is kept [m]
constexpr double kReach = 0.025;     // a point farther from a shape never meets it [m]
constexpr double kRound = 0.0005;    // radius by which edges of links are rounded [m]
constexpr double kMove = 2;          // largest step in a coordinate [mm]
constexpr double kArm = 20;          // length that makes lengths of angles [mm]
constexpr double kAtRest = 0.02;     // steps that are shorter end a motion [mm]
constexpr int kMoves = 10;
constexpr double kGive = 2;  // work by which the hand may yield, which makes efforts unique [N mm]

/// A small motion of the object, and what it asks of the hand.
struct Step {
  Vector6d move = Vector6d::Zero();  // [mm]
  double effort = 0;
};

/// Dual program of a step: contact forces, forces of the bounds on a step, and the effort.
mechanics::LinearProgram program(const Vector6d& load,
                                 const std::vector<LoadTester::Contact>& contacts,
                                 const VectorXd& limits) {
  mechanics::LinearProgram lp;
  for (int k = 0; k < 6; ++k) lp.add_row(load[k], load[k]);
  for (Eigen::Index j = 0; j < limits.size(); ++j) lp.add_row(-kInfinity, 0);
  const int effort = lp.add_variable(0, kInfinity, -kGive);
  for (int j = 0; j < limits.size(); ++j) lp.set(6 + j, effort, -limits[j]);
  for (int k = 0; k < 6; ++k) {
    for (const double sign : {1.0, -1.0}) lp.set(k, lp.add_variable(0, kInfinity, -kMove), sign);
  }
  for (const LoadTester::Contact& contact : contacts) {
    const int column = lp.add_variable(0, kInfinity, -contact.gap);
    lp.set_block(0, column, contact.row);
    lp.set_block(6, column, contact.opens);
  }
  return lp;
}

Step step(const Vector6d& load, const std::vector<LoadTester::Contact>& contacts,
          const VectorXd& limits) {
  const mechanics::LpSolution found = mechanics::solve_lp(program(load, contacts, limits));
  if (found.status != mechanics::LpStatus::optimal) return {};
  return {-found.duals.head<6>(), found.x[0]};
}

/// Motion of a body whose step is given in mm, about a point.
Eigen::Isometry3d motion(const Vector6d& move, const Vector3d& center_W) {
  const Vector3d turn = move.tail<3>() / kArm;
  const double angle = turn.norm();
  const Vector3d axis = angle > 0 ? Vector3d(turn / angle) : Vector3d::UnitX();
  return Eigen::Translation3d(center_W + move.head<3>() / kMetre) * Eigen::AngleAxisd(angle, axis) *
         Eigen::Translation3d(-center_W);
}

/// A link's shape with a ball around it.
LoadTester::Body body_of(const robot::LinkShape& shape) {
  LoadTester::Body body{shape.link, distance_to(shape.placed), Vector3d::Zero(), 0};
  const std::vector<Sphere> spheres = covered(shape.placed, MeshInside::hull).spheres;
  for (const Sphere& sphere : spheres)
    body.center_L += sphere.center / static_cast<double>(spheres.size());
  for (const Sphere& sphere : spheres)
    body.radius = std::max(body.radius, (sphere.center - body.center_L).norm() + sphere.radius);
  return body;
}

}  // namespace

mechanics::Matrix6Xd loads_W(const Eigen::Matrix3d& R_WH, double force, double torque) {
  mechanics::Matrix6Xd loads(6, 36);
  for (int i = 0; i < 36; ++i) {
    const auto axis = [&](int k) { return Vector3d((k < 3 ? 1 : -1) * R_WH.col(k % 3)); };
    loads.col(i) << force * axis(i % 6), torque * axis(i / 6);
  }
  return loads;
}

LoadTester::LoadTester(const Problem& problem)
    : problem_(problem), mean_O_(problem.object.points().rowwise().mean()) {
  const robot::Robot& robot = problem.robot;
  const VectorXd open = robot.state(problem.hand.open), closed = robot.state(problem.hand.closed);
  for (const int joint : robot.group(problem.hand.hand)) {
    if (open[joint] != closed[joint]) joints_.push_back(joint);
  }
  const auto count = static_cast<Eigen::Index>(joints_.size());
  directions_.resize(count);
  limits_.resize(count);
  units_.resize(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const int joint = joints_[static_cast<std::size_t>(j)];
    directions_[j] = open[joint] > closed[joint] ? 1 : -1;
    const bool slides = robot.step_weights()[joint] > 1;
    units_[j] = slides ? 1 : kMetre;
    limits_[j] = robot.max_effort()[joint] * units_[j];
  }
  for (const robot::LinkShape& shape : robot.shapes()) bodies_.push_back(body_of(shape));
}

std::vector<LoadTester::Pair> LoadTester::pairs(const robot::Poses& X_WL, const Vector3d& center_W,
                                                double reach) const {
  const geometry::Mesh& surface = problem_.object.surface();
  const Eigen::Matrix3Xd p_W = problem_.X_WO * surface.vertices;
  std::map<std::array<int, 4>, Pair> nearest;  // of each cell of space, for each body
  const auto add = [&](const Vector3d& p, std::size_t i) {
    const Body& body = bodies_[i];
    const Vector3d p_L = X_WL[static_cast<std::size_t>(body.link)].inverse() * p;
    if ((p_L - body.center_L).norm() > body.radius + kReach) return;
    const double distance = body.distance(p_L);
    if (distance > kReach) return;
    const Eigen::Vector3i cell = (p / kCellSize).array().floor().cast<int>();
    const std::array key{cell.x(), cell.y(), cell.z(), static_cast<int>(i)};
    const auto [entry, is_new] = nearest.try_emplace(key, Pair{p, i, distance, p});
    if (!is_new && distance < entry->second.distance) entry->second = {p, i, distance, p};
  };
  for (Eigen::Index i = 0; i < surface.triangles.cols(); ++i) {
    poll();
    visit_points(p_W(Eigen::all, surface.triangles.col(i)), kSpacing, [&](const Vector3d& p) {
      if ((p - center_W).norm() > reach) return;
      for (std::size_t body = 0; body < bodies_.size(); ++body) add(p, body);
    });
  }
  std::vector<Pair> found;
  for (const auto& [key, pair] : nearest) found.push_back(pair);
  return found;
}

LoadTester::Twists LoadTester::opening_twists(const robot::Poses& X_WL) const {
  Twists twists(X_WL.size(), mechanics::Matrix6Xd::Zero(6, directions_.size()));
  mechanics::Matrix6Xd J;
  for (std::size_t link = 0; link < X_WL.size(); ++link) {
    problem_.robot.jacobian(static_cast<int>(link), X_WL, J);
    for (Eigen::Index j = 0; j < directions_.size(); ++j) {
      const Vector6d velocity = directions_[j] * J.col(joints_[static_cast<std::size_t>(j)]);
      const Vector3d spin = velocity.tail<3>();
      twists[link].col(j) << velocity.head<3>() - spin.cross(X_WL[link].translation()), spin;
    }
  }
  return twists;
}

/// Contacts that a step of the object may close.
std::vector<LoadTester::Contact> LoadTester::contacts(std::vector<Pair>& pairs,
                                                      const Eigen::Isometry3d& moved,
                                                      const Vector3d& center_W,
                                                      const robot::Poses& X_WL,
                                                      const Twists& twists) const {
  std::vector<Contact> found;
  for (Pair& pair : pairs) {
    const Vector3d p = moved * pair.p_W, arm = p - center_W;
    const double window = kRound + kMove / kMetre * std::sqrt(3) * (1 + arm.norm() * kMetre / kArm);
    if (pair.distance - (p - pair.measured_W).norm() > window) continue;
    const Body& body = bodies_[pair.body];
    const auto link = static_cast<std::size_t>(body.link);
    const Vector3d p_L = X_WL[link].inverse() * p;
    pair.distance = body.distance(p_L);
    pair.measured_W = p;
    if (pair.distance > window) continue;
    const Vector3d n = X_WL[link].linear() * gradient(body.distance, p_L);
    Contact contact;
    contact.row << -n, -arm.cross(n) * kMetre / kArm;
    contact.opens = -(n.transpose() * twists[link].topRows<3>() +
                      p.cross(n).transpose() * twists[link].bottomRows<3>())
                         .transpose()
                         .cwiseProduct(units_);
    contact.gap = kMetre * std::max(0.0, pair.distance - kRound);
    found.push_back(contact);
  }
  return found;
}

double LoadTester::effort_of(const Vector6d& load, const Vector3d& center_W,
                             std::vector<Pair> pairs, const robot::Poses& X_WL,
                             const Twists& twists) const {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  double effort = 0;
  for (int i = 0; i < kMoves; ++i) {
    poll();
    const Vector3d mean_W = moved * (problem_.X_WO * mean_O_);
    Vector6d wrench = load;  // about the hand's centre
    wrench.tail<3>() += (mean_W - center_W).cross(load.head<3>());
    wrench.tail<3>() *= kMetre / kArm;
    const Step next = step(wrench, contacts(pairs, moved, center_W, X_WL, twists), limits_);
    effort = next.effort;
    moved = motion(next.move, center_W) * moved;
    if (next.move.lpNorm<Eigen::Infinity>() < kAtRest) break;
  }
  return effort;
}

double LoadTester::effort(const VectorXd& q, const Vector3d& center_W, double reach, double force,
                          double torque) const {
  if (force == 0 && torque == 0) return 0;
  robot::Poses X_WL;
  problem_.robot.forward(q, X_WL);
  const Twists twists = opening_twists(X_WL);
  const std::vector<Pair> near = pairs(X_WL, center_W, reach + kReach);
  const int palm = problem_.robot.frame(problem_.hand.frame);
  const auto loads = loads_W(X_WL[static_cast<std::size_t>(palm)].linear(), force, torque);
  double most = 0;
  for (Eigen::Index i = 0; i < loads.cols() && kSudden * most <= 1; ++i)
    most = std::max(most, effort_of(loads.col(i), center_W, near, X_WL, twists));
  return kSudden * most;
}

void require_efforts(const Problem& problem, const StabilityOptions& options) {
  if (problem.hand.fingers.size() != 1 || (options.force == 0 && options.torque == 0)) return;
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    if (std::isfinite(problem.robot.max_effort()[joint])) continue;
    throw std::invalid_argument(
        "robot: joint '" + problem.robot.joint_names()[static_cast<std::size_t>(joint)] +
        "' of the hand has no effort limit above 0 in the URDF, so the force of its fingers is "
        "unknown; give it one, or set options.stability.force and options.stability.torque to 0");
  }
}

}  // namespace graspless::clasp
