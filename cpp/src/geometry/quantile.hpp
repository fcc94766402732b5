// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Quantiles of values in any order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace graspless::geometry {

/// The upper median of the values, at least one. Reorders them.
template <typename T>
T median(std::vector<T>& values) {
  const auto middle = values.begin() + (values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The largest of the values, at least one, that at most a share of the others are below.
template <typename T>
T quantile(std::vector<T> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace graspless::geometry
