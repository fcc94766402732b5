// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

namespace graspless::planning {

/// End of the reason of a search that found nothing: what stopped it most often, and that it is
/// unfinished if the budget ended it. `refusals`: how often each obstruction was met.
inline std::string obstruction(const std::map<std::string, std::int64_t>& refusals,
                               bool is_unfinished) {
  const auto most = std::max_element(refusals.begin(), refusals.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  std::string text;
  if (most != refusals.end()) text += "; most frequent obstruction: " + most->first;
  if (is_unfinished) text += "; the budget ran out before everything was tried";
  return text;
}

}  // namespace graspless::planning
