// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements that may carry the object along some of the arcs, and what they cost at least.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "fingertip/lazy/bounds.hpp"
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
  Candidates(const PoseGraph& graph, const StabilityBounds& bounds);

  void reserve(std::size_t more);
  /// The candidate of this placement, created on first use. It costs its displacement alone until
  /// refresh().
  int open(const Placement& placement);
  int size() const { return static_cast<int>(all_.size()); }
  const Placement& placement(int c) const { return at(c).placement; }

  /// Costs of the arcs before each pose, and from each pose on; infinite when one is impossible.
  /// Valid until the next call of a function of this class.
  struct Sums {
    const double *before, *after;
  };
  Sums sums(int c) const;
  double before(int c, int pose) const { return sums(c).before[pose]; }
  double after(int c, int pose) const { return sums(c).after[pose]; }
  /// Cost of an arc of a candidate that has been looked at.
  double arc(int c, int arc) const { return arcs_[arc_index(c, arc)]; }

  /// The least displacement in an arc: no arc costs less. The first and the last that is not clear.
  struct Reach {
    double least_arc;
    int candidate, first_blocked, last_blocked;
    bool operator<(const Reach& other) const { return least_arc < other.least_arc; }
  };
  Reach reach(int c) const;

  /// True once bounds have been taken up or samples requested. Until then a candidate costs its
  /// displacement, and has no place in the tables.
  bool is_looked_at(int c) const { return at(c).row >= 0; }

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
  void request_slot(int c, int slot, std::vector<StabilityQuery>& queries);
  /// Records the result of a query.
  void record(const StabilityQuery& query);

  /// Distinct instants of the motion, in its order.
  const std::vector<int>& instants() const { return instants_; }
  std::vector<int> instants(int arc) const;  // of an arc's samples, each once
  std::int64_t memory() const;
  static std::int64_t bytes_each(const PoseGraph& graph);  // until they are looked at

 private:
  enum class Known : std::uint8_t { bound, requested, solved };
  struct Candidate {
    Placement placement;
    std::int64_t stamp = 0;
    int solved = 0;
    int row = -1;  // of the tables; -1 until it is looked at
  };
  const Candidate& at(int c) const { return all_[static_cast<std::size_t>(c)]; }
  Candidate& at(int c) { return all_[static_cast<std::size_t>(c)]; }
  std::size_t sum_index(int c) const {
    return static_cast<std::size_t>(at(c).row) * static_cast<std::size_t>(graph_.num_poses());
  }
  std::size_t arc_index(int c, int arc) const {
    return static_cast<std::size_t>(at(c).row) * static_cast<std::size_t>(graph_.num_arcs()) +
           static_cast<std::size_t>(arc);
  }
  std::size_t slot_index(int c, int slot) const {
    return static_cast<std::size_t>(at(c).row) * instants_.size() + static_cast<std::size_t>(slot);
  }
  int slot(int arc, int sample) const {
    return slots_[static_cast<std::size_t>(arc * graph_.options.samples_per_arc + sample)];
  }
  double displacement(int arc, const Placement& placement) const;
  double least_cost(int arc, int c) const;
  void look_at(int c);
  bool tighten(int c, int slot);
  double tighten_arc(int c, int arc, bool& changed);
  void set_stability(int c, int slot, double z);
  bool update(int c);

  const PoseGraph& graph_;
  const StabilityBounds& bounds_;
  std::vector<int> instants_, slots_;
  std::vector<double> displacements_;  // locations x arcs: of a P-th of it; infinite: not clear
  std::vector<Candidate> all_;
  int rows_ = 0;
  std::vector<double> z_;               // rows x slots
  std::vector<double> weight_;          // rows x slots: 1 + X_stab / z
  std::vector<Known> known_;            // rows x slots
  std::vector<double> arcs_;            // rows x arcs
  std::vector<double> before_, after_;  // rows x poses
  mutable std::vector<double> some_arcs_, some_before_, some_after_;  // of one without a row
  std::unordered_map<Placement, int, PlacementHash> index_;
  bool keeps_inner_arcs_ = false;
};

}  // namespace graspless::fingertip
