// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/watch.hpp"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace graspless {
namespace {

constexpr std::int64_t kInterval = 3'000'000;  // between checks [ns]
constexpr double kSmall = 1e6;                 // memory that is not worth a check [bytes]

thread_local Watch* innermost = nullptr;
thread_local std::int64_t next_check = 0;
thread_local double announced = 0;  // [bytes]

std::function<void()>& default_check() {
  static std::function<void()> check;
  return check;
}

std::function<void()>& sleep() {
  static std::function<void()> sleep = [] {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  };
  return sleep;
}

/// Some milliseconds coarse where the system offers that: a fifth of the cost of the fine clock.
std::int64_t nanoseconds() {
#ifdef CLOCK_MONOTONIC_COARSE
  timespec now;
  clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
#else
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
#endif
}

}  // namespace

Watch::Watch(std::function<void()> check)
    : check_(std::move(check)), outer_(std::exchange(innermost, this)) {}

Watch::~Watch() { innermost = outer_; }

void poll() {
  const std::int64_t now = nanoseconds();
  if (now < next_check) return;
  next_check = now + kInterval;
  for (const Watch* watch = innermost; watch != nullptr; watch = watch->outer_) watch->check_();
  if (innermost == nullptr && default_check()) default_check()();
}

void announce_memory(double bytes) {
  if (bytes < kSmall) return;
  struct Announcement {
    explicit Announcement(double bytes) { announced = bytes; }
    ~Announcement() { announced = 0; }
  } const announcement(bytes);
  next_check = 0;
  poll();
}

void wait_briefly() {
  sleep()();
  poll();
}

void set_sleep(std::function<void()> other) { sleep() = std::move(other); }

double announced_memory() { return announced; }

void set_default_check(std::function<void()> check) { default_check() = std::move(check); }

double resident_memory() {
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  char text[64] = {};
  const auto size = read(file, text, sizeof(text) - 1);
  close(file);
  long long total = 0, resident = 0;
  if (size <= 0 || std::sscanf(text, "%lld %lld", &total, &resident) != 2) return 0;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace graspless
