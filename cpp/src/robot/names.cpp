// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/names.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <stdexcept>

namespace graspless::robot {
namespace {

/// Letters to insert, remove or replace between two names, whatever their case (Levenshtein).
std::size_t edits(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t replaced = diagonal + (lower(a[i]) != lower(b[k]));
      diagonal = row[k + 1];
      row[k + 1] = std::min({replaced, row[k] + 1, row[k + 1] + 1});
    }
  }
  return row.back();
}

/// " (did you mean 'tool0'?)", or nothing where no name is like this one.
std::string hint(const std::string& name, const std::vector<std::string>& names) {
  const auto fewer = [&](const std::string& a, const std::string& b) {
    return edits(name, a) < edits(name, b);
  };
  const auto closest = std::min_element(names.begin(), names.end(), fewer);
  if (closest == names.end() || 3 * edits(name, *closest) > name.size()) return "";
  return " (did you mean '" + *closest + "'?)";
}

}  // namespace

int index_of(const std::string& name, const std::vector<std::string>& names,
             const std::string& what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw_unknown(name, names, what);
  return static_cast<int>(found - names.begin());
}

void throw_unknown(const std::string& name, const std::vector<std::string>& names,
                   const std::string& what) {
  std::string message = "unknown " + what + " '" + name + "'" + hint(name, names) + "; ";
  message += names.empty() ? "there are none" : "choose from ";
  for (const std::string& choice : names) {
    if (&choice != &names.front()) message += ", ";
    message += choice;
  }
  throw std::invalid_argument(message);
}

}  // namespace graspless::robot
