// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/fields.hpp"

#include <array>
#include <cmath>

#include "complaint.hpp"

namespace graspless::planning {

enum class Fruit { apple, pear };
constexpr auto choices(Fruit) {
  return std::array{Choice{Fruit::apple, "apple", "A."}, Choice{Fruit::pear, "pear", "B."}};
}

struct Sample {
  double length = 1;
  int count = 2;
  bool flag = false;
  Fruit fruit = Fruit::pear;
};
constexpr auto fields(const Sample&) {
  return std::make_tuple(
      Field{"length", &Sample::length, "m", "Length of it.", Range::left_open(0, 2)},
      Field{"count", &Sample::count, "", "Number of it.", Range::closed(1, 10)},
      Field{"flag", &Sample::flag, "", "True if it is."},
      Field{"fruit", &Sample::fruit, "", "Kind of it."});
}

namespace {

TEST(Range, ContainsItsClosedEndsOnly) {
  for (const Range& range :
       {Range::open(0, 1), Range::closed(0, 1), Range::left_open(0, 1), Range::right_open(0, 1)}) {
    EXPECT_EQ(range.contains(0), !range.lower_is_open);
    EXPECT_EQ(range.contains(1), !range.upper_is_open);
    EXPECT_TRUE(range.contains(0.5));
    EXPECT_FALSE(range.contains(-1e-9));
    EXPECT_FALSE(range.contains(1 + 1e-9));
    EXPECT_FALSE(range.contains(std::nan("")));
  }
  EXPECT_FALSE(Range::positive().contains(HUGE_VAL));
  EXPECT_TRUE(Range::left_open(0, HUGE_VAL).contains(HUGE_VAL));
}

TEST(Range, IsWrittenAsAnInterval) {
  EXPECT_EQ(to_string(Range::left_open(0, 0.02)), "(0, 0.02]");
  EXPECT_EQ(to_string(Range::not_negative()), "[0, inf)");
  EXPECT_EQ(to_string(Range{}), "");
}

TEST(Fields, TheFirstValueOutOfRangeIsNamed) {
  Sample sample;
  require_in_range("sample.", sample);
  sample.count = 11;
  EXPECT_EQ(complaint([&] { require_in_range("sample.", sample); }),
            "sample.count must lie in [1, 10], not 11. Number of it.");
  sample.length = 0;
  EXPECT_EQ(complaint([&] { require_in_range("sample.", sample); }),
            "sample.length must lie in (0, 2] m, not 0. Length of it.");
  sample = {};
  sample.fruit = static_cast<Fruit>(7);
  EXPECT_EQ(complaint([&] { require_in_range("sample.", sample); }),
            "sample.fruit must be one of apple, pear");
}

TEST(Choices, GiveEachValueItsName) {
  EXPECT_EQ(name_of(Fruit::pear), "pear");
  EXPECT_EQ(name_of(static_cast<Fruit>(7)), "unknown");
}

}  // namespace
}  // namespace graspless::planning
