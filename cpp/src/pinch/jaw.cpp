// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/jaw.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <variant>

#include "geometry/box_mesh.hpp"
#include "robot/names.hpp"
#include "robot/rates.hpp"

namespace graspless::pinch {

using Eigen::Isometry3d, Eigen::Vector3d;

namespace {

/// The shapes of some links.
LinkShapes shapes_of(const robot::Robot& robot, const std::vector<std::string>& links) {
  LinkShapes found;
  std::copy_if(robot.shapes().begin(), robot.shapes().end(), std::back_inserter(found),
               [&](const robot::LinkShape& shape) {
                 return robot::contains(links, robot.frame_names()[shape.link]);
               });
  return found;
}

/// Shapes of links in the hand's frame H at q.
std::vector<geometry::PlacedShape> in_hand(const slide::Problem& problem, const LinkShapes& shapes,
                                           const Eigen::VectorXd& q) {
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(q, X_WL);
  const Isometry3d X_HW = X_WL[robot.frame(problem.hand.grasp_frame)].inverse();
  std::vector<geometry::PlacedShape> placed;
  for (const robot::LinkShape& shape : shapes) {
    placed.push_back(shape.placed);
    placed.back().X_BG = X_HW * X_WL[shape.link] * shape.placed.X_BG;
  }
  return placed;
}

/// Corners of the part of a mesh with p . along >= least, which is not empty. No triangles.
geometry::Mesh part_of(const geometry::Mesh& mesh, const Vector3d& along, double least) {
  const Eigen::VectorXd beyond = (mesh.vertices.transpose() * along).array() - least;
  std::vector<Vector3d> corners;
  for (Eigen::Index i = 0; i < beyond.size(); ++i) {
    if (beyond[i] >= 0) corners.emplace_back(mesh.vertices.col(i));
  }
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(k, t), b = mesh.triangles((k + 1) % 3, t);
      if ((beyond[a] >= 0) == (beyond[b] >= 0)) continue;
      const double share = beyond[a] / (beyond[a] - beyond[b]);
      corners.emplace_back((1 - share) * mesh.vertices.col(a) + share * mesh.vertices.col(b));
    }
  }
  const auto count = static_cast<Eigen::Index>(corners.size());
  return {Eigen::Map<const Eigen::Matrix3Xd>(corners.front().data(), 3, count), {}};
}

/// The shapes of a finger that reach its end; of meshes and boxes, the part within `pad` of it [m].
/// What is behind may be wider, and holds nothing.
LinkShapes at_end(const slide::Problem& problem, const LinkShapes& finger, const Eigen::VectorXd& q,
                  double pad) {
  constexpr double kRounding = 1e-9;  // [m]
  const Vector3d forward = Vector3d::UnitZ();
  const std::vector<geometry::PlacedShape> placed = in_hand(problem, finger, q);
  double end = -std::numeric_limits<double>::infinity();
  for (const auto& shape : placed) end = std::max(end, geometry::extent(shape, forward));
  const double least = end - pad;
  LinkShapes found;
  for (std::size_t i = 0; i < finger.size(); ++i) {
    if (geometry::extent(placed[i], forward) <= least + kRounding) continue;
    found.push_back(finger[i]);
    geometry::Shape& shape = found.back().placed.shape;
    if (const auto* box = std::get_if<geometry::Box>(&shape)) shape = geometry::box_mesh(box->size);
    auto* mesh = std::get_if<geometry::Mesh>(&shape);
    if (mesh == nullptr) continue;
    const Isometry3d& X_HG = placed[i].X_BG;
    *mesh = part_of(*mesh, X_HG.linear().row(2).transpose(), least - X_HG.translation().z());
  }
  return found;
}

/// Intersection of two intervals, or the gap between them.
std::pair<double, double> common(const std::pair<double, double>& a,
                                 const std::pair<double, double>& b) {
  return std::minmax(std::max(a.first, b.first), std::min(a.second, b.second));
}

}  // namespace

Shapes::Shapes(const slide::Problem& problem, const LinkShapes& shapes, const Eigen::VectorXd& q)
    : shapes_(in_hand(problem, shapes, q)) {}

double Shapes::extent(const Vector3d& direction_H) const {
  const double length = direction_H.norm();
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& placed : shapes_) {
    largest = std::max(largest, geometry::extent(placed, direction_H / length));
  }
  return largest * length;
}

// The slopes of the support function are the outermost points.
std::pair<double, double> Shapes::outermost(const Vector3d& direction_H,
                                            const Vector3d& axis_H) const {
  constexpr double kTurn = 1e-4;
  const double here = extent(direction_H);
  return {(here - extent(direction_H - kTurn * axis_H)) / kTurn,
          (extent(direction_H + kTurn * axis_H) - here) / kTurn};
}

double extent(const std::vector<Shapes>& all, const Vector3d& direction_H) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Shapes& shapes : all) largest = std::max(largest, shapes.extent(direction_H));
  return largest;
}

