// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Largest disturbance that fingers as springs and a rigid or yielding environment withstand.
#include "graspless/mechanics/withstands.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mechanics/equilibrium/inner_forces.hpp"
#include "mechanics/equilibrium/springs.hpp"
#include "mechanics/equilibrium/support.hpp"
#include "mechanics/stability/control.hpp"

namespace graspless::mechanics {
namespace {

// Stiffness of a rigid environment, relative to the largest given.
constexpr double kRigid = 1e5;
// Relative difference that is rounding.
constexpr double kEven = 1e-9;
// Stiffness of friction that has given way, relative to a finger along the surface.
constexpr double kGiven = 0.1;

void validate_yield(const Yield& yield) {
  if (!yield.points_O.allFinite()) throw std::invalid_argument("yield.points_O must be finite");
  if (!(yield.distance > 0)) throw std::invalid_argument("yield.distance must be positive");
}

Vector6d wrench_at(const ContactSet& set, const Eigen::Vector3d& p_OC, const Eigen::Vector3d& f) {
  Vector6d wrench;
  wrench << f, (p_OC - set.com_O).cross(f);
  return wrench;
}

class Law {
 public:
  Law(const ContactSet& set, const std::vector<FingerMode>& modes, const Equilibrium& nominal,
      const Yield& yield, const Matrix6Xd& directions)
      : set_(set),
        modes_(modes),
        nominal_(nominal),
        yield_(yield),
        demands_(set.wrench_scale.partialPivLu().solve(directions)),
        support_(set),
        supplied_(-set.known_wrench_O) {
    for (std::size_t j = 0; j < set.fingers.size(); ++j) {
      supplied_ -= wrench_at(set, set.fingers[j].p_OC, nominal.finger_forces_O.col(j));
    }
  }

  std::optional<Sprung> sprung_by(const Compliance& compliance) const {
    return sprung(set_, modes_, compliance, demands_);
  }

  /// Largest t up to `most` with these springs; any t <= `enough` if it is not more than that.
  double largest(const std::optional<Sprung>& found, double most, double enough) const {
    if (!found) return 0;
    double t = within_yield(found->moved, most);
    const std::size_t contacts = set_.contacts.size();
    for (std::size_t i = 0; i < found->springs.size(); ++i) {
      const Spring& spring = found->springs[i];
      const Eigen::Vector3d force_O = force_at(nominal_, i);
      if (i >= contacts) {
        t = std::min({t, spring.within_cone(force_O), spring.within_limit(force_O)});
      } else if (!support_.is_closed_form()) {
        t = std::min(t, spring.within_cone(force_O));
      }
    }
    if (t <= enough || !support_.is_closed_form()) return t;
    return within_support(found->springs, t);
  }

  /// An e such that all conditions hold, with these springs and without a disturbance, while every
  /// finger is out of its place by e at most, in any direction.
  double tolerates(const Compliance& compliance) const {
    const auto found = misplaced(set_, modes_, compliance);
    if (!found) return 0;
    double e = within_yield_by_errors(found->moved);
    const bool is_closed = support_.is_closed_form();
    for (std::size_t i = is_closed ? set_.contacts.size() : 0; i < found->springs.size(); ++i) {
      e = std::min(e, found->springs[i].tolerates(force_at(nominal_, i)));
    }
    if (!is_closed) return e;
    Matrix6Xd changes(6, found->moved.cols());  // of what the environment supplies
    for (Eigen::Index k = 0; k < changes.cols(); ++k) {
      changes.col(k) = rest(Vector6d::Zero(), found->springs, k);
    }
    return std::min(e, support_.tolerates(supplied_, changes));
  }

 private:
  double within_yield_by_errors(const Matrix6Xd& moved) const {
    double e = Spring::kUnlimited;
    for (Eigen::Index k = 0; k < yield_.points_O.cols(); ++k) {
      const Eigen::Vector3d lever = yield_.points_O.col(k) - set_.com_O;
      double far = 0;
      for (Eigen::Index j = 0; j + 3 <= moved.cols(); j += 3) {
        Eigen::Matrix3d way = moved.block<3, 3>(0, j);
        for (int axis = 0; axis < 3; ++axis) {
          way.col(axis) += Eigen::Vector3d(moved.col(j + axis).tail<3>()).cross(lever);
        }
        far += largest_stretch(way);
      }
      if (far > 0) e = std::min(e, yield_.distance / far);
    }
    return e;
  }

