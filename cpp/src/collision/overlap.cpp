// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// FCL's penetration depth is not used: it aborts on flush shapes, and has no meaning for meshes.
#include "collision/overlap.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "graspless/watch.hpp"

namespace graspless::collision {
namespace {

constexpr double kShortest = 1e-3, kLongest = 4;  // first and last translation [m]
constexpr double kPrecision = 0.03;               // relative

/// Directions from the middle of a cube to its faces, edges and corners.
std::vector<Eigen::Vector3d> cube_directions() {
  std::vector<Eigen::Vector3d> all;
  for (int i = 0; i < 27; ++i) {
    if (i != 13) all.push_back(Eigen::Vector3d(i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1).normalized());
  }
  return all;
}

int index_of(const World& world, std::pair<int, int> wanted) {
  const auto pairs = world.pairs();
  const auto found = std::find(pairs.begin(), pairs.end(), wanted);
  return found == pairs.end() ? -1 : static_cast<int>(found - pairs.begin());
}

/// Moves one body of a pair, and puts it back at the end.
class Parting {
 public:
  Parting(World& world, int pair)
      : world_(world), pair_(pair), body_(world.pair(pair).second), X_WB_(world.pose(body_)) {}
  ~Parting() { world_.set_pose(body_, X_WB_); }
  Parting(const Parting&) = delete;
  Parting& operator=(const Parting&) = delete;

  bool parts(const Eigen::Vector3d& translation_W) {
    world_.set_pose(body_, Eigen::Translation3d(translation_W) * X_WB_);
    return !world_.touches(pair_);
  }

 private:
  World& world_;
  int pair_, body_;
  Eigen::Isometry3d X_WB_;
};

}  // namespace

double overlap(World& world, int a, int b) {
  const int pair = index_of(world, std::minmax(a, b));
  if (pair < 0 || !world.touches(pair)) return 0;
  Parting parting(world, pair);
  const auto directions = cube_directions();
  double parted = std::numeric_limits<double>::infinity();
  for (double length = kShortest; length <= kLongest && parted > length; length *= 2) {
    for (const auto& direction : directions) {
      poll();
      if (!parting.parts(std::min(length, parted) * direction)) continue;
      double touching = length == kShortest ? 0 : length / 2;
      parted = std::min(length, parted);
      while (parted - touching > std::max(kPrecision * parted, kPrecision * kShortest)) {
        const double middle = (touching + parted) / 2;
        (parting.parts(middle * direction) ? parted : touching) = middle;
      }
    }
  }
  return parted;
}

}  // namespace graspless::collision
