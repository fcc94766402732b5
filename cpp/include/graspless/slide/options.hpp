// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::slide {

enum class Search { paper, fast };

/// Table of the values: name and text.
constexpr auto choices(Search) {
  using planning::Choice;
  return std::array{
      Choice{Search::paper, "paper", "Algorithm 1 as written."},
      Choice{Search::fast, "fast",
             "Algorithm 1 with goals sampled to fit a start and connected to it directly first."}};
}

inline constexpr double kMaxDepth = 0.1;  ///< upper end of the range of depths [m]

/// Range of the uncertainty of a positive quantity, as a fraction of it.
inline constexpr auto kFraction = planning::Range::right_open(0, 1);

/// Options of the search; fields() describes them. Defaults are the paper's where it gives one.
struct Options {
  Search search = Search::fast;
  double pitch = 0.7853981633974483;
  double pitch_tolerance = 0.1;
  std::optional<double> min_depth;
  std::optional<double> max_depth;
  double root_scale = 100;
  double min_overhang = 0.02;
  double com_margin = 0.010;
  double tip_margin = 0.010;
  double rim_margin = 0.005;
  double lift_height = 0.08;
  double grasp_approach = 0.06;
  bool deep_grasp = false;
  bool refuse_lag = true;
  double friction_spread = 0.3;
  double mass_spread = 0.2;
  double com_spread = 0.005;
  double pad_spread = 0;
  double thickness_spread = 0.2;
  double height_spread = 0.003;
  double flexure_spread = 0.2;
  double position_spread = 0.003;
  double angle_spread = 0.0349;
  double tracking_spread = 0.001;
  double range = 0.1;
  double resolution = 0.01;
  double max_memory = 4e9;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Options&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"search", &Options::search, "", "Search algorithm."},
      Field{"pitch", &Options::pitch, "rad", "Angle between the finger and the surface.",
            Range::open(0, 1.5707963267948966), "beta_0"},
      Field{"pitch_tolerance", &Options::pitch_tolerance, "rad",
            "Largest deviation from the pitch while the object slides. The pitch must stay within "
            "(0, pi/2).",
            Range::open(0, 0.7853981633974483), "Delta_beta"},
      Field{"min_depth", &Options::min_depth, "m",
            "Least depth of the commanded fingertip below the object's top face. By default that "
            "of hand.finger_model.",
            Range::right_open(0, kMaxDepth), "Delta_Z^-"},
      Field{"max_depth", &Options::max_depth, "m",
            "Largest depth of the commanded fingertip below the object's top face. At least "
            "min_depth. By default that of hand.finger_model.",
            Range::right_open(0, kMaxDepth), "Delta_Z^+"},
      Field{"root_scale", &Options::root_scale, "",
            "Scale of the number of roots: larger values add roots more often.", Range::positive(),
            "N*, Eq. (5)"},
      Field{"min_overhang", &Options::min_overhang, "m",
            "Least length of the object beyond the edge that the hand can grasp.",
            Range::positive(), "u*"},
      Field{"com_margin", &Options::com_margin, "m",
            "Least distance of the centre of mass from the edge, on the support. In simulation the "
            "lift tipped some objects at 2 mm and none at 10 mm; the paper uses 0.",
            Range::not_negative()},
      Field{"tip_margin", &Options::tip_margin, "m",
            "Least distance of the fingertip's contact from the edge, on the support.",
            Range::not_negative()},
      Field{"rim_margin", &Options::rim_margin, "m",
            "Least distance of the contact from the object's outline at the start, at most half of "
            "the largest that the object allows. In simulation a pad that pressed on a rim lost "
            "the object.",
            Range::not_negative()},
      Field{"lift_height", &Options::lift_height, "m",
            "Clearance above the object before the hand moves around to grasp it.",
            Range::left_open(0, 1)},
      Field{"grasp_approach", &Options::grasp_approach, "m",
            "Length of the hand's straight final motion.", Range::left_open(0, 1)},
      Field{"deep_grasp", &Options::deep_grasp, "",
            "Grasp as near to the support's edge as the hand can, where the weight turns the "
            "object least in it. The paper's hand closes in the middle of what sticks out."},
      Field{
          "refuse_lag", &Options::refuse_lag, "",
          "Refuse slides in which the object may lag so far behind the finger, by the friction of "
          "pad and support, that the hand does not grasp it or the support does not hold it."},
      Field{"friction_spread", &Options::friction_spread, "",
            "Uncertainty of hand.pad_friction and of support.friction, each: a fraction of it.",
            kFraction},
      Field{"mass_spread", &Options::mass_spread, "",
            "Uncertainty of the object's mass: a fraction of it.", kFraction},
      Field{"com_spread", &Options::com_spread, "m", "Uncertainty of the object's centre of mass.",
            Range::not_negative()},
      Field{"pad_spread", &Options::pad_spread, "",
            "Part of the pad's length that may not bear, because the object is uneven or tilted: "
            "the rest of it may be at either end.",
            kFraction},
      Field{"thickness_spread", &Options::thickness_spread, "",
            "Uncertainty of the object's thickness: a fraction of it.", kFraction},
      Field{"height_spread", &Options::height_spread, "m",
            "Uncertainty of the height of the support.", Range::not_negative()},
      Field{
          "flexure_spread", &Options::flexure_spread, "",
          "Uncertainty of hand.flexure_length and hand.flexure_stiffness, each: a fraction of it.",
          kFraction},
      Field{"position_spread", &Options::position_spread, "m",
            "Uncertainty of the object's position at the start.", Range::not_negative()},
      Field{"angle_spread", &Options::angle_spread, "rad",
            "Uncertainty of the object's orientation at the start.", Range::not_negative()},
      Field{"tracking_spread", &Options::tracking_spread, "m",
            "Error with which the arm follows the plan while it presses.", Range::not_negative()},
      Field{"range", &Options::range, "rad",
            "Longest step of ConstrainedExtend, as the Euclidean norm over the joints.",
            Range::left_open(0, 1)},
      Field{"resolution", &Options::resolution, "rad",
            "Largest joint step between checked configurations. check() uses 0.01.",
            Range::closed(1e-4, 0.01)},
      Field{"max_memory", &Options::max_memory, "bytes", "Largest memory that the search may take.",
            Range::positive()});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const Options& options);

}  // namespace graspless::slide
