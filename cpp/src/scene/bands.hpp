// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proof that quantities stay in their bands on an edge, by bounds on parts of it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "graspless/scene/certificate.hpp"
#include "graspless/watch.hpp"

namespace graspless::scene {

/// Lower bound on how far inside their bands some quantities stay: the least of them.
struct Slack {
  double least = std::numeric_limits<double>::infinity();
  const char* of = "";
  const char* unit = "m";

  void add(double slack, const char* name, const char* its_unit = "m") {
    if (!(slack >= least)) *this = {slack, name, its_unit};
  }
  /// The doubt that a negative slack at `t` means.
  Doubt doubt(double t, Verdict verdict) const { return {{}, 0, t, verdict, of, -least, unit}; }
};

/// Divides the part of an edge from t = `from` to t = `to` until `slack(t, place, t, place)` proves
/// each piece; `place(t)` is what it depends on. With both places the same, it must be exact.
/// Returns the first doubt.
template <typename Place, typename PlaceAt, typename SlackOf>
std::optional<Doubt> find_doubt(double from, const Place& at_from, double to, const Place& at_to,
                                const PlaceAt& place, const SlackOf& slack) {
  constexpr double kSmallest = 1.0 / (1 << 16);  // a point moves by less than kFinest on it
  poll();
  const Slack here = slack(from, at_from, to, at_to);
  if (here.least >= 0) return std::nullopt;
  if (to - from <= kSmallest) return here.doubt(from, Verdict::undecided);
  const double middle = (from + to) / 2;
  const Place at_middle = place(middle);
  const Slack now = slack(middle, at_middle, middle, at_middle);
  if (!(now.least >= 0)) return now.doubt(middle, Verdict::refuted);
  auto found = find_doubt(from, at_from, middle, at_middle, place, slack);
  return found ? found : find_doubt(middle, at_middle, to, at_to, place, slack);
}

/// Same for an edge as a whole, its ends included.
template <typename PlaceAt, typename SlackOf>
std::optional<Doubt> find_doubt(const std::string& segment, std::size_t edge, const PlaceAt& place,
                                const SlackOf& slack) {
  const auto first = place(0.0), last = place(1.0);
  std::optional<Doubt> found;
  const Slack at_first = slack(0.0, first, 0.0, first), at_last = slack(1.0, last, 1.0, last);
  if (!(at_first.least >= 0)) {
    found = at_first.doubt(0, Verdict::refuted);
  } else if (!(at_last.least >= 0)) {
    found = at_last.doubt(1, Verdict::refuted);
  } else {
    found = find_doubt(0.0, first, 1.0, last, place, slack);
  }
  if (found) {
    found->segment = segment;
    found->row = edge + 1;
  }
  return found;
}

}  // namespace graspless::scene
