// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/perception/camera.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace graspless::perception {
namespace {

constexpr int kLeast = 16, kMost = 20000;                                  // pixels along a side
constexpr double kNarrowest = 5 * M_PI / 180, kWidest = 170 * M_PI / 180;  // field of view [rad]

[[noreturn]] void refuse(const std::string& field, double value, const std::string& allowed) {
  std::ostringstream text;
  text << field << " is " << value << "; it must " << allowed;
  throw std::invalid_argument(text.str());
}

void require_size(const char* field, int size) {
  if (size < kLeast || size > kMost) refuse(field, size, "lie in [16, 20000] pixels");
}

void require_view(const char* name, double focal, double center, int size) {
  const std::string k = std::string("K's ") + name;
  if (!(focal > 0)) refuse(k + " focal length", focal, "be positive [pixels]");
  const double least = 0.1 * size, most = 0.9 * size;
  if (!(center >= least && center <= most)) {
    std::ostringstream range;
    range << "lie in [" << least << ", " << most
          << "] pixels, near the middle of the image; is K that of another resolution?";
    refuse(k + " principal point", center, range.str());
  }
  const double angle = std::atan(center / focal) + std::atan((size - 1 - center) / focal);
  if (angle < kNarrowest || angle > kWidest) {
    refuse(k + " field of view", angle * 180 / M_PI,
           "lie in [5, 170] degrees; the focal length is in pixels");
  }
}

}  // namespace

Camera camera_with_view(int width, int height, double angle) {
  if (width < 1) refuse("width", width, "be positive");
  if (height < 1) refuse("height", height, "be positive");
  if (!(angle > 0 && angle < M_PI)) refuse("angle", angle, "lie in (0, pi) rad");
  const double f = width / (2 * std::tan(angle / 2));
  Camera camera{width, height};
  camera.K << f, 0, (width - 1) / 2.0, 0, f, (height - 1) / 2.0, 0, 0, 1;
  return camera;
}

void validate(const Camera& camera) {
  require_size("width", camera.width);
  require_size("height", camera.height);
  const Eigen::Matrix3d& K = camera.K;
  const bool is_pinhole = K.allFinite() && std::abs(K(0, 1)) < 1e-9 && std::abs(K(1, 0)) < 1e-9 &&
                          (K.row(2) - Eigen::RowVector3d(0, 0, 1)).norm() < 1e-9;
  if (!is_pinhole) {
    throw std::invalid_argument(
        "K is not that of a pinhole camera without skew: it must be [[fx, 0, cx], [0, fy, cy], "
        "[0, 0, 1]], finite, in pixels");
  }
  require_view("horizontal", K(0, 0), K(0, 2), camera.width);
  require_view("vertical", K(1, 1), K(1, 2), camera.height);
}

}  // namespace graspless::perception
