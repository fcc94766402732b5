// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Proves piece by piece that a contact set holds over intervals of friction, or finds a coefficient
// at which it fails.
#include "graspless/mechanics/friction_interval.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/stability/control.hpp"
#include "mechanics/stability/fixed_forces.hpp"
#include "mechanics/stability/reference.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kSameStability = 1e-9;  // tolerance of z, relative to `needed`
constexpr double kSeparated = 1e-9;      // least distance of unit wrenches from a separating plane
constexpr double kWithin = 1e-9;         // fraction by which targets stay within reach
constexpr double kNarrow = 1e-6;         // width of the smallest piece

void validate_interval(const FrictionInterval& interval, const std::string& what) {
  if (interval.lower >= 0 && interval.lower <= interval.upper && std::isfinite(interval.upper)) {
    return;
  }
  throw std::invalid_argument(what + " must be an interval with 0 <= lower <= upper, not " +
                              std::to_string(interval.lower) + " to " +
                              std::to_string(interval.upper));
}

struct FrictionQuery {
  const ContactSet& set;
  const std::vector<FingerMode>& modes;
  const Eigen::VectorXd& commanded_forces;
  FrictionInterval fingers;
  double needed;
  const Matrix6Xd& directions;
};

ContactSet with_friction(const FrictionQuery& q, double stick, double slide, double fingers) {
  ContactSet set = q.set;
  for (Contact& contact : set.contacts) {
    contact.friction = contact.mode == ContactMode::stick ? stick : slide;
  }
  for (Finger& finger : set.fingers) finger.friction = fingers;
  return set;
}

FrictionVerdict fails(double environment, double fingers, const std::string& reason) {
  FrictionVerdict verdict;
  verdict.environment = environment;
  verdict.fingers = fingers;
  verdict.reason = reason;
  return verdict;
}

std::string at(double environment, double fingers) {
  return " at friction " + std::to_string(environment) + " (environment), " +
         std::to_string(fingers) + " (fingers)";
}

/// Property of a contact set, for one coefficient of friction and for an interval of them.
struct Property {
  virtual ~Property() = default;
  virtual bool holds_at(double environment) = 0;
  /// True if the property is proven over the piece.
  virtual bool proven(const FrictionInterval& piece) = 0;
  virtual FrictionVerdict failure(double environment) = 0;
};

/// Halves the interval until every piece is proven or a coefficient fails.
FrictionVerdict settle(const FrictionInterval& interval, Property* property) {
  for (const double end : {interval.lower, interval.upper}) {
    if (!property->holds_at(end)) return property->failure(end);
  }
  std::vector<FrictionInterval> open = {interval};
  while (!open.empty()) {
    const FrictionInterval piece = open.back();
    open.pop_back();
    if (property->proven(piece)) continue;
    const double middle = (piece.lower + piece.upper) / 2;
    if (!property->holds_at(middle) || piece.upper - piece.lower < kNarrow) {
      return property->failure(middle);
    }
    open.push_back({piece.lower, middle});
    open.push_back({middle, piece.upper});
  }
  FrictionVerdict verdict;
  verdict.holds = true;
  return verdict;
}

/// No jamming. It is proven by a y with y . g > 0 for every generator g of (5), since then no sum
/// of generators with positive weights vanishes. A narrower cone lies within a wider one, and the
/// generator of a sliding contact is linear in its coefficient, so checking both ends covers the
/// interval.
class NoJam : public Property {
 public:
  explicit NoJam(const FrictionQuery& query) : q_(query) {}
  bool holds_at(double environment) override {
    return Reference(with_friction(q_, environment, environment, q_.fingers.upper))
        .internal_force_is_bounded(force_mask(q_.set, q_.modes));
  }
  bool proven(const FrictionInterval& piece) override {
    LinearProgram program;
    for (int i = 0; i < 6; ++i) program.add_variable(-1, 1);  // y
    program.add_variable(0, 1, 1);                            // separation
    for (const double slide : {piece.lower, piece.upper}) {
      const ContactSet set = with_friction(q_, piece.upper, slide, q_.fingers.upper);
      add(environment_wrenches(set).generators, &program);
      for (std::size_t i = 0; i < q_.modes.size(); ++i) {
        if (q_.modes[i] == FingerMode::force) continue;
        add(finger_wrenches(set, static_cast<int>(i)).generators, &program);
      }
    }
    return solve_lp(program).objective > kSeparated;
  }
  FrictionVerdict failure(double environment) override {
    return fails(environment, q_.fingers.upper,
                 "contact forces may grow without bound against each other" +
                     at(environment, q_.fingers.upper));
  }

