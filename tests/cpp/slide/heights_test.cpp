// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slides of objects that are no prisms: plates and bowls, pressed where they are level.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "graspless/slide/resume.hpp"

#include "slide/contact.hpp"
#include "slide/placement.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

using Eigen::Isometry3d, Eigen::Vector2d;

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
  EXPECT_TRUE(square.has_face_at({0, 0}, 1, 1));
}

/// Of two level parts, the one near the centre of mass, although the other is larger.
TEST(SlideHeights, ThePartNearTheCentreOfMassIsPressed) {
  const Object steps = round_object([](const Vector2d& p) { return p.x() < 0.02 ? 0.008 : 0.016; });
  EXPECT_NEAR(steps.top(), 0.008, 1e-3);
  const Eigen::Vector3d com(0.05, 0, 0.01);
  EXPECT_NEAR(steps.with_com(com).top(), 0.016, 1e-3);
  EXPECT_NEAR(steps.with_com(com).with_heights(*steps.heights()).top(), 0.016, 1e-3);
  EXPECT_NEAR(steps.with_com(com).with_com({-0.05, 0, 0.01}).top(), 0.008, 1e-3);
}

/// A rugged disc with a level ridge of a width along x, and perhaps a higher wall beside it.
Object ridged(double width, double wall) {
  return round_object([&](const Vector2d& p) {
    if (std::abs(p.y()) < width / 2) return 0.012;
    if (p.y() > width / 2 && p.y() < width / 2 + 0.01) return wall;
    return std::lround((p.x() + p.y()) / 0.005) % 2 == 0 ? 0.001 : 0.0065;
  });
}

/// A pad that need not bear with all of its length presses on what is narrower, if nothing beside
/// that is higher.
TEST(SlideHeights, ANarrowPartIsPressedWithAPartOfThePad) {
  Problem problem = plate_problem();
  Options uneven;
  uneven.pad_spread = 0.7;
  ASSERT_GE(problem.hand.pad_width, 0.03);
  const auto on_ridge = [&](const Object& object, const Options& options) {
    problem.object = object;
    int count = 0;
    for (const auto i : contact_points(problem, options))
      count += std::abs(object.heights()->at(object.points().col(i)) - 0.012) < 1e-9;
    return count;
  };
  EXPECT_GT(on_ridge(ridged(0.01, 0.001), uneven), 0);
  EXPECT_EQ(on_ridge(ridged(0.01, 0.001), {}), 0);
  EXPECT_EQ(on_ridge(ridged(0.01, 0.02), uneven), 0);
  EXPECT_GT(on_ridge(ridged(0.06, 0.001), {}), 0);
}

/// A ring with heights, whose hole is wider than the pad.
Object ring_object(double height) {
  return round_object([&](const Vector2d& p) { return p.norm() < 0.04 ? 0 : height; });
}

TEST(SlideHeights, NothingIsPressedInAHole) {
  for (const double height : {0.002, 0.006}) {  // the first is as near to the bottom of the hole
    Problem problem = plate_problem();
    problem.object = ring_object(height);
    EXPECT_NEAR(problem.object.top(), height, 1e-12);
    const auto points = contact_points(problem, {});
    ASSERT_FALSE(points.empty());
    for (const auto i : points)
      EXPECT_GT(problem.object.heights()->at(problem.object.points().col(i)), 0);
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Plan found = plan(problem, {}, seeded(seed));
      ASSERT_TRUE(found) << seed << ": " << found.reason;
      EXPECT_TRUE(check(problem, found).empty()) << check(problem, found).front();
    }
  }
}

/// Where the finger presses on the object, in O.
Vector2d contact_of(const Problem& problem, const Plan& plan) {
  const Segment& slide = *std::find_if(plan.segments.begin(), plan.segments.end(),
                                       [](const Segment& s) { return s.name == "slide"; });
  const Isometry3d X_SW = problem.support.X_WS().inverse();
  const int F = problem.robot.frame(problem.hand.fingertip);
  const Tip pressed = tip(X_SW * problem.robot.pose(F, slide.positions.front()));
  const Planar X_SC = effective_tip(problem.hand, pressed, problem.object.top(), Options{}.pitch);
  return planar(X_SW * slide.object_poses.front()).inverse() * X_SC.translation();
}

