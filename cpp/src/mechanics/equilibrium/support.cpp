// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Resultant forces of the environment: which ones an edge that sticks and a face that slides can
// supply.
#include "mechanics/equilibrium/support.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mechanics/equilibrium/springs.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

constexpr double kSame = 1e-9;   // of unit vectors and coefficients
constexpr double kFlat = 1e-9;   // relative height of a point that lies on a line or in a plane
constexpr double kRound = 1e-9;  // relative to the wrench
constexpr int kHalvings = 40;

bool is_one_plane(const std::vector<Contact>& contacts) {
  const Contact& a = contacts.front();
  return std::all_of(contacts.begin(), contacts.end(), [&](const Contact& b) {
    const Vector3d apart = b.p_OC - a.p_OC;
    return b.mode == a.mode && (b.n_O - a.n_O).norm() < kSame &&
           std::abs(b.friction - a.friction) < kSame * (1 + a.friction) &&
           std::abs(a.n_O.dot(apart)) <= 1e-6 * apart.norm();
  });
}

bool is_one_direction(const std::vector<Contact>& contacts) {
  const Vector3d t = tangent(contacts.front().n_O, contacts.front().t_O);
  return std::all_of(contacts.begin(), contacts.end(),
                     [&](const Contact& b) { return (tangent(b.n_O, b.t_O) - t).norm() < kSame; });
}

}  // namespace

Support::Support(const ContactSet& set) {
  if (set.contacts.size() < 2 || !is_one_plane(set.contacts)) return;
  const Contact& contact = set.contacts.front();
  n_ = contact.n_O;
  friction_ = contact.friction;
  first_ = contact.p_OC - set.com_O;
  along_ = set.contacts[1].p_OC - contact.p_OC;
  if (contact.mode == ContactMode::stick) {
    length_ = along_.norm();
    squared_ = along_.squaredNorm();
    unit_ = along_.normalized();
    is_edge_ = set.contacts.size() == 2 && length_ > 0;
  } else if (set.contacts.size() > 2 && is_one_direction(set.contacts)) {
    find_facets(set);
  }
}

/// A face that slides supplies the force K e, e = n - mu t, at a point q / K about the centre of
/// mass, inside the hull of the contacts. With the wrench (F, M): K = n . F, M = q x e, and n . q =
/// K h, so q = e x M / e^2 + (K h - n . (e x M) / e^2) e. The side from p_a to p_b of the hull asks
/// m . (q - K p_a) >= 0, where m points inwards.
void Support::find_facets(const ContactSet& set) {
  const Contact& any = set.contacts.front();
  const Vector3d e = any.n_O - any.friction * tangent(any.n_O, any.t_O);
  const double h = any.n_O.dot(first_);
  std::vector<Vector6d> facets;
  bool is_wide = false;
  for (const Contact& a : set.contacts) {
    for (const Contact& b : set.contacts) {
      const Vector3d side = b.p_OC - a.p_OC;
      if (&a == &b || !(side.norm() > 0)) continue;
      const Vector3d m = n_.cross(side).normalized();
      double lowest = 0, highest = 0;
      for (const Contact& c : set.contacts) {
        lowest = std::min(lowest, m.dot(c.p_OC - a.p_OC));
        highest = std::max(highest, m.dot(c.p_OC - a.p_OC));
      }
      if (lowest < -kFlat * side.norm()) continue;
      is_wide = is_wide || highest > kFlat * side.norm();
      const double e2 = e.squaredNorm();
      const Vector3d on_moment = (m.cross(e) - m.dot(e) * n_.cross(e)) / e2;  // m . q of M
      Vector6d facet;
      facet << (m.dot(e) * h - m.dot(a.p_OC - set.com_O)) * n_, on_moment;
      facets.push_back(facet);
    }
  }
  if (!is_wide) return;
  Vector6d presses = Vector6d::Zero();
  presses.head<3>() = n_;
  facets.push_back(presses);
  facets_ = std::move(facets);
}

/// The forces f_1 and f_2 across the edge follow from the wrench; along it, only their sum does.
std::array<Vector3d, 2> Support::across_edge(const Vector6d& w) const {
  const Vector3d force = w.head<3>();
  const Vector3d moment = w.tail<3>() - first_.cross(force);
  const Vector3d second = moment.cross(along_) / squared_;
  const Vector3d across = force - unit_.dot(force) * unit_;
  return {across - second, second};
}

