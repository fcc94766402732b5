// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Poses of an object that slides and turns on the floor, and what it meets between them.
#include "fingertip/lattice/space.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;
constexpr double kSameYaw = 1e-9;  // [rad]

/// Moves in the order of their steps along x, y and yaw, without standing still.
std::array<int, 3> steps_of(int move) {
  const int i = move < 13 ? move : move + 1;
  return {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
}

}  // namespace

LatticeSpace::LatticeSpace(Workshop& workshop, const Lattice& lattice)
    : workshop_(workshop),
      clearance_(workshop.problem),
      X_WO_start_(lattice.X_WO_start),
      num_locations_(ix(workshop.locations.size())) {
  set_axes(lattice);
  start_ = index_of(lattice.X_WO_start);
  goal_ = index_of(lattice.X_WO_goal);
  tabulate();
  const auto poses = ix(num_poses());
  floor_kinds_.assign(ix(num_yaws()) * kMoves, kUnknown);
  arc_kinds_.assign(poses * kMoves, kUnknown);
  free_.assign(poses, -1);
  clear_.assign(poses * num_locations_, -1);
  rest_.assign(poses, kUnknown);
}

void LatticeSpace::set_axes(const Lattice& lattice) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    counts_[i] = lattice.counts[i];
    lower_[i] = lattice.lower[axis];
    step_[i] = counts_[i] > 1 ? (lattice.upper[axis] - lower_[i]) / (counts_[i] - 1) : 0;
  }
  if (counts_[2] < 2) return;
  const int around = static_cast<int>(std::lround(kTurn / step_[2]));
  if (std::abs(around * step_[2] - kTurn) > kSameYaw || counts_[2] < around) return;
  counts_[2] = around;  // yaws a whole turn apart are the same
  wraps_ = true;
}

int LatticeSpace::index_of(const Eigen::Isometry3d& X_WO) const {
  const Eigen::Vector3d p = X_WO.translation() - X_WO_start_.translation();
  const Eigen::Matrix3d turn = X_WO.linear() * X_WO_start_.linear().transpose();
  const double yaw = std::atan2(turn(1, 0), turn(0, 0));
  std::array<double, 3> values{p.x(), p.y(), yaw};
  std::array<int, 3> index{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (counts_[i] == 1) continue;
    const auto at = [&](double value) {
      return static_cast<int>(std::lround((value - lower_[i]) / step_[i]));
    };
    index[i] = at(values[i]);
    // Of the yaws that are the same, the one on the lattice.
    for (int turns = -3; i == 2 && turns <= 3; ++turns) {
      const int other = at(yaw + turns * kTurn);
      if (other >= 0 && other < counts_[2]) index[2] = other;
    }
    if (index[i] < 0 || index[i] >= counts_[i]) {
      throw std::invalid_argument("motion: start and goal must lie on the lattice");
    }
  }
  return (index[0] * counts_[1] + index[1]) * counts_[2] + index[2];
}

Eigen::Isometry3d LatticeSpace::X_WO(int pose) const {
  const int k = pose % counts_[2], xy = pose / counts_[2];
  const Eigen::AngleAxisd turn(lower_[2] + k * step_[2], Eigen::Vector3d::UnitZ());
  Eigen::Isometry3d X = X_WO_start_;
  X.linear() = turn * X_WO_start_.linear();
  X.translation().x() += lower_[0] + xy / counts_[1] * step_[0];
  X.translation().y() += lower_[1] + xy % counts_[1] * step_[1];
  return X;
}

int LatticeSpace::find_next(int pose, int move) const {
  const std::array<int, 3> step = steps_of(move);
  const int k = pose % counts_[2], xy = pose / counts_[2];
  const int x = xy / counts_[1] + step[0], y = xy % counts_[1] + step[1];
  int yaw = k + step[2];
  if (x < 0 || x >= counts_[0] || y < 0 || y >= counts_[1]) return -1;
  if (wraps_) yaw = (yaw + counts_[2]) % counts_[2];
  // With one or two yaws all the way round, a turn would lead back or both ways to one.
  if (yaw < 0 || yaw >= counts_[2] || (wraps_ && counts_[2] < 3 && step[2] != 0)) return -1;
  return (x * counts_[1] + y) * counts_[2] + yaw;
}

