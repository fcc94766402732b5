// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements that may carry the object along some of the arcs, and what they cost at least.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "fingertip/lazy/bounds.hpp"
#include "fingertip/lazy/displacements.hpp"
#include "fingertip/lazy/evaluator_pool.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

struct PlacementHash {
  std::size_t operator()(const Placement& placement) const;
};

/// Arc costs of placements by (9), with z where it has been solved and an upper bound of z where it
/// has not: lower bounds, exact where all samples have been solved.
class Candidates {
 public:
  Candidates(const PoseGraph& graph, const StabilityBounds& bounds,
             const Displacements& displacements);

  /// The candidate of this placement, created on first use. It costs its displacement alone until
  /// refresh().
  int open(const Placement& placement);
  /// The same of a placement that the frontier takes up as a route all the way.
  int enter(const Placement& placement);
  bool is_entered(const Placement& placement) const;
  int size() const { return static_cast<int>(all_.size()); }
  const Placement& placement(int c) const { return at(c).placement; }

  /// Cost of the arcs before a pose, and from it on; infinite when one is impossible.
  double before(int c, int pose) const { return before_[sum_index(c) + pose]; }
  double after(int c, int pose) const { return after_[sum_index(c) + pose]; }
  double arc(int c, int arc) const { return arcs_[arc_index(c, arc)]; }

  /// Takes up new bounds. True if any cost has changed.
  bool refresh(int c);
  void refresh_all();
  /// Keeps costs of arcs between impossible ones too, from now on.
  void keep_inner_arcs();

  /// Adds queries about the most critical open samples of these arcs, more each time. True if any
  /// sample is open, requested already or not.
  bool request(int c, int first_arc, int last_arc, std::vector<StabilityQuery>& queries);
  /// True if all samples of these arcs have been solved and are stable.
  bool is_solved(int c, int first_arc, int last_arc) const;
  /// Adds the query about one sample, by its place in instants(), if it is open.
  void request_slot(int c, int slot, std::vector<StabilityQuery>& queries, double needed = 0);
  /// Records the result of a query.
  void record(const StabilityQuery& query);

  /// Least cost of a candidate that is solved all the way, so far.
  double best() const { return best_; }

  /// Distinct instants of the motion, in its order.
  const std::vector<int>& instants() const { return instants_; }
  std::vector<int> instants(int arc) const;  // of an arc's samples, each once
  std::int64_t memory() const;

 private:
  enum class Known : std::uint8_t { bound, requested, solved };
  struct Candidate {
    Placement placement;
    std::int64_t stamp = 0;
    int solved = 0;
    bool is_entered = false;
  };
  const Candidate& at(int c) const { return all_[c]; }
  Candidate& at(int c) { return all_[c]; }
  std::size_t sum_index(int c) const { return static_cast<std::size_t>(c) * graph_.num_poses(); }
  std::size_t arc_index(int c, int arc) const {
    return static_cast<std::size_t>(c) * graph_.num_arcs() + arc;
  }
  std::size_t slot_index(int c, int slot) const { return c * instants_.size() + slot; }
  int slot(int arc, int sample) const {
    return slots_[arc * graph_.options.samples_per_arc + sample];
  }
  bool tighten(int c, int slot);
  double tighten_arc(int c, int arc, bool& changed);
  void set_stability(int c, int slot, double z);
  double needed(int c, int slot) const;
  bool update(int c);

  const PoseGraph& graph_;
  const StabilityBounds& bounds_;
  const Displacements& displacements_;
  std::vector<int> instants_, slots_;
  std::vector<Candidate> all_;
  std::vector<double> z_;               // candidates x slots
  std::vector<double> weight_;          // candidates x slots: 1 + X_stab / z
  std::vector<Known> known_;            // candidates x slots
  std::vector<double> arcs_;            // candidates x arcs
  std::vector<double> before_, after_;  // candidates x poses
  std::unordered_map<Placement, int, PlacementHash> index_;
  bool keeps_inner_arcs_ = false;
  double best_ = kInfinity;
};

}  // namespace graspless::fingertip
