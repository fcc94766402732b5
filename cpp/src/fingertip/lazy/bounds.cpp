// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Upper bounds on stability from wrench functionals, as tables over locations.
#include "fingertip/lazy/bounds.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "graspless/watch.hpp"

#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {

using mechanics::Matrix6d;
using mechanics::Matrix6Xd;
using mechanics::Vector6d;

namespace {

constexpr double kPolar = 1e-12;   // y . g of a functional of length 1 that counts as <= 0
constexpr double kRoundUp = 2e-6;  // of single precision, relative to the terms added
constexpr double kProgress = 0.1;  // a functional must bound by that much more elsewhere
constexpr std::size_t kKept = 2;   // functionals kept of those of one solution

/// Map from coefficients on (force, moment about com) in O to those on (force, moment about the
/// origin) in W.
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

bool are_polar(const Matrix6Xd& generators, const Vector6d& y) {
  const double limit = kPolar * y.norm();
  for (Eigen::Index g = 0; g < generators.cols(); ++g) {
    if (y.dot(generators.col(g)) > limit * generators.col(g).norm()) return false;
  }
  return true;
}

int round_up(int n) { return (n + kStep - 1) / kStep * kStep; }

}  // namespace

StabilityBounds::StabilityBounds(const PoseGraph& graph, const Instants& instants)
    : graph_(graph), instants_(instants), num_locations_(graph.locations.size()) {
  const Matrix6Xd& directions = graph.options.disturbance_directions;
  has_paper_directions_ = directions.cols() == mechanics::disturbance_directions().cols() &&
                          directions == mechanics::disturbance_directions();
  paper_length_ = directions.col(0).norm();
  list_edges();
  pools_.resize(instants.size());
  const int P = graph.options.samples_per_arc;
  for (int i = 0; i < P; ++i) {
    const int j = (P / 2 + i) % P;  // the middle samples side by side: they are looked at most
    for (int arc = 0; arc < graph.num_arcs(); ++arc) {
      poll();
      place(graph.instant(arc, j), along_screw(graph.X_WO(arc), graph.twist_O(arc), (j + 0.5) / P));
    }
  }
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    place(graph.rest_instant(pose), graph.X_WO(pose));
  }
  // Few instants, as in a slide, have to tell all by themselves.
  width_ = all_.size() <= 4 ? 256 : 32;
  find_standing();
}

void StabilityBounds::list_edges() {
  if (num_locations_ == 0) return;
  edges_ = static_cast<int>(graph_.locations.wrenches(0).generators.cols());
  padded_ = round_up(edges_);
  const auto count = static_cast<std::size_t>(num_locations_);
  edge_wrenches_.resize(count * static_cast<std::size_t>(6 * edges_));
  components_.resize(count * static_cast<std::size_t>(6 * padded_), 0.0F);
  for (int location = 0; location < num_locations_; ++location) {
    poll();
    const mechanics::FingerWrenches& wrenches = graph_.locations.wrenches(location);
    for (int j = 0; j < edges_; ++j) {
      const Vector6d w =
          wrenches.generators.col(j) * (wrenches.max_normal_force / wrenches.normal[j]);
      most_force_ = std::max(most_force_, w.norm());
      for (int c = 0; c < 6; ++c) {
        edge_wrenches_[(location * edges_ + j) * 6 + c] = static_cast<float>(w[c]);
        components_[(location * 6 + c) * padded_ + j] = static_cast<float>(w[c]);
      }
    }
  }
}

void StabilityBounds::place(int instant, const Eigen::Isometry3d& X_WO) {
  if (std::find(all_.begin(), all_.end(), instant) != all_.end()) return;
  pool(instant).row = all_.size();
  all_.push_back(instant);
  const mechanics::ContactSet& set = instants_[instant].set;
  // The inverse of a rigid map and of a scale; the scale is well conditioned.
  pool(instant).to_world = functional_to_world(X_WO, set.com_O) * set.wrench_scale.transpose();
  pool(instant).from_world = pool(instant).to_world.inverse();
}

void StabilityBounds::find_standing() {
  for (const int instant : all_) {
    poll();
    const Matrix6Xd generators =
        pool(instant).from_world.transpose() * instants_[instant].environments.front().generators;
    int& number = pool(instant).standing;
    for (std::size_t i = 0; i < standing_.size() && number < 0; ++i) {
      if (standing_[i].cols() == generators.cols() &&
          (standing_[i] - generators).norm() <= kPolar * generators.norm()) {
        number = static_cast<int>(i);
      }
    }
    if (number >= 0) continue;
    number = static_cast<int>(standing_.size());
    standing_.push_back(generators);
  }
}

int StabilityBounds::used(int instant) const { return round_up(pool(instant).size); }

/// Fills the columns of a block that are new since it was last used.
void StabilityBounds::fill(const Pool& p, std::size_t location, std::size_t at) const {
  const std::lock_guard<std::mutex> lock(filling_[location % filling_.size()]);
  const std::int64_t filled = filled_[at].load(std::memory_order_relaxed);
  float* h = h_.get() + at * static_cast<std::size_t>(width_);
  const float* edges = edge_wrenches_.data() + location * static_cast<std::size_t>(edges_ * 6);
  for (int first = 0; first < p.size && filled < p.stamp; first += kStep) {
    const auto begin = p.stamps.begin() + first;
    if (*std::max_element(begin, begin + kStep) <= filled) continue;
    greatest_of_edges(edges, edges_, p.y.data() + first, width_, h + first);
  }
  filled_[at].store(p.stamp, std::memory_order_release);
}

