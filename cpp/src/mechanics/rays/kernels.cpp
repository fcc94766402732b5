// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inner loops of a ray shot. They are compiled twice, and processors with AVX2 and FMA take the
// wider version. So the last bits may differ from machine to machine.
#include "mechanics/rays/kernels.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/simd.hpp"

namespace graspless::mechanics::kernels {
namespace {

template <int K>
GRASPLESS_INLINE void multiply_by(const double* X, const double* b, double* values) {
  double sum[K] = {};
  for (int k = 0; k < K; ++k) {
    for (int i = 0; i < K; ++i) sum[i] += X[k * K + i] * b[k];
  }
  for (int i = 0; i < K; ++i) values[i] = sum[i];
}

template <int K>
GRASPLESS_INLINE int most_against_of(const Inverse& X, const double* b, double allowed) {
  double distance[K];
  multiply_by<K>(X.columns, b, distance);
  for (int i = 0; i < K; ++i) {
    const double value = distance[i] < 0 ? distance[i] : 0;
    distance[i] = value * value * X.per_square[i];
  }
  int r = -1;
  for (int i = 0; i < K; ++i) {
    if (distance[i] <= allowed) continue;
    allowed = distance[i];
    r = i;
  }
  return r;
}

template <int K>
GRASPLESS_INLINE void exchange_in(const Inverse& X, const double* entering, int r) {
  double column[K], square[K] = {};
  multiply_by<K>(X.columns, entering, column);
  const double pivot = 1 / column[r];
  column[r] -= 1;
  for (int k = 0; k < K; ++k) {
    double* x = X.columns + k * K;
    const double factor = x[r] * pivot;
    for (int i = 0; i < K; ++i) {
      x[i] -= factor * column[i];
      square[i] += x[i] * x[i];
    }
  }
  for (int i = 0; i < K; ++i) X.per_square[i] = 1 / (square[i] > 0 ? square[i] : 1);
}

template <int K>
GRASPLESS_INLINE void slacks_of(const Inverse& X, const double* origin, double z,
                                const double* blocks, int count, double* slack) {
  double base[K], step[6][K];
  multiply_by<K>(X.columns, origin, base);
  for (int r = 0; r < K; ++r) {
    const double scale = std::sqrt(X.per_square[r]);
    base[r] *= scale;
    for (int i = 0; i < 6; ++i) step[i][r] = z * scale * X.columns[i * K + r];
  }
  for (int block = 0; block < count; ++block) {
    const double* l = blocks + block * 6 * kLanes;
    double least[kLanes] = {};
    for (int r = 0; r < K; ++r) {
      double value[kLanes];
      for (int d = 0; d < kLanes; ++d) value[d] = base[r];
      for (int i = 0; i < 6; ++i) {
        for (int d = 0; d < kLanes; ++d) value[d] += step[i][r] * l[i * kLanes + d];
      }
      for (int d = 0; d < kLanes; ++d) least[d] = value[d] < least[d] ? value[d] : least[d];
    }
    for (int d = 0; d < kLanes; ++d) slack[block * kLanes + d] = least[d];
  }
}

}  // namespace

GRASPLESS_SIMD void multiply(const Inverse& X, const double* b, double* values) {
  X.K == 8 ? multiply_by<8>(X.columns, b, values) : multiply_by<12>(X.columns, b, values);
}

GRASPLESS_SIMD int most_against(const Inverse& X, const double* b, double allowed) {
  return X.K == 8 ? most_against_of<8>(X, b, allowed) : most_against_of<12>(X, b, allowed);
}

GRASPLESS_SIMD void exchange(const Inverse& X, const double* entering, int r) {
  X.K == 8 ? exchange_in<8>(X, entering, r) : exchange_in<12>(X, entering, r);
}

GRASPLESS_SIMD int least_price(const double* rho, const double* blocks, const int* finger_row,
                               int count, double below) {
  double least[kLanes], found[kLanes];
  for (int j = 0; j < kLanes; ++j) {
    least[j] = below;
    found[j] = -1;
  }
  for (int block = 0; block < count; ++block) {
    const double* a = blocks + block * kBlock;
    const double finger = rho[finger_row[block]];
    double price[kLanes];
    for (int j = 0; j < kLanes; ++j) price[j] = finger * a[6 * kLanes + j];
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < kLanes; ++j) price[j] += rho[i] * a[i * kLanes + j];
    }
    const double here = block;
    for (int j = 0; j < kLanes; ++j) {
      found[j] = price[j] < least[j] ? here : found[j];
      least[j] = price[j] < least[j] ? price[j] : least[j];
    }
  }
  int best = -1;
  for (int j = 0; j < kLanes; ++j) {
    if (least[j] >= below) continue;
    below = least[j];
    best = static_cast<int>(found[j]) * kLanes + j;
  }
  return best;
}

GRASPLESS_SIMD void slacks(const Inverse& X, const double* origin, double z, const double* blocks,
                           int count, double* slack) {
  X.K == 8 ? slacks_of<8>(X, origin, z, blocks, count, slack)
           : slacks_of<12>(X, origin, z, blocks, count, slack);
}

}  // namespace graspless::mechanics::kernels
