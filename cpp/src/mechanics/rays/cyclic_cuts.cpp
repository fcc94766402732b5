// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Problem (6): ray shots along the directions share only f_com.
#include "mechanics/rays/cyclic_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace graspless::mechanics {
namespace {

constexpr double kTolerance = 1e-13;  // distance from a target that counts as reached, relative
constexpr double kCeiling = 1e6;      // z above this multiple of the largest force is infinite
constexpr double kNothing = 1e-12;    // z below this multiple of the largest force is 0
constexpr double kFirstTrial = 1;     // first z to try, as a multiple of the largest force

using kernels::kLanes;

}  // namespace

CyclicCuts::CyclicCuts(const Matrix6Xd& directions) : directions_(directions) {
  count_ = static_cast<int>(directions.cols());
  longest_ = directions.colwise().norm().maxCoeff();
}

std::int64_t CyclicCuts::pivots() const {
  std::int64_t sum = 0;
  for (const Environment& e : environments_) sum += e.basis.pivots();
  return sum;
}

/// Returns false if some environment and the fingers do not span the space.
bool CyclicCuts::prepare(const std::vector<const EnvironmentWrenches*>& environments,
                         const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  fingers_ = static_cast<int>(fingers.size());
  dims_ = 0;
  force_scale_ = 0;
  std::array<double, kMaxFingers> upper{};
  for (int i = 0; i < fingers_; ++i) {
    limit_[i] = fingers[i]->max_normal_force;
    dim_[i] = (force >> i & 1U) == 0 ? -1 : dims_;
    if (dim_[i] >= 0) upper[dims_++] = limit_[i];
    force_scale_ += limit_[i];
  }
  used_ = environments.size();
  if (environments_.size() < used_) environments_.resize(used_);
  for (std::size_t e = 0; e < used_; ++e) {
    force_scale_ = std::max(force_scale_, environments[e]->known.norm());
  }
  if (force_scale_ == 0) force_scale_ = 1;
  model_.begin(dims_, upper.data(), kCeiling * force_scale_);
  tolerance_ = kTolerance;
  for (std::size_t e = 0; e < used_; ++e) {
    Environment& environment = environments_[e];
    environment.known = environments[e]->known;
    environment.columns.assign(*environments[e], fingers, force);
    environment.unreached.restart(directions_);
    if (environment.basis.resume(environment.columns)) continue;
    environment.basis.begin(environment.columns);
    if (environment.basis.complete(target(e, critical_, 0))) continue;
    used_ = e + 1;  // the bases of those after it are not those of their columns
    return false;
  }
  return true;
}

/// Right-hand side of the balance for the target z l_d.
RayBasis::Vector CyclicCuts::target(std::size_t environment, int direction, double z) const {
  RayBasis::Vector b{};
  for (int i = 0; i < 6; ++i) {
    b[i] = z * directions_(i, direction) - environments_[environment].known[i];
  }
  for (int i = 0; i < fingers_; ++i) {
    const int dim = dim_[i];
    b[6 + i] = dim < 0 ? limit_[i] : model_.f()[dim];
  }
  return b;
}

/// Restarts with all directions, in the order that the last run left.
void CyclicCuts::Unreached::restart(const Matrix6Xd& all) {
  left = static_cast<int>(all.cols());
  if (!order.empty()) return;
  order.resize(left);
  std::iota(order.begin(), order.end(), 0);
  const int blocks = (left + kLanes - 1) / kLanes;
  slack.resize(blocks * kLanes);
  table.assign(blocks * 6 * kLanes, 0.0);
  for (int at = 0; at < left; ++at) {
    for (int i = 0; i < 6; ++i) *place(at, i) = all(i, at);
  }
}

double* CyclicCuts::Unreached::place(int at, int axis) {
  return &table[(at / kLanes * 6 + axis) * kLanes + at % kLanes];
}

/// Removes a direction that is reached: the last one left takes its place.
void CyclicCuts::Unreached::remove(int at) {
  --left;
  std::swap(order[at], order[left]);
  slack[at] = slack[left];
  for (int i = 0; i < 6; ++i) std::swap(*place(at, i), *place(left, i));
}

/// Distance from a target that counts as reached.
double CyclicCuts::distance(double z) const { return tolerance_ * (force_scale_ + z * longest_); }

/// Removes the targets z l_d that the current basis carries. Returns the nearest of the others, or
/// -1.
int CyclicCuts::sweep(std::size_t index, double z) {
  Environment& e = environments_[index];
  Unreached& u = e.unreached;
  if (u.left == 0) return -1;
  const RayBasis::Vector origin = target(index, 0, 0);
  const double allowed =
      -2 * distance(z);  // twice that of reach(), so that what it reaches is removed
  kernels::slacks(e.basis.inverse(), origin.data(), z, u.table.data(),
                  (u.left + kLanes - 1) / kLanes, u.slack.data());
  int nearest = -1;
  for (int at = u.left - 1; at >= 0; --at) {
    if (u.slack[at] >= allowed) {
      u.remove(at);
      if (nearest == u.left) nearest = at;
    } else if (nearest < 0 || u.slack[at] > u.slack[nearest]) {
      nearest = at;
    }
  }
  return nearest < 0 ? -1 : u.order[nearest];
}

