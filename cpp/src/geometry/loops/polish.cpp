// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Loops of a thinned cloud, shortened on the whole one: from a few roots on each loop instead of
// from all vertices, and within their own class.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/loops/rooted_cycles.hpp"
#include "geometry/loops/shortest_basis.hpp"

namespace graspless::geometry {
namespace {

constexpr int kRoots = 8;         // a loop, at most
constexpr double kGain = 1e-4;    // of a root that makes the next one worth it
constexpr double kDetour = 4;     // of a coarse edge's way on the whole cloud, in edge lengths
constexpr double kSlack = 1.001;  // of the bound on a way that may be the shortest

using Class = std::vector<Annotation::Word>;

/// The points of `whole` nearest to each corner of the loops: the corners themselves where the
/// thinned cloud is part of the whole one.
Cycle nearest_vertices(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& corners) {
  Cycle vertices;
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    Eigen::Index nearest = 0;
    (points.colwise() - corners.col(i)).colwise().squaredNorm().minCoeff(&nearest);
    const auto vertex = static_cast<int>(nearest);
    if (vertices.empty() || vertices.back() != vertex) vertices.push_back(vertex);
  }
  while (vertices.size() > 1 && vertices.back() == vertices.front()) vertices.pop_back();
  return vertices;
}

class Polish {
 public:
  explicit Polish(const Complex& complex)
      : complex_(complex),
        graph_(complex),
        annotation_(complex, graph_),
        cycles_(complex, graph_, annotation_),
        paths_(graph_) {}

  /// Empty where the loop has no way on the whole cloud.
  Cycle of(const Eigen::Matrix3Xd& loop) {
    Cycle cycle = traced(nearest_vertices(complex_.points, loop));
    if (cycle.empty()) return cycle;
    const Class cls = class_of(cycle);
    // What was traced may go back and forth: only its class counts, and a bound on its length.
    double length = std::numeric_limits<double>::infinity();
    // A cycle found from a root begins opposite of it. The next root is there or a quarter on.
    for (int i = 0, in_vain = 0; i < kRoots && in_vain < 2; ++i) {
      const double before = length;
      shorten(cycle[i % 2 == 0 ? 0 : cycle.size() / 4], cls, cycle, length);
      in_vain = length < before * (1 - kGain) ? 0 : in_vain + 1;
    }
    return std::isfinite(length) ? cycle : Cycle();
  }

 private:
  /// The coarse loop, corner to corner along edges of the whole cloud.
  Cycle traced(const Cycle& corners) {
    Cycle cycle;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int from = corners[i], to = corners[(i + 1) % corners.size()];
      const double straight = (complex_.points.col(from) - complex_.points.col(to)).norm();
      paths_.start(from, kDetour * straight);
      int v = from;
      while ((v = paths_.next()) >= 0 && v != to) paths_.expand(v);
      if (v < 0) return {};
      std::vector<int> way = paths_.path(to);  // back to `from`
      std::reverse(way.begin(), way.end());
      cycle.insert(cycle.end(), way.begin(), way.end() - 1);
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

  /// The shortest cycle of the class that runs through the root, where it is shorter.
  void shorten(int root, const Class& cls, Cycle& cycle, double& length) {
    const double bound = std::min(length, cycle_length(complex_.points, cycle) * kSlack);
    for (const RootedCycles::Closing& closing : cycles_.from(root, bound)) {
      if (!std::equal(cls.begin(), cls.end(), cycles_.class_of(closing))) continue;
      cycle = cycles_.cycle(closing);
      length = cycle_length(complex_.points, cycle);
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

std::vector<Cycle> polished(const Complex& whole, const std::vector<Eigen::Matrix3Xd>& loops) {
  Polish polish(whole);
  std::vector<Cycle> cycles;
  for (const Eigen::Matrix3Xd& loop : loops) cycles.push_back(polish.of(loop));
  return cycles;
}

}  // namespace graspless::geometry
