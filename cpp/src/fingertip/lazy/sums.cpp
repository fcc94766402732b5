// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops of bounds, eight numbers at a time.
#include <algorithm>
#include <cstring>

#include "fingertip/lazy/bounds.hpp"
#include "geometry/simd.hpp"

namespace graspless::fingertip {

namespace {

// What the compiler keeps in as many registers as it takes.
typedef float Eight __attribute__((vector_size(kStep * sizeof(float))));

}  // namespace

GRASPLESS_SIMD float least_sum(const float* const* rows, int count, int size) {
  Eight least = Eight{} + kFree;
  for (int i = 0; i < size; i += kStep) {
    Eight sum, more;
    std::memcpy(&sum, rows[0] + i, sizeof(Eight));
    for (int r = 1; r < count; ++r) {
      std::memcpy(&more, rows[r] + i, sizeof(Eight));
      sum += more;
    }
    least = sum < least ? sum : least;
  }
  float all[kStep];
  std::memcpy(all, &least, sizeof(Eight));
  for (int k = 4; k > 0; k /= 2) {
    for (int i = 0; i < k; ++i) all[i] = all[i + k] < all[i] ? all[i + k] : all[i];
  }
  return all[0];
}

GRASPLESS_SIMD void greatest_of_edges(const float* edges, int count, const float* y, int stride,
                                      float* h) {
  Eight component[6];
  for (int c = 0; c < 6; ++c) std::memcpy(&component[c], y + c * stride, sizeof(Eight));
  Eight most = Eight{};
  for (int j = 0; j < count; ++j, edges += 6) {
    const Eight sum = (edges[0] * component[0] + edges[1] * component[1]) +
                      (edges[2] * component[2] + edges[3] * component[3]) +
                      (edges[4] * component[4] + edges[5] * component[5]);
    most = sum > most ? sum : most;
  }
  std::memcpy(h, &most, sizeof(Eight));
}

GRASPLESS_SIMD float greatest_of_edges(const float* components, int stride, const float* y) {
  Eight most = Eight{}, edges;
  for (int j = 0; j < stride; j += kStep) {
    Eight sum = Eight{};
    for (int c = 0; c < 6; ++c) {
      std::memcpy(&edges, components + c * stride + j, sizeof(Eight));
      sum += y[c] * edges;
    }
    most = sum > most ? sum : most;
  }
  float all[kStep];
  std::memcpy(all, &most, sizeof(Eight));
  return *std::max_element(all, all + kStep);
}

}  // namespace graspless::fingertip
