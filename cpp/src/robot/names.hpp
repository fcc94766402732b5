// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace graspless::robot {

template <typename Value>
bool contains(const std::vector<Value>& values, const Value& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// Index of `name` among `names`; throws std::invalid_argument that lists them all.
int index_of(const std::string& name, const std::vector<std::string>& names,
             const std::string& what);

/// Throws std::invalid_argument: "unknown link 'tol0' (did you mean 'tool0'?); choose from base,
/// tool0".
[[noreturn]] void throw_unknown(const std::string& name, const std::vector<std::string>& names,
                                const std::string& what);

template <typename Value>
std::vector<std::string> keys(const std::map<std::string, Value>& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

template <typename Value>
const Value& at(const std::map<std::string, Value>& map, const std::string& name,
                const std::string& what) {
  const auto found = map.find(name);
  if (found == map.end()) throw_unknown(name, keys(map), what);
  return found->second;
}

}  // namespace graspless::robot
