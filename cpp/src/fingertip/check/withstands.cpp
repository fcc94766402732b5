// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): which disturbances the springs of fingers and environment withstand, by halving the
// size of each disturbance until every condition of mechanics::withstands() holds.
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "fingertip/check/check.hpp"
#include "mechanics/lp/program.hpp"

namespace graspless::fingertip::checking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanics::ContactMode;
using mechanics::FingerMode;
using mechanics::Matrix6d;
using mechanics::Matrix6Xd;
using Jacobian = Eigen::Matrix<double, 3, 6>;  // motion of a point per twist about the com

constexpr double kStiff = 1e5;   // rigid, relative to the largest stiffness
constexpr double kSoft = 1e-9;   // below which a motion is free, relative to the stiffness
constexpr double kSlack = 1e-9;  // relative to the forces
constexpr int kHalvings = 50;

enum class Ground { edge, face, other };

/// Stiffness of the environment along its normals and along its surface.
struct Stiffness {
  double normal, tangential;
};

class Springs {
 public:
  Springs(const Instant& instant, const mechanics::Equilibrium& nominal, const Options& options,
          const Eigen::Matrix3Xd& corners_O, const Matrix6Xd& pushes, const Stiffness& ground)
      : instant_(instant),
        set_(instant.set),
        nominal_(nominal),
        options_(options),
        ground_(kind_of(set_)) {
    for (const mechanics::Contact& c : set_.contacts) add(c, ground);
    for (std::size_t j = 0; j < set_.fingers.size(); ++j) add(j);
    const Matrix6d scaled = set_.wrench_scale * stiffness_ * set_.wrench_scale.transpose();
    holds_ = scaled.eigenvalues().real().minCoeff() > kSoft * scaled.norm();
    if (holds_) move(stiffness_.fullPivLu().solve(pushes), corners_O, pushes);
  }

