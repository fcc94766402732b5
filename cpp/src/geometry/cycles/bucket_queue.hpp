// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace graspless::geometry {

/// A monotone priority queue for Dijkstra's algorithm: buckets of equal width, of which only the
/// lowest is sorted (Dial 1969). Exact. Ties are broken by vertex.
///
/// The items of a bucket are a linked list, and places are used again at once. So a push touches
/// little memory, and most of it lately.
class BucketQueue {
 public:
  struct Item {
    double key;
    int vertex;
  };

  explicit BucketQueue(double width) : per_unit_(width > 0 ? 1 / width : 1) {}

  void clear() {
    for (std::size_t b = first_; b < end_; ++b) heads_[b] = kNone;
    lowest_.clear();
    entries_.clear();
    free_ = kNone;
    first_ = end_ = 0;
    is_sorted_ = false;
  }

  /// `key` must not be less than the last key popped.
  void push(double key, int vertex) {
    const auto b = static_cast<std::size_t>(key * per_unit_);
    const Item item{key, vertex};
    if (b == first_ && is_sorted_) {
      lowest_.insert(std::upper_bound(lowest_.begin(), lowest_.end(), item, IsLater()), item);
      return;
    }
    if (b >= end_) {
      end_ = b + 1;
      if (end_ > heads_.size()) heads_.resize(end_ + end_ / 2, kNone);
    }
    const int place = free_place();
    entries_[place] = {item, heads_[b]};
    heads_[b] = place;
  }

  /// Removes the item with the smallest key. Returns false if the queue is empty.
  bool pop(Item& item) {
    if (lowest_.empty() && !next_bucket()) return false;
    item = lowest_.back();
    lowest_.pop_back();
    return true;
  }

  /// Vertex that the next pop() probably returns, or -1 if unknown.
  int peek() const { return lowest_.empty() ? -1 : lowest_.back().vertex; }

 private:
  static constexpr int kNone = -1;
  struct Entry {
    Item item;
    int next;
  };
  struct IsLater {
    bool operator()(const Item& a, const Item& b) const {
      return a.key > b.key || (a.key == b.key && a.vertex > b.vertex);
    }
  };

  int free_place() {
    if (free_ == kNone) {
      entries_.emplace_back();
      return static_cast<int>(entries_.size()) - 1;
    }
    const int place = free_;
    free_ = entries_[place].next;
    return place;
  }

  /// Takes and sorts the items of the next bucket that has any. Returns false if there is none.
  bool next_bucket() {
    while (first_ < end_ && heads_[first_] == kNone) ++first_;
    is_sorted_ = first_ < end_;
    if (!is_sorted_) return false;
    for (int place = heads_[first_]; place != kNone;) {
      Entry& entry = entries_[place];
      lowest_.push_back(entry.item);
      const int next = entry.next;
      entry.next = free_;
      free_ = place;
      place = next;
    }
    heads_[first_] = kNone;
    if (lowest_.size() > 1) std::sort(lowest_.begin(), lowest_.end(), IsLater());
    return true;
  }

  double per_unit_;
  std::vector<int> heads_;      // per bucket: place of an item, or none
  std::vector<Entry> entries_;  // each with the place of the next one
  int free_ = kNone;            // first place without an item
  std::vector<Item> lowest_;    // items of the first bucket, if it is sorted: smallest key last
  std::size_t first_ = 0, end_ = 0;  // range of the buckets in use
  bool is_sorted_ = false;
};

}  // namespace graspless::geometry
