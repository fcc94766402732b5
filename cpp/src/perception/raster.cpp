// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/raster.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

namespace graspless::perception {
namespace {

/// Sets the fourth cell where two cells touch at a corner only; true if there was one.
bool join_corners(Raster& mask) {
  bool is_changed = false;
  for (int y = 0; y + 1 < mask.ny; ++y) {
    std::uint8_t* row = &mask.values[mask.index(0, y)];
    const std::uint8_t* next = row + mask.nx;
    for (int x = 0; x + 1 < mask.nx; ++x) {
      const bool a = row[x], b = row[x + 1], c = next[x], d = next[x + 1];
      if (a == d && b == c && a != b) {
        row[a ? x + 1 : x] = 1;
        is_changed = true;
      }
    }
  }
  return is_changed;
}

/// Number of steps to the nearest cell of a mask, for all cells: along sides, or diagonally, too.
std::vector<int> steps_from(const Raster& mask, bool is_diagonal) {
  constexpr int kFar = 1 << 20;
  std::vector<int> steps(mask.values.size());
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = mask.values[i] ? 0 : kFar;
  const int nx = mask.nx, ny = mask.ny;
  const auto pass = [&](int sign) {  // rows up or down, and cells in both directions of a row
    for (int k = 0; k < ny; ++k) {
      const int y = sign > 0 ? k : ny - 1 - k;
      int* row = &steps[mask.index(0, y)];
      const int* before = k > 0 ? row - sign * nx : nullptr;
      const auto take = [&](int first, int end, int shift) {  // from the row before
        for (int x = first; x < end; ++x) row[x] = std::min(row[x], before[x + shift] + 1);
      };
      if (before) take(0, nx, 0);
      if (before && is_diagonal) take(1, nx, -1);
      if (before && is_diagonal) take(0, nx - 1, 1);
      for (int x = 1; x < nx; ++x) row[x] = std::min(row[x], row[x - 1] + 1);
      for (int x = nx - 2; x >= 0; --x) row[x] = std::min(row[x], row[x + 1] + 1);
    }
  };
  pass(1);
  pass(-1);
  return steps;
}

}  // namespace

Raster cover(const Eigen::AlignedBox2d& box, double cell, int most) {
  const double longest = box.sizes().maxCoeff();
  const double side = std::max(cell, longest / (most - 2));
  const auto count = [&](double size) { return static_cast<int>(std::ceil(size / side)) + 2; };
  return {box.min() - Eigen::Vector2d::Constant(side), side, count(box.sizes().x()),
          count(box.sizes().y())};
}

Pieces pieces_of(const Raster& mask, bool is_diagonal) {
  Pieces pieces{std::vector<int>(mask.values.size(), -1), {}};
  std::vector<int> parent;  // of provisional labels
  const auto root = [&](int label) {
    while (parent[label] != label) {
      int& above = parent[label];
      above = parent[above];  // halves the way of the next
      label = above;
    }
    return label;
  };
  const auto join = [&](int& label, int other) {
    if (other < 0 || other == label) return;
    if (label < 0) {
      label = other;
      return;
    }
    const int a = root(label), b = root(other);
    label = std::min(a, b);
    parent[std::max(a, b)] = label;
  };
  for (int y = 0; y < mask.ny; ++y) {
    poll();
    const std::uint8_t* value = &mask.values[mask.index(0, y)];
    int* row = &pieces.label[mask.index(0, y)];
    const int* before = y > 0 ? row - mask.nx : nullptr;
    for (int x = 0; x < mask.nx; ++x) {
      if (!value[x]) continue;
      int label = x > 0 ? row[x - 1] : -1;
      if (before) join(label, before[x]);
      if (is_diagonal && before && x > 0) join(label, before[x - 1]);
      if (is_diagonal && before && x + 1 < mask.nx) join(label, before[x + 1]);
      if (label < 0) {
        label = static_cast<int>(parent.size());
        parent.push_back(label);
      }
      row[x] = label;
    }
  }
  std::vector<int> final_label(parent.size(), -1);
  for (std::size_t k = 0; k < parent.size(); ++k) {
    const auto top = static_cast<std::size_t>(root(static_cast<int>(k)));
    if (final_label[top] < 0) {
      final_label[top] = static_cast<int>(pieces.size.size());
      pieces.size.push_back(0);
    }
    final_label[k] = final_label[top];
  }
  for (std::size_t i = 0; i < pieces.label.size();) {
    const int provisional = pieces.label[i];
    const std::size_t first = i;  // of a run of cells with this label
    const int label = provisional < 0 ? -1 : final_label[provisional];
    for (; i < pieces.label.size() && pieces.label[i] == provisional; ++i) pieces.label[i] = label;
    if (label >= 0) pieces.size[label] += i - first;
  }
  return pieces;
}

void fill_holes(Raster& mask) {
  Raster rest = mask;
  for (std::uint8_t& value : rest.values) value = !value;
  const Pieces pieces = pieces_of(rest, false);
  std::vector<bool> is_open(pieces.size.size(), false);
  const auto open = [&](int x, int y) {
    const int label = pieces.label[mask.index(x, y)];
    if (label >= 0) is_open[label] = true;
  };
  for (int x = 0; x < mask.nx; ++x) {
    open(x, 0);
    open(x, mask.ny - 1);
  }
  for (int y = 0; y < mask.ny; ++y) {
    open(0, y);
    open(mask.nx - 1, y);
  }
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    const int label = pieces.label[i];
    if (label >= 0 && !is_open[label]) mask.values[i] = 1;
  }
}

