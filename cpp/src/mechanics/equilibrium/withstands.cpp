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
      supplied_ -= wrench_at(set, set.fingers[j].p_OC,
                             nominal.finger_forces_O.col(static_cast<Eigen::Index>(j)));
    }
  }

  /// Largest t up to `most` with these springs; any t <= `enough` if it is not more than that.
  double largest(const Compliance& compliance, double most, double enough) const {
    const auto found = sprung(set_, modes_, compliance, demands_);
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

 private:
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
    const std::size_t contacts = set_.contacts.size();
    for (Eigen::Index d = 0; d < demands_.cols() && t > 0; ++d) {
      Vector6d change = demands_.col(d);
      for (std::size_t j = 0; j < set_.fingers.size(); ++j) {
        change -= wrench_at(set_, set_.fingers[j].p_OC, springs[contacts + j].changes.col(d));
      }
      t = support_.within(supplied_, change, t);
    }
    return t;
  }

  const ContactSet& set_;
  const std::vector<FingerMode>& modes_;
  const Equilibrium& nominal_;
  const Yield& yield_;
  Matrix6Xd demands_;  // R^-1/2 l_i
  Support support_;
  Vector6d supplied_;  // wrench of the environment without a disturbance
};

}  // namespace

double withstands(const ContactSet& set, const std::vector<FingerMode>& modes,
                  const Equilibrium& nominal, const Compliance& compliance, const Yield& yield,
                  const Matrix6Xd& directions) {
  validate(set);
  validate_modes(set, modes);
  validate_nominal(set, nominal);
  planning::require_in_range("compliance.", compliance);
  validate_yield(yield);
  validate_directions(directions);
  const Law law(set, modes, nominal, yield, directions);
  const Compliance& c = compliance;
  const double rigid = kRigid * std::max({c.environment_normal, c.environment_tangential,
                                          c.finger_normal, c.finger_tangential});
  const auto with = [&](double normal, double tangential, double most, double enough) {
    return law.largest({normal, tangential, c.finger_normal, c.finger_tangential}, most, enough);
  };
  const double most = largest_force(set);
  const double sticks = with(rigid, rigid, law.largest(compliance, most, 0), 0);
  const bool can_give =
      std::any_of(set.contacts.begin(), set.contacts.end(),
                  [](const Contact& at) { return at.mode == ContactMode::stick; });
  if (!can_give) return sticks;
  const double shares = std::max(sticks, with(rigid, c.finger_tangential, most, sticks));
  return std::max(shares, with(rigid, kGiven * c.finger_tangential, most, shares));
}

}  // namespace graspless::mechanics