void LatticeSpace::tabulate() {
  const Locations& locations = workshop_.locations;
  for (int pose = 0; pose < num_poses(); ++pose) {
    yaws_.push_back(pose % counts_[2]);
    origins_.push_back(X_WO(pose).translation());
    for (int move = 0; move < kMoves; ++move) next_.push_back(find_next(pose, move));
  }
  for (int k = 0; k < num_yaws(); ++k) {
    const Eigen::Isometry3d X_WO_k = X_WO(k);
    for (int move = 0; move < kMoves; ++move) {
      const std::array<int, 3> step = steps_of(move);
      const Eigen::AngleAxisd turn(step[2] * step_[2], Eigen::Vector3d::UnitZ());
      Eigen::Isometry3d X_WO_next = X_WO_k;
      X_WO_next.linear() = turn * X_WO_k.linear();
      X_WO_next.translation() += Eigen::Vector3d(step[0] * step_[0], step[1] * step_[1], 0);
      twists_O_.push_back(screw_between(X_WO_k, X_WO_next));
      for (int l = 0; l < locations.size(); ++l) {
        displacements_.push_back(sphere_speed(twists_O_.back(), locations[l]));
      }
    }
    for (int l = 0; l < locations.size(); ++l) {
      centers_.push_back(X_WO_k.linear() * locations[l].center_O);
    }
  }
}

Eigen::Vector3d LatticeSpace::center_W(int pose, int location) const {
  return origins_[ix(pose)] + centers_[ix(yaw(pose)) * num_locations_ + ix(location)];
}

bool LatticeSpace::is_clear(int pose, int location) {
  std::int8_t& known = clear_[ix(pose) * num_locations_ + ix(location)];
  if (known < 0) known = clearance_.is_clear(center_W(pose, location)) ? 1 : 0;
  return known != 0;
}

/// What the object does to the walls: the floor it touches everywhere.
LatticeSpace::Near LatticeSpace::near_planes(const Eigen::Isometry3d& X_WO) const {
  const Problem& problem = workshop_.problem;
  const double tolerance = kContactTolerance * problem.object.size();
  Near near = Near::nothing;
  for (std::size_t i = 1; i < problem.planes.size(); ++i) {
    const Plane& plane = problem.planes[i];
    const Eigen::RowVector3d n_O = plane.n_W.transpose() * X_WO.linear();
    const double height =
        (n_O * problem.object.hull()).minCoeff() + plane.n_W.dot(X_WO.translation()) - plane.offset;
    if (height < -tolerance) return Near::inside;
    if (height <= tolerance) near = Near::contact;
  }
  return near;
}

bool LatticeSpace::is_free(int pose) {
  std::int8_t& known = free_[ix(pose)];
  if (known < 0) {
    const Eigen::Isometry3d X = X_WO(pose);
    known = near_planes(X) != Near::inside && clearance_.obstacle_at(X).empty() ? 1 : 0;
  }
  return known != 0;
}

int LatticeSpace::find_kind(int pose, int move) {
  const int to = next(pose, move);
  if (to < 0 || !is_free(pose) || !is_free(to)) return -1;
  const std::size_t on_floor = ix(yaw(pose)) * kMoves + ix(move);
  const mechanics::Vector6d& twist_O = twists_O_[on_floor];
  const Eigen::Isometry3d X = X_WO(pose);
  const int P = workshop_.options.samples_per_arc;
  std::vector<mechanics::BodyState> states;
  bool touches = false;
  for (int j = 0; j < P; ++j) {
    const Eigen::Isometry3d X_j = along_screw(X, twist_O, (j + 0.5) / P);
    const Near near = near_planes(X_j);
    if (near == Near::inside || !clearance_.obstacle_at(X_j).empty()) return -1;
    touches = touches || near == Near::contact;
    states.push_back(moving_state(X_j, twist_O));
  }
  if (!touches && floor_kinds_[on_floor] != kUnknown) return floor_kinds_[on_floor];
  int kind = -1;
  try {
    if (!touches) states.resize(1);  // the mechanics stay the same
    std::vector<int> instants;
    for (const auto& state : states) instants.push_back(workshop_.instants.add(state));
    if (std::count(instants.begin(), instants.end(), instants.front()) == P) instants.resize(1);
    kind = num_kinds();
    kinds_.push_back(std::move(instants));
  } catch (const std::invalid_argument&) {
    kind = -1;  // into a wall, or contacts that points cannot stand for
  }
  if (!touches) floor_kinds_[on_floor] = kind;
  return kind;
}

int LatticeSpace::rest_instant(int pose) {
  int& known = rest_[ix(pose)];
  if (known == kUnknown) {
    known = -1;
    if (is_free(pose)) {
      known = workshop_.instants.add(resting_state(X_WO(pose), mechanics::Vector6d::Zero()));
    }
  }
  return known;
}

int LatticeSpace::rest_instant(int pose, int next_move) {
  const mechanics::Vector6d& twist_O = twists_O_[ix(yaw(pose)) * kMoves + ix(next_move)];
  return workshop_.instants.add(resting_state(X_WO(pose), twist_O));
}

std::int64_t LatticeSpace::memory() const {
  return static_cast<std::int64_t>((arc_kinds_.size() + next_.size()) * sizeof(int) +
                                   clear_.size() + displacements_.size() * sizeof(double) +
                                   centers_.size() * sizeof(Eigen::Vector3d));
}

}  // namespace graspless::fingertip
