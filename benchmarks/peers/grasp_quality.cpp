// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grasp_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <Eigen/Geometry>

namespace graspless::benchmarks {
namespace {

using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

constexpr int kEdges = 8;  // of a linear friction cone
constexpr Eigen::Index kDirections = 2000;
constexpr int kStarts = 40;  // of the directions, those least resisted

/// Unit vectors, the same every time.
const Wrenches& directions() {
  static const Wrenches all = [] {
    std::mt19937_64 rng(1);
    std::normal_distribution<double> normal;
    Wrenches d(6, kDirections);
    for (double& value : d.reshaped()) value = normal(rng);
    d.colwise().normalize();
    return d;
  }();
  return all;
}

Wrenches edge_wrenches(const std::vector<GraspContact>& contacts, const Eigen::Vector3d& center_O,
                       double size, double friction) {
  Wrenches edges(6, static_cast<Eigen::Index>(contacts.size()) * kEdges);
  Eigen::Index next = 0;
  for (const GraspContact& contact : contacts) {
    const Eigen::Vector3d u = contact.n_O.unitOrthogonal(), v = contact.n_O.cross(u);
    for (int k = 0; k < kEdges; ++k, ++next) {
      const double angle = 2 * M_PI * k / kEdges;
      const Eigen::Vector3d force =
          contact.n_O + friction * (std::cos(angle) * u + std::sin(angle) * v);
      edges.col(next) << force, (contact.p_O - center_O).cross(force) / size;
    }
  }
  return edges;
}

/// The least that is resisted near a direction: down the slope of a convex function, on a sphere.
double least_near(const Wrenches& edges, Eigen::Matrix<double, 6, 1> d) {
  constexpr int kSteps = 150;
  double least = std::numeric_limits<double>::infinity(), step = 0.3;
  for (int i = 0; i < kSteps; ++i, step *= 0.95) {
    Eigen::Index strongest;
    least = std::min(least, (d.transpose() * edges).maxCoeff(&strongest));
    d = (d - step * edges.col(strongest)).normalized();
  }
  return least;
}

}  // namespace

double grasp_quality(const std::vector<GraspContact>& contacts, const Eigen::Vector3d& center_O,
                     double size, double friction) {
  if (contacts.size() < 2) return 0;
  const Wrenches edges = edge_wrenches(contacts, center_O, size, friction);
  const Eigen::VectorXd resisted = (directions().transpose() * edges).rowwise().maxCoeff();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(kDirections));
  std::iota(order.begin(), order.end(), 0);
  std::partial_sort(order.begin(), order.begin() + kStarts, order.end(),
                    [&](Eigen::Index a, Eigen::Index b) { return resisted[a] < resisted[b]; });
  double least = resisted[order.front()];
  for (int i = 0; i < kStarts && least > 0; ++i) {
    least = std::min(least, least_near(edges, directions().col(order[i])));
  }
  return std::max(0.0, least);
}

}  // namespace graspless::benchmarks
