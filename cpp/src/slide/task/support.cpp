// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/support.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/mechanics/contact.hpp"

#include "slide/task/prisms.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

constexpr double kMinFriction = 1e-6;

double within(const std::string& what, double value, double least, double most,
              const std::string& unit = "") {
  require_within(what, value, least, most, unit);
  return value;
}

/// One flag for each of `count` edges.
std::vector<bool> usable(const std::optional<std::vector<int>>& edges, int count) {
  if (!edges) return std::vector<bool>(static_cast<std::size_t>(count), true);
  if (edges->empty()) {
    throw std::invalid_argument("support usable_edges is empty; it must name at least one edge");
  }
  std::vector<bool> flags(count, false);
  for (const int edge : *edges) {
    const bool is_known = edge >= 0 && edge < count;
    if (!is_known || flags[edge]) {
      throw std::invalid_argument(
          "support usable_edges has " + std::to_string(edge) +
          (is_known ? " twice" : "; edges are numbered from 0 to " + std::to_string(count - 1)));
    }
    flags[edge] = true;
  }
  return flags;
}

}  // namespace

Support::Support(const geometry::Polygon& polygon, const Eigen::Isometry3d& X_WS, double slab,
                 double band_width, double friction,
                 const std::optional<std::vector<int>>& usable_edges)
    : goal_band_(polygon, band_width),
      X_WS_(X_WS),
      slab_(within("support slab", slab, geometry::kMinLength, geometry::kMaxLength, " m")),
      friction_(within("support friction", friction, kMinFriction, mechanics::kMaxFriction)),
      is_usable_(usable(usable_edges, polygon.size())),
      shapes_(prisms(polygon, -slab, 0)),
      solid_(shapes_, "support") {
  geometry::require_pose(X_WS, "support X_WS");
  const double tilt = std::acos(std::clamp(X_WS.linear()(2, 2), -1.0, 1.0));
  constexpr double kMaxTilt = 1.0471975511965976;
  if (tilt > kMaxTilt) {
    throw std::invalid_argument("support is tilted by " + figure(tilt) + " rad; at most " +
                                figure(kMaxTilt) + " rad (60 degrees) is allowed");
  }
}

bool Support::is_usable(int edge) const {
  const auto at = static_cast<std::size_t>(edge);
  if (at < is_usable_.size()) return is_usable_[at];  // false of a negative one
  throw std::invalid_argument("edge must be in [0, " + std::to_string(is_usable_.size()) +
                              "), not " + std::to_string(edge));
}

bool Support::has_unusable_edges() const {
  return std::find(is_usable_.begin(), is_usable_.end(), false) != is_usable_.end();
}

}  // namespace graspless::slide
