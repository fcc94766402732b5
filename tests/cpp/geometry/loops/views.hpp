// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Views of simple objects, made by casting rays.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graspless/geometry/loops.hpp"

namespace graspless::geometry {

constexpr float kOpen = std::numeric_limits<float>::infinity();

struct Block {
  Eigen::Vector3d low, high;
  bool is_object = true;
};

/// Length of a ray up to a block; infinite if it misses.
inline double hit(const Block& block, const Eigen::Vector3d& p, const Eigen::Vector3d& r) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double a = (block.low[i] - p[i]) / r[i], b = (block.high[i] - p[i]) / r[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out && in > 0 ? in : std::numeric_limits<double>::infinity();
}

/// A camera at `eye` that looks at the origin, with x level.
inline Eigen::Isometry3d look_from(const Eigen::Vector3d& eye) {
  const Eigen::Vector3d z = -eye.normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() << x, z.cross(x), z;
  X.translation() = eye;
  return X;
}

struct Seen {
  Eigen::Matrix3Xd points;
  std::vector<RayImage> rays;
};

/// What cameras see of blocks: the points where rays end on the object, and the rays.
inline Seen look(const std::vector<Block>& blocks, const std::vector<Eigen::Vector3d>& eyes) {
  constexpr int kSide = 120;
  Seen seen;
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& eye : eyes) {
    RayImage rays;
    rays.K << 200, 0, (kSide - 1) / 2.0, 0, 200, (kSide - 1) / 2.0, 0, 0, 1;
    rays.X_OC = look_from(eye);
    rays.ends.setConstant(kSide, kSide, kOpen);
    for (int v = 0; v < kSide; ++v) {
      for (int u = 0; u < kSide; ++u) {
        const Eigen::Vector3d r =
            rays.X_OC.linear() * rays.K.inverse() * Eigen::Vector3d(u + 1e-4, v + 1e-4, 1);
        double nearest = std::numeric_limits<double>::infinity();
        bool is_object = false;
        for (const Block& block : blocks) {
          const double z = hit(block, eye, r);
          if (z >= nearest) continue;
          nearest = z;
          is_object = block.is_object;
        }
        if (std::isinf(nearest)) continue;
        rays.ends(v, u) = static_cast<float>(is_object ? -nearest : nearest);
        if (is_object) points.push_back(eye + nearest * r);
      }
    }
    seen.rays.push_back(rays);
  }
  seen.points.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) seen.points.col(i) = points[i];
  return seen;
}

inline Loops loops_of(const Seen& seen) { return shortest_loops(seen.points, {}, seen.rays); }

/// A frame with an opening of 0.12 x 0.12 m, from posts 20 mm thick, that faces y. The right post
/// ends `gap` below the upper one.
inline std::vector<Block> frame(double gap = 0) {
  return {{{-0.08, -0.01, -0.08}, {-0.06, 0.01, 0.08}},
          {{0.06, -0.01, -0.08}, {0.08, 0.01, 0.06 - gap}},
          {{-0.06, -0.01, -0.08}, {0.06, 0.01, -0.06}},
          {{-0.06, -0.01, 0.06}, {0.08, 0.01, 0.08}}};
}

/// Walls of a box 0.16 m wide and 0.08 m high, open at the top, with a floor or without.
inline std::vector<Block> tray(bool has_floor) {
  std::vector<Block> blocks = {{{-0.08, -0.08, -0.04}, {-0.075, 0.08, 0.04}},
                               {{0.075, -0.08, -0.04}, {0.08, 0.08, 0.04}},
                               {{-0.075, -0.08, -0.04}, {0.075, -0.075, 0.04}},
                               {{-0.075, 0.075, -0.04}, {0.075, 0.08, 0.04}}};
  if (has_floor) blocks.push_back({{-0.075, -0.075, -0.04}, {0.075, 0.075, -0.038}});
  return blocks;
}

inline const Eigen::Vector3d kFront(0.05, -0.45, 0.1), kAbove(0.05, -0.2, 0.4);

}  // namespace graspless::geometry
