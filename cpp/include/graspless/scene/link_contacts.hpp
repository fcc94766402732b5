// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// Pairs of links, as frame indices with the smaller first, that need no test for collision.
struct LinkContacts {
  std::vector<std::pair<int, int>> always;  ///< touch in at least 95 % of the configurations
  std::vector<std::pair<int, int>> never;   ///< no contact was found
};

/// Tests the links of a robot against each other, except Robot::ignored_pairs, in random
/// configurations within the joint limits. Half of the configurations are uniform. In the other
/// half, each joint is at one of its limits with a probability of 1/2. The first fiftieth of the
/// samples, but at least 50, decides about pairs that touch; a pair that has been near without
/// contact in 2000 samples is not sampled further. Samples hardly ever show two hands in contact.
/// The distance of a pair that has shown none, with more than three joints between its links, is
/// therefore minimized from twelve configurations. The same seed gives the same result.
/// With `links` (frame indices), only pairs with at least one of them are tested. Throws
/// std::invalid_argument unless 0 < samples <= 10^6 and the links exist.
GRASPLESS_API LinkContacts sample_contacts(const robot::Robot& robot, int samples = 10000,
                                           std::uint64_t seed = 1,
                                           const std::vector<int>& links = {});

}  // namespace graspless::scene
