// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "pinch/check_contacts.hpp"
#include "pinch/wall_measure.hpp"

namespace graspless::pinch {

using Eigen::Vector2d;

namespace {

constexpr double kEqual = 1e-6;         // heights [m], tangents
constexpr double kWeight = 9.81;        // of a kilogram [N]
constexpr double kMeasuredMass = 0.15;  // relative
constexpr double kHangs = 0.1;          // of an object that hangs from the hand [rad]

class WallExamination {
 public:
  WallExamination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem),
        options_(options),
        plan_(plan),
        map_(*problem.object.heights()),
        middle_((plan.contacts_O.col(0) + plan.contacts_O.col(1)).head<2>() / 2),
        across_((plan.contacts_O.col(1) - plan.contacts_O.col(0)).head<2>()),
        width_(across_.norm()),
        height_(plan.contacts_O(2, 0)) {
    across_ /= width_;
    along_ = Vector2d(across_.y(), -across_.x());
  }

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
    check_mass(friction, wall.rise);
    return faults_;
  }

 private:
  void fault(const std::string& what) { faults_.push_back("wall: " + what); }
  static std::string figure(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
  }

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

  /// The pads bear force, twist and tilt: see largest_mass().
  void check_mass(double friction, double rise) {
    const Vector2d arm = problem_.object.com().head<2>() - middle_;
    const std::optional<double> force = finger_force(problem_, plan_, options_);
    if (!force) {
      fault("the effort limit of a joint that closes the hand is unknown");
      return;
    }
    const double press = *force, mu = problem_.hand.pad_friction,
                 weight = kWeight * problem_.object.mass(),
                 swing = kHangs * std::max(0.0, height_ - problem_.object.com().z());
    const double left = mu - std::min(friction, plan_.friction), half = options_.patch - rise;
    const double along = std::max(0.0, std::abs(arm.dot(along_)) - swing),
                 across = std::max(0.0, std::abs(arm.dot(across_)) - swing);
    if (left <= 0 || (half <= 0 && across > 0)) {
      fault(left <= 0 ? "its slopes need all friction of the pads"
                      : "nobody saw a face as low as the pads reach");
      return;
    }
    const double slips = weight / (2 * left * press),
                 twists = weight * along / (4 * mu * options_.patch * press / 3),
                 tilts = across > 0 ? weight * across / (2 * half * press) : 0;
    const double load = std::max(std::sqrt(slips * slips + twists * twists), tilts);
    if (load > 1 + kMeasuredMass) {
      fault("the pads bear " + figure(problem_.object.mass() / load) + " kg there, it weighs " +
            figure(problem_.object.mass()) + " kg");
    }
    const double bears = problem_.object.mass() / load;
    if (!plan_.max_mass || !(*plan_.max_mass <= (1 + kMeasuredMass) * bears))
      fault("max_mass must be at most the " + figure(bears) + " kg that the pads bear");
  }

  const Problem& problem_;
  const Options& options_;
  const Plan& plan_;
  const geometry::HeightMap& map_;
  Vector2d middle_, across_, along_;
  double width_, height_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of_wall(const Problem& problem, const Plan& plan,
                                        const Options& options) {
  return WallExamination(problem, plan, options).run();
}

}  // namespace graspless::pinch
