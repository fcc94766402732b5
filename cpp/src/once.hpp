// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Locks for long work that may be stopped. Threads that wait for it call poll(), so that they end
// on time as well. Every room may include this header.
#pragma once

#include <atomic>
#include <mutex>

#include "graspless/watch.hpp"

namespace graspless {

/// A mutex whose lock() calls poll() while it waits, and so may throw.
class PolledMutex {
 public:
  void lock() {
    while (!mutex_.try_lock()) wait_briefly();
  }
  void unlock() { mutex_.unlock(); }

 private:
  std::mutex mutex_;
};

/// Work that is done once for all threads. If it throws, the next call does it anew.
class Once {
 public:
  template <typename Work>
  void operator()(const Work& work) {
    if (done_.load(std::memory_order_acquire)) return;
    const std::lock_guard lock(mutex_);
    if (done_.load(std::memory_order_relaxed)) return;
    work();
    done_.store(true, std::memory_order_release);
  }

 private:
  PolledMutex mutex_;
  std::atomic<bool> done_{false};
};

}  // namespace graspless
