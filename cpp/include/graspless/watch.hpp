// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cancellation of long work. Every loop whose length a caller's data decide calls poll(). Every
// room may include this header.
#pragma once

#include <functional>

#include "graspless/export.hpp"

namespace graspless {

/// Thrown by a check to end the work. Not a std::exception, so that no handler of errors takes it
/// for one.
struct GRASPLESS_API Stop {};

/// Calls `check` from poll() on the thread that made it, at most every 3 ms, while it lives. The
/// check ends the work by throwing Stop, which plan() passes on. It must not call graspless, whose
/// work may hold a lock. Watches nest: poll() calls the checks of all. The last one that was made
/// must be destroyed first.
class GRASPLESS_API Watch {
 public:
  explicit Watch(std::function<void()> check);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  friend GRASPLESS_API void poll();
  std::function<void()> check_;
  Watch* outer_;
};

/// Calls the checks of this thread's watches when they are due. Costs a few nanoseconds otherwise.
GRASPLESS_API void poll();

/// Calls the checks at once, before work that takes `bytes` of memory in one step. They read the
/// amount from announced_memory(). Ignores less than 1 MB.
GRASPLESS_API void announce_memory(double bytes);
/// Memory that is about to be taken [bytes]; 0 outside the checks that announce_memory() calls.
GRASPLESS_API double announced_memory();

/// Sleeps for a moment, then calls poll(): for loops that wait for another thread.
GRASPLESS_API void wait_briefly();
/// Makes wait_briefly() call `sleep`, for instance to give up a lock that the other thread needs.
/// Must be called before other threads wait.
GRASPLESS_API void set_sleep(std::function<void()> sleep);

/// Makes poll() call `check` on threads without a Watch. Must be called before other threads poll.
GRASPLESS_API void set_default_check(std::function<void()> check);

/// Resident memory of this process [bytes]; 0 where /proc does not exist.
GRASPLESS_API double resident_memory();

}  // namespace graspless
