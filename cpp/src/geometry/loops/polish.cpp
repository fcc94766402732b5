// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Shortens loops of a downsampled cloud on the full cloud, and moves loops onto the surface, within
// their homology class and from a few roots on each loop instead of all vertices.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/loops/resolution.hpp"
#include "geometry/loops/rooted_cycles.hpp"
#include "geometry/loops/shortest_basis.hpp"

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
  explicit LoopPolisher(const Complex& complex) : LoopPolisher(complex, EdgeGraph(complex)) {}
  /// The lengths are those of `graph`.
  LoopPolisher(const Complex& complex, EdgeGraph graph)
      : complex_(complex),
        graph_(std::move(graph)),
        annotation_(complex, graph_),
        cycles_(complex, graph_, annotation_),
        paths_(graph_) {}

  /// Returns an empty cycle if the loop cannot be traced on the full cloud.
  Cycle polish(const Eigen::Matrix3Xd& loop) {
    const Cycle cycle = traced(nearest_vertices(complex_.points, loop));
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
      const double straight = (complex_.points.col(from) - complex_.points.col(to)).norm();
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
    for (const RootedCycles::ClosingEdge& edge : cycles_.from(root, bound)) {
      if (!std::equal(cls.begin(), cls.end(), cycles_.class_of(edge))) continue;
      cycle = cycles_.cycle(edge);
      length = length_of(cycle);
      return;
    }
  }

  const Complex& complex_;
  EdgeGraph graph_;
  Annotation annotation_;
  RootedCycles cycles_;
  ShortestPaths paths_;
};

}  // namespace

std::vector<Cycle> around_gaps(const Complex& complex, const Resolution& resolution,
                               std::vector<Cycle> cycles) {
  std::optional<LoopPolisher> polisher;  // most clouds need none
  for (Cycle& cycle : cycles) {
    if (resolution.widest_gap(cycle) == 0) continue;
    if (!polisher) {
      const auto weight = [&](int a, int b) {  // short edges stay near the material
        const double relative = resolution.relative_length(a, b);
        return std::max(1.0, relative * relative);
      };
      polisher.emplace(complex, EdgeGraph(complex, weight));
    }
    Cycle moved = polisher->shortened(cycle);
    if (!moved.empty()) cycle = std::move(moved);
  }
  return cycles;
}

std::vector<Cycle> polished(const Complex& whole, const std::vector<Eigen::Matrix3Xd>& loops) {
  LoopPolisher polisher(whole);
  std::vector<Cycle> cycles;
  for (const Eigen::Matrix3Xd& loop : loops) cycles.push_back(polisher.polish(loop));
  return cycles;
}

}  // namespace graspless::geometry
