// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads that share the work of one call.
#include "crew.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

#include "graspless/watch.hpp"

namespace graspless {
namespace {

// Jobs follow each other within tens of microseconds: worth staying awake for.
constexpr auto kAwake = std::chrono::microseconds(1000);

}  // namespace

Crew::Crew(int threads) {
  threads_.reserve(std::max(0, threads - 1));
  try {
    for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // The system allows no more threads: fewer do the same work.
  }
}

Crew::~Crew() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    ++posted_;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::start(Job& job) {
  if (threads_.empty()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back(&job);
    ++posted_;
  }
  wake_.notify_all();
}

void Crew::finish(Job& job) {
  take(job);
  end(job);
  if (job.failure) std::rethrow_exception(job.failure);
}

void Crew::cancel(Job& job) {
  job.has_ended = true;
  end(job);
}

void Crew::share(std::size_t count, const std::function<void(std::size_t)>& item) {
  Job job(count, item);
  start(job);
  finish(job);
}

/// Waits for the helpers of a job. No other can come to it.
void Crew::end(Job& job) {
  if (threads_.empty()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.erase(std::remove(jobs_.begin(), jobs_.end(), &job), jobs_.end());
  }
  while (job.helpers > 0) std::this_thread::yield();
}

void Crew::help() {
  const Job* current = nullptr;
  const Watch watch([&current] {
    if (current != nullptr && current->has_ended) throw Stop{};
  });
  int seen = 0;
  while (true) {
    const auto until = std::chrono::steady_clock::now() + kAwake;
    while (posted_ == seen && std::chrono::steady_clock::now() < until) std::this_thread::yield();
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait(lock, [&] { return posted_ != seen; });
    seen = posted_;
    if (stop_) return;
    while (Job* job = open_job()) {
      current = job;
      ++job->helpers;
      lock.unlock();
      take(*job);
      current = nullptr;
      --job->helpers;  // the job may be gone now
      lock.lock();
    }
  }
}

/// The newest job with an item that no thread has taken: its thread waits for it.
Crew::Job* Crew::open_job() const {
  for (auto job = jobs_.rbegin(); job != jobs_.rend(); ++job) {
    if ((*job)->next < (*job)->count && !(*job)->has_ended) return *job;
  }
  return nullptr;
}

void Crew::take(Job& job) {
  try {
    for (std::size_t i = job.next++; i < job.count && !job.has_ended; i = job.next++) job.item(i);
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!job.failure) job.failure = std::current_exception();
    job.has_ended = true;
  }
}

}  // namespace graspless
