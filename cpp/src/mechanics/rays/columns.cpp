// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Columns of the balance, side by side for pricing.
#include <algorithm>
#include <cmath>

#include "mechanics/rays/basis.hpp"

namespace graspless::mechanics {
namespace {

using kernels::kBlock;
using kernels::kLanes;

int blocks_for(int columns) { return (columns + kLanes - 1) / kLanes; }

}  // namespace

/// Returns the first entry of column j; the others follow at steps of kLanes.
double* Columns::place(int j) { return &table_[j / kLanes * kBlock + j % kLanes]; }

void Columns::assign(const EnvironmentWrenches& environment,
                     const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  const int n = static_cast<int>(fingers.size());
  const int passive = static_cast<int>(environment.generators.cols());
  rows_ = 6 + n;
  finger_row_.assign(blocks_for(passive), 6);  // a row of zeros
  for (int i = 0; i < n; ++i) {
    const int edges = static_cast<int>(fingers[i]->normal.size());
    finger_row_.insert(finger_row_.end(), static_cast<std::size_t>(blocks_for(edges + 1)), 6 + i);
  }
  table_.assign(finger_row_.size() * kBlock, 0.0);
  longest_ = 0;
  const auto put = [&](const Matrix6Xd& generators, int first) {
    if (generators.cols() > 0) {
      longest_ = std::max(longest_, generators.colwise().squaredNorm().maxCoeff());
    }
    for (int j = 0; j < static_cast<int>(generators.cols()); ++j) {
      double* entry = place(first + j);
      for (int i = 0; i < 6; ++i) entry[i * kLanes] = generators(i, j);
    }
  };
  put(environment.generators, 0);
  int next = kLanes * blocks_for(passive);
  for (int i = 0; i < n; ++i) {
    const FingerWrenches& finger = *fingers[i];
    const int edges = static_cast<int>(finger.normal.size());
    put(finger.generators, next);
    for (int j = 0; j < edges; ++j) place(next + j)[6 * kLanes] = finger.normal[j];
    const bool forced = (force >> i & 1U) != 0;
    slack_[i] = forced ? -1 : next + edges;
    if (!forced) place(next + edges)[6 * kLanes] = 1;
    next += kLanes * blocks_for(edges + 1);
  }
  longest_ = std::sqrt(longest_);
}

void Columns::column(int j, double* entries) const {
  const double* entry = &table_[j / kLanes * kBlock + j % kLanes];
  for (int i = 0; i < rows_; ++i) entries[i] = i < 6 ? entry[i * kLanes] : 0;
  const int row = finger_row_[j / kLanes];
  if (row < rows_) entries[row] = entry[6 * kLanes];
}

}  // namespace graspless::mechanics
