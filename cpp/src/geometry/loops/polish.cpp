// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/polish.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "crew.hpp"
#include "geometry/cycles/rooted_cycles.hpp"
#include "geometry/sampling/hilbert_order.hpp"
#include "once.hpp"

namespace graspless::geometry {
namespace {

constexpr int kMaxRoots = 8;       // per loop
constexpr double kMinGain = 1e-4;  // relative gain of a root that counts as progress
constexpr double kMaxDetour = 4;   // path on the full cloud relative to an edge of the coarse loop
constexpr double kSlack = 1.001;   // of the bound on the length, against rounding

using Class = std::vector<Annotation::Word>;

/// Finds the nearest point of a cloud whose neighbours are mostly close in memory.
class NearestPoint {
 public:
  explicit NearestPoint(const Eigen::Matrix3Xd& points) : points_(points) {
    for (Eigen::Index first = 0; first < points.cols(); first += kPoints) {
      const auto members = points.middleCols(first, std::min(kPoints, points.cols() - first));
      boxes_.emplace_back(members.rowwise().minCoeff(), members.rowwise().maxCoeff());
    }
  }

  int operator()(const Eigen::Vector3d& p) const {
    constexpr double kRounding = 1 - 1e-9;
    double least = std::numeric_limits<double>::infinity();
    Eigen::Index nearest = 0;
    for (std::size_t box = 0; box < boxes_.size(); ++box) {
      if (boxes_[box].squaredExteriorDistance(p) * kRounding > least) continue;
      const auto first = static_cast<Eigen::Index>(box) * kPoints;
      for (Eigen::Index i = first; i < std::min(first + kPoints, points_.cols()); ++i) {
        const double squared = (points_.col(i) - p).squaredNorm();
        if (squared >= least) continue;
        least = squared;
        nearest = i;
      }
    }
    return static_cast<int>(nearest);
  }

 private:
  static constexpr Eigen::Index kPoints = 64;
  const Eigen::Matrix3Xd& points_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

/// For each corner, the nearest point of the full cloud. Consecutive duplicates are dropped.
Cycle nearest_vertices(const NearestPoint& nearest, const Eigen::Matrix3Xd& corners) {
  Cycle vertices;
  for (const auto& corner : corners.colwise()) {
    poll();
    const int vertex = nearest(corner);
    if (vertices.empty() || vertices.back() != vertex) vertices.push_back(vertex);
  }
  while (vertices.size() > 1 && vertices.back() == vertices.front()) vertices.pop_back();
  return vertices;
}

class LoopPolisher {
 public:
  /// Points, graph and labels must outlive this object.
  LoopPolisher(const Eigen::Matrix3Xd& points, const EdgeGraph& graph, const Annotation& annotation)
      : points_(points),
        annotation_(annotation),
        graph_(graph),
        cycles_(graph, annotation),
        paths_(graph) {}

  /// Shortens the loop through these points of the full cloud. Returns an empty cycle if it cannot
  /// be traced on edges.
  Cycle polish(const Cycle& corners) {
    const Cycle cycle = traced(corners);
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
  const EdgeGraph& graph_;
  RootedCycles cycles_;
  ShortestPaths paths_;
};

/// Replaces a loop by a cycle that is shorter. `order[i]` is the caller's index of point i.
void replace(Loop& loop, const Complex& whole, const Cycle& cycle, const Resolution& resolution,
             const std::vector<int>& order) {
  if (cycle.empty()) return;
  const double length = cycle_length(whole.points, cycle);
  if (length >= loop.length) return;
  loop.points = whole.points(Eigen::all, cycle);
  loop.vertices.clear();
  for (const int vertex : cycle) loop.vertices.push_back(order[vertex]);
  loop.length = length;
  loop.gap = resolution.widest_gap(cycle);
}

/// A graph of the edges of a complex, made where it is first needed, and its polishers. Several
/// threads may use it at once.
class Polishers {
 public:
  Polishers(const Complex& complex, const std::optional<Annotation>& annotation, EdgeWeight weight)
      : complex_(complex), weight_(std::move(weight)), spares_([this, &annotation] {
          return std::make_unique<LoopPolisher>(complex_.points, graph(), *annotation);
        }) {}

