// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/friction_interval.hpp"
#include "graspless/mechanics/stability.hpp"
#include "graspless/mechanics/withstands.hpp"

#include "fingertip/check/instant.hpp"
#include "fingertip/check/stability.hpp"
#include "mechanics/equilibrium/springs.hpp"

/// check(): the promises of a plan, one function each. The formulas are written anew from the paper
/// and the contract in fingertip.hpp, so that a mistake of the search cannot hide here. Of this
/// room only public types and validate() are used. Shared with the planner: the public functions of
/// mechanics (contact_patches, internal_force_is_bounded with the reference engine,
/// compliant_equilibrium, compliant_stability, holds_over_friction), with_round_cones, collision
/// and geometry.
namespace graspless::fingertip::checking {

using Faults = std::vector<std::string>;
using Poses = std::vector<Eigen::Isometry3d>;
using mechanics::Vector6d;

// withstands.cpp

/// The largest disturbance that an instant withstands: mechanics::withstands() anew.
double withstands_at(const Instant& instant, const mechanics::Equilibrium& nominal,
                     const Options& options, const Eigen::Matrix3Xd& corners_O);

/// Results of examining an instant.
struct Verdict {
  Instant instant;
  double stability = 0;  // the least at the ends of the environment's friction
  double compliant_stability = 0;
  std::optional<mechanics::Equilibrium> nominal;
  mechanics::Promise promise;
  bool is_bounded = false;  // Problem (5)
  mechanics::FrictionVerdict over_friction;
};

// motion.cpp: where the object goes

/// The body twist, linear part first, that carries X_WA to X_WB in unit time.
Vector6d screw_between(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB);
/// Pose to which a body twist carries X_WA in the time t.
Eigen::Isometry3d along_screw(const Eigen::Isometry3d& X_WA, const Vector6d& twist_O, double t);

/// One plan under examination.
class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const Options& options);
  Faults run();

 private:
  struct World;  // spheres and obstacles about the object

  void fault(const std::string& where, const std::string& what);
  template <typename Part>
  void attempt(const std::string& where, const Part& part);
  std::string place(std::size_t segment) const;
  std::string place(std::size_t segment, std::size_t row) const;
  const Segment& segment(std::size_t i) const { return plan_.segments[i]; }
  bool is_regrasp(std::size_t i) const { return segment(i).finger >= 0; }

  // check.cpp: what the plan says of itself
  bool has_shape();
  void check_shape(std::size_t segment);
  void check_state(std::size_t segment, std::size_t row);
  void check_cost();
  void check_weakest();
  double arc_cost(std::size_t segment, std::size_t arc) const;  // Eq. (9)

  // motion.cpp: where the object goes
  void check_chain();
  void check_rows(std::size_t segment);
  void check_names(std::size_t segment);
  int num_tumbles() const;
  Vector6d axis_W(std::size_t segment, std::size_t arc) const;
  void check_motion(const Path& path, const Poses& way);
  void check_motion(const Lattice& lattice, const Poses& way);
  void check_motion(const Goal& goal, const Poses& way);
  bool is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const;
  Vector6d arc_twist(std::size_t segment, std::size_t arc) const;
  Eigen::Isometry3d row_pose(std::size_t segment, std::size_t row) const;

  // fingers.cpp: where the fingers are, and what they and the object must not touch
  void check_fingers();
  void check_start();
  void check_contact(std::size_t segment, std::size_t row, std::size_t finger);
  Eigen::Vector3d center(const FingerState& finger) const;  // of the sphere, in O
  void check_clearances();
  void check_arcs();
  void check_between_rows(World& world, std::size_t segment, std::size_t arc);
  void check_between_regrasps(World& world, std::size_t segment);
  void check_planes(const std::string& where, const Row& row, const Eigen::Isometry3d& X_WO,
                    double slack);
  void check_spheres(const std::string& where, const Row& row);
  void check_world(World& world, const std::string& where, const Row& row,
                   const Eigen::Isometry3d& X_WO);
  double bulge(std::size_t segment, std::size_t arc) const;

  // mechanics.cpp: what holds the object
  void check_mechanics(std::size_t segment, std::size_t row);
  std::string find_instant(std::size_t segment, std::size_t row, Instant& instant) const;
  const Verdict& judged(const Instant& instant);
  Verdict judge(const Instant& instant);
  void check_nominal(std::size_t segment, std::size_t row, const Instant& instant);
  mechanics::Promise promise_of(const Instant& instant, const mechanics::Equilibrium& nominal,
                                const std::optional<mechanics::Sprung>& springs) const;
  void check_withstands(std::size_t segment, std::size_t row, const Instant& instant,
                        const Verdict& found);
  double drift(std::size_t segment, std::size_t row) const;
  mechanics::BodyState state(std::size_t segment, std::size_t row) const;
  bool is_interval() const;

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  double same_length_;  // [m]
  double same_force_;   // [N]
  mechanics::Matrix6d wrench_scale_;
  Stabilities stabilities_;
  mechanics::LpBasis margin_basis_;  // of the last row
  std::vector<Verdict> verdicts_;    // of the instants seen so far
  Faults faults_;
};

}  // namespace graspless::fingertip::checking
