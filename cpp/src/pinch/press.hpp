// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "graspless/pinch/pinch.hpp"

#include "pinch/jaw.hpp"

namespace graspless::pinch {

/// Force with which each finger presses: options.grip_force, or that of half the effort limits of
/// the joints that close the hand, by virtual work.
class Press {
 public:
  Press(const Problem& problem, const Options& options, const Jaw& jaw);

  /// Force at a distance of the fingers [N].
  double at(double width) const;
  /// A joint that closes the hand and whose effort nobody knows; empty if there is none.
  const std::string& unknown() const { return unknown_; }

 private:
  static constexpr std::size_t kSamples = 9;
  std::array<double, kSamples> gaps_{}, forces_{};  // from open to closed
  std::string unknown_;
};

}  // namespace graspless::pinch
