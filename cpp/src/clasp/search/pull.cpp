// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/pull.hpp"

#include <cmath>

namespace graspless::clasp {
namespace {

double cosine(const Eigen::Vector3d& v, const Eigen::Vector3d& unit) {
  const double length = v.norm();
  return length > 0 ? v.dot(unit) / length : 0;
}

}  // namespace

std::optional<double> pull_score(const geometry::ClaspTarget& target, const PullCenters& centers,
                                 const Eigen::Vector3d& pull) {
  const double along = std::abs(target.tangent.dot(pull));
  const double outward = cosine(target.point - centers.loop, pull);
  if (along > kMaxAlong || outward < kMinOutward) return std::nullopt;
  return outward - along + cosine(target.point - centers.object, pull);
}

}  // namespace graspless::clasp
