// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinch: two fingers hold a bar by friction.
#include "clasp/stability/pinch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "graspless/clasp/options.hpp"
#include "graspless/mechanics/stability.hpp"
#include "graspless/watch.hpp"

#include "clasp/free_space/link_spheres.hpp"
#include "clasp/hand/palm.hpp"
#include "clasp/stability/load.hpp"
#include "robot/rates.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

constexpr double kBand = 0.001;       // contacts this much farther than the nearest count [m]
constexpr double kTouch = 0.003;      // gaps that pad and hand take up [m]
constexpr double kTriangle = 0.0015;  // spacing of points on a triangle [m]
constexpr double kLeast = 0.01;       // strengths below this are none: 100 N that resist 1 N
constexpr double kEnd = 0.2;          // part of a contact's length that is its end
constexpr double kGrip = 0.5;         // part of its effort limit with which a joint grips
constexpr double kIdle = 1e-3;        // a joint that moves a finger less does not press [m/rad]
constexpr double kNoLoad = 1e-6;      // [N or Nm]
constexpr int kEdges = 8;             // of friction cones
constexpr double kRay = 0.00025;      // step along the line from tip to tip [m]

/// Links that move with a finger, or the link of its tip if no joint of the hand moves it.
std::set<int> links_of(const Problem& problem, const Finger& finger, const Finger& other) {
  const robot::Robot& robot = problem.robot;
  std::set<int> moving, found;
  for (const CurveNode& node : finger.nodes) {
    const auto is_it = [&](const CurveNode& o) { return o.link == node.link; };
    const bool is_shared = std::any_of(other.nodes.begin(), other.nodes.end(), is_it);
    if (!is_shared && moves_in_palm(problem.hand, robot, node))
      moving.insert(robot.frame(node.link));
  }
  if (moving.empty()) return {robot.frame(finger.nodes.back().link)};
  for (int link = 0; link < static_cast<int>(robot.frame_names().size()); ++link) {
    for (int above = link; above >= 0; above = robot.parent(above)) {
      if (moving.count(above) > 0) found.insert(link);
    }
  }
  return found;
}

/// Mean of the touches whose coordinate along a direction is at least `least`.
Touch mean_beyond(const std::vector<Touch>& touches, const Vector3d& along_W, double least) {
  Touch mean{Vector3d::Zero(), Vector3d::Zero(), 0};
  int count = 0;
  for (const Touch& touch : touches) {
    if (along_W.dot(touch.p_W) < least) continue;
    mean.p_W += touch.p_W;
    mean.n_W += touch.n_W;
    ++count;
  }
  mean.p_W /= count;
  mean.n_W.normalize();
  return mean;
}

/// Both ends of a contact along the bar, as means: single points of a cloud's surface are rough.
std::array<Touch, 2> ends(const std::vector<Touch>& touches, const Vector3d& along_W) {
  const auto end = [&](const Vector3d& d) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Touch& touch : touches) {
      low = std::min(low, d.dot(touch.p_W));
      high = std::max(high, d.dot(touch.p_W));
    }
    return mean_beyond(touches, d, high - kEnd * (high - low));
  };
  return {end(along_W), end(-along_W)};
}

}  // namespace

double opening(const robot::Robot& robot, const Hand& hand) {
  const Eigen::VectorXd open = robot.state(hand.open);
  const CurveNode &tip = hand.fingers.front().nodes.back(), &thumb = hand.thumb.nodes.back();
  const Vector3d from = node_position(robot, tip, open), to = node_position(robot, thumb, open);
  std::vector<std::pair<Eigen::Isometry3d, CoveredShape>> shapes;
  for (const robot::LinkShape& shape : robot.shapes()) {
    const std::string& link = robot.frame_names()[shape.link];
    if (link != tip.link && link != thumb.link) continue;
    shapes.emplace_back(robot.pose(shape.link, open).inverse(),
                        covered(shape.placed, MeshInside::hull));
  }
  const double length = (to - from).norm();
  double longest = 0, entered = 0;
  for (double along = 0; along < length; along += kRay) {
    const Vector3d p = from + along / length * (to - from);
    const bool inside = std::any_of(shapes.begin(), shapes.end(), [&](const auto& shape) {
      return shape.second.depth(shape.first * p) > 0;
    });
    if (inside) entered = along;
    longest = std::max(longest, along - entered);
  }
  return longest;
}

