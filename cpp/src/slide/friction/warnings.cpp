// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/friction/warnings.hpp"

#include <algorithm>
#include <iomanip>
#include <optional>
#include <sstream>

#include "slide/refusals.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

using Rows = std::vector<PressedRow>;

/// The pad's friction is too small to drag the object.
std::optional<Warning> of_drag(const Problem& problem, const Rows& rows, double beyond) {
  constexpr double kLargest = 10;  // beyond it the exact number says nothing more
  const double load = drag_load(problem, rows);
  if (load <= beyond) return std::nullopt;
  std::ostringstream out;
  out << std::setprecision(3) << ": the slide needs " << (load < kLargest ? "" : "more than ")
      << std::min(load, kLargest) << " times the friction that the pad has ("
      << std::setprecision(6) << "object.mass " << problem.object.mass() << " kg, support.friction "
      << problem.support.friction() << ", hand.pad_friction " << problem.hand.pad_friction << "); "
      << (problem.support.friction() < problem.hand.pad_friction
              ? "another seed may press nearer to the centre of mass"
              : "no seed helps while support.friction is not below hand.pad_friction");
  return Warning{"the fingertip's pad cannot drag the object", out.str()};
}

/// Eq. (2) lets the object turn with the finger; the pad's friction limits how fast. The object may
/// lag behind.
std::optional<Warning> of_torsion(const Problem& problem, const Rows& rows, double beyond) {
  constexpr double kSmallLag = 2;  // not worth a warning [deg]
  const Turning slide = turning(problem, rows);
  const double lag = slide.lag / kDegree;
  if (lag < kSmallLag * beyond) return std::nullopt;
  std::ostringstream out;
  out << std::setprecision(2) << slide.max_turn_rate / kDegree / 100
      << " deg/cm, but the pad's friction turns the object by at most "
      << slide.allowed_turn_rate / kDegree / 100 << " deg/cm: the object may lag behind by " << lag
      << " deg; a wider pad (hand.pad_width) or a smoother support (support.friction) helps";
  return Warning{"the slide turns by up to ", out.str()};
}

/// The object ends behind the plan, because the wrist gives way to friction.
std::optional<Warning> of_trailing(const Problem& problem, const Rows& rows, double beyond) {
  constexpr double kSmallTrail = 2e-3;  // not worth a warning [m]
  const Trailing slide = trailing(problem, rows);
  if (slide.left < kSmallTrail * beyond) return std::nullopt;
  return Warning{"the wrist gives way to the friction of the support",
                 ": the object trails " + in_mm(slide.sliding) +
                     " behind the plan while it slides, and ends " + in_mm(slide.left) +
                     " short of it; a larger hand.wrist_stiffness or a smoother support "
                     "(support.friction) helps"};
}

/// The fingers grasp too far from the centre of mass for their joints.
std::optional<Warning> of_weight(const Problem& problem, const std::optional<Bearing>& held,
                                 double beyond) {
  if (!held || problem.object.mass() <= beyond * held->max_mass) return std::nullopt;
  std::ostringstream out;
  out << std::setprecision(3) << held->max_mass << " kg where they grasp, with the centre of mass "
      << in_mm(held->lever) << " beyond their tips and " << in_mm(held->offset) << " aside, and "
      << in_mm(held->depth) << " of the object between them (object.mass " << std::setprecision(6)
      << problem.object.mass() << " kg); a larger options.min_overhang may help";
  return Warning{"the hand may lose the object when it lifts it: its fingers bear ", out.str()};
}

}  // namespace

std::vector<Warning> warnings(const Problem& problem, const std::vector<PressedRow>& rows,
                              const std::optional<Bearing>& held, double beyond) {
  std::vector<Warning> found;
  const auto add = [&found](const std::optional<Warning>& warning) {
    if (warning) found.push_back(*warning);
    return warning.has_value();
  };
  if (!add(of_drag(problem, rows, beyond))) {  // else these two mean nothing
    add(of_torsion(problem, rows, beyond));
    add(of_trailing(problem, rows, beyond));
  }
  add(of_weight(problem, held, beyond));
  return found;
}

}  // namespace graspless::slide
