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

std::optional<double> pull_score(const geometry::ClaspTarget& place, const Pulled& of,
                                 const Eigen::Vector3d& pull) {
  const double along = std::abs(place.tangent.dot(pull));
  const double outward = cosine(place.point - of.loop_middle, pull);
  if (along > kMostAlong || outward < kLeastOutward) return std::nullopt;
  return outward - along + cosine(place.point - of.object_middle, pull);
}

}  // namespace graspless::clasp