  double largest(double most) const {
    if (!holds_) return 0;
    double t = most;
    for (Eigen::Index d = 0; d < yields_.size() && t > 0; ++d) {
      if (ground_ == Ground::face) t = face(d, t);
      if (holds(d, t)) continue;
      double low = 0, high = t;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2;
        (holds(d, middle) ? low : high) = middle;
      }
      t = low;
    }
    return t;
  }

 private:
  /// Notes what motions of the object, one a column, change.
  void move(const Matrix6Xd& moved, const Eigen::Matrix3Xd& corners_O, const Matrix6Xd& pushes) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Jacobian softly = springs_[i] * points_[i];
      forces_.emplace_back(softly.lazyProduct(moved));
    }
    yields_ = Eigen::ArrayXd::Zero(moved.cols());
    for (const auto& corner : corners_O.colwise()) {
      const Jacobian at = point(corner);
      for (Eigen::Index d = 0; d < moved.cols(); ++d) {
        yields_[d] = std::max(yields_[d], Vector3d(at * moved.col(d)).squaredNorm());
      }
    }
    yields_ = yields_.sqrt();
    // The environment has to supply the first part, and t times the second.
    rest_ = -set_.known_wrench_O;
    rest_grows_ = pushes;
    const std::size_t contacts = set_.contacts.size();
    for (std::size_t j = 0; j < set_.fingers.size(); ++j) {
      const Eigen::Matrix<double, 6, 3> carries = points_[contacts + j].transpose();
      rest_ -= carries * nominal_.finger_forces_O.col(j);
      rest_grows_ -= carries.lazyProduct(forces_[contacts + j]);
    }
  }

  /// Springs supply the disturbance's direction: the object moves against it.
  Vector3d force(std::size_t i, Eigen::Index d, double t) const {
    const auto contacts = static_cast<Eigen::Index>(set_.contacts.size());
    const auto at = static_cast<Eigen::Index>(i);
    const Vector3d before = at < contacts ? Vector3d(nominal_.contact_forces_O.col(at))
                                          : Vector3d(nominal_.finger_forces_O.col(at - contacts));
    return before + t * forces_[i].col(d);
  }

  Jacobian point(const Vector3d& p_O) const {
    Jacobian J;
    for (int i = 0; i < 3; ++i) {
      J.col(i) = Vector3d::Unit(i);
      J.col(3 + i) = Vector3d::Unit(i).cross(p_O - set_.com_O);
    }
    return J;
  }

  void add(const Vector3d& p_O, const Matrix3d& spring) {
    points_.push_back(point(p_O));
    springs_.push_back(spring);
    stiffness_ += points_.back().transpose() * spring * points_.back();
  }

  void add(const mechanics::Contact& c, const Stiffness& ground) {
    const Matrix3d N = c.n_O * c.n_O.transpose();
    if (c.mode == ContactMode::slide) {
      const Vector3d t = mechanics::tangent(c.n_O, c.t_O);
      return add(c.p_OC, ground.normal * (N - c.friction * t * c.n_O.transpose()));
    }
    add(c.p_OC, ground.normal * N + ground.tangential * (Matrix3d::Identity() - N));
  }

  void add(std::size_t j) {
    const mechanics::Finger& f = set_.fingers[j];
    const Matrix3d N = f.n_O * f.n_O.transpose();
    const bool pushes = instant_.modes[j] == FingerMode::position;
    add(f.p_OC, (pushes ? options_.compliance.finger_normal : 0) * N +
                    options_.compliance.finger_tangential * (Matrix3d::Identity() - N));
  }

  static bool in_cone(const Vector3d& f, const Vector3d& n, double friction) {
    const double normal = n.dot(f);
    return (f - normal * n).norm() <= friction * normal + kSlack * (1 + f.norm());
  }

  bool holds(Eigen::Index d, double t) const {
    const std::size_t contacts = set_.contacts.size();
    for (std::size_t j = 0; j < set_.fingers.size(); ++j) {
      const mechanics::Finger& finger = set_.fingers[j];
      const Vector3d f = force(contacts + j, d, t);
      if (!in_cone(f, finger.n_O, finger.friction)) return false;
      if (instant_.modes[j] == FingerMode::position &&
          finger.n_O.dot(f) > finger.max_normal_force * (1 + kSlack)) {
        return false;
      }
    }
    if (t * yields_[d] > options_.max_yield) return false;
    if (ground_ == Ground::edge) return edge_holds(d, t);
    for (std::size_t i = 0; ground_ == Ground::other && i < contacts; ++i) {
      const mechanics::Contact& c = set_.contacts[i];
      const Vector3d f = force(i, d, t);
      const bool slides = c.mode == ContactMode::slide;
      if (slides ? c.n_O.dot(f) < -kSlack * (1 + f.norm()) : !in_cone(f, c.n_O, c.friction)) {
        return false;
      }
    }
    return true;
  }

  /// Wrench that the environment has to supply.
  Vector6d rest(Eigen::Index d, double t) const { return rest_ + t * rest_grows_.col(d); }

  /// Two contacts: the force at the second one across the edge has the moment about the first one.
  /// Along the edge, both take a part from an interval.
  bool edge_holds(Eigen::Index d, double t) const {
    const mechanics::Contact &a = set_.contacts[0], &b = set_.contacts[1];
    const Vector6d w = rest(d, t);
    const Vector3d way = b.p_OC - a.p_OC, e = way.normalized();
    const Vector3d total = w.head<3>();
    const Vector3d about_a = w.tail<3>() - (a.p_OC - set_.com_O).cross(total);
    const Vector3d f_b = about_a.cross(e) / way.norm();
    const Vector3d f_a = total - e.dot(total) * e - f_b;
    const double slack = kSlack * (1 + total.norm() + f_b.norm());
    const auto left = [&](const Vector3d& f) {  // of the friction; negative: none
      const double normal = a.n_O.dot(f), across = (f - normal * a.n_O).norm();
      const double most = a.friction * normal + slack;
      return most < across ? -1.0 : std::sqrt(most * most - across * across);
    };
    const double first = left(f_a), second = left(f_b), along = e.dot(total);
    if (first < 0 || second < 0) return false;
    return std::max(-first, along - second) <= std::min(first, along + second) + slack;
  }

  /// A face that slides: coefficients of its contacts' edges, by a linear program.
  double face(Eigen::Index d, double most) const {
    mechanics::LinearProgram lp;
    lp.add_variable(0, most, 1);
    const Vector6d now = set_.wrench_scale * rest(d, 0);
    const Vector6d grows = set_.wrench_scale * rest_grows_.col(d);
    const double slack = kSlack * (1 + now.norm());
    for (int row = 0; row < 6; ++row) lp.add_row(now[row] - slack, now[row] + slack);
    lp.set_block(0, 0, -grows);
    for (const mechanics::Contact& c : set_.contacts) {
      const Vector3d edge = c.n_O - c.friction * mechanics::tangent(c.n_O, c.t_O);
      const auto k = static_cast<int>(lp.num_variables());
      lp.add_variable(0, mechanics::kInfinity);
      lp.set_block(0, k, set_.wrench_scale * Vector6d(point(c.p_OC).transpose() * edge));
    }
    const mechanics::LpSolution found = mechanics::solve_lp(lp);
    return found.status == mechanics::LpStatus::optimal ? found.objective : 0;
  }

  static Ground kind_of(const mechanics::ContactSet& set) {
    const auto& all = set.contacts;
    const mechanics::Contact& a = all.front();
    const Vector3d t = mechanics::tangent(a.n_O, a.t_O);
    Vector3d off = Vector3d::Zero();  // of the first contact's line through the second one
    for (const mechanics::Contact& b : all) {
      const bool is_alike = b.mode == a.mode && b.friction == a.friction &&
                            (b.n_O - a.n_O).norm() < kSlack &&
                            std::abs(a.n_O.dot(b.p_OC - a.p_OC)) <= 1e-6 * (b.p_OC - a.p_OC).norm();
      if (!is_alike) return Ground::other;
      if (b.mode == ContactMode::slide && (mechanics::tangent(b.n_O, b.t_O) - t).norm() >= kSlack) {
        return Ground::other;
      }
      const Vector3d turned = (all.back().p_OC - a.p_OC).cross(b.p_OC - a.p_OC);
      if (turned.norm() > off.norm()) off = turned;
    }
    if (a.mode == ContactMode::stick) return all.size() == 2 ? Ground::edge : Ground::other;
    const double length = (all.back().p_OC - a.p_OC).norm();
    return off.norm() > kSlack * length * length ? Ground::face : Ground::other;
  }

  const Instant& instant_;
  const mechanics::ContactSet& set_;
  const mechanics::Equilibrium& nominal_;
  const Options& options_;
  Ground ground_;
  std::vector<Jacobian> points_;   // of contacts, then fingers
  std::vector<Matrix3d> springs_;  // force that an approach of the object takes away
  Matrix6d stiffness_ = Matrix6d::Zero();
  bool holds_ = false;
  Vector6d rest_ = Vector6d::Zero();      // see move()
  Matrix6Xd rest_grows_;                  // of each direction
  std::vector<Eigen::Matrix3Xd> forces_;  // of each spring in each direction, for t = 1
  Eigen::ArrayXd yields_;                 // motion of the farthest corner, for t = 1 [m]
};

}  // namespace

double withstands_at(const Instant& instant, const mechanics::Equilibrium& nominal,
                     const Options& options, const Eigen::Matrix3Xd& corners_O) {
  const mechanics::Compliance& c = options.compliance;
  const double stiff = kStiff * std::max({c.environment_normal, c.environment_tangential,
                                          c.finger_normal, c.finger_tangential});
  double most = instant.set.known_wrench_O.head<3>().norm();
  for (const mechanics::Finger& finger : instant.set.fingers) most += finger.max_normal_force;
  const Matrix6Xd pushes = instant.set.wrench_scale.inverse() * options.disturbance_directions;
  const auto with = [&](const Stiffness& ground) {
    return Springs(instant, nominal, options, corners_O, pushes, ground).largest(most);
  };
  const double sticks =
      std::min(with({c.environment_normal, c.environment_tangential}), with({stiff, stiff}));
  const bool any_sticks =
      std::any_of(instant.set.contacts.begin(), instant.set.contacts.end(),
                  [](const auto& contact) { return contact.mode == ContactMode::stick; });
  if (!any_sticks) return sticks;
  return std::max(
      {sticks, with({stiff, c.finger_tangential}), with({stiff, 0.1 * c.finger_tangential})});
}

}  // namespace graspless::fingertip::checking
