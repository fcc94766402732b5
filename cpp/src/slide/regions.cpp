// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "graspless/planning/forest_cbirrt.hpp"
#include "graspless/planning/vector_states.hpp"

namespace graspless::slide {

namespace ob = ompl::base;
using planning::vector;

namespace {

// Draws in a row whose nearest configurations are refused, after which the others are tried too.
constexpr int kPatience = 100;

// Rejections by friction, after which contacts near the centre of mass are preferred.
constexpr int kLagPatience = 30;

// Values of the arm's free joint that are tried for a start and for its partner, if it has one, and
// the first draws have failed.
constexpr int kFreeJoints = 5, kFreeJointsOfPartner = 3;
constexpr int kFirstDraws = 4 * planning::ForestCBiRRT::kCompared;  // of starts

// Goals of the object that are drawn for each start; values of the free joint for a given one.
constexpr int kDraws = 24, kDrawsOfEnd = 4;

// Draws of the goal and of the edge of a slide that goes on, before those of other edges.
constexpr int kFormer = 8, kFormerEdge = 24;

Planar contact_at(const Eigen::Vector2d& point, double yaw) {
  Planar contact = Planar::Identity();
  contact.linear() = Eigen::Rotation2Dd(yaw).toRotationMatrix();
  contact.translation() = point;
  return contact;
}

/// Returns the configurations of one draw that press at `contact`, the nearest to `near` first.
std::vector<Eigen::VectorXd> presses_at(Query& query, const Planar& contact, double depth,
                                        const Eigen::VectorXd& near, double free_joint) {
  const Eigen::Isometry3d X_WF = query.pressed_tip(contact, depth, query.options.pitch);
  const Eigen::VectorXd near_arm = query.arm.part(near);
  std::vector<Eigen::VectorXd> arms;
  for (const Eigen::VectorXd& q : query.draw_ik(query.tip_ik, X_WF, near, free_joint)) {
    arms.push_back(query.arm.part(q));
  }
  const auto nearest = std::min_element(
      arms.begin(), arms.end(),
      [&](const auto& a, const auto& b) { return (a - near_arm).norm() < (b - near_arm).norm(); });
  if (nearest != arms.end()) std::iter_swap(arms.begin(), nearest);
  return arms;
}

std::optional<Eigen::VectorXd> press_at(Query& query, const Planar& contact, double depth,
                                        const Eigen::VectorXd& near, double free_joint) {
  std::vector<Eigen::VectorXd> arms = presses_at(query, contact, depth, near, free_joint);
  return arms.empty() ? std::nullopt : std::optional(arms.front());
}

double draw_depth(Query& query) {
  const auto [min, max] = depth_band(query.problem.hand, query.options);
  return query.uniform(min, max);
}

/// Returns how far the object's points move on a straight slide, in the mean: at most the way of
/// the centre of mass and what the turn about it adds [m].
double travel(const Query& query, const Planar& object_S) {
  const Eigen::Vector2d com = query.problem.object.com().head<2>();
  const Planar turned = object_S * query.object_start.inverse();
  const double turn = std::abs(Eigen::Rotation2Dd(turned.rotation()).smallestAngle());
  return (object_S * com - query.object_start * com).norm() +
         turn * query.problem.object.mean_distance(com);
}

/// Returns how the object sticks out at a goal; nothing if not as the options ask.
std::optional<Placement> placed(Query& query, const Planar& object_S) {
  const Placement place = placement(query.problem, query.options, object_S);
  if (place.overhang >= query.options.min_overhang && place.com_inside) return place;
  query.refuse("goal: " + place.fault);  // for example at a corner, where another edge is nearer
  return std::nullopt;
}

}  // namespace

StartRegion::StartRegion(const ob::SpaceInformationPtr& si, Query& query)
    : planning::SampleableRegion(si),
      query_(query),
      contacts_(contact_points(query.problem, query.options)) {}

/// Draws a contact point, uniformly. Where friction is the bottleneck, more of them near the centre
/// of mass.
std::int32_t StartRegion::draw_point() const {
  const double share = query_.uniform(0, 1);
  const auto nth = [](const auto& points, double t) {
    return points[static_cast<std::size_t>(t * static_cast<double>(points.size()))];
  };
  if (query_.num_lags < kLagPatience) return nth(contacts_, share);
  if (nearest_.empty()) {
    const Object& object = query_.problem.object;
    const auto far = [&](std::int32_t i) {
      return (object.points().col(i) - object.com().head<2>()).squaredNorm();
    };
    nearest_ = contacts_;
    std::stable_sort(nearest_.begin(), nearest_.end(),
                     [&](std::int32_t a, std::int32_t b) { return far(a) < far(b); });
  }
  return nth(nearest_, share * share * share);
}

// Eq. (3): a contact anywhere on the object's top face, any yaw, pitch beta_0, a depth in the band.
bool StartRegion::try_sample(ob::State* state) const {
  const Eigen::Vector2d p_OP = query_.problem.object.points().col(draw_point());
  const Planar contact = contact_at(query_.object_start * p_OP, query_.uniform(0, 2 * M_PI));
  if (!query_.problem.support.polygon().contains(contact.translation())) {
    query_.refuse("start: off the support");
    return false;
  }
  const double free_joint = query_.draw_free_joint();
  const Eigen::VectorXd near = query_.draw_seed();
  const double depth = draw_depth(query_);
  std::vector<Eigen::VectorXd> arms = presses_at(query_, contact, depth, near, free_joint);
  const bool is_hard = num_drawn_++ >= kFirstDraws,
             has_more = is_hard && query_.tip_ik.free_joint();
  for (int k = 1; arms.empty() && has_more && k < kFreeJoints; ++k)
    arms = presses_at(query_, contact, depth, near, query_.draw_free_joint());
  if (arms.empty()) {
    query_.refuse("start: reach");
    return false;
  }
  const auto is_valid = [&](const Eigen::VectorXd& arm) {
    return query_.contact.is_valid(arm, ContactSpace::Carried{contact, query_.object_start});
  };
  auto valid = is_valid(arms.front()) ? arms.begin() : arms.end();
  if (valid == arms.begin() && refused_ < kPatience) refused_ = 0;
  if (valid == arms.end()) {
    if (refused_ < kPatience) ++refused_;
    // For example, the nearest one has the elbow down if home has.
    if (refused_ == kPatience) valid = std::find_if(arms.begin() + 1, arms.end(), is_valid);
  }
  if (valid == arms.end()) {
    query_.refuse_press("start: ", refused_ == kPatience ? arms.back() : arms.front());
    return false;
  }
  vector(state, query_.arm.dof()) = *valid;
  return true;
}

GoalRegion::GoalRegion(const ob::SpaceInformationPtr& si, Query& query, Motions& motions,
                       const Interruption* at)
    : planning::SampleableRegion(si),
      query_(query),
      motions_(motions),
      edges_(usable_edges(query.problem.support)),
      has_one_start_(at != nullptr) {
  if (!at || !at->X_WO_goal) return;
  const Planar goal = planar(query.X_WS.inverse() * *at->X_WO_goal);
  const Placement place = placement(query.problem, query.options, goal);
  if (!place.sticks_out) return;
  former_ = goal;
  former_edge_ = place.edge;
}

// Eq. (4): a contact anywhere near the edges, any yaw, pitch beta_0, a depth in the band.
bool GoalRegion::try_sample(ob::State* state) const {
  if (query_.object_end) return false;  // goals fit a start
  const auto point =
      query_.problem.support.goal_band().sample(query_.rng, query_.options.tip_margin);
  if (!point) {
    query_.refuse("goal: no room near the edges");
    return false;
  }
  const Support& support = query_.problem.support;
  if (support.has_unusable_edges() &&
      !support.is_usable(support.polygon().nearest_edge(*point).index)) {
    query_.refuse("goal: edge not usable");
    return false;
  }
  const Planar contact = contact_at(*point, query_.uniform(0, 2 * M_PI));
  const double free_joint = query_.draw_free_joint();
  const Eigen::VectorXd near = query_.draw_seed();
  const auto arm = press_at(query_, contact, draw_depth(query_), near, free_joint);
  if (!arm) {
    query_.refuse("goal: reach");
    return false;
  }
  if (!query_.contact.is_valid(*arm, std::nullopt)) {
    query_.refuse_press("goal: ", *arm);
    return false;
  }
  vector(state, query_.arm.dof()) = *arm;
  return true;
}

std::optional<double> GoalRegion::try_sample_partner(const ob::State* start, ob::State* goal,
                                                     double max_cost) const {
  const Eigen::VectorXd q_start = vector(start, query_.arm.dof());
  const Eigen::VectorXd near = query_.arm.full(q_start);
  const ContactSpace::Carried carried = query_.carried_from(q_start);
  const double depth = query_.top - query_.contact.tip_at(q_start).height;
  const bool is_hard = num_drawn_ >= kDraws * planning::ForestCBiRRT::kCompared,
             has_more = is_hard && query_.tip_ik.free_joint();
  for (const Partner& partner : draw_partners(carried, query_.free_joint_of(near))) {
    if (query_.clock.is_out() || partner.travel >= max_cost) break;
    const Planar contact = partner.object_S * carried.object_start.inverse() * carried.tip_start;
    auto arm = press_at(query_, contact, depth, near, partner.free_joint);
    for (int k = 1; !arm && has_more && k < kFreeJointsOfPartner; ++k)
      arm = press_at(query_, contact, depth, near, query_.draw_free_joint(partner.free_joint));
    if (!arm) {
      query_.refuse("goal: reach");
    } else if (!query_.contact.is_valid(*arm, carried)) {
      query_.refuse_press("goal: ", *arm);
    } else if (is_goal(carried, depth, partner.object_S)) {
      vector(goal, query_.arm.dof()) = *arm;
      return partner.travel;
    }
  }
  return std::nullopt;
}

/// True if friction is likely to take the object there, where the hand grasps or leaves it.
bool GoalRegion::is_goal(const ContactSpace::Carried& carried, double depth,
                         const Planar& object_S) const {
  if (query_.object_end) return query_.is_lag_likely_small(carried, depth, std::nullopt, object_S);
  const auto place = placed(query_, object_S);
  return place && query_.is_lag_likely_small(carried, depth, place, object_S) &&
         motions_.is_graspable(object_S, *place);
}

/// Draws goals that fit a start. For the first starts, the nearest goals come first: the pad turns
/// the least on them. A slide that goes on prefers its former goal, and then its former edge.
std::vector<GoalRegion::Partner> GoalRegion::draw_partners(const ContactSpace::Carried& carried,
                                                           double joint_at_start) const {
  const bool near_first = num_drawn_ < kDraws * planning::ForestCBiRRT::kCompared;
  std::vector<Partner> partners;
  const int draws = !query_.object_end ? kDraws : query_.tip_ik.free_joint() ? kDrawsOfEnd : 1;
  for (int i = 0; i < draws; ++i) {
    const int rank = former_ ? (num_drawn_ >= kFormer) + (num_drawn_ >= kFormer + kFormerEdge) : 0;
    const auto object_S = draw_object_pose(carried);
    const double free_joint = draw_free_joint(joint_at_start, i);
    if (!object_S) continue;
    partners.push_back({*object_S, free_joint, rank, travel(query_, *object_S)});
  }
  if (!near_first) return partners;
  std::stable_sort(partners.begin(), partners.end(), [](const Partner& a, const Partner& b) {
    return std::tie(a.rank, a.travel) < std::tie(b.rank, b.travel);
  });
  return partners;
}

/// Draws a goal pose of the object: graspable by construction, or where it is left, with the
/// fingertip's contact still on the support.
std::optional<Planar> GoalRegion::draw_object_pose(const ContactSpace::Carried& carried) const {
  const std::optional<Planar> object_S = draw_graspable();
  if (!object_S) {
    query_.refuse("goal: overhang against centre of mass");
    return std::nullopt;
  }
  const Planar contact = *object_S * carried.object_start.inverse() * carried.tip_start;
  const geometry::Polygon& Q = query_.problem.support.polygon();
  if (!Q.has_margin(contact.translation(), query_.options.tip_margin)) {
    query_.refuse("goal: fingertip off the support");
    return std::nullopt;
  }
  return object_S;
}

std::optional<Planar> GoalRegion::draw_graspable() const {
  const int drawn = num_drawn_++;
  if (query_.object_end) return query_.object_end;
  if (former_ && drawn < kFormer) return former_;
  const bool is_former = former_ && drawn < kFormer + kFormerEdge;
  const geometry::Polygon::Edge edge =
      is_former ? former_edge_ : query_.problem.support.polygon().edge(edges_(query_.rng));
  return draw_graspable_pose(query_.problem, query_.options, edge, query_.rng);
}

/// Draws the free joint of a partner: that of its start; if there is no other, later ones near it.
double GoalRegion::draw_free_joint(double at_start, int i) const {
  if (query_.object_end) return i == 0 ? at_start : query_.draw_free_joint(at_start);
  if (!query_.tip_ik.free_joint() || !has_one_start_ || num_drawn_ <= 1) return at_start;
  if (num_drawn_ > kFormer + kFormerEdge && query_.uniform(0, 1) < 0.5) {
    return query_.draw_free_joint();
  }
  return query_.draw_free_joint(at_start);
}

bool GoalRegion::isStartGoalPairValid(const ob::State* start, const ob::State* goal) const {
  ++query_.statistics.pairs;
  return motions_.is_pair_valid(vector(start, query_.arm.dof()), vector(goal, query_.arm.dof()));
}

}  // namespace graspless::slide
