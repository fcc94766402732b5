// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/hole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "graspless/watch.hpp"

#include "clasp/parameters.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

constexpr double kPrecision = 0.00025;  // of the radius of a ball [m]
constexpr double kWide = 0.1;           // holes wider than this do not stop a finger [m]

/// A triangle of the cone over a loop, with a bound on the distance of its points from the object.
struct Part {
  std::array<Vector3d, 3> corners;
  double most;  // [m]
  bool operator<(const Part& other) const { return most < other.most; }
};

std::string millimetres(double length) { return std::to_string(std::lround(1000 * length)); }

/// Bounds on the radius of the largest ball that fits [m], and the centre of one with the lower.
struct Radius {
  double least = 0, most = 0;
  Vector3d center = Vector3d::Zero();
};

/// Narrows the bounds until they are close, the ball is as wide as `enough`, or `goes_on`, which is
/// called before each step, returns false.
template <class GoesOn>
Radius largest_ball(const Object& object, int loop, double enough, const GoesOn& goes_on) {
  const collision::Clearance& clearance = object.outer_clearance();
  double widest = -1;  // that fits [m]
  Vector3d center;
  std::priority_queue<Part> parts;
  const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d middle = (a + b + c) / 3;
    const double here = clearance.distance(middle);
    if (here > widest) center = middle;
    widest = std::max(widest, here);
    const double size = std::max({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()});
    parts.push({{a, b, c}, here + size});  // the distance is 1-Lipschitz
  };
  const Eigen::Matrix3Xd& p = object.loops().found[loop].points;
  const Vector3d apex = p.rowwise().mean();
  for (Eigen::Index i = 0; i < p.cols(); ++i) add(apex, p.col(i), p.col((i + 1) % p.cols()));
  while (parts.top().most > widest + kPrecision && 2 * widest < enough && goes_on()) {
    const auto [a, b, c] = parts.top().corners;
    parts.pop();
    const double ab = (a - b).norm(), bc = (b - c).norm(), ca = (c - a).norm();
    if (ab >= bc && ab >= ca) {  // halve the longest side
      add(a, (a + b) / 2, c);
      add((a + b) / 2, b, c);
    } else if (bc >= ca) {
      add(a, b, (b + c) / 2);
      add(a, (b + c) / 2, c);
    } else {
      add(a, b, (c + a) / 2);
      add((c + a) / 2, b, c);
    }
  }
  return {widest, parts.top().most, center};
}

/// Width of a hole in words, from a few thousand steps: it is told even if the time is over.
std::string width_in_words(const Object& object, int loop) {
  constexpr int kSteps = 3000;
  int left = kSteps;
  const Radius radius = largest_ball(object, loop, kWide, [&] { return left-- > 0; });
  if (2 * radius.least >= kWide) return "at least 100 mm wide";
  const std::string least = millimetres(2 * radius.least), most = millimetres(2 * radius.most);
  const bool is_close = radius.most - radius.least <= kPrecision;
  return (is_close ? most : least + " to " + most) + " mm wide";
}

}  // namespace

double hole_width(const Object& object, int loop, double enough) {
  const Radius radius = largest_ball(object, loop, enough, [] {
    poll();
    return true;
  });
  return 2 * (2 * radius.least < enough ? radius.most : radius.least);
}

Hole widest_place(const Object& object, int loop) {
  const Radius radius = largest_ball(object, loop, kWide, [] {
    poll();
    return true;
  });
  return {radius.center, 2 * radius.least};
}

double needed_width(const robot::Robot& robot, const Hand& hand) {
  double fingers = 0;
  for (const Finger& finger : hand.fingers) fingers = std::max(fingers, tip_radius(robot, finger));
  return 2 * std::min(fingers, tip_radius(robot, hand.thumb));
}

std::string describe_sizes(const Problem& problem, int loop) {
  const double needed = needed_width(problem.robot, problem.hand);
  const double handle = problem.object.loops().found[loop].thickness;
  std::string text = "loop " + std::to_string(loop) + ": its hole is ";
  text += width_in_words(problem.object, loop);
  if (handle > 0) text += ", its handle " + millimetres(handle) + " mm thick";
  if (needed > 0) text += ", a finger " + millimetres(needed) + " mm";
  return text;
}

}  // namespace graspless::clasp
