// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "graspless/pinch/pinch.hpp"

#include "complaint.hpp"
#include "pinch/grasps.hpp"
#include "pinch/jaw.hpp"
#include "pinch/wall_measure.hpp"
#include "slide/problems.hpp"

namespace graspless::pinch {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using geometry::HeightMap;
using slide::Object;

constexpr double kFine = 0.0025;  // side of the cells [m]

/// Height of a vessel at a place in O.
using Shape = std::function<double(const Vector2d&)>;

HeightMap sampled(const Shape& shape, double half) {
  HeightMap map;
  const auto count = static_cast<Eigen::Index>(std::ceil(2 * half / kFine));
  map.corner.setConstant(-half);
  map.cell = kFine;
  map.heights.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const Vector2d cell(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      map.heights(i, j) = shape(map.corner + kFine * cell);
    }
  }
  return map;
}

/// A round cup: the wall may lean outwards by a tangent.
struct Cup {
  double radius = 0.06, wall = 0.006, height = 0.08, bottom = 0.01, lean = 0;
  double at(const Vector2d& p) const {
    const double r = p.norm();
    if (r > radius) return 0;
    if (r > radius - wall) return height;
    if (lean == 0) return bottom;
    return std::max(bottom, height - (radius - wall - r) / lean);
  }
};

/// A plan from a search that no slow machine or sanitizer cuts short.
Plan plan_in_time(const Problem& problem, const Options& options = {}) {
  planning::Budget budget;
  budget.seconds = std::numeric_limits<double>::infinity();
  return pinch::plan(problem, options, budget);
}

Problem with_cup(const Cup& cup, double mass = 0.06, double x = 0.6, double y = 0.1,
                 double yaw = 0.4) {
  const HeightMap map = sampled([&](const Vector2d& p) { return cup.at(p); }, cup.radius + 0.01);
  const Object object = Object::prism("cup", slide::disc(cup.radius, 48, {0, 0}), cup.height)
                            .with_mass(mass)
                            .with_heights(map);
  return slide::make_problem(slide::tables()[0], object, slide::flat(x, y, yaw));
}

TEST(Walls, AreAsThickAsTheyAreMade) {
  const Cup cup;
  const HeightMap map = sampled([&](const Vector2d& p) { return cup.at(p); }, 0.07);
  const auto found = walls(map, {0, 0, 0.04}, 0.016, {0.05}, 0.008);
  int straight = 0;
  for (const Faces& wall : found) {
    EXPECT_GE(wall.width, cup.wall - 2 * kFine);
    EXPECT_NEAR(wall.middle().norm(), cup.radius - cup.wall / 2, 0.012);
    EXPECT_NEAR(std::hypot(wall.lever, wall.offset), wall.middle().norm(), 1e-9);
    EXPECT_EQ(wall.rise, 0);  // known to be solid
    if (wall.lever > 0.003) continue;
    ++straight;  // closing towards the axis
    EXPECT_LE(wall.width, cup.wall + 3 * kFine);
    EXPECT_LT(wall.friction, 0.3);
  }
  EXPECT_GT(straight, 36);
}

/// A wall that is not seen down to the contacts may recede below.
TEST(Walls, WhatNobodySawBearsLess) {
  const Cup cup;
  HeightMap map = sampled([&](const Vector2d& p) { return cup.at(p); }, 0.07);
  map.undersides = map.heights.min(0.07).max(0);
  const auto found = walls(map, {0, 0, 0.04}, 0.016, {0.06}, 0.008);
  ASSERT_FALSE(found.empty());
  for (const Faces& wall : found) EXPECT_NEAR(wall.rise, 0.008, 1e-12);  // 0.07 is above the pads
}

