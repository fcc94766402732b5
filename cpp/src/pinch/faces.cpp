// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspless/watch.hpp"

namespace graspless::pinch {

using Eigen::Matrix2Xd, Eigen::Vector2d;

namespace {

constexpr int kDirections = 36;
constexpr int kLeastColumns = 5, kMostColumns = 400;
constexpr double kColumn = 0.001;   // [m]
constexpr double kFace = 0.010;     // over which a noisy outline is averaged [m]
constexpr double kOffPad = 0.0015;  // of a contact behind the outermost point on a flat pad [m]

/// Lower and upper boundary of a polygon over columns of equal width.
struct Profile {
  std::vector<double> x, low, high;
  double column;
};

Profile profile(const Matrix2Xd& corners) {
  const double left = corners.row(0).minCoeff(), right = corners.row(0).maxCoeff();
  const int count = std::clamp(static_cast<int>(std::ceil((right - left) / kColumn)), kLeastColumns,
                               kMostColumns);
  Profile found;
  found.column = (right - left) / count;
  const auto size = static_cast<std::size_t>(count);
  found.low.assign(size, std::numeric_limits<double>::infinity());
  found.high.assign(size, -std::numeric_limits<double>::infinity());
  for (int i = 0; i < count; ++i) found.x.push_back(left + (i + 0.5) * found.column);
  for (Eigen::Index k = 0; k < corners.cols(); ++k) {
    Vector2d a = corners.col(k), b = corners.col((k + 1) % corners.cols());
    if (a.x() > b.x()) std::swap(a, b);
    if (a.x() == b.x()) continue;
    const auto begin = static_cast<int>(std::ceil((a.x() - left) / found.column - 0.5));
    for (int i = std::max(begin, 0); i < count; ++i) {
      const auto column = static_cast<std::size_t>(i);
      if (found.x[column] > b.x()) break;
      const double y = a.y() + (b.y() - a.y()) * (found.x[column] - a.x()) / (b.x() - a.x());
      found.low[column] = std::min(found.low[column], y);
      found.high[column] = std::max(found.high[column], y);
    }
  }
  return found;
}

/// Slope of the line that fits `count` values best.
double slope(const std::vector<double>& values, std::size_t begin, std::size_t count,
             double column) {
  double sum = 0, square = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = (static_cast<double>(i) - (static_cast<double>(count) - 1) / 2) * column;
    sum += x * values[begin + i];
    square += x * x;
  }
  return square > 0 ? sum / square : 0;
}

/// Largest slope of the lines that fit the first half, the second half and all of `count` values.
/// A corner has steep halves.
double steepest(const std::vector<double>& values, std::size_t begin, std::size_t count,
                double column) {
  const std::size_t half = (count + 1) / 2;
  return std::max({std::abs(slope(values, begin, count, column)),
                   std::abs(slope(values, begin, half, column)),
                   std::abs(slope(values, begin + count - half, half, column))});
}

}  // namespace

std::vector<Faces> opposite_faces(const geometry::Polygon& outline, const Vector2d& com,
                                  double pad) {
  std::vector<Faces> found;
  for (int k = 0; k < kDirections; ++k) {
    poll();
    const double yaw = k * M_PI / kDirections;
    const Eigen::Rotation2Dd turn(yaw - M_PI / 2);  // closing direction along y
    const Profile along = profile(turn.inverse().toRotationMatrix() * outline.vertices());
    const double com_x = (turn.inverse() * com).x();
    const auto size = along.x.size();
    const double across = static_cast<double>(size) * along.column;
    const auto columns = [&](double length) {
      return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(length / along.column)), 2,
                                     size);
    };
    const std::size_t face = columns(std::min(kFace, across / 2)),
                      count = std::max(face, columns(pad));
    const std::size_t step = std::max<std::size_t>(1, face / 2);
    for (std::size_t begin = 0; begin + count <= size; begin += step) {
      const auto low = along.low.begin() + begin, high = along.high.begin() + begin;
      const auto n = static_cast<std::ptrdiff_t>(count);
      const double bottom = *std::min_element(low, low + n),
                   top = *std::max_element(high, high + n);
      const std::size_t inner = begin + (count - face) / 2, middle = inner + face / 2;
      // A pad that is longer than the face is flat, and touches what is outermost.
      const double behind = std::max(along.low[middle] - bottom, top - along.high[middle]);
      if (count > face && behind > kOffPad) continue;
      const double x = (along.x[begin] + along.x[begin + count - 1]) / 2;
      const double steep = std::max(steepest(along.low, inner, face, along.column),
                                    steepest(along.high, inner, face, along.column));
      found.push_back({yaw, turn * Vector2d(x, bottom), turn * Vector2d(x, top), top - bottom,
                       steep, std::abs(x - com_x)});
    }
  }
  return found;
}

}  // namespace graspless::pinch