Jaw::Jaw(const slide::Problem& problem, const Options& options)
    : problem_(problem), depth_(options.depth) {
  std::vector<std::string> others;  // links of the other finger
  for (const std::string& link : problem.hand.fingers) {
    if (!robot::contains(problem.hand.sliding_finger, link)) others.push_back(link);
  }
  own_ = shapes_of(problem.robot, problem.hand.sliding_finger);
  others_ = shapes_of(problem.robot, others);
  q_open_ = problem.robot.state(problem.hand.open, problem.q_home);
  q_closed_ = problem.robot.state(problem.hand.closed, q_open_);
  for (const int joint : problem.robot.group(problem.hand.arm)) {
    q_open_[joint] = q_closed_[joint] = problem.q_home[joint];
  }
  constexpr double kPad = 0.02;  // length of the ends that hold the object [m]
  const double pad = std::max(kPad, 2 * depth_);
  own_face_ = at_end(problem, own_, q_open_, pad);
  other_face_ = at_end(problem, others_, q_open_, pad);
  const Vector3d y = Vector3d::UnitY();
  const Shapes own(problem, own_face_, q_open_), other(problem, other_face_, q_open_);
  const double own_middle = own.extent(y) - own.extent(-y),
               other_middle = other.extent(y) - other.extent(-y);
  side_ = own_middle > other_middle ? 1 : -1;
  open_ = closed_by(0);
  closed_ = closed_by(1);
  widest_ = open_.gap;
  if (!options.opening || *options.opening >= widest_) return;
  open_ = at_width(std::max(*options.opening, closed_.gap)).value_or(closed_);
  q_open_ = open_.q;
}

Grip Jaw::at(const Eigen::VectorXd& q) const {
  constexpr double kRound = 0.001;  // length of a pad that is not flat [m]
  Grip grip;
  grip.q = q;
  const Shapes own(problem_, own_face_, grip.q), other(problem_, other_face_, grip.q);
  const Vector3d inward = -side_ * Vector3d::UnitY();  // of the sliding finger
  const double own_face = own.extent(inward), other_face = other.extent(-inward);
  grip.gap = -own_face - other_face;
  const auto along = [&](const Vector3d& axis) {
    return common(own.outermost(inward, axis), other.outermost(-inward, axis));
  };
  const auto z = along(Vector3d::UnitZ()), x = along(Vector3d::UnitX());
  const double length = z.second - z.first, depth = std::min(depth_, length / 2);
  grip.contact_H << (x.first + x.second) / 2, -side_ * (own_face - other_face) / 2,
      z.second - depth;
  grip.end = length > kRound ? depth : std::numeric_limits<double>::infinity();
  grip.pad = x.second - x.first;
  return grip;
}

std::optional<Grip> Jaw::at_width(double width) const {
  if (width > opening() || width < least_gap()) return std::nullopt;
  double apart = 0, beyond = 1;
  constexpr int kHalvings = 14;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (apart + beyond) / 2;
    (closed_by(middle).gap >= width ? apart : beyond) = middle;
  }
  return closed_by(apart);
}

double Jaw::shift(const Grip& grip, double width, double margin) const {
  constexpr double kEven = 1e-5;  // jaws that open equally far [m]
  const double off = open_.contact_H.y() - grip.contact_H.y(),
               nearest = (open_.gap - width) / 2 - std::abs(off);
  return margin - nearest <= kEven ? 0 : std::copysign(margin - nearest, -off);
}

std::array<Eigen::AlignedBox3d, 2> Jaw::open_fingers() const {
  std::array<Eigen::AlignedBox3d, 2> boxes;
  const std::array both{&own_, &others_};
  for (std::size_t i = 0; i < both.size(); ++i) {
    const Shapes finger(problem_, *both[i], q_open_);
    const auto corner = [&](double sign) {
      return Vector3d(sign * finger.extent(sign * Vector3d::UnitX()),
                      sign * finger.extent(sign * Vector3d::UnitY()),
                      sign * finger.extent(sign * Vector3d::UnitZ()));
    };
    boxes[i] = Eigen::AlignedBox3d(corner(-1), corner(1));
  }
  return boxes;
}

Eigen::VectorXd Jaw::contact_rates(const Grip& grip) const {
  const robot::Robot& robot = problem_.robot;
  robot::Poses X_WL;
  robot.forward(grip.q, X_WL);
  const Isometry3d& X_WH = X_WL[robot.frame(problem_.hand.grasp_frame)];
  const auto closing = [&](const LinkShapes& face, const Vector3d& inward_H) {
    const auto reach = [&](const robot::LinkShape& shape) {
      return Shapes(problem_, {shape}, grip.q).extent(inward_H);
    };
    const auto foremost =
        std::max_element(face.begin(), face.end(),
                         [&](const auto& a, const auto& b) { return reach(a) < reach(b); });
    return robot::rates(robot, foremost->link, X_WL,
                        X_WH * Vector3d(grip.contact_H - grip.gap / 2 * inward_H),
                        X_WH.linear() * inward_H);
  };
  const Vector3d inward = -side_ * Vector3d::UnitY();
  return -(closing(own_face_, inward) + closing(other_face_, -inward)).transpose();
}

Eigen::VectorXd Jaw::gap_rates(double closing) const {
  constexpr double kTurn = 1e-4;
  const Grip here = closed_by(closing);
  Eigen::VectorXd rates = contact_rates(here).cwiseAbs();
  for (const int joint : problem_.robot.group(problem_.hand.arm)) rates[joint] = -1;
  for (Eigen::Index j = 0; j < rates.size(); ++j) {
    if (rates[j] < 0) continue;
    Eigen::VectorXd q = here.q;
    q[j] += kTurn;
    rates[j] = std::max(rates[j], std::abs(gap(q) - here.gap) / kTurn);
  }
  return rates.cwiseMax(0);
}

std::vector<Shapes> Jaw::fingers(const std::vector<Grip>& grips) const {
  const LinkShapes all = shapes_of(problem_.robot, problem_.hand.fingers);
  std::vector<Shapes> found{Shapes(problem_, all, q_open_)};
  for (const Grip& grip : grips) found.emplace_back(problem_, all, grip.q);
  return found;
}

}  // namespace graspless::pinch
