// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/height_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/watch.hpp"

#include "text.hpp"

namespace graspless::geometry {

namespace {

constexpr double kLeastCell = 1e-4;  // [m]
constexpr Eigen::Index kMostCells = 1000000;
constexpr double kMostLevels = 1e9;

/// Number of steps that a height takes, rounded up.
int level_of(double height, double step) {
  constexpr double kRoundOff = 1e-9;
  return static_cast<int>(std::ceil(height / step - kRoundOff));
}

/// Takes equal rectangles of cells out of a table of levels.
class Rectangles {
 public:
  explicit Rectangles(Eigen::ArrayXXi levels) : levels_(std::move(levels)) {}

  /// Largest number of columns from (i, j) on, and of rows with all of them, that have the level of
  /// (i, j). Clears them.
  std::pair<Eigen::Index, Eigen::Index> take(Eigen::Index i, Eigen::Index j) {
    const int level = levels_(i, j);
    Eigen::Index across = 1, along = 1;
    while (j + across < levels_.cols() && levels_(i, j + across) == level) ++across;
    while (i + along < levels_.rows() && (levels_.block(i + along, j, 1, across) == level).all())
      ++along;
    levels_.block(i, j, along, across).setZero();
    return {along, across};
  }

  int level(Eigen::Index i, Eigen::Index j) const { return levels_(i, j); }

 private:
  Eigen::ArrayXXi levels_;
};

}  // namespace

double HeightMap::of(const Eigen::ArrayXXd& values, const Eigen::Vector2d& p_O) const {
  const double x = std::floor((p_O.x() - corner.x()) / cell),
               y = std::floor((p_O.y() - corner.y()) / cell);
  const bool is_inside = x >= 0 && y >= 0 && x < static_cast<double>(values.rows()) &&
                         y < static_cast<double>(values.cols());
  return is_inside ? values(static_cast<Eigen::Index>(x), static_cast<Eigen::Index>(y)) : 0;
}

std::pair<double, double> HeightMap::range_near(const Eigen::Vector2d& p_O, double radius) const {
  const Eigen::Vector2d middle = (p_O - corner) / cell;  // in cells
  const auto index = [](double at, Eigen::Index count) {
    return static_cast<Eigen::Index>(std::clamp(std::floor(at), 0.0, static_cast<double>(count)));
  };
  const double reach = radius / cell, here = at(p_O);
  std::pair<double, double> range{here, here};
  for (Eigen::Index i = index(middle.x() - reach, heights.rows());
       i < index(middle.x() + reach + 1, heights.rows()); ++i) {
    for (Eigen::Index j = index(middle.y() - reach, heights.cols());
         j < index(middle.y() + reach + 1, heights.cols()); ++j) {
      const Eigen::Vector2d center(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      if (heights(i, j) == 0 || (center - middle).norm() > reach) continue;
      if (range.first == 0 || heights(i, j) < range.first) range.first = heights(i, j);
      range.second = std::max(range.second, heights(i, j));
    }
  }
  return range;
}

void validate(const HeightMap& map, const std::string& field) {
  const auto refuse = [&](const std::string& what) { throw std::invalid_argument(field + what); };
  if (!map.corner.allFinite() || map.corner.lpNorm<Eigen::Infinity>() > kMaxLength)
    refuse(".corner must be two finite coordinates of at most 1e4 m");
  if (!(map.cell >= kLeastCell && map.cell <= kMaxLength))
    refuse(".cell must lie in [1e-4, 1e4] m, not " + figure(map.cell));
  const Eigen::Index count = map.heights.size();
  if (count < 1 || count > kMostCells)
    refuse(".heights must have 1 to 1000000 cells, not " + std::to_string(count));
  const bool is_sound =
      map.heights.isFinite().all() && (map.heights >= 0).all() && (map.heights <= kMaxLength).all();
  if (!is_sound) refuse(".heights must lie in [0, 1e4] m");
  if (!(map.heights.maxCoeff() >= kMinLength)) refuse(".heights must have one of at least 1e-6 m");
  if (map.undersides.size() == 0) return;
  const bool has_size =
      map.undersides.rows() == map.heights.rows() && map.undersides.cols() == map.heights.cols();
  if (!has_size) refuse(".undersides must be as many as .heights");
  if (!((map.undersides >= 0).all() && (map.undersides <= map.heights).all()))
    refuse(".undersides must lie in [0, their heights]");
}

std::vector<PlacedShape> columns(const HeightMap& map, double step) {
  require(step >= kMinLength && std::isfinite(step), "step", step, "must be at least 1e-6 m");
  const double highest = map.heights.maxCoeff();
  require(highest <= kMostLevels * step, "step", step,
          "must be at least a billionth of the greatest height, " + figure(highest) + " m");
  Rectangles rectangles(
      map.heights.unaryExpr([&](double height) { return level_of(height, step); }));
  std::vector<PlacedShape> boxes;
  for (Eigen::Index i = 0; i < map.heights.rows(); ++i) {
    poll();
    for (Eigen::Index j = 0; j < map.heights.cols(); ++j) {
      const int level = rectangles.level(i, j);
      if (level == 0) continue;
      const auto [along, across] = rectangles.take(i, j);
      const double height = std::min(level * step, highest);
      const Eigen::Vector3d size(map.cell * static_cast<double>(along),
                                 map.cell * static_cast<double>(across), height);
      const Eigen::Vector3d low(map.corner.x() + map.cell * static_cast<double>(i),
                                map.corner.y() + map.cell * static_cast<double>(j), 0);
      boxes.push_back({Box{size}, Eigen::Isometry3d(Eigen::Translation3d(low + size / 2))});
    }
  }
  return boxes;
}

}  // namespace graspless::geometry
