// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/report.hpp"

#include <sstream>

#include "graspless/geometry/sampling.hpp"

namespace graspless::geometry {
namespace {

/// Larger than any object that a hand clasps [m].
constexpr double kMaxPlausibleExtent = 20;

std::string count(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::string describe(const Plateau& plateau) {
  return "from " + short_number(plateau.lower) + " to " + short_number(plateau.upper) +
         " m (ratio " + short_number(plateau.ratio()) + ")";
}

/// Advice for max_edge_length: the widest plateau.
std::string advice(const Filtration& filtration) {
  const std::vector<Plateau> all = filtration.plateaus();
  if (all.empty()) return "; no other value gives a lasting loop";
  const auto loops = static_cast<std::size_t>(all[0].loops);
  return "; " + count(loops, "loop") + (loops == 1 ? " exists " : " exist ") + describe(all[0]);
}

/// Explanation of why K_d has no loop at a given d.
std::string why_no_loop(const Filtration& filtration, double d) {
  std::string reason = "max_edge_length " + short_number(d) + " m ";
  const std::vector<Plateau> all = filtration.plateaus();
  if (filtration.complex(d).edges.cols() == 0) {
    reason += "is too small: no two points are closer; the spacing is about " +
              short_number(spacing(filtration.points())) + " m";
  } else if (!all.empty() && d <= all[0].lower) {
    reason += "is too small: the points do not form a loop";
  } else if (!all.empty() && d > all[0].upper) {
    reason += "is too large: every hole is filled";
  } else {
    reason += "leaves no loop";
  }
  return reason + advice(filtration);
}

/// Warns if most loops die before the widest plateau begins.
void warn_of_gaps(const Filtration& filtration, Loops& result) {
  const std::vector<Plateau> all = filtration.plateaus();
  if (all.empty()) return;
  std::size_t gaps = 0;
  for (const auto* loops : {&result.loops, &result.meridians}) {
    for (const Loop& loop : *loops) gaps += loop.death <= all[0].lower;
  }
  const std::size_t found = result.loops.size() + result.meridians.size();
  if (2 * gaps <= found) return;
  result.warnings.push_back("max_edge_length " + short_number(result.complex.max_edge_length) +
                            " m may be too small: " + std::to_string(gaps) + " of " +
                            count(found, "loop") + " are gaps between points" + advice(filtration));
}

void warn_of_open_loops(Loops& result) {
  for (std::size_t i = 0; i < result.loops.size(); ++i) {
    const Loop& loop = result.loops[i];
    if (loop.gap == 0) continue;
    result.warnings.push_back("loop " + std::to_string(i) + " crosses a gap of " +
                              short_number(loop.gap) +
                              " m without points; the object may come free there");
  }
}

}  // namespace

std::string short_number(double value) {
  std::ostringstream out;
  out.precision(3);
  out << value;
  return out.str();
}

std::vector<std::string> cloud_warnings(const Filtration& filtration) {
  std::vector<std::string> warnings;
  const Eigen::Matrix3Xd& points = filtration.points();
  const double extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  if (extent > kMaxPlausibleExtent) {
    warnings.push_back("the points span " + short_number(extent) +
                       " m, which looks like millimetres; lengths are in metres");
  }
  const Eigen::Index equal = points.cols() - filtration.num_vertices();
  if (equal > 0) {
    warnings.push_back(count(static_cast<std::size_t>(equal), "point") +
                       (equal == 1 ? " equals another" : " equal others") +
                       "; equal points count once");
  }
  return warnings;
}

std::string no_plateau_reason(const Filtration& filtration, const LoopOptions& options) {
  const std::vector<Plateau> all = filtration.plateaus();
  if (all.empty()) return "no reliable hole: no max_edge_length gives a lasting loop";
  const std::string widest =
      "no reliable hole: the widest plateau of the Betti curve is " + describe(all[0]);
  if (all[0].ratio() < options.min_ratio) {
    return widest + ", below min_ratio " + short_number(options.min_ratio);
  }
  return widest + ", below lowest_ratio " + short_number(options.lowest_ratio);
}

void report(const Filtration& filtration, Loops& result) {
  const double d = result.complex.max_edge_length;
  const bool chosen = result.plateau.loops > 0;
  if (!chosen) warn_of_gaps(filtration, result);
  if (result.loops.empty()) {
    result.reason = result.meridians.empty()
                        ? why_no_loop(filtration, d)
                        : "every loop runs around a thick handle instead of along it";
    return;
  }
  result.status = LoopStatus::found;
  warn_of_open_loops(result);
  result.reason =
      count(result.loops.size(), "loop") + " at max_edge_length " + short_number(d) + " m";
  if (chosen) result.reason += ", on the plateau " + describe(result.plateau);
  if (!result.meridians.empty()) {
    result.reason +=
        "; discarded: " + count(result.meridians.size(), "loop") + " around a thick handle";
  }
}

}  // namespace graspless::geometry
