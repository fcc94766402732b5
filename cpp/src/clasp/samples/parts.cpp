// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/samples/parts.hpp"

#include <cmath>

#include "geometry/turn.hpp"

namespace graspless::clasp {
namespace {

using geometry::PlacedShape;

constexpr double kFullTurn = 6.283185307179586;  // [rad]
constexpr int kCornerSegments = 4;

PlacedShape placed(const geometry::Shape& shape, const Eigen::Vector3d& p_OG) {
  PlacedShape part{shape};
  part.X_BG.translation() = p_OG;
  return part;
}

PlacedShape capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  PlacedShape part = placed(geometry::Capsule{radius, (to - from).norm()}, (from + to) / 2);
  part.X_BG.linear() = geometry::turn_from_z(to - from).toRotationMatrix();
  return part;
}

}  // namespace

Parts bar(const Points& points, double radius) {
  Parts parts;
  for (std::size_t i = 1; i < points.size(); ++i) {
    parts.push_back(capsule(points[i - 1], points[i], radius));
  }
  return parts;
}

Parts arch(const Arch& arch) {
  const double bend = arch.corner + arch.radius;  // of the bar's centre line
  const double x = arch.width / 2 - arch.corner, z = arch.height - arch.corner;
  Points points{{-x - bend, 0, -arch.root}};
  for (int i = 0; i <= kCornerSegments; ++i) {
    const double angle = kFullTurn / 4 * i / kCornerSegments;
    points.emplace_back(-x - bend * std::cos(angle), 0, z + bend * std::sin(angle));
  }
  for (std::size_t i = points.size(); i-- > 0;) {  // mirrored half
    points.emplace_back(-points[i].x(), 0, points[i].z());
  }
  return bar(points, arch.radius);
}

PlacedShape box(const Eigen::Vector3d& size, const Eigen::Vector3d& p_OG) {
  return placed(geometry::Box{size}, p_OG);
}

PlacedShape wedge(const Eigen::Vector2d& lower_size, double lower,
                  const Eigen::Vector2d& upper_size, double upper) {
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d side(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5);
    corners.col(i) << side.cwiseProduct(i & 4 ? upper_size : lower_size), i & 4 ? upper : lower;
  }
  return placed(geometry::Convex{corners}, Eigen::Vector3d::Zero());
}

PlacedShape ellipsoid(const Eigen::Vector3d& half_axes, const Eigen::Vector3d& p_OG) {
  constexpr int kRings = 9, kSectors = 18;
  Eigen::Matrix3Xd points(3, kRings * kSectors + 2);
  Eigen::Index next = 0;
  for (int ring = 1; ring <= kRings; ++ring) {
    const double polar = kFullTurn / 2 * ring / (kRings + 1);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double around = kFullTurn * sector / kSectors;
      points.col(next++) << std::cos(polar), std::sin(polar) * std::cos(around),
          std::sin(polar) * std::sin(around);
    }
  }
  points.col(next++) << 1, 0, 0;
  points.col(next) << -1, 0, 0;
  return placed(geometry::Convex{half_axes.asDiagonal() * points}, p_OG);
}

PlacedShape disc(double radius, double width, const Eigen::Vector3d& p_OG) {
  constexpr int kSectors = 20;
  Eigen::Matrix3Xd points(3, 2 * kSectors);
  for (int i = 0; i < kSectors; ++i) {
    const double angle = kFullTurn * i / kSectors;
    points.col(2 * i) << radius * std::sin(angle), width / 2, -radius * std::cos(angle);
    points.col(2 * i + 1) << radius * std::sin(angle), -width / 2, -radius * std::cos(angle);
  }
  return placed(geometry::Convex{points}, p_OG);
}

Parts moved(Parts parts, const Eigen::Vector3d& by) {
  for (PlacedShape& part : parts) part.X_BG.pretranslate(by);
  return parts;
}

void append(Parts& parts, const Parts& more) {
  parts.insert(parts.end(), more.begin(), more.end());
}

}  // namespace graspless::clasp
