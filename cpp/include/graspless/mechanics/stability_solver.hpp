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

/// Wrenches that the environment can exert on an object, in scaled wrench space: the part of Eq.
/// (3) that does not depend on the fingers.
struct EnvironmentWrenches {
  Matrix6Xd generators;  ///< R^1/2 W_env C_env, one column per edge of a cone
  /// Generators for Problem (5) if they differ: friction at the upper end of its interval. Empty:
  /// the same as `generators`.
  Matrix6Xd jam_generators;
  Vector6d known = Vector6d::Zero();  ///< R^1/2 Q_known
};

/// Wrenches that one finger can exert on an object, in scaled wrench space.
struct FingerWrenches {
  Matrix6Xd generators;          ///< R^1/2 W_rob C_rob, one column per edge of the cone
  Matrix6Xd jam_generators;      ///< like EnvironmentWrenches::jam_generators
  Eigen::VectorXd normal;        ///< n . c_j: normal force per unit of each edge's coefficient [-]
  double max_normal_force = 10;  ///< [N]
};

/// Both throw like validate(), and finger_wrenches() for an index without a finger.
GRASPLESS_API EnvironmentWrenches environment_wrenches(const ContactSet& set);
GRASPLESS_API FingerWrenches finger_wrenches(const ContactSet& set, int finger);

/// Set of fingers in force control: bit i stands for finger i.
using ForceMask = unsigned;

/// Solves (5) and (6) for many contact sets. Keeps its workspace and the last critical direction,
/// and allocates no memory once warm. Use one per thread.
///
/// Problem (6) decomposes into ray shots that share only f_com: for fixed f_com, z is the least
/// over the directions d of b_d(f_com) = max { z : z l_d in S(f_com) }, where S is the set of
/// wrenches that can be balanced. A basis that carries one target z l_d often carries the next. A
/// row of its inverse that proves a target out of reach is a facet of S and gives a cut z <= a + b
/// . f_com, valid for every direction and every f_com. The model of all cuts is maximised after
/// each new one (dual simplex in 1 + number of force fingers dimensions), until all targets are
/// reached at its maximum.
///
/// Rays are shot in double precision. Where a basis that decides is so ill-conditioned that
/// rounding could be the reason, as with contacts nearly on a line, the problem goes to
/// Engine::reference.
class GRASPLESS_API StabilitySolver {
 public:
  /// Throws std::invalid_argument unless the directions (6 x N) are finite and positively span the
  /// space.
  explicit StabilitySolver(const Matrix6Xd& directions = disturbance_directions());
  StabilitySolver(StabilitySolver&&) noexcept;
  StabilitySolver& operator=(StabilitySolver&&) noexcept;
  ~StabilitySolver();

  /// Sets the contacts for the calls that follow. Several environments are the same instant under
  /// several coefficients of friction: results hold for all of them, with one f_com. The wrenches
  /// must outlive those calls. Throws std::invalid_argument on no environment, more than
  /// kMaxFingers fingers, or a finger without one normal force for each of its generators.
  void set(const std::vector<const EnvironmentWrenches*>& environments,
           const std::vector<const FingerWrenches*>& fingers);
  /// The same for a contact set, which is copied. If it is ill-conditioned, results are more
  /// accurate than those from its rounded wrenches. Throws like validate().
  void set(const ContactSet& set);

  /// Problem (5): returns true if nothing can jam.
  bool internal_force_is_bounded(ForceMask force);

  /// Problem (6). Stops as soon as z < needed is proven; the result's z is then an upper bound
  /// below `needed`.
  Stability max_stability(ForceMask force, double needed = 0);

  /// max_stability() without the binding directions and without allocating memory.
  struct Evaluation {
    double z = 0;
    Eigen::Vector4d commanded_forces = Eigen::Vector4d::Zero();
  };
  Evaluation evaluate(ForceMask force, double needed = 0);

  /// Best combination of control modes, Section 3.4. `found` is false if z < needed is proven.
  struct Best {
    bool found = false;
    ForceMask force = 0;
    double z = 0;  ///< upper bound if not found
    Eigen::Vector4d commanded_forces = Eigen::Vector4d::Zero();
    unsigned ties = 0;  ///< masks of equal z (to 1e-9): bit m stands for mask m
  };
  Best best_control_modes(double needed = 0);

  /// Facet normals y found since clear_supports(), as wrench functionals: y . g <= 0 for every
  /// generator g of the environment (the first one, if several were set). For any fingers they
  /// bound
  ///   z <= (y . known + sum over fingers of h(finger)) / max over d of y . l_d,
  ///   h(finger) = max_normal_force * max(0, max_j y . c_j / normal_j).
  const std::vector<Vector6d>& supports() const;
  void clear_supports();

  struct Counters {
    std::int64_t evaluations = 0;    ///< number of Problems (6) solved
    std::int64_t bounded_tests = 0;  ///< number of Problems (5) solved
    std::int64_t pivots = 0;         ///< number of pivots of the ray shots
    std::int64_t handed_over = 0;    ///< number of both solved by Engine::reference
  };
  const Counters& counters() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graspless::mechanics
