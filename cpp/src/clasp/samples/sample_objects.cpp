// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/sample_objects.hpp"

#include <stdexcept>
#include <utility>

#include "clasp/samples/parts.hpp"
#include "text.hpp"

namespace graspless::clasp {
namespace {

using Maker = Parts (*)();

const std::vector<std::pair<std::string, Maker>>& makers() {
  static const std::vector<std::pair<std::string, Maker>> all{{"purse", make_purse},
                                                              {"bag", make_bag},
                                                              {"travel_bag", make_travel_bag},
                                                              {"lawn_mower", make_lawn_mower},
                                                              {"chair", make_chair}};
  return all;
}

Maker maker(const std::string& wanted) {
  std::string choices;
  for (const auto& [name, make] : makers()) {
    if (name == wanted) return make;
    choices += (choices.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument("sample object must be one of " + choices + ", not '" + wanted + "'");
}

struct Scaled {
  double scale;
  void operator()(geometry::Box& box) const { box.size *= scale; }
  void operator()(geometry::Sphere& sphere) const { sphere.radius *= scale; }
  void operator()(geometry::Capsule& capsule) const {
    capsule.radius *= scale;
    capsule.length *= scale;
  }
  void operator()(geometry::Convex& convex) const { convex.vertices *= scale; }
  void operator()(geometry::Mesh& mesh) const { mesh.vertices *= scale; }
};

}  // namespace

const std::vector<std::string>& sample_object_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, make] : makers()) all.push_back(name);
    return all;
  }();
  return names;
}

std::vector<geometry::PlacedShape> sample_object(const std::string& name, double scale) {
  constexpr double kMaxScale = 1000;
  const Maker make = maker(name);
  require(scale > 0 && scale <= kMaxScale, "scale", scale, "must be in (0, 1000]");
  Parts parts = make();
  for (geometry::PlacedShape& part : parts) {
    std::visit(Scaled{scale}, part.shape);
    part.X_BG.translation() *= scale;
  }
  return parts;
}

}  // namespace graspless::clasp