  const EdgeGraph& graph() {
    made_([this] { graph_.emplace(complex_, weight_); });
    return *graph_;
  }

  /// Calls `work` with a polisher that no other thread uses.
  Cycle operator()(const std::function<Cycle(LoopPolisher&)>& work) { return spares_.lend(work); }

 private:
  const Complex& complex_;
  const EdgeWeight weight_;
  Once made_;
  std::optional<EdgeGraph> graph_;
  Spares<LoopPolisher> spares_;
};

/// Cycles of one complex, with the labels of its edges. They are computed once, where needed.
class Polish {
 public:
  explicit Polish(const Complex& complex) : plain_(complex, annotation_, {}), complex_(complex) {}

  /// Labels the edges. Must come before traced().
  void label() { annotation_.emplace(complex_, plain_.graph()); }

  Cycle traced(const Cycle& corners) {
    return plain_([&](LoopPolisher& polisher) { return polisher.polish(corners); });
  }

  Cycle around_gaps(const Resolution& resolution, Cycle cycle) {
    if (resolution.widest_gap(cycle) == 0) return cycle;  // as in most clouds
    weighted_made_([&] {
      if (!annotation_) label();
      weighted_ = std::make_unique<Polishers>(complex_, annotation_, [&resolution](int a, int b) {
        const double relative = resolution.relative_length(a, b);  // short edges stay near
        return std::max(1.0, relative * relative);                 // the material
      });
    });
    Cycle moved = (*weighted_)([&](LoopPolisher& polisher) { return polisher.shortened(cycle); });
    return moved.empty() ? cycle : moved;
  }

 private:
  std::optional<Annotation> annotation_;
  Polishers plain_;
  Once weighted_made_;
  std::unique_ptr<Polishers> weighted_;
  const Complex& complex_;
};

}  // namespace

std::vector<Cycle> around_gaps(const Complex& complex, const Resolution& resolution,
                               std::vector<Cycle> cycles) {
  Polish polish(complex);
  for (Cycle& cycle : cycles) cycle = polish.around_gaps(resolution, std::move(cycle));
  return cycles;
}

std::vector<Cycle> polished(const Complex& whole, const std::vector<Eigen::Matrix3Xd>& loops) {
  const NearestPoint nearest(whole.points);
  Polish polish(whole);
  polish.label();
  std::vector<Cycle> cycles;
  for (const Eigen::Matrix3Xd& loop : loops)
    cycles.push_back(polish.traced(nearest_vertices(nearest, loop)));
  return cycles;
}

void polish(const Eigen::Matrix3Xd& points, int threads, std::vector<Loop>& loops) {
  if (loops.empty()) return;
  Crew crew(threads);
  // Neighbours in space are close in memory, which makes every pass over them quicker.
  const std::vector<int> order = morton_order(points);
  const Filtration filtration(points(Eigen::all, order), "points");
  const NearestPoint nearest(filtration.points());
  std::map<double, std::vector<Loop*>> by_scale;
  for (Loop& loop : loops) by_scale[loop.max_edge_length].push_back(&loop);
  for (const auto& [d, group] : by_scale) {
    const Complex whole = filtration.complex(d);
    std::optional<Resolution> resolution;
    Polish polish(whole);
    crew.share(2, [&](std::size_t part) {
      if (part == 0) return polish.label();
      resolution.emplace(whole);
    });
    const std::vector<Loop*>& members = group;
    crew.share(members.size(), [&](std::size_t i) {
      const Cycle corners = nearest_vertices(nearest, members[i]->points);
      const Cycle cycle = polish.around_gaps(*resolution, polish.traced(corners));
      replace(*members[i], whole, cycle, *resolution, order);
    });
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
}

}  // namespace graspless::geometry
