// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads that share the work of one call. Every room may include this header.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace graspless {

/// Shares items among the thread that made it and its helpers. Results must not depend on the
/// thread that takes an item.
class Crew {
 public:
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Items 0 to count - 1, each taken by one thread. The first exception ends the rest.
  struct Job {
    Job(std::size_t count_in, std::function<void(std::size_t)> item_in)
        : count(count_in), item(std::move(item_in)) {}
    const std::size_t count;
    const std::function<void(std::size_t)> item;
    std::atomic<bool> has_ended{false};

   private:
    friend class Crew;
    std::atomic<std::size_t> next{0};
    std::atomic<int> helpers{0};
    std::exception_ptr failure;
  };

  /// Lets the helpers begin. The job must stay until finish() or cancel().
  void start(Job& job);
  /// Takes the items that are left, waits for those of the helpers, and throws what one has thrown.
  void finish(Job& job);
  /// Leaves the rest of the items, and waits for those that helpers have begun.
  void cancel(Job& job);
  /// Does a whole job.
  void share(std::size_t count, const std::function<void(std::size_t)>& item);

 private:
  void help();
  void take(Job& job);
  void end(Job& job);
  Job* open_job() const;

  std::vector<std::thread> threads_;
  std::vector<Job*> jobs_;
  std::mutex mutex_;  // of jobs_ and failures
  std::condition_variable wake_;
  std::atomic<int> posted_{0};
  bool stop_ = false;
};

/// Things that one thread at a time works with. One more is made where all are in use.
template <class Thing>
class Spares {
 public:
  using Make = std::function<std::unique_ptr<Thing>()>;
  explicit Spares(Make make) : make_(std::move(make)) {}

  /// Makes things until there are `count`, while none is in use.
  void stock(std::size_t count) {
    while (idle_.size() < count) idle_.push_back(make_());
  }

  /// Calls `work` with a thing that no other thread uses.
  template <class Work>
  auto lend(const Work& work) {
    std::unique_ptr<Thing> thing = take();
    auto result = work(*thing);
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(thing));
    return result;
  }

 private:
  std::unique_ptr<Thing> take() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Thing> thing = std::move(idle_.back());
        idle_.pop_back();
        return thing;
      }
    }
    return make_();
  }

  const Make make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Thing>> idle_;
};

}  // namespace graspless
