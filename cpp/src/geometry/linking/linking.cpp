// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How curves wind around one another: the front of the sums in linking_kernels.hpp.
#include "graspless/geometry/linking.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "geometry/linking/kernels.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Corners = Eigen::Matrix<double, Eigen::Dynamic, 3>;

void check(const Matrix3Xd& curve, const char* name, bool is_closed) {
  const int least = is_closed ? 3 : 2;
  if (curve.cols() < least) {
    throw std::invalid_argument(std::string(name) + " must have at least " + std::to_string(least) +
                                " corners, not " + std::to_string(curve.cols()));
  }
  if (!curve.allFinite()) throw std::invalid_argument(std::string(name) + " must be finite");
}

double reach(const Matrix3Xd& curve) { return curve.cwiseAbs().maxCoeff(); }

/// The power of two that brings coordinates of this size to at most 1; differences of them cannot
/// overflow then, and results do not depend on the unit.
double scale_for(double size) {
  return std::ldexp(1.0, std::min(1000, -std::ilogb(std::max(size, 1e-300)) - 1));
}

Corners by_coordinate(const Matrix3Xd& curve, bool is_closed) {
  Corners corners(curve.cols() + (is_closed ? 1 : 0), 3);
  corners.topRows(curve.cols()) = curve.transpose();
  if (is_closed) corners.bottomRows(1) = curve.col(0).transpose();
  return corners;
}

kernels::Line line_of(const Corners& corners) {
  const double* x = corners.data();
  const Eigen::Index n = corners.rows();
  return {x, x + n, x + 2 * n, static_cast<int>(n) - 1};
}

kernels::Curve curve_of(const Matrix3Xd& corners, bool is_closed) {
  return {corners, static_cast<int>(corners.cols()) - (is_closed ? 0 : 1)};
}

/// In a fan from beside the curve; where a test is in doubt, from another place. Where the curves
/// touch every apex leaves doubt: then the integral decides, which leaves out what touches, rounded
/// towards zero from the middle.
int count_with_care(const kernels::Line& line, const Matrix3Xd& curve, double scale) {
  constexpr int kApexes = 5;
  const kernels::Curve closed = curve_of(curve, true);
  const Vector3d middle = scale * curve.rowwise().mean();
  const double size = ((scale * curve).colwise() - middle).cwiseAbs().maxCoeff();
  for (int k = 1; k <= kApexes; ++k) {
    // no symmetry of a curve that people draw
    const Vector3d aside(std::cos(1.7 * k), std::sin(2.9 * k), std::cos(4.3 * k + 1));
    const Vector3d apex = middle + 0.37 * size * aside;
    bool is_sure = true;
    const int number = kernels::signed_crossings(line, closed, scale, apex, is_sure);
    if (is_sure) return number;
  }
  const double integral = kernels::gauss_integral(line, closed, scale);
  const double rounded = std::ceil(std::max(0.0, std::abs(integral) - 0.5 - 1e-6));
  return static_cast<int>(std::copysign(rounded, integral));
}

/// In the fan from the curve's first corner, which is cheapest.
int count_crossings(const kernels::Line& line, const Matrix3Xd& curve, double scale) {
  bool is_sure = true;
  const int number =
      kernels::signed_crossings(line, curve_of(curve, true), scale, scale * curve.col(0), is_sure);
  return is_sure ? number : count_with_care(line, curve, scale);
}

/// Segments of a prepared loop that share a box.
constexpr int kBoxed = 8;

Eigen::Matrix<double, 6, Eigen::Dynamic> boxes_along(const Corners& corners) {
  const Eigen::Index segments = corners.rows() - 1;
  Eigen::Matrix<double, 6, Eigen::Dynamic> boxes(6, (segments + kBoxed - 1) / kBoxed);
  for (Eigen::Index b = 0; b < boxes.cols(); ++b) {
    const auto part =
        corners.middleRows(b * kBoxed, std::min<Eigen::Index>(kBoxed, segments - b * kBoxed) + 1);
    boxes.col(b) << part.colwise().minCoeff().transpose(), part.colwise().maxCoeff().transpose();
  }
  return boxes;
}

}  // namespace

