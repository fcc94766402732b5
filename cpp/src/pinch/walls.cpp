// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "graspless/watch.hpp"

#include "geometry/quantile.hpp"
#include "pinch/wall_measure.hpp"
#include "slide/friction/pressed.hpp"

namespace graspless::pinch {

using Eigen::Index, Eigen::Vector2d;

namespace {

constexpr int kClosings = 36;          // directions
constexpr double kRoundOff = 1e-9;     // [m]
constexpr double kSample = 0.5;        // in cells
constexpr std::size_t kLeastSeen = 8;  // columns in which a face must have been seen
constexpr double kSwing = 0.1;  // of an object that hangs from the hand, before it is at rest [rad]
constexpr double kEven = 0.5;   // share of the moment that pads with uneven contacts bear
constexpr double kMostRise = 0.75;  // in half pads: what is left of the contact is a noisy measure
constexpr double kSeenHeight = 0.003;  // of what was seen of the side of a wall in a cell [m]

/// The part of a wall in one column: samples from `begin` to before `end` are as high as the
/// contacts, those from `inner_begin` to before `inner_end` reach above them.
struct Run {
  Index begin, end, inner_begin, inner_end;
  std::array<double, 2> underside;  // of the cells at both ends [m]
  std::array<bool, 2> is_seen;      // not just bounded by rays
};

/// Heights in the axes of one closing direction: columns along it.
class Section {
 public:
  Section(const geometry::HeightMap& map, double yaw)
      : turn_(yaw - M_PI / 2), step_(kSample * map.cell) {
    const Vector2d size = map.cell * Vector2d(static_cast<double>(map.heights.rows()),
                                              static_cast<double>(map.heights.cols()));
    Eigen::Matrix<double, 2, 4> corners;
    corners << 0, size.x(), size.x(), 0, 0, 0, size.y(), size.y();
    const Eigen::Matrix<double, 2, 4> turned =
        turn_.inverse().toRotationMatrix() * (corners.colwise() + map.corner);
    low_ = turned.rowwise().minCoeff();
    const Vector2d count = (turned.rowwise().maxCoeff() - low_) / step_;
    heights_.resize(static_cast<Index>(count.y()) + 1, static_cast<Index>(count.x()) + 1);
    undersides_.resize(heights_.rows(), heights_.cols());
    for (Index x = 0; x < heights_.cols(); ++x) {
      for (Index y = 0; y < heights_.rows(); ++y) {
        const Vector2d p_O = turn_ * Vector2d(this->x(x), this->y(static_cast<double>(y) + 0.5));
        heights_(y, x) = map.at(p_O);
        undersides_(y, x) = map.underside_at(p_O);
      }
    }
  }

  Index columns() const { return heights_.cols(); }
  double step() const { return step_; }
  double x(Index column) const { return low_.x() + step_ * (static_cast<double>(column) + 0.5); }
  /// Where a sample begins.
  double y(double sample) const { return low_.y() + step_ * sample; }
  Vector2d in_O(double x, double y) const { return turn_ * Vector2d(x, y); }
  Vector2d turned(const Vector2d& p_O) const { return turn_.inverse() * p_O; }

  /// Runs of a column that are as high as contacts, and somewhere as high as `top`.
  std::vector<Run> runs(Index column, double height, double top) const {
    std::vector<Run> found;
    for (Index y = 0; y < heights_.rows();) {
      if (heights_(y, column) < height) {
        ++y;
        continue;
      }
      Run run{y, y, -1, -1, {}, {}};
      for (; y < heights_.rows() && heights_(y, column) >= height; ++y) {
        if (heights_(y, column) < top) continue;
        if (run.inner_begin < 0) run.inner_begin = y;
        run.inner_end = y + 1;
      }
      run.end = y;
      for (const std::size_t end : {0U, 1U}) {
        const Index at = end == 0 ? run.begin : run.end - 1;
        run.underside[end] = undersides_(at, column);
        run.is_seen[end] = run.underside[end] < heights_(at, column) - kSeenHeight;
      }
      if (run.inner_begin >= 0) found.push_back(run);
    }
    return found;
  }

 private:
  Eigen::Rotation2Dd turn_;
  double step_;
  Vector2d low_;
  Eigen::ArrayXXd heights_, undersides_;
};

/// The run of a column that overlaps one of its neighbour most.
std::optional<Run> next_to(const Run& run, const std::vector<Run>& runs) {
  std::optional<Run> best;
  Index most = 0;
  for (const Run& other : runs) {
    const Index common = std::min(run.end, other.end) - std::max(run.begin, other.begin);
    if (common > most) {
      most = common;
      best = other;
    }
  }
  return best;
}

/// Sums over the columns of a face, for its slope and its place.
struct Face {
  double farthest = -std::numeric_limits<double>::infinity();
  double moment = 0, square = 0, rises = 0, count = 0;
  std::vector<double> undersides;

