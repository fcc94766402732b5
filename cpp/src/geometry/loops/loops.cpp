// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shortest_loops: from a cloud to K_d, and from K_d to its loops (Stork 2013, Section IV-A).
#include "graspless/geometry/loops.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "graspless/geometry/sampling.hpp"
#include "graspless/geometry/shape.hpp"

#include "geometry/cycles/shortest_basis.hpp"
#include "geometry/loops/classes.hpp"
#include "geometry/loops/evidence.hpp"
#include "geometry/loops/one_sided.hpp"
#include "geometry/loops/polish.hpp"
#include "geometry/loops/report.hpp"
#include "geometry/loops/resolution.hpp"
#include "geometry/loops/scales.hpp"
#include "geometry/loops/thickness.hpp"
#include "geometry/require_points.hpp"
#include "geometry/sampling/downsample.hpp"
#include "geometry/sampling/unevenness.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

constexpr Eigen::Index kMaxPoints = 10000000;
constexpr Eigen::Index kMaxPolished = 1000000;  // its triangulation takes about 2 KB a point
constexpr int kMinVertices = 20;

/// Number of classes alive at the given d, or at any.
int num_classes(const Filtration& filtration, double d) {
  const auto& pairs = filtration.persistence();
  return static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return d == 0 || (pair.birth < d && d <= pair.death);
  }));
}

void check_count(const Eigen::Matrix3Xd& points, const LoopOptions& options) {
  const bool polishes = options.polish && points.cols() > options.max_points;
  const Eigen::Index most = polishes ? kMaxPolished : kMaxPoints;
  if (points.cols() <= most) return;
  throw std::invalid_argument("points must be at most " + std::to_string(most) +
                              (polishes ? " for polish" : "") + ", not " +
                              std::to_string(points.cols()));
}

std::vector<int> all_columns(const Eigen::Matrix3Xd& points) {
  std::vector<int> all(points.cols());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void require_enough(Eigen::Index count) {
  if (count >= kMinVertices) return;
  throw std::invalid_argument("points must hold at least " + std::to_string(kMinVertices) +
                              " distinct points, not " + std::to_string(count));
}

Filtration filtration_of(const Eigen::Matrix3Xd& points) {
  require_enough(points.cols());  // before the complex asks for the few that it needs
  Filtration filtration(points, "points");
  require_enough(filtration.num_vertices());
  return filtration;
}

/// `columns[i]` is the index of point i in the cloud that the caller gave.
Loop make_loop(const Eigen::Matrix3Xd& points, const Cycle& cycle,
               const std::vector<int>& columns) {
  Loop loop;
  loop.points = points(Eigen::all, cycle);
  loop.length = cycle_length(points, cycle);
  for (const int vertex : cycle) loop.vertices.push_back(columns[vertex]);
  return loop;
}

/// Finds the loops of the classes that are at their own scale in K_d, or of all that are alive.
/// Removes these classes from `classes`. Returns the surface of K_d.
Complex find_loops(const Filtration& filtration, const Complex& complex,
                   const std::vector<int>& columns, bool takes_all, Judged& classes,
                   Loops& result) {
  const double d = complex.max_edge_length;
  const auto own =
      std::stable_partition(classes.begin(), classes.end(), [&](const JudgedClass& judged) {
        return takes_all ? !is_alive(judged, d) : !accepts(judged, d);
      });
  std::sort(own, classes.end(), [](const JudgedClass& a, const JudgedClass& b) {
    return a.span.death < b.span.death;  // a cycle of several classes stands for the last to die
  });
  std::vector<int> pairs;
  for (auto judged = own; judged != classes.end(); ++judged) pairs.push_back(judged->pair);
  const std::vector<ClassCycle> basis = shortest_basis(complex, filtration.labels(d, pairs));
  std::vector<Cycle> cycles;
  for (const ClassCycle& member : basis) cycles.push_back(member.cycle);
  const Resolution resolution(complex);
  cycles = around_gaps(complex, resolution, std::move(cycles));
  Complex surface = surface_of(complex, resolution);
  const std::vector<Thickness> measured = thickness(surface, cycles);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const JudgedClass& judged = own[basis[i].cls];
    Loop loop = make_loop(complex.points, cycles[i], columns);
    loop.birth = judged.span.birth;
    loop.death = judged.span.death;
    loop.thickness = measured[i].widest;
    loop.width = measured[i].narrowest;
    loop.max_edge_length = d;
    loop.openness = judged.openness;
    loop.gap = resolution.widest_gap(cycles[i]);
    loop.jump = judged.jump;
    loop.reason = judged.reason;
    auto& list = judged.kind == JudgedClass::Kind::found       ? result.found
                 : judged.kind == JudgedClass::Kind::uncertain ? result.uncertain
                                                               : result.meridians;
    list.push_back(std::move(loop));
  }
  classes.erase(own, classes.end());
  return surface;
}

void sort_by_length(std::vector<Loop>& loops) {
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
}

/// Values of d at which all holes of the chosen complex exist.
Plateau plateau_of(const Loops& result) {
  Plateau plateau{0, std::numeric_limits<double>::infinity(), 0};
  for (const Loop& loop : result.found) {
    if (loop.max_edge_length != result.complex.max_edge_length) continue;
    plateau.lower = std::max(plateau.lower, loop.birth);
    plateau.upper = std::min(plateau.upper, loop.death);
    ++plateau.loops;
  }
  return plateau.loops > 0 ? plateau : Plateau{};
}