double gauss_linking(const Matrix3Xd& a, bool a_is_closed, const Matrix3Xd& b, bool b_is_closed) {
  check(a, "a", a_is_closed);
  check(b, "b", b_is_closed);
  if (a.cols() < b.cols()) return gauss_linking(b, b_is_closed, a, a_is_closed);
  const Corners corners = by_coordinate(a, a_is_closed);
  return kernels::gauss_integral(line_of(corners), curve_of(b, b_is_closed),
                                 scale_for(std::max(reach(a), reach(b))));
}

int linking_number(const Matrix3Xd& a, const Matrix3Xd& b) {
  check(a, "a", true);
  check(b, "b", true);
  if (a.cols() < b.cols()) return linking_number(b, a);
  const Corners corners = by_coordinate(a, true);
  return count_crossings(line_of(corners), b, scale_for(std::max(reach(a), reach(b))));
}

PreparedLoop::PreparedLoop(const Matrix3Xd& loop) : points_(loop) {
  check(loop, "loop", true);
  corners_ = by_coordinate(loop, true);
  reach_ = reach(loop);
  boxes_ = boxes_along(corners_);
}

double PreparedLoop::gauss_linking(const Matrix3Xd& curve, bool is_closed) const {
  check(curve, "curve", is_closed);
  return kernels::gauss_integral(line_of(corners_), curve_of(curve, is_closed),
                                 scale_for(std::max(reach_, reach(curve))));
}

/// The fan from a corner of the curve lies within the curve's box: only segments that come near
/// that can run through it.
int PreparedLoop::linking_number(const Matrix3Xd& closed_curve) const {
  check(closed_curve, "curve", true);
  const kernels::Line line = line_of(corners_);
  const kernels::Curve curve = curve_of(closed_curve, true);
  const double scale = scale_for(std::max(reach_, reach(closed_curve)));
  const Vector3d low = closed_curve.rowwise().minCoeff();
  const Vector3d high = closed_curve.rowwise().maxCoeff();
  const auto is_near = [&](Eigen::Index b) {
    return (boxes_.col(b).head<3>().array() <= high.array()).all() &&
           (boxes_.col(b).tail<3>().array() >= low.array()).all();
  };
  int number = 0;
  bool is_sure = true;
  for (Eigen::Index b = 0; b < boxes_.cols() && is_sure; ++b) {
    if (!is_near(b)) continue;
    const int begin = static_cast<int>(b) * kBoxed;
    while (b + 1 < boxes_.cols() && is_near(b + 1)) ++b;
    const int end = std::min(line.segments, static_cast<int>(b + 1) * kBoxed);
    const kernels::Line part{line.x + begin, line.y + begin, line.z + begin, end - begin};
    number += kernels::signed_crossings(part, curve, scale, scale * closed_curve.col(0), is_sure);
  }
  return is_sure ? number : count_with_care(line, closed_curve, scale);
}

Vector3d PreparedLoop::field(const Vector3d& point) const {
  if (!point.allFinite()) throw std::invalid_argument("point must be finite");
  Vector3d sum = Vector3d::Zero();
  Vector3d r0 = points_.col(points_.cols() - 1) - point;
  for (Eigen::Index i = 0; i < points_.cols(); ++i) {
    const Vector3d r1 = points_.col(i) - point;
    const double lengths = r0.norm() * r1.norm(), apart = lengths + r0.dot(r1);
    if (apart > 1e-15 * lengths) {
      sum += r0.cross(r1) * ((r0.norm() + r1.norm()) / (lengths * apart));
    }
    r0 = r1;
  }
  return sum / (4 * M_PI);
}

std::vector<double> PreparedLoop::gauss_linking(const std::vector<Matrix3Xd>& curves,
                                                bool are_closed) const {
  std::vector<double> values;
  values.reserve(curves.size());
  for (const Matrix3Xd& curve : curves) values.push_back(gauss_linking(curve, are_closed));
  return values;
}

std::vector<int> PreparedLoop::linking_numbers(const std::vector<Matrix3Xd>& closed_curves) const {
  std::vector<int> numbers;
  numbers.reserve(closed_curves.size());
  for (const Matrix3Xd& curve : closed_curves) numbers.push_back(linking_number(curve));
  return numbers;
}

}  // namespace graspless::geometry
