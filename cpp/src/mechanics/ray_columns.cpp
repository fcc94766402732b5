// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The columns of the balance, side by side for pricing.
#include <algorithm>

#include "mechanics/ray_basis.hpp"

namespace graspless::mechanics {
namespace {

void copy(const Matrix6Xd& generators, int first, int stride, double* table) {
  for (int j = 0; j < static_cast<int>(generators.cols()); ++j) {
    for (int i = 0; i < 6; ++i) table[i * stride + first + j] = generators(i, j);
  }
}

}  // namespace

void Columns::assign(const EnvironmentWrenches& environment,
                     const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  const int n = static_cast<int>(fingers.size());
  rows_ = 6 + n;
  count_ = static_cast<int>(environment.generators.cols());
  for (const FingerWrenches* finger : fingers)
    count_ += static_cast<int>(finger->normal.size()) + 1;
  stride_ = (count_ + 7) / 8 * 8;
  table_.assign(static_cast<std::size_t>(rows_ * stride_), 0.0);
  copy(environment.generators, 0, stride_, table_.data());
  int next = static_cast<int>(environment.generators.cols());
  for (int i = 0; i < n; ++i) {
    const FingerWrenches& finger = *fingers[static_cast<std::size_t>(i)];
    const int edges = static_cast<int>(finger.normal.size());
    copy(finger.generators, next, stride_, table_.data());
    double* normals = &table_[static_cast<std::size_t>((6 + i) * stride_)];
    std::copy_n(finger.normal.data(), edges, normals + next);
    const bool passive = (force >> i & 1U) == 0;
    slack_[static_cast<std::size_t>(i)] = passive ? next + edges : -1;
    if (passive) normals[next + edges] = 1;
    blocks_[static_cast<std::size_t>(i)] = {next, next + edges + (passive ? 1 : 0), 6 + i};
    next += edges + (passive ? 1 : 0);
  }
  count_ = next;
}

void Columns::price(const double* rho, double* prices) const {
  const double* row = table_.data();
  for (int j = 0; j < stride_; ++j) prices[j] = rho[0] * row[j];
  for (int i = 1; i < 6; ++i) {
    row += stride_;
    for (int j = 0; j < stride_; ++j) prices[j] += rho[i] * row[j];
  }
  for (int i = 6; i < rows_; ++i) {
    const Block& block = blocks_[static_cast<std::size_t>(i - 6)];
    row += stride_;
    for (int j = block.first; j < block.last; ++j) prices[j] += rho[i] * row[j];
  }
}

}  // namespace graspless::mechanics
