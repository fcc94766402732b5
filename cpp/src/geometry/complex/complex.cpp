// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Filtration: computes the simplices at construction, and persistence on first use.
#include "graspless/geometry/complex.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <Eigen/Eigenvalues>

#include "geometry/complex/delaunay.hpp"
#include "geometry/complex/plateaus.hpp"
#include "geometry/complex/reduction.hpp"
#include "geometry/complex/simplices.hpp"
#include "geometry/pulse.hpp"
#include "geometry/require_points.hpp"
#include "once.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

/// Ratio of thickness to length below which a cloud counts as flat.
constexpr double kFlat = 1e-6;

bool is_flat(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred * centred.transpose(),
                                                            Eigen::EigenvaluesOnly);
  return axes.eigenvalues()[0] <= kFlat * kFlat * axes.eigenvalues()[2];
}

void check_span(const Delaunay& delaunay, const Eigen::Matrix3Xd& points, const std::string& what) {
  if (delaunay.num_vertices < 4) {
    throw std::invalid_argument(what + " must hold at least 4 distinct points, not " +
                                std::to_string(delaunay.num_vertices));
  }
  if (delaunay.dimension < 3 || is_flat(points)) {
    throw std::invalid_argument(what + " must span a volume; all " + std::to_string(points.cols()) +
                                " lie in a plane or on a line");
  }
}

Simplices triangulated(const Eigen::Matrix3Xd& points, const std::string& what) {
  require_points(points, what);
  const Delaunay triangulation = delaunay(points);
  check_span(triangulation, points, what);
  return simplices(points, triangulation);
}

}  // namespace

struct Filtration::Data {
  /// A vertex's parent in the tree of shortest edges.
  struct Parent {
    int vertex = -1, depth = 0;
    double length = 0;  // of the edge to it [m]
  };

  Eigen::Matrix3Xd points;
  Simplices simplices;
  mutable Once ranked, reduced, completed, spanned;
  mutable std::optional<Ranking> ranking;
  mutable std::optional<BettiCurve> betti;
  mutable std::optional<Reduction> reduction;
  mutable std::vector<PersistencePair> pairs;
  mutable std::vector<Parent> tree;

  const BettiCurve& curve() const {
    ranked([this] {
      ranking = geometry::ranking(simplices);
      betti = betti_curve(*ranking);
    });
    return *betti;
  }
  const Reduction& reduce() const {
    curve();
    reduced([this] { reduction.emplace(*ranking); });
    return *reduction;
  }
  const std::vector<PersistencePair>& all_pairs() const {
    completed([this] {
      pairs = reduce().pairs();
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Reduction::Ends ends = reduction->ends(static_cast<int>(i));
        const int edge = ranking->edge[ends.edge];
        pairs[i].closing = simplices.edges[edge];
        pairs[i].filling = simplices.triangles[ends.triangle].vertices;
      }
    });
    return pairs;
  }
  /// Index of the edge between two points; -1 if there is none, or no such point.
  int edge(int a, int b) const {
    const auto n = static_cast<int>(points.cols());
    return a >= 0 && b >= 0 && a < n && b < n ? simplices.edge(a, b) : -1;
  }
  /// Longest edge on the way between two vertices in the tree of shortest edges [m].
  double longest_step(int a, int b) const {
    curve();
    spanned([this] { span_tree(); });
    double longest = 0;
    while (a != b) {
      int& deeper = tree[a].depth >= tree[b].depth ? a : b;
      longest = std::max(longest, tree[deeper].length);
      deeper = tree[deeper].vertex;
    }
    return longest;
  }

 private:
  void span_tree() const {
    const auto n = static_cast<int>(points.cols());
    std::vector<std::vector<std::pair<int, double>>> near(n);
    for (std::size_t r = 0; r < ranking->lengths.size(); ++r) {
      if (ranking->makes_loop[r]) continue;
      const auto [a, b] = simplices.edges[ranking->edge[r]];
      near[a].emplace_back(b, ranking->lengths[r]);
      near[b].emplace_back(a, ranking->lengths[r]);
    }
    tree.resize(n);
    std::vector<char> is_known(n);
    std::vector<int> open;
    Pulse pulse;
    for (int root = 0; root < n; ++root) {
      pulse();
      if (is_known[root]) continue;
      is_known[root] = 1;
      open.push_back(root);
      while (!open.empty()) {
        const int from = open.back();
        open.pop_back();
        for (const auto& [to, length] : near[from]) {
          if (is_known[to]) continue;
          is_known[to] = 1;
          tree[to] = {from, tree[from].depth + 1, length};
          open.push_back(to);
        }
      }
    }
  }
};

