// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shortest_loops: from a cloud to K_d, and from K_d to its loops (Stork 2013, Section IV-A).
#include "graspless/geometry/loops.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "graspless/geometry/shape.hpp"

#include "geometry/complex/plateaus.hpp"
#include "geometry/loops/report.hpp"
#include "geometry/loops/resolution.hpp"
#include "geometry/loops/shortest_basis.hpp"
#include "geometry/require_points.hpp"
#include "geometry/sampling/downsample.hpp"

namespace graspless::geometry {
namespace {

constexpr Eigen::Index kMaxPoints = 10000000;
constexpr Eigen::Index kMaxPolished = 1000000;  // its triangulation takes about 2 KB a point
constexpr int kMinVertices = 20;

void check_count(const Eigen::Matrix3Xd& points, const LoopOptions& options) {
  const bool polishes = options.polish && points.cols() > options.max_points;
  const Eigen::Index most = polishes ? kMaxPolished : kMaxPoints;
  if (points.cols() <= most) return;
  throw std::invalid_argument("points must be at most " + std::to_string(most) +
                              (polishes ? " for polish" : "") + ", not " +
                              std::to_string(points.cols()));
}

std::vector<int> all_columns(const Eigen::Matrix3Xd& points) {
  std::vector<int> all(static_cast<std::size_t>(points.cols()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Filtration filtration_of(const Eigen::Matrix3Xd& points) {
  const Filtration filtration(points, "points");
  if (filtration.num_vertices() >= kMinVertices) return filtration;
  throw std::invalid_argument("points must hold at least " + std::to_string(kMinVertices) +
                              " distinct points, not " + std::to_string(filtration.num_vertices()));
}

/// Number of lasting loops that live on both plateaus and between them.
int shared_loops(const std::vector<PersistencePair>& pairs, const Plateau& lower,
                 const Plateau& upper) {
  return static_cast<int>(
      std::count_if(pairs.begin(), pairs.end(), [&](const PersistencePair& pair) {
        return pair.death >= kLastingRatio * pair.birth && pair.birth <= lower.lower &&
               pair.death >= upper.upper;
      }));
}

/// The lowest plateau with exactly the loops of `chosen`: K_d is finer there, loops are shorter.
Plateau lowest_with_same_loops(const Filtration& filtration, const std::vector<Plateau>& all,
                               const Plateau& chosen, double min_ratio) {
  Plateau result = chosen;
  for (const Plateau& plateau : all) {
    if (plateau.lower < result.lower && plateau.loops == chosen.loops &&
        plateau.ratio() >= min_ratio &&
        shared_loops(filtration.persistence(), plateau, chosen) == chosen.loops) {
      result = plateau;
    }
  }
  return result;
}

/// The plateau that the options select, if one is wide enough.
std::optional<Plateau> choose_plateau(const Filtration& filtration, const LoopOptions& options) {
  const std::vector<Plateau> all = filtration.plateaus();  // widest first
  if (options.lowest_plateau) {
    std::optional<Plateau> lowest;
    for (const Plateau& plateau : all) {
      if (plateau.ratio() < std::max(options.lowest_ratio, options.min_ratio)) break;
      if (!lowest || plateau.lower < lowest->lower) lowest = plateau;
    }
    return lowest;
  }
  if (all.empty() || all[0].ratio() < options.min_ratio) return std::nullopt;
  return lowest_with_same_loops(filtration, all, all[0], options.min_ratio);
}

/// `columns[i]` is the index of point i in the cloud that the caller gave.
Loop make_loop(const Eigen::Matrix3Xd& points, const Cycle& cycle,
               const std::vector<int>& columns) {
  Loop loop;
  loop.points = points(Eigen::all, cycle);
  loop.length = cycle_length(points, cycle);
  for (const int vertex : cycle) loop.vertices.push_back(columns[static_cast<std::size_t>(vertex)]);
  return loop;
}

/// True for a short-lived loop where the basis holds more loops than the chosen plateau.
bool is_noise(const PersistencePair& span, const Plateau& plateau, std::size_t found) {
  return plateau.loops > 0 && static_cast<int>(found) > plateau.loops &&
         span.death < kLastingRatio * span.birth;
}

bool is_shorter(const Loop& a, const Loop& b) { return a.length < b.length; }

/// Sets the surface, and the loops along it.
void find_loops(const Filtration& filtration, const std::vector<int>& columns, bool drop_meridians,
                Loops& result) {
  const Complex& complex = result.complex;
  const Resolution resolution(complex);
  result.surface = surface_of(complex, resolution);
  const std::vector<Cycle> basis = shortest_basis(complex);
  const std::vector<bool> is_meridian =
      drop_meridians ? find_meridians(complex, basis) : std::vector<bool>(basis.size());
  const std::vector<Cycle> cycles = around_gaps(complex, resolution, basis);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const PersistencePair span = filtration.span(basis[i], complex.max_edge_length);
    if (is_noise(span, result.plateau, basis.size())) continue;
    Loop loop = make_loop(complex.points, cycles[i], columns);
    loop.birth = span.birth;
    loop.death = span.death;
    const Thickness found = thickness(result.surface, cycles[i]);
    loop.thickness = found.widest;
    loop.width = found.narrowest;
    loop.gap = resolution.widest_gap(cycles[i]);
    (is_meridian[i] ? result.meridians : result.loops).push_back(std::move(loop));
  }
  std::stable_sort(result.loops.begin(), result.loops.end(), is_shorter);
  std::stable_sort(result.meridians.begin(), result.meridians.end(), is_shorter);
}

/// Replaces loops by shorter ones of the same class on the full cloud.
void polish(const Eigen::Matrix3Xd& points, Loops& result) {
  std::vector<Eigen::Matrix3Xd> curves;
  for (const Loop& loop : result.loops) curves.push_back(loop.points);
  const Complex whole = Filtration(points, "points").complex(result.complex.max_edge_length);
  const Resolution resolution(whole);
  const std::vector<Cycle> cycles = around_gaps(whole, resolution, polished(whole, curves));
  const std::vector<int> columns = all_columns(points);
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (cycles[i].empty()) continue;
    Loop loop = make_loop(points, cycles[i], columns);
    if (loop.length >= result.loops[i].length) continue;
    loop.birth = result.loops[i].birth;
    loop.death = result.loops[i].death;
    loop.thickness = result.loops[i].thickness;
    loop.width = result.loops[i].width;
    loop.gap = resolution.widest_gap(cycles[i]);
    result.loops[i] = std::move(loop);
  }
  std::stable_sort(result.loops.begin(), result.loops.end(), is_shorter);
}

}  // namespace

void validate(const LoopOptions& options) {
  const auto require = [](bool holds, const std::string& name, double value,
                          const std::string& must) {
    if (holds) return;
    throw std::invalid_argument(name + " must be " + must + ", not " + short_number(value));
  };
  require(options.max_edge_length >= 0 && options.max_edge_length <= kMaxLength, "max_edge_length",
          options.max_edge_length,
          "in [0, " + short_number(kMaxLength) + "] m (0: chosen from the Betti curve)");
  require(options.lowest_ratio > 1 && std::isfinite(options.lowest_ratio), "lowest_ratio",
          options.lowest_ratio, "greater than 1 and finite");
  require(options.min_ratio > 1 && std::isfinite(options.min_ratio), "min_ratio", options.min_ratio,
          "greater than 1 and finite");
  require(options.max_points >= 100 && options.max_points <= 1000000, "max_points",
          options.max_points, "in [100, 1000000]");
}

Loops shortest_loops(const Eigen::Matrix3Xd& points, const LoopOptions& options) {
  validate(options);
  check_count(points, options);
  require_points(points, "points");
  const bool downsamples = points.cols() > options.max_points;
  const std::vector<int> columns =
      downsamples ? downsample_to(points, options.max_points / 2) : all_columns(points);
  const Filtration filtration = filtration_of(points(Eigen::all, columns));  // IV-A: D

  Loops result;
  result.warnings = cloud_warnings(filtration);
  result.betti = filtration.betti();
  double d = options.max_edge_length;
  if (d == 0) {  // left open by the paper: the widest plateau of the Betti curve
    const std::optional<Plateau> plateau = choose_plateau(filtration, options);
    if (!plateau) {
      result.reason = no_plateau_reason(filtration, options);
      return result;
    }
    result.plateau = *plateau;
    d = edge_length_on(*plateau, result.betti);
  }
  result.complex = filtration.complex(d);                           // IV-A: K_d
  find_loops(filtration, columns, options.drop_meridians, result);  // III-B, IV-A: S
  if (downsamples && options.polish) polish(points, result);
  report(filtration, result);
  return result;
}

}  // namespace graspless::geometry
