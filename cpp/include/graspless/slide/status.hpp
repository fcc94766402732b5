// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::slide {

/// Outcome of a query.
enum class Status {
  solved,
  start_in_collision,
  off_support,
  contact_lost,
  cannot_drag,
  no_start_root,
  no_goal_root,
  no_valid_pair,
  not_connected,
  interrupted,
  out_of_memory,
};

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::start_in_collision, "start_in_collision",
             "The robot touches something in its home configuration, or where it resumes a slide."},
      Choice{Status::off_support, "off_support",
             "The object of a slide to resume does not lie flat on the support."},
      Choice{Status::contact_lost, "contact_lost",
             "The finger of a slide to resume does not press on the object."},
      Choice{Status::cannot_drag, "cannot_drag",
             "The pad's friction cannot drag the object, wherever the finger presses."},
      Choice{Status::no_start_root, "no_start_root",
             "No configuration that presses on the object was found."},
      Choice{Status::no_goal_root, "no_goal_root",
             "No configuration that presses near an edge was found."},
      Choice{Status::no_valid_pair, "no_valid_pair",
             "Starts and goals were found, but no pair of them was valid."},
      Choice{Status::not_connected, "not_connected",
             "No valid pair was connected within the budget."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."},
      Choice{Status::out_of_memory, "out_of_memory",
             "The search would need more memory than options.max_memory."}};
}
GRASPLESS_API std::string to_string(Status status);

}  // namespace graspless::slide
