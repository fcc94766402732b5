// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/loops/open_regions.hpp"
#include "geometry/loops/report.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

/// Least share of a region's pixels that are linked with a loop that it passes, and largest share
/// with a loop that it does not.
constexpr double kAll = 0.9, kNone = 0.1;
constexpr double kNear = 1e-3;        // least depth of a loop in front of a camera [m]
constexpr double kLongStep = 3;       // of a loop, relative to the spacing
constexpr double kMostUnseen = 0.05;  // of the length of a hole's loop

/// Numbers of the columns of a row where a closed polygon has an edge, ascending.
void crossings_of(const Eigen::Matrix2Xd& polygon, double row, std::vector<double>& columns) {
  columns.clear();
  Eigen::Index last = polygon.cols() - 1;
  for (Eigen::Index i = 0; i < polygon.cols(); last = i++) {
    const double below = polygon(1, last), above = polygon(1, i);
    if ((below > row) == (above > row)) continue;
    const double t = (row - below) / (above - below);
    columns.push_back(polygon(0, last) + t * (polygon(0, i) - polygon(0, last)));
  }
  std::sort(columns.begin(), columns.end());
}

/// Sight of the cameras at a point.
enum class Seen { object, nothing, open };

Seen seen_from(const RayImage& rays, const Eigen::Vector3d& p_C, double tolerance) {
  if (p_C.z() < kNear) return Seen::nothing;
  const Eigen::Vector3d pixel = rays.K * p_C / p_C.z();
  const auto u = static_cast<Eigen::Index>(std::lround(std::clamp(pixel.x(), -2.0, 1e6)));
  const auto v = static_cast<Eigen::Index>(std::lround(std::clamp(pixel.y(), -2.0, 1e6)));
  if (u < 0 || v < 0 || u >= rays.ends.cols() || v >= rays.ends.rows()) return Seen::nothing;
  for (Eigen::Index y = std::max<Eigen::Index>(v - 1, 0);
       y <= std::min(v + 1, rays.ends.rows() - 1); ++y) {
    for (Eigen::Index x = std::max<Eigen::Index>(u - 1, 0);
         x <= std::min(u + 1, rays.ends.cols() - 1); ++x) {
      const auto end = static_cast<double>(rays.ends(y, x));
      if (end < 0 && std::abs(-end - p_C.z()) <= tolerance) return Seen::object;
    }
  }
  const double end = std::abs(static_cast<double>(rays.ends(v, u)));
  return end > p_C.z() + tolerance ? Seen::open : Seen::nothing;
}

}  // namespace

Evidence::Evidence(const std::vector<RayImage>& rays, const Eigen::Matrix3Xd& points) {
  const Planes hull = hull_of(points);
  for (const RayImage& image : rays) {
    views_.push_back({&image, image.X_OC.inverse(), open_regions(image, hull, size_)});
  }
}

Passage Evidence::of(const Eigen::Matrix3Xd& loop, double spacing) const {
  Passage passage;
  passage.is_passed.resize(size_.size());
  passage.is_touched.resize(size_.size());
  for (const View& view : views_) count_linked(view, loop, passage);
  examine_steps(loop, spacing, passage);
  return passage;
}

