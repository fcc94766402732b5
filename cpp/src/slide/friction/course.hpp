// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slide/friction/pressed.hpp"
#include "slide/placement.hpp"

/// Where friction takes the object: the integration behind tube.hpp.
namespace graspless::slide {

/// Result of the integration of one slide.
struct Course {
  Tube tube;
  std::vector<Planar> ends;  ///< pose of the object in S after the slide, in each world
};

Course course(const Problem& problem, const Options& options, const std::vector<PressedRow>& rows);

/// Slide in which the pad moves and turns evenly, at constant depth and the pitch beta_0.
struct EvenSlide {
  Planar tip_start, tip_goal;  ///< effective tips
  Planar object_start;
  double depth;  ///< [m]
};

/// Estimates where the object ends in the worlds with the weakest pad, and with one that bears at
/// one of its ends.
std::vector<Planar> weakest_ends(const Problem& problem, const Options& options,
                                 const EvenSlide& slide);

/// Largest deviations of a slide's ends from its plan.
struct Lag {
  double position = 0, angle = 0;  ///< [m, rad]
};
Lag largest_lag(const Problem& problem, const std::vector<Planar>& ends, const Planar& object_goal);

/// Tolerance of a grasp whose middle is at the rim of the object, or beside it by round-off [m].
inline constexpr double kGraspGive = 0.002;

/// Largest lag of a slide: a pad that slips by more may lose the object. In simulation, tilts of an
/// object by 1 degree made slides with 9 to 13 degrees end 50 to 160 degrees off.
inline constexpr Lag kMostLag{0.010, 0.0873};

/// Returns the condition that friction breaks at one of the ends: the lag is at most kMostLag, the
/// centre of mass is on the support, also if the object rests on its rim, and the middle of the
/// planned grasp (in S) is on the object, if it is grasped. Nothing if all hold. The margins of the
/// plan (com_margin, min_overhang) are for the other errors.
std::optional<std::string> broken_by_lag(const Problem& problem, const Planar& object_goal,
                                         const std::optional<Eigen::Vector2d>& grasp,
                                         const std::vector<Planar>& ends);

}  // namespace graspless::slide