const float* StabilityBounds::block(int instant, int location) const {
  const Pool& p = pool(instant);
  const std::size_t at = static_cast<std::size_t>(location) * all_.size() + p.row;
  if (filled_[at].load(std::memory_order_acquire) < p.stamp) {
    fill(p, static_cast<std::size_t>(location), at);
  }
  return h_.get() + at * static_cast<std::size_t>(width_);
}

float StabilityBounds::bound(int instant, const Placement& placement) const {
  const Pool& p = pool(instant);
  if (p.size == 0) return kFree;
  const float* rows[1 + mechanics::kMaxFingers] = {p.offsets.data()};
  int count = 1;
  for (const std::int32_t location : placement) {
    if (location >= 0) rows[count++] = block(instant, location);
  }
  return least_sum(rows, count, round_up(p.size));
}

bool StabilityBounds::is_polar(int instant, const Vector6d& y) const {
  return are_polar(instants_[instant].environments.front().generators, y);
}

/// Scales y such that its bound is y . known + sum of h.
bool StabilityBounds::measure(int instant, const Placement& placement, Bound& bound) const {
  Vector6d& y = bound.y;
  const double sigma =
      has_paper_directions_
          ? paper_length_ * std::max(y.lpNorm<Eigen::Infinity>(), y.lpNorm<1>() / std::sqrt(6.0))
          : (graph_.options.disturbance_directions.transpose() * y).maxCoeff();
  if (!(sigma > 0) || !std::isfinite(sigma)) return false;
  y /= sigma;
  bound.offset = y.dot(instants_[instant].environments.front().known);
  bound.value = bound.offset;
  const Eigen::Matrix<float, 6, 1> y_float = y.cast<float>();
  for (const std::int32_t location : placement) {
    if (location < 0) continue;
    const float* components = components_.data() + static_cast<std::size_t>(location * 6 * padded_);
    bound.value += static_cast<double>(greatest_of_edges(components, padded_, y_float.data()));
  }
  return true;
}

/// Functionals that bound the placement most, best first.
std::vector<StabilityBounds::Bound> StabilityBounds::best_of(
    int instant, const std::vector<Vector6d>& functionals, const Placement& placement) const {
  std::vector<Bound> found;
  for (const Vector6d& y : functionals) {
    Bound bound{y, 0, 0};
    if (measure(instant, placement, bound)) found.push_back(bound);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Bound& a, const Bound& b) { return a.value < b.value; });
  if (found.size() > kKept) found.resize(kKept);
  return found;
}

/// Carries a functional to another instant. False if it is none there.
bool StabilityBounds::carry(int target, Carried& carried, Bound& bound) const {
  const Pool& p = pool(target);
  const auto kind = static_cast<std::size_t>(p.standing);
  if (carried.holds[kind] < 0) carried.holds[kind] = are_polar(standing_[kind], carried.world);
  bound = carried.bound;
  if (carried.holds[kind] == 1) {
    bound.y = p.from_world * carried.world;
    return true;
  }
  return is_polar(target, bound.y);
}

void StabilityBounds::add(int instant, const std::vector<Vector6d>& functionals,
                          const Placement& placement) {
  std::vector<Carried> found;
  for (const Bound& bound : best_of(instant, functionals, placement)) {
    found.push_back(
        {bound, pool(instant).to_world * bound.y, std::vector<std::int8_t>(standing_.size(), -1)});
    store(instant, bound);
  }
  const double needed = graph_.options.min_stability;
  for (const int target : all_) {
    poll();
    if (target == instant) continue;
    const auto known = static_cast<double>(bound(target, placement));
    if (known < needed) continue;  // nothing to gain
    Bound best;
    best.value = known - kProgress * std::abs(known);
    bool is_better = false;
    for (Carried& carried : found) {
      Bound here;
      if (!carry(target, carried, here) || !measure(target, placement, here)) continue;
      if (here.value >= best.value) continue;
      best = here;
      is_better = true;
    }
    if (is_better) store(target, best);
  }
}

void StabilityBounds::store(int instant, const Bound& bound) {
  Pool& p = pool(instant);
  const auto width = static_cast<std::size_t>(width_);
  if (!h_) {
    const std::size_t blocks = static_cast<std::size_t>(num_locations_) * all_.size();
    h_.reset(new float[blocks * width]);
    filled_ = std::make_unique<std::atomic<std::int64_t>[]>(blocks);
  }
  if (p.offsets.empty()) {
    p.offsets.resize(width, kFree);
    p.stamps.resize(width, 0);
    p.y.resize(6 * width, 0.0F);
  }
  int column = p.size;
  if (p.size < width_) {
    ++p.size;
    ++count_;
  } else {
    column = p.oldest;
    p.has_forgotten = true;
    p.oldest = (p.oldest + 1) % width_;
  }
  const auto col = static_cast<std::size_t>(column);
  const double most = bound.y.norm() * most_force_;
  p.offsets[col] = static_cast<float>(
      bound.offset + kRoundUp * (std::abs(bound.offset) + graph_.num_fingers * most));
  for (std::size_t c = 0; c < 6; ++c) p.y[c * width + col] = static_cast<float>(bound.y[c]);
  p.stamp = p.stamps[col] = ++stamp_;
}

std::int64_t StabilityBounds::memory() const {
  std::size_t bytes = (edge_wrenches_.size() + components_.size()) * sizeof(float);
  if (h_) {
    const std::size_t block = static_cast<std::size_t>(width_) * sizeof(float) + sizeof(filled_[0]);
    bytes += static_cast<std::size_t>(num_locations_) * all_.size() * block;
  }
  for (const Pool& p : pools_) {
    bytes += (p.offsets.size() + p.y.size()) * sizeof(float) + p.stamps.size() * sizeof(p.stamp);
  }
  return static_cast<std::int64_t>(bytes);
}

}  // namespace graspless::fingertip
