// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// What a class of H_1 is: a hole, the inside of a handle, a gap between points, or unclear.
#include "geometry/loops/classes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "geometry/loops/openness.hpp"
#include "geometry/loops/report.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

/// Ratio death / birth of gaps between evenly spread points.
constexpr double kLeastGapRatio = 1.4, kMostGapRatio = 2.4;
/// Number of gaps near a class that say how dense the points are there, and the fewest that do.
constexpr std::size_t kNearGaps = 25, kFewestGaps = 5;
/// Least ratio death / birth, and strength relative to LoopOptions::min_ratio, of a listed class.
constexpr double kListedRatio = 1.6, kListedStrength = 0.9;
/// Least ratio death / birth of a hole.
constexpr double kLeastRatio = 2;
/// Largest ratio of the edge that closes a loop to the other steps around it. Across a larger gap,
/// an object is open, or was not seen.
constexpr double kMaxJump = 1.5;
/// Least share of rays that leave on the narrower side of a hole, and largest on the wider side of
/// the inside of a handle.
constexpr double kOpen = 0.1, kClosed = 0.05;
/// K_d of the rays: this many times the birth, and not above the death.
constexpr double kSurface = 2;

/// Openness at the triangles that fill classes. Keeps the last complex, as many classes have nearly
/// the same scale.
class Middles {
 public:
  explicit Middles(const Filtration& filtration) : filtration_(filtration) {}

  Openness openness(const PersistencePair& pair) {
    const double most = pair.death, least = std::min(kSurface * pair.birth, most);
    if (!complex_ || complex_->max_edge_length > most || complex_->max_edge_length < least ||
        complex_->max_edge_length > 1.3 * least) {
      complex_ = filtration_.complex(std::min(1.15 * least, most));
    }
    const Eigen::Matrix3d corners = filtration_.points()(Eigen::all, pair.filling);
    const Eigen::Vector3d ab = corners.col(1) - corners.col(0);
    const Eigen::Vector3d ac = corners.col(2) - corners.col(0);
    return geometry::openness(*complex_, corners.rowwise().mean(), ab.cross(ac));
  }

 private:
  const Filtration& filtration_;
  std::optional<Complex> complex_;
};

Eigen::Vector3d middle_of(const Filtration& filtration, const PersistencePair& pair) {
  return filtration.points()(Eigen::all, pair.filling).rowwise().mean();
}

/// Compares a class with the gaps between the points near it.
class Gaps {
 public:
  explicit Gaps(const Filtration& filtration) : filtration_(filtration) {
    for (const PersistencePair& pair : filtration.persistence()) {
      const double ratio = pair.death / pair.birth;
      if (ratio >= kMostGapRatio) continue;
      if (ratio < kLeastGapRatio) break;  // largest ratio first
      gaps_.push_back({middle_of(filtration, pair), pair.birth});
    }
  }

  /// Ratio of a class's death to the median birth of the gaps near it. Its own ratio death / birth
  /// if there are hardly any gaps.
  double strength(const PersistencePair& pair) {
    const std::size_t count = std::min(kNearGaps, gaps_.size());
    if (count < kFewestGaps) return pair.death / pair.birth;
    const Eigen::Vector3d middle = middle_of(filtration_, pair);
    const auto end = gaps_.begin() + count;
    std::nth_element(gaps_.begin(), end - 1, gaps_.end(), [&](const Gap& a, const Gap& b) {
      return (a.middle - middle).squaredNorm() < (b.middle - middle).squaredNorm();
    });
    const auto median = gaps_.begin() + (count / 2);
    std::nth_element(gaps_.begin(), median, end,
                     [](const Gap& a, const Gap& b) { return a.birth < b.birth; });
    return pair.death / median->birth;
  }

 private:
  struct Gap {
    Eigen::Vector3d middle;
    double birth;
  };
  const Filtration& filtration_;
  std::vector<Gap> gaps_;
};

using Kind = JudgedClass::Kind;

/// Sets the kind, and the reason unless the class is a hole.
void judge(const Openness& open, double strength, const LoopOptions& options, JudgedClass& judged) {
  const double ratio = judged.span.death / judged.span.birth;
  judged.kind = Kind::uncertain;
  if (std::max(open.above, open.below) <= kClosed) {
    judged.kind = options.drop_meridians ? Kind::meridian : Kind::found;
    judged.reason = "it runs around a thick handle instead of along it";
  } else if (judged.jump > kMaxJump) {
    judged.reason = "it closes across a gap of " + figure(judged.span.birth, 3) + " m, " +
                    figure(judged.jump, 3) + " times the other steps around it";
  } else if (judged.openness < kOpen) {
    judged.reason = "the object closes it on one side";
  } else if (strength < options.min_ratio || ratio < kLeastRatio) {
    judged.reason = "it is " + figure(strength, 3) +
                    " times as wide as the gaps between points near it (a hole: " +
                    figure(options.min_ratio, 3) + "), with a ratio death / birth of " +
                    figure(ratio, 3) + " (a hole: " + figure(kLeastRatio, 3) + ")";
  } else {
    judged.kind = Kind::found;
  }
  if (judged.kind == Kind::found) judged.reason.clear();
}

}  // namespace

double JudgedClass::coarsest() const { return std::sqrt(span.birth * span.death); }

std::vector<JudgedClass> judged_classes(const Filtration& filtration, const LoopOptions& options) {
  const double d = options.max_edge_length;
  std::vector<JudgedClass> result;
  Middles middles(filtration);
  Gaps gaps(filtration);
  const std::vector<PersistencePair>& pairs = filtration.persistence();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PersistencePair& pair = pairs[i];
    if (pair.death < kListedRatio * pair.birth) break;  // largest ratio first
    if (d > 0 && !(pair.birth < d && d <= pair.death)) continue;
    poll();
    const double strength = gaps.strength(pair);
    if (strength < kListedStrength * options.min_ratio) continue;
    JudgedClass judged;
    judged.pair = static_cast<int>(i);
    judged.span = pair;
    judged.jump = filtration.jump(pair);
    const Openness open = middles.openness(pair);
    judged.openness = std::min(open.above, open.below);
    judge(open, strength, options, judged);
    const bool is_gap = judged.kind == Kind::uncertain && strength < options.min_ratio;
    if (is_gap && judged.openness < kOpen) continue;
    result.push_back(std::move(judged));
  }
  return result;
}

}  // namespace graspless::geometry
