// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The heuristic (11), and the displacements that it takes.
#include "fingertip/search/heuristic.hpp"

#include <algorithm>

#include "graspless/watch.hpp"

#include "geometry/cycles/bucket_queue.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kSamePoint = 1e-12;  // [m]
constexpr double kSlack = 1 - 1e-12;  // of lower bounds, for rounding
constexpr int kParts = 64;            // buckets that the longest arc spans

}  // namespace

RemainingDistance::RemainingDistance(const PoseGraph& graph)
    : graph_(graph), tables_(graph.locations.size()) {
  // On the floor only the plan view of a sphere's centre matters.
  const auto in_plan = [&](int location) -> Eigen::Vector2d {
    return graph.center_W(graph.start(), location).head<2>();
  };
  for (int l = 0; l < graph.locations.size(); ++l) {
    poll();
    int same = graph.is_path() ? l : 0;
    while (same < l && (in_plan(same) - in_plan(l)).norm() > kSamePoint) ++same;
    table_of_.push_back(same);
  }
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    origins_W_.push_back(graph.X_WO(pose).translation());
    if (graph.turn(pose) == static_cast<int>(pose_of_turn_.size())) pose_of_turn_.push_back(pose);
  }
}

std::vector<double> RemainingDistance::search(int location, double limit) {
  std::vector<Eigen::Vector3d> centers_W;  // turns: about the object's origin
  for (const int pose : pose_of_turn_) {
    centers_W.push_back(graph_.X_WO(pose).linear() * graph_.locations[location].center_O);
  }
  const Eigen::Vector3d start_W = graph_.center_W(graph_.start(), location);
  std::vector<double> arcs;  // motions
  for (int motion = 0; motion < graph_.num_motions(); ++motion) {
    arcs.push_back(graph_.options.samples_per_arc * graph_.displacement(motion, location));
  }
  geometry::BucketQueue queue(*std::max_element(arcs.begin(), arcs.end()) / kParts);
  std::vector<double> distances(graph_.num_poses(), kInfinity);
  const auto push = [&](int pose, double distance) {
    double& known = distances[pose];
    if (distance >= known) return;
    // Pairs below the limit before are below it at a smaller distance, too.
    if (known == kInfinity) {
      const Eigen::Vector3d center_W = centers_W[graph_.turn(pose)] + origins_W_[pose];
      const double straight = (center_W - start_W).norm() * kSlack;
      if (distance + straight >= limit) return;
    }
    known = distance;
    queue.push(distance, pose);
  };
  push(graph_.goal(), 0);
  geometry::BucketQueue::Item item{};
  while (queue.pop(item)) {
    poll();
    const int pose = item.vertex;
    if (item.key > distances[pose] || !graph_.is_free(pose)) continue;
    for (int move = 0; move < graph_.num_moves(); ++move) {
      const int from = graph_.previous(pose, move);
      if (from >= 0) push(from, item.key + arcs[graph_.motion(from, move)]);
    }
  }
  return distances;
}

std::int64_t RemainingDistance::memory() const {
  std::size_t bytes = 0;
  for (const auto& table : tables_) bytes += table.size() * sizeof(double);
  return static_cast<std::int64_t>(bytes);
}

Heuristic::Heuristic(const PoseGraph& graph, RemainingDistance& remaining, double greed)
    : graph_(graph), greed_(greed), remaining_(remaining) {}

double Heuristic::operator()(const Node& node) const {
  int n_regr = 0;
  double displacement = 0;  // max_i |Delta q*_i|
  for (int i = 0; i < num_fingers(node.placement); ++i) {
    const int l = node.placement[i];
    if (!graph_.is_clear(graph_.goal(), l)) ++n_regr;
    displacement = std::max(displacement, remaining_.to_goal(l)[node.pose]);
  }
  if (displacement == kInfinity || greed_ > 1) return greed_ * displacement;
  // (11) as printed takes the displacement; to regrasp may be cheaper.
  const double X_regr = graph_.options.regrasp_cost;
  return (n_regr > 0 ? n_regr * X_regr : std::min(displacement, X_regr)) * kSlack;
}

}  // namespace graspless::fingertip
