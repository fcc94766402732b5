// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Virtual linking, eq. (2) of Stork, Pokorny, Kragic 2013.
#include <stdexcept>
#include <string>

#include "graspless/geometry/linking.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

struct Lengths {
  double chord, closed;  // delta and |alpha^|: chord, and curve with chord [m]
};

Lengths measure(const Matrix3Xd& curve) {
  if (curve.cols() < 2) {
    throw std::invalid_argument("curve must have at least 2 corners, not " +
                                std::to_string(curve.cols()));
  }
  if (!curve.allFinite()) throw std::invalid_argument("curve must be finite");
  const Eigen::Index last = curve.cols() - 1;
  double length = 0;
  for (Eigen::Index i = 0; i < last; ++i) length += (curve.col(i + 1) - curve.col(i)).norm();
  const double chord = (curve.col(last) - curve.col(0)).norm();
  return {chord, chord + length};
}

double closedness_of(const Lengths& lengths) {
  return lengths.closed > 0 ? 1 - lengths.chord / lengths.closed : 0;
}

/// Adds `factor` times the gradient of the distance between corners i and j.
void add_distance_gradient(const Matrix3Xd& curve, Eigen::Index i, Eigen::Index j, double factor,
                           Matrix3Xd& gradient) {
  const Vector3d difference = curve.col(j) - curve.col(i);
  const double length = difference.norm();
  if (length == 0) return;
  gradient.col(i) -= difference * (factor / length);
  gradient.col(j) += difference * (factor / length);
}

int linking_with_chord(const Matrix3Xd& loop, const Matrix3Xd& curve) {
  return curve.cols() < 3 ? 0 : linking_number(loop, curve);
}

}  // namespace

double closedness(const Matrix3Xd& curve) { return closedness_of(measure(curve)); }

double closedness(const Matrix3Xd& curve, Matrix3Xd& gradient) {
  const Lengths lengths = measure(curve);
  gradient.setZero(3, curve.cols());
  if (lengths.closed == 0) return 0;
  const double per_length = lengths.chord / (lengths.closed * lengths.closed);
  const Eigen::Index last = curve.cols() - 1;
  for (Eigen::Index i = 0; i < last; ++i)
    add_distance_gradient(curve, i, i + 1, per_length, gradient);
  add_distance_gradient(curve, last, 0, per_length - 1 / lengths.closed, gradient);
  return closedness_of(lengths);
}

double virtual_linking(const Matrix3Xd& loop, const Matrix3Xd& curve) {
  const double factor = closedness(curve);
  return factor * linking_with_chord(loop, curve);
}

VirtualLinking virtual_linking_gradient(const Matrix3Xd& loop, const Matrix3Xd& curve) {
  VirtualLinking result;
  const double factor = closedness(curve, result.gradient);
  result.linking_number = linking_with_chord(loop, curve);
  result.value = factor * result.linking_number;
  result.gradient *= result.linking_number;
  return result;
}

}  // namespace graspless::geometry
