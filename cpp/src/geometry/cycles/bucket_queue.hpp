// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace graspless::geometry {

/// A monotone priority queue for Dijkstra's algorithm: buckets of equal width, of which only the
/// lowest is sorted (Dial 1969). Exact. Ties are broken by vertex.
class BucketQueue {
 public:
  struct Item {
    double key;
    int vertex;
  };

  explicit BucketQueue(double width) : per_unit_(width > 0 ? 1 / width : 1) {}

  void clear() {
    for (std::size_t b = first_; b < end_; ++b) buckets_[b].clear();
    first_ = end_ = 0;
    is_sorted_ = false;
  }

  /// `key` must not be less than the last key popped.
  void push(double key, int vertex) {
    const auto b = static_cast<std::size_t>(key * per_unit_);
    if (b >= end_) {
      end_ = b + 1;
      if (end_ > buckets_.size()) buckets_.resize(end_ + end_ / 2);
    }
    std::vector<Item>& bucket = buckets_[b];
    const Item item{key, vertex};
    if (b == first_ && is_sorted_) {
      bucket.insert(std::upper_bound(bucket.begin(), bucket.end(), item, IsLater()), item);
    } else {
      bucket.push_back(item);
    }
  }

  /// Removes the item with the smallest key. Returns false if the queue is empty.
  bool pop(Item& item) {
    while (first_ < end_ && buckets_[first_].empty()) {
      ++first_;
      is_sorted_ = false;
    }
    if (first_ == end_) return false;
    std::vector<Item>& bucket = buckets_[first_];
    if (!is_sorted_) std::sort(bucket.begin(), bucket.end(), IsLater());
    is_sorted_ = true;
    item = bucket.back();
    bucket.pop_back();
    return true;
  }

  /// Vertex that the next pop() probably returns, or -1 if unknown.
  int peek() const {
    return first_ < end_ && !buckets_[first_].empty() ? buckets_[first_].back().vertex : -1;
  }

 private:
  struct IsLater {
    bool operator()(const Item& a, const Item& b) const {
      return a.key > b.key || (a.key == b.key && a.vertex > b.vertex);
    }
  };

  double per_unit_;
  std::vector<std::vector<Item>> buckets_;
  std::size_t first_ = 0, end_ = 0;  // range of the buckets in use
  bool is_sorted_ = false;           // true if the first bucket is sorted, smallest key last
};

}  // namespace graspless::geometry
