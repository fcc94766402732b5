// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Load that forces a hand open. Lengths in the linear programs are mm, so that coefficients are of
// one size.
#include "clasp/stability/load.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "graspless/watch.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using mechanics::Vector6d;

constexpr double kSpacing = 0.0015;  // of points on a triangle [m]
constexpr double kCellSize = 0.002;  // of space, for each of which one point is kept [m]
constexpr double kAtRest = 0.02;     // steps that are shorter end a motion [mm]
constexpr int kMoves = 6;
constexpr int kFlight = 2;            // moves with the same near points while nothing is met
constexpr int kFlights = 12;          // 48 mm along each axis: more play than a closed hand has
constexpr double kLeastTurn = 0.002;  // by which each joint may give way in a step [rad]
constexpr double kLeastSlide = 0.1;   // [mm]
constexpr std::size_t kUsualPoints = 1 << 14;

/// Number of a body, and of a cell of space in each direction.
using Cell = std::array<int, 4>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const int number : cell)
      hash = (hash ^ static_cast<std::uint32_t>(number)) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

}  // namespace

/// What is known of the points near the hand, and of them before the object moves.
struct LoadTester::Measured {
  Measured(NearPoints near, const std::vector<Body>& bodies, const Posture& hand)
      : points(std::move(near)), first(points, Eigen::Isometry3d::Identity(), bodies, hand) {}

  NearPoints points;
  PosedContacts first;
};

Eigen::Isometry3d motion_of(const Vector6d& move, const Vector3d& center_W) {
  const Vector3d turn = move.tail<3>() / kArm;
  const double angle = turn.norm();
  const Vector3d axis = angle > 0 ? Vector3d(turn / angle) : Vector3d::UnitX();
  return Eigen::Translation3d(center_W + move.head<3>() / kMetre) * Eigen::AngleAxisd(angle, axis) *
         Eigen::Translation3d(-center_W);
}

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
  std::vector<double> directions;
  for (const int joint : robot.group(problem.hand.hand)) {
    if (!std::isfinite(robot.max_effort()[joint])) continue;
    for (const double direction : {1.0, -1.0}) {
      if (direction * (closed[joint] - open[joint]) > 0) continue;
      joints_.push_back(joint);
      directions.push_back(direction);
    }
  }
  const auto count = static_cast<Eigen::Index>(joints_.size());
  directions_ = Eigen::Map<const VectorXd>(directions.data(), count);
  limits_.resize(count);
  units_.resize(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const int joint = joints_[j];
    const bool slides = robot.step_weights()[joint] > 1;
    units_[j] = slides ? 1 : kMetre;
    limits_[j] = robot.max_effort()[joint] * units_[j];
    give_ = std::min(give_, limits_[j] * (slides ? kLeastSlide : kLeastTurn));
  }
  for (const robot::LinkShape& shape : robot.shapes()) bodies_.push_back(body_of(shape));
}

Posture LoadTester::posture(const VectorXd& q, const Vector3d& center_W) const {
  Posture hand;
  hand.center_W = center_W;
  problem_.robot.forward(q, hand.X_WL);
  for (const Eigen::Isometry3d& X : hand.X_WL) hand.X_LW.push_back(X.inverse());
  hand.twists.assign(hand.X_WL.size(), mechanics::Matrix6Xd(6, directions_.size()));
  VectorXd ways = directions_;  // 0 where a joint is at its stop
  for (Eigen::Index j = 0; j < ways.size(); ++j) {
    const int joint = joints_[j];
    const double stop = (ways[j] > 0 ? problem_.robot.upper() : problem_.robot.lower())[joint];
    if (ways[j] * (stop - q[joint]) <= 0) ways[j] = 0;
  }
  mechanics::Matrix6Xd J;
  for (std::size_t link = 0; link < hand.X_WL.size(); ++link) {
    problem_.robot.jacobian(static_cast<int>(link), hand.X_WL, J);
    for (Eigen::Index j = 0; j < directions_.size(); ++j) {
      const Vector6d velocity = ways[j] * units_[j] * J.col(joints_[j]);
      const Vector3d spin = velocity.tail<3>();
      hand.twists[link].col(j) << velocity.head<3>() - spin.cross(hand.X_WL[link].translation()),
          spin;
    }
  }
  return hand;
}

