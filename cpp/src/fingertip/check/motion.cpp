// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): where the object goes.
#include <algorithm>
#include <cmath>

#include "fingertip/check/check.hpp"
#include "text.hpp"

namespace graspless::fingertip::checking {
namespace {

constexpr double kSameAngle = 1e-6;  // [rad]
// Limits of the contract, tested to a factor of 2: smaller rotations [rad] count as none, and axes
// nearer to upright count as upright.
constexpr double kNoTurn = 1e-9, kUpright = 1e-6;
constexpr double kSameAxis = 1e-3;  // of tumbles; of lengths, by the object's size
constexpr double kTwoPi = 6.28318530717958647692;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// The integral of exp(s [w]) over s from 0 to 1, which maps a body's velocity to its translation.
Eigen::Matrix3d screw_shift(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = cross_matrix(w);
  if (angle < 1e-5) return Eigen::Matrix3d::Identity() + W / 2 + W * W / 6;
  const double a2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / a2 * W +
         (angle - std::sin(angle)) / (a2 * angle) * W * W;
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

/// The largest distance between corresponding points of a hull at two poses.
double farthest_way(const Eigen::Matrix3Xd& hull, const Eigen::Isometry3d& a,
                    const Eigen::Isometry3d& b) {
  return ((a * hull) - (b * hull)).colwise().norm().maxCoeff();
}

double lattice_step(const Lattice& lattice, int axis) {
  const int cells = lattice.counts[axis] - 1;
  return cells > 0 ? (lattice.upper[axis] - lattice.lower[axis]) / cells : 0;
}

/// Index of a value of the lattice along an axis. False if it is none, to the tolerance `same`.
bool lattice_index(const Lattice& lattice, int axis, double value, double same, double& index) {
  const double step = lattice_step(lattice, axis);
  const int last = lattice.counts[axis] - 1;
  double above = value - lattice.lower[axis];
  // Yaws a whole turn apart are the same: take the first that is on the lattice.
  if (axis == 2) above -= kTwoPi * std::floor((above + same) / kTwoPi);
  for (; above <= last * step + same; above += kTwoPi) {
    index = step > 0 ? std::round(above / step) : 0;
    if (std::abs(above - index * step) <= same && index >= 0 && index <= last) return true;
    if (axis != 2) break;
  }
  return false;
}

}  // namespace

Vector6d screw_between(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB) {
  const Eigen::Isometry3d X_AB = X_WA.inverse() * X_WB;
  Vector6d twist;
  twist.tail<3>() = rotation_vector(X_AB.linear());
  twist.head<3>() = screw_shift(twist.tail<3>()).inverse() * X_AB.translation();
  return twist;
}

Eigen::Isometry3d along_screw(const Eigen::Isometry3d& X_WA, const Vector6d& twist_O, double t) {
  const Eigen::Vector3d w = t * twist_O.tail<3>();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  if (w.norm() > 0) X.linear() = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
  X.translation() = screw_shift(w) * (t * twist_O.head<3>());
  return X_WA * X;
}

bool Examination::is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const {
  return (a.translation() - b.translation()).norm() <= same_length_ &&
         rotation_vector(a.linear().transpose() * b.linear()).norm() <= kSameAngle;
}

/// Checks that each segment begins where the last one ended, and that together they make the
/// problem's motion.
void Examination::check_chain() {
  Poses way = segment(0).X_WO;
  for (std::size_t s = 1; s < plan_.segments.size(); ++s) {
    const Poses& poses = segment(s).X_WO;
    if (!is_same(way.back(), poses.front())) {
      fault(place(s), "does not begin where the last one ended");
    }
    way.insert(way.end(), poses.begin() + 1, poses.end());
  }
  std::visit([&](const auto& motion) { check_motion(motion, way); }, problem_.motion);
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    check_rows(s);
    if (!is_regrasp(s)) check_names(s);
  }
}

/// Checks that slides do not turn, and that turns are about the floor's normal and tumbles about
/// another axis.
void Examination::check_names(std::size_t s) {
  const std::string& name = segment(s).name;
  for (std::size_t arc = 0; arc + 1 < segment(s).X_WO.size(); ++arc) {
    const Eigen::Vector3d w_O = arc_twist(s, arc).tail<3>();
    const Eigen::Vector3d w_W = segment(s).X_WO[arc].linear() * w_O;
    const double angle = w_W.norm();
    const double tilt = w_W.cross(problem_.planes.front().n_W.normalized()).norm();
    const bool right = name == "slide"  ? angle <= 2 * kNoTurn
                       : name == "turn" ? angle >= kNoTurn / 2 && tilt <= 2 * kUpright * angle
                                        : angle >= kNoTurn / 2 && tilt >= kUpright / 2 * angle;
    if (!right) fault(place(s), "is no " + name + " after pose " + std::to_string(arc));
  }
}

/// Axis of a turning arc: moment and direction in the world.
Vector6d Examination::axis_W(std::size_t s, std::size_t arc) const {
  const Vector6d twist_O = arc_twist(s, arc);
  const Eigen::Isometry3d& X_WO = segment(s).X_WO[arc];
  const Eigen::Vector3d w_W = X_WO.linear() * twist_O.tail<3>();
  Vector6d axis;
  axis << X_WO.linear() * twist_O.head<3>() - w_W.cross(X_WO.translation()), w_W;
  axis.head<3>() /= problem_.object.size();
  return axis / w_W.norm();
}

/// Number of tumbles. A tumble lasts as long as its axis stays the same, also over regrasps.
int Examination::num_tumbles() const {
  int tumbles = 0;
  Vector6d last = Vector6d::Zero();
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    if (is_regrasp(s)) continue;
    if (segment(s).name != "tumble") last.setZero();
    for (std::size_t k = 0; segment(s).name == "tumble" && k + 1 < segment(s).X_WO.size(); ++k) {
      const Vector6d axis = axis_W(s, k);
      if ((axis - last).norm() > kSameAxis) ++tumbles;
      last = axis;
    }
  }
  return tumbles;
}

