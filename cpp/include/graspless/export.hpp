// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks what the shared library shows; everything else stays hidden (docs/architecture.md says
/// why).
#define GRASPLESS_API __attribute__((visibility("default")))