/// Counts the pixels of every region of a view around which the loop's projection winds.
void Evidence::count_linked(const View& view, const Eigen::Matrix3Xd& loop,
                            Passage& passage) const {
  const Eigen::Matrix3Xd p_C = view.X_CO * loop;
  if (p_C.row(2).minCoeff() < kNear) return;
  const Eigen::Matrix2Xd polygon = (view.rays->K * p_C).colwise().hnormalized();
  const double last = static_cast<double>(view.region.rows() - 1);
  const auto from =
      static_cast<Eigen::Index>(std::ceil(std::clamp(polygon.row(1).minCoeff(), 0.0, last + 1)));
  const auto to =
      static_cast<Eigen::Index>(std::floor(std::clamp(polygon.row(1).maxCoeff(), -1.0, last)));
  std::vector<int> linked(size_.size());
  std::vector<double> columns;
  const double width = static_cast<double>(view.region.cols());
  for (Eigen::Index v = from; v <= to; ++v) {
    poll();
    crossings_of(polygon, static_cast<double>(v), columns);
    for (std::size_t k = 0; k + 1 < columns.size(); k += 2) {
      const auto begin = static_cast<Eigen::Index>(std::ceil(std::clamp(columns[k], 0.0, width)));
      const auto end = static_cast<Eigen::Index>(std::ceil(std::clamp(columns[k + 1], 0.0, width)));
      for (Eigen::Index u = begin; u < end; ++u) {
        const int region = view.region(v, u);
        if (region >= 0) ++linked[region];
      }
    }
  }
  double area = 0;
  const double depth = p_C.row(2).mean();
  const double pixel = depth * depth / std::abs(view.rays->K.topLeftCorner<2, 2>().determinant());
  for (std::size_t i = 0; i < linked.size(); ++i) {
    if (linked[i] == 0) continue;
    const double share = static_cast<double>(linked[i]) / size_[i];
    passage.is_touched[i] |= static_cast<char>(share > kNone);
    if (share < kAll) continue;
    passage.is_passed[i] = 1;
    area += linked[i] * pixel;
  }
  passage.seen_through = std::max(passage.seen_through, area);
}

/// Looks at the middles of steps that are longer than the points are apart.
void Evidence::examine_steps(const Eigen::Matrix3Xd& loop, double spacing, Passage& passage) const {
  double length = 0, unseen = 0;
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Eigen::Vector3d a = loop.col(i), b = loop.col((i + 1) % loop.cols());
    const double step = (b - a).norm();
    length += step;
    if (step <= kLongStep * spacing) continue;
    const double tolerance = std::max(2 * spacing, step / 4);
    bool is_on = true, is_open = false;
    for (const double t : {0.3, 0.5, 0.7}) {
      const Eigen::Vector3d p = a + t * (b - a);
      Seen best = Seen::nothing;
      for (const View& view : views_) {
        const Seen seen = seen_from(*view.rays, view.X_CO * p, tolerance);
        if (seen == Seen::object) best = seen;
        if (best != Seen::object && seen == Seen::open) best = seen;
      }
      is_on &= best == Seen::object;
      is_open |= best == Seen::open;
    }
    if (is_on) continue;
    if (is_open) passage.gap = std::max(passage.gap, step);
    unseen += is_open ? 0 : step;
  }
  passage.unseen = length > 0 ? unseen / length : 0;
}

namespace {

/// Why rays do not make a hole of a loop; empty if they do. `known`: regions of shorter holes.
std::string doubt(const Passage& passage, const std::vector<char>& known) {
  bool is_passed = false, is_new = false;
  for (std::size_t i = 0; i < known.size(); ++i) {
    is_passed |= passage.is_passed[i] != 0;
    is_new |= passage.is_passed[i] != 0 && known[i] == 0;
  }
  if (!is_passed)
    return "no ray passed through it: it may be the rim of a vessel, or the edge of what was seen";
  if (passage.gap > 0) {
    return "it crosses " + figure(passage.gap, 3) + " m that rays passed: the object is open there";
  }
  if (passage.unseen > kMostUnseen) {
    return "no ray reached " + figure(100 * passage.unseen, 3) +
           " % of its length: the object may be open there";
  }
  if (!is_new) return "all rays through it pass through shorter loops as well";
  return "";
}

}  // namespace

void weigh(const Evidence& evidence, double spacing, Loops& result) {
  std::vector<Loop> loops;
  for (auto* list : {&result.found, &result.uncertain, &result.meridians}) {
    std::move(list->begin(), list->end(), std::back_inserter(loops));
    list->clear();
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
  std::vector<char> known;
  for (Loop& loop : loops) {
    const Passage passage = evidence.of(loop.points, spacing);
    known.resize(passage.is_passed.size());
    loop.seen_through = passage.seen_through;
    loop.unseen = passage.unseen;
    loop.reason = doubt(passage, known);
    if (!loop.reason.empty()) {
      result.uncertain.push_back(std::move(loop));
      continue;
    }
    for (std::size_t i = 0; i < known.size(); ++i) known[i] |= passage.is_touched[i];
    result.found.push_back(std::move(loop));
  }
  result.has_rays = true;
}

}  // namespace graspless::geometry
