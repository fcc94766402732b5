// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/budget.hpp"

namespace graspless::planning {
namespace {

constexpr std::chrono::milliseconds kPollInterval{10};

}  // namespace

Clock::Clock(const Budget& budget) : budget_(budget), start_(Steady::now()), next_poll_(start_) {
  require_in_range("budget.", budget);
}

bool Clock::spend() {
  if (iterations_ >= budget_.iterations || is_out()) return false;
  ++iterations_;
  return true;
}

bool Clock::is_out() {
  if (interrupted_) return true;
  const auto now = Steady::now();
  if (budget_.interrupted && now >= next_poll_) {
    next_poll_ = now + kPollInterval;
    interrupted_ = budget_.interrupted();
  }
  return interrupted_ || std::chrono::duration<double>(now - start_).count() >= budget_.seconds;
}

double Clock::seconds() const {
  return std::chrono::duration<double>(Steady::now() - start_).count();
}

}  // namespace graspless::planning
