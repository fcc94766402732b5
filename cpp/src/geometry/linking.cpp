// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How curves wind around one another: the front of the sums in linking_kernels.hpp.
#include "graspless/geometry/linking.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/linking_kernels.hpp"

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

/// By the fan from the curve's first corner; where that is in doubt, from others beside it. Where
/// the curves touch every apex leaves doubt: then the integral decides, which leaves out what
/// touches, rounded towards zero from the middle.
int count_crossings(const kernels::Line& line, const Matrix3Xd& curve, double scale) {
  constexpr int kApexes = 5;
  const kernels::Curve closed = curve_of(curve, true);
  bool is_sure = false;
  int number = kernels::signed_crossings(line, closed, scale, scale * curve.col(0), is_sure);
  if (is_sure) return number;
  const Vector3d middle = scale * curve.rowwise().mean();
  const double size = ((scale * curve).colwise() - middle).cwiseAbs().maxCoeff();
  for (int k = 1; k <= kApexes; ++k) {
    // no symmetry of a curve that people draw
    const Vector3d aside(std::cos(1.7 * k), std::sin(2.9 * k), std::cos(4.3 * k + 1));
    number = kernels::signed_crossings(line, closed, scale, middle + 0.37 * size * aside, is_sure);
    if (is_sure) return number;
  }
  const double integral = kernels::gauss_integral(line, closed, scale);
  const double size_of_integral = std::ceil(std::max(0.0, std::abs(integral) - 0.5 - 1e-6));
  return static_cast<int>(std::copysign(size_of_integral, integral));
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
  low_ = loop.rowwise().minCoeff();
  high_ = loop.rowwise().maxCoeff();
}

double PreparedLoop::gauss_linking(const Matrix3Xd& curve, bool is_closed) const {
  check(curve, "curve", is_closed);
  return kernels::gauss_integral(line_of(corners_), curve_of(curve, is_closed),
                                 scale_for(std::max(reach_, reach(curve))));
}

int PreparedLoop::linking_number(const Matrix3Xd& closed_curve) const {
  check(closed_curve, "curve", true);
  const bool lies_apart = (closed_curve.rowwise().minCoeff().array() > high_.array()).any() ||
                          (closed_curve.rowwise().maxCoeff().array() < low_.array()).any();
  if (lies_apart) return 0;
  return count_crossings(line_of(corners_), closed_curve,
                         scale_for(std::max(reach_, reach(closed_curve))));
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
