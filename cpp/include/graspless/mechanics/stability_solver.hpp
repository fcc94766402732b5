// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/mechanics/contact.hpp"
#include "graspless/mechanics/stability.hpp"

namespace graspless::mechanics {

/// What the environment can do to an object, in scaled wrench space: the part of Eq. (3) that does
/// not depend on the fingers.
struct EnvironmentWrenches {
  Matrix6Xd generators;  ///< R^1/2 W_env C_env, a column an edge
  /// Those of Problem (5) where they are others (friction known as an interval: its upper end);
  /// empty: `generators`.
  Matrix6Xd jam_generators;
  Vector6d known = Vector6d::Zero();  ///< R^1/2 Q_known
};

/// What one finger can do to an object.
struct FingerWrenches {
  Matrix6Xd generators;          ///< R^1/2 W_rob C_rob, a column an edge
  Matrix6Xd jam_generators;      ///< as EnvironmentWrenches::jam_generators
  Eigen::VectorXd normal;        ///< n . c_j: the normal force of each edge's unit [-]
  double max_normal_force = 10;  ///< [N]
};

GRASPLESS_API EnvironmentWrenches environment_wrenches(const ContactSet& set);
GRASPLESS_API FingerWrenches finger_wrenches(const ContactSet& set, int finger);

/// A set of fingers in force control, as bits: finger i by 1 << i.
using ForceMask = unsigned;

/// Solves (5) and (6) for many contact sets. Holds its workspace and the last critical direction;
/// allocates nothing once warm. One a thread.
///
/// Problem (6) falls apart into ray shots that share f_com alone: for fixed f_com, z is the least
/// over the directions d of b_d(f_com) = max { z : z l_d in S(f_com) }, S the set of wrenches that
/// can be balanced. A basis that carries one target z l_d often carries the next; a row of its
/// inverse that proves a target out of reach is a facet of S and gives a cut z <= a + b . f_com,
/// valid for every direction and every f_com. The model of all cuts is maximised anew after each
/// (dual simplex in 1 + number of force fingers dimensions); done when all targets are reached at
/// the model's maximum.
class GRASPLESS_API StabilitySolver {
 public:
  /// Throws std::invalid_argument unless the directions (6 x N) are finite and positively span the
  /// space.
  explicit StabilitySolver(const Matrix6Xd& directions = disturbance_directions());
  StabilitySolver(StabilitySolver&&) noexcept;
  StabilitySolver& operator=(StabilitySolver&&) noexcept;
  ~StabilitySolver();

  /// The instant that is asked about from now on. Several environments are the same instant under
  /// several coefficients of friction: answers hold for all of them with one f_com. What is pointed
  /// to must outlive the questions; at most kMaxFingers fingers.
  void set(const std::vector<const EnvironmentWrenches*>& environments,
           const std::vector<const FingerWrenches*>& fingers);
  /// The same for a contact set, which is copied. Where it is ill-conditioned, answers are more
  /// accurate than from its rounded wrenches. Throws as validate().
  void set(const ContactSet& set);

  /// Problem (5).
  bool internal_force_is_bounded(ForceMask force);

  /// Problem (6). Stops as soon as z < needed is proven, with a bound in place of z: then
  /// result.z < needed, and it is an upper bound only.
  Stability max_stability(ForceMask force, double needed = 0);

  /// max_stability() without the directions: all in place, for callers in a hurry.
  struct Evaluation {
    double z = 0;
    Eigen::Vector4d commanded_forces = Eigen::Vector4d::Zero();
  };
  Evaluation evaluate(ForceMask force, double needed = 0);

  /// Section 3.4, over combinations of control modes. `found` is false when z < needed is proven.
  struct Best {
    bool found = false;
    ForceMask force = 0;
    double z = 0;  ///< an upper bound when not found
    Eigen::Vector4d commanded_forces = Eigen::Vector4d::Zero();
    unsigned ties = 0;  ///< masks of equal z (to 1e-9), as bits: mask m by 1 << m
  };
  Best best_control_modes(double needed = 0);

  /// Wrench functionals found since clear_supports(), as columns: y . g <= 0 for every generator g
  /// of the environment that was set (the first of several counts: cuts of others are not kept), so
  /// that for any fingers
  ///   z <= (y . known + sum over fingers of h(finger)) / max over d of y . l_d,
  ///   h(finger) = max_normal_force * max(0, max_j y . c_j / normal_j).
  const std::vector<Vector6d>& supports() const;
  void clear_supports();

  struct Counters {
    std::int64_t evaluations = 0;    ///< of Problem (6)
    std::int64_t bounded_tests = 0;  ///< of Problem (5)
    std::int64_t pivots = 0;
    std::int64_t handed_over = 0;  ///< of both, to the reference engine: ill-conditioned contacts
  };
  const Counters& counters() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graspless::mechanics
