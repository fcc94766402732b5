// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "graspless/slide/slide.hpp"

#include "scene/rows.hpp"
#include "slide/check/finger_span.hpp"
#include "slide/check/replay.hpp"
#include "slide/contact.hpp"
#include "slide/friction/pressed.hpp"
#include "slide/task/hand_frames.hpp"

/// Implements check(): one function for each property of a valid plan. The formulas are written
/// again from the paper and docs/internals/slide.md, so that a mistake in the search does not
/// repeat itself here. Only the risks of friction come from the functions that warn of them, and
/// the tube from the one that integrates it.
namespace graspless::slide {

constexpr double kSame = 1e-6;        // [m, rad]
constexpr double kRimSpacing = 5e-4;  // points on a rim are that far apart, or nearer [m]
constexpr double kRound = 1e-9;       // of a band's ends [m, rad]
// Allowed movement and turn of the contact while the finger presses or lifts [m, rad]. The movement
// may exceed a margin that the slide only just keeps by as much.
constexpr double kStray = 5e-4, kStrayTurn = 1e-3;
constexpr double kSideways = 0.003, kTurned = 0.03;  // of the hand off its straight approach

using Faults = std::vector<std::string>;

/// Signed distance of a point to a polygon's boundary [m], positive inside (by the winding number).
double signed_depth(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& p);

/// Depths of the commanded fingertip below the object's top face: those of the options, or of the
/// model of the finger.
DepthBand allowed_depths(const Hand& hand, const Options& options);

/// Replays one plan and collects its faults.
class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem),
        plan_(plan),
        options_(options),
        depths_(allowed_depths(problem.hand, options)),
        X_SW_(problem.support.X_WS().inverse()),
        fingertip_(problem.robot.frame(problem.hand.fingertip)),
        profile_(problem),
        strict_(problem, depths_.max) {}

  Faults run();
  /// Proves what lies between the rows. Throws std::invalid_argument if the plan is not one.
  scene::EdgeCertificate certify();

  using Finger = ReplayedFinger;
  Finger finger(const Eigen::VectorXd& q) const {
    return finger(problem_.robot.pose(fingertip_, q));
  }
  Finger finger(const Eigen::Isometry3d& X_WF) const;

 private:
  friend class BandProver;

  void fault(const std::string& where, const std::string& what) {
    faults_.push_back(where + ": " + what);
  }
  void fault(const Segment& segment, std::size_t row, const std::string& what) {
    fault(segment.name + " row " + std::to_string(row), what);
  }
  std::vector<std::string> names() const;
  bool has(const std::string& name) const;
  const Segment& segment(const std::string& name) const;

  bool has_shape();
  void check_rows();
  void check_object_poses();
  void check_collisions(const Segment& segment);
  void check_retreat(const Segment& segment);
  void check_pressing(const Segment& segment);
  void check_depth(const Segment& segment, std::size_t row, const Finger& now);
  void check_still(const Segment& segment, std::size_t row, const Finger& now,
                   const Finger& pressed);
  bool is_on_object(const Segment& segment, const Finger& pressed) const;
  double rim_margin() const;
  void check_face(const Eigen::Vector2d& contact_O);
  void check_slide();
  void check_slide_row(const Segment& slide, std::size_t row, const Eigen::VectorXd& q);
  /// The part of the object that sticks out of the support after the slide.
  struct Protrusion {
    bool any = false;
    double overhang = 0;
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    geometry::Polygon::Edge edge{};
    bool is_over_unusable_edge = false;
  };
  Protrusion protrusion() const;
  double held_by_rim(const Planar& X_SO, const Eigen::Vector2d& com) const;
  double highest_near(const Eigen::Vector2d& p_O, const Protrusion& out) const;
  bool is_held_at(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& out,
                  const Eigen::Isometry3d& X_SO) const;
  Eigen::Isometry3d object_start() const;
  Eigen::Isometry3d flat_where_interrupted() const;
  void check_lies_flat();
  void check_hand_open();
  void check_clearance();
  void check_touching_row(const Segment& segment, std::size_t row, const Finger& now);
  void check_pair();
  void check_end();
  void check_held_up();
  void check_grasp();
  void check_closing();
  void check_tube();
  void check_ends(const std::vector<Planar>& ends);
  void check_drag(const std::vector<PressedRow>& rows);
  void check_warnings();
  void check_straight(const Segment& grasp);
  std::vector<scene::Doubt> prove_free(const Segment& segment) const;
  Eigen::Isometry3d followed(const Eigen::Isometry3d& X_WO_start, const Finger& start,
                             const Finger& now) const;

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  DepthBand depths_;
  Eigen::Isometry3d X_SW_;
  int fingertip_;
  FingerProfile profile_;
  Replay strict_;  // in which nothing may touch
  Faults faults_;
};

}  // namespace graspless::slide
