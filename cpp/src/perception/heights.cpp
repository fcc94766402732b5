// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/heights.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

namespace graspless::perception {
namespace {

constexpr double kSignificant = 4.5;  // deviations of a height that is not noise
constexpr double kReliable = 6.5;     // deviations of a mean that is significant nearly always
constexpr int kWidestWindow = 9;      // window [pixels]

/// Replaces every value of some rows by the sum of the window around it. Several rows at once, as
/// each sum waits for the one before.
template <int kRows>
void sum_along_rows(DepthImage& image, Eigen::Index first, Eigen::Index half) {
  const Eigen::Index width = image.cols();
  using Rows = Eigen::Array<float, kRows, 1>;
  Eigen::Array<float, kRows, Eigen::Dynamic> before = image.middleRows(first, kRows);
  Rows sum;
  for (int k = 0; k < kRows; ++k) sum[k] = image.row(first + k).head(std::min(half, width)).sum();
  for (Eigen::Index u = 0; u < width; ++u) {
    if (u + half < width) sum += before.col(u + half);
    if (u - half - 1 >= 0) sum -= before.col(u - half - 1);
    image.col(u).template segment<kRows>(first) = sum;
  }
}

/// Replaces every value by the sum of the window around it, which ends at the border.
void sum_windows(DepthImage& image, int window) {
  const Eigen::Index half = window / 2, height = image.rows();
  Eigen::Index v = 0;
  for (; v + 8 <= height; v += 8) sum_along_rows<8>(image, v, half);
  for (; v < height; ++v) sum_along_rows<1>(image, v, half);
  const DepthImage rows = image;
  Eigen::Array<float, 1, Eigen::Dynamic> sum = rows.topRows(std::min(half, height)).colwise().sum();
  for (Eigen::Index v = 0; v < height; ++v) {
    if (v + half < height) sum += rows.row(v + half);
    if (v - half - 1 >= 0) sum -= rows.row(v - half - 1);
    image.row(v) = sum;
  }
}

int window_for(double deviation, const Options& options) {
  const double needed = kSignificant * deviation / (options.min_thickness / 2);
  return std::clamp(2 * static_cast<int>(needed / 2) + 1, 1, kWidestWindow);
}

/// Largest mean height in the window around a pixel.
float highest_near(const DepthImage& mean, Eigen::Index v, Eigen::Index u, int half) {
  const Eigen::Index top = std::max<Eigen::Index>(v - half, 0);
  const Eigen::Index left = std::max<Eigen::Index>(u - half, 0);
  const Eigen::Index rows = std::min<Eigen::Index>(v + half + 1, mean.rows()) - top;
  const Eigen::Index columns = std::min<Eigen::Index>(u + half + 1, mean.cols()) - left;
  return mean.block(top, left, rows, columns).maxCoeff();
}

class Classifier {
 public:
  Classifier(const Sight& sight, const NoiseModel& noise, const Options& options, Heights& result)
      : sight_(sight),
        noise_(noise),
        options_(options),
        result_(result),
        below_(result.camera > 0 ? Level::below : Level::missing) {}

  void classify() {
    const Eigen::Index height = sight_.depth.rows(), width = sight_.depth.cols();
    sums_ = DepthImage::Zero(height, width);
    counts_ = DepthImage::Zero(height, width);
    deviation_.resize(height, width);
    for (Eigen::Index v = 0; v < height; ++v) {
      poll();
      classify_row(v);
    }
    if (result_.window > 1) average();
    for (Eigen::Index v = 0; v < height; ++v) sharpen(v);
  }

 private:
  void classify_row(Eigen::Index v) {
    const float* depth = sight_.depth.row(v).data();
    float* height = result_.height.row(v).data();
    float* deviation = deviation_.row(v).data();
    float* sum = sums_.row(v).data();
    float* count = counts_.row(v).data();
    Level* level = result_.level.row(v).data();
    const auto slope = static_cast<float>(result_.across.x());
    const auto start =
        static_cast<float>(result_.across.y() * static_cast<double>(v) + result_.across.z());
    const auto camera = static_cast<float>(result_.camera);
    const auto constant = static_cast<float>(noise_(0));
    const auto quadratic = static_cast<float>(noise_(1) - noise_(0));
    for (Eigen::Index u = 0; u < sight_.depth.cols(); ++u) {
      const float z = depth[u], across = start + slope * static_cast<float>(u);
      const float h = z * across + camera;
      const float d = std::abs(across) * (constant + quadratic * z * z);
      const float limit = static_cast<float>(kSignificant) * d;
      height[u] = h;
      deviation[u] = d;
      const bool is_near = z > 0 && std::abs(h) <= limit;
      sum[u] = is_near ? h : 0;
      count[u] = is_near ? 1 : 0;
      level[u] = !(z > 0)    ? Level::missing
                 : h > limit ? Level::above
                 : is_near   ? Level::level
                             : below_;
    }
  }

  void average() {
    sum_windows(sums_, result_.window);
    sum_windows(counts_, result_.window);
    sums_ /= counts_.max(1);
  }

  /// Decides which pixels near the plane are above or below it by their means.
  void sharpen(Eigen::Index v) {
    const auto least = static_cast<float>(options_.min_thickness / 2);
    for (Eigen::Index u = 0; u < sight_.depth.cols(); ++u) {
      if (result_.level(v, u) != Level::level) continue;
      const float mean = sums_(v, u);
      result_.height(v, u) = mean;
      const float limit = std::max(least, static_cast<float>(kSignificant) * deviation_(v, u) /
                                              std::sqrt(std::max(1.0f, counts_(v, u))));
      if (mean < -limit) result_.level(v, u) = below_;
      // The means fall from the object's height to zero across its outline: it is where they are
      // half as high.
      if (mean > limit && 2 * mean > highest_near(sums_, v, u, result_.window / 2 + 1)) {
        result_.level(v, u) = Level::above;
      }
    }
  }

  const Sight& sight_;
  const NoiseModel& noise_;
  const Options& options_;
  Heights& result_;
  const Level below_;  // of points below the plane; a ray from below has not come as far
  DepthImage sums_, counts_, deviation_;
};

}  // namespace

Heights heights_over(const Sight& sight, const Plane& plane, const NoiseModel& noise,
                     const Options& options) {
  Heights result;
  const Eigen::Vector3d n_C = sight.X_WC.linear().transpose() * plane.n_W;
  result.across = n_C.transpose() * sight.K.inverse();
  result.camera = plane.above(sight.X_WC.translation());
  result.height.resize(sight.depth.rows(), sight.depth.cols());
  result.level.resize(sight.depth.rows(), sight.depth.cols());
  const Eigen::Vector3d center = sight.K * (sight.X_WC.inverse() * plane.center_W);
  const double z = std::max(center.z(), 0.05);
  result.window = window_for(
      result.deviation(noise, z, center.x() / center.z(), center.y() / center.z()), options);
  Classifier(sight, noise, options, result).classify();
  return result;
}

double least_thickness(const Sight& sight, const Heights& heights, const NoiseModel& noise,
                       const Options& options, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d at = sight.K * (sight.X_WC.inverse() * p_W);
  const double deviation = heights.deviation(noise, at.z(), at.x() / at.z(), at.y() / at.z());
  return std::max(options.min_thickness, kReliable * deviation / heights.window);
}

}  // namespace graspless::perception
