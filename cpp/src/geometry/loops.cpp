// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// shortest_loops: which cloud, which d, and what is said of the loops of K_d.
#include "graspless/geometry/loops.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "geometry/loop_words.hpp"
#include "geometry/plateaus.hpp"
#include "geometry/require_points.hpp"
#include "geometry/shortest_basis.hpp"
#include "geometry/thinning.hpp"

namespace graspless::geometry {
namespace {

constexpr Eigen::Index kMaxPoints = 10000000;
constexpr Eigen::Index kMaxPolished = 1000000;  // the whole cloud's triangulation: about 2 KB each
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

/// `columns` are those of the points given in the cloud that was thinned to them.
Loop described(const Eigen::Matrix3Xd& points, const Cycle& cycle,
               const std::vector<int>& columns) {
  Loop loop;
  loop.points = points(Eigen::all, cycle);
  loop.length = cycle_length(points, cycle);
  for (const int vertex : cycle) loop.vertices.push_back(columns[static_cast<std::size_t>(vertex)]);
  return loop;
}

/// Of a chosen d: a loop that comes and goes at once beside those of the plateau.
bool is_noise(const PersistencePair& span, const Plateau& plateau, std::size_t found) {
  return plateau.loops > 0 && static_cast<int>(found) > plateau.loops &&
         span.death < kLasting * span.birth;
}

void find_loops(const Filtration& filtration, const std::vector<int>& columns, bool drop_meridians,
                Loops& result) {
  const Complex& complex = result.complex;
  const std::vector<Cycle> basis = shortest_basis(complex);
  const std::vector<bool> is_meridian =
      drop_meridians ? find_meridians(complex, basis) : std::vector<bool>(basis.size());
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const PersistencePair span = filtration.span(basis[i], complex.max_edge_length);
    if (is_noise(span, result.plateau, basis.size())) continue;
    Loop loop = described(complex.points, basis[i], columns);
    loop.birth = span.birth;
    loop.death = span.death;
    loop.thickness = thickness(complex, basis[i]);
    (is_meridian[i] ? result.meridians : result.loops).push_back(std::move(loop));
  }
}

/// The same loops on the cloud before it was thinned, where they are shorter.
void polish(const Eigen::Matrix3Xd& points, Loops& result) {
  std::vector<Eigen::Matrix3Xd> curves;
  for (const Loop& loop : result.loops) curves.push_back(loop.points);
  const Complex whole = Filtration(points, "points").complex(result.complex.max_edge_length);
  const std::vector<Cycle> cycles = polished(whole, curves);
  const std::vector<int> columns = all_columns(points);
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (cycles[i].empty()) continue;
    Loop loop = described(points, cycles[i], columns);
    if (loop.length >= result.loops[i].length) continue;
    loop.birth = result.loops[i].birth;
    loop.death = result.loops[i].death;
    loop.thickness = result.loops[i].thickness;
    result.loops[i] = std::move(loop);
  }
  std::stable_sort(result.loops.begin(), result.loops.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
}

}  // namespace

Loops shortest_loops(const Eigen::Matrix3Xd& points, const LoopOptions& options) {
  validate(options);
  check_count(points, options);
  require_points(points, "points");
  const bool thins = points.cols() > options.max_points;
  const std::vector<int> columns =
      thins ? thinned_to(points, options.max_points / 2) : all_columns(points);
  const Filtration filtration = filtration_of(points(Eigen::all, columns));

  Loops result;
  result.warnings = cloud_warnings(filtration);
  result.betti = filtration.betti();
  double d = options.max_edge_length;
  if (d == 0) {
    const std::optional<Plateau> plateau = choose_plateau(filtration, options);
    if (!plateau) {
      result.reason = why_no_plateau(filtration, options);
      return result;
    }
    result.plateau = *plateau;
    d = edge_length_on(*plateau, result.betti);
  }
  result.complex = filtration.complex(d);
  find_loops(filtration, columns, options.drop_meridians, result);
  if (thins && options.polish) polish(points, result);
  conclude(filtration, result);
  return result;
}

}  // namespace graspless::geometry
