// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/load_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "clasp/stability/balls.hpp"
#include "geometry/turn.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using mechanics::Vector6d;

constexpr double kRound = 0.0005;     // radius by which edges of links are rounded [m]
constexpr double kTiny = 1e-12;       // more than the rounding of a distance [m]
constexpr double kBlunt = 2e-3;       // from an axis, where normals are sure [m]
constexpr double kSlack = 0.01;       // more than the error of a normal by finite differences
constexpr double kRounding = 0.5e-6;  // of lengths; less than a contact must be passed by [mm]

/// The way to a point from the nearest point of an axis.
Vector3d from_axis(const Axis& axis, const Vector3d& p) {
  const Vector3d beyond = p - axis.from;
  const double t = beyond.dot(axis.along) / std::max(axis.along.squaredNorm(), 1e-30);
  return beyond - std::clamp(t, 0.0, 1.0) * axis.along;
}

/// Gap of a point [mm] at a distance [m].
double gap_of(double distance) { return kMetre * std::max(0.0, distance - kRound); }

/// Distance beyond which no step closes a gap [m].
double window(const Vector3d& p_W, const Posture& hand) {
  const double turned = (p_W - hand.center_W).norm() * kMetre / kArm;
  return kRound + kMove / kMetre * std::sqrt(3) * (1 + turned);
}

}  // namespace

NearPoints::NearPoints(Eigen::Matrix3Xd points_W, const std::vector<Range>& ranges,
                       const Eigen::ArrayXd& distance)
    : p_W(std::move(points_W)), places(static_cast<std::size_t>(p_W.cols())) {
  std::vector<int> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  for (const auto& [body, begin, count] : ranges) {
    std::vector<BallGroup> groups;
    group_neighbours(p_W, order, begin, begin + count, kBlock, groups);
    for (const BallGroup& group : groups) {
      Block block{body, group.end - group.begin,      {}, group.middle, 0, {}, {}, 0,
                  0,    Eigen::Isometry3d::Identity()};
      block.first.at_W.rowwise() = group.middle.transpose().array();
      block.first.distance.setConstant(std::numeric_limits<double>::infinity());
      for (Eigen::Index i = 0; i < block.size; ++i) {
        const Eigen::Index point = order[group.begin + i];
        block.points[i] = point;
        places[point] = {blocks.size(), i};
        block.first.at_W.row(i) = p_W.col(point).transpose();
        block.first.distance[i] = distance[point];
        block.radius = std::max(block.radius, (p_W.col(point) - group.middle).norm());
      }
      block.last = block.first;
      block.least = block.least_first = block.first.distance.minCoeff();
      blocks.push_back(block);
    }
  }
}

PosedContacts::PosedContacts(NearPoints& points, const Eigen::Isometry3d& moved,
                             const std::vector<Body>& bodies, const Posture& hand)
    : points_(points),
      bodies_(bodies),
      hand_(hand),
      moved_(moved),
      posed_(points.blocks.size(), -1) {
  for (const Body& body : bodies) {
    const Eigen::Isometry3d& X_WL = hand.X_WL[body.link];
    axes_W_.push_back(body.axis_L);
    if (!body.axis_L) continue;
    axes_W_.back()->from = X_WL * body.axis_L->from;
    axes_W_.back()->along = X_WL.linear() * body.axis_L->along;
  }
  middles_.reserve(points.blocks.size());
  for (const NearPoints::Block& block : points.blocks) middles_.push_back(middle_of(block));
}

/// The distance that points of a block may lose between two motions of the object is that of the
/// middle and that of a turn: the largest singular value of the difference of two rotations is its
/// norm / sqrt(2). The way from the nearest point of an axis to a point changes by no more than the
/// point.
PosedContacts::Middle PosedContacts::middle_of(const NearPoints::Block& block) const {
  const Vector3d p_W = moved_ * block.middle_W;
  if (const auto& axis_W = axes_W_[block.body]) {
    const Vector3d q = from_axis(*axis_W, p_W);
    const double away = q.norm(), nearest = away - block.radius;
    const double bends = nearest > kBlunt ? block.radius / (away - block.radius / 2) : HUGE_VAL;
    return {p_W, q / away, bends, gap_of(nearest - axis_W->radius - kTiny)};
  }
  const auto lost = [&](const Eigen::Isometry3d& before) {
    return (p_W - before * block.middle_W).norm() +
           geometry::most_apart(moved_.linear(), before.linear()) * block.radius;
  };
  const double least = std::max(block.least_first - lost(Eigen::Isometry3d::Identity()),
                                block.least - lost(block.moved));
  return {p_W, Vector3d::Zero(), HUGE_VAL, gap_of(least)};
}

