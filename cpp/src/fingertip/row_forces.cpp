// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces of rows, which do not depend on each other.
#include "fingertip/row_forces.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "graspless/watch.hpp"

#include "mechanics/equilibrium/springs.hpp"

namespace graspless::fingertip {
namespace {

RowForces forces_of(const RowContacts& row, const Options& options, const mechanics::Yield& yield) {
  const auto& [set, best] = row;
  const auto& directions = options.disturbance_directions;
  RowForces forces;
  const auto springs = mechanics::sprung_along(set, best.modes, options.compliance, directions);
  forces.nominal =
      mechanics::compliant_equilibrium(set, best.modes, best.stability.commanded_forces, springs);
  if (!forces.nominal) return forces;
  forces.compliant_stability = mechanics::compliant_stability(set, *forces.nominal, springs);
  forces.promise = mechanics::promise(set, best.modes, *forces.nominal, options.compliance, yield,
                                      directions, springs);
  return forces;
}

/// Rows that threads take one by one. The first exception ends all.
class Shared {
 public:
  Shared(const std::vector<RowContacts>& rows, const Options& options,
         const mechanics::Yield& yield)
      : rows_(rows), options_(options), yield_(yield), forces_(rows.size()) {}

  void help() {
    const Watch watch([this] {
      if (failed_) throw Stop{};
    });
    take();
  }

  void take() {
    try {
      for (std::size_t i = next_++; i < rows_.size() && !failed_; i = next_++) {
        poll();
        forces_[i] = forces_of(rows_[i], options_, yield_);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failed_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  /// When all threads have ended.
  std::vector<RowForces> result() {
    if (failure_) std::rethrow_exception(failure_);
    return std::move(forces_);
  }

 private:
  const std::vector<RowContacts>& rows_;
  const Options& options_;
  const mechanics::Yield& yield_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<RowForces> forces_;
};

}  // namespace

std::vector<RowForces> forces_of(const std::vector<RowContacts>& rows, const Options& options,
                                 const mechanics::Yield& yield) {
  Shared shared(rows, options, yield);
  std::vector<std::thread> helpers;
  const auto threads = std::min(static_cast<std::size_t>(options.threads), rows.size());
  for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back([&] { shared.help(); });
  shared.take();
  for (std::thread& helper : helpers) helper.join();
  return shared.result();
}

}  // namespace graspless::fingertip
