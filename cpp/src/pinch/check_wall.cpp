// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "graspless/watch.hpp"

#include "pinch/check_contacts.hpp"

namespace graspless::pinch {

using Eigen::Vector2d;

namespace {

constexpr double kEqual = 1e-6;         // heights [m]
constexpr double kWeight = 9.81;        // of a kilogram [N]
constexpr double kMeasured = 0.10;      // of angles that are measured in two ways [rad]
constexpr double kMeasuredMass = 0.15;  // relative
constexpr double kHangs = 0.1;          // of an object that hangs from the hand [rad]
// Tangents: a pad touches all of an upright face, and with its end one that leans so much more.
constexpr double kUprightFace = 0.1, kFlatter = 0.2;
constexpr double kSeenPart = 0.003;  // of the height of a cell, at least [m]
constexpr int kLines = 33;           // across the wall

/// One line across a wall, in the plane of the closing direction: where the wall ends to the side
/// of the first and of the second contact, at their height and above them [m].
struct Crossing {
  bool is_wall = false;
  std::array<double, 2> out{}, out_above{}, underside{};
  std::array<bool, 2> is_seen{};
};

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
        height_(plan.contacts_O(2, 0)),
        above_(height_ + options.patch - kEqual) {
    across_ /= width_;
    along_ = Vector2d(across_.y(), -across_.x());
  }

  std::vector<std::string> run() {
    const std::string misplaced = why_misplaced();
    if (!misplaced.empty()) {
      fault(misplaced);
      return faults_;
    }
    std::vector<double> u;
    std::vector<Crossing> lines;
    for (int i = 0; i < kLines; ++i) {
      u.push_back(options_.patch * (2.0 * i / (kLines - 1) - 1));
      lines.push_back(crossing(u.back()));
      if (!lines.back().is_wall) {
        fault("no wall between the contacts rises " + figure(options_.patch) + " m above them");
        return faults_;
      }
    }
    double friction = 0, rise = 0;
    for (const std::size_t side : {0U, 1U}) {
      const auto [slope, lean] = check_side(u, lines, side);
      friction = std::max(friction, std::hypot(slope, lean));
      rise = std::max({rise, hidden(side), options_.patch * (lean - kUprightFace) / kFlatter});
    }
    // A face leans by half a cell more or less, over the height that is measured.
    const double measured = kMeasured + map_.cell / (2 * options_.patch);
    if (std::atan(plan_.friction) < std::atan(friction) - measured)
      fault("friction must be at least the " + figure(friction) + " that its slopes need");
    check_mass(friction, std::min(rise, options_.patch));
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

  double height_at(double u, double v) const { return map_.at(middle_ + u * along_ + v * across_); }

  /// Looks for the highest place between the contacts, and walks from there to both sides.
  Crossing crossing(double u) const {
    poll();
    const double step = map_.cell / 8;
    double highest = 0, from = 0;
    for (double v = -width_ / 2; v <= width_ / 2; v += step) {
      if (height_at(u, v) > highest) {
        highest = height_at(u, v);
        from = v;
      }
    }
    Crossing line;
    line.is_wall = highest >= above_;
    for (const int side : {0, 1}) {
      const double way = side == 0 ? -step : step;
      const auto i = static_cast<std::size_t>(side);
      double v = from;
      line.out_above[i] = std::abs(v);
      for (; height_at(u, v) >= height_; v += way) {
        if (height_at(u, v) >= above_) line.out_above[i] = side == 0 ? -v : v;
      }
      line.out[i] = side == 0 ? -v : v;
      line.underside[i] = map_.underside_at(middle_ + u * along_ + (v - way) * across_);
      line.is_seen[i] = height_at(u, v - way) > line.underside[i] + kSeenPart;
    }
    return line;
  }

  /// Returns the slopes of the face of a side: along the wall and upwards.
  std::pair<double, double> check_side(const std::vector<double>& u,
                                       const std::vector<Crossing>& lines, std::size_t side) {
    double uu = 0, uv = 0, rise = 0, seen = 0, farthest = -1e9;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double out = lines[i].out[side];
      uu += u[i] * u[i], uv += u[i] * out;  // u is symmetric
      if (lines[i].is_seen[side]) rise += out - lines[i].out_above[side], seen += 1;
      farthest = std::max(farthest, out);
    }
    const std::string where = "contact " + std::to_string(side);
    if (std::abs(farthest - width_ / 2) > map_.cell) {
      faults_.push_back(where + ": the wall ends " + figure(farthest - width_ / 2) +
                        " m beyond it");
    }
    const double slope = uv / uu, lean = seen > 0 ? rise / seen / options_.patch : 0,
                 need = std::hypot(slope, lean);
    if (std::atan(need) > std::atan(options_.friction) + kMeasured) {
      faults_.push_back(where + ": the wall slopes by a tangent of " + figure(need) +
                        ", which exceeds the friction");
    }
    return {slope, lean};
  }

  /// How far the middle of a contact is above the middle of its pad. The face is as low as half of
  /// what was seen of it, which must be 5 mm along the wall, at most three times the half length of
  /// the pad from its middle.
  double hidden(std::size_t side) const {
    constexpr double kSeen = 0.005, kApart = 0.001;  // [m]
    std::vector<double> found;
    for (const double way : {-1.0, 1.0}) {
      for (double u = way > 0 ? 0 : -kApart; std::abs(u) <= 3 * options_.patch; u += way * kApart) {
        const Crossing line = crossing(u);
        if (!line.is_wall) break;
        if (line.is_seen[side]) found.push_back(line.underside[side]);
      }
    }
    if (static_cast<double>(found.size()) * kApart < kSeen) return options_.patch;
    std::sort(found.begin(), found.end());
    const double lowest = found[found.size() / 2];
    return std::clamp((lowest - height_ + options_.patch) / 2, 0.0, options_.patch);
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
  double width_, height_, above_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of_wall(const Problem& problem, const Plan& plan,
                                        const Options& options) {
  return WallExamination(problem, plan, options).run();
}

}  // namespace graspless::pinch
