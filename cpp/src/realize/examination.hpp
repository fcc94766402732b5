// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// check() of a realization: its promises, one function each, written anew from the plan so that a
// mistake of the search cannot hide here. Kinematics, FCL and input validation are shared.
#pragma once

#include <string>
#include <vector>

#include "graspless/fingertip/problem.hpp"
#include "graspless/realize/realize.hpp"
#include "graspless/robot/robot.hpp"

#include "realize/validate.hpp"
#include "scene/bands.hpp"
#include "scene/replay.hpp"

namespace graspless::realize {

/// The robot's links, planes, obstacles and the object as bodies of a world of its own.
class Replay {
 public:
  Replay(const Problem& problem, const robot::Robot& robot);

  /// A link that may reach `depth` [m] into the object against the direction out_O.
  struct Allowed {
    std::string link;
    Eigen::Vector3d out_O;
    double depth;
  };
  /// "a - b" for every pair that touches at these poses.
  std::vector<std::string> touching(const robot::Poses& X_WL, const Eigen::Isometry3d& X_WO,
                                    const std::vector<Allowed>& allowed);
  /// Places the object, and sets the allowances, which turn with it.
  void place(const Eigen::Isometry3d& X_WO, const std::vector<Allowed>& allowed);
  int object() const { return object_; }  ///< index of the object in the world
  scene::Replay& bodies() { return replay_; }

 private:
  scene::Replay replay_;
  int object_ = -1;
};

/// Expected properties of a segment of joint motion.
struct Phase {
  std::string name;
  int plan_segment;
  std::vector<Eigen::Isometry3d> X_WO;  // poses the object passes through; one: it stands still
  std::vector<FingerState> places;      // of each finger
  std::vector<bool> holds, moves;       // at its place all along; straight on or off its place
};

/// The pose at `s` in [0, 1] of the screw from X_WA to X_WB, by the screw's axis.
Eigen::Isometry3d on_screw(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB, double s);

class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const robot::Robot& robot,
              const Carrier& carrier, const Realization& realization,
              const RealizeOptions& options);
  std::vector<std::string> run();
  /// Proves what lies between the rows. Throws std::invalid_argument if these are no joint paths.
  scene::EdgeCertificate certify();

 private:
  void expect_phases();
  bool has_shape();
  bool has_sound_rows(const JointSegment& segment);
  bool assigns_fingertips();
  void check_joints();
  void check_object(const JointSegment& segment, const Phase& phase);
  void check_still(const JointSegment& segment, const Phase& phase);
  void check_segment(const JointSegment& segment, const Phase& phase);
  void check_instant(std::size_t row, const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO,
                     const Phase& phase);
  void check_tips(std::size_t row, const Eigen::Isometry3d& X_WO, const Phase& phase);
  void check_scrub(const JointSegment& segment, const Phase& phase);
  void check_ends(const JointSegment& segment, const Phase& phase);
  std::vector<Replay::Allowed> allowances(const Phase& phase) const;
  std::vector<scene::Doubt> prove_free(const JointSegment& segment, const Phase& phase);
  std::vector<scene::Doubt> prove_tips(const JointSegment& segment, const Phase& phase);
  std::vector<double> tip_bends(const JointSegment& segment, std::size_t edge,
                                const Eigen::VectorXd& step);
  void add_tip(const Phase& phase, std::size_t finger, const Eigen::Vector3d& first,
               const Eigen::Vector3d& last, double off, scene::Slack& slack) const;
  std::string segment_name() const;
  Eigen::Vector3d tip_O(std::size_t finger, const Eigen::Isometry3d& X_WO) const;
  Eigen::Vector3d center_O(std::size_t finger, const Phase& phase) const;

  void fault(std::size_t row, const std::string& what);  // of the segment looked at; once each
  void fault(const std::string& what) { faults_.push_back(what); }

  const Problem& problem_;
  const Plan& plan_;
  const robot::Robot& robot_;
  const Carrier& carrier_;
  const Realization& realization_;
  const RealizeOptions& options_;
  std::vector<Phase> phases_;
  std::vector<int> frame_of_finger_;
  std::vector<std::vector<std::string>> links_of_finger_;
  std::size_t segment_ = 0;
  Replay replay_;
  robot::Poses X_WL_;
  std::vector<std::string> faults_;
};

}  // namespace graspless::realize
