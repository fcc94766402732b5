// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/complex/reduction.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

void push(std::vector<int>& heap, int edge) {
  heap.push_back(edge);
  std::push_heap(heap.begin(), heap.end());
}

int pop(std::vector<int>& heap) {
  std::pop_heap(heap.begin(), heap.end());
  const int top = heap.back();
  heap.pop_back();
  return top;
}

/// Removes and returns the longest edge of a sum over Z_2, or -1 if the sum is empty. Edges that
/// occur twice cancel.
int pop_pivot(std::vector<int>& heap) {
  while (!heap.empty()) {
    const int top = pop(heap);
    if (heap.empty() || heap.front() != top) return top;
    pop(heap);
  }
  return -1;
}

}  // namespace

Reduction::Reduction(Ranking ranking) : ranking_(std::move(ranking)) {
  columns_.resize(ranking_.lengths.size());
  entries_.reserve(4 * ranking_.lengths.size());
  Pulse pulse;
  for (std::size_t t = 0; t < ranking_.triangles.size(); ++t) {
    pulse();
    if (ranking_.triangles[t].fills_loop) add_column(static_cast<int>(t));
  }
  collect_pairs();
}

void Reduction::add_column(int triangle) {
  const Ranking::Triangle& boundary = ranking_.triangles[triangle];
  Column* column = &columns_[boundary.longest];
  const int begin = static_cast<int>(entries_.size());
  if (column->triangle < 0) {  // first column with this pivot: already reduced
    entries_.insert(entries_.end(), boundary.others.begin(), boundary.others.end());
  } else {
    std::vector<int> heap{boundary.longest, boundary.others[0], boundary.others[1]};
    std::make_heap(heap.begin(), heap.end());
    column = &columns_[reduce(heap, triangle).pivot];
    for (int edge = pop_pivot(heap); edge >= 0; edge = pop_pivot(heap)) entries_.push_back(edge);
  }
  *column = {triangle, begin, static_cast<int>(entries_.size())};
}

Reduction::Remainder Reduction::reduce(std::vector<int>& heap, int end_triangle) const {
  Remainder result{-1, -1};
  Pulse pulse;
  while ((result.pivot = pop_pivot(heap)) >= 0) {
    pulse();
    const Column& column = columns_[result.pivot];
    if (column.triangle < 0 || column.triangle >= end_triangle) break;
    result.last_triangle = std::max(result.last_triangle, column.triangle);
    for (int i = column.begin; i < column.end; ++i) {
      push(heap, entries_[i]);
    }
  }
  return result;
}

void Reduction::collect_pairs() {
  Pulse pulse;
  for (std::size_t pivot = 0; pivot < columns_.size(); ++pivot) {
    pulse();
    if (columns_[pivot].triangle < 0) continue;
    const auto& filling = ranking_.triangles[columns_[pivot].triangle];
    const double birth = ranking_.lengths[pivot];
    const double death = ranking_.lengths[filling.longest];
    if (!(birth < death)) continue;
    pairs_.push_back({birth, death});
    pivots_.push_back(static_cast<int>(pivot));
  }
  std::vector<std::size_t> order(pairs_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    const PersistencePair &a = pairs_[i], &b = pairs_[k];
    return a.death * b.birth > b.death * a.birth;
  });
  const std::vector<PersistencePair> pairs = std::move(pairs_);
  const std::vector<int> pivots = std::move(pivots_);
  pairs_.clear();
  pivots_.clear();
  for (const std::size_t i : order) {
    pairs_.push_back(pairs[i]);
    pivots_.push_back(pivots[i]);
  }
}

Reduction::Ends Reduction::ends(int pair) const {
  const int pivot = pivots_[pair];
  const int column = columns_[pivot].triangle;
  return {pivot, ranking_.triangles[column].simplex};
}

/// An edge that connects two pieces has no label. Any other edge closes the cycle of its reduced
/// column. That cycle is a boundary if its triangle is in K_d, and else the class of its pair.
std::vector<std::uint64_t> Reduction::labels(double max_edge_length,
                                             const std::vector<int>& classes, int words) const {
  const auto end =
      std::lower_bound(ranking_.lengths.begin(), ranking_.lengths.end(), max_edge_length);
  const auto num_edges = static_cast<std::size_t>(end - ranking_.lengths.begin());
  const auto width = static_cast<std::size_t>(words);
  std::vector<std::uint64_t> labels(num_edges * width);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto pivot = static_cast<std::size_t>(pivots_[classes[i]]);
    labels[pivot * width + i / 64] |= std::uint64_t{1} << (i % 64);
  }
  Pulse pulse;
  for (std::size_t e = 0; e < num_edges; ++e) {
    pulse();
    const Column& column = columns_[e];
    for (int i = column.begin; i < column.end; ++i) {
      const auto other = static_cast<std::size_t>(entries_[i]);
      for (std::size_t w = 0; w < width; ++w) labels[e * width + w] ^= labels[other * width + w];
    }
  }
  return labels;
}

PersistencePair Reduction::span(const std::vector<int>& cycle, double max_edge_length) const {
  const auto length = [&](int edge) { return edge < 0 ? 0 : ranking_.lengths[edge]; };
  const auto entered = std::partition_point(ranking_.triangles.begin(), ranking_.triangles.end(),
                                            [&](const Ranking::Triangle& triangle) {
                                              return length(triangle.longest) < max_edge_length;
                                            });
  std::vector<int> heap = cycle;
  std::make_heap(heap.begin(), heap.end());
  const Remainder before = reduce(heap, static_cast<int>(entered - ranking_.triangles.begin()));
  if (before.pivot >= 0) push(heap, before.pivot);
  const Remainder after = reduce(heap, static_cast<int>(ranking_.triangles.size()));
  const int last = before.pivot < 0 ? before.last_triangle : after.last_triangle;
  const double death = last < 0 ? 0 : length(ranking_.triangles[last].longest);
  return {before.pivot < 0 ? death : length(before.pivot), death};
}

}  // namespace graspless::geometry