/// Its inner face leans by a tangent, its outer one is upright.
TEST(Walls, AreMeasuredAsTheyAreMade) {
  const double height = 0.06, patch = 0.008;
  for (const double lean : {0.0, 0.15, 0.3}) {
    Cup cup;
    cup.lean = lean;
    const HeightMap map = sampled([&](const Vector2d& p) { return cup.at(p); }, 0.07);
    const double inner = cup.radius - cup.wall - lean * (cup.height - height);
    double inside = 0, outside = 0, rise = 0;
    constexpr int kAngles = 40;
    for (int k = 0; k < kAngles; ++k) {
      const double angle = 0.1 + k * 2 * M_PI / kAngles;
      const Vector3d out(std::cos(angle), std::sin(angle), 0);
      Eigen::Matrix<double, 3, 2> contacts;
      contacts << inner * out, cup.radius * out;
      contacts.row(2).setConstant(height);
      const WallMeasure wall = measure_wall(map, contacts, patch);
      ASSERT_TRUE(wall.is_wall);
      EXPECT_LE(std::abs(wall.beyond[1]), kFine);
      inside += wall.friction[0] / kAngles;
      outside += wall.friction[1] / kAngles;
      rise += wall.rise / kAngles;
      contacts.row(2).setConstant(cup.height - patch / 2);
      EXPECT_FALSE(measure_wall(map, contacts, patch).is_wall);
    }
    EXPECT_NEAR(inside, lean, 0.12) << lean;
    EXPECT_LT(outside, 0.2) << lean;
    EXPECT_NEAR(rise, std::clamp((lean - 0.1) / 0.2, 0.0, 1.0) * patch, 0.003) << lean;
  }
}

TEST(Walls, TheMassIsTheOneThatTheFormulaGives) {
  const double mu = 1.0, g = 9.81;
  const Pads pads{mu, 10, 0.01};
  Faces faces{};
  faces.friction = 0.2;
  EXPECT_NEAR(largest_mass(faces, pads), 2 * 0.8 * 10 / g, 1e-12);
  faces.offset = 0.05;  // across: tilt alone counts
  EXPECT_NEAR(largest_mass(faces, pads), 10 * 0.01 / 0.05 / g, 1e-12);
  faces.rise = 0.005;
  EXPECT_NEAR(largest_mass(faces, pads), 10 * 0.005 / 0.05 / g, 1e-12);
  faces = Faces{};
  faces.lever = 0.05;  // along: force and twist
  const double twist = 4.0 / 3 * mu * 0.01 * 10;
  EXPECT_NEAR(largest_mass(faces, pads), 1 / std::hypot(1 / 20.0, 0.05 / twist) / g, 1e-12);
  faces.friction = 1.1;
  EXPECT_EQ(largest_mass(faces, pads), 0);
}

TEST(Walls, MoreOfAnythingBearsLess) {
  std::mt19937_64 rng(4);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 200; ++i) {
    Faces faces{};
    faces.friction = part(rng);
    faces.lever = 0.1 * part(rng);
    faces.offset = 0.1 * part(rng);
    faces.rise = 0.008 * part(rng);
    const Pads pads{1.16, 8, 0.008};
    const double mass = largest_mass(faces, pads);
    for (double Faces::*member : {&Faces::friction, &Faces::lever, &Faces::offset, &Faces::rise}) {
      Faces worse = faces;
      worse.*member += 0.01;
      EXPECT_LE(largest_mass(worse, pads), mass);
    }
    faces.drop = 0.1;  // it hangs lower
    EXPECT_GE(largest_mass(faces, pads), mass);
  }
}

TEST(RimPinch, OneFingerIsInsideAndOneOutside) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> wall(0.003, 0.03), radius(0.055, 0.08), height(0.06, 0.12),
      yaw(-3, 3), x(0.5, 0.7), y(-0.15, 0.15);
  for (int i = 0; i < 8; ++i) {
    Cup cup;
    cup.wall = wall(rng);
    cup.radius = radius(rng) + cup.wall;
    cup.height = height(rng);
    const Problem problem = with_cup(cup, 0.05, x(rng), y(rng), yaw(rng));
    const Plan found = plan_in_time(problem);
    ASSERT_TRUE(found) << i << ": " << found.reason;
    EXPECT_EQ(joined(check(problem, found)), "");
    const double a = found.contacts_O.col(0).head<2>().norm(),
                 b = found.contacts_O.col(1).head<2>().norm();
    EXPECT_LT(std::min(a, b), cup.radius - cup.wall + 1.5 * kFine);
    EXPECT_GT(std::max(a, b), cup.radius - 1.5 * kFine);
    EXPECT_LE(found.contacts_O(2, 0), cup.height - Options{}.patch);
    ASSERT_TRUE(found.max_mass);
    EXPECT_GE(*found.max_mass, 0.05);
  }
}

