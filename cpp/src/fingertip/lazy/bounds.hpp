// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

constexpr int kStep = 8;        // sizes and strides are multiples of it
constexpr float kFree = 1e30F;  // more than any sum

/// The least entry of the sum of rows of `size` entries.
float least_sum(const float* const* rows, int count, int size);

/// The greatest w . y over edges w (6 numbers each) or 0, of kStep functionals y whose components
/// are `stride` apart.
void greatest_of_edges(const float* edges, int count, const float* y, int stride, float* h);

/// The same for one functional; components of the edges are `stride` apart.
float greatest_of_edges(const float* components, int stride, const float* y);

/// For any y with y . g <= 0 for all generators g of an instant's environment,
///   z <= (y . known + sum over fingers of h(y, location)) / max over d of y . l_d.
/// An instant has up to width() functionals. A table holds h for each location, filled where it is
/// looked at. The entries of a location for all instants lie together, since a placement is mostly
/// looked at from instant to instant. Threads may look at bounds together while none adds any. A
/// functional found at one instant serves others too: what an environment cannot do stays the same
/// in the world while the object turns about standing contacts, and in the object while it slides.
class StabilityBounds {
 public:
  StabilityBounds(const PoseGraph& graph, const Instants& instants);

  /// Upper bound on z of the placement (single precision, rounded up).
  float bound(int instant, const Placement& placement) const;

  /// Adds functionals that were found when `placement` was solved at `instant`. Each instant gets
  /// those that bound this placement by much more than is known there.
  void add(int instant, const std::vector<mechanics::Vector6d>& functionals,
           const Placement& placement);

  /// Grows whenever bounds at this instant may have changed; at any instant.
  std::int64_t stamp(int instant) const { return pool(instant).stamp; }
  std::int64_t stamp() const { return stamp_; }
  /// True once a functional has given way to another: bounds at this instant may have risen.
  bool has_forgotten(int instant) const { return pool(instant).has_forgotten; }

  /// The table as it lies in memory: used() floats at an instant and a location, to be added up
  /// over the fingers and to offsets(); the least sum is the bound.
  int used(int instant) const;  // a multiple of kStep
  const float* block(int instant, int location) const;
  const float* offsets(int instant) const { return pool(instant).offsets.data(); }
  using Step = Eigen::Array<float, kStep, 1>;

  std::int64_t count() const { return count_; }  // functionals in all tables
  std::int64_t memory() const;

 private:
  struct Pool {
    mechanics::Matrix6d to_world, from_world;  // functionals on wrenches about the world's origin
    int standing = -1;    // instants whose environments are the same in the world share a number
    std::size_t row = 0;  // place in all_
    int size = 0, oldest = 0;
    bool has_forgotten = false;
    std::int64_t stamp = 0;
    std::vector<float> offsets, y;     // width; 6 x width
    std::vector<std::int64_t> stamps;  // of each functional
  };
  struct Bound {
    mechanics::Vector6d y;
    double offset, value;
  };
  /// A functional to be carried to other instants.
  struct Carried {
    Bound bound;
    mechanics::Vector6d world;
    std::vector<std::int8_t> holds;  // for each kind of standing environment; -1: not known yet
  };
  const Pool& pool(int instant) const { return pools_[instant]; }
  Pool& pool(int instant) { return pools_[instant]; }
  void list_edges();
  void place(int instant, const Eigen::Isometry3d& X_WO);
  void find_standing();
  void fill(const Pool& pool, std::size_t location, std::size_t at) const;
  bool is_polar(int instant, const mechanics::Vector6d& y) const;
  std::vector<Bound> best_of(int instant, const std::vector<mechanics::Vector6d>& functionals,
                             const Placement& placement) const;
  bool carry(int target, Carried& carried, Bound& bound) const;
  bool measure(int instant, const Placement& placement, Bound& bound) const;
  void store(int instant, const Bound& bound);

  const PoseGraph& graph_;
  const Instants& instants_;
  int num_locations_, width_ = 0, edges_ = 0;
  bool has_paper_directions_ = false;
  double paper_length_ = 0;
  int padded_ = 0;                    // edges_, rounded up
  std::vector<float> edge_wrenches_;  // f_max c_j / normal_j: location, edge, component
  std::vector<float> components_;     // the same: location, component, edge
  std::vector<Pool> pools_;
  std::vector<int> all_;                        // instants in use
  std::vector<mechanics::Matrix6Xd> standing_;  // generators in the world
  std::unique_ptr<float[]> h_;  // locations x instants x width; undefined if not filled
  std::unique_ptr<std::atomic<std::int64_t>[]> filled_;  // up to which stamp: locations x instants
  mutable std::array<std::mutex, 64> filling_;           // of a location, modulo their number
  double most_force_ = 0;
  std::int64_t stamp_ = 1, count_ = 0;
};

}  // namespace graspless::fingertip
