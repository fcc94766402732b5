// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/annotation.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "geometry/cycles/shortest_paths.hpp"
#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

/// A sum of distinct symbols over Z_2, ascending.
using Symbols = std::vector<int>;

Symbols sum(const Symbols& a, const Symbols& b) {
  Symbols c;
  c.reserve(a.size() + b.size());
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(c));
  return c;
}

/// Propagates labels from edge to edge over the triangles: the labels of a triangle's edges must
/// sum to zero. Edges of a forest of shortest paths have label zero. An edge that no triangle
/// determines gets a new symbol, in order of the length of the cycle it closes in the forest. With
/// this order few symbols turn out to be redundant.
class LabelPropagation {
 public:
  LabelPropagation(const Complex& complex, const EdgeGraph& graph) : graph_(graph) {
    list_triangles(complex);
    known_.assign(graph.num_edges(), Known::no);
    value_.resize(known_.size());
    grow_forest();
    for (const int edge : by_cycle_length()) {
      if (known_[edge] != Known::no) continue;
      assign(edge, {num_symbols_++});
      propagate();
    }
  }

  int num_symbols() const { return num_symbols_; }
  const std::vector<Symbols>& values() const { return value_; }
  const std::vector<Symbols>& relations() const { return relations_; }

 private:
  void list_triangles(const Complex& complex) {
    triangles_.resize(complex.triangles.cols());
    first_.assign(graph_.num_edges() + 1, 0);
    std::vector<int> edge_to(graph_.num_vertices());
    int first = -1;
    Pulse pulse;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      pulse();
      const auto corner = complex.triangles.col(t);
      if (corner[0] != first) {  // triangles with the same first corner follow each other
        first = corner[0];
        for (const EdgeGraph::Arc& arc : graph_.arcs(first)) edge_to[arc.to] = arc.edge;
      }
      triangles_[t] = {edge_to[corner[1]], edge_to[corner[2]], graph_.edge(corner[1], corner[2])};
      for (const int edge : triangles_[t]) ++first_[edge + 1];
    }
    for (std::size_t e = 1; e < first_.size(); ++e) first_[e] += first_[e - 1];
    std::vector<int> next(first_.begin(), first_.end() - 1);
    cofaces_.resize(3 * triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (const int edge : triangles_[t]) cofaces_[next[edge]++] = static_cast<int>(t);
    }
  }

  void grow_forest() {
    ShortestPaths paths(graph_);
    depth_.assign(graph_.num_vertices(), -1);
    for (int root = 0; root < graph_.num_vertices(); ++root) {
      if (depth_[root] >= 0) continue;
      paths.start(root, std::numeric_limits<double>::infinity());
      Pulse pulse;
      for (int v = root; (v = paths.next()) >= 0;) {
        pulse();
        depth_[v] = paths.distance(v);
        paths.expand(v);
        if (paths.via(v) >= 0) assign(paths.via(v), {});
      }
    }
    propagate();
  }

  /// Edges without a label, in order of the length of the cycle they close in the forest.
  std::vector<int> by_cycle_length() const {
    std::vector<std::pair<double, int>> order;
    Pulse pulse;
    for (int e = 0; e < graph_.num_edges(); ++e) {
      pulse();
      const auto [a, b] = graph_.ends(e);
      if (known_[e] == Known::no) order.emplace_back(depth_[a] + depth_[b] + graph_.length(e), e);
    }
    std::sort(order.begin(), order.end());
    std::vector<int> edges;
    for (const auto& [length, edge] : order) edges.push_back(edge);
    return edges;
  }

  void assign(int edge, Symbols value) {
    known_[edge] = value.empty() ? Known::zero : Known::value;
    if (!value.empty()) value_[edge] = std::move(value);
    queue_.push_back(edge);
  }

  void propagate() {
    Pulse pulse;
    while (!queue_.empty()) {
      pulse();
      const int edge = queue_.back();
      queue_.pop_back();
      for (int i = first_[edge]; i < first_[edge + 1]; ++i) visit(triangles_[cofaces_[i]]);
    }
  }

  void visit(const std::array<int, 3>& edges) {
    int unknown = -1, num_unknown = 0;
    bool is_empty = true;
    for (const int edge : edges) {
      if (known_[edge] == Known::no) {
        unknown = edge;
        ++num_unknown;
      } else {
        is_empty = is_empty && known_[edge] == Known::zero;
      }
    }
    if (num_unknown > 1 || (num_unknown == 0 && is_empty)) return;
    Symbols total;
    for (const int edge : edges) {
      if (known_[edge] == Known::value) total = sum(total, value_[edge]);
    }
    if (num_unknown == 1) {
      assign(unknown, std::move(total));
    } else if (!total.empty()) {
      relations_.push_back(std::move(total));
    }
  }

  const EdgeGraph& graph_;
  std::vector<std::array<int, 3>> triangles_;  // edges of each triangle
  std::vector<int> first_, cofaces_;           // triangles of each edge
  std::vector<double> depth_;                  // distance of each vertex to its root [m]
  enum class Known : char { no, zero, value };
  std::vector<Known> known_;
  std::vector<Symbols> value_, relations_;
  std::vector<int> queue_;
  int num_symbols_ = 0;
};

