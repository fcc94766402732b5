// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Square cells of a plane.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace graspless::perception {

/// One byte for each cell of a rectangle.
struct Raster {
  Eigen::Vector2d origin;  ///< lower left corner [m]
  double cell;             ///< side of a cell [m]
  int nx, ny;
  std::vector<std::uint8_t> values;

  Raster(const Eigen::Vector2d& origin, double cell, int nx, int ny)
      : origin(origin),
        cell(cell),
        nx(nx),
        ny(ny),
        values(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), 0) {}

  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < nx && y < ny; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x);
  }
  /// Value of a cell; 0 outside.
  std::uint8_t at(int x, int y) const { return has(x, y) ? values[index(x, y)] : 0; }
  int column(double x) const { return static_cast<int>(std::floor((x - origin.x()) / cell)); }
  int row(double y) const { return static_cast<int>(std::floor((y - origin.y()) / cell)); }
  Eigen::Vector2d center(int x, int y) const {
    return origin + cell * Eigen::Vector2d(x + 0.5, y + 0.5);
  }
};

/// The raster that covers a box with cells of at least `cell` [m], and at most `most` along a side.
Raster cover(const Eigen::AlignedBox2d& box, double cell, int most);

/// Connected pieces of the cells that are not 0.
struct Pieces {
  std::vector<int> label;         ///< of each cell; -1: the cell is 0
  std::vector<std::size_t> size;  ///< of each piece [cells]
};
Pieces pieces_of(const Raster& mask, bool is_diagonal);

/// Sets the cells that those of the mask enclose.
void fill_holes(Raster& mask);
/// Sets cells between cells of the mask: grows it by one cell and shrinks it again.
void close_gaps(Raster& mask);
/// Sets the cells that are at most `steps` cells from those of the mask, along rows and columns.
void grow(Raster& mask, int steps);
/// Sets every cell to what most of the 5 x 5 cells around it are.
void vote(Raster& mask);
/// Clears strips of the mask that are at most about 2 `half` cells wide, but for stubs as long.
void clear_strips(Raster& mask, int half);
/// Keeps the largest piece alone, connected along sides, and fills cells until no two of its cells
/// touch at a corner only.
void keep_largest(Raster& mask);

/// A step along the boundary of a mask, with the mask on its left.
struct Step {
  int x, y;          ///< its first corner
  int in_x, in_y;    ///< the cell on its left
  int out_x, out_y;  ///< direction away from that cell
};
/// Boundary of a mask without holes in one piece, counter-clockwise. See keep_largest().
std::vector<Step> boundary_of(const Raster& mask);

}  // namespace graspless::perception
