// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/polish.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/cycles/rooted_cycles.hpp"
#include "geometry/sampling/hilbert_order.hpp"

namespace graspless::geometry {
namespace {

constexpr int kMaxRoots = 8;       // per loop
constexpr double kMinGain = 1e-4;  // relative gain of a root that counts as progress
constexpr double kMaxDetour = 4;   // path on the full cloud relative to an edge of the coarse loop
constexpr double kSlack = 1.001;   // of the bound on the length, against rounding

using Class = std::vector<Annotation::Word>;

/// For each corner, the nearest point of the full cloud. Consecutive duplicates are dropped.
Cycle nearest_vertices(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& corners) {
  Cycle vertices;
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    poll();
    Eigen::Index nearest = 0;
    (points.colwise() - corners.col(i)).colwise().squaredNorm().minCoeff(&nearest);
    const auto vertex = static_cast<int>(nearest);
    if (vertices.empty() || vertices.back() != vertex) vertices.push_back(vertex);
  }
  while (vertices.size() > 1 && vertices.back() == vertices.front()) vertices.pop_back();
  return vertices;
}

class LoopPolisher {
 public:
  /// The lengths are those of `graph`. Points and labels must outlive this object.
  LoopPolisher(const Eigen::Matrix3Xd& points, EdgeGraph graph, const Annotation& annotation)
      : points_(points),
        annotation_(annotation),
        cycles_(std::move(graph), annotation),
        graph_(cycles_.graph()),
        paths_(graph_) {}

  /// Returns an empty cycle if the loop cannot be traced on the full cloud.
  Cycle polish(const Eigen::Matrix3Xd& loop) {
    const Cycle cycle = traced(nearest_vertices(points_, loop));
    return cycle.empty() ? cycle : shortened(cycle);
  }

  /// Shortens a closed walk within its class. Returns an empty cycle if none is found.
  Cycle shortened(Cycle cycle) {
    const Class cls = class_of(cycle);
    // A traced walk may go back and forth. Only its class and a bound on its length are used.
    double length = std::numeric_limits<double>::infinity();
    // A cycle found from a root begins opposite to it. The next root is there or a quarter further.
    for (int i = 0, failures = 0; i < kMaxRoots && failures < 2; ++i) {
      const double before = length;
      shorten(cycle[i % 2 == 0 ? 0 : cycle.size() / 4], cls, cycle, length);
      failures = length < before * (1 - kMinGain) ? 0 : failures + 1;
    }
    return std::isfinite(length) ? cycle : Cycle();
  }

 private:
  /// Traces the coarse loop along edges of the full cloud, corner by corner.
  Cycle traced(const Cycle& corners) {
    Cycle cycle;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int from = corners[i], to = corners[(i + 1) % corners.size()];
      const double straight = (points_.col(from) - points_.col(to)).norm();
      paths_.start(from, kMaxDetour * straight);
      int v = from;
      while ((v = paths_.next()) >= 0 && v != to) {
        poll();
        paths_.expand(v);
      }
      if (v < 0) return {};
      std::vector<int> path = paths_.path(to);  // back to `from`
      std::reverse(path.begin(), path.end());
      cycle.insert(cycle.end(), path.begin(), path.end() - 1);
    }
    return cycle;
  }

  Class class_of(const Cycle& cycle) const {
    Class sum(static_cast<std::size_t>(annotation_.words()), 0);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Annotation::Word* cls =
          annotation_.of(graph_.edge(cycle[i], cycle[(i + 1) % cycle.size()]));
      for (std::size_t w = 0; w < sum.size(); ++w) sum[w] ^= cls[w];
    }
    return sum;
  }

  double length_of(const Cycle& cycle) const {
    double length = 0;
    for (std::size_t i = 0; i < cycle.size(); ++i)
      length += graph_.length(graph_.edge(cycle[i], cycle[(i + 1) % cycle.size()]));
    return length;
  }

  /// Replaces the cycle by the shortest one of its class through the root, if that is shorter.
  void shorten(int root, const Class& cls, Cycle& cycle, double& length) {
    const double bound = std::min(length, length_of(cycle) * kSlack);
    const auto edge = cycles_.shortest(root, bound, cls.data());
    if (!edge) return;
    cycle = cycles_.cycle(*edge);
    length = length_of(cycle);
  }

  const Eigen::Matrix3Xd& points_;
  const Annotation& annotation_;
  RootedCycles cycles_;
  const EdgeGraph& graph_;
  ShortestPaths paths_;
};