/// Loops of all classes, each in a complex at its own scale (III-B, IV-A: S). With `seeks_clear`,
/// those of holes are found in one complex if it holds nothing else.
void find_all(const Filtration& filtration, const std::vector<int>& columns, Judged classes,
              bool seeks_clear, const LoopOptions& options, Loops& result) {
  const bool d_is_given = options.max_edge_length > 0;
  const Judged all_holes = holes_of(classes);
  double d = options.max_edge_length;
  if (!d_is_given && seeks_clear && !all_holes.empty())
    d = clear_edge_length(filtration, all_holes);
  if (d > 0) {
    result.complex = filtration.complex(d);
    result.surface = find_loops(filtration, result.complex, columns, true, classes, result);
  }
  while (!d_is_given && !classes.empty()) {
    const Judged holes = holes_of(classes);
    Complex complex = filtration.complex(common_edge_length(filtration, holes, classes));
    Complex surface = find_loops(filtration, complex, columns, false, classes, result);
    if (d == 0 && !holes.empty()) {
      d = complex.max_edge_length;
      result.complex = std::move(complex);
      result.surface = std::move(surface);
    }
  }
  for (auto* list : {&result.found, &result.uncertain, &result.meridians}) sort_by_length(*list);
}

/// Surface of a cloud in which no hole chose a complex.
Complex surface_of_cloud(const Filtration& filtration) {
  constexpr double kFar = 8;  // spacings: beyond the sixth neighbour's, in a random cloud too
  const Complex complex = filtration.complex(kFar * spacing(filtration.points()));
  return surface_of(complex, Resolution(complex));
}

/// Complex of most of the holes that rays passed through.
void choose_complex(const Filtration& filtration, Loops& result) {
  std::map<double, int> counts;
  for (const Loop& loop : result.found) ++counts[loop.max_edge_length];
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == counts.end() || most->first == result.complex.max_edge_length) return;
  result.complex = filtration.complex(most->first);
  result.surface = surface_of(result.complex, Resolution(result.complex));
}

/// Gaps between independent random points look like holes; those between a third of them, spread
/// more evenly, hardly ever do.
constexpr int kThinned = 3;

/// True of independent random points on a surface, if there are enough to thin them.
bool are_random(const Eigen::Matrix3Xd& points) {
  constexpr double kRandom = 0.55;
  constexpr int kFew = 300;
  return points.cols() >= kFew && unevenness(points) > kRandom;
}

}  // namespace

void validate(const LoopOptions& options) {
  require(options.max_edge_length >= 0 && options.max_edge_length <= kMaxLength, "max_edge_length",
          options.max_edge_length,
          "must be in [0, " + figure(kMaxLength) + "] m (0: each hole has its own)");
  require(options.min_ratio > 1 && std::isfinite(options.min_ratio), "min_ratio", options.min_ratio,
          "must be greater than 1 and finite");
  require(options.max_points >= 100 && options.max_points <= 1000000, "max_points",
          options.max_points, "must be in [100, 1000000]");
  require(options.threads >= 1 && options.threads <= 256, "threads", options.threads,
          "must be in [1, 256]");
}

Loops shortest_loops(const Eigen::Matrix3Xd& points, const LoopOptions& options,
                     const std::vector<RayImage>& rays) {
  validate(options);
  for (std::size_t i = 0; i < rays.size(); ++i)
    validate(rays[i], "rays[" + std::to_string(i) + "]");
  check_count(points, options);
  require_points(points, "points");
  const bool downsamples = points.cols() > options.max_points;
  const int most = downsamples ? options.max_points / 2 : static_cast<int>(points.cols());
  const bool is_thinned = most > points.cols() / kThinned && options.max_edge_length == 0 &&
                          rays.empty() && are_random(points);
  const int used = is_thinned ? static_cast<int>(points.cols()) / kThinned : most;
  const std::vector<int> columns =
      used < points.cols() ? downsample_to(points, used) : all_columns(points);
  const Filtration filtration = filtration_of(points(Eigen::all, columns));  // IV-A: D

  Loops result;
  result.warnings = cloud_warnings(filtration);
  if (is_thinned) result.warnings.push_back(thinning_warning(columns.size()));
  result.betti = filtration.betti();
  Judged classes = judged_classes(filtration, options);
  result.noise =
      num_classes(filtration, options.max_edge_length) - static_cast<int>(classes.size());
  find_all(filtration, columns, std::move(classes), rays.empty(), options, result);
  if (!rays.empty()) {
    weigh(Evidence(rays, filtration.points()), spacing(filtration.points()), result);
    choose_complex(filtration, result);
  } else if (!options.all_sides) {
    doubt_if_one_sided(filtration.points(), result);
  }
  if (result.complex.edges.cols() == 0) result.surface = surface_of_cloud(filtration);
  if (options.max_edge_length == 0) result.plateau = plateau_of(result);
  if (downsamples && options.polish) polish(points, options.threads, result.found);
  report(filtration, options, result);
  return result;
}

}  // namespace graspless::geometry
