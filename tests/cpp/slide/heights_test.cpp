// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slides of objects that are no prisms: plates and bowls, pressed where they are level.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "slide/placement.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

using Eigen::Vector2d;

constexpr double kRadius = 0.075, kMiddle = 0.045, kBottom = 0.006, kRim = 0.02;  // [m]

/// A disc whose height depends on the place.
Object round_object(const std::function<double(const Vector2d&)>& height) {
  geometry::HeightMap map;
  map.corner = {-0.08, -0.08};
  map.cell = 0.005;
  map.heights.setZero(32, 32);
  for (Eigen::Index i = 0; i < 32; ++i) {
    for (Eigen::Index j = 0; j < 32; ++j) {
      const Vector2d cell(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      const Vector2d p = map.corner + map.cell * cell;
      if (p.norm() <= kRadius) map.heights(i, j) = height(p);
    }
  }
  return Object::from_polygon("plate", disc(kRadius, 40, {0, 0}), kRim).with_heights(map);
}

double plate_height(const Vector2d& p) {
  return kBottom + (kRim - kBottom) * std::max(0.0, p.norm() - kMiddle) / (kRadius - kMiddle);
}

Problem plate_problem() {
  return make_problem(tables()[0], round_object(plate_height), flat(0.65, 0.1, 0.3));
}

TEST(SlideHeights, APlateIsPressedInItsMiddle) {
  const Object plate = round_object(plate_height);
  EXPECT_NEAR(plate.top(), kBottom, 1e-3);
  EXPECT_EQ(plate.thickness(), kRim);
  const Problem problem = plate_problem();
  for (const auto i : contact_points(problem, {})) EXPECT_LE(plate.points().col(i).norm(), kMiddle);
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Plan found = plan(problem, {}, seeded(seed));
    ASSERT_TRUE(found) << seed << ": " << found.reason;
    EXPECT_TRUE(check(problem, found).empty()) << check(problem, found).front();
    // The hand closes around the rim, not around the bottom.
    EXPECT_NEAR(found.X_WH_grasp.translation().z(), kRim / 2, 2e-3);
  }
}

TEST(SlideHeights, APrismIsPressedOnItsTop) {
  const Object& square = objects()[0];
  EXPECT_EQ(square.top(), square.thickness());
  EXPECT_EQ(square.height_near({0.3, 0}, 0.01), square.thickness());
  EXPECT_TRUE(square.has_face_at({0, 0}, 1));
}

/// Plates with a bump here or there: check() says so if it is where the plan presses.
TEST(SlideHeights, CheckFindsAPressBesideABump) {
  Problem problem = plate_problem();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  int num_found = 0, num_bumps = 0;
  for (double x = -0.04; x <= 0.04; x += 0.02) {
    for (double y = -0.04; y <= 0.04; y += 0.02) {
      problem.object = round_object([&](const Vector2d& p) {
        return plate_height(p) + ((p - Vector2d(x, y)).norm() < 0.008 ? 0.005 : 0);
      });
      ++num_bumps;
      const auto faults = check(problem, found);
      num_found += std::any_of(faults.begin(), faults.end(), [](const std::string& fault) {
        return fault.find("beside the contact") != std::string::npos;
      });
    }
  }
  EXPECT_GE(num_found, 1);
  EXPECT_LE(num_found, num_bumps / 3);
}

TEST(SlideHeights, RefusesWhatIsNowhereLevel) {
  const Object cone =
      round_object([](const Vector2d& p) { return kRim * (1 - p.norm() / (kRadius + 0.01)); });
  const Problem problem = make_problem(tables()[0], cone, flat(0.65, 0.1, 0.3));
  EXPECT_NE(complaint([&] { validate(problem, {}); }).find("nothing to press on"),
            std::string::npos);
}

}  // namespace
}  // namespace graspless::slide
