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

/// The open curve with its chord as a closed one.
struct Chord {
  double chord, length;  // of the chord, and of the closed curve
};

Chord measure(const Matrix3Xd& curve) {
  const Eigen::Index n = curve.cols();
  const double chord = (curve.col(n - 1) - curve.col(0)).norm();
  return {chord, chord + (curve.rightCols(n - 1) - curve.leftCols(n - 1)).colwise().norm().sum()};
}

int closed_linking_number(const Matrix3Xd& loop, const Matrix3Xd& curve) {
  check(loop, "loop", true);
  check(curve, "curve", false);
  return curve.cols() < 3 ? 0 : linking_number(loop, curve);
}

void add_direction(const Vector3d& from, const Vector3d& to, double factor, Matrix3Xd& gradient,
                   Eigen::Index i, Eigen::Index j) {
  const double length = (to - from).norm();
  if (length == 0) return;
  const Vector3d direction = (to - from) * (factor / length);
  gradient.col(i) -= direction;
  gradient.col(j) += direction;
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

double virtual_linking(const Matrix3Xd& loop, const Matrix3Xd& curve) {
  const int number = closed_linking_number(loop, curve);
  if (number == 0) return 0;
  const Chord closed = measure(curve);
  return (1 - closed.chord / closed.length) * number;
}

VirtualLinking virtual_linking_gradient(const Matrix3Xd& loop, const Matrix3Xd& curve) {
  VirtualLinking result;
  result.linking_number = closed_linking_number(loop, curve);
  result.gradient.setZero(3, curve.cols());
  if (result.linking_number == 0) return result;
  const Chord closed = measure(curve);
  result.value = (1 - closed.chord / closed.length) * result.linking_number;
  const Eigen::Index last = curve.cols() - 1;
  const double per_length = result.linking_number * closed.chord / (closed.length * closed.length);
  const double per_chord = per_length - result.linking_number / closed.length;
  add_direction(curve.col(last), curve.col(0), per_chord, result.gradient, last, 0);
  for (Eigen::Index i = 0; i < last; ++i) {
    add_direction(curve.col(i), curve.col(i + 1), per_length, result.gradient, i, i + 1);
  }
  return result;
}

PreparedLoop::PreparedLoop(const Matrix3Xd& loop) : points_(loop) {
  check(loop, "loop", true);
  corners_ = by_coordinate(loop, true);
  reach_ = reach(loop);
}

double PreparedLoop::gauss_linking(const Matrix3Xd& curve, bool is_closed) const {
  check(curve, "curve", is_closed);
  return kernels::gauss_integral(line_of(corners_), curve_of(curve, is_closed),
                                 scale_for(std::max(reach_, reach(curve))));
}

int PreparedLoop::linking_number(const Matrix3Xd& closed_curve) const {
  check(closed_curve, "curve", true);
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
