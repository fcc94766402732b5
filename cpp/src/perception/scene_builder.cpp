// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "graspless/watch.hpp"

#include "text.hpp"

namespace graspless::perception {
namespace {

constexpr double kSlab = 0.06;    // sides of a support are this high at most [m],
constexpr double kAside = 0.01;   // and seen this far beside it;
constexpr double kBeside = 0.03;  // the noise of its plane is seen farther [m]

}  // namespace

bool is_used(const Support& support, const Scene& scene) {
  const auto lies_on = [&](const Object& object) { return object.support == support.name; };
  return scene.supports.size() == 1 ||
         std::any_of(scene.objects.begin(), scene.objects.end(), lies_on);
}

SceneBuilder::SceneBuilder(const std::vector<Sight>& sights, const NoiseModel& noise,
                           const Options& options)
    : sights_(sights), noise_(noise), options_(options) {
  for (const Sight& sight : sights) {
    claims_.emplace_back(Claims::value_type::Constant(sight.height(), sight.width(), false));
  }
}

void SceneBuilder::add(const Plane& plane) {
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

Scene SceneBuilder::finish() {
  name_supports();
  name_objects();
  warn_of_heights();
  scene_.status = scene_.supports.empty() ? Status::no_support : Status::found;
  scene_.reason =
      say(scene_.supports.size(), scene_.supports.size() == 1 ? " support" : " supports", " and ",
          scene_.objects.size(), scene_.objects.size() == 1 ? " object" : " objects");
  return std::move(scene_);
}

Support SceneBuilder::support_of(const Plane& plane, const Region& region,
                                 const std::vector<Sighting>& sightings) {
  double least = 1;
  const Eigen::Vector3d center = plane.center_W;
  for (const Sighting& sighting : sightings) {
    if ((sighting.sight->X_WC.inverse() * center).z() < 0.05) continue;
    least = std::min(least,
                     least_thickness(*sighting.sight, sighting.heights, noise_, options_, center));
  }
  const Sight& first = sights_[plane.cells.front().view];
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

void SceneBuilder::add_objects(const Region& region, const Support& support,
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
void SceneBuilder::claim_support(const Region& region, const std::vector<Sighting>& sightings) {
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
void SceneBuilder::name_supports() {
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

void SceneBuilder::name_objects() {
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

void SceneBuilder::warn_of_heights() {
  for (std::size_t i = 0; i < scene_.supports.size(); ++i) {
    const Support& support = scene_.supports[i];
    if (left_out_[i] == 0 || !is_used(support, scene_)) continue;
    scene_.warnings.push_back(
        say("something over ", support.name, " reaches ", left_out_[i],
            " m above it, but max_height is ", options_.max_height,
            " m: what is higher is neither object nor obstacle; raise max_height to keep it"));
  }
}

}  // namespace graspless::perception