void close_gaps(Raster& mask) {
  const auto spread = [&](std::uint8_t what) {
    const Raster given = mask;
    const auto is = [&](int x, int y) {
      return given.has(x, y) && (given.values[given.index(x, y)] != 0) == (what != 0);
    };
    for (int y = 0; y < mask.ny; ++y) {
      for (int x = 0; x < mask.nx; ++x) {
        if (is(x - 1, y) || is(x + 1, y) || is(x, y - 1) || is(x, y + 1)) {
          mask.values[mask.index(x, y)] = what;
        }
      }
    }
  };
  spread(1);
  spread(0);
}

void grow(Raster& mask, int steps) {
  const std::vector<int> outside = steps_from(mask, true);
  for (std::size_t i = 0; i < outside.size(); ++i) mask.values[i] = outside[i] <= steps;
}

void vote(Raster& mask) {
  constexpr int kHalf = 2, kMajority = 13;
  std::vector<int> sums(mask.values.size(), 0);  // of five cells in a row
  const Raster given = mask;
  for (int y = 0; y < mask.ny; ++y) {
    for (int x = kHalf; x + kHalf < mask.nx; ++x) {
      const std::uint8_t* first = &given.values[mask.index(x - kHalf, y)];
      sums[mask.index(x, y)] = first[0] + first[1] + first[2] + first[3] + first[4];
    }
  }
  for (int y = kHalf; y + kHalf < mask.ny; ++y) {
    poll();
    for (int x = 0; x < mask.nx; ++x) {
      int sum = 0;
      for (int k = -kHalf; k <= kHalf; ++k) sum += sums[mask.index(x, y + k)];
      mask.values[mask.index(x, y)] = sum >= kMajority;
    }
  }
}

void clear_strips(Raster& mask, int half) {
  constexpr int kMore = 2;  // cells, so that nothing is lost at corners
  Raster rest = mask;
  for (std::uint8_t& value : rest.values) value = !value;
  const std::vector<int> inside = steps_from(rest, false);
  Raster core = mask;
  for (std::size_t i = 0; i < core.values.size(); ++i) core.values[i] = inside[i] > half;
  const std::vector<int> outside = steps_from(core, true);
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    mask.values[i] = mask.values[i] && outside[i] <= half + kMore;
  }
}

void keep_largest(Raster& mask) {
  const auto select = [&] {
    const Pieces pieces = pieces_of(mask, false);
    const auto largest = std::max_element(pieces.size.begin(), pieces.size.end());
    const int label = static_cast<int>(largest - pieces.size.begin());
    std::transform(pieces.label.begin(), pieces.label.end(), mask.values.begin(),
                   [label](int other) -> std::uint8_t { return other == label; });
  };
  if (std::none_of(mask.values.begin(), mask.values.end(), [](auto v) { return v; })) return;
  select();
  do fill_holes(mask);
  while (join_corners(mask));
}

std::vector<Step> boundary_of(const Raster& mask) {
  std::vector<Step> steps;
  const auto first = std::find(mask.values.begin(), mask.values.end(), 1);
  if (first == mask.values.end()) return steps;
  const auto start = static_cast<std::size_t>(first - mask.values.begin());
  const int x0 = static_cast<int>(start % static_cast<std::size_t>(mask.nx));
  const int y0 = static_cast<int>(start / static_cast<std::size_t>(mask.nx));
  int x = x0, y = y0, dx = 1, dy = 0;  // along the lower side of the lowest row
  // The cell beside the step from the corner (x, y); side 1: on its left, -1: on its right.
  const auto column = [&](int side) { return x + (dx - side * dy - 1) / 2; };
  const auto row = [&](int side) { return y + (dy + side * dx - 1) / 2; };
  do {
    poll();
    steps.push_back({x, y, column(1), row(1), dy, -dx});
    x += dx;
    y += dy;
    const auto cell_ahead = [&](int side) { return mask.at(column(side), row(side)) != 0; };
    if (cell_ahead(-1)) {
      const int turned = dx;  // right
      dx = dy;
      dy = -turned;
    } else if (!cell_ahead(1)) {
      const int turned = dx;  // left
      dx = -dy;
      dy = turned;
    }
  } while (x != x0 || y != y0 || dx != 1);
  return steps;
}

}  // namespace graspless::perception
