// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Scales linear programs whose rows differ by orders of magnitude.
#include "mechanics/lp/conditioning.hpp"

#include <Eigen/Eigenvalues>

namespace graspless::mechanics {
namespace {

constexpr double kEven = 1e-3;       // least ratio of singular values that solvers handle well
constexpr double kDependent = 1e-7;  // ratio below which rows are dependent

}  // namespace

Matrix6d balance_conditioning(const EnvironmentWrenches& environment,
                              const std::vector<FingerWrenches>& fingers) {
  Matrix6d gram = environment.generators * environment.generators.transpose();
  for (const FingerWrenches& finger : fingers) {
    gram += finger.generators * finger.generators.transpose();
  }
  // Squares of the singular values, ascending.
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(gram);
  const Vector6d values = eigen.eigenvalues();
  const double least = values[0], largest = values[5];
  if (!(least < kEven * kEven * largest) || least < kDependent * kDependent * largest) {
    return Matrix6d::Identity();
  }
  return (largest / values.array()).sqrt().matrix().asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace graspless::mechanics
