// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <Eigen/Eigenvalues>

#include "graspless/watch.hpp"

#include "geometry/segment.hpp"

namespace graspless::perception {
namespace {

/// The corners of the steps, closed: point(size) is point(0).
class Ring {
 public:
  Ring(const Raster& mask, const std::vector<Step>& boundary) {
    for (const Step& step : boundary) {
      points_.push_back(mask.origin + mask.cell * Eigen::Vector2d(step.x, step.y));
    }
  }
  std::size_t size() const { return points_.size(); }
  const Eigen::Vector2d& point(std::size_t i) const { return points_[i % size()]; }
  Eigen::Vector2d middle(std::size_t i) const { return (point(i) + point(i + 1)) / 2; }
  std::size_t farthest_from(std::size_t i) const {
    std::size_t best = i;
    for (std::size_t k = 0; k < size(); ++k) {
      if ((point(k) - point(i)).norm() > (point(best) - point(i)).norm()) best = k;
    }
    return best;
  }

 private:
  std::vector<Eigen::Vector2d> points_;
};

/// Adds the indices where the polyline from `first` to `last` must bend, without `last`.
void split(const Ring& ring, std::size_t first, std::size_t last, double tolerance,
           std::vector<std::size_t>& corners) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    poll();
    const auto [a, b] = open.back();
    open.pop_back();
    std::size_t worst = a;
    double most = tolerance;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double far = geometry::distance_to_segment(ring.point(i), ring.point(a), ring.point(b));
      if (far > most) {
        most = far;
        worst = i;
      }
    }
    if (worst == a) {
      corners.push_back(a);
    } else {
      open.emplace_back(worst, b);
      open.emplace_back(a, worst);
    }
  }
}

/// Replaces each label by the most frequent one around it.
void smooth(std::vector<EdgeLabel>& labels, int half) {
  const auto given = labels;
  const auto n = static_cast<int>(labels.size());
  if (n <= 2 * half + 1) return;
  std::array<int, 3> votes{};
  const auto vote = [&](int i, int sign) {
    votes[static_cast<std::size_t>(given[(i + n) % n])] += sign;
  };
  for (int i = -half; i <= half; ++i) vote(i, 1);
  for (int i = 0; i < n; ++i) {
    auto& label = labels[i];
    const auto most = std::max_element(votes.begin(), votes.end()) - votes.begin();
    if (votes[most] > votes[static_cast<std::size_t>(label)]) {
      label = static_cast<EdgeLabel>(most);
    }
    vote(i - half, -1);
    vote(i + half + 1, 1);
  }
}

/// Indices at which the label changes.
std::vector<std::size_t> changes_of(const std::vector<EdgeLabel>& labels) {
  std::vector<std::size_t> changes;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != labels[(i + labels.size() - 1) % labels.size()]) changes.push_back(i);
  }
  return changes;
}

/// Gives runs of real edges that are too short the label before them.
void drop_short_runs(std::vector<EdgeLabel>& labels, std::size_t least) {
  const auto changes = changes_of(labels);
  const std::size_t n = labels.size();
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::size_t first = changes[k];
    const std::size_t last = changes[(k + 1) % changes.size()] + (k + 1 == changes.size() ? n : 0);
    if (labels[first] != EdgeLabel::real || last - first >= least) continue;
    const EdgeLabel before = labels[(first + n - 1) % n];
    for (std::size_t i = first; i < last; ++i) labels[i % n] = before;
  }
}

/// A straight line through the middles of steps.
struct Line {
  Eigen::Vector2d point, along;
  Eigen::Vector2d project(const Eigen::Vector2d& p) const {
    return point + along * along.dot(p - point);
  }
};