/// Both may share the force along the edge as they like: |f_1 + f_2 along| <= the sum of what the
/// two cones have left.
bool Support::edge_supplies(const Vector6d& w) const {
  const Vector3d force = w.head<3>();
  const Vector3d moment = w.tail<3>() - first_.cross(force);
  const double round = kRound * (force.norm() + moment.norm() / length_);
  double room = round - std::abs(unit_.dot(force));
  for (const Vector3d& f : across_edge(w)) {
    const double normal = n_.dot(f), most = friction_ * normal + round;
    const double slips = (f - normal * n_).norm();
    if (normal < -round || slips > most) return false;
    room += std::sqrt(most * most - slips * slips);
  }
  return room >= 0;
}

/// Each end's force, and the force along the edge, may change by what all errors change it at most.
double Support::edge_tolerates(const Vector6d& w, const Matrix6Xd& changes) const {
  struct End {
    double normal, slips, normal_per_error = 0, slips_per_error = 0;
  };
  double along_per_error = 0, most = Spring::kUnlimited;
  std::array<End, 2> ends{};
  for (std::size_t i = 0; i < 2; ++i) {
    End& end = ends[i];
    const Vector3d f = across_edge(w)[i];
    end.normal = n_.dot(f);
    end.slips = (f - end.normal * n_).norm();
    for (Eigen::Index k = 0; k + 3 <= changes.cols(); k += 3) {
      Eigen::Matrix3d of;
      for (int axis = 0; axis < 3; ++axis) of.col(axis) = across_edge(changes.col(k + axis))[i];
      end.normal_per_error += (n_.transpose() * of).norm();
      end.slips_per_error += largest_stretch(of - n_ * (n_.transpose() * of));
    }
    const double room = std::max(0.0, friction_ * end.normal - end.slips);
    const double per_error = end.slips_per_error + friction_ * end.normal_per_error;
    if (per_error > 0) most = std::min(most, room / per_error);
  }
  for (Eigen::Index k = 0; k + 3 <= changes.cols(); k += 3) {
    along_per_error += (unit_.transpose() * changes.block<3, 3>(0, k)).norm();
  }
  const auto left = [&](double e) {  // of the friction along the edge
    double sum = -std::abs(unit_.dot(w.head<3>())) - e * along_per_error;
    for (const End& end : ends) {
      const double held = friction_ * (end.normal - e * end.normal_per_error);
      const double slips = end.slips + e * end.slips_per_error;
      sum += std::sqrt(std::max(0.0, held * held - slips * slips));
    }
    return sum;
  };
  if (!(left(0) > 0)) return 0;
  if (along_per_error > 0) most = std::min(most, left(0) / along_per_error);
  if (!std::isfinite(most) || left(most) >= 0) return most;
  double low = 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + most) / 2;
    (left(middle) >= 0 ? low : most) = middle;
  }
  return low;
}

double Support::tolerates(const Vector6d& w, const Matrix6Xd& changes) const {
  if (is_edge_) return edge_tolerates(w, changes);
  double most = Spring::kUnlimited;
  for (const Vector6d& facet : facets_) {
    double falls = 0;
    for (Eigen::Index k = 0; k + 3 <= changes.cols(); k += 3) {
      falls += (facet.transpose() * changes.middleCols<3>(k)).norm();
    }
    if (falls > 0) most = std::min(most, std::max(0.0, facet.dot(w)) / falls);
  }
  return most;
}

double Support::within(const Vector6d& w, const Vector6d& change, double most) const {
  if (is_edge_) {
    if (edge_supplies(w + most * change)) return most;
    if (!edge_supplies(w)) return 0;
    double low = 0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + most) / 2;
      (edge_supplies(w + middle * change) ? low : most) = middle;
    }
    return low;
  }
  for (const Vector6d& facet : facets_) {
    const double now = std::max(0.0, facet.dot(w)), falls = -facet.dot(change);
    if (falls * most > now) most = now / falls;
  }
  return most;
}

}  // namespace graspless::mechanics
