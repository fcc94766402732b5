// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/names.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace graspless::robot {
namespace {

constexpr std::size_t kLongest = 100;  // name with a hint [letters]

/// Letters to insert, remove, replace or swap with the next one between two names, whatever their
/// case (Damerau and Levenshtein).
std::size_t edits(const std::string& a, const std::string& b) {
  const auto differ = [](char c, char d) {
    return std::tolower(static_cast<unsigned char>(c)) !=
           std::tolower(static_cast<unsigned char>(d));
  };
  std::vector<std::size_t> last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::vector<std::size_t> before = std::exchange(last, row);
    row[0] = i + 1;
    for (std::size_t k = 0; k < b.size(); ++k) {
      row[k + 1] = std::min({last[k] + differ(a[i], b[k]), row[k] + 1, last[k + 1] + 1});
      if (i > 0 && k > 0 && !differ(a[i], b[k - 1]) && !differ(a[i - 1], b[k])) {
        row[k + 1] = std::min(row[k + 1], before[k - 1] + 1);
      }
    }
  }
  return row.back();
}

/// " (did you mean 'tool0'?)", or nothing unless one name is more like this one than all others.
std::string hint(const std::string& name, const std::vector<std::string>& names) {
  if (name.size() > kLongest) return "";
  const std::string* closest = nullptr;
  std::size_t fewest = name.size() / 3 + 1;
  for (const std::string& choice : names) {
    if (choice.size() > name.size() + name.size() / 3) continue;
    const std::size_t changes = edits(name, choice);
    if (changes <= fewest) closest = changes < fewest ? &choice : nullptr;
    fewest = std::min(fewest, changes);
  }
  return closest ? " (did you mean '" + *closest + "'?)" : "";
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