/// Cycles of one complex, with the labels of its edges. They are computed once, where needed.
class Polish {
 public:
  explicit Polish(const Complex& complex) : complex_(complex) {}

  std::vector<Cycle> traced(const std::vector<Eigen::Matrix3Xd>& loops) {
    label();
    LoopPolisher polisher(complex_.points, *graph_, *annotation_);
    std::vector<Cycle> cycles;
    for (const Eigen::Matrix3Xd& loop : loops) cycles.push_back(polisher.polish(loop));
    return cycles;
  }

  std::vector<Cycle> around_gaps(const Resolution& resolution, std::vector<Cycle> cycles) {
    std::optional<LoopPolisher> polisher;  // most clouds need none
    for (Cycle& cycle : cycles) {
      if (resolution.widest_gap(cycle) == 0) continue;
      if (!polisher) {
        const auto weight = [&](int a, int b) {  // short edges stay near the material
          const double relative = resolution.relative_length(a, b);
          return std::max(1.0, relative * relative);
        };
        label();
        polisher.emplace(complex_.points, EdgeGraph(complex_, weight), *annotation_);
      }
      Cycle moved = polisher->shortened(cycle);
      if (!moved.empty()) cycle = std::move(moved);
    }
    return cycles;
  }

 private:
  void label() {
    if (annotation_) return;
    graph_.emplace(complex_);
    annotation_.emplace(complex_, *graph_);
  }

  const Complex& complex_;
  std::optional<EdgeGraph> graph_;
  std::optional<Annotation> annotation_;
};

}  // namespace

std::vector<Cycle> around_gaps(const Complex& complex, const Resolution& resolution,
                               std::vector<Cycle> cycles) {
  return Polish(complex).around_gaps(resolution, std::move(cycles));
}

std::vector<Cycle> polished(const Complex& whole, const std::vector<Eigen::Matrix3Xd>& loops) {
  return Polish(whole).traced(loops);
}

void polish(const Eigen::Matrix3Xd& points, std::vector<Loop>& loops) {
  if (loops.empty()) return;
  // Neighbours in space are close in memory, which makes every pass over them quicker.
  const std::vector<int> order = morton_order(points);
  const Filtration filtration(points(Eigen::all, order), "points");
  std::map<double, std::vector<Loop*>> by_scale;
  for (Loop& loop : loops) by_scale[loop.max_edge_length].push_back(&loop);
  for (const auto& [d, group] : by_scale) {
    std::vector<Eigen::Matrix3Xd> curves;
    for (const Loop* loop : group) curves.push_back(loop->points);
    const Complex whole = filtration.complex(d);
    const Resolution resolution(whole);
    Polish polish(whole);
    const std::vector<Cycle> cycles = polish.around_gaps(resolution, polish.traced(curves));
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      if (cycles[i].empty()) continue;
      const double length = cycle_length(whole.points, cycles[i]);
      if (length >= group[i]->length) continue;
      group[i]->points = whole.points(Eigen::all, cycles[i]);
      group[i]->vertices.clear();
      for (const int vertex : cycles[i])
        group[i]->vertices.push_back(order[static_cast<std::size_t>(vertex)]);
      group[i]->length = length;
      group[i]->gap = resolution.widest_gap(cycles[i]);
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
}

}  // namespace graspless::geometry
