// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "graspless/clasp/clasp.hpp"

namespace graspless::clasp {
namespace {

void require(bool holds, const std::string& field, double value, const std::string& must) {
  if (holds) return;
  throw std::invalid_argument("options." + field + " " + must + ", not " + std::to_string(value));
}

void require_positive(const std::string& field, double value, double most) {
  require(value > 0 && value <= most, field, value,
          "must be positive and at most " + std::to_string(most));
}

}  // namespace

void validate(const Options& o) {
  require(o.min_linking >= 0 && o.min_linking < 1, "min_linking", o.min_linking,
          "must lie in (0, 1), or be 0 to be derived");
  require(o.targets >= 0 && o.targets <= 10000, "targets", o.targets,
          "must be 1 to 10000, or 0 to be derived");
  require(o.pre_expansions >= 0 && o.pre_expansions <= 1000000, "pre_expansions", o.pre_expansions,
          "must be 1 to 1000000, or 0 to be derived");
  require(o.random_probability >= 0 && o.random_probability < 1, "random_probability",
          o.random_probability, "must lie in [0, 1)");
  require(o.restart_cycles >= 0, "restart_cycles", o.restart_cycles, "must not be negative");
  require_positive("dt", o.dt, 1);
  require_positive("max_step", o.max_step, 1);
  require_positive("blend_distance", o.blend_distance, 1);
  require_positive("blend_slope", o.blend_slope, 1e4);
  require_positive("position_damping", o.position_damping, 10);
  require_positive("alignment_damping", o.alignment_damping, 10);
  require_positive("linking_damping", o.linking_damping, 10);
  require(o.patience >= 0 && o.patience <= 1e4, "patience", o.patience, "must lie in [0, 10000]");
  require(o.linking_weight >= 0 && o.linking_weight <= 100, "linking_weight", o.linking_weight,
          "must lie in [0, 100] m");
  require_positive("exploring_step", o.exploring_step, 2);
  require(o.max_connect_steps > 0, "max_connect_steps", o.max_connect_steps, "must be positive");
  require(o.resolution >= 1e-5 && o.resolution <= 0.01, "resolution", o.resolution,
          "must lie in [0.00001, 0.01], whose end is the step of check()");
  require(o.shortcut_rounds >= 0, "shortcut_rounds", o.shortcut_rounds, "must not be negative");
  validate(o.stability);
}

std::string to_string(Status status) {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::start_in_collision:
      return "start_in_collision";
    case Status::no_reliable_hole:
      return "no_reliable_hole";
    case Status::no_target_in_reach:
      return "no_target_in_reach";
    case Status::not_found:
      return "not_found";
    case Status::not_secure:
      return "not_secure";
    case Status::interrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace graspless::clasp