/// Points of the object's surface near bodies of the hand.
NearPoints LoadTester::near_points(const Posture& hand, double reach,
                                   const Eigen::Isometry3d& X_WO) const {
  const geometry::Mesh& surface = problem_.object.surface();
  const Eigen::Matrix3Xd p_W = X_WO * surface.vertices;
  const auto in_link = [&](const Vector3d& p, const Body& body) -> Vector3d {
    return hand.X_LW[body.link] * p;
  };
  struct Nearest {
    Vector3d p_W;
    double distance;
  };
  std::unordered_map<Cell, Nearest, CellHash> nearest;
  nearest.reserve(kUsualPoints);
  const auto add = [&](const Vector3d& p, std::size_t i, double at_least) {
    if (at_least > kReach) return;
    const Eigen::Vector3i cell = (p / kCellSize).array().floor().cast<int>();
    const Cell key{static_cast<int>(i), cell.x(), cell.y(), cell.z()};
    const auto former = nearest.find(key);
    if (former != nearest.end() && at_least >= former->second.distance) return;
    const double distance = bodies_[i].distance(in_link(p, bodies_[i]), kReach);
    if (distance > kReach) return;
    if (former == nearest.end()) {
      nearest.emplace(key, Nearest{p, distance});
    } else if (distance < former->second.distance) {
      former->second = {p, distance};
    }
  };
  std::vector<std::pair<std::size_t, double>> near;  // bodies of a triangle, with their distances
  for (Eigen::Index i = 0; i < surface.triangles.cols(); ++i) {
    poll();
    const Facet facet(p_W(Eigen::all, surface.triangles.col(i)));
    if ((facet.center - hand.center_W).norm() > reach + facet.size) continue;
    near.clear();
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const Vector3d center_L = in_link(facet.center, bodies_[k]);
      if (bodies_[k].at_least(center_L) > kReach + facet.size) continue;
      const double distance = bodies_[k].distance(center_L, kReach + facet.size);
      if (distance <= kReach + facet.size) near.emplace_back(k, distance);
    }
    if (near.empty()) continue;
    visit_points(facet.corners, kSpacing, [&](const Vector3d& p) {
      if ((p - hand.center_W).norm() > reach) return;
      for (const auto& [body, distance] : near) add(p, body, distance - (p - facet.center).norm());
    });
  }
  std::vector<std::pair<Cell, Nearest>> sorted(nearest.begin(), nearest.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  Eigen::Matrix3Xd points_W(3, static_cast<Eigen::Index>(sorted.size()));
  Eigen::ArrayXd distances(points_W.cols());
  std::vector<NearPoints::Range> ranges;
  Eigen::Index count = 0;
  for (const auto& [key, point] : sorted) {
    const auto body = static_cast<std::size_t>(key.front());
    if (ranges.empty() || ranges.back().body != body) ranges.push_back({body, count, 0});
    ++ranges.back().size;
    points_W.col(count) = point.p_W;
    distances[count++] = point.distance;
  }
  return {std::move(points_W), ranges, distances};
}

