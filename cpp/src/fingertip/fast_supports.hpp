// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Upper bounds on stability from wrench functionals, as tables over locations.
#pragma once

#include <cstdint>
#include <vector>

#include "fingertip/instants.hpp"
#include "fingertip/locations.hpp"
#include "fingertip/path_query.hpp"

namespace graspless::fingertip {

/// For any y with y . g <= 0 for all generators g of an instant's environment,
///   z <= (y . known + sum over fingers of h(y, location)) / max over d of y . l_d.
/// A table holds h for all locations and up to `capacity` functionals an instant; a bound is the
/// least over them. A functional found at one instant serves others too: what the environment
/// cannot do stays the same in the world while an object turns about standing contacts, and in the
/// object while it slides.
class Supports {
 public:
  Supports(const PathQuery& query, const Instants& instants);

  /// At least z of the placement (single precision, rounded up).
  float bound(int instant, const Placement& placement) const;

  /// Takes functionals that were found when `placement` was solved at `instant`: to each instant of
  /// `targets` those that bound this placement more tightly than what is known there.
  void add(int instant, const std::vector<mechanics::Vector6d>& functionals,
           const Placement& placement, const std::vector<int>& targets);

  /// Grows whenever bounds at this instant may have changed.
  std::int64_t stamp(int instant) const { return pool(instant).stamp; }
  std::int64_t stamp() const { return stamp_; }

  /// The table as it lies in memory: one block of width() floats a location, to be added up over
  /// the fingers and to offsets(); the least sum is the bound.
  int width() const { return width_; }
  int used(int instant) const;  // of width(), a multiple of 8
  const float* block(int instant, int location) const {
    return pool(instant).h.data() + static_cast<std::size_t>(location) * width();
  }
  const float* offsets(int instant) const { return pool(instant).offsets.data(); }

  std::int64_t count() const { return count_; }  // functionals in all tables
  std::int64_t memory() const;

 private:
  struct Pool {
    mechanics::Matrix6d to_world, from_world;  // functionals on wrenches about the world's origin
    std::vector<float> offsets, h;
    int size = 0, oldest = 0;
    std::int64_t stamp = 0;
  };
  struct Row {
    mechanics::Vector6d y;
    double offset;
  };
  const Pool& pool(int instant) const { return pools_[static_cast<std::size_t>(instant)]; }
  void place(int instant, const Eigen::Isometry3d& X_WO);
  bool is_polar(int instant, const mechanics::Vector6d& y) const;
  double value(int location, const mechanics::Vector6d& y) const;  // h(y, location)
  bool normalize(int instant, mechanics::Vector6d& y, double& offset) const;
  double total(const Placement& placement, const mechanics::Vector6d& y) const;
  void store(int instant, const mechanics::Vector6d& y, double offset);

  const PathQuery& query_;
  const Instants& instants_;
  int num_locations_, width_ = 0, edges_ = 0;
  std::vector<float> edge_wrenches_;  // f_max c_j / normal_j: edge, component, location
  mutable std::vector<float> row_;
  std::vector<Pool> pools_;
  std::int64_t stamp_ = 1, count_ = 0;
};

}  // namespace graspless::fingertip
