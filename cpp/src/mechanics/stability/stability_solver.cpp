// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fast engine, which hands over ill-conditioned problems to the reference engine.
#include "graspless/mechanics/stability_solver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "graspless/watch.hpp"

#include "mechanics/contacts/wrenches.hpp"
#include "mechanics/rays/cyclic_cuts.hpp"
#include "mechanics/rays/jamming.hpp"
#include "mechanics/stability/mode_search.hpp"
#include "mechanics/stability/reference.hpp"

namespace graspless::mechanics {
namespace {

/// Returns true if every vector is a combination of the columns with coefficients >= 0.
bool span_positively(const Matrix6Xd& directions) {
  EnvironmentWrenches pushes;
  pushes.generators = directions;
  Columns columns;
  columns.assign(pushes, {}, 0);
  RayBasis basis;
  basis.begin(columns);
  if (!basis.complete({})) return false;
  for (int axis = 0; axis < 12; ++axis) {
    RayBasis::Vector target{};
    target[axis % 6] = axis < 6 ? 1 : -1;
    if (basis.reach(target, 1e-12) == RayBasis::Outcome::facet) return false;
  }
  return true;
}

const Matrix6Xd& checked(const Matrix6Xd& directions) {
  validate_directions(directions);
  if (!span_positively(directions)) {
    throw std::invalid_argument(
        "directions must positively span the space of wrenches: these " +
        std::to_string(directions.cols()) +
        " columns leave some half-space empty, and z would measure nothing there");
  }
  return directions;
}

}  // namespace

struct StabilitySolver::Impl {
  explicit Impl(const Matrix6Xd& directions) : cuts(checked(directions)) {}

  bool is_bounded(ForceMask force) {
    require_set(force);
    ++counters.bounded_tests;
    for (const EnvironmentWrenches* environment : environments) {
      const bool is_bounded = jamming.is_bounded(*environment, fingers, force);
      if (jamming.is_doubtful()) return handed_over().internal_force_is_bounded(force);
      if (!is_bounded) return false;
    }
    return true;
  }

  void require_set(ForceMask force) const {
    if (environments.empty()) throw std::invalid_argument("set() must be called first");
    if (force >> fingers.size() != 0)
      throw std::invalid_argument("force has a bit for a finger that does not exist");
  }

  CyclicCuts::Result solve(ForceMask force, double needed) {
    require_set(force);
    ++counters.evaluations;
    const auto result = cuts.solve(environments, fingers, force, needed);
    counters.pivots = cuts.pivots();
    return result;
  }

  /// Like solve(), by the reference engine if rounding may have decided.
  CyclicCuts::Result evaluate(ForceMask force, double needed) {
    CyclicCuts::Result result = solve(force, needed);
    if (!result.is_doubtful) return result;
    const Stability found = handed_over().evaluate(force, cuts.directions());
    result.z = found.z;
    result.is_doubtful = false;
    std::copy_n(found.commanded_forces.data(), fingers.size(), result.f_com.begin());
    return result;
  }

  /// Engine for problems that are too ill-conditioned for rays. Counts them.
  const Reference& handed_over() {
    ++counters.handed_over;
    if (!reference) {
      reference = set ? Reference(*set) : Reference(environments, fingers);
    }
    return *reference;
  }

  std::vector<const EnvironmentWrenches*> environments;
  std::vector<const FingerWrenches*> fingers;
  std::optional<ContactSet> set;  // the origin of the wrenches, if known
  EnvironmentWrenches own_environment;
  std::vector<FingerWrenches> own_fingers;
  std::optional<Reference> reference;  // for this instant, once needed
  CyclicCuts cuts;
  Jamming jamming;
  Counters counters;
};

StabilitySolver::StabilitySolver(const Matrix6Xd& directions)
    : impl_(std::make_unique<Impl>(directions)) {}
StabilitySolver::StabilitySolver(StabilitySolver&&) noexcept = default;
StabilitySolver& StabilitySolver::operator=(StabilitySolver&&) noexcept = default;
StabilitySolver::~StabilitySolver() = default;

void StabilitySolver::set(const std::vector<const EnvironmentWrenches*>& environments,
                          const std::vector<const FingerWrenches*>& fingers) {
  if (environments.empty()) throw std::invalid_argument("environments must not be empty");
  const auto is_null = [](const auto* pointer) { return pointer == nullptr; };
  if (std::any_of(environments.begin(), environments.end(), is_null) ||
      std::any_of(fingers.begin(), fingers.end(), is_null))
    throw std::invalid_argument("environments and fingers must not be null");
  for (const FingerWrenches* finger : fingers) {
    if (finger->normal.size() != finger->generators.cols())
      throw std::invalid_argument(
          "fingers must have one normal force for each of their generators");
  }
  if (fingers.size() > kMaxFingers) {
    throw std::invalid_argument("fingers must be at most " + std::to_string(kMaxFingers) +
                                ", not " + std::to_string(fingers.size()));
  }
  impl_->environments = environments;
  impl_->fingers = fingers;
  impl_->set.reset();
  impl_->reference.reset();
}

void StabilitySolver::set(const ContactSet& set) {
  validate(set);
  Impl& own = *impl_;
  own.own_environment = wrenches_of_environment(set);
  own.own_fingers = wrenches_of_fingers(set);
  std::vector<const FingerWrenches*> pointers;
  for (const FingerWrenches& finger : own.own_fingers) pointers.push_back(&finger);
  this->set({&own.own_environment}, pointers);
  own.set = set;
}

bool StabilitySolver::internal_force_is_bounded(ForceMask force) {
  return impl_->is_bounded(force);
}

Stability StabilitySolver::max_stability(ForceMask force, double needed) {
  const auto result = impl_->solve(force, needed);
  std::vector<int> binding;
  bool is_doubtful = result.is_doubtful;
  if (!is_doubtful && result.z > 0 && result.z >= needed && std::isfinite(result.z)) {
    binding = impl_->cuts.binding();
    is_doubtful = impl_->cuts.is_doubtful();
  }
  if (is_doubtful) return impl_->handed_over().max_stability(force, impl_->cuts.directions());
  Stability stability;
  stability.z = result.z;
  stability.commanded_forces = Eigen::Map<const Eigen::VectorXd>(
      result.f_com.data(), static_cast<Eigen::Index>(impl_->fingers.size()));
  stability.binding_directions = binding;
  return stability;
}

StabilitySolver::Evaluation StabilitySolver::evaluate(ForceMask force, double needed) {
  poll();
  const auto result = impl_->evaluate(force, needed);
  return {result.z, Eigen::Map<const Eigen::Vector4d>(result.f_com.data())};
}

StabilitySolver::Best StabilitySolver::best_control_modes(double needed) {
  CyclicCuts::Result last, kept;
  Best best = search_modes(
      static_cast<int>(impl_->fingers.size()), needed,
      [&](ForceMask mask) { return impl_->is_bounded(mask); },
      [&](ForceMask mask, double least) {
        last = impl_->evaluate(mask, least);
        return last.z;
      },
      [&](ForceMask) { kept = last; });
  best.commanded_forces = Eigen::Map<const Eigen::Vector4d>(kept.f_com.data());
  return best;
}

const std::vector<Vector6d>& StabilitySolver::supports() const { return impl_->cuts.supports(); }
void StabilitySolver::clear_supports() { impl_->cuts.supports().clear(); }
const StabilitySolver::Counters& StabilitySolver::counters() const { return impl_->counters; }

}  // namespace graspless::mechanics