void Examination::check_rows(std::size_t s) {
  for (std::size_t r = 0; r < segment(s).rows.size(); ++r) {
    if (is_same(segment(s).rows[r].X_WO, row_pose(s, r))) continue;
    fault(place(s, r), "pose: not where the motion has the object");
  }
}

void Examination::check_motion(const Path& path, const Poses& way) {
  if (way.size() != path.X_WO.size()) {
    return fault("plan", "passes " + std::to_string(way.size()) + " poses, not the path's " +
                             std::to_string(path.X_WO.size()));
  }
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (is_same(way[k], path.X_WO[k])) continue;
    fault("plan", "pose " + std::to_string(k) + " is not the path's");
  }
}

/// Checks that every pose is on the lattice, and a neighbour of the one before.
void Examination::check_motion(const Lattice& lattice, const Poses& way) {
  constexpr double kOnLattice = 1e-6;  // the ends may be as far from their nodes [m, rad]
  const auto is_end = [&](const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    const Eigen::Vector3d turn = rotation_vector(a.linear().transpose() * b.linear());
    return (a.translation() - b.translation()).norm() <= same_length_ + 2 * kOnLattice &&
           turn.norm() <= kSameAngle + kOnLattice;
  };
  if (!is_end(way.front(), lattice.X_WO_start)) fault("plan", "does not begin at the start");
  if (!is_end(way.back(), lattice.X_WO_goal)) fault("plan", "does not end at the goal");
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Eigen::Matrix3d R = way[k].linear() * lattice.X_WO_start.linear().transpose();
    const Eigen::Vector3d p = way[k].translation() - lattice.X_WO_start.translation();
    Eigen::Vector3d index;
    bool on = std::abs(p.z()) <= same_length_ && R(2, 2) >= 1 - kSameAngle;
    const Eigen::Vector3d value(p.x(), p.y(), std::atan2(R(1, 0), R(0, 0)));
    for (int i = 0; i < 3; ++i) {
      on = lattice_index(lattice, i, value[i], i < 2 ? same_length_ : kSameAngle, index[i]) && on;
    }
    if (!on) fault("plan", "pose " + std::to_string(k) + " is not on the lattice");
    Eigen::Vector3d moved = (index - last).cwiseAbs();
    const double turn = std::round(kTwoPi / lattice_step(lattice, 2));  // a whole one, in steps
    moved[2] = std::min(moved[2], std::abs(turn - moved[2]));
    if (k > 0 && !(moved.maxCoeff() <= 1)) {
      fault("plan", "pose " + std::to_string(k) + " is no neighbour of the one before");
    }
    last = index;
  }
}

/// Checks that the object goes from start to goal in steps that are small enough.
void Examination::check_motion(const Goal& goal, const Poses& way) {
  if (!is_same(way.front(), goal.X_WO_start)) fault("plan", "does not begin at the start");
  // The goal may be given with rounded angles; the plan ends flat on the floor.
  if (farthest_way(problem_.object.hull(), way.back(), goal.X_WO_goal) > 3 * same_length_) {
    fault("plan", "does not end at the goal");
  }
  const int tumbles = num_tumbles();
  if (tumbles > goal.max_tumbles) {
    fault("plan", "tumbles " + std::to_string(tumbles) + " times, more than max_tumbles");
  }
  const double size = problem_.object.size();
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double angle = rotation_vector(way[k - 1].linear().transpose() * way[k].linear()).norm();
    const double moved = farthest_way(problem_.object.hull(), way[k - 1], way[k]);
    if (angle > goal.turn_step + kSameAngle ||
        moved > goal.slide_step + angle * size + same_length_) {
      fault("plan", "the step to pose " + std::to_string(k) + " turns by " + figure(angle) +
                        " rad and moves " + figure(moved) + " m");
    }
  }
}

Vector6d Examination::arc_twist(std::size_t s, std::size_t arc) const {
  return screw_between(segment(s).X_WO[arc], segment(s).X_WO[arc + 1]);
}

/// Pose of a row: row k P + j lies in the middle of the j-th of P parts of the motion after pose k.
Eigen::Isometry3d Examination::row_pose(std::size_t s, std::size_t r) const {
  if (is_regrasp(s)) return segment(s).X_WO[0];
  const auto parts = static_cast<std::size_t>(options_.samples_per_arc);
  const double t = (static_cast<double>(r % parts) + 0.5) / static_cast<double>(parts);
  return along_screw(segment(s).X_WO[r / parts], arc_twist(s, r / parts), t);
}

}  // namespace graspless::fingertip::checking