Filtration::Filtration(const Eigen::Matrix3Xd& points, const std::string& what) {
  auto data = std::make_shared<Data>();
  data->simplices = triangulated(points, what);
  data->points = points;
  data_ = std::move(data);
}

const Eigen::Matrix3Xd& Filtration::points() const { return data_->points; }
int Filtration::num_vertices() const { return data_->simplices.num_vertices; }

Complex Filtration::complex(double max_edge_length) const {
  require(max_edge_length >= 0, "max_edge_length", max_edge_length, "must not be negative");
  const Simplices& all = data_->simplices;
  Complex result;
  result.points = data_->points;
  result.max_edge_length = max_edge_length;
  const auto is_in = [=](double longest) { return longest < max_edge_length; };
  result.edges.resize(2, std::count_if(all.lengths.begin(), all.lengths.end(), is_in));
  Eigen::Index n = 0;
  Pulse pulse;
  for (std::size_t e = 0; e < all.edges.size(); ++e) {
    pulse();
    if (is_in(all.lengths[e])) result.edges.col(n++) << all.edges[e][0], all.edges[e][1];
  }
  result.triangles.resize(3, std::count_if(all.triangles.begin(), all.triangles.end(),
                                           [&](const Simplices::Triangle& triangle) {
                                             return is_in(triangle.longest_edge);
                                           }));
  n = 0;
  for (const auto& triangle : all.triangles) {
    pulse();
    if (!is_in(triangle.longest_edge)) continue;
    result.triangles.col(n++) << triangle.vertices[0], triangle.vertices[1], triangle.vertices[2];
  }
  return result;
}

const std::vector<PersistencePair>& Filtration::persistence() const { return data_->all_pairs(); }

ClassLabels Filtration::labels(double max_edge_length, const std::vector<int>& classes) const {
  for (const int i : classes) {
    const auto& pairs = persistence();
    const bool exists = i >= 0 && i < static_cast<int>(pairs.size());
    const auto at = static_cast<std::size_t>(i);
    if (exists && pairs[at].birth < max_edge_length && max_edge_length <= pairs[at].death) continue;
    throw std::invalid_argument("class " + std::to_string(i) + " is not alive at " +
                                figure(max_edge_length) + " m");
  }
  ClassLabels result;
  result.num_classes = static_cast<int>(classes.size());
  result.words = std::max(1, (result.num_classes + 63) / 64);
  const auto words = static_cast<std::size_t>(result.words);
  const std::vector<std::uint64_t> by_rank =
      data_->reduce().labels(max_edge_length, classes, result.words);
  const Simplices& all = data_->simplices;
  for (std::size_t e = 0; e < all.edges.size(); ++e) {
    if (!(all.lengths[e] < max_edge_length)) continue;
    const auto first =
        by_rank.begin() +
        static_cast<std::ptrdiff_t>(static_cast<std::size_t>(data_->ranking->rank[e]) * words);
    result.bits.insert(result.bits.end(), first, first + result.words);
  }
  return result;
}

double Filtration::jump(const PersistencePair& pair) const {
  const auto [a, b] = pair.closing;
  if (data_->edge(a, b) < 0) {
    throw std::invalid_argument("pair.closing must be an edge, not points " + std::to_string(a) +
                                " and " + std::to_string(b));
  }
  const double longest = data_->longest_step(a, b);
  return longest > 0 ? pair.birth / longest : 1;
}

const BettiCurve& Filtration::betti() const { return data_->curve(); }

std::vector<Plateau> Filtration::plateaus(double lasting_ratio) const {
  require(lasting_ratio >= 1, "lasting_ratio", lasting_ratio, "must be at least 1");
  return geometry::plateaus(persistence(), lasting_ratio);
}

PersistencePair Filtration::span(const std::vector<int>& cycle, double max_edge_length) const {
  if (cycle.size() < 3) {
    throw std::invalid_argument("cycle must have at least 3 points, not " +
                                std::to_string(cycle.size()));
  }
  const std::vector<int>& rank = data_->reduce().ranking().rank;
  std::vector<int> edges;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const int a = cycle[i], b = cycle[(i + 1) % cycle.size()];
    const int edge = data_->edge(a, b);
    if (edge < 0 || !(data_->simplices.lengths[edge] < max_edge_length)) {
      throw std::invalid_argument("cycle goes from point " + std::to_string(a) + " to " +
                                  std::to_string(b) + ", which is no edge shorter than " +
                                  figure(max_edge_length) + " m");
    }
    edges.push_back(rank[edge]);
  }
  return data_->reduce().span(edges, max_edge_length);
}

}  // namespace graspless::geometry
