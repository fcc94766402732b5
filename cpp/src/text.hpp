// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers in messages. Every room may include this header.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace graspless {

constexpr double kDegree = 0.017453292519943295;  ///< [rad]

/// A number with so many significant digits. std::to_string() would write 1e-9 as 0.000000.
inline std::string figure(double value, int digits = 6) {
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

/// The parts of a sentence, with three significant digits in numbers.
template <class... Parts>
std::string say(const Parts&... parts) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << parts);
  return text.str();
}

/// All digits of an integer.
template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
std::string figure(Integer value) {
  return std::to_string(value);
}

/// Throws std::invalid_argument if a number is not what it must be.
template <typename Number>
void require(bool holds, const std::string& field, Number value, const std::string& must) {
  if (!holds) throw std::invalid_argument(field + " " + must + ", not " + figure(value));
}

/// The same for a number that must lie in [least, most].
template <typename Number>
void require_within(const std::string& field, Number value, std::common_type_t<Number> least,
                    std::common_type_t<Number> most, const std::string& unit = "") {
  if (value >= least && value <= most) return;
  require(false, field, value, "must lie in [" + figure(least) + ", " + figure(most) + "]" + unit);
}

}  // namespace graspless
