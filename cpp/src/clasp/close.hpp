// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/hand.hpp"

#include "clasp/free_space/free_space.hpp"

namespace graspless::clasp {

/// Closes the hand from q until contact (Stork 2013, Section IV-D). The joints of the hand move in
/// turn by 0.01 rad or 1 mm towards the closed state, until every further step would collide or
/// reach the closed state. Returns collision-free rows from q on, at most 0.05 rad or 5 mm apart in
/// any joint.
GRASPLESS_API std::vector<Eigen::VectorXd> close_hand(FreeSpace& space, const robot::Robot& robot,
                                                      const Hand& hand, const Eigen::VectorXd& q);

}  // namespace graspless::clasp