/// Places the points of a block, with bounds on their gaps.
PosedContacts::Posed& PosedContacts::posed(std::size_t index) {
  int& number = posed_[index];
  if (number >= 0) return poses_[number];
  number = static_cast<int>(poses_.size());
  Posed& posed = poses_.emplace_back();
  NearPoints::Block& block = points_.blocks[index];
  const Eigen::Matrix3d R = moved_.linear();
  const Vector3d t = moved_.translation();
  const auto& from = block.first.at_W;
  const auto &x = from.col(0), &y = from.col(1), &z = from.col(2);
  posed.p_W.col(0) = R(0, 0) * x + R(0, 1) * y + R(0, 2) * z + t[0];
  posed.p_W.col(1) = R(1, 0) * x + R(1, 1) * y + R(1, 2) * z + t[1];
  posed.p_W.col(2) = R(2, 0) * x + (R(2, 1) * y + R(2, 2) * z) + t[2];  // as Eigen's products round
  if (const auto& axis_W = axes_W_[block.body]) {
    place_around(*axis_W, posed);
  } else {
    place_known(block, posed);
  }
  posed.gap = kMetre * (posed.distance - kRound).max(0);
  keep_bounds(index, posed);
  return posed;
}

/// Bounds from what was measured before.
void PosedContacts::place_known(const NearPoints::Block& block, Posed& posed) {
  const auto left = [&](const NearPoints::Known& known) -> Values {
    const auto way = posed.p_W - known.at_W;
    return known.distance -
           (way.col(0).square() + way.col(1).square() + way.col(2).square()).sqrt();
  };
  posed.distance = left(block.first).max(left(block.last));
}

/// Distances from an axis, and normals.
void PosedContacts::place_around(const Axis& axis, Posed& posed) {
  const Vector3d &a = axis.from, &u = axis.along;
  auto& q = posed.n_W;
  q = posed.p_W.rowwise() - a.transpose().array();
  const double square = std::max(u.squaredNorm(), 1e-30);
  const Values t = ((q.col(0) * u[0] + q.col(1) * u[1] + q.col(2) * u[2]) / square).max(0).min(1);
  for (int k = 0; k < 3; ++k) q.col(k) -= t * u[k];
  const Values away = (q.col(0).square() + q.col(1).square() + q.col(2).square()).sqrt();
  q.colwise() /= away.max(kTiny);
  posed.distance = away - axis.radius - kTiny;
}

/// Keeps the least of the bounds of a block, for this pose and for others.
void PosedContacts::keep_bounds(std::size_t index, const Posed& posed) {
  NearPoints::Block& block = points_.blocks[index];
  block.least = posed.distance.minCoeff();
  block.moved = moved_;
  middles_[index].least = posed.gap.minCoeff();
}

/// Replaces the bound on a gap by the gap.
void PosedContacts::measure(NearPoints::Block& block, Posed& posed, Eigen::Index i) {
  if (std::exchange(posed.is_measured[i], true)) return;
  const Body& body = bodies_[block.body];
  const Vector3d p_W = posed.p_W.row(i);
  const Vector3d p_L = hand_.X_LW[body.link] * p_W;
  const double distance = std::min(body.distance(p_L, kReach), kReach);
  posed.distance[i] = block.last.distance[i] = distance;
  block.last.at_W.row(i) = p_W;
  posed.gap[i] =
      distance > window(p_W, hand_) ? std::numeric_limits<double>::infinity() : gap_of(distance);
}

/// Contact of a point that was measured and is near enough.
const LoadContact* PosedContacts::contact(const NearPoints::Block& block, const Posed& posed,
                                          Eigen::Index i) {
  const Eigen::Index point = block.points[i];
  const auto [found, is_new] = contacts_.try_emplace(point);
  LoadContact& contact = found->second;
  if (!is_new) return &contact;
  const Body& body = bodies_[block.body];
  const auto link = static_cast<std::size_t>(body.link);
  const Vector3d p_W = posed.p_W.row(i);
  const Vector3d n_W = hand_.X_WL[link].linear() *
                       gradient(body.distance, hand_.X_LW[link] * p_W, posed.distance[i]);
  Vector6d wrench_W;  // of a unit force along the normal, about W's origin
  wrench_W << n_W, p_W.cross(n_W);
  contact.point = point;
  contact.row << -n_W, -(p_W - hand_.center_W).cross(n_W) * kMetre / kArm;
  contact.opens = -hand_.twists[link].transpose() * wrench_W;
  contact.gap = posed.gap[i];
  return &contact;
}

