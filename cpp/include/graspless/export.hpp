// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Marks what the shared library shows; everything else stays hidden (docs/architecture.md says
/// why).
#define GRASPLESS_API __attribute__((visibility("default")))

// Eigen's matrices have another layout, and memory that only they can free, where a program is
// compiled for wider registers than the library. Such a program would crash.
#ifdef GRASPLESS_EIGEN_ALIGN_BYTES  // of an installed library, from its CMake target
static_assert(EIGEN_DEFAULT_ALIGN_BYTES == GRASPLESS_EIGEN_ALIGN_BYTES &&
                  EIGEN_MAX_STATIC_ALIGN_BYTES == GRASPLESS_EIGEN_ALIGN_BYTES,
              "Eigen aligns matrices otherwise here than in the graspless library: compile both "
              "with the same -m flags (-march=native, -mavx) and the same macros of Eigen");
#endif
