// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Joint motions that carry fingertips along prescribed paths, without a jump, and those that are
// free to choose their way.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "graspless/planning/budget.hpp"
#include "graspless/planning/path.hpp"
#include "graspless/realize/realize.hpp"

#include "realize/hand.hpp"

namespace graspless::realize {

/// Contacts of the fingers of a plan: column i for finger i, in O.
struct Grip {
  Eigen::Matrix3Xd center_O;  // of the spheres [m]
  Eigen::Matrix3Xd n_O;       // into the object
};

/// Motion of the held fingertips while the object moves along screws from pose to pose. Their
/// centres go straight from from_O to to_O, in O.
struct Stretch {
  std::vector<Eigen::Isometry3d> X_WO;  // one pose: the object stands still
  int parts = 1;                        // rows from one pose to the next, at least
  Eigen::Matrix3Xd from_O, to_O;
  FingerMask held = 0;
  /// Normals of the contacts: the fingertips shall turn with the object; empty: as they like.
  Eigen::Matrix3Xd n_O = {};

  int arcs() const { return X_WO.size() < 2 ? 1 : static_cast<int>(X_WO.size()) - 1; }
  Eigen::Isometry3d pose(double s) const;  // s in [0, arcs()]
  TipTargets targets(double s) const;
};

/// Rows up to the first failure.
struct Tracked {
  std::vector<Eigen::VectorXd> positions;
  std::vector<Eigen::Isometry3d> X_WO;
  double reached = 0;  // s of the last row
  std::string fault;   // why no further; empty when complete
  bool is_complete() const { return fault.empty(); }
};

/// Configuration that a stretch is pulled to as far as the fingertips leave room; nothing: away
/// from the limits only.
using Bias = std::optional<Eigen::VectorXd>;

/// Follows the stretch from q, which is at its beginning. Contacts are as last set in the scene.
Tracked track(Hand& hand, const Stretch& stretch, const Eigen::VectorXd& q, const Bias& bias = {});

/// JointSegment::scrub of rows with the held fingers in contact.
double scrub(const Hand& hand, const JointSegment& rows, const Eigen::Matrix3Xd& n_O,
             FingerMask held);

/// Rows from one configuration to another while the object stands where the scene has it and the
/// fingers in held.held stay at held.p_WT (none held: any free motion). Contacts are as last set.
/// Empty if `iterations` of the tree search found no path.
std::optional<planning::Path> reach(Hand& hand, const TipTargets& held, const Eigen::VectorXd& from,
                                    const Eigen::VectorXd& to, int iterations,
                                    planning::Clock& clock, std::mt19937_64& rng);

}  // namespace graspless::realize