const LoadContact* PosedContacts::at(Eigen::Index point) {
  const auto [index, i] = points_.places[point];
  NearPoints::Block& block = points_.blocks[index];
  Posed& placed = posed(index);
  measure(block, placed, i);
  return std::isfinite(placed.gap[i]) ? contact(block, placed, i) : nullptr;
}

/// False if a measured point does not pass its contact in a motion relative to the body [mm]. The
/// distance from a convex body is convex: along the normal, it grows by no more than on the way
/// back.
bool PosedContacts::may_pass(const Body& body, const Posed& posed, Eigen::Index i,
                             const Vector3d& motion_W) const {
  if (!body.is_convex) return true;
  const Vector3d p_W = posed.p_W.row(i);
  const Vector3d back_W = p_W - motion_W / kMetre;
  const auto link = static_cast<std::size_t>(body.link);
  const double there = body.distance(hand_.X_LW[link] * back_W, HUGE_VAL);
  return kMetre * (there - posed.distance[i]) + kRounding > posed.gap[i];
}

/// Adds the contacts of a block that a motion may pass.
void PosedContacts::find(std::size_t index, const Motion& motion,
                         std::vector<const LoadContact*>& found) {
  NearPoints::Block& block = points_.blocks[index];
  const Body& body = bodies_[block.body];
  Posed& placed = posed(index);
  const auto& p_W = placed.p_W;
  const auto &v = motion.v, &w = motion.w;
  const Values squares = (v[0] + w[1] * p_W.col(2) - w[2] * p_W.col(1)).square() +
                         (v[1] + w[2] * p_W.col(0) - w[0] * p_W.col(2)).square() +
                         (v[2] + w[0] * p_W.col(1) - w[1] * p_W.col(0)).square();
  Values approach = squares.sqrt();
  if (axes_W_[block.body]) {
    const auto& n = placed.n_W;
    const Values along = n.col(0) * (v[0] + w[1] * p_W.col(2) - w[2] * p_W.col(1)) +
                         n.col(1) * (v[1] + w[2] * p_W.col(0) - w[0] * p_W.col(2)) +
                         n.col(2) * (v[2] + w[0] * p_W.col(1) - w[1] * p_W.col(0));
    const auto is_clear = placed.distance + axes_W_[block.body]->radius > kBlunt;
    approach = is_clear.select(kSlack * approach - along, approach);
  }
  bool is_changed = false;
  for (Eigen::Index i = 0; i < block.size; ++i) {
    if (approach[i] <= placed.gap[i] - kRounding) continue;
    is_changed = is_changed || !placed.is_measured[i];
    measure(block, placed, i);
    if (approach[i] > placed.gap[i] - kRounding &&
        may_pass(body, placed, i, motion * Vector3d(p_W.row(i))))
      found.push_back(contact(block, placed, i));
  }
  if (is_changed) keep_bounds(index, placed);
}

/// A contact is passed by the part of the point's motion relative to the body along its normal,
/// which is at most the whole of that motion.
std::vector<const LoadContact*> PosedContacts::near(const Vector6d& move, const VectorXd& yield) {
  const Vector3d turn = move.tail<3>() * kMetre / kArm;
  std::vector<Motion> motions;  // relative to each body; w in [mm/m]
  std::vector<double> spins;
  for (const Body& body : bodies_) {
    const Vector6d twist = hand_.twists[body.link] * yield;
    motions.push_back(
        {move.head<3>() - twist.head<3>() - turn.cross(hand_.center_W), turn - twist.tail<3>()});
    spins.push_back(motions.back().w.norm());
  }
  std::vector<const LoadContact*> found;
  for (std::size_t k = 0; k < points_.blocks.size(); ++k) {
    const NearPoints::Block& block = points_.blocks[k];
    const Motion& motion = motions[block.body];
    const Middle& middle = middles_[k];
    const Vector3d way = motion * middle.p_W;
    const double spread = spins[block.body] * block.radius, most = way.norm() + spread;
    if (most <= middle.least) continue;
    const double approach = spread + (middle.bends + kSlack) * most - way.dot(middle.n_W);
    if (approach <= middle.least) continue;
    posed(k);
    if (std::min(most, approach) > middle.least) find(k, motion, found);
  }
  std::sort(found.begin(), found.end(),
            [](const auto* a, const auto* b) { return a->point < b->point; });
  return found;
}

}  // namespace graspless::clasp