TEST(RimPinch, SquareVesselsToo) {
  const double side = 0.06, wall = 0.005;
  const HeightMap map = sampled(
      [&](const Vector2d& p) {
        const double out = p.lpNorm<Eigen::Infinity>();
        return out > side ? 0 : out > side - wall ? 0.07 : 0.008;
      },
      side + 0.01);
  const geometry::Polygon outline(
      geometry::columns({{-side, -side}, {side, -side}, {side, side}, {-side, side}}));
  const Object box = Object::prism("box", outline, 0.07).with_mass(0.08).with_heights(map);
  const Problem problem = slide::make_problem(slide::tables()[0], box, slide::flat(0.6, 0, 0.3));
  const Plan found = plan_in_time(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found)), "");
  EXPECT_LT(found.friction, 0.3);
}

struct Refused {
  const char* name;
  Cup cup;
  double mass;
  Status status;
  const char* words;
};

TEST(RimPinch, RefusesWithTheNumberInTheWay) {
  const Refused all_of_them[] = {
      {"thick", {0.16, 0.06, 0.08, 0.01, 0}, 0.05, Status::too_wide, "the hand opens 54 mm"},
      {"heavy", {0.06, 0.006, 0.08, 0.01, 0}, 0.9, Status::too_heavy, "it weighs 0.90 kg"},
      {"leaning",
       {0.08, 0.006, 0.08, 0.01, 0.6},
       0.02,
       Status::too_heavy,
       "is upright and was seen on both sides"},
      {"narrow", {0.028, 0.003, 0.08, 0.01, 0}, 0.05, Status::no_room, "too high there"},
      {"full",
       {0.06, 0.006, 0.08, 0.078, 0},
       0.05,
       Status::too_wide,
       "mm thick where it is thinnest, the hand opens"},
      {"shallow", {0.06, 0.006, 0.08, 0.07, 0}, 0.05, Status::no_room, "mm too high there"}};
  for (const Refused& one : all_of_them) {
    const Plan found = plan_in_time(with_cup(one.cup, one.mass));
    EXPECT_EQ(to_string(found.status), to_string(one.status)) << one.name << ": " << found.reason;
    EXPECT_NE(found.reason.find(one.words), std::string::npos) << one.name << ": " << found.reason;
  }
}

/// Nothing is assumed about a hand whose URDF has no effort limit.
TEST(RimPinch, NeedsTheForceOfTheHand) {
  Problem problem = with_cup({});
  std::string urdf = problem.robot.urdf();
  const std::string given = " effort=\"2\"";
  for (std::size_t at; (at = urdf.find(given)) != std::string::npos;) urdf.erase(at, given.size());
  problem.robot = robot::Robot::from_urdf(urdf, problem.robot.options());
  const Plan unknown = plan_in_time(problem);
  EXPECT_EQ(unknown.status, Status::unknown_force) << unknown.reason;
  EXPECT_NE(unknown.reason.find("joint 'left_finger_joint'"), std::string::npos);
  EXPECT_NE(unknown.reason.find("options.grip_force"), std::string::npos);
  Options options;
  options.grip_force = 8;
  const Plan found = plan_in_time(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found, options)), "");
  EXPECT_NE(joined(check(problem, found)).find("effort limit"), std::string::npos);
}

