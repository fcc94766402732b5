// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "pinch/check_contacts.hpp"
#include "pinch/wall_measure.hpp"
#include "text.hpp"

namespace graspless::pinch {

namespace {

constexpr double kEqual = 1e-6;  // heights [m], tangents

class WallExamination {
 public:
  WallExamination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem),
        options_(options),
        plan_(plan),
        map_(*problem.object.heights()),
        width_((plan.contacts_O.col(1) - plan.contacts_O.col(0)).head<2>().norm()),
        height_(plan.contacts_O(2, 0)) {}

  std::vector<std::string> run() {
    const std::string misplaced = why_misplaced();
    if (!misplaced.empty()) {
      fault(misplaced);
      return faults_;
    }
    const WallMeasure wall = measure_wall(map_, plan_.contacts_O, options_.patch);
    if (!wall.is_wall) {
      fault("no wall between the contacts rises " + figure(options_.patch) + " m above them");
      return faults_;
    }
    for (const std::size_t side : {0U, 1U}) check_side(wall, side);
    const double friction = std::max(wall.friction[0], wall.friction[1]);
    if (!(plan_.friction >= friction - kEqual))
      fault("friction must be at least the " + figure(friction) + " that its slopes need");
    for (const std::string& what : faults_of_load(problem_, plan_, options_, friction, wall.rise))
      fault(what);
    return faults_;
  }

 private:
  void fault(const std::string& what) { faults_.push_back("wall: " + what); }

  /// Why there is no wall to look at between the contacts; empty if there may be one.
  std::string why_misplaced() const {
    if (!(width_ > 0)) return "both contacts are the same";
    if (!(height_ > kEqual)) return "the contacts are not above the support";
    const double widest = map_.cell * std::hypot(map_.heights.rows(), map_.heights.cols());
    return width_ <= widest ? "" : "the contacts are farther apart than the object is wide";
  }

  void check_side(const WallMeasure& wall, std::size_t side) {
    const std::string where = "contact " + std::to_string(side);
    if (!fits(wall, side, map_.cell)) {
      faults_.push_back(where + ": the wall ends " + figure(wall.beyond[side]) + " m beyond it");
    }
    if (wall.friction[side] > options_.friction + kEqual) {
      faults_.push_back(where + ": the wall slopes by a tangent of " + figure(wall.friction[side]) +
                        ", which exceeds the friction");
    }
  }

  const Problem& problem_;
  const Options& options_;
  const Plan& plan_;
  const geometry::HeightMap& map_;
  double width_, height_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of_wall(const Problem& problem, const Plan& plan,
                                        const Options& options) {
  return WallExamination(problem, plan, options).run();
}

}  // namespace graspless::pinch