  /// `out`: how far the face is from the middle of the wall at `u` along it; `inner`: the same
  /// above the contacts. Only what was seen of a face leans.
  void add(double u, double out, double inner, bool is_seen) {
    farthest = std::max(farthest, out);
    moment += u * out, square += u * u;
    if (is_seen) rises += out - inner, count += 1;
  }
  double lean(double above) const { return count > 0 ? rises / count / above : 0; }
  /// Tangent of the angle between closing and the normal; u has the mean 0.
  double friction(double above) const {
    return std::hypot(square > 0 ? moment / square : 0, lean(above));
  }
  /// How far the middle of the contact may be above that of a pad, from `above` below `height` to
  /// as much above: the face was not seen further down, or leans, and the pad touches it with its
  /// end. A few noisy points show no face.
  double rise(double height, double above) {
    if (undersides.size() < kLeastSeen) return above;
    const double hidden = (geometry::median(undersides) - height + above) / 2,
                 lost = (lean(above) - kUpright) / (kLeaning - kUpright) * above;
    return std::clamp(std::max(hidden, lost), 0.0, above);
  }
};

/// The wall through a run of the middle one of some columns, if it goes on through all of them.
std::optional<Faces> wall_through(const Section& section, const std::vector<std::vector<Run>>& runs,
                                  Index begin, Index count, const Run& middle, double height,
                                  double above) {
  const Index at = begin + count / 2, beside = count;  // columns that show the faces, too
  const double centre = (section.x(begin) + section.x(begin + count - 1)) / 2;
  Face first, second;
  for (const Index way : {Index(-1), Index(1)}) {
    std::optional<Run> run = middle;
    const Index from = std::max<Index>(0, begin - beside),
                to = std::min(begin + count + beside, section.columns());
    for (Index c = way < 0 ? at : at + 1; c >= from && c < to; c += way) {
      const bool is_within = c >= begin && c < begin + count;
      if (c != at) run = next_to(*run, runs[c]);
      if (!run && is_within) return std::nullopt;
      if (!run) break;
      if (run->is_seen[0]) first.undersides.push_back(run->underside[0]);
      if (run->is_seen[1]) second.undersides.push_back(run->underside[1]);
      if (!is_within) continue;
      const auto y = [&](Index sample) { return section.y(static_cast<double>(sample)); };
      const double u = section.x(c) - centre;
      first.add(u, -y(run->begin), -y(run->inner_begin), run->is_seen[0]);
      second.add(u, y(run->end), y(run->inner_end), run->is_seen[1]);
    }
  }
  Faces faces{};
  faces.first = section.in_O(centre, -first.farthest);
  faces.second = section.in_O(centre, second.farthest);
  faces.width = first.farthest + second.farthest;
  faces.friction = std::max(first.friction(above), second.friction(above));
  faces.rise = std::max(first.rise(height, above), second.rise(height, above));
  return faces;
}

/// The walls of one closing direction with contacts at one height.
std::vector<Faces> walls_in(const Section& section, double length, double height, double above) {
  std::vector<std::vector<Run>> runs;
  for (Index c = 0; c < section.columns(); ++c)
    runs.push_back(section.runs(c, height, height + above - kRoundOff));
  const auto count = std::max<Index>(2, static_cast<Index>(std::ceil(length / section.step())));
  const Index stride = std::max<Index>(1, count / 4);
  std::vector<Faces> found;
  for (Index begin = 0; begin + count <= section.columns(); begin += stride) {
    for (const Run& run : runs[begin + count / 2]) {
      const auto wall = wall_through(section, runs, begin, count, run, height, above);
      if (wall) found.push_back(*wall);
    }
  }
  return found;
}

}  // namespace

std::vector<Faces> walls(const geometry::HeightMap& map, const Eigen::Vector3d& com, double length,
                         const std::vector<double>& heights, double above) {
  std::vector<Faces> found;
  for (int k = 0; k < kClosings; ++k) {
    const double yaw = k * M_PI / kClosings;
    const Section section(map, yaw);
    const Vector2d com_turned = section.turned(com.head<2>());
    for (const double height : heights) {
      poll();
      for (Faces& wall : walls_in(section, length, height, above)) {
        const Vector2d away = section.turned(wall.middle()) - com_turned;
        wall.yaw = yaw;
        wall.lever = std::abs(away.x());
        wall.offset = std::abs(away.y());
        wall.height = height;
        found.push_back(wall);
      }
    }
  }
  return found;
}

double largest_mass(const Faces& faces, const Pads& pads) {
  const double a = pads.half, swing = kSwing * std::max(0.0, faces.drop);
  const double force = (pads.friction - faces.friction) * pads.press / pads.share,
               twist = 4.0 / 3 * pads.friction * a * pads.press,
               tilt = 2 * kEven * (a - faces.rise) * pads.press;
  const double lever = std::max(0.0, faces.lever - swing),
               offset = std::max(0.0, faces.offset - swing);
  if (force <= 0 || faces.rise > kMostRise * a) return 0;
  const double load = std::hypot(1 / force, lever / twist);  // per newton of weight
  return 1 / (slide::kGravity * std::max(load, offset / tilt));
}

}  // namespace graspless::pinch
