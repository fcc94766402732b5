// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Before a function: compiled for wider registers too (AVX2, FMA); the loader takes what the
/// machine has, so that last bits may differ from machine to machine.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(__SANITIZE_ADDRESS__)
#define GRASPLESS_WIDE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define GRASPLESS_WIDE
#endif