/// Returns true if all targets z l_d are reached in an environment. Stops at a facet that excludes
/// one, or where rounding errors may have decided.
bool CyclicCuts::certify(std::size_t index, double z) {
  RayBasis& basis = environments_[index].basis;
  for (int d = critical_; d >= 0; d = sweep(index, z)) {
    const auto outcome = basis.reach(target(index, d, z), distance(z));
    if (outcome == RayBasis::Outcome::facet || basis.is_doubtful()) {
      critical_ = d;
      return false;
    }
  }
  return true;
}

/// Cut of the facet rho . (z l_d - known, f) >= 0 for all d, solved for z: with y = -rho,
/// z <= (y . known + sum of rho f) / max_d y . l_d.
Cuts::Cut CyclicCuts::cut(std::size_t index) const {
  const Environment& e = environments_[index];
  const RayBasis::Vector& rho = e.basis.facet();
  double width = 0;
  for (int d = 0; d < count_; ++d) {
    double sum = 0;
    for (int i = 0; i < 6; ++i) sum -= rho[i] * directions_(i, d);
    width = std::max(width, sum);
  }
  Cuts::Cut cut;
  for (int i = 0; i < 6; ++i) cut.a -= rho[i] * e.known[i];
  for (int i = 0; i < fingers_; ++i) {
    if (dim_[i] < 0) {
      cut.a += rho[6 + i] * limit_[i];
    } else {
      cut.b[dim_[i]] = rho[6 + i] / width;
    }
  }
  cut.a /= width;
  return cut;
}

void CyclicCuts::keep_support(const RayBasis::Vector& facet) {
  Vector6d y;
  for (int i = 0; i < 6; ++i) y[i] = -facet[i];
  supports_.push_back(y.normalized());
}

bool CyclicCuts::is_doubtful() const {
  return std::any_of(environments_.begin(), environments_.begin() + used_,
                     [](const Environment& e) { return e.basis.is_doubtful(); });
}

CyclicCuts::Result CyclicCuts::finish() const {
  Result result;
  result.z = model_.z() > kNothing * force_scale_ ? model_.z() : 0;
  for (int i = 0; i < fingers_; ++i) {
    if (dim_[i] < 0) continue;
    result.f_com[i] = std::clamp(model_.f()[dim_[i]], 0.0, limit_[i]);
  }
  return result;
}

CyclicCuts::Result CyclicCuts::solve(const std::vector<const EnvironmentWrenches*>& environments,
                                     const std::vector<const FingerWrenches*>& fingers,
                                     ForceMask force, double needed) {
  const Result result = attempt(environments, fingers, force, needed);
  if (!result.is_doubtful) return result;
  for (Environment& environment : environments_) environment.basis.forget();
  return attempt(environments, fingers, force, needed);
}

CyclicCuts::Result CyclicCuts::attempt(const std::vector<const EnvironmentWrenches*>& environments,
                                       const std::vector<const FingerWrenches*>& fingers,
                                       ForceMask force, double needed) {
  if (!prepare(environments, fingers, force)) {
    Result none;
    none.is_doubtful = is_doubtful();
    return none;
  }
  double trial = std::min(model_.z(), kFirstTrial * force_scale_);
  for (std::size_t e = 0; e < used_;) {
    if (certify(e, trial)) {
      if (++e < used_) continue;
      if (trial == model_.z()) break;
      trial = model_.z();  // everything was reached, and z may be larger
    } else if (environments_[e].basis.is_doubtful()) {
      return {0, {}, true};
    } else {
      const Cuts::Cut found = cut(e);
      if (e == 0) keep_support(environments_[e].basis.facet());
      const bool is_against = model_.at(found) < trial;
      const bool is_new = model_.add(found);
      if (!is_against || !is_new)
        tolerance_ *= 2;  // only rounding errors put the target beyond the facet
      if (model_.z() < needed || model_.z() <= kNothing * force_scale_) return finish();
      if (dims_ == 0 && model_.z() <= trial) {
        trial = model_.z();
        continue;
      }
      trial = std::min(trial, model_.z());
    }
    for (std::size_t i = 0; i < used_; ++i) environments_[i].unreached.restart(directions_);
    e = 0;
  }
  Result result = finish();
  if (result.z >= kCeiling * force_scale_) result.z = std::numeric_limits<double>::infinity();
  return result;
}

std::vector<int> CyclicCuts::binding() {
  std::vector<int> found;
  const double z = std::max(0.0, model_.z());
  const double beyond = z + 1e-9 * std::max(1.0, z);
  for (int d = 0; d < count_; ++d) {
    for (std::size_t e = 0; e < used_; ++e) {
      if (environments_[e].basis.reach(target(e, d, beyond), distance(beyond)) ==
          RayBasis::Outcome::reached) {
        continue;
      }
      found.push_back(d);
      break;
    }
  }
  return found;
}

}  // namespace graspless::mechanics
