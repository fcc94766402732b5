// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <ompl/base/Planner.h>

#include "graspless/export.hpp"
#include "graspless/planning/sampleable_region.hpp"

namespace graspless::planning {

class Forest;
class RootComponents;

/// CBiRRT with sampleable start and goal regions: Algorithm 1 of Hang, Morgan and Dollar 2019.
///
/// Grows one forest of trees from sampled starts and another from sampled goals, and connects them
/// under a constraint until `Goal::isStartGoalPairValid` accepts a connected pair of roots. Runs on
/// any state space. Without a projector it is RRT-Connect over forests. Without a start region the
/// problem's start states are the roots. The goal must be an `ompl::base::GoalSampleableRegion`.
///
/// set_connect_first(true) adds a shortcut to Algorithm 1. It samples a partner for each new root,
/// or several for each given start (SampleableRegion::try_sample_partner), and tries to connect the
/// two at once. The cheapest pair of the first kCompared starts comes first. It also counts all
/// starts and goals as connected that are joined by any chain of connections (union-find over the
/// roots).
///
/// Repeatable for one seed if set_random_config is given (OMPL's samplers share a global seed).
class GRASPLESS_API ForestCBiRRT : public ompl::base::Planner {
 public:
  static constexpr int kCompared = 16;  ///< starts
  using State = ompl::base::State;
  /// Projects a state onto the constraint; false if that fails. Must not change a state that is on
  /// it already.
  using Projector = std::function<bool(State*)>;
  /// True if the motion between two near states is valid. `start` is the start root of its tree. It
  /// is null in the goal forest, where the start is not known; the motion is checked again once it
  /// is.
  using MotionCheck = std::function<bool(const State* start, const State* from, const State* to)>;
  /// True if a whole path through both forests is valid from its start root. The final check, for
  /// whatever the motion check leaves out while trees grow. Without it, the motion check runs again
  /// on the motions whose start was not known.
  using PathCheck = std::function<bool(const std::vector<State*>& path)>;
  /// RandomConfig() of the algorithm.
  using RandomConfig = std::function<void(std::mt19937_64&, State*)>;

  explicit ForestCBiRRT(const ompl::base::SpaceInformationPtr& si);
  ~ForestCBiRRT() override;

  void set_start_region(std::shared_ptr<const ompl::base::GoalSampleableRegion> region);
  void set_projector(Projector projector) { project_ = std::move(projector); }
  void set_motion_check(MotionCheck check) { motion_check_ = std::move(check); }
  void set_path_check(PathCheck check) { path_check_ = std::move(check); }
  void set_random_config(RandomConfig draw) { random_config_ = std::move(draw); }
  void set_seed(std::uint64_t seed) { rng_.seed(seed); }
  void set_root_scale(double root_scale);  ///< N* of Eq. (5), positive; default 100
  double root_scale() const { return root_scale_; }
  void set_range(double range);  ///< longest step of an extension; 0: chosen by setup()
  double range() const { return range_; }
  void set_connect_first(bool on) { connect_first_ = on; }

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  void setup() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  std::size_t num_start_roots() const;
  std::size_t num_goal_roots() const;
  std::size_t num_nodes() const;
  std::size_t num_pairs() const { return num_pairs_; }  ///< pairs checked by isStartGoalPairValid

 private:
  struct Meeting {  // two nodes, one of each forest, at the same state
    int start_node, goal_node;
  };
  struct Pair {  // two roots
    int start, goal;
    double cost;
  };

  void check_problem() const;
  void add_given_starts();
  bool can_add_root();
  int add_from_region(Forest& forest);
  bool connect_partners(const ompl::base::PlannerTerminationCondition& ptc);
  std::optional<Pair> add_partner(int start, double max_cost);
  int start_for(const Forest& forest, int root);
  bool is_solved_by(const Pair& pair);
  bool draw(const ompl::base::GoalSampleableRegion& region, State* state) const;
  int extend(Forest& forest, int from, const State* target);
  bool is_motion_valid(const State* start, const State* from, const State* to) const;
  bool are_motions_valid(const State* start, const std::vector<State*>& path,
                         std::size_t first) const;
  bool solves(const Meeting& meeting);
  bool is_pair_valid(int start_root, int goal_root);
  bool accept(int start_root, int goal_root, const std::vector<Meeting>& route);

  std::shared_ptr<const ompl::base::GoalSampleableRegion> start_region_;
  Projector project_;
  MotionCheck motion_check_;
  PathCheck path_check_;
  RandomConfig random_config_;
  ompl::base::StateSamplerPtr sampler_;
  std::mt19937_64 rng_{1};
  double root_scale_ = 100;
  double range_ = 0;
  bool connect_first_ = false;

  std::unique_ptr<Forest> start_forest_, goal_forest_;
  std::unique_ptr<RootComponents> components_;
  std::set<std::pair<int, int>> refused_;  // pairs of roots; most connections repeat a known pair
  Forest* next_ = nullptr;                 // the forest to grow next: Pi_a
  std::size_t num_pairs_ = 0;
};

}  // namespace graspless::planning