  double within_yield(const Matrix6Xd& moved, double t) const {
    for (Eigen::Index k = 0; k < yield_.points_O.cols(); ++k) {
      const Eigen::Vector3d lever = yield_.points_O.col(k) - set_.com_O;
      for (Eigen::Index d = 0; d < moved.cols(); ++d) {
        const Eigen::Vector3d way =
            moved.col(d).head<3>() + Eigen::Vector3d(moved.col(d).tail<3>()).cross(lever);
        const double far2 = way.squaredNorm();
        if (t * t * far2 > yield_.distance * yield_.distance) t = yield_.distance / std::sqrt(far2);
      }
    }
    return t;
  }

  double within_support(const std::vector<Spring>& springs, double t) const {
    for (Eigen::Index d = 0; d < demands_.cols() && t > 0; ++d) {
      t = support_.within(supplied_, rest(demands_.col(d), springs, d), t);
    }
    return t;
  }

  /// What is left of a wrench beside what the fingers supply by change k of their forces.
  Vector6d rest(Vector6d wrench, const std::vector<Spring>& springs, Eigen::Index k) const {
    for (std::size_t j = 0; j < set_.fingers.size(); ++j) {
      const Spring& spring = springs[set_.contacts.size() + j];
      wrench -= wrench_at(set_, set_.fingers[j].p_OC, spring.changes.col(k));
    }
    return wrench;
  }

  const ContactSet& set_;
  const std::vector<FingerMode>& modes_;
  const Equilibrium& nominal_;
  const Yield& yield_;
  Matrix6Xd demands_;  // R^-1/2 l_i
  Support support_;
  Vector6d supplied_;  // wrench of the environment without a disturbance
};

/// Stiffnesses of the springs with which a set withstands most, and how much.
struct Holding {
  double disturbance = 0;
  std::vector<Compliance> springs;
};

/// The environment sticks, or its friction gives way and the set withstands more. `given`: the
/// springs of the compliance.
Holding holding(const Law& law, const ContactSet& set, const Compliance& c,
                const std::optional<Sprung>& given) {
  const double rigid = kRigid * std::max({c.environment_normal, c.environment_tangential,
                                          c.finger_normal, c.finger_tangential});
  const auto with = [&](double normal, double tangential) {
    return Compliance{normal, tangential, c.finger_normal, c.finger_tangential};
  };
  const double most = largest_force(set);
  const Compliance sticks = with(rigid, rigid);
  Holding found{law.largest(law.sprung_by(sticks), law.largest(given, most, 0), 0), {c, sticks}};
  const bool can_give =
      std::any_of(set.contacts.begin(), set.contacts.end(),
                  [](const Contact& at) { return at.mode == ContactMode::stick; });
  if (!can_give) return found;
  for (const double share : {1.0, kGiven}) {
    const Compliance gives = with(rigid, share * c.finger_tangential);
    const double t = law.largest(law.sprung_by(gives), most, found.disturbance);
    if (t > found.disturbance * (1 + kEven)) found = {t, {gives}};
  }
  return found;
}

void validate_all(const ContactSet& set, const std::vector<FingerMode>& modes,
                  const Equilibrium& nominal, const Compliance& compliance, const Yield& yield,
                  const Matrix6Xd& directions) {
  validate(set);
  validate_modes(set, modes);
  validate_nominal(set, nominal);
  planning::require_in_range("compliance.", compliance);
  validate_yield(yield);
  validate_directions(directions);
}

}  // namespace

double withstands(const ContactSet& set, const std::vector<FingerMode>& modes,
                  const Equilibrium& nominal, const Compliance& compliance, const Yield& yield,
                  const Matrix6Xd& directions) {
  validate_all(set, modes, nominal, compliance, yield, directions);
  const Law law(set, modes, nominal, yield, directions);
  return holding(law, set, compliance, law.sprung_by(compliance)).disturbance;
}

Promise promise(const ContactSet& set, const std::vector<FingerMode>& modes,
                const Equilibrium& nominal, const Compliance& compliance, const Yield& yield,
                const Matrix6Xd& directions, const std::optional<Sprung>& found) {
  validate_nominal(set, nominal);
  validate_yield(yield);
  const Law law(set, modes, nominal, yield, directions);
  const Holding held = holding(law, set, compliance, found);
  if (!(held.disturbance > 0)) return {};
  double e = Promise::kAnyPlace;
  for (const Compliance& springs : held.springs) e = std::min(e, law.tolerates(springs));
  return {held.disturbance, e};
}

Promise promise(const ContactSet& set, const std::vector<FingerMode>& modes,
                const Equilibrium& nominal, const Compliance& compliance, const Yield& yield,
                const Matrix6Xd& directions) {
  validate_all(set, modes, nominal, compliance, yield, directions);
  return promise(set, modes, nominal, compliance, yield, directions,
                 sprung_along(set, modes, compliance, directions));
}

}  // namespace graspless::mechanics