 private:
  static void add(const Matrix6Xd& generators, LinearProgram* program) {
    for (Eigen::Index j = 0; j < generators.cols(); ++j) {
      const int row = program->add_row(0, kInfinity);
      program->set_block(row, 0, generators.col(j).normalized().transpose());
      program->set(row, 6, -1);
    }
  }
  const FrictionQuery& q_;
};

/// z >= needed, by the proof in friction_interval.hpp.
class StableEnough : public Property {
 public:
  explicit StableEnough(const FrictionQuery& query) : q_(query) {
    for (const Contact& contact : q_.set.contacts) {
      if (contact.mode != ContactMode::slide) continue;
      const Eigen::Vector3d t = tangent(contact.n_O, contact.t_O);
      Vector6d wrench;
      wrench << t, (contact.p_OC - q_.set.com_O).cross(t);
      drag_.push_back(q_.set.wrench_scale * wrench);
    }
  }
  bool holds_at(double environment) override {
    z_ = FixedForces(with_friction(q_, environment, environment, q_.fingers.lower), q_.modes,
                     q_.commanded_forces)
             .stability(q_.directions);
    return enough(z_);
  }
  bool proven(const FrictionInterval& piece) override {
    const double middle = (piece.lower + piece.upper) / 2;
    const double delta = (piece.upper - piece.lower) / 2;
    const FixedForces balance(with_friction(q_, piece.lower, middle, q_.fingers.lower), q_.modes,
                              q_.commanded_forces);
    double bound = balance.stability(q_.directions);
    if (!std::isfinite(bound)) return false;  // the contacts jam
    if (delta > 0 && !drag_.empty() && enough(bound)) {
      bound *= 1 - kWithin;
      bound -= delta * decrease(balance, bound);
    }
    if (!enough(bound)) return false;
    least_ = std::min(least_, bound);
    return true;
  }
  FrictionVerdict failure(double environment) override {
    const double fingers = q_.fingers.lower;
    const std::string what = enough(z_) ? "a stability of " + std::to_string(q_.needed) +
                                              " N can be neither proven nor refuted"
                                        : "the stability is " + std::to_string(z_) +
                                              " N, less than " + std::to_string(q_.needed) + " N";
    return fails(environment, fingers, what + at(environment, fingers));
  }
  double least() const { return least_; }

 private:
  bool enough(double z) const { return z >= q_.needed - kSameStability * std::max(1.0, q_.needed); }

  /// Decrease of z per unit of the coefficient: at another one, the forces k_d that reach z l_d
  /// miss it by sum k_i t_i, to either side.
  double decrease(const FixedForces& balance, double z) const {
    std::vector<Vector6d> misses;
    for (Eigen::Index d = 0; d < q_.directions.cols(); ++d) {
      const Eigen::VectorXd forces = balance.sliding_forces(z * q_.directions.col(d));
      Vector6d drag = Vector6d::Zero();
      for (std::size_t i = 0; i < drag_.size(); ++i) {
        drag += forces[static_cast<Eigen::Index>(i)] * drag_[i];
      }
      misses.push_back(drag);
      misses.push_back(-drag);
    }
    return largest_gauge(q_.directions, misses);
  }

  const FrictionQuery& q_;
  std::vector<Vector6d> drag_;  // R^1/2 W_i t_i of each sliding contact
  double z_ = 0, least_ = kInfinity;
};

void validate_query(const FrictionQuery& q, const FrictionInterval& environment) {
  validate(q.set);
  validate_modes(q.set, q.modes);
  validate_commanded_forces(q.set, q.modes, q.commanded_forces);
  validate_interval(environment, "environment");
  validate_interval(q.fingers, "fingers");
  if (!(q.needed >= 0) || !std::isfinite(q.needed)) {
    throw std::invalid_argument("needed must be a stability of 0 N or more, not " +
                                std::to_string(q.needed));
  }
  if (q.directions.cols() == 0 || !q.directions.allFinite()) {
    throw std::invalid_argument("directions must be finite, one at least");
  }
}

}  // namespace

FrictionVerdict holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                                    const Eigen::VectorXd& commanded_forces,
                                    const FrictionInterval& environment,
                                    const FrictionInterval& fingers, double needed,
                                    const Matrix6Xd& directions) {
  const FrictionQuery query{set, modes, commanded_forces, fingers, needed, directions};
  validate_query(query, environment);
  NoJam no_jam(query);
  FrictionVerdict verdict = settle(environment, &no_jam);
  if (!verdict.holds) return verdict;
  StableEnough stable(query);
  verdict = settle(environment, &stable);
  if (verdict.holds) verdict.least_stability = stable.least();
  return verdict;
}

}  // namespace graspless::mechanics
