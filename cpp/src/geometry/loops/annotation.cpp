// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/annotation.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "geometry/loops/shortest_paths.hpp"

namespace graspless::geometry {
namespace {

/// A sum of symbols over Z_2: those that stand in it, ascending.
using Symbols = std::vector<int>;

Symbols sum(const Symbols& a, const Symbols& b) {
  Symbols c;
  c.reserve(a.size() + b.size());
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(c));
  return c;
}

/// Symbols spread from edge to edge over the triangles, whose sums must be zero. An edge of the
/// forest of shortest paths carries nothing; an edge that no triangle settles gets a new symbol,
/// those with the shortest way round first, so that few symbols turn out to be superfluous.
class Spreading {
 public:
  Spreading(const Complex& complex, const EdgeGraph& graph) : graph_(graph) {
    list_triangles(complex);
    is_known_.assign(static_cast<std::size_t>(graph.num_edges()), 0);
    value_.resize(is_known_.size());
    grow_forest();
    for (const int edge : by_way_round()) {
      if (is_known_[index(edge)]) continue;
      settle(edge, {num_symbols_++});
      spread();
    }
  }

  int num_symbols() const { return num_symbols_; }
  const std::vector<Symbols>& values() const { return value_; }
  const std::vector<Symbols>& relations() const { return relations_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void list_triangles(const Complex& complex) {
    triangles_.resize(index(static_cast<int>(complex.triangles.cols())));
    first_.assign(index(graph_.num_edges()) + 1, 0);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto corner = complex.triangles.col(static_cast<Eigen::Index>(t));
      triangles_[t] = {graph_.edge(corner[0], corner[1]), graph_.edge(corner[0], corner[2]),
                       graph_.edge(corner[1], corner[2])};
      for (const int edge : triangles_[t]) ++first_[index(edge) + 1];
    }
    for (std::size_t e = 1; e < first_.size(); ++e) first_[e] += first_[e - 1];
    std::vector<int> next(first_.begin(), first_.end() - 1);
    cofaces_.resize(3 * triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (const int edge : triangles_[t])
        cofaces_[index(next[index(edge)]++)] = static_cast<int>(t);
    }
  }

  void grow_forest() {
    ShortestPaths paths(graph_);
    depth_.assign(index(graph_.num_vertices()), -1);
    for (int root = 0; root < graph_.num_vertices(); ++root) {
      if (depth_[index(root)] >= 0) continue;
      paths.start(root, std::numeric_limits<double>::infinity());
      for (int v = root; (v = paths.next()) >= 0;) {
        depth_[index(v)] = paths.distance(v);
        paths.expand(v);
        if (paths.via(v) >= 0) settle(paths.via(v), {});
      }
    }
    spread();
  }

  /// The edges not known yet, those with the shortest way round first.
  std::vector<int> by_way_round() const {
    std::vector<std::pair<double, int>> order;
    for (int e = 0; e < graph_.num_edges(); ++e) {
      const auto [a, b] = graph_.ends(e);
      if (!is_known_[index(e)])
        order.emplace_back(depth_[index(a)] + depth_[index(b)] + graph_.length(e), e);
    }
    std::sort(order.begin(), order.end());
    std::vector<int> edges;
    for (const auto& [way, edge] : order) edges.push_back(edge);
    return edges;
  }

  void settle(int edge, Symbols value) {
    is_known_[index(edge)] = 1;
    value_[index(edge)] = std::move(value);
    queue_.push_back(edge);
  }

  void spread() {
    while (!queue_.empty()) {
      const int edge = queue_.back();
      queue_.pop_back();
      for (int i = first_[index(edge)]; i < first_[index(edge) + 1]; ++i)
        look_at(triangles_[index(cofaces_[index(i)])]);
    }
  }

  void look_at(const std::array<int, 3>& edges) {
    int unknown = -1, num_unknown = 0;
    bool is_empty = true;
    for (const int edge : edges) {
      if (!is_known_[index(edge)]) {
        unknown = edge;
        ++num_unknown;
      } else {
        is_empty = is_empty && value_[index(edge)].empty();
      }
    }
    if (num_unknown > 1 || (num_unknown == 0 && is_empty)) return;
    Symbols total;
    for (const int edge : edges) {
      if (!value_[index(edge)].empty()) total = sum(total, value_[index(edge)]);
    }
    if (num_unknown == 1) {
      settle(unknown, std::move(total));
    } else if (!total.empty()) {
      relations_.push_back(std::move(total));
    }
  }

  const EdgeGraph& graph_;
  std::vector<std::array<int, 3>> triangles_;  // their edges
  std::vector<int> first_, cofaces_;           // the triangles of an edge
  std::vector<double> depth_;                  // distance of a vertex in its tree [m]
  std::vector<char> is_known_;
  std::vector<Symbols> value_, relations_;
  std::vector<int> queue_;
  int num_symbols_ = 0;
};

/// Relations in reduced form: each rules out its last symbol, which stands in no other.
class Relations {
 public:
  explicit Relations(const std::vector<Symbols>& relations) {
    for (const Symbols& relation : relations) {
      Symbols rest = reduced(relation);
      if (rest.empty()) continue;
      const int pivot = rest.back();
      for (auto& [other, row] : rows_) {
        if (std::binary_search(row.begin(), row.end(), pivot)) row = sum(row, rest);
      }
      rows_.emplace(pivot, std::move(rest));
    }
  }
  bool rules_out(int symbol) const { return rows_.count(symbol) > 0; }
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
  const Spreading spreading(complex, graph);
  const Relations relations(spreading.relations());
  num_classes_ = spreading.num_symbols() - relations.size();
  words_ = std::max(1, (num_classes_ + 63) / 64);
  std::vector<int> bit(static_cast<std::size_t>(spreading.num_symbols()), -1);
  int next = 0;
  for (int symbol = 0; symbol < spreading.num_symbols(); ++symbol) {
    if (!relations.rules_out(symbol)) bit[static_cast<std::size_t>(symbol)] = next++;
  }
  bits_.assign(spreading.values().size() * static_cast<std::size_t>(words_), 0);
  for (std::size_t e = 0; e < spreading.values().size(); ++e) {
    if (spreading.values()[e].empty()) continue;
    for (const int symbol : relations.reduced(spreading.values()[e])) {
      const auto b = static_cast<std::size_t>(bit[static_cast<std::size_t>(symbol)]);
      bits_[e * static_cast<std::size_t>(words_) + b / 64] |= Word{1} << (b % 64);
    }
  }
}

bool Annotation::is_zero(int edge) const {
  return std::all_of(of(edge), of(edge) + words_, [](Word word) { return word == 0; });
}

}  // namespace graspless::geometry