/// Relations between symbols in reduced form: each eliminates its last symbol, which occurs in no
/// other relation.
class Relations {
 public:
  explicit Relations(const std::vector<Symbols>& relations) {
    Pulse pulse;
    for (const Symbols& relation : relations) {
      pulse();
      Symbols rest = reduced(relation);
      if (rest.empty()) continue;
      const int pivot = rest.back();
      for (auto& [other, row] : rows_) {
        if (std::binary_search(row.begin(), row.end(), pivot)) row = sum(row, rest);
      }
      rows_.emplace(pivot, std::move(rest));
    }
  }
  bool eliminates(int symbol) const { return rows_.count(symbol) > 0; }
  int size() const { return static_cast<int>(rows_.size()); }
  Symbols reduced(Symbols value) const {
    const Symbols given = value;
    for (const int symbol : given) {
      const auto row = rows_.find(symbol);
      if (row != rows_.end()) value = sum(value, row->second);
    }
    return value;
  }

 private:
  std::map<int, Symbols> rows_;
};

}  // namespace

Annotation::Annotation(const Complex& complex, const EdgeGraph& graph) {
  const LabelPropagation labels(complex, graph);
  const Relations relations(labels.relations());
  num_classes_ = labels.num_symbols() - relations.size();
  words_ = std::max(1, (num_classes_ + 63) / 64);
  std::vector<int> bit(labels.num_symbols(), -1);
  int next = 0;
  for (int symbol = 0; symbol < labels.num_symbols(); ++symbol) {
    if (!relations.eliminates(symbol)) bit[symbol] = next++;
  }
  bits_.assign(labels.values().size() * static_cast<std::size_t>(words_), 0);
  Pulse pulse;
  for (std::size_t e = 0; e < labels.values().size(); ++e) {
    pulse();
    if (labels.values()[e].empty()) continue;
    for (const int symbol : relations.reduced(labels.values()[e])) {
      const auto b = static_cast<std::size_t>(bit[symbol]);
      bits_[e * static_cast<std::size_t>(words_) + b / 64] |= Word{1} << (b % 64);
    }
  }
  find_zeros();
}

void Annotation::find_zeros() {
  is_zero_.resize(bits_.size() / static_cast<std::size_t>(words_));
  for (std::size_t e = 0; e < is_zero_.size(); ++e) {
    const Word* label = of(static_cast<int>(e));
    is_zero_[e] = std::all_of(label, label + words_, [](Word word) { return word == 0; });
  }
}

}  // namespace graspless::geometry
