// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/ascending.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>

#include "geometry/pulse.hpp"

namespace graspless::geometry {
namespace {

/// A whole number in the order of the doubles.
std::uint64_t key_of(double number) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  std::uint64_t bits = 0;
  number += 0.0;  // makes 0 of -0
  std::memcpy(&bits, &number, sizeof number);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

}  // namespace

std::vector<int> ascending(const std::vector<double>& numbers) {
  constexpr int kDigit = 11, kKey = 64;
  constexpr std::uint64_t kDigits = 1u << kDigit;
  struct Item {
    std::uint64_t key;
    int index;
  };
  std::vector<Item> items, sorted(numbers.size());
  items.reserve(numbers.size());
  for (const double number : numbers)
    items.push_back({key_of(number), static_cast<int>(items.size())});
  Pulse pulse;
  for (int shift = 0; shift < kKey; shift += kDigit) {
    const auto digit = [shift](const Item& item) { return item.key >> shift & (kDigits - 1); };
    std::array<int, kDigits + 1> next{};
    for (const Item& item : items) ++next[digit(item) + 1];
    if (std::find(next.begin(), next.end(), static_cast<int>(items.size())) != next.end())
      continue;  // all have the same digit
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Item& item : items) {
      pulse();
      sorted[next[digit(item)]++] = item;
    }
    std::swap(items, sorted);
  }
  std::vector<int> order;
  order.reserve(items.size());
  for (const Item& item : items) order.push_back(item.index);
  return order;
}

}  // namespace graspless::geometry
