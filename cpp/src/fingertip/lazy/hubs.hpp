// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements at which the object rests on all fingers but one, and the best routes through them.
#pragma once

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "crew.hpp"
#include "fingertip/lazy/candidates.hpp"

namespace graspless::fingertip {

/// A hub, and a pose at which the object may rest there.
struct HubPose {
  int hub, pose;
};

/// A hub is a pose and the fingers kept there. Arcs lead to it from each placement that contains
/// them, by lifting one finger, and from it to each of them, by putting the finger down elsewhere.
/// The way in costs X_regr and the way out nothing, instead of an arc for each pair of placements.
class Hubs {
 public:
  Hubs(const PoseGraph& graph, const StabilityBounds& bounds, const Displacements& displacements,
       Candidates& candidates);

  /// A finger that can be put down at a hub: then the placement may carry the object.
  struct Member {
    std::int32_t location;
    std::int32_t candidate = -1;        // the placement; -1: not opened yet
    std::int32_t comes = -1, goes = 0;  // the last pose it comes to, the first it goes on from
    bool is_examined() const { return comes >= 0; }  // until then it may do both everywhere
  };
  /// Adds a placement to the hubs of all its subsets of one finger less.
  void link(const Placement& placement, int candidate = -1);
  void unlink_all();
  /// Sorts the members, drops those linked twice, and bounds the costs at each pose by their
  /// displacements. Needed before bound() and best(). Forgets candidates that were linked.
  void rank(Crew& crew);
  int open(const Placement& kept);
  int size() const { return static_cast<int>(kept_.size()); }
  const Placement& kept(int hub) const { return kept_[hub]; }
  const std::vector<Member>& members(int hub) const { return members_[hub]; }

  /// A hub that is reached by putting a finger down at a location and lifting another.
  struct Neighbor {
    int hub;
    std::int32_t location;
  };
  const std::vector<Neighbor>& neighbors(int hub);

  /// True unless the object is known not to rest there.
  bool may_be_stable(int hub, int pose);

  /// True if the object has been shown to rest there.
  bool is_stable(int hub, int pose) { return known(hub, slot(pose)) == Known::stable; }

  /// The cheapest route with one regrasp, at this hub, and its candidates.
  struct Regrasp {
    double cost = std::numeric_limits<double>::infinity();
    int before = -1, after = -1;
  };
  Regrasp best(int hub, int pose);
  /// Compares the members at each of these, one hub a thread, and refreshes the candidates found.
  void compare(const std::vector<HubPose>& together, Crew& crew);
  /// True until the members have been compared for the first time.
  bool is_untouched(int hub, int pose) const {
    const Least& least = least_[index(hub, pose)];
    return least.first < 0 && least.second < 0 && least.before + least.after < kInfinity;
  }
  /// At most its cost.
  double bound(int hub, int pose);

  /// Adds the query about rest there if that is open. True if it is open, requested already or not.
  bool request(int hub, int pose, std::vector<StabilityQuery>& queries);
  void record(const StabilityQuery& query);

  std::int64_t memory() const { return memory_; }  // of members, neighbors and least costs
  /// Distinct instants at rest.
  const std::vector<int>& instants() const { return instants_; }

 private:
  enum class Known : std::uint8_t { open, requested, stable, unstable };
  /// Least costs up to a pose and from it on, as last compared, and the members that have them.
  struct Least {
    double before = std::numeric_limits<double>::infinity(), after = before;
    int first = -1, second = -1;  // -1: not known yet
  };
  std::size_t index(int hub, int pose) const {
    return static_cast<std::size_t>(hub) * static_cast<std::size_t>(graph_.num_poses()) +
           static_cast<std::size_t>(pose);
  }
  void rank(int hub);
  Least least_of(int hub, int pose);
  void examine(const Placement& placement, Member& member) const;
  void compare(int hub, int pose);
  bool has_risen(int hub, int pose) const;
  int candidate(int hub, int member);
  int slot(int pose) const { return slots_[pose]; }
  Known& known(int hub, int slot) {
    return known_[static_cast<std::size_t>(hub) * instants_.size() +
                  static_cast<std::size_t>(slot)];
  }

  const PoseGraph& graph_;
  const StabilityBounds& bounds_;
  const Displacements& displacements_;
  Candidates& candidates_;
  std::int64_t memory_ = 0;
  std::vector<int> instants_, slots_;
  std::vector<Placement> kept_;
  std::vector<std::vector<Member>> members_;
  std::vector<std::vector<Neighbor>> neighbors_;  // empty until they are asked for
  std::vector<Known> known_;                      // hubs x slots
  std::vector<Least> least_;                      // hubs x poses
  std::unordered_map<Placement, int, PlacementHash> index_;
  std::vector<int> index_of_one_;  // the same for a single finger, by its location; -1: none yet
};

}  // namespace graspless::fingertip
