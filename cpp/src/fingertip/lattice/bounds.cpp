// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Upper bounds on stability from wrench functionals, for instants that are not known beforehand.
#include "fingertip/lattice/bounds.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "fingertip/lazy/bounds.hpp"

namespace graspless::fingertip {
namespace {

using mechanics::Vector6d;

constexpr double kPolar = 1e-12;     // y . g of a functional of length 1 that counts as <= 0
constexpr float kRounding = 1e-5F;   // of single precision, relative to the terms added
constexpr double kProgress = 0.999;  // a functional must bound by that much better to be kept

}  // namespace

LatticeBounds::LatticeBounds(const PoseGraph& graph, Evaluator& evaluator)
    : locations_(graph.locations),
      options_(graph.options),
      evaluator_(evaluator),
      row_(graph.locations.size()) {
  const std::size_t L = row_.size();
  num_edges_ = L == 0 ? 0 : static_cast<int>(locations_.wrenches(0).generators.cols());
  edges_.resize(num_edges_ * 6 * L);
  for (int l = 0; l < locations_.size(); ++l) {
    poll();
    const mechanics::FingerWrenches& wrenches = locations_.wrenches(l);
    for (int j = 0; j < num_edges_; ++j) {
      const Vector6d w =
          wrenches.generators.col(j) * (wrenches.max_normal_force / wrenches.normal[j]);
      for (int c = 0; c < 6; ++c) edges_[(j * 6 + c) * L + l] = static_cast<float>(w[c]);
    }
  }
}

LatticeBounds::Table& LatticeBounds::table(int instant) {
  if (instant >= static_cast<int>(tables_.size())) tables_.resize(instant + 1);
  Table& table = tables_[instant];
  if (table.h.empty()) {
    table.h.assign(row_.size() * kWidth, 0.0F);
    table.offsets.assign(kWidth, kFree);
    // The newest first: they refused placements like those that are looked at now.
    for (std::size_t i = pool_.size(); i-- > 0 && table.size < kWidth / 2;) {
      store(instant, table, pool_[i], nullptr);
    }
  }
  return table;
}

double LatticeBounds::bound(int instant, const Placement& placement) {
  const Table& t = table(instant);
  const float* rows[1 + mechanics::kMaxFingers] = {t.offsets.data()};
  int count = 1;
  for (const std::int32_t location : placement) {
    if (location >= 0) rows[count++] = t.h.data() + static_cast<std::size_t>(location) * kWidth;
  }
  return static_cast<double>(least_sum(rows, count, (t.size + kStep - 1) / kStep * kStep));
}

double LatticeBounds::solve(int instant, const Placement& placement) {
  const double known = evaluator_.known(instant, placement);
  if (known >= 0) return known;
  evaluator_.solver().clear_supports();
  const double z = evaluator_.stability(instant, placement);
  for (const Vector6d& y : evaluator_.solver().supports()) learn(instant, y, placement);
  return z;
}

void LatticeBounds::learn(int instant, const Vector6d& y, const Placement& placement) {
  if (!store(instant, table(instant), y, &placement)) return;
  if (pool_.size() < kMaxPool) pool_.push_back(y);
}

/// Keeps a functional if it is one here, and bounds the placement better than what is there.
bool LatticeBounds::store(int instant, Table& t, const Vector6d& y_in, const Placement* placement) {
  const mechanics::EnvironmentWrenches& environment =
      evaluator_.instants()[instant].environments.front();
  if ((environment.generators.transpose() * y_in).maxCoeff() > kPolar * y_in.norm()) return false;
  const double sigma = (options_.disturbance_directions.transpose() * y_in).maxCoeff();
  if (!(sigma > 1e-9 * y_in.norm())) return false;
  const Vector6d y = y_in / sigma;
  const float known = static_cast<float>(y.dot(environment.known));
  const float slack = kRounding * (std::abs(known) + row(y) * 4);
  if (placement != nullptr) {
    float sum = known + slack;
    for (const std::int32_t location : *placement) {
      if (location >= 0) sum += row_[location];
    }
    if (static_cast<double>(sum) >= kProgress * bound(instant, *placement)) return false;
  }
  int column = t.size;
  if (t.size < kWidth) {
    ++t.size;
    ++count_;
  } else {
    column = t.oldest;
    t.oldest = (t.oldest + 1) % kWidth;
  }
  t.offsets[column] = known + slack;
  for (std::size_t l = 0; l < row_.size(); ++l) t.h[l * kWidth + column] = row_[l];
  return true;
}

/// h at all locations; returns the largest.
float LatticeBounds::row(const Vector6d& y) {
  const std::size_t L = row_.size();
  std::fill(row_.begin(), row_.end(), 0.0F);
  const Eigen::Matrix<float, 6, 1> f = y.cast<float>();
  for (int j = 0; j < num_edges_; ++j) {
    const float* w = edges_.data() + j * 6 * L;
    for (std::size_t l = 0; l < L; ++l) {
      const float sum = f[0] * w[l] + f[1] * w[L + l] + f[2] * w[2 * L + l] + f[3] * w[3 * L + l] +
                        f[4] * w[4 * L + l] + f[5] * w[5 * L + l];
      row_[l] = std::max(row_[l], sum);
    }
  }
  float most = 0;
  for (const float h : row_) most = std::max(most, h);
  return most;
}

std::int64_t LatticeBounds::memory() const {
  std::size_t bytes = edges_.size() * sizeof(float);
  for (const Table& t : tables_) bytes += (t.h.size() + t.offsets.size()) * sizeof(float);
  return static_cast<std::int64_t>(bytes);
}

}  // namespace graspless::fingertip
