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

/// std::to_string() writes all digits of an integer.
template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
std::string figure(Integer, int = 0) = delete;

/// Throws std::invalid_argument if a number is not what it must be.
inline void require(bool holds, const std::string& field, double value, const std::string& must) {
  if (!holds) throw std::invalid_argument(field + " " + must + ", not " + figure(value));
}

}  // namespace graspless
