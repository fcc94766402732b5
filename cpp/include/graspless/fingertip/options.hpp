// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "graspless/export.hpp"
#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/stability.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::fingertip {

enum class Search { dijkstra, paper, fast };

/// Table of the values: name and text.
constexpr auto choices(Search) {
  using planning::Choice;
  return std::array{
      Choice{Search::dijkstra, "dijkstra",
             "Uniform-cost search over the manipulation-feasibility graph."},
      Choice{Search::paper, "paper",
             "A* with the heuristic of Eq. (11), corrected where it is not admissible."},
      Choice{Search::fast, "fast",
             "Lazy best-first search over finger placements, bounded by support functions."}};
}

/// Options of the search; fields() describes them. Defaults are the paper's where it gives one.
struct Options {
  Search search = Search::fast;
  int locations_per_side = 7;
  double location_spacing = 0;
  int cone_edges = 6;
  int samples_per_arc = 3;
  double min_stability = 0.5;
  double regrasp_cost = 100;
  double stability_weight = 0.01;
  mechanics::Matrix6Xd disturbance_directions = mechanics::disturbance_directions();
  mechanics::Compliance compliance;
  double max_yield = 1e-3;
  int max_regrasps = 8;
  int threads = 1;
  double max_memory = 4e9;
  bool explain = true;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Options&) {
  using planning::Field, planning::Range;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return std::make_tuple(
      Field{"search", &Options::search, "",
            "Search algorithm. All find the same cost, but fast may find a higher one on a lattice "
            "with regrasps: `lower_bound` says so."},
      Field{"locations_per_side", &Options::locations_per_side, "",
            "Number of fingertip locations along each side of a face's rectangle, centred in "
            "cells.",
            Range::closed(1, 10000)},
      Field{"location_spacing", &Options::location_spacing, "m",
            "Distance between locations, instead of locations_per_side. 0: use "
            "locations_per_side.",
            Range::not_negative()},
      Field{"cone_edges", &Options::cone_edges, "", "Number of edges of a friction cone.",
            Range::closed(3, 64), "s"},
      Field{"samples_per_arc", &Options::samples_per_arc, "",
            "Number of instants checked between two poses of the object.", Range::closed(1, 1000),
            "P"},
      Field{"min_stability", &Options::min_stability, "N",
            "Least disturbance that every instant must withstand.", Range::left_open(0, 1e9),
            "z_min"},
      Field{"regrasp_cost", &Options::regrasp_cost, "m",
            "Cost of one regrasp, as a displacement of the object.", Range::positive(),
            "X_regr, Eq. (10)"},
      Field{"stability_weight", &Options::stability_weight, "N",
            "Weight of stability in the cost of a motion: its displacement times "
            "1 + stability_weight / stability. 0: displacement alone.",
            Range::not_negative(), "X_stab, Eq. (9)"},
      Field{"disturbance_directions",
            &Options::disturbance_directions,
            "",
            "Directions of the disturbances in scaled wrench space, forces first: a column each in "
            "C++, a row each in Python. They must positively span that space.",
            {},
            "l_i"},
      Field{"compliance", &Options::compliance, "",
            "Springs at the contacts, for nominal forces, compliant_stability and withstands."},
      Field{"max_yield", &Options::max_yield, "m",
            "Largest distance by which the springs may let a corner of the object yield to a "
            "disturbance that `withstands` counts.",
            Range::positive()},
      Field{"max_regrasps", &Options::max_regrasps, "", "Maximum number of regrasps.",
            Range::closed(0, 1000)},
      Field{"threads", &Options::threads, "", "Number of threads.", Range::closed(1, 256)},
      Field{"max_memory", &Options::max_memory, "bytes",
            "Largest memory of the search's tables; a larger search is refused.",
            Range::left_open(0, kInfinity)},
      Field{"explain", &Options::explain, "",
            "On failure, find by bisection which single relaxation of friction, force limit or "
            "min_stability helps."});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const Options& options);

}  // namespace graspless::fingertip
