// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/hilbert_order.hpp"

#include <vector>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/hilbert_sort.h>

namespace graspless::geometry {

Eigen::Matrix3Xd in_hilbert_order(const Eigen::Matrix3Xd& points) {
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> sorted;
  for (const auto& p : points.colwise()) sorted.emplace_back(p.x(), p.y(), p.z());
  CGAL::hilbert_sort(sorted.begin(), sorted.end(), Kernel());
  Eigen::Matrix3Xd out(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Kernel::Point_3& p = sorted[static_cast<std::size_t>(i)];
    out.col(i) << p.x(), p.y(), p.z();
  }
  return out;
}

}  // namespace graspless::geometry
