// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/hand.hpp"

#include "clasp/free_space/free_space.hpp"

namespace graspless::clasp {

/// The hand closes until contact: joints of the hand in turn, 0.01 rad towards the closed state
/// each, until none can move on without touching anything. The rows from q on, at most 0.05 rad
/// apart, every one free; the last is where one more step of any joint would touch or leave the
/// limits.
GRASPLESS_API std::vector<Eigen::VectorXd> close_hand(FreeSpace& space, const robot::Robot& robot,
                                                      const Hand& hand, const Eigen::VectorXd& q);

}  // namespace graspless::clasp
