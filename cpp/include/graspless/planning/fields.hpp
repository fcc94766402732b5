// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables of options, statistics and status values. Every such struct has beside it one function
// fields(), every enum one function choices(). Validation, bindings, task files and the reference
// page docs/reference/options.md are made from these tables.
#pragma once

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>

#include "graspless/export.hpp"

namespace graspless::planning {

/// Interval of allowed values; by default, every number.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_is_open = true;
  bool upper_is_open = true;

  static constexpr Range closed(double lower, double upper) { return {lower, upper, false, false}; }
  static constexpr Range open(double lower, double upper) { return {lower, upper, true, true}; }
  static constexpr Range left_open(double lower, double upper) {
    return {lower, upper, true, false};
  }
  static constexpr Range right_open(double lower, double upper) {
    return {lower, upper, false, true};
  }
  static constexpr Range positive() { return {0}; }
  static constexpr Range not_negative() { return right_open(0, Range{}.upper); }

  constexpr bool contains(double value) const {
    return (lower_is_open ? value > lower : value >= lower) &&
           (upper_is_open ? value < upper : value <= upper);
  }
};

/// "(0, 0.02]"; empty for every number.
GRASPLESS_API std::string to_string(const Range& range);

/// Description of one member of a struct.
template <class Struct, class Value>
struct Field {
  const char* name;
  Value Struct::*member;
  const char* unit;         ///< "m"; empty for counts, ratios and text
  const char* text;         ///< one sentence or two
  Range range = {};         ///< of numbers
  const char* source = "";  ///< section or equation of the planner's paper; empty: not from there
};
/// @cond
template <class Struct, class Value>
Field(const char*, Value Struct::*, const char*, const char*, Range = {}, const char* = "")
    -> Field<Struct, Value>;
/// @endcond

/// Description of one value of an enum.
template <class Enum>
struct Choice {
  Enum value;
  const char* name;
  const char* text;
};
/// @cond
template <class Enum>
Choice(Enum, const char*, const char*) -> Choice<Enum>;
/// @endcond

/// Name of an enum's value in its table of choices().
template <class Enum>
std::string name_of(Enum value) {
  for (const auto& choice : choices(Enum{})) {
    if (choice.value == value) return choice.name;
  }
  return "unknown";
}

/// Throws std::invalid_argument that states name, value, range, unit and text, unless the value
/// lies in the range.
GRASPLESS_API void require_in_range(const std::string& name, double value, const Range& range,
                                    const std::string& unit, const std::string& text);

/// Throws std::invalid_argument that states name and choices, unless an enum has the value.
template <class Enum>
void require_choice(const std::string& name, Enum value) {
  std::string names;
  for (const auto& choice : choices(Enum{})) {
    if (choice.value == value) return;
    names += (names.empty() ? "" : ", ") + std::string(choice.name);
  }
  throw std::invalid_argument(name + " must be one of " + names);
}

/// The same for all members of a struct. The message is about the first member outside its range,
/// whose name follows `prefix`.
template <class Struct>
void require_in_range(const std::string& prefix, const Struct& values) {
  const auto require = [&](const auto& field) {
    const auto& value = values.*field.member;
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::optional<double>>) {
      if (value) require_in_range(prefix + field.name, *value, field.range, field.unit, field.text);
    } else if constexpr (std::is_enum_v<Value>) {
      require_choice(prefix + field.name, value);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      require_in_range(prefix + field.name, static_cast<double>(value), field.range, field.unit,
                       field.text);
    }
  };
  std::apply([&](const auto&... field) { (require(field), ...); }, fields(values));
}

}  // namespace graspless::planning
