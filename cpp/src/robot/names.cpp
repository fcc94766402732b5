// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/names.hpp"

#include <algorithm>
#include <stdexcept>

namespace graspless::robot {

int index_of(const std::string& name, const std::vector<std::string>& names,
             const std::string& what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw_unknown(name, names, what);
  return static_cast<int>(found - names.begin());
}

void throw_unknown(const std::string& name, const std::vector<std::string>& names,
                   const std::string& what) {
  std::string message = "unknown " + what + " '" + name + "'; ";
  message += names.empty() ? "there are none" : "choose from ";
  for (const std::string& choice : names) {
    if (&choice != &names.front()) message += ", ";
    message += choice;
  }
  throw std::invalid_argument(message);
}

}  // namespace graspless::robot