/// A cup whose wall is lower on one side is taken where it is high.
TEST(RimPinch, ALowWallIsLeftAlone) {
  const Cup cup;
  const HeightMap map = sampled(
      [&](const Vector2d& p) { return p.x() < 0 ? std::min(0.02, cup.at(p)) : cup.at(p); }, 0.07);
  const Object object =
      Object::prism("cup", slide::disc(cup.radius, 48, {0, 0}), cup.height).with_heights(map);
  const Problem problem = slide::make_problem(slide::tables()[0], object, slide::flat(0.6, 0, 0.3));
  const Plan found = plan_in_time(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_GT(found.contacts_O(0, 0), 0);
  EXPECT_EQ(joined(check(problem, found)), "");
}

TEST(RimPinch, EditedPlansAreAtFault) {
  const Problem problem = with_cup({});
  const Plan found = plan_in_time(problem);
  ASSERT_TRUE(found) << found.reason;
  ASSERT_EQ(joined(check(problem, found)), "");
  const auto fault_of = [&](const auto& edit) {
    Plan edited = found;
    edit(edited);
    return joined(check(problem, edited));
  };
  EXPECT_NE(fault_of([](Plan& p) { p.max_mass = 2 * *p.max_mass + 1; }).find("max_mass"),
            std::string::npos);
  EXPECT_NE(fault_of([](Plan& p) { p.max_mass.reset(); }).find("max_mass"), std::string::npos);
  EXPECT_NE(fault_of([](Plan& p) { p.contacts_O.row(2).array() += 0.02; }).find("wall"),
            std::string::npos);
  EXPECT_NE(fault_of([](Plan& p) { p.contacts_O.col(1) = p.contacts_O.col(0); }), "");
  for (const double height : {0.0, -0.01}) {  // where the plane and all around is as high
    EXPECT_NE(fault_of([&](Plan& p) {
                p.contacts_O.row(2).setConstant(height);
              }).find("not above the support"),
              std::string::npos);
  }
  EXPECT_NE(fault_of([](Plan& p) { p.contacts_O(0, 0) += 1e9; }).find("farther apart"),
            std::string::npos);
  for (const double friction : {-1.0, std::nan(""), 1e9})
    EXPECT_NE(fault_of([&](Plan& p) { p.friction = friction; }).find("friction"),
              std::string::npos);
  EXPECT_NE(fault_of([](Plan& p) {
              const Vector3d out = (p.contacts_O.col(1) - p.contacts_O.col(0)).normalized();
              p.contacts_O.colwise() += 0.01 * out;
            }),
            "");
  EXPECT_NE(fault_of([](Plan& p) {  // both fingers on one side of the wall
              p.segments[2].positions.push_back(p.segments[2].positions.back());
              p.segments[2].object_poses.push_back(p.segments[2].object_poses.back());
            })
                .find("collision"),
            std::string::npos);
}

/// Friction that the slopes need does not hold the object, too.
TEST(RimPinch, APlanOnALeaningWallNeedsFriction) {
  Cup cup;
  cup.lean = 0.25;
  cup.height = 0.1;
  const Problem problem = with_cup(cup, 0.02);
  Options options;
  options.patch = 0.016;
  Plan found = plan_in_time(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found, options)), "");
  found.friction = 0;
  EXPECT_NE(joined(check(problem, found, options)).find("friction must be at least"),
            std::string::npos);
}

/// Cells are as wide as a wall leans over half a pad: planner and check() must measure it alike.
TEST(RimPinch, PlansOnLeaningWallsHold) {
  int solved = 0;
  for (const double lean : {0.15, 0.25, 0.3}) {
    for (const double radius : {0.055, 0.064, 0.073}) {
      Cup cup;
      cup.lean = lean;
      cup.radius = radius;
      const Problem problem = with_cup(cup, 0.02);
      const Plan found = plan_in_time(problem);
      solved += found ? 1 : 0;
      if (found) {
        EXPECT_EQ(joined(check(problem, found)), "") << lean << ", " << radius;
      }
    }
  }
  EXPECT_GT(solved, 5);
}

