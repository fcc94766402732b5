// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "graspless/clasp/clasp.hpp"

#include "clasp/grip.hpp"
#include "scene/replay.hpp"

/// check(): one function per property of a plan. The formulas are implemented independently of the
/// search, so that a mistake there cannot go unnoticed here.
namespace graspless::clasp {

constexpr double kTolerance = 1e-6;  // [m, rad]

using Faults = std::vector<std::string>;

/// Gauss linking integral, eq. (1), of two closed polylines: sum of the solid angles of all pairs
/// of segments (Klenin, Langowski 2000, method 1a).
double double_integral(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b);

/// Corners of the curve from the tip of a finger to the tip of the thumb, 3 x n in W [m].
Eigen::Matrix3Xd curve_in_world(const Problem& problem, int finger, const Eigen::VectorXd& q);

/// A short stability test in which FCL decides: makes random moves of the object, each until it
/// touches the hand at q. Returns true if the loop came free.
bool comes_free(const Problem& problem, int loop, const Eigen::VectorXd& q);

/// Checks one plan.
class PlanChecker {
 public:
  PlanChecker(const Problem& problem, const Plan& plan, const Options& options);

  Faults run();
  /// Proves what lies between the rows. Throws std::invalid_argument if the plan is not one.
  scene::EdgeCertificate certify();

 private:
  template <typename... Parts>
  void fault(const std::string& where, const Parts&... parts) {
    std::ostringstream text;
    text << where << ": ";
    (text << ... << parts);
    faults_.push_back(text.str());
  }
  static std::string at(const Segment& segment, std::size_t row) {
    return segment.name + " row " + std::to_string(row);
  }
  const Segment& reach() const { return plan_.segments[0]; }
  const Segment& close() const { return plan_.segments[1]; }
  const Eigen::VectorXd& q_end() const { return close().positions.back(); }
  /// The closed hand within its limits: tests of it take no other.
  Eigen::VectorXd q_closed() const { return problem_.robot.clamp(q_end()); }
  const Eigen::Matrix3Xd& loop_points() const;

  bool is_complete();
  bool has_sound_rows(const Segment& segment);
  void check_rows();
  void check_collisions(const Segment& segment);
  void check_target();
  bool is_marked() const;
  void check_tangent();
  void check_pull();
  void check_hand_at_target();
  Eigen::Matrix3Xd loop_W() const;
  void check_linking(const Segment& segment);
  void check_threshold();
  void check_hand_closes();
  void check_closed_until_contact();
  void check_stability();
  void check_pinch();
  void check_certificate();

  const Grip grip_;  // the fingers that the plan says
  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  scene::Replay replay_;
  Faults faults_;
};

}  // namespace graspless::clasp
