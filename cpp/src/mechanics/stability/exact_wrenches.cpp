// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Wrenches in quadruple precision.
#include "mechanics/stability/exact_wrenches.hpp"

#include <array>
#include <vector>

#include "mechanics/contacts/cones.hpp"

namespace graspless::mechanics {
namespace {

#if __LDBL_MANT_DIG__ >= 113
using Quad = long double;
#else
__extension__ using Quad = __float128;
#endif
using QuadWrench = std::array<Quad, 6>;

QuadWrench widened(const Vector6d& wrench) {
  QuadWrench wide;
  for (int i = 0; i < 6; ++i) wide[i] = wrench[i];
  return wide;
}

QuadWrench scaled(const Matrix6d& scale, const QuadWrench& wrench) {
  QuadWrench result{};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      result[i] += Quad{scale(i, j)} * wrench[j];
    }
  }
  return result;
}

/// R^1/2 W of the unit force along `edge` at p_OC.
QuadWrench wrench(const ContactSet& set, const Eigen::Vector3d& p_OC, const Eigen::Vector3d& edge) {
  std::array<Quad, 3> r{};
  for (int i = 0; i < 3; ++i) r[i] = Quad{p_OC[i]} - Quad{set.com_O[i]};
  const Quad x = edge.x(), y = edge.y(), z = edge.z();
  return scaled(set.wrench_scale,
                {x, y, z, r[1] * z - r[2] * y, r[2] * x - r[0] * z, r[0] * y - r[1] * x});
}

Eigen::MatrixXd rounded(const Eigen::MatrixXd& rows, const std::vector<QuadWrench>& wrenches) {
  Eigen::MatrixXd product(rows.rows(), static_cast<Eigen::Index>(wrenches.size()));
  for (Eigen::Index j = 0; j < product.cols(); ++j) {
    for (Eigen::Index i = 0; i < product.rows(); ++i) {
      Quad sum = 0;
      for (int k = 0; k < 6; ++k) {
        sum += Quad{rows(i, k)} * wrenches[j][k];
      }
      product(i, j) = static_cast<double>(sum);
    }
  }
  return product;
}

template <typename Touch>
void append(const ContactSet& set, const Touch& touch, std::vector<QuadWrench>* wrenches) {
  const Eigen::Matrix3Xd edges = cone_of(touch, set.cone_edges);
  for (Eigen::Index j = 0; j < edges.cols(); ++j) {
    wrenches->push_back(wrench(set, touch.p_OC, edges.col(j)));
  }
}

}  // namespace

Eigen::MatrixXd exact_product(const Eigen::MatrixXd& rows, const Matrix6Xd& wrenches) {
  std::vector<QuadWrench> wide;
  for (Eigen::Index j = 0; j < wrenches.cols(); ++j) wide.push_back(widened(wrenches.col(j)));
  return rounded(rows, wide);
}

Eigen::MatrixXd exact_environment(const Eigen::MatrixXd& rows, const ContactSet& set) {
  std::vector<QuadWrench> wrenches;
  for (const Contact& contact : set.contacts) append(set, contact, &wrenches);
  return rounded(rows, wrenches);
}

Eigen::MatrixXd exact_finger(const Eigen::MatrixXd& rows, const ContactSet& set, int finger) {
  std::vector<QuadWrench> wrenches;
  append(set, set.fingers[finger], &wrenches);
  return rounded(rows, wrenches);
}

Eigen::VectorXd exact_known(const Eigen::MatrixXd& rows, const ContactSet& set) {
  return rounded(rows, {scaled(set.wrench_scale, widened(set.known_wrench_O))});
}

}  // namespace graspless::mechanics
