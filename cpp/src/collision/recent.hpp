// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <list>
#include <mutex>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace graspless::collision {

/// Values that were asked for last, as long as their sizes have a sum of at most `most`.
/// Thread-safe.
template <class Key, class Value>
class Recent {
 public:
  explicit Recent(Eigen::Index most) : most_(most) {}

  /// The value whose key passes `is_it`.
  template <class IsIt>
  std::optional<Value> find(const IsIt& is_it) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& entry) { return is_it(entry.key); });
    if (found == entries_.end()) return std::nullopt;
    entries_.splice(entries_.begin(), entries_, found);
    return found->value;
  }

  void add(Key key, const Value& value, Eigen::Index size) {
    if (size > most_) return;
    std::list<Entry> added, old;  // made and destroyed while others can ask
    added.push_back({std::move(key), value, size});
    const std::lock_guard lock(mutex_);
    entries_.splice(entries_.begin(), added);
    for (count_ += size; count_ > most_; count_ -= old.front().size)
      old.splice(old.begin(), entries_, std::prev(entries_.end()));
  }

 private:
  struct Entry {
    Key key;
    Value value;
    Eigen::Index size;
  };
  std::mutex mutex_;
  std::list<Entry> entries_;  // the last one first
  Eigen::Index most_, count_ = 0;
};

}  // namespace graspless::collision
