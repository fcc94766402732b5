// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sampling/hilbert_order.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/hilbert_sort.h>

namespace graspless::geometry {
namespace {

/// The 21 bits of a whole number, each followed by two zeros.
std::uint64_t spread(double value) {
  auto bits = static_cast<std::uint64_t>(value);
  bits = (bits | bits << 32) & 0x1f00000000ffffull;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffull;
  bits = (bits | bits << 8) & 0x100f00f00f00f00full;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ull;
  return (bits | bits << 2) & 0x1249249249249249ull;
}

}  // namespace

Eigen::Matrix3Xd in_hilbert_order(const Eigen::Matrix3Xd& points) {
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> sorted;
  for (const auto& p : points.colwise()) sorted.emplace_back(p.x(), p.y(), p.z());
  CGAL::hilbert_sort(sorted.begin(), sorted.end(), Kernel());
  Eigen::Matrix3Xd out(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Kernel::Point_3& p = sorted[i];
    out.col(i) << p.x(), p.y(), p.z();
  }
  return out;
}

std::vector<int> morton_order(const Eigen::Matrix3Xd& points) {
  constexpr double kCells = 1 << 21;  // along a side
  const Eigen::Vector3d low = points.rowwise().minCoeff();
  const double side = (points.rowwise().maxCoeff() - low).maxCoeff();
  const double scale = side > 0 ? (kCells - 1) / side : 0;
  std::vector<std::pair<std::uint64_t, int>> codes;
  codes.reserve(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d cell = (points.col(i) - low) * scale;
    const std::uint64_t code = spread(cell.x()) | spread(cell.y()) << 1 | spread(cell.z()) << 2;
    codes.emplace_back(code, static_cast<int>(i));
  }
  std::sort(codes.begin(), codes.end());
  std::vector<int> order;
  order.reserve(codes.size());
  for (const auto& [code, i] : codes) order.push_back(i);
  return order;
}

}  // namespace graspless::geometry
