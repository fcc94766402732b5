// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops of bounds, eight numbers at a time.
#pragma once

namespace graspless::fingertip {

constexpr int kStep = 8;        // sizes and strides are multiples of it
constexpr float kFree = 1e30F;  // more than any sum

/// The least entry of the sum of rows of `size` entries.
float least_sum(const float* const* rows, int count, int size);

/// The greatest w . y over edges w (6 numbers each) or 0, of kStep functionals y whose components
/// are `stride` apart.
void greatest_of_edges(const float* edges, int count, const float* y, int stride, float* h);

/// The same of one functional; components of the edges are `stride` apart.
float greatest_of_edges(const float* components, int stride, const float* y);

}  // namespace graspless::fingertip
