// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/slide/slide.hpp"
#include "graspless/slide/torsion.hpp"

#include "slide/contact.hpp"

/// The forces between finger, object and support at the rows of a slide.
namespace graspless::slide {

/// Row of a slide: how the finger presses, and the point about which the object turns.
struct PressedRow {
  Tip tip;               ///< commanded fingertip
  double depth;          ///< of the tip below the top face [m]
  Planar X_SO;           ///< pose of the object
  Eigen::Vector2d p_SM;  ///< centre of mass [m]
  Eigen::Vector2d p_SC;  ///< centre of pressure, if the finger did not bend or drag [m]
  double yaw;            ///< of the object [rad]
  double radius;         ///< mean distance of the object's points to the centre of pressure [m]
};

PressedRow pressed_row(const Problem& problem, const Tip& tip, const Planar& X_SO);

/// Returns the rows of a segment.
std::vector<PressedRow> pressed_rows(const Problem& problem, const Segment& slide);

/// Returns the rows of the plan's slide; none if it has no slide.
std::vector<PressedRow> pressed_rows(const Problem& problem, const Plan& plan);

/// The functions of torsion.hpp, for the rows of a slide.
double drag_load(const Problem& problem, const std::vector<PressedRow>& rows);
Trailing trailing(const Problem& problem, const std::vector<PressedRow>& rows);
Turning turning(const Problem& problem, const std::vector<PressedRow>& rows);

/// Returns the centre of pressure in S, without drag [m]. The finger presses with its pad, ahead of
/// the unbent tip.
Eigen::Vector2d pressure_center(const Problem& problem, const PressedRow& row);

/// Returns the first row after which drag may tip an object that is higher than half its width: the
/// support's friction acts below the finger and moves the centre of pressure ahead, by its
/// coefficient times the height of the face. Nothing if that stays on object and support.
std::optional<std::size_t> tipping_row(const Problem& problem, const Options& options,
                                       const std::vector<PressedRow>& rows);

constexpr double kGravity = 9.81;  ///< [m/s^2]

/// Weight of the object [N].
double weight(const Problem& problem);

/// Returns mu_s (N + m g) / (mu_p N), the force of the support's friction relative to that of the
/// pad. Also defined for an infinite press N [N].
double drag_ratio(const Problem& problem, double press);

}  // namespace graspless::slide
