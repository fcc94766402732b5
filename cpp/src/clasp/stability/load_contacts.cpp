// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/load_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using mechanics::Vector6d;

constexpr double kRound = 0.0005;     // radius by which edges of links are rounded [m]
constexpr double kRounding = 0.5e-6;  // of lengths; less than a contact must be passed by [mm]

/// Distance beyond which no step closes a gap [m].
double window(const Vector3d& p_W, const Posture& hand) {
  const double turned = (p_W - hand.center_W).norm() * kMetre / kArm;
  return kRound + kMove / kMetre * std::sqrt(3) * (1 + turned);
}

}  // namespace

NearPoints::NearPoints(Eigen::Matrix3Xd points_W, std::vector<Range> of_bodies,
                       Eigen::ArrayXd distances)
    : p_W(std::move(points_W)),
      ranges(std::move(of_bodies)),
      distance(std::move(distances)),
      measured_W(p_W) {
  constexpr Eigen::Index kBlock = 32;
  for (const auto& [body, first, count] : ranges) {
    for (Eigen::Index begin = first; begin < first + count; begin += kBlock) {
      const Eigen::Index size = std::min(kBlock, first + count - begin);
      const auto some = p_W.middleCols(begin, size);
      const Vector3d middle = (some.rowwise().minCoeff() + some.rowwise().maxCoeff()) / 2;
      const double radius = (some.colwise() - middle).colwise().norm().maxCoeff();
      blocks.push_back({{body, begin, size}, middle, radius});
    }
  }
}

PosedContacts::PosedContacts(NearPoints& points, const Eigen::Isometry3d& moved,
                             const std::vector<Body>& bodies, const Posture& hand)
    : points_(points),
      bodies_(bodies),
      hand_(hand),
      p_W_((moved.linear() * points.p_W).colwise() + moved.translation()),
      is_measured_(static_cast<std::size_t>(points.p_W.cols())) {
  const Points& from = points.measured_W;
  const auto way =
      ((p_W_.x - from.x).square() + (p_W_.y - from.y).square() + (p_W_.z - from.z).square()).sqrt();
  gap_ = kMetre * (points.distance - way - kRound).max(0);
  for (const auto& [range, middle_W, radius] : points.blocks) {
    middles_W_.push_back(moved * middle_W);
    least_.push_back(gap_.segment(range.begin, range.size).minCoeff());
  }
}

/// Replaces the bound on a gap by the gap.
void PosedContacts::measure(Eigen::Index point, const Body& body) {
  if (std::exchange(is_measured_[static_cast<std::size_t>(point)], 1) != 0) return;
  const Vector3d p_W = p_W_[point];
  const Vector3d p_L = hand_.X_LW[static_cast<std::size_t>(body.link)] * p_W;
  const double distance = std::min(body.distance(p_L, kReach), kReach);
  points_.distance[point] = distance;
  points_.measured_W.x[point] = p_W.x();
  points_.measured_W.y[point] = p_W.y();
  points_.measured_W.z[point] = p_W.z();
  gap_[point] = distance > window(p_W, hand_) ? std::numeric_limits<double>::infinity()
                                              : kMetre * std::max(0.0, distance - kRound);
}

/// Contact of a point that was measured and is near enough.
const LoadContact* PosedContacts::contact(Eigen::Index point, const Body& body) {
  const auto [found, is_new] = contacts_.try_emplace(point);
  LoadContact& contact = found->second;
  if (!is_new) return &contact;
  const auto link = static_cast<std::size_t>(body.link);
  const Vector3d p_W = p_W_[point];
  const Vector3d n_W = hand_.X_WL[link].linear() *
                       gradient(body.distance, hand_.X_LW[link] * p_W, points_.distance[point]);
  Vector6d wrench_W;  // of a unit force along the normal, about W's origin
  wrench_W << n_W, p_W.cross(n_W);
  contact.point = point;
  contact.row << -n_W, -(p_W - hand_.center_W).cross(n_W) * kMetre / kArm;
  contact.opens = -hand_.twists[link].transpose() * wrench_W;
  contact.gap = gap_[point];
  return &contact;
}

const LoadContact* PosedContacts::at(Eigen::Index point) {
  const auto is_after = [](Eigen::Index i, const NearPoints::Range& r) { return i < r.begin; };
  const auto after =
      std::upper_bound(points_.ranges.begin(), points_.ranges.end(), point, is_after);
  const Body& body = bodies_[std::prev(after)->body];
  measure(point, body);
  return std::isfinite(gap_[point]) ? contact(point, body) : nullptr;
}

/// False if a measured point does not pass its contact in a motion relative to the body [mm]. The
/// distance from a convex body is convex: along the normal, it grows by no more than on the way
/// back.
bool PosedContacts::may_pass(Eigen::Index point, const Body& body, const Vector3d& motion_W) const {
  if (!body.is_convex) return true;
  const Vector3d back_W = p_W_[point] - motion_W / kMetre;
  const auto link = static_cast<std::size_t>(body.link);
  const double there = body.distance(hand_.X_LW[link] * back_W, HUGE_VAL);
  return kMetre * (there - points_.distance[point]) + kRounding > gap_[point];
}

/// A contact is passed by the part of the point's motion relative to the body along its normal,
/// which is at most the whole of that motion, v + w x p.
std::vector<const LoadContact*> PosedContacts::near(const Vector6d& move, const VectorXd& yield) {
  const Vector3d turn = move.tail<3>() * kMetre / kArm;
  std::vector<const LoadContact*> found;
  for (std::size_t k = 0; k < points_.blocks.size(); ++k) {
    const auto& [range, middle_W, radius] = points_.blocks[k];
    const Body& body = bodies_[range.body];
    const Vector6d twist = hand_.twists[static_cast<std::size_t>(body.link)] * yield;
    const Vector3d w = turn - twist.tail<3>();  // [mm/m]
    const Vector3d v = move.head<3>() - twist.head<3>() - turn.cross(hand_.center_W);
    const auto motion = [&](const Vector3d& p_W) -> Vector3d { return v + w.cross(p_W); };
    if (motion(middles_W_[k]).norm() + w.norm() * radius <= least_[k]) continue;
    for (Eigen::Index point = range.begin; point < range.begin + range.size; ++point) {
      const Vector3d way = motion(p_W_[point]);
      const auto is_short = [&] {
        const double most = gap_[point] + kRounding;
        return way.squaredNorm() <= most * most;
      };
      if (is_short()) continue;
      measure(point, body);
      if (!is_short() && may_pass(point, body, way)) found.push_back(contact(point, body));
    }
  }
  return found;
}

}  // namespace graspless::clasp
