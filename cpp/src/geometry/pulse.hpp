// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/watch.hpp"

namespace graspless::geometry {

/// Polls once in 256 turns of a loop, where a turn takes nanoseconds and poll() would be much of
/// it.
class Pulse {
 public:
  void operator()() {
    if (++turns_ % 256 == 0) poll();
  }

 private:
  unsigned turns_ = 0;
};

}  // namespace graspless::geometry
