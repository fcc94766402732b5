// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

namespace graspless::planning {

/// True if the name of a body, or a text with one, is that of an obstacle with a padding.
inline bool is_padded(const std::string& text) { return text.find("(padding ") != text.npos; }

constexpr const char* kLessPadding = "; a smaller padding may help";

/// A remedy for the contact of two bodies, if one has a padding.
inline std::string remedy(const std::string& a, const std::string& b) {
  return is_padded(a) || is_padded(b) ? kLessPadding : "";
}

inline std::string contact(const std::string& a, const std::string& b) {
  return "'" + a + "' touches '" + b + "'" + remedy(a, b);
}

/// The most frequent obstruction by an obstacle with a padding.
inline auto most_padded(const std::map<std::string, std::int64_t>& refusals) {
  auto most = refusals.end();
  for (auto it = refusals.begin(); it != refusals.end(); ++it) {
    if (is_padded(it->first) && (most == refusals.end() || it->second > most->second)) most = it;
  }
  return most;
}

/// End of the reason of a search that found nothing: what stopped it most often, and that it is
/// unfinished if the budget ended it. `refusals`: how often each obstruction was met.
inline std::string obstruction(const std::map<std::string, std::int64_t>& refusals,
                               bool is_unfinished) {
  const auto most = std::max_element(refusals.begin(), refusals.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  std::string text;
  if (most != refusals.end()) text += "; most frequent obstruction: " + most->first;
  if (const auto padded = most_padded(refusals); padded != refusals.end()) {
    if (padded != most) text += ", and " + padded->first;
    text += kLessPadding;
  }
  if (is_unfinished) text += "; the budget ran out before everything was tried";
  return text;
}

}  // namespace graspless::planning
