// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "graspless/planning/path.hpp"

#include "slide/hand_motion.hpp"
#include "slide/query.hpp"

namespace graspless::slide {

/// Motion from q_home onto the object; rows are configurations of the arm.
struct Approach {
  planning::Path free;   ///< from q_home to above the contact
  planning::Path press;  ///< down to the touch, then along the retreat line to the start
};

/// Motion off the object after the slide, and the grasp; only `lift` and `object_goal` if the
/// object is left there.
struct Handling {
  planning::Path lift;   ///< along the retreat line until the finger is off the object, then up
  planning::Path reach;  ///< free motion to the start of the straight approach
  planning::Path grasp;  ///< straight approach to H_g
  std::vector<Eigen::VectorXd>
      close;  ///< configurations of all joints; the last one touches the object
  Placement placement;
  Planar object_goal;      ///< kappa_g in S
  Eigen::Isometry3d X_WH;  ///< H_g
};

/// Plans the motions before and after the slide and implements IsPairValid() of Section IV-C.1.
class GRASPLESS_API Motions {
 public:
  explicit Motions(Query& query)
      : query_(query),
        hand_(query.problem.robot, query.arm, query.free, query.options.resolution,
              query.statistics.ik_calls) {}

  /// Makes `start` a start where the finger presses already: it needs no approach.
  void begin_at(const Eigen::VectorXd& start) {
    approaches_[std::vector<double>(start.begin(), start.end())].found = Approach{};
  }

  /// IsPairValid(): checks the overhang, the centre of mass, and the motions onto the start and
  /// from the goal to the grasp.
  bool is_pair_valid(const Eigen::VectorXd& start, const Eigen::VectorXd& goal);
  /// True if a collision-free configuration exists that grasps the object at this pose.
  bool is_graspable(const Planar& object_S, const Placement& place);

  /// Returns the motion that takes a pressing finger off the object, to options.lift_height above
  /// it; nothing if it collides or leaves the arm's reach.
  std::optional<planning::Path> lift_from(const Eigen::VectorXd& pressed, const Planar& object_S);
  /// The same for a finger that does not press on the object.
  std::optional<planning::Path> rise_from(const Eigen::VectorXd& start, const Planar& object_S);

  /// Motions of the pair that was last found valid.
  const Approach& approach() const { return *valid_approach_; }
  const Handling& handling() const { return *handling_; }

 private:
  struct GraspConfiguration {
    Eigen::VectorXd arm;
    int roll;
    double deep;  ///< way from the middle of what sticks out towards the edge [m]
  };

  bool is_goal(Handling& handling);
  const std::optional<Approach>& approach_to(const Eigen::VectorXd& start);
  std::optional<Approach> find_approach(const Eigen::VectorXd& start, int iterations);
  int search_iterations() const;
  bool stands_still(const planning::Path& lift, int steps, const Planar& contact);
  std::vector<GraspConfiguration> grasp_configurations(const Placement& placement,
                                                       std::size_t enough);
  void refuse_grasp(const std::optional<std::pair<int, int>>& touching, const Eigen::VectorXd& q);
  bool find_reach(Handling& handling);
  bool add_grasp(const GraspConfiguration& grasp, Handling& handling);
  bool add_reach(Handling& handling, int iterations);
  bool add_close(Handling& handling);
  std::optional<planning::Path> free_path(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                          int iterations);
  std::optional<std::vector<Eigen::VectorXd>> close_hand(const Eigen::VectorXd& arm);
  bool is_straight(const planning::Path& path, const Handling& handling, int roll);
  void place_object(const Planar& object_S);

  Query& query_;
  HandMotion hand_;
  struct Drawn {
    Planar object_S = Planar::Identity();
    Eigen::Vector2d out_center = Eigen::Vector2d::Zero();  // of its placement
    std::vector<GraspConfiguration> grasps;
  };

  struct KnownApproach {
    std::optional<Approach> found;
    int iterations = -1;  // of the last search that failed
  };

  std::map<std::vector<double>, KnownApproach> approaches_;  // by start configuration
  int num_refused_ = 0;                                      // pairs rejected for want of a motion
  std::vector<Drawn> drawn_;                                 // last results of is_graspable()
  std::optional<Approach> valid_approach_;
  std::optional<Handling> handling_;
};

}  // namespace graspless::slide