Line fit_line(const Ring& ring, std::size_t first, std::size_t last) {
  const std::size_t margin = (last - first) / 8;  // corners are round
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  const std::size_t begin = first + margin, end = last - margin;
  for (std::size_t i = begin; i < end; ++i) mean += ring.middle(i);
  mean /= static_cast<double>(end - begin);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = begin; i < end; ++i) {
    spread += (ring.middle(i) - mean) * (ring.middle(i) - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  return {mean, axes.eigenvectors().col(1)};
}

/// Largest distance of the steps from the line through them.
double bend(const Ring& ring, std::size_t first, std::size_t last) {
  const Line line = fit_line(ring, first, last);
  double most = 0;
  for (std::size_t i = first; i < last; ++i) {
    most = std::max(most, (ring.middle(i) - line.project(ring.middle(i))).norm());
  }
  return most;
}

/// Drops corners without which the fitted edges still keep within the tolerance, the straightest
/// first. A chord between two steps bends with their noise; a line through all steps does not.
void drop_needless(const Ring& ring, const std::vector<std::size_t>& fixed, double tolerance,
                   std::vector<std::size_t>& corners) {
  while (corners.size() > 3) {
    poll();
    const std::size_t n = corners.size();
    std::size_t straightest = n;
    double least = tolerance;
    for (std::size_t k = 0; k < n; ++k) {
      if (std::find(fixed.begin(), fixed.end(), corners[k] % ring.size()) != fixed.end()) continue;
      const std::size_t first = corners[(k + n - 1) % n], last = corners[(k + 1) % n];
      const double without = bend(ring, first, last + (last <= first ? ring.size() : 0));
      if (without > least) continue;
      least = without;
      straightest = k;
    }
    if (straightest == n) return;
    corners.erase(corners.begin() + straightest);
  }
}

/// Where two fitted edges meet, near the corner `at` of the polyline.
Eigen::Vector2d meet(const Line& a, const Line& b, const Eigen::Vector2d& at, double tolerance) {
  const double sine = a.along.x() * b.along.y() - a.along.y() * b.along.x();
  const Eigen::Vector2d between = (a.project(at) + b.project(at)) / 2;
  if (std::abs(sine) < 0.2) return between;
  const Eigen::Vector2d d = b.point - a.point;
  const Eigen::Vector2d p = a.point + a.along * (d.x() * b.along.y() - d.y() * b.along.x()) / sine;
  return (p - at).norm() < 1.5 * tolerance ? p : between;
}

std::optional<geometry::Polygon> polygon_of(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return std::nullopt;
  Eigen::Matrix2Xd vertices(2, static_cast<Eigen::Index>(points.size()));
  double doubled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d &a = points[i], &b = points[(i + 1) % points.size()];
    vertices.col(i) = a;
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  if (!(doubled > 0)) return std::nullopt;  // turned inside out
  try {
    return geometry::Polygon(vertices);
  } catch (const std::invalid_argument&) {  // it crosses itself
    return std::nullopt;
  }
}

/// Gives short real edges beside others the label of those: a corner of the boundary of what was
/// seen may look like an edge.
void doubt_short_edges(const std::vector<Eigen::Vector2d>& points, std::vector<EdgeLabel>& labels,
                       double least) {
  const auto given = labels;
  const std::size_t n = labels.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (given[i] != EdgeLabel::real || (points[(i + 1) % n] - points[i]).norm() >= least) continue;
    for (const EdgeLabel beside : {given[(i + n - 1) % n], given[(i + 1) % n]}) {
      if (beside != EdgeLabel::real) labels[i] = beside;
    }
  }
}

/// Corners of the polyline, from index to index of the ring; ascending, the last may exceed its
/// size.
std::vector<std::size_t> corners_of(const Ring& ring, const std::vector<std::size_t>& fixed,
                                    double tolerance) {
  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    const bool is_last = k + 1 == fixed.size();
    split(ring, fixed[k], is_last ? fixed[0] + ring.size() : fixed[k + 1], tolerance, corners);
  }
  return corners;
}

}  // namespace

LabelledPolygon fitted_polygon(const Raster& mask, const std::vector<Step>& boundary,
                               std::vector<EdgeLabel> labels, double tolerance, double least_real) {
  const Ring ring(mask, boundary);
  smooth(labels, 4);
  drop_short_runs(labels, static_cast<std::size_t>(least_real / mask.cell));
  const std::vector<std::size_t> changes = changes_of(labels);
  const auto fixed = changes.empty() ? std::vector<std::size_t>{0, ring.farthest_from(0)} : changes;
  for (double allowed = tolerance;; allowed = allowed > mask.cell / 4 ? allowed / 2 : 0) {
    auto corners = corners_of(ring, fixed, allowed);
    drop_needless(ring, changes, allowed, corners);
    std::vector<Line> lines;
    std::vector<EdgeLabel> kept;
    std::vector<Eigen::Vector2d> fitted, plain;
    const auto n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t last = k + 1 < n ? corners[k + 1] : corners[0] + ring.size();
      lines.push_back(fit_line(ring, corners[k], last));
      kept.push_back(labels[((corners[k] + last) / 2) % ring.size()]);
      plain.push_back(ring.point(corners[k]));
    }
    for (std::size_t k = 0; k < n; ++k) {
      fitted.push_back(meet(lines[(k + n - 1) % n], lines[k], plain[k], tolerance));
    }
    for (const auto& points : {fitted, plain}) {
      const auto polygon = polygon_of(points);
      if (!polygon) continue;
      doubt_short_edges(points, kept, 1.5 * least_real);
      return {*polygon, kept};
    }
    if (allowed == 0) throw std::logic_error("the boundary of a mask crosses itself");
  }
}

geometry::Polygon simple_polygon(const Raster& mask, const std::vector<Step>& boundary,
                                 double tolerance) {
  const Ring ring(mask, boundary);
  for (double allowed = tolerance;; allowed = allowed > mask.cell / 4 ? allowed / 2 : 0) {
    std::vector<Eigen::Vector2d> points;
    for (const std::size_t i : corners_of(ring, {0, ring.farthest_from(0)}, allowed)) {
      points.push_back(ring.point(i));
    }
    if (const auto polygon = polygon_of(points)) return *polygon;
    if (allowed == 0) throw std::logic_error("the boundary of a mask crosses itself");
  }
}

}  // namespace graspless::perception
