// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scale of wrenches, Eqs. (7) and (8), and the disturbances of Problem (6).
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "graspless/mechanics/contact.hpp"

#include "mechanics/contacts/wrenches.hpp"
#include "text.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kEqual = 1e-9;  // relative difference of moments that count as equal

struct Principal {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;  // columns
};

/// Turns the axes towards the columns of `targets`: signs are free, and so are rotations within the
/// spaces of equal moments. Returns the sum of the cosines that remain.
double turn_towards(const Eigen::Matrix3d& targets, Principal& principal) {
  Eigen::Matrix3d near = principal.axes.transpose() * targets;
  const double equal = kEqual * principal.moments.maxCoeff();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (std::abs(principal.moments[i] - principal.moments[j]) > equal) near(i, j) = 0;
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(near, Eigen::ComputeFullU | Eigen::ComputeFullV);
  principal.axes = principal.axes * svd.matrixU() * svd.matrixV().transpose();
  return (principal.axes.transpose() * targets).trace();
}

/// Returns principal axes in the order and with the signs nearest to the axes of O.
Principal principal_axes(const Eigen::Matrix3d& inertia) {
  Eigen::Matrix3d off = inertia;
  off.diagonal().setZero();
  if (off.cwiseAbs().maxCoeff() <= 1e-12 * inertia.trace()) {
    return {inertia.diagonal(), Eigen::Matrix3d::Identity()};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Principal best;
  double nearest = -1;
  std::array<int, 3> order{0, 1, 2};  // axis of O for each eigenvector
  do {
    Principal candidate{solver.eigenvalues(), solver.eigenvectors()};
    Eigen::Matrix3d targets;
    for (int i = 0; i < 3; ++i) {
      targets.col(i) = Eigen::Vector3d::Unit(order[i]);
    }
    const double near = turn_towards(targets, candidate);
    if (near <= nearest + 1e-9) continue;
    nearest = near;
    for (int i = 0; i < 3; ++i) {
      const int axis = order[i];
      best.moments[axis] = candidate.moments[i];
      best.axes.col(axis) = candidate.axes.col(i);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

void check_inertia(double mass, const Eigen::Matrix3d& inertia) {
  require_within("mass", mass, kMinMass, kMaxMass, " kg");
  if (!inertia.allFinite()) throw std::invalid_argument("inertia_O must be finite");
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() >
      1e-9 * inertia.cwiseAbs().maxCoeff()) {
    throw std::invalid_argument("inertia_O must be symmetric");
  }
}

void check_moments(const Eigen::Vector3d& moments) {
  const double least = moments.minCoeff();
  if (!(least > 0)) {
    throw std::invalid_argument("inertia_O must be positive definite: its least moment is " +
                                figure(least));
  }
  if (moments.sum() - 2 * moments.maxCoeff() < -1e-9 * moments.maxCoeff()) {
    throw std::invalid_argument(
        "inertia_O must have no principal moment above the sum of the others, as no body has: " +
        figure(moments.x()) + ", " + figure(moments.y()) + ", " + figure(moments.z()));
  }
}

}  // namespace

Matrix6d wrench_scale(double mass, const Eigen::Matrix3d& inertia_O) {
  check_inertia(mass, inertia_O);
  const Principal principal = principal_axes((inertia_O + inertia_O.transpose()) / 2);
  check_moments(principal.moments);
  const Eigen::Vector3d per_moment = (mass * principal.moments.cwiseInverse()).cwiseSqrt();
  if (!(per_moment.maxCoeff() <= kMaxScale))
    throw std::invalid_argument("inertia_O has a moment of " +
                                figure(principal.moments.minCoeff()) +
                                " kg m^2, too little for a mass of " + figure(mass) + " kg");
  Matrix6d scale = Matrix6d::Zero();
  scale.topLeftCorner<3, 3>() = principal.axes.transpose();
  scale.bottomRightCorner<3, 3>() = per_moment.asDiagonal() * principal.axes.transpose();
  return scale;
}

Matrix6Xd disturbance_directions() {
  const double k = 2 * std::sqrt(3 - std::sqrt(6.0));
  Matrix6Xd directions(6, 76);
  directions.leftCols<6>() = k * Matrix6d::Identity();
  directions.middleCols<6>(6) = -k * Matrix6d::Identity();
  for (int corner = 0; corner < 64; ++corner) {
    for (int axis = 0; axis < 6; ++axis) {
      directions(axis, 12 + corner) = ((corner >> axis) & 1) != 0 ? -k : k;
    }
    directions.col(12 + corner) /= std::sqrt(6.0);
  }
  return directions;
}

}  // namespace graspless::mechanics
