// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/report.hpp"

#include <algorithm>

#include "graspless/geometry/sampling.hpp"

#include "geometry/loops/classes.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

/// Larger than any object that a hand clasps [m].
constexpr double kMaxPlausibleExtent = 20;

std::string count(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::string describe(const Plateau& plateau) {
  return "from " + figure(plateau.lower, 3) + " to " + figure(plateau.upper, 3) + " m (ratio " +
         figure(plateau.ratio(), 3) + ")";
}

/// Advice for max_edge_length: the holes of any d.
std::string advice(const Filtration& filtration) {
  LoopOptions any;
  const std::vector<JudgedClass> classes = judged_classes(filtration, any);
  const auto hole = std::find_if(classes.begin(), classes.end(), [](const JudgedClass& judged) {
    return judged.kind == JudgedClass::Kind::found;
  });
  if (hole == classes.end()) return "; no other value gives a reliable hole";
  return "; a hole exists " + describe({hole->span.birth, hole->span.death, 1});
}

/// Explanation of why K_d has no loop at a given d.
std::string why_no_loop(const Filtration& filtration, double d, int num_alive) {
  std::string reason = "max_edge_length " + figure(d, 3) + " m ";
  const std::vector<Plateau> all = filtration.plateaus();
  if (filtration.complex(d).edges.cols() == 0) {
    reason += "is too small: no two points are closer; the spacing is about " +
              figure(spacing(filtration.points()), 3) + " m";
  } else if (num_alive > 0) {
    return "each of the " + count(static_cast<std::size_t>(num_alive), "loop") +
           " at max_edge_length " + figure(d, 3) + " m is a gap between points" +
           advice(filtration);
  } else if (!all.empty() && d <= all[0].lower) {
    reason += "is too small: the points do not form a loop";
  } else if (!all.empty() && d > all[0].upper) {
    reason += "is too large: every hole is filled";
  } else {
    reason += "leaves no loop";
  }
  return reason + advice(filtration);
}

/// Warns if most classes at a given d are gaps between points.
void warn_of_gaps(const Filtration& filtration, Loops& result) {
  const std::size_t listed =
      result.found.size() + result.uncertain.size() + result.meridians.size();
  const auto noise = static_cast<std::size_t>(result.noise);
  if (noise <= listed) return;
  result.warnings.push_back("max_edge_length " + figure(result.complex.max_edge_length, 3) +
                            " m may be too small: " + std::to_string(noise) + " of " +
                            count(noise + listed, "loop") + " are gaps between points" +
                            advice(filtration));
}

void warn_of_open_loops(Loops& result) {
  for (std::size_t i = 0; i < result.found.size(); ++i) {
    const Loop& loop = result.found[i];
    if (loop.gap == 0) continue;
    result.warnings.push_back("loop " + std::to_string(i) + " crosses a gap of " +
                              figure(loop.gap, 3) +
                              " m without points; the object may come free there");
  }
}

}  // namespace

std::vector<std::string> cloud_warnings(const Filtration& filtration) {
  std::vector<std::string> warnings;
  const Eigen::Matrix3Xd& points = filtration.points();
  const double extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  if (extent > kMaxPlausibleExtent) {
    warnings.push_back("the points span " + figure(extent, 3) +
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

std::string thinning_warning(std::size_t used) {
  return "the points lie at random distances from each other: " + std::to_string(used) +
         " of them, which are spread more evenly, are used, and small holes may be missed; sample "
         "the surface evenly, or more densely";
}

void report(const Filtration& filtration, const LoopOptions& options, Loops& result) {
  const bool d_is_given = options.max_edge_length > 0;
  if (d_is_given) warn_of_gaps(filtration, result);
  const std::string unclear =
      result.uncertain.empty() ? "" : count(result.uncertain.size(), "uncertain loop");
  if (!result.found.empty()) {
    result.status = LoopStatus::found;
    warn_of_open_loops(result);
    result.reason = count(result.found.size(), "loop") + " at max_edge_length " +
                    figure(result.complex.max_edge_length, 3) + " m";
    if (!d_is_given) result.reason += ", on the plateau " + describe(result.plateau);
    if (!unclear.empty()) result.reason += "; beside " + unclear;
  } else if (!unclear.empty()) {
    const auto seen = std::max_element(
        result.uncertain.begin(), result.uncertain.end(),
        [](const Loop& a, const Loop& b) { return a.seen_through < b.seen_through; });
    result.reason =
        unclear + (seen->seen_through > 0 ? "; the one seen through most: " : "; the shortest: ") +
        seen->reason;
  } else if (!result.meridians.empty()) {
    result.reason = "every loop runs around a thick handle instead of along it";
  } else if (d_is_given) {
    result.reason = why_no_loop(filtration, options.max_edge_length, result.noise);
  } else {
    result.reason = "every loop is a gap between points";
  }
  if (result.status == LoopStatus::found && !result.meridians.empty()) {
    result.reason +=
        "; discarded: " + count(result.meridians.size(), "loop") + " around a thick handle";
  }
}

}  // namespace graspless::geometry
