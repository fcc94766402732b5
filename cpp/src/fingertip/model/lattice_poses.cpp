// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Poses and arcs of an object that slides and turns on the floor.
#include <array>
#include <cmath>
#include <stdexcept>

#include "graspless/watch.hpp"

#include "fingertip/model/pose_graph.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kMoves = 26;  // to the neighbours of a pose
constexpr double kTurn = 2 * M_PI;
constexpr double kSameYaw = 1e-9;  // [rad]

/// Steps of a move along x, y and yaw, in lexicographic order and without standing still: moves m
/// and 25 - m are opposite.
std::array<int, 3> steps_of(int move) {
  const int i = move < kMoves / 2 ? move : move + 1;
  return {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
}

/// Arithmetic of a lattice's indices: pose = (x * counts[1] + y) * counts[2] + yaw.
class Grid {
 public:
  explicit Grid(const Lattice& lattice) : X_WO_start_(lattice.X_WO_start), counts_(lattice.counts) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      lower_[i] = lattice.lower[axis];
      step_[i] = counts_[i] > 1 ? (lattice.upper[axis] - lower_[i]) / (counts_[i] - 1) : 0;
    }
    if (counts_[2] < 2) return;
    const int around = static_cast<int>(std::lround(kTurn / step_[2]));
    if (std::abs(around * step_[2] - kTurn) > kSameYaw || counts_[2] < around) return;
    counts_[2] = around;  // yaws a whole turn apart are the same
    wraps_ = true;
  }

  int num_poses() const { return counts_[0] * counts_[1] * counts_[2]; }
  int num_yaws() const { return counts_[2]; }
  int yaw(int pose) const { return pose % counts_[2]; }

  int index_of(const Eigen::Isometry3d& X_WO) const {
    const Eigen::Vector3d p = X_WO.translation() - X_WO_start_.translation();
    const Eigen::Matrix3d turn = X_WO.linear() * X_WO_start_.linear().transpose();
    const double yaw = std::atan2(turn(1, 0), turn(0, 0));
    const std::array<double, 3> values{p.x(), p.y(), yaw};
    std::array<int, 3> index{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (counts_[i] == 1) continue;
      const auto at = [&](double value) {
        return static_cast<int>(std::lround((value - lower_[i]) / step_[i]));
      };
      index[i] = at(values[i]);
      // Several yaws are the same turn: take the one on the lattice.
      double off = kTurn;
      for (int turns = -3; i == 2 && turns <= 3; ++turns) {
        const double value = yaw + turns * kTurn;
        const int other = at(value);
        const double beside = std::abs(lower_[2] + other * step_[2] - value);
        if (other < 0 || other >= counts_[2] || beside >= off) continue;
        index[2] = other;
        off = beside;
      }
      if (index[i] < 0 || index[i] >= counts_[i]) {
        throw std::invalid_argument("motion: start and goal must lie on the lattice");
      }
    }
    return (index[0] * counts_[1] + index[1]) * counts_[2] + index[2];
  }

  Eigen::Isometry3d X_WO(int pose) const {
    const int k = yaw(pose), xy = pose / counts_[2];
    const Eigen::AngleAxisd turn(lower_[2] + k * step_[2], Eigen::Vector3d::UnitZ());
    Eigen::Isometry3d X = X_WO_start_;
    X.linear() = turn * X_WO_start_.linear();
    X.translation().x() += lower_[0] + xy / counts_[1] * step_[0];
    X.translation().y() += lower_[1] + xy % counts_[1] * step_[1];
    return X;
  }

  /// A neighbour's pose, also where that lies off the lattice.
  Eigen::Isometry3d X_WO_after(const Eigen::Isometry3d& X_WO, int move) const {
    const std::array<int, 3> step = steps_of(move);
    const Eigen::AngleAxisd turn(step[2] * step_[2], Eigen::Vector3d::UnitZ());
    Eigen::Isometry3d X_WO_next = X_WO;
    X_WO_next.linear() = turn * X_WO.linear();
    X_WO_next.translation() += Eigen::Vector3d(step[0] * step_[0], step[1] * step_[1], 0);
    return X_WO_next;
  }

  int next(int pose, int move) const {
    const std::array<int, 3> step = steps_of(move);
    const int xy = pose / counts_[2];
    const int x = xy / counts_[1] + step[0], y = xy % counts_[1] + step[1];
    int k = yaw(pose) + step[2];
    if (x < 0 || x >= counts_[0] || y < 0 || y >= counts_[1]) return -1;
    if (wraps_) k = (k + counts_[2]) % counts_[2];
    if (k < 0 || k >= counts_[2]) return -1;
    return (x * counts_[1] + y) * counts_[2] + k;
  }

 private:
  Eigen::Isometry3d X_WO_start_;
  std::array<int, 3> counts_;
  std::array<double, 3> lower_{}, step_{};
  bool wraps_ = false;  // the yaws go all the way round
};

}  // namespace

PoseGraph::PoseGraph(const Problem& problem, const Lattice& lattice, const Locations& locations_in,
                     Instants& instants, const Options& options_in)
    : options(options_in),
      locations(locations_in),
      num_fingers(problem.fingers.count),
      problem_(problem),
      instants_(instants),
      num_locations_(locations_in.size()),
      num_moves_(kMoves),
      clearance_(problem) {
  const Grid grid(lattice);
  start_ = grid.index_of(lattice.X_WO_start);
  goal_ = grid.index_of(lattice.X_WO_goal);
  for (int pose = 0; pose < grid.num_poses(); ++pose) {
    poll();
    X_WO_.push_back(grid.X_WO(pose));
    turns_.push_back(grid.yaw(pose));
    for (int move = 0; move < kMoves; ++move) next_.push_back(grid.next(pose, move));
  }
  for (int yaw = 0; yaw < grid.num_yaws(); ++yaw) {
    for (int move = 0; move < kMoves; ++move) {
      add_motion(screw_between(X_WO(yaw), grid.X_WO_after(X_WO(yaw), move)));
    }
  }
  floor_kinds_.assign(num_motions(), kUnknown);
  kinds_of_.assign(next_.size(), kUnknown);
  rest_.assign(X_WO_.size(), kUnknown);
  free_.assign(X_WO_.size(), -1);
  make_clearance_table();
  keep_to_start();
}

double PoseGraph::memory_needed(const Lattice& lattice, double num_locations) {
  const double yaws = lattice.counts[2];
  const double poses = 1.0 * lattice.counts[0] * lattice.counts[1] * yaws;
  // A pose: itself, moves and their kinds, marks of the search; a location: clearance and distance.
  return poses * (sizeof(Eigen::Isometry3d) + 2 * sizeof(int) * kMoves + 64 +
                  num_locations * (1 + sizeof(double))) +
         yaws * num_locations * sizeof(double) * kMoves;
}

}  // namespace graspless::fingertip
