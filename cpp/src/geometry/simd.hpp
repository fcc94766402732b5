// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Compiles a function twice, for plain x86-64 and for AVX2 with FMA. The loader picks what the
/// machine supports, so the last bits of results may differ between machines. Sanitizers have no
/// runtime yet when the loader picks.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GRASPLESS_SIMD __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define GRASPLESS_SIMD
#endif

/// For the helpers of such a function: they must be compiled into both copies.
#define GRASPLESS_INLINE inline __attribute__((always_inline))