PinchTester::PinchTester(const Problem& problem) : problem_(problem) {
  const Hand& hand = problem.hand;
  sides_ = {side(hand.fingers.front(), hand.thumb), side(hand.thumb, hand.fingers.front())};
  const Eigen::VectorXd open = problem.robot.state(hand.open);
  const auto tip = [&](const Finger& finger) {
    return node_position(problem.robot, finger.nodes.back(), open);
  };
  const auto base = [&](const Finger& finger) {
    return node_position(problem.robot, finger.nodes.front(), open);
  };
  reach_ = 0;
  const Vector3d middle = (tip(hand.fingers.front()) + tip(hand.thumb)) / 2;
  for (const Finger* finger : {&hand.fingers.front(), &hand.thumb})
    reach_ = std::max({reach_, (tip(*finger) - middle).norm(), (base(*finger) - middle).norm()});
  const Eigen::Matrix3Xd& p = problem.object.points();
  mean_O_ = p.rowwise().mean();
  const double radius = std::sqrt((p.colwise() - mean_O_).colwise().squaredNorm().mean());
  scale_.setIdentity();
  scale_.bottomRightCorner<3, 3>() /= std::max(radius, geometry::kMinLength);
}

PinchTester::Side PinchTester::side(const Finger& finger, const Finger& other) const {
  const std::set<int> links = links_of(problem_, finger, other);
  Side side;
  for (const robot::LinkShape& shape : problem_.robot.shapes()) {
    if (links.count(shape.link) > 0) side.push_back(body_of(shape));
  }
  return side;
}

std::array<std::vector<Touch>, 2> PinchTester::touches(const Eigen::VectorXd& q) const {
  robot::Poses X_WL;
  problem_.robot.forward(q, X_WL);
  const Hand& hand = problem_.hand;
  const Vector3d middle_W = (node_position(problem_.robot, hand.fingers.front().nodes.back(), q) +
                             node_position(problem_.robot, hand.thumb.nodes.back(), q)) /
                            2;
  return {touches_of(sides_[0], X_WL, middle_W), touches_of(sides_[1], X_WL, middle_W)};
}

std::vector<Touch> PinchTester::touches_of(const Side& side, const robot::Poses& X_WL,
                                           const Vector3d& middle_W) const {
  const Gap gap(side, X_WL);
  const std::vector<NearFacet> facets = facets_near(gap, middle_W);
  double most = std::numeric_limits<double>::infinity();  // of gaps that may be the least
  for (const NearFacet& facet : facets) most = std::min(most, facet.gap + facet.size);
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<Touch> found;
  for (const NearFacet& facet : facets) {
    poll();
    if (facet.gap - facet.size > most + kBand) continue;
    visit_points(facet.corners, kTriangle, [&](const Vector3d& p) {
      if (facet.gap - (p - facet.center).norm() > most + kBand) return;
      const double distance = gap.at(p, most + kBand);
      nearest = std::min(nearest, distance);
      most = std::min(most, distance);
      if (distance <= most + kBand) found.push_back({p, Vector3d::Zero(), distance});
    });
  }
  const auto is_far = [&](const Touch& touch) { return touch.gap > nearest + kBand; };
  found.erase(std::remove_if(found.begin(), found.end(), is_far), found.end());
  for (Touch& touch : found) {
    poll();
    touch.n_W = gap.normal(touch.p_W, touch.gap);
  }
  const auto has_none = [](const Touch& touch) { return touch.n_W.isZero(); };
  found.erase(std::remove_if(found.begin(), found.end(), has_none), found.end());
  return found;
}

/// Triangles of the object within reach of the tips, without those that are surely farther from
/// the finger than others.
std::vector<PinchTester::NearFacet> PinchTester::facets_near(const Gap& gap,
                                                             const Vector3d& middle_W) const {
  const geometry::Mesh& surface = problem_.object.surface();
  const Eigen::Matrix3Xd p_W = problem_.X_WO * surface.vertices;
  std::vector<NearFacet> facets;
  double most = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < surface.triangles.cols(); ++i) {
    const Facet facet(p_W(Eigen::all, surface.triangles.col(i)));
    if ((facet.center - middle_W).norm() > reach_ + facet.size) continue;
    poll();
    const double distance = gap.at(facet.center, most + kBand + facet.size);
    most = std::min(most, distance + facet.size);
    if (std::isfinite(distance)) facets.push_back({facet, distance});
  }
  return facets;
}

