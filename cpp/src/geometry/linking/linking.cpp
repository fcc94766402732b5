// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Linking of curves: checks, scales and lays out the input of the sums in kernels.hpp.
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

void require_curve(const Matrix3Xd& curve, const char* name, bool is_closed) {
  const int least = is_closed ? 3 : 2;
  if (curve.cols() < least) {
    throw std::invalid_argument(std::string(name) + " must have at least " + std::to_string(least) +
                                " corners, not " + std::to_string(curve.cols()));
  }
  if (!curve.allFinite()) throw std::invalid_argument(std::string(name) + " must be finite");
}

double max_coordinate(const Matrix3Xd& curve) { return curve.cwiseAbs().maxCoeff(); }

/// Power of two that scales coordinates of this size to at most 1. Their differences then cannot
/// overflow, and results do not depend on the unit.
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

/// Tries several apexes beside the curve until no test is within rounding of changing sides. If the
/// curves touch, every apex fails. The integral, which omits touching segments, then decides. It is
/// rounded with a half towards zero.
int robust_linking_number(const kernels::Line& line, const Matrix3Xd& curve, double scale) {
  constexpr int kApexes = 5;
  const kernels::Curve closed = curve_of(curve, true);
  const Vector3d middle = scale * curve.rowwise().mean();
  const double size = ((scale * curve).colwise() - middle).cwiseAbs().maxCoeff();
  for (int k = 1; k <= kApexes; ++k) {
    // Avoids the symmetries of hand-made curves.
    const Vector3d aside(std::cos(1.7 * k), std::sin(2.9 * k), std::cos(4.3 * k + 1));
    const Vector3d apex = middle + 0.37 * size * aside;
    bool is_certain = true;
    const int number = kernels::signed_crossings(line, closed, scale, apex, is_certain);
    if (is_certain) return number;
  }
  const double integral = kernels::gauss_integral(line, closed, scale);
  const double rounded = std::ceil(std::max(0.0, std::abs(integral) - 0.5 - 1e-6));
  return static_cast<int>(std::copysign(rounded, integral));
}

/// Uses the curve's first corner as the apex, which is cheapest.
int fast_linking_number(const kernels::Line& line, const Matrix3Xd& curve, double scale) {
  bool is_certain = true;
  const int number = kernels::signed_crossings(line, curve_of(curve, true), scale,
                                               scale * curve.col(0), is_certain);
  return is_certain ? number : robust_linking_number(line, curve, scale);
}

/// Number of consecutive segments of a prepared loop that share a bounding box.
constexpr int kSegmentsPerBox = 8;

Eigen::Matrix<double, 6, Eigen::Dynamic> boxes_along(const Corners& corners) {
  const Eigen::Index segments = corners.rows() - 1;
  Eigen::Matrix<double, 6, Eigen::Dynamic> boxes(
      6, (segments + kSegmentsPerBox - 1) / kSegmentsPerBox);
  for (Eigen::Index b = 0; b < boxes.cols(); ++b) {
    const auto part = corners.middleRows(
        b * kSegmentsPerBox,
        std::min<Eigen::Index>(kSegmentsPerBox, segments - b * kSegmentsPerBox) + 1);
    boxes.col(b) << part.colwise().minCoeff().transpose(), part.colwise().maxCoeff().transpose();
  }
  return boxes;
}

}  // namespace

double gauss_linking(const Matrix3Xd& a, bool a_is_closed, const Matrix3Xd& b, bool b_is_closed) {
  require_curve(a, "a", a_is_closed);
  require_curve(b, "b", b_is_closed);
  if (a.cols() < b.cols()) return gauss_linking(b, b_is_closed, a, a_is_closed);
  const Corners corners = by_coordinate(a, a_is_closed);
  return kernels::gauss_integral(line_of(corners), curve_of(b, b_is_closed),
                                 scale_for(std::max(max_coordinate(a), max_coordinate(b))));
}

int linking_number(const Matrix3Xd& a, const Matrix3Xd& b) {
  require_curve(a, "a", true);
  require_curve(b, "b", true);
  if (a.cols() < b.cols()) return linking_number(b, a);
  const Corners corners = by_coordinate(a, true);
  return fast_linking_number(line_of(corners), b,
                             scale_for(std::max(max_coordinate(a), max_coordinate(b))));
}

PreparedLoop::PreparedLoop(const Matrix3Xd& loop) : points_(loop) {
  require_curve(loop, "loop", true);
  corners_ = by_coordinate(loop, true);
  max_coordinate_ = max_coordinate(loop);
  boxes_ = boxes_along(corners_);
}

double PreparedLoop::gauss_linking(const Matrix3Xd& curve, bool is_closed) const {
  require_curve(curve, "curve", is_closed);
  return kernels::gauss_integral(line_of(corners_), curve_of(curve, is_closed),
                                 scale_for(std::max(max_coordinate_, max_coordinate(curve))));
}

/// The fan of triangles from a corner of the curve lies within the curve's bounding box. Only
/// segments whose box overlaps that box can cross it.
int PreparedLoop::linking_number(const Matrix3Xd& closed_curve) const {
  require_curve(closed_curve, "curve", true);
  const kernels::Line line = line_of(corners_);
  const kernels::Curve curve = curve_of(closed_curve, true);
  const double scale = scale_for(std::max(max_coordinate_, max_coordinate(closed_curve)));
  const Vector3d low = closed_curve.rowwise().minCoeff();
  const Vector3d high = closed_curve.rowwise().maxCoeff();
  const auto is_near = [&](Eigen::Index b) {
    return (boxes_.col(b).head<3>().array() <= high.array()).all() &&
           (boxes_.col(b).tail<3>().array() >= low.array()).all();
  };
  int number = 0;
  bool is_certain = true;
  for (Eigen::Index b = 0; b < boxes_.cols() && is_certain; ++b) {
    if (!is_near(b)) continue;
    const int begin = static_cast<int>(b) * kSegmentsPerBox;
    while (b + 1 < boxes_.cols() && is_near(b + 1)) ++b;
    const int end = std::min(line.segments, static_cast<int>(b + 1) * kSegmentsPerBox);
    const kernels::Line part{line.x + begin, line.y + begin, line.z + begin, end - begin};
    number +=
        kernels::signed_crossings(part, curve, scale, scale * closed_curve.col(0), is_certain);
  }
  return is_certain ? number : robust_linking_number(line, closed_curve, scale);
}

Vector3d PreparedLoop::field(const Vector3d& point) const {
  if (!point.allFinite()) throw std::invalid_argument("point must be finite");
  Vector3d sum = Vector3d::Zero();
  Vector3d r0 = points_.col(points_.cols() - 1) - point;
  for (Eigen::Index i = 0; i < points_.cols(); ++i) {
    const Vector3d r1 = points_.col(i) - point;
    const double lengths = r0.norm() * r1.norm(), denominator = lengths + r0.dot(r1);
    if (denominator > 1e-15 * lengths) {
      sum += r0.cross(r1) * ((r0.norm() + r1.norm()) / (lengths * denominator));
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
