// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "graspless/planning/sampleable_region.hpp"

#include "slide/motions.hpp"
#include "slide/query.hpp"

/// Regions from which the planner samples: C_s of Eq. (3), C_g of Eq. (4), and goals that fit a
/// start.
namespace graspless::slide {

class GRASPLESS_API StartRegion : public planning::SampleableRegion {
 public:
  StartRegion(const ompl::base::SpaceInformationPtr& si, Query& query);
  bool try_sample(ompl::base::State* state) const override;

 private:
  std::int32_t draw_point() const;

  Query& query_;
  std::vector<std::int32_t> contacts_;  ///< indices of contact_points()
  mutable std::vector<std::int32_t>
      nearest_;              ///< the same, the nearest to the centre of mass first
  mutable int refused_ = 0;  ///< draws in a row whose nearest configuration is not valid
  mutable int num_drawn_ = 0;
};

class GRASPLESS_API GoalRegion : public planning::SampleableRegion {
 public:
  /// With `at`, for a slide that goes on from there: all partners are for the same start, so they
  /// differ in the arm's free joint too. The first ones have the object at the former goal, the
  /// next ones over the same edge.
  GoalRegion(const ompl::base::SpaceInformationPtr& si, Query& query, Motions& motions,
             const Interruption* at = nullptr);
  bool try_sample(ompl::base::State* state) const override;
  /// The cost of a pair is the travel of the object [m].
  std::optional<double> try_sample_partner(const ompl::base::State* start, ompl::base::State* goal,
                                           double max_cost) const override;
  bool isStartGoalPairValid(const ompl::base::State* start,
                            const ompl::base::State* goal) const override;

 private:
  bool is_goal(const ContactSpace::Carried& carried, double depth, const Planar& object_S) const;

  /// Goal of the object that was drawn for a start.
  struct Partner {
    Planar object_S;
    double free_joint;  ///< of the arm at the goal [rad]
    int rank;           ///< partners of a smaller rank come first
    double travel;      ///< of the object from the start [m]
  };

  std::vector<Partner> draw_partners(const ContactSpace::Carried& carried,
                                     double joint_at_start) const;
  std::optional<Planar> draw_object_pose(const ContactSpace::Carried& carried) const;
  std::optional<Planar> draw_graspable() const;
  double draw_free_joint(double at_start, int i) const;

  Query& query_;
  Motions& motions_;
  mutable std::discrete_distribution<int> edges_;  ///< to stick out over
  bool has_one_start_;
  std::optional<Planar> former_;  ///< goal pose of the object in S, if it is over an edge
  geometry::Polygon::Edge former_edge_{};
  mutable int num_drawn_ = 0;  ///< object poses
};

}  // namespace graspless::slide
