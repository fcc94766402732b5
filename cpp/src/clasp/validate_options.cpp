// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>
#include <stdexcept>
#include <string>

#include "graspless/clasp/clasp.hpp"

namespace graspless::clasp {
namespace {

constexpr double kLeast = 1e-6;
constexpr int kMost = 10000;

void require(bool holds, const std::string& field, double value, const std::string& must) {
  if (holds) return;
  std::ostringstream text;
  text.precision(10);
  text << "options." << field << " " << must << ", not " << value;
  throw std::invalid_argument(text.str());
}

/// Much less than kLeast loses itself in rounding, and so do the damping's squares.
void require_positive(const std::string& field, double value, double most) {
  std::ostringstream must;
  must << "must lie in [" << kLeast << ", " << most << "]";
  require(value >= kLeast && value <= most, field, value, must.str());
}

/// Counts are bounded: no clock interrupts what is counted.
void require_count(const std::string& field, int value, int least, int most,
                   const std::string& if_zero = "") {
  require(value >= least && value <= most, field, value,
          "must lie in [" + std::to_string(least) + ", " + std::to_string(most) + "]" + if_zero);
}

}  // namespace

void validate(const Options& o) {
  require(o.min_linking >= 0 && o.min_linking < 1, "min_linking", o.min_linking,
          "must lie in (0, 1), or be 0 to be derived");
  require_count("targets", o.targets, 0, kMost, "; 0 to be derived");
  require_count("pre_expansions", o.pre_expansions, 0, kMost, "; 0 to be derived");
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
  require(o.patience >= 0 && o.patience <= 1e6, "patience", o.patience, "must lie in [0, 1e6]");
  require(o.linking_weight >= 0 && o.linking_weight <= 100, "linking_weight", o.linking_weight,
          "must lie in [0, 100] m");
  require_positive("exploring_step", o.exploring_step, 2);
  require_count("max_connect_steps", o.max_connect_steps, 1, kMost);
  require(o.resolution >= 1e-4 && o.resolution <= 0.01, "resolution", o.resolution,
          "must lie in [0.0001, 0.01], at most the step of check()");
  require_count("shortcut_rounds", o.shortcut_rounds, 0, kMost);
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
