// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace graspless::geometry {

inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Returns the word that begins at `at` or behind the spaces there, and moves `at` behind it. Empty
/// at the end of the text.
inline std::string_view next_word(std::string_view text, std::size_t& at) {
  const char* const end = text.data() + text.size();
  const char* const from = std::find_if_not(text.data() + at, end, is_space);
  const char* const to = std::find_if(from, end, is_space);
  at = static_cast<std::size_t>(to - text.data());
  return {from, static_cast<std::size_t>(to - from)};
}

/// Returns the number that a word is, under any locale; nothing if it is none.
inline std::optional<double> to_number(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || stop != end) return {};
  return number;
}

/// Start of a word, for messages.
inline std::string shortened(std::string_view word) { return std::string(word.substr(0, 40)); }

}  // namespace graspless::geometry
