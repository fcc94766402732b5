// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Evenly spread points on the outer surface of a union of shapes.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "graspless/geometry/pose.hpp"
#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/sampling/darts.hpp"
#include "geometry/sampling/hilbert_order.hpp"
#include "geometry/sampling/interior.hpp"
#include "geometry/sampling/sample_elimination.hpp"
#include "geometry/sampling/surface_sampler.hpp"

namespace graspless::geometry {
namespace {

// Candidates per requested point, as Yuksel proposes.
constexpr int kCandidates = 5;
// Larger clouds are spread a little less evenly, in a tenth of the time.
constexpr int kLarge = 100'000;
// Largest number of draws per candidate. The others lie inside a shape.
constexpr int kMaxDraws = 2000;
// Points are tested this far outside their shape [m], so that touching faces do not count as outer.
constexpr double kOutside = 1e-7;

struct Candidates {
  Eigen::Matrix3Xd points;
  double area = 0;  // of the outer surface, estimated [m^2]
};

class Surface {
 public:
  explicit Surface(const std::vector<PlacedShape>& shapes) {
    for (const PlacedShape& placed : shapes) {
      samplers_.emplace_back(placed);
      interiors_.emplace_back(placed);
      area_ += samplers_.back().area();
      cumulative_area_.push_back(area_);
    }
  }

  Candidates draw(int count, std::mt19937_64& rng) const {
    Candidates candidates{Eigen::Matrix3Xd(3, count)};
    const std::int64_t limit = std::int64_t{kMaxDraws} * count;
    std::int64_t num_draws = 0;
    for (int found = 0; found < count; ++num_draws) {
      poll();
      if (num_draws == limit) {
        throw std::invalid_argument("shapes have almost no surface outside one another");
      }
      const std::size_t shape = draw_shape(rng);
      const SurfaceSampler::Point point = samplers_[shape].draw(rng);
      if (!is_outside(point, shape)) continue;
      candidates.points.col(found++) = point.p_B;
    }
    candidates.area = area_ * count / static_cast<double>(num_draws);
    return candidates;
  }

 private:
  std::size_t draw_shape(std::mt19937_64& rng) const {
    const auto at = std::upper_bound(cumulative_area_.begin(), cumulative_area_.end() - 1,
                                     area_ * draw_uniform(rng));
    return static_cast<std::size_t>(at - cumulative_area_.begin());
  }

  bool is_outside(const SurfaceSampler::Point& point, std::size_t own) const {
    const Eigen::Vector3d p_B = point.p_B + kOutside * point.outward_B;
    for (std::size_t i = 0; i < interiors_.size(); ++i) {
      if (i != own && interiors_[i].contains(p_B)) return false;
    }
    return true;
  }

  std::vector<SurfaceSampler> samplers_;
  std::vector<Interior> interiors_;
  std::vector<double> cumulative_area_;
  double area_ = 0;
};

}  // namespace

Eigen::Matrix3Xd sample_surface(const std::vector<PlacedShape>& shapes, int count,
                                std::uint64_t seed) {
  constexpr int kMaxCount = 10'000'000;
  if (count < 1 || count > kMaxCount) {
    throw std::invalid_argument("count must be in [1, " + std::to_string(kMaxCount) + "], not " +
                                std::to_string(count));
  }
  if (shapes.empty()) throw std::invalid_argument("shapes must not be empty");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string what = "shapes[" + std::to_string(i) + "]";
    validate(shapes[i].shape, what + ".shape");
    require_pose(shapes[i].X_BG, what + ".X_BG");
  }
  std::mt19937_64 rng(seed);
  Candidates candidates = Surface(shapes).draw(kCandidates * count, rng);
  const bool is_large = count > kLarge;
  candidates.points =
      is_large ? in_cell_order(candidates.points) : in_hilbert_order(candidates.points);
  const std::vector<int> kept = is_large
                                    ? throw_darts(candidates.points, count, candidates.area)
                                    : eliminate_samples(candidates.points, count, candidates.area);
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    points.col(i) = candidates.points.col(kept[i]);
  }
  return points;
}

}  // namespace graspless::geometry