/// Steps of an object, whose mean is at mean_W before it moves.
LoadTester::Pressed LoadTester::press(const Vector6d& load, Measured& known, const Posture& hand,
                                      const Vector3d& mean_W, int moves) const {
  LoadStepper stepper(limits_, give_);
  Pressed pressed;
  Eigen::Isometry3d& moved = pressed.moved;
  for (int i = 0; i < moves && !pressed.is_at_rest; ++i) {
    poll();
    Vector6d wrench = load;  // about the hand's centre
    wrench.tail<3>() += (moved * mean_W - hand.center_W).cross(load.head<3>());
    wrench.tail<3>() *= kMetre / kArm;
    LoadStep next;
    if (i == 0) {
      next = stepper.step(wrench, known.first);
    } else {
      PosedContacts contacts(known.points, moved, bodies_, hand);
      next = stepper.step(wrench, contacts);
    }
    if (next.effort > pressed.most.effort)
      pressed.most = {next.effort, next.yields < 0 ? -1 : joints_[next.yields]};
    moved = motion_of(next.move, hand.center_W) * moved;
    pressed.is_free = pressed.is_free && next.is_free;
    pressed.is_at_rest = next.move.lpNorm<Eigen::Infinity>() < kAtRest;
  }
  return pressed;
}

/// Where nothing stops the object, it flies on until it meets the hand.
LoadEffort LoadTester::effort_of(const Vector6d& load, Measured& known, const Posture& hand,
                                 double reach) const {
  Eigen::Isometry3d X_WO = problem_.X_WO;
  Pressed pressed = press(load, known, hand, X_WO * mean_O_, kMoves);
  for (int i = 0; i < kFlights && pressed.is_free && !pressed.is_at_rest; ++i) {
    X_WO = pressed.moved * X_WO;
    Measured here(near_points(hand, reach + kReach, X_WO), bodies_, hand);
    if (here.points.places.empty()) break;  // it has left the hand
    pressed = press(load, here, hand, X_WO * mean_O_, kFlight);
    if (!pressed.is_free) return press(load, here, hand, X_WO * mean_O_, kMoves).most;
  }
  return pressed.most;
}

LoadEffort LoadTester::effort(const VectorXd& q, const Vector3d& center_W, double reach,
                              double force, double torque, double enough, Crew* crew) const {
  if (force == 0 && torque == 0) return {};
  const Posture hand = posture(q, center_W);
  const NearPoints near = near_points(hand, reach + kReach, problem_.X_WO);
  const auto palm = static_cast<std::size_t>(problem_.robot.frame(problem_.hand.frame));
  const auto loads = loads_W(hand.X_WL[palm].linear(), force, torque);
  Spares<Measured> measured([&] { return std::make_unique<Measured>(near, bodies_, hand); });
  std::vector<LoadEffort> found(loads.cols());
  std::atomic<std::size_t> last{found.size()};  // a load that asks for more than enough
  const auto test = [&](std::size_t i) {
    if (i > last) return;
    found[i] =
        measured.lend([&](Measured& known) { return effort_of(loads.col(i), known, hand, reach); });
    found[i].effort *= kSudden;
    if (!(found[i].effort > enough)) return;
    for (std::size_t before = last; i < before && !last.compare_exchange_weak(before, i);) {
    }
  };
  if (crew != nullptr) {
    crew->share(found.size(), test);
  } else {
    for (std::size_t i = 0; i < found.size(); ++i) test(i);
  }
  LoadEffort most;
  for (std::size_t i = 0; i < found.size() && most.effort <= enough; ++i) {
    if (found[i].effort > most.effort) most = found[i];
  }
  return most;
}

std::optional<int> missing_effort(const Problem& problem, const StabilityOptions& options) {
  if (problem.hand.fingers.size() != 1 || (options.force == 0 && options.torque == 0)) return {};
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    if (!std::isfinite(problem.robot.max_effort()[joint])) return joint;
  }
  return {};
}

void require_efforts(const Problem& problem, const StabilityOptions& options) {
  const std::optional<int> joint = missing_effort(problem, options);
  if (!joint) return;
  throw std::invalid_argument(
      "robot: joint '" + problem.robot.joint_names()[*joint] +
      "' of the hand has no effort limit above 0 in the URDF, so the force of its fingers is "
      "unknown; give it one, or set options.stability.force and options.stability.torque to 0");
}

}  // namespace graspless::clasp
