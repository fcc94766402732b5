// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

#include "perception/objects.hpp"

namespace graspless::perception {
namespace {

constexpr double kLargestDepth = 15;  // of a median [m]
constexpr double kLeastShare = 0.05;  // of the pixels that have a depth
constexpr double kUsualTilt = 0.05;   // [rad]
constexpr double kNoisy = 2;          // times the expected noise
constexpr double kSlab = 0.06;        // sides of a support are this high at most [m],
constexpr double kAside = 0.01;       // and seen this far beside it;
constexpr double kBeside = 0.03;      // the noise of its plane is seen farther [m]

template <class... Parts>
std::string say(const Parts&... parts) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << parts);
  return text.str();
}

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

/// True if something lies on a support, or there is no other one.
bool is_used(const Support& support, const Scene& scene) {
  const auto lies_on = [&](const Object& object) { return object.support == support.name; };
  return scene.supports.size() == 1 ||
         std::any_of(scene.objects.begin(), scene.objects.end(), lies_on);
}

/// Builds the scene, plane by plane.
class Builder {
 public:
  Builder(const std::vector<Sight>& sights, const NoiseModel& noise, const Options& options)
      : sights_(sights), noise_(noise), options_(options) {
    for (const Sight& sight : sights) {
      claims_.emplace_back(Claims::value_type::Constant(sight.height(), sight.width(), false));
    }
  }

  void add(const Plane& plane) {
    std::vector<Sighting> sightings;
    for (const Sight& sight : sights_) {
      sightings.push_back({&sight, heights_over(sight, plane, noise_, options_)});
    }
    for (const Region& region : regions_of(plane, sightings, noise_, options_)) {
      Support support = support_of(plane, region, sightings);
      add_objects(region, support, sightings);
      for (geometry::Convex& shape : patches(region, options_)) {
        scene_.unseen.push_back({"", std::move(shape)});
      }
      areas_.push_back(region.area);
      scene_.supports.push_back(std::move(support));
      claim_support(region, sightings);
    }
  }

  Scene finish() {
    name_supports();
    name_objects();
    warn_of_heights();
    scene_.status = scene_.supports.empty() ? Status::no_support : Status::found;
    scene_.reason =
        say(scene_.supports.size(), scene_.supports.size() == 1 ? " support" : " supports", " and ",
            scene_.objects.size(), scene_.objects.size() == 1 ? " object" : " objects");
    return std::move(scene_);
  }

 private:
  Support support_of(const Plane& plane, const Region& region,
                     const std::vector<Sighting>& sightings) {
    double least = 1;
    const Eigen::Vector3d center = plane.center_W;
    for (const Sighting& sighting : sightings) {
      if ((sighting.sight->X_WC.inverse() * center).z() < 0.05) continue;
      least = std::min(
          least, least_thickness(*sighting.sight, sighting.heights, noise_, options_, center));
    }
    const Sight& first = sights_[static_cast<std::size_t>(plane.cells.front().view)];
    const double z = (first.X_WC.inverse() * center).z();
    return {say(number_++),
            region.outline.polygon,
            region.outline.labels,
            region.X_WS,
            plane.height_error,
            plane.angle_error,
            noise_(z),
            least};
  }

  void add_objects(const Region& region, const Support& support,
                   const std::vector<Sighting>& sightings) {
    const std::vector<Cluster> clusters =
        clusters_over(region, sightings, noise_, options_, claims_, left_out_.emplace_back());
    for (const Cluster& cluster : clusters) {
      auto object = measure(cluster, region, support, sightings, noise_, options_);
      if (!object) continue;
      object->name = say(scene_.objects.size());
      for (geometry::Convex& shape : shadows(cluster, region, sightings)) {
        scene_.unseen.push_back({object->name, std::move(shape)});
      }
      scene_.objects.push_back(std::move(*object));
    }
  }

  /// Lower supports must not take this one, or its sides, for an object. What lies elsewhere in its
  /// plane, or a little below that, may be one.
  void claim_support(const Region& region, const std::vector<Sighting>& sightings) {
    Raster sides = region.inside, near = region.inside;
    grow(sides, static_cast<int>(std::ceil(kAside / sides.cell)));
    for (std::size_t k : joined_to(region)) near.values[k] = 1;
    grow(near, static_cast<int>(std::ceil(kBeside / near.cell)));
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      poll();
      const Sight& sight = *sightings[i].sight;
      const Heights& heights = sightings[i].heights;
      const Rays rays(sightings[i], region.X_WS);
      for (int v = 0; v < sight.height(); ++v) {
        for (int u = 0; u < sight.width(); ++u) {
          const bool is_side = heights.level(v, u) == Level::below &&
                               heights.height(v, u) > -static_cast<float>(kSlab);
          if (heights.level(v, u) != Level::level && !is_side) continue;
          const auto z = static_cast<double>(sight.depth(v, u));
          const Eigen::Vector3d p = rays.at_depth(u, v, z);
          const Raster& taken = is_side ? sides : near;
          if (taken.at(taken.column(p.x()), taken.row(p.y()))) claims_[i](v, u) = true;
        }
      }
    }
  }

  /// Names are given by area; objects refer to them.
  void name_supports() {
    std::vector<std::size_t> order(areas_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return areas_[a] > areas_[b]; });
    std::vector<Support> sorted;
    std::vector<double> left_out;
    for (std::size_t i = 0; i < order.size(); ++i) {
      Support& support = scene_.supports[order[i]];
      const std::string name = say("support_", i);
      for (Object& object : scene_.objects) {
        if (object.support == support.name) object.support = name;
      }
      support.name = name;
      sorted.push_back(std::move(support));
      left_out.push_back(left_out_[order[i]]);
    }
    scene_.supports = std::move(sorted);
    left_out_ = std::move(left_out);
  }

  void name_objects() {
    const Eigen::Vector3d camera = sights_.front().X_WC.translation();
    const auto distance = [&](const Object& o) { return (o.X_WO.translation() - camera).norm(); };
    std::stable_sort(scene_.objects.begin(), scene_.objects.end(),
                     [&](const Object& a, const Object& b) { return distance(a) < distance(b); });
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      const std::string name = say("object_", i);
      for (Unseen& unseen : scene_.unseen) {
        if (unseen.behind == scene_.objects[i].name) unseen.behind = name;
      }
      scene_.objects[i].name = name;
    }
  }

  void warn_of_heights() {
    for (std::size_t i = 0; i < scene_.supports.size(); ++i) {
      const Support& support = scene_.supports[i];
      if (left_out_[i] == 0 || !is_used(support, scene_)) continue;
      scene_.warnings.push_back(
          say("something over ", support.name, " reaches ", left_out_[i],
              " m above it, but max_height is ", options_.max_height,
              " m: what is higher is neither object nor obstacle; raise max_height to keep it"));
    }
  }

  const std::vector<Sight>& sights_;
  const NoiseModel& noise_;
  const Options& options_;
  Claims claims_;
  Scene scene_;
  std::vector<double> areas_, left_out_;  // of the supports
  int number_ = 0;
};

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
  Builder builder(sights, noise, options);
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