/// The object of a plan with a hole or a bump where it is pressed, in cells of several sizes.
TEST(SlideHeights, CheckFindsAHoleOrABumpAtTheContact) {
  Problem problem = plate_problem();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const Vector2d contact = contact_of(problem, found);
  const Object plate = problem.object;
  for (const double cell : {0.0025, 0.005, 0.02, 0.05}) {
    geometry::HeightMap level;
    const auto count = static_cast<Eigen::Index>(std::ceil(0.2 / cell));
    level.corner = {-0.1, -0.1};
    level.cell = cell;
    level.heights.setConstant(count, count, plate.top());
    for (const double height : {plate.top(), 0.0, kRim}) {
      geometry::HeightMap map = level;
      for (const double x : {-0.002, 0.0, 0.002}) {
        for (const double y : {-0.002, 0.0, 0.002}) {
          const Vector2d at = (contact + Vector2d(x, y) - map.corner) / cell;
          map.heights(static_cast<Eigen::Index>(at.x()), static_cast<Eigen::Index>(at.y())) =
              height;
        }
      }
      problem.object = plate.with_heights(map);
      const auto faults = check(problem, found);
      const bool is_found = std::any_of(faults.begin(), faults.end(), [](const std::string& fault) {
        return fault.find("at the contact") != std::string::npos;
      });
      EXPECT_EQ(is_found, height != plate.top()) << cell << " " << height;
    }
  }
}

/// The finger leans over the wall of a bowl, but not through it.
TEST(SlideHeights, TheFingerKeepsOffWalls) {
  for (const double wall : {0.02, 0.03, 0.048}) {
    geometry::HeightMap map = *round_object([](const Vector2d&) { return 0.006; }).heights();
    for (Eigen::Index i = 0; i < map.heights.rows(); ++i) {
      for (Eigen::Index j = 0; j < map.heights.cols(); ++j) {
        const Vector2d cell(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
        const double out = (map.corner + map.cell * cell).norm();
        if (out > 0.065 && out <= kRadius) map.heights(i, j) = wall;
      }
    }
    Problem problem = plate_problem();
    problem.object = Object::prism("bowl", disc(kRadius, 40, {0, 0}), wall).with_heights(map);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Plan found = plan(problem, {}, seeded(seed));
      ASSERT_TRUE(found) << wall << " " << seed << ": " << found.reason;
      EXPECT_TRUE(check(problem, found).empty()) << wall << " " << check(problem, found).front();
    }
  }
}

/// A slide of a plate that has moved in the hand goes on where the plate is level, and check()
/// agrees.
TEST(SlideHeights, ResumesWhereThePlateIsLevel) {
  const Problem problem = plate_problem();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const Segment& slide = *std::find_if(found.segments.begin(), found.segments.end(),
                                       [](const Segment& s) { return s.name == "slide"; });
  const std::size_t row = slide.positions.size() / 2;
  const Vector2d contact = contact_of(problem, found);
  const double radius = face_radius(problem.hand, {});
  int solved = 0, refused = 0;
  for (double away = 0; away < 0.055; away += 0.004) {
    for (int k = 0; k < 4; ++k) {
      const Vector2d now = away * Vector2d(std::cos(k * M_PI / 2), std::sin(k * M_PI / 2));
      const Vector2d moved = contact - now;
      const Isometry3d X_WO =
          slide.object_poses.at(row) * Eigen::Translation3d(moved.x(), moved.y(), 0);
      const Plan rest =
          resume(problem, {slide.positions.at(row), X_WO, std::nullopt}, {}, seeded(1));
      if (rest) {
        EXPECT_TRUE(check(problem, rest).empty()) << check(problem, rest).front();
      }
      const bool is_level = rest.reason.find("not level") == std::string::npos;
      const double least = kMiddle - radius;
      if (away < least - 0.006) {
        EXPECT_TRUE(is_level) << now.transpose();
      }
      if (away > least + 0.012) {
        EXPECT_FALSE(is_level) << now.transpose();
      }
      solved += static_cast<bool>(rest);
      refused += !is_level;
    }
  }
  EXPECT_GT(solved, 10);
  EXPECT_GT(refused, 10);
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
  const Plan found = plan(problem, {}, seeded(1));
  EXPECT_EQ(found.status, Status::no_start_root);
  EXPECT_NE(found.reason.find("nothing to press on"), std::string::npos) << found.reason;
}

}  // namespace
}  // namespace graspless::slide
