// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

#include "perception/scene_builder.hpp"
#include "text.hpp"

namespace graspless::perception {
namespace {

constexpr double kLargestDepth = 15;  // of a median [m]
constexpr double kLeastShare = 0.05;  // of the pixels that have a depth
constexpr double kUsualTilt = 0.05;   // [rad]
constexpr double kNoisy = 2;          // times the expected noise

Scene failure(Status status, const std::string& reason) {
  Scene scene;
  scene.status = status;
  scene.reason = reason;
  return scene;
}

/// Least factor of the noise: no camera resolves a tenth of a millimetre, nor less than its steps,
/// whose rounding has a deviation as well. Where a plane falls by about one step from pixel to
/// pixel, all pixels of a cell are rounded alike, and the cell looks smooth.
double least_noise_scale(const std::vector<Sight>& sights, const std::vector<Plane>& planes,
                         const NoiseModel& noise) {
  double step = 0, nearest = std::numeric_limits<double>::infinity();
  for (const Sight& sight : sights) step = std::max(step, sight.step);
  for (const Plane& plane : planes) {
    for (const Cell& cell : plane.cells) nearest = std::min(nearest, cell.depth);
  }
  return std::max(1e-4, step / std::sqrt(12.0)) / noise(nearest);
}

/// The scene of views without trustworthy depths; otherwise its status is `found`.
Scene judge_depths(const std::vector<Sight>& sights) {
  double share = 0, median = 0;
  for (const Sight& sight : sights) {
    share = std::max(share, sight.share);
    median = std::max(median, sight.median);
  }
  if (share < kLeastShare) {
    return failure(Status::no_depth, say("only ", 100 * share,
                                         " % of the pixels have a depth; is the camera covered, "
                                         "too near, or in bright light?"));
  }
  if (median > kLargestDepth) {
    return failure(Status::not_metres, say("the median depth is ", median,
                                           " m; depths must be in metres: divide those in "
                                           "millimetres by 1000"));
  }
  return failure(Status::found, "");
}

Scene without_support(const std::vector<Cell>& cells, const Options& options) {
  const auto below = find_planes(cells, options, true);
  if (!below.empty()) {
    return failure(Status::camera_below,
                   say("a plane of ", below.front().area,
                       " m^2 is seen from below; check that X_WC is the pose of the optical frame "
                       "(z forward, y down) in a world with z up"));
  }
  return failure(Status::no_support, say("no plane of at least ", options.min_support_area,
                                         " m^2 within ", options.max_tilt,
                                         " rad of level; check X_WC, and K of depth images, look "
                                         "at the table from above, or change "
                                         "min_support_area or max_tilt"));
}

void warn_of(Scene& scene, const std::vector<Sight>& sights, const NoiseModel& noise,
             const std::vector<Plane>& planes) {
  for (const Sight& sight : sights) {
    if (sight.stride > 1) {
      scene.warnings.push_back(say("the image is large: one of ", sight.stride,
                                   " rows and columns was read; raise max_pixels to read all"));
    }
  }
  if (noise.scale > kNoisy) {
    scene.warnings.push_back(
        say("the depths are ", noise.scale,
            " times as noisy as expected: average several frames, or set noise_constant and "
            "noise_quadratic"));
  }
  const double tilt = std::acos(std::min(1.0, planes.front().n_W.z()));
  if (tilt > kUsualTilt) {
    scene.warnings.push_back(
        say("the largest support tilts by ", tilt, " rad; if it is level, X_WC or K is wrong"));
  }
  for (const Support& support : scene.supports) {
    if (is_used(support, scene) &&
        std::count(support.edges.begin(), support.edges.end(), EdgeLabel::real) == 0) {
      scene.warnings.push_back(support.name +
                               " has no real edge: the image ends or something hides each; nothing "
                               "can be slid over an edge that was not seen");
    }
  }
  const auto is_patch = [](const Unseen& unseen) { return unseen.behind.empty(); };
  const auto patches = std::count_if(scene.unseen.begin(), scene.unseen.end(), is_patch);
  if (patches > 0) {
    scene.warnings.push_back(
        say(patches, patches == 1 ? " patch of a support has" : " patches of supports have",
            " no depth, as under glass or dark things; they count as unseen"));
  }
}

void validate_views(const std::vector<View>& views) {
  if (views.empty()) throw std::invalid_argument("views must have at least one view, not 0");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const View& view = views[i];
    try {
      validate(
          Camera{static_cast<int>(view.depth.cols()), static_cast<int>(view.depth.rows()), view.K});
      geometry::require_pose(view.X_WC, "X_WC");
    } catch (const std::invalid_argument& error) {
      if (views.size() == 1) throw;
      throw std::invalid_argument(say("views[", i, "]: ", error.what()));
    }
  }
}

}  // namespace

void validate(const Options& options) { planning::require_in_range("options.", options); }

Scene perceive(const std::vector<View>& views, const Options& options) {
  validate(options);
  validate_views(views);
  NoiseModel noise{options.noise_constant, options.noise_quadratic};
  std::vector<Sight> sights;
  std::vector<Cell> cells;
  for (const View& view : views) sights.push_back(prepare(view, noise, options.max_pixels));
  if (const Scene judged = judge_depths(sights); !judged) return judged;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const auto found = planar_cells(sights[i], static_cast<int>(i), noise);
    cells.insert(cells.end(), found.begin(), found.end());
  }
  std::vector<Plane> planes = find_planes(cells, options, false);
  if (planes.empty()) return without_support(cells, options);
  noise.scale = std::max(planes.front().noise_scale, least_noise_scale(sights, planes, noise));
  // From the highest to the lowest: what stands on a shelf is not an object of the board below.
  std::vector<Plane> ordered = planes;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Plane& a, const Plane& b) { return a.center_W.z() > b.center_W.z(); });
  SceneBuilder builder(sights, noise, options);
  for (const Plane& plane : ordered) builder.add(plane);
  Scene scene = builder.finish();
  if (!scene)
    return failure(Status::no_support,
                   say("level surfaces were seen, but no piece of one that hangs together has ",
                       options.min_support_area,
                       " m^2; look at the table from above, or change min_support_area"));
  warn_of(scene, sights, noise, planes);
  return scene;
}

}  // namespace graspless::perception