mechanics::ContactSet pinch_contacts(const std::array<std::vector<Touch>, 2>& touches,
                                     const Vector3d& mean_W, const Vector3d& along_W,
                                     double friction) {
  mechanics::ContactSet set;
  for (const std::vector<Touch>& side : touches) {
    for (const Touch& touch : ends(side, along_W))
      set.fingers.push_back({touch.p_W, touch.n_W, friction, 0.5, Vector3d::Zero()});
  }
  set.com_O = mean_W;
  set.cone_edges = kEdges;
  return set;
}

/// Force of each finger at kGrip of the effort limits, by virtual work: both move against the
/// object. 0 if no joint moves them.
double PinchTester::press(const std::array<std::vector<Touch>, 2>& touches,
                          const Eigen::VectorXd& q) const {
  robot::Poses X_WL;
  problem_.robot.forward(q, X_WL);
  Eigen::RowVectorXd closing = Eigen::RowVectorXd::Zero(problem_.robot.dof());  // [m/rad or 1]
  for (std::size_t k = 0; k < 2; ++k) {
    const int link = sides_[k].back().link;
    const Touch touch = mean_beyond(touches[k], Vector3d::Zero(), 0);
    closing += robot::rates(problem_.robot, link, X_WL, touch.p_W, touch.n_W);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const int joint : problem_.robot.group(problem_.hand.hand)) {
    const double limit = kGrip * problem_.robot.max_effort()[joint];
    if (std::abs(closing[joint]) > kIdle) least = std::min(least, limit / std::abs(closing[joint]));
  }
  return std::isfinite(least) ? least : 0;
}

Pinch PinchTester::test(const Eigen::VectorXd& q, double friction,
                        const StabilityOptions& options) {
  const auto found = touches(q);
  Pinch pinch;
  for (const std::vector<Touch>& side : found) {
    double gap = std::numeric_limits<double>::infinity();
    for (const Touch& touch : side) gap = std::min(gap, touch.gap);
    pinch.gap = std::max(pinch.gap, gap);
  }
  if (pinch.gap > kTouch) return pinch;
  const Hand& hand = problem_.hand;
  const Eigen::Matrix3d R_WH = problem_.robot.pose(problem_.robot.frame(hand.frame), q).linear();
  mechanics::ContactSet set =
      pinch_contacts(found, problem_.X_WO * mean_O_, R_WH * hand.sideways_H, friction);
  set.wrench_scale = scale_;
  const std::vector modes(4, mechanics::FingerMode::position);
  pinch.strength = mechanics::max_stability(set, modes).z;
  pinch.press = press(found, q);
  pinch.holds = pinch.strength > kLeast;
  if (options.force == 0 && options.torque == 0) return pinch;
  // Loads must span all wrenches.
  const auto loads =
      loads_W(R_WH, std::max(options.force, kNoLoad), std::max(options.torque, kNoLoad));
  set.wrench_scale.setIdentity();
  pinch.load = pinch.press / kSudden * mechanics::max_stability(set, modes, loads).z;
  pinch.holds = pinch.holds && pinch.load >= 1;
  return pinch;
}

Pinch test_pinch(const Problem& problem, const Eigen::VectorXd& q, double friction,
                 const StabilityOptions& stability) {
  validate(problem);
  validate(stability);
  require_efforts(problem, stability);
  robot::require_configuration(problem.robot, q, "q");
  if (problem.hand.fingers.size() != 1) {
    throw std::invalid_argument("hand.fingers has " + std::to_string(problem.hand.fingers.size()) +
                                " fingers; a pinch is for one besides the thumb");
  }
  Options options;
  options.friction = friction;
  planning::require_in_range("", options);
  return PinchTester(problem).test(q, friction, stability);
}

}  // namespace graspless::clasp
