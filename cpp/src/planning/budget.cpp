// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/budget.hpp"

#include <cmath>

namespace graspless::planning {
namespace {

constexpr std::chrono::milliseconds kPollInterval{4};
constexpr std::chrono::milliseconds kGrace{15};  // for loops that ask is_out() and end in order
constexpr std::chrono::milliseconds kToConclude{40};
constexpr std::chrono::milliseconds kToConcludeRow{10};  // twenty times what one takes

// Growth that is not held against a query: free lists of the allocator, other threads' small work.
constexpr double kUnnoticed = 20e6;  // [bytes]

}  // namespace

Clock::Clock(const Budget& budget, double max_memory)
    : budget_(budget), max_memory_(max_memory), start_(Steady::now()), next_poll_(start_) {
  require_in_range("budget.", budget);
}

bool Clock::spend() {
  refused_ = iterations_ >= budget_.iterations || is_out();
  if (!refused_) ++iterations_;
  return !refused_;
}

bool Clock::is_out() {
  if (out_since_) return true;
  look_if_due();
  const auto now = Steady::now();
  const bool is_late = std::chrono::duration<double>(now - start_).count() >= budget_.seconds;
  if (is_late || interrupted_ || out_of_memory_) out_since_ = now;
  return out_since_.has_value();
}

void Clock::look_if_due() {
  const auto now = Steady::now();
  if (now < next_poll_ && announced_memory() <= 0) return;
  next_poll_ = now + kPollInterval;
  look();
}

void Clock::look() {
  interrupted_ = budget_.interrupted && budget_.interrupted();
  if (!std::isfinite(max_memory_)) return;
  const double resident = resident_memory();
  if (!memory_at_start_) memory_at_start_ = resident;
  const double taken = resident - *memory_at_start_ + announced_memory();
  out_of_memory_ = taken > max_memory_ + kUnnoticed;
}

void Clock::require() {
  if (!is_out()) return;
  if (concluding_ && !interrupted_ && !out_of_memory_) {  // the time is over, and nothing else
    look_if_due();
    if (interrupted_) out_since_ = Steady::now();
  }
  std::chrono::milliseconds grace = concluding_ ? kToConclude : kGrace;
  if (concluding_ && !interrupted_) {
    grace += kToConcludeRow * static_cast<std::chrono::milliseconds::rep>(*concluding_);
  }
  if (out_of_memory_ || Steady::now() >= *out_since_ + grace) throw Stop{};
}

std::string Clock::reason() const {
  if (interrupted_) return "interrupted before a plan was found";
  if (!out_of_memory_) return "the time was over before the search could begin or end";
  const std::string limit = std::isfinite(max_memory_)
                                ? std::to_string(std::llround(max_memory_ / 1e6)) + " MB"
                                : "the system has";
  return "the search needs more memory than options.max_memory = " + limit;
}

std::string Clock::note() const {
  const bool is_done = refused_ && iterations_ >= budget_.iterations;
  const bool is_late = out_since_ && !interrupted_ && !out_of_memory_ && !is_done;
  return is_late ? "; the time limit ended the search" : "";
}

double Clock::seconds() const {
  return std::chrono::duration<double>(Steady::now() - start_).count();
}

}  // namespace graspless::planning
