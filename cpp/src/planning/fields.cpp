// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/fields.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace graspless::planning {

std::string to_string(const Range& range) {
  if (std::isinf(range.lower) && std::isinf(range.upper)) return "";
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << (range.lower_is_open ? "(" : "[") << range.lower << ", " << range.upper
       << (range.upper_is_open ? ")" : "]");
  return text.str();
}

void require_in_range(const std::string& name, double value, const Range& range,
                      const std::string& unit, const std::string& text) {
  if (range.contains(value) || to_string(range).empty()) return;
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message.precision(10);
  message << name << " must lie in " << to_string(range) << (unit.empty() ? "" : " ") << unit
          << ", not " << value << ". " << text;
  throw std::invalid_argument(message.str());
}

}  // namespace graspless::planning
