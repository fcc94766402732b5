// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/wall_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graspless/watch.hpp"

#include "geometry/quantile.hpp"

namespace graspless::pinch {

using Eigen::Vector2d;

namespace {

constexpr double kRounded = 1e-6;    // [m]
constexpr double kSeenPart = 0.003;  // of the height of a cell, at least [m]
constexpr int kLines = 33;           // across the wall
constexpr int kSteps = 8;            // in a cell, along a line

/// One line across a wall, in the plane of the closing direction: where the wall ends to the side
/// of the first and of the second contact, at their height and above them [m].
struct Crossing {
  bool is_wall = false;
  std::array<double, 2> out{}, out_above{}, underside{};
  std::array<bool, 2> is_seen{};
};

class Measurement {
 public:
  Measurement(const geometry::HeightMap& map, const Eigen::Matrix<double, 3, 2>& contacts_O,
              double patch)
      : map_(map),
        patch_(patch),
        middle_((contacts_O.col(0) + contacts_O.col(1)).head<2>() / 2),
        across_((contacts_O.col(1) - contacts_O.col(0)).head<2>()),
        width_(across_.norm()),
        height_(contacts_O(2, 0)) {
    across_ /= width_;
    along_ = Vector2d(across_.y(), -across_.x());
  }

  WallMeasure run() const {
    WallMeasure wall;
    if (!(height_ > kRounded)) return wall;  // all around is as high
    std::vector<double> u;
    std::vector<Crossing> lines;
    for (int i = 0; i < kLines; ++i) {
      u.push_back(patch_ * (2.0 * i / (kLines - 1) - 1));
      lines.push_back(crossing(u.back()));
      if (!lines.back().is_wall) return wall;
    }
    wall.is_wall = true;
    for (const std::size_t side : {0U, 1U}) {
      const double lean = add_side(u, lines, side, wall);
      wall.rise =
          std::max({wall.rise, hidden(side), patch_ * (lean - kUpright) / (kLeaning - kUpright)});
    }
    wall.rise = std::min(wall.rise, patch_);
    return wall;
  }

 private:
  double height_at(double u, double v) const { return map_.at(middle_ + u * along_ + v * across_); }

  /// Looks for the highest place between the contacts, and walks from there to both sides.
  Crossing crossing(double u) const {
    poll();
    const double step = map_.cell / kSteps, above = height_ + patch_ - kRounded;
    double highest = 0, from = 0;
    for (double v = -width_ / 2; v <= width_ / 2; v += step) {
      if (height_at(u, v) > highest) {
        highest = height_at(u, v);
        from = v;
      }
    }
    Crossing line;
    line.is_wall = highest >= above;
    for (const int side : {0, 1}) {
      const double way = side == 0 ? -step : step;
      const auto i = static_cast<std::size_t>(side);
      double v = from;
      line.out_above[i] = std::abs(v);
      for (; height_at(u, v) >= height_; v += way) {
        if (height_at(u, v) >= above) line.out_above[i] = side == 0 ? -v : v;
      }
      line.out[i] = side == 0 ? -v : v;
      line.underside[i] = map_.underside_at(middle_ + u * along_ + (v - way) * across_);
      line.is_seen[i] = height_at(u, v - way) > line.underside[i] + kSeenPart;
    }
    return line;
  }

  /// Adds the end of a face and its slopes along the wall and upwards. Returns the latter: only
  /// what was seen of a face leans.
  double add_side(const std::vector<double>& u, const std::vector<Crossing>& lines,
                  std::size_t side, WallMeasure& wall) const {
    double uu = 0, uv = 0, rise = 0, seen = 0, farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double out = lines[i].out[side];
      uu += u[i] * u[i], uv += u[i] * out;  // u is symmetric
      if (lines[i].is_seen[side]) rise += out - lines[i].out_above[side], seen += 1;
      farthest = std::max(farthest, out);
    }
    const double lean = seen > 0 ? rise / seen / patch_ : 0;
    wall.beyond[side] = farthest - width_ / 2;
    wall.friction[side] = std::hypot(uv / uu, lean);
    return lean;
  }

  /// How far the middle of a contact is above the middle of its pad. The face is as low as half of
  /// what was seen of it, which must be 5 mm along the wall, at most three times the half length of
  /// the pad from its middle.
  double hidden(std::size_t side) const {
    constexpr double kSeen = 0.005, kApart = 0.001;  // [m]
    std::vector<double> found;
    for (const double way : {-1.0, 1.0}) {
      for (double u = way > 0 ? 0 : -kApart; std::abs(u) <= 3 * patch_; u += way * kApart) {
        const Crossing line = crossing(u);
        if (!line.is_wall) break;
        if (line.is_seen[side]) found.push_back(line.underside[side]);
      }
    }
    if (static_cast<double>(found.size()) * kApart < kSeen) return patch_;
    return std::clamp((geometry::median(found) - height_ + patch_) / 2, 0.0, patch_);
  }

  const geometry::HeightMap& map_;
  double patch_;
  Vector2d middle_, across_, along_;
  double width_, height_;
};

}  // namespace

bool fits(const WallMeasure& wall, std::size_t side, double cell) {
  return std::abs(wall.beyond[side]) <= cell + kRounded;
}

WallMeasure measure_wall(const geometry::HeightMap& map,
                         const Eigen::Matrix<double, 3, 2>& contacts_O, double patch) {
  return Measurement(map, contacts_O, patch).run();
}

}  // namespace graspless::pinch
