// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Stabilities asked for in batches and solved by several threads.
#include "fingertip/lazy/evaluator_pool.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "graspless/watch.hpp"

namespace graspless::fingertip {

namespace {

// Batches follow each other within tens of microseconds: worth staying awake for.
constexpr auto kAwake = std::chrono::microseconds(1000);

}  // namespace

EvaluatorPool::EvaluatorPool(std::vector<Evaluator>& evaluators, int threads)
    : evaluators_(evaluators) {
  const int most = static_cast<int>(evaluators.size());
  for (int i = 1; i < std::min(threads, most); ++i) threads_.emplace_back([this] { help(); });
}

EvaluatorPool::~EvaluatorPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    ++round_;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void EvaluatorPool::start(std::vector<StabilityQuery>& queries) {
  queries_ = &queries;
  next_lane_ = 0;
  cancelled_ = false;
  shared_ = !threads_.empty() && !queries.empty();
  if (!shared_) return;
  busy_ = threads_.size();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++round_;
  }
  wake_.notify_all();
}

void EvaluatorPool::finish() {
  take_lanes();
  while (shared_ && busy_ > 0) std::this_thread::yield();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void EvaluatorPool::cancel() {
  cancelled_ = true;
  while (shared_ && busy_ > 0) std::this_thread::yield();
  failure_ = nullptr;
}

void EvaluatorPool::help() {
  const Watch watch([this] {
    if (cancelled_) throw Stop{};
  });
  int seen = 0;
  while (true) {
    const auto until = std::chrono::steady_clock::now() + kAwake;
    while (round_ == seen && std::chrono::steady_clock::now() < until) std::this_thread::yield();
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [&] { return round_ != seen; });
      seen = round_;
    }
    if (stop_) return;
    take_lanes();
    --busy_;
  }
}

void EvaluatorPool::take_lanes() {
  const std::size_t lanes = std::min(evaluators_.size(), queries_->size());
  for (std::size_t lane = next_lane_++; lane < lanes; lane = next_lane_++) {
    try {
      solve_lane(lane);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      cancelled_ = true;  // the whole batch fails with this query
    }
  }
}

void EvaluatorPool::solve_lane(std::size_t lane) {
  Evaluator& evaluator = evaluators_[lane];
  for (std::size_t i = lane; i < queries_->size() && !cancelled_; i += evaluators_.size()) {
    StabilityQuery& query = (*queries_)[i];
    evaluator.solver().clear_supports();
    query.z = evaluator.stability(query.instant, query.placement, query.needed);
    query.functionals = evaluator.solver().supports();
  }
}

}  // namespace graspless::fingertip
