// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Upper bounds on stability from wrench functionals, as tables over locations.
#include "fingertip/fast_supports.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "fingertip/screw.hpp"

namespace graspless::fingertip {

using mechanics::Matrix6d;
using mechanics::Vector6d;

namespace {

constexpr float kFree = 1e30F;      // an empty place in a table bounds nothing
constexpr double kPolar = 1e-12;    // y . g of a functional of length 1 that counts as <= 0
constexpr double kRounding = 2e-6;  // of single precision, relative to the terms added
constexpr double kProgress = 1e-4;  // a functional must bound by that much more to be kept

/// From coefficients on (force, moment about com) in O to those on (force, moment about the origin)
/// in W.
Matrix6d functional_to_world(const Eigen::Isometry3d& X_WO, const Eigen::Vector3d& com_O) {
  const Eigen::Matrix3d R_WO = X_WO.linear();
  const Eigen::Vector3d com_W = X_WO * com_O;
  Eigen::Matrix3d cross;
  cross << 0, -com_W.z(), com_W.y(), com_W.z(), 0, -com_W.x(), -com_W.y(), com_W.x(), 0;
  Matrix6d map = Matrix6d::Zero();
  map.topLeftCorner<3, 3>() = R_WO;
  map.topRightCorner<3, 3>() = cross * R_WO;
  map.bottomRightCorner<3, 3>() = R_WO;
  return map;
}

int round_up(int n, int step) { return (n + step - 1) / step * step; }

}  // namespace

Supports::Supports(const PathQuery& query, const Instants& instants)
    : query_(query), instants_(instants), num_locations_(query.locations.size()) {
  // Many instants share what one solution tells; a slide has but one or two.
  width_ = instants.size() <= 4 ? 64 : 32;
  edges_ =
      num_locations_ == 0 ? 0 : static_cast<int>(query.locations.wrenches(0).generators.cols());
  const auto L = static_cast<std::size_t>(num_locations_);
  edge_wrenches_.resize(static_cast<std::size_t>(edges_) * 6 * L);
  row_.resize(L);
  for (int location = 0; location < num_locations_; ++location) {
    const mechanics::FingerWrenches& wrenches = query.locations.wrenches(location);
    for (int j = 0; j < edges_; ++j) {
      const Vector6d w =
          wrenches.generators.col(j) * (wrenches.max_normal_force / wrenches.normal[j]);
      for (int c = 0; c < 6; ++c) {
        edge_wrenches_[static_cast<std::size_t>(j * 6 + c) * L +
                       static_cast<std::size_t>(location)] = static_cast<float>(w[c]);
      }
    }
  }
  pools_.resize(static_cast<std::size_t>(instants.size()));
  const int P = query.options.samples_per_arc;
  for (int arc = query.num_arcs() - 1; arc >= 0; --arc) {  // the first use counts
    for (int j = P - 1; j >= 0; --j) {
      const auto a = static_cast<std::size_t>(arc);
      place(query.instant(arc, j), along_screw(query.X_WO[a], query.twist_O[a], (j + 0.5) / P));
    }
  }
  for (int pose = query.num_poses() - 1; pose >= 0; --pose) {
    place(query.rest_instant(pose), query.X_WO[static_cast<std::size_t>(pose)]);
  }
}

void Supports::place(int instant, const Eigen::Isometry3d& X_WO) {
  Pool& p = pools_[static_cast<std::size_t>(instant)];
  const mechanics::ContactSet& set = instants_[instant].set;
  const Matrix6d to_world = functional_to_world(X_WO, set.com_O);
  p.to_world = to_world * set.wrench_scale.transpose();
  p.from_world = p.to_world.inverse();
}

int Supports::used(int instant) const { return round_up(pool(instant).size, 8); }

float Supports::bound(int instant, const Placement& placement) const {
  const Pool& p = pool(instant);
  float least = kFree;
  const int used = round_up(p.size, 8);
  for (int i = 0; i < used; i += 8) {
    float sums[8];
    for (int k = 0; k < 8; ++k) sums[k] = p.offsets[static_cast<std::size_t>(i + k)];
    for (const std::int32_t location : placement) {
      if (location < 0) break;
      const float* h = block(instant, location) + i;
      for (int k = 0; k < 8; ++k) sums[k] += h[k];
    }
    for (int k = 0; k < 8; ++k) least = sums[k] < least ? sums[k] : least;
  }
  return least;
}

bool Supports::is_polar(int instant, const Vector6d& y) const {
  const mechanics::Matrix6Xd& generators = instants_[instant].environments.front().generators;
  const double limit = kPolar * y.norm();
  for (Eigen::Index g = 0; g < generators.cols(); ++g) {
    if (y.dot(generators.col(g)) > limit) return false;
  }
  return true;
}

bool Supports::normalize(int instant, Vector6d& y, double& offset) const {
  const double sigma = (query_.options.disturbance_directions.transpose() * y).maxCoeff();
  if (!(sigma > 1e-9 * y.norm())) return false;
  y /= sigma;
  offset = y.dot(instants_[instant].environments.front().known);
  return std::isfinite(offset);
}

double Supports::value(int location, const Vector6d& y) const {
  const auto L = static_cast<std::size_t>(num_locations_);
  double most = 0;
  for (int j = 0; j < edges_; ++j) {
    double sum = 0;
    for (int c = 0; c < 6; ++c) {
      sum += y[c] * static_cast<double>(edge_wrenches_[static_cast<std::size_t>(j * 6 + c) * L +
                                                       static_cast<std::size_t>(location)]);
    }
    most = std::max(most, sum);
  }
  return most;
}

double Supports::total(const Placement& placement, const Vector6d& y) const {
  double sum = 0;
  for (const std::int32_t location : placement) {
    if (location >= 0) sum += value(location, y);
  }
  return sum;
}

void Supports::add(int instant, const std::vector<Vector6d>& functionals,
                   const Placement& placement, const std::vector<int>& targets) {
  const double needed = query_.options.min_stability;
  std::vector<Vector6d> world;
  for (const Vector6d& y : functionals) world.push_back(pool(instant).to_world * y);
  for (const int target : targets) {
    const double known = static_cast<double>(bound(target, placement));
    if (known < needed) continue;  // nothing to gain
    double best = known - kProgress * std::max(1.0, std::abs(known)), best_offset = 0;
    Vector6d best_y = Vector6d::Zero();
    for (std::size_t i = 0; i < functionals.size(); ++i) {
      Vector6d y = target == instant ? functionals[i] : pool(target).from_world * world[i];
      if (target != instant && !is_polar(target, y)) {
        y = functionals[i];
        if (!is_polar(target, y)) continue;
      }
      double offset = 0;
      if (!normalize(target, y, offset)) continue;
      const double bounded = offset + total(placement, y);
      if (bounded < best) {
        best = bounded;
        best_y = y;
        best_offset = offset;
      }
    }
    if (best_y != Vector6d::Zero()) store(target, best_y, best_offset);
  }
}

void Supports::store(int instant, const Vector6d& y, double offset) {
  Pool& p = pools_[static_cast<std::size_t>(instant)];
  const auto L = static_cast<std::size_t>(num_locations_);
  if (p.h.empty()) {
    p.h.resize(L * static_cast<std::size_t>(width_), 0.0F);
    p.offsets.resize(static_cast<std::size_t>(width_), kFree);
  }
  std::fill(row_.begin(), row_.end(), 0.0F);
  float most = 0;
  for (int j = 0; j < edges_; ++j) {
    const float* w = edge_wrenches_.data() + static_cast<std::size_t>(j) * 6 * L;
    const float y0 = static_cast<float>(y[0]), y1 = static_cast<float>(y[1]),
                y2 = static_cast<float>(y[2]), y3 = static_cast<float>(y[3]),
                y4 = static_cast<float>(y[4]), y5 = static_cast<float>(y[5]);
    for (std::size_t l = 0; l < L; ++l) {
      const float sum = y0 * w[l] + y1 * w[L + l] + y2 * w[2 * L + l] + y3 * w[3 * L + l] +
                        y4 * w[4 * L + l] + y5 * w[5 * L + l];
      row_[l] = sum > row_[l] ? sum : row_[l];
    }
  }
  for (const float h : row_) most = std::max(most, h);
  int column = p.size;
  if (p.size < width_) {
    ++p.size;
    ++count_;
  } else {
    column = p.oldest;
    p.oldest = (p.oldest + 1) % width_;
  }
  const auto col = static_cast<std::size_t>(column);
  const double slack = kRounding * (std::abs(offset) + 6.0 * static_cast<double>(most) + 1.0);
  p.offsets[col] = static_cast<float>(offset + slack);
  for (std::size_t l = 0; l < L; ++l) p.h[l * static_cast<std::size_t>(width_) + col] = row_[l];
  p.stamp = ++stamp_;
}

std::int64_t Supports::memory() const {
  std::size_t bytes = edge_wrenches_.size() * sizeof(float);
  for (const Pool& p : pools_) bytes += (p.h.size() + p.offsets.size()) * sizeof(float);
  return static_cast<std::int64_t>(bytes);
}

}  // namespace graspless::fingertip
