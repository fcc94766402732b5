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
#include "graspless/watch.hpp"

#include "mechanics/contacts/wrenches.hpp"
#include "mechanics/stability/fixed_forces.hpp"
#include "mechanics/stability/friction_query.hpp"
#include "mechanics/stability/reference.hpp"
#include "text.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kSameStability = 1e-9;  // tolerance of z, relative to `needed`
constexpr double kSeparated = 1e-9;      // least distance of unit wrenches from a separating plane
constexpr double kWithin = 1e-9;         // fraction by which targets stay within reach
constexpr double kNarrow = 1e-6;         // width of the smallest piece
constexpr int kMaxPieces = 1000;         // of several surfaces; each takes milliseconds

FrictionVerdict fails(const Coefficients& environment, double fingers, const std::string& reason) {
  FrictionVerdict verdict;
  verdict.environment = environment;
  verdict.fingers = fingers;
  verdict.reason = reason;
  return verdict;
}

std::string at(const Coefficients& environment, double fingers) {
  std::string text = " at friction ";
  for (const double coefficient : environment) text += figure(coefficient) + ", ";
  text.resize(text.size() - 2);
  return text + " (environment), " + figure(fingers) + " (fingers)";
}

/// Property of a contact set, for certain coefficients of friction and for intervals of them.
struct Property {
  virtual ~Property() = default;
  virtual bool holds_at(const Coefficients& environment) = 0;
  /// True if the property is proven over the piece.
  virtual bool proven(const Intervals& piece) = 0;
  virtual FrictionVerdict failure(const Coefficients& environment) = 0;
  /// Ends at which cones of sticking contacts are worst.
  virtual Coefficients worst_sticking(const Intervals& all) = 0;
};

