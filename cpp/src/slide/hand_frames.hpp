// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/slide/problem.hpp"

namespace graspless::slide {

/// Throws std::invalid_argument that names the frame if F or H of the hand is not oriented as
/// docs/notation.md requires.
void check_hand_frames(const Problem& problem);

}  // namespace graspless::slide