/// check() refuses a wall that ends more than a cell from its contact: the search must not take it.
TEST(RimPinch, AWallThatEndsElsewhereIsNotTaken) {
  const Problem problem = with_cup({});
  const Options options;
  const Jaw jaw(problem);
  Grasps result;
  std::vector<Faces> faces = select_walls(problem, options, jaw, result);
  faces = measured_walls(std::move(faces), problem, options, jaw, result);
  ASSERT_FALSE(faces.empty()) << result.reason;
  Faces off = faces.front();
  const Vector2d out = (off.second - off.first).normalized();
  off.second += 2.5 * kFine * out;
  EXPECT_EQ(measured_walls({faces.front()}, problem, options, jaw, result).size(), 1u);
  EXPECT_TRUE(measured_walls({off}, problem, options, jaw, result).empty());
  EXPECT_EQ(result.status, Status::too_flat);
  EXPECT_NE(result.reason.find("the walls are ragged"), std::string::npos) << result.reason;
}

/// The same plan, on another object.
TEST(RimPinch, APlanForAnotherVesselIsAtFault) {
  const Plan found = plan_in_time(with_cup({}));
  ASSERT_TRUE(found) << found.reason;
  Cup full, thick, low;
  full.bottom = 0.07;
  thick.wall = 0.02;
  low.height = 0.06;
  EXPECT_NE(joined(check(with_cup(full), found)).find("collision"), std::string::npos);
  EXPECT_NE(joined(check(with_cup(thick), found)), "");
  EXPECT_NE(joined(check(with_cup(low), found)).find("wall"), std::string::npos);
  EXPECT_NE(joined(check(with_cup({}, 1.5), found)).find("it weighs 1.5 kg"), std::string::npos);
  Problem unseen = with_cup({});
  HeightMap map = *unseen.object.heights();
  map.undersides = map.heights;
  unseen.object = unseen.object.with_heights(map);
  EXPECT_NE(joined(check(unseen, found)).find("nobody saw"), std::string::npos);
}

TEST(RimPinch, IsTheSameEveryTime) {
  const Problem problem = with_cup({});
  const Plan a = plan_in_time(problem), b = plan_in_time(problem);
  ASSERT_TRUE(a);
  EXPECT_EQ(a.contacts_O, b.contacts_O);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t i = 0; i < a.segments.size(); ++i)
    EXPECT_EQ(a.segments[i].positions, b.segments[i].positions);
}

/// Two walls with a gap that the open fingers do not fit into.
TEST(Walls, AHandThatIsLessOpenNeedsLessRoom) {
  const double gap = 0.042, wall = 0.006, height = 0.09;
  const HeightMap map = sampled(
      [&](const Vector2d& p) {
        const double off = std::abs(p.y()) - gap / 2;
        return std::abs(p.x()) > 0.05 || off > wall ? 0 : off > 0 ? height : 0.01;
      },
      0.07);
  const Object object =
      Object::prism("pen box",
                    geometry::Polygon(geometry::columns({{-0.05, -gap / 2 - wall},
                                                         {0.05, -gap / 2 - wall},
                                                         {0.05, gap / 2 + wall},
                                                         {-0.05, gap / 2 + wall}})),
                    height)
          .with_mass(0.06)
          .with_heights(map);
  const Problem problem =
      slide::make_problem(slide::tables()[0], object, slide::flat(0.6, 0.1, 0.4));
  EXPECT_FALSE(plan_in_time(problem));
  Options options;
  options.opening = 0.027;
  const Plan found = plan_in_time(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found, options)), "");
  EXPECT_NEAR(found.opening, Jaw(problem).opening(), 1e-12);
  EXPECT_NEAR(Jaw(problem).gap(found.segments[1].positions.back()), 0.027, 1e-4);
  EXPECT_NE(joined(check(problem, found)).find("the hand is not open"), std::string::npos);
  options.opening = 0.03;
  EXPECT_NE(joined(check(problem, found, options)).find("the hand is not open"), std::string::npos);
  options.opening = 1;  // more than it opens
  EXPECT_FALSE(plan_in_time(problem, options));
  options.opening = 0.001;
  EXPECT_EQ(plan_in_time(problem, options).status, Status::too_wide);
}

}  // namespace
}  // namespace graspless::pinch