/// Halves the intervals until every piece is proven or coefficients fail.
FrictionVerdict settle(const FrictionQuery& query, Property* property) {
  const Intervals& whole = query.environment.friction;
  std::vector<std::size_t> varied = uncertain_surfaces(query, ContactMode::slide);
  for (const Coefficients& end : ends(whole, varied, property->worst_sticking(whole))) {
    if (!property->holds_at(end)) return property->failure(end);
  }
  if (varied.empty()) varied = uncertain_surfaces(query, ContactMode::stick);
  std::vector<Intervals> open = {whole};
  for (int pieces = 0; !open.empty(); ++pieces) {
    poll();
    Intervals piece = std::move(open.back());
    open.pop_back();
    if (property->proven(piece)) continue;
    const Coefficients middle = middles(piece);
    std::size_t widest = varied.empty() ? 0 : varied.front();
    for (const std::size_t s : varied) {
      if (width(piece[s]) > width(piece[widest])) widest = s;
    }
    const bool is_last =
        width(piece[widest]) < kNarrow || (varied.size() > 1 && pieces > kMaxPieces);
    if (!property->holds_at(middle) || is_last) {
      return property->failure(middle);
    }
    open.push_back(piece);
    open.back()[widest].upper = middle[widest];
    piece[widest].lower = middle[widest];
    open.push_back(std::move(piece));
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
  bool holds_at(const Coefficients& environment) override {
    return Reference(with_friction(q_, environment, environment, q_.fingers.upper))
        .internal_force_is_bounded(force_mask(q_.set, q_.modes));
  }
  bool proven(const Intervals& piece) override {
    LinearProgram program;
    for (int i = 0; i < 6; ++i) program.add_variable(-1, 1);  // y
    program.add_variable(0, 1, 1);                            // separation
    for (const auto& slide : {lower_ends(piece), upper_ends(piece)}) {
      const ContactSet set = with_friction(q_, upper_ends(piece), slide, q_.fingers.upper);
      add(wrenches_of_environment(set).generators, &program);
      const std::vector<FingerWrenches> fingers = wrenches_of_fingers(set);
      for (std::size_t i = 0; i < fingers.size(); ++i) {
        if (q_.modes[i] == FingerMode::position) add(fingers[i].generators, &program);
      }
    }
    return solve_lp(program).objective > kSeparated;
  }
  FrictionVerdict failure(const Coefficients& environment) override {
    return fails(environment, q_.fingers.upper,
                 "contact forces may grow without bound against each other" +
                     at(environment, q_.fingers.upper));
  }
  Coefficients worst_sticking(const Intervals& all) override { return upper_ends(all); }

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
    for (std::size_t i = 0; i < q_.set.contacts.size(); ++i) {
      const Contact& contact = q_.set.contacts[i];
      if (contact.mode != ContactMode::slide) continue;
      const Eigen::Vector3d t = tangent(contact.n_O, contact.t_O);
      Vector6d wrench;
      wrench << t, (contact.p_OC - q_.set.com_O).cross(t);
      drag_.push_back({q_.set.wrench_scale * wrench, q_.surface(i)});
    }
  }
  bool holds_at(const Coefficients& environment) override {
    z_ = FixedForces(with_friction(q_, environment, environment, q_.fingers.lower), q_.modes,
                     q_.commanded_forces)
             .stability(q_.directions);
    return enough(z_);
  }
  bool proven(const Intervals& piece) override {
    const FixedForces balance(
        with_friction(q_, lower_ends(piece), middles(piece), q_.fingers.lower), q_.modes,
        q_.commanded_forces);
    double bound = balance.stability(q_.directions);
    if (!std::isfinite(bound)) return false;  // the contacts jam
    const bool varies = std::any_of(drag_.begin(), drag_.end(), [&](const Drag& drag) {
      return width(piece[drag.surface]) > 0;
    });
    if (varies && enough(bound)) {
      bound *= 1 - kWithin;
      bound -= decrease(balance, bound, piece);
    }
    if (!enough(bound)) return false;
    least_ = std::min(least_, bound);
    return true;
  }
  FrictionVerdict failure(const Coefficients& environment) override {
    const double fingers = q_.fingers.lower;
    const std::string what =
        enough(z_) ? "a stability of " + figure(q_.needed) + " N can be neither proven nor refuted"
                   : "the stability is " + figure(z_) + " N, less than " + figure(q_.needed) + " N";
    return fails(environment, fingers, what + at(environment, fingers));
  }
  Coefficients worst_sticking(const Intervals& all) override { return lower_ends(all); }
  double least() const { return least_; }

 private:
  bool enough(double z) const { return z >= q_.needed - kSameStability * std::max(1.0, q_.needed); }

  /// R^1/2 W_i t_i of a sliding contact.
  struct Drag {
    Vector6d wrench;
    std::size_t surface;
  };

  /// Largest decrease of z over the piece: away from its middle, the forces k_d that reach z l_d
  /// miss it by delta sum k_i t_i for each surface, to either side.
  double decrease(const FixedForces& balance, double z, const Intervals& piece) const {
    std::vector<std::vector<Vector6d>> misses(piece.size());
    for (Eigen::Index d = 0; d < q_.directions.cols(); ++d) {
      const Eigen::VectorXd forces = balance.sliding_forces(z * q_.directions.col(d));
      std::vector<Vector6d> drags(piece.size(), Vector6d::Zero());
      for (std::size_t i = 0; i < drag_.size(); ++i) {
        drags[drag_[i].surface] += forces[i] * drag_[i].wrench;
      }
      for (std::size_t s = 0; s < piece.size(); ++s) {
        misses[s].push_back(drags[s]);
        misses[s].push_back(-drags[s]);
      }
    }
    double sum = 0;
    for (std::size_t s = 0; s < piece.size(); ++s) {
      const double delta = width(piece[s]) / 2;
      if (delta > 0) sum += delta * largest_gauge(q_.directions, misses[s]);
    }
    return sum;
  }

  const FrictionQuery& q_;
  std::vector<Drag> drag_;
  double z_ = 0, least_ = kInfinity;
};

}  // namespace

FrictionVerdict holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                                    const Eigen::VectorXd& commanded_forces,
                                    const Surfaces& environment, const FrictionInterval& fingers,
                                    double needed, const Matrix6Xd& directions) {
  const FrictionQuery query{set, modes, commanded_forces, environment, fingers, needed, directions};
  validate(query);
  NoJam no_jam(query);
  FrictionVerdict verdict = settle(query, &no_jam);
  if (!verdict.holds) return verdict;
  StableEnough stable(query);
  verdict = settle(query, &stable);
  if (verdict.holds) verdict.least_stability = stable.least();
  return verdict;
}

FrictionVerdict holds_over_friction(const ContactSet& set, const std::vector<FingerMode>& modes,
                                    const Eigen::VectorXd& commanded_forces,
                                    const FrictionInterval& environment,
                                    const FrictionInterval& fingers, double needed,
                                    const Matrix6Xd& directions) {
  const Surfaces one{{environment}, std::vector<int>(set.contacts.size(), 0)};
  return holds_over_friction(set, modes, commanded_forces, one, fingers, needed, directions);
}

}  // namespace graspless::mechanics
