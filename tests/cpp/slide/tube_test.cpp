// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/tube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "graspless/slide/torsion.hpp"

#include "complaint.hpp"
#include "slide/friction/drag.hpp"
#include "slide/friction/pressed.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

Matrix3d surface_at(const Vector2d& p, double force, double radius) {
  Matrix3d J = Matrix3d::Identity();
  J(0, 2) = -p.y();
  J(1, 2) = p.x();
  const Vector3d squares(1, 1, radius * radius);
  return force * force * J.transpose() * squares.asDiagonal() * J;
}

/// Both limit surfaces as matrices at the middle of the pad, whose force is 1.
struct Surfaces {
  Matrix3d pad, support;
};
Surfaces surfaces(const Drag& drag, const Vector2d& p_TC) {
  return {surface_at({0, 0}, 1, drag.pad), surface_at(p_TC, drag.ratio, drag.radius)};
}

Vector3d wrench(const Matrix3d& H, const Vector3d& twist) {
  return H * twist / std::sqrt(twist.dot(H * twist));
}

/// How much of a limit surface a wrench uses.
double used(const Matrix3d& H, const Vector3d& F) { return std::sqrt(F.dot(H.inverse() * F)); }

struct Case {
  Drag drag;
  Vector2d p_TC;
  Vector3d pad;
};
Case random_case(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto about = [&] { return 2 * unit(rng) - 1; };
  return {{2 * unit(rng), 0.01 + 0.06 * unit(rng), 0.002 + 0.015 * unit(rng)},
          {0.03 * about(), 0.03 * about()},
          {about(), about(), 40 * about()}};
}

TEST(Drag, TheWrenchesOfBothSurfacesAreEqual) {
  std::mt19937_64 rng(1);
  int held = 0, slips = 0, still = 0;
  for (int i = 0; i < 4000; ++i) {
    const Case c = random_case(rng);
    const Surfaces H = surfaces(c.drag, c.p_TC);
    const Vector3d moved = dragged(c.drag, c.p_TC, c.pad);
    if (moved == c.pad) {
      EXPECT_LE(used(H.pad, wrench(H.support, moved)), 1 + 1e-9);
      ++held;
    } else if (moved.isZero(0)) {
      EXPECT_LE(used(H.support, wrench(H.pad, c.pad)), 1 + 1e-9);
      ++still;
    } else {
      const Vector3d slip = c.pad - moved;
      const Vector3d difference = wrench(H.support, moved) - wrench(H.pad, slip);
      const Vector3d scale(1, 1, c.drag.pad);
      EXPECT_LE(difference.cwiseQuotient(scale).norm(), 1e-6 * (1 + c.drag.ratio));
      // The pad pulls the object the way it slips, and never turns it faster than itself.
      EXPECT_GT(wrench(H.pad, slip).dot(moved), 0);
      EXPECT_LT(moved.dot(H.pad * moved), c.pad.dot(H.pad * c.pad));
      ++slips;
    }
  }
  EXPECT_GT(std::min({held, slips, still}), 200);
}

TEST(Drag, TurningTheWorldTurnsTheTwist) {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 500; ++i) {
    const Case c = random_case(rng);
    const Eigen::Rotation2Dd R(0.01 * i);
    const auto turned = [&](const Vector3d& v) {
      const Vector2d p = R * Vector2d(v.head<2>());
      return Vector3d(p.x(), p.y(), v.z());
    };
    const Vector3d a = turned(dragged(c.drag, c.p_TC, c.pad));
    const Vector3d b = dragged(c.drag, R * c.p_TC, turned(c.pad));
    EXPECT_TRUE((a - b).cwiseAbs().maxCoeff() < 1e-8) << a << "\n" << b;
  }
}

// One law: the bounds of torsion.hpp are where this one begins to slip.
TEST(Drag, SlipBeginsAtTheBoundsOfTurnAndLoad) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> unit(0, 1);
  int finite = 0, loads = 0;
  for (int i = 0; i < 500; ++i) {
    Problem problem = simple_problem();
    problem.hand.pad_width = 0.01 + 0.05 * unit(rng);
    problem.object = problem.object.with_mass(0.05 + 1.5 * unit(rng));
    const double radius = 0.01 + 0.05 * unit(rng), press = 2 + 20 * unit(rng);
    const Drag drag{drag_ratio(problem, press), radius, problem.hand.pad_width / 4};
    const auto sticks = [&](const Vector2d& p_TC, double turn) {
      const Vector3d pad(1, 0, turn);
      return dragged(drag, p_TC, pad) == pad;
    };
    const double k = max_turn_per_length(problem, radius, press);
    if (k > 0 && std::isfinite(k)) {
      EXPECT_TRUE(sticks({0, 0}, k * (1 - 1e-6)));
      EXPECT_FALSE(sticks({0, 0}, k * (1 + 1e-6)));
      ++finite;
    }
    if (drag.ratio < 1) {  // drag_load: ratio sqrt(1 + (e / w)^2)
      const double e = drag.pad * std::sqrt(1 / (drag.ratio * drag.ratio) - 1);
      EXPECT_TRUE(sticks({0, e * (1 - 1e-6)}, 0));
      EXPECT_FALSE(sticks({0, e * (1 + 1e-6)}, 0));
      ++loads;
    }
  }
  EXPECT_GT(std::min(finite, loads), 100);
}

Options exact() {
  Options options;
  options.refuse_lag = false;
  options.friction_spread = options.mass_spread = options.com_spread = 0;
  options.thickness_spread = options.height_spread = options.flexure_spread = 0;
  options.position_spread = options.angle_spread = options.tracking_spread = 0;
  return options;
}

/// Problems of random poses and masses [kg], with plans that ignore friction.
struct Planned {
  Problem problem;
  Plan plan;
};
std::vector<Planned> planned(int count, double least, double most) {
  std::mt19937_64 rng(7);
  std::uniform_real_distribution<double> mass(least, most);
  std::vector<Planned> found;
  Options any;
  any.refuse_lag = false;
  for (int i = 0; i < count; ++i) {
    const Support& table = tables()[static_cast<std::size_t>(i) % 4];
    Object object = objects()[static_cast<std::size_t>(i) % 3].with_mass(mass(rng));
    const Eigen::Isometry3d X_SO = random_pose(table, object, rng);
    Problem problem = make_problem(table, object, X_SO);
    Plan plan = slide::plan(problem, any, seeded(static_cast<std::uint64_t>(i) + 1));
    if (plan) found.push_back({std::move(problem), std::move(plan)});
  }
  return found;
}

const Segment& sliding_of(const Plan& plan) {
  return *std::find_if(plan.segments.begin(), plan.segments.end(),
                       [](const Segment& segment) { return segment.name == "slide"; });
}

TEST(Tube, WithAmpleFrictionAndNoSpreadItHasNoWidth) {
  for (auto& [problem, plan] : planned(8, 0.03, 0.1)) {
    problem.hand.pad_friction = 8;
    problem.hand.pad_width = 0.15;
    const Tube found = tube(problem, plan, exact());
    ASSERT_EQ(found.position.size(), sliding_of(plan).positions.size());
    EXPECT_LT(*std::max_element(found.position.begin(), found.position.end()), 1e-6);
    EXPECT_LT(*std::max_element(found.angle.begin(), found.angle.end()), 1e-6);
  }
}

TEST(Tube, GrowsWithEverySpread) {
  const auto all = planned(10, 0.05, 0.8);
  double Options::*const spreads[] = {
      &Options::friction_spread,  &Options::mass_spread,   &Options::com_spread,
      &Options::thickness_spread, &Options::height_spread, &Options::flexure_spread,
      &Options::position_spread,  &Options::angle_spread,  &Options::tracking_spread};
  for (const auto& spread : spreads) {
    int wider = 0;
    for (const auto& [problem, plan] : all) {
      Options options = exact();
      const Tube none = tube(problem, plan, options);
      options.*spread = Options{}.*spread;
      const Tube some = tube(problem, plan, options);
      for (std::size_t row = 0; row < none.position.size(); ++row) {
        EXPECT_GE(some.position[row], none.position[row]);
        EXPECT_GE(some.angle[row], none.angle[row]);
        wider += some.position[row] + some.angle[row] > none.position[row] + none.angle[row];
      }
    }
    EXPECT_GT(wider, 0);
  }
}

/// The object's last pose by another way to the same law: the largest t for which the pad's wrench
/// balances, by bisection on a general eigenproblem, in steps of 0.2 mm.
Planar brute_force(const Problem& problem, const Segment& slide) {
  const std::vector<PressedRow> rows = pressed_rows(problem, slide);
  const double mg = weight(problem);
  Planar X_SO = rows.front().X_SO;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const auto contact = [&](const PressedRow& at) {
      return effective_tip(problem.hand, at.tip, problem.object.thickness(), Options{}.pitch);
    };
    const Planar a = contact(rows[row - 1]), b = contact(rows[row]);
    const Vector2d way = b.translation() - a.translation();
    const Eigen::Matrix2d R = a.linear().transpose() * b.linear();
    const double turn = std::atan2(R(1, 0), R(0, 0));
    const int steps = 1 + static_cast<int>(std::max(way.norm() / 2e-4, std::abs(turn) / 2e-3));
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) / steps;
      const double depth = rows[row - 1].depth + t * (rows[row].depth - rows[row - 1].depth);
      const double pitch =
          rows[row - 1].tip.pitch + t * (rows[row].tip.pitch - rows[row - 1].tip.pitch);
      const Vector2d p = a.translation() + (1.0 * i / steps) * way;
      const Vector2d heading = Eigen::Rotation2Dd(t * turn) * Vector2d(a.linear().col(0));
      const double along = way.norm() > 0 ? heading.dot(way.normalized()) : 0;
      const double N =
          dragging_force(problem.hand, depth, pitch, along, problem.support.friction(), mg);
      const Vector2d p_SM = X_SO * Vector2d(problem.object.com().head<2>());
      const Vector2d C = (N * p + mg * p_SM) / (N + mg);
      const Vector2d p_OC = X_SO.inverse() * C;
      const double r = (problem.object.points().colwise() - p_OC).colwise().norm().mean();
      const Matrix3d support = surface_at(C - p, problem.support.friction() * (N + mg), r);
      const Matrix3d pad =
          surface_at({0, 0}, problem.hand.pad_friction * N, problem.hand.pad_width / 4);
      const Vector3d twist(way.x() / steps, way.y() / steps, turn / steps);
      Vector3d moved = twist;
      if (used(pad, wrench(support, twist)) > 1) {
        double low = 0, high = 1;  // 1 - share of the pad in l H_s + H_p
        for (int k = 0; k < 50; ++k) {
          const double m = (low + high) / 2, l = m / (1 - m);
          moved = (l * support + pad).ldlt().solve(pad * twist);
          const Vector3d slip = twist - moved;
          const double ratio =
              std::sqrt(slip.dot(pad * slip)) / std::sqrt(moved.dot(support * moved));
          (ratio > l ? low : high) = m;
        }
        if (high == 1) moved.setZero();
      }
      const Eigen::Rotation2Dd Q(moved.z());
      X_SO.translation() = p + moved.head<2>() + Q * Vector2d(X_SO.translation() - p);
      X_SO.linear() = Q.toRotationMatrix() * X_SO.linear();
    }
  }
  return X_SO;
}

TEST(Tube, EndsWhereFineStepsOfTheSameLawEnd) {
  int lagging = 0;
  for (const auto& [problem, plan] : planned(60, 0.2, 0.9)) {
    const Segment& slide = sliding_of(plan);
    const Planar goal = pressed_rows(problem, slide).back().X_SO;
    const double off = (brute_force(problem, slide).translation() - goal.translation()).norm();
    if (off > 0.1) continue;  // the pad has lost the object
    const Tube found = tube(problem, plan, exact());
    EXPECT_NEAR(found.position.back(), off, 1e-3 + 0.1 * off);
    lagging += off > 2e-3;
  }
  EXPECT_GT(lagging, 4);
}

TEST(Tube, TurningTheWorldChangesNothing) {
  for (auto& [problem, plan] : planned(6, 0.3, 1.0)) {
    const Tube before = plan.tube;
    // The same plan with the first joint, a vertical axis through the origin, turned along.
    const double turn = 0.2;
    const Eigen::Isometry3d X(Eigen::AngleAxisd(turn, Vector3d::UnitZ()));
    const Support& old = problem.support;
    problem.support = Support(old.polygon(), X * old.X_WS(), old.slab(), 0.06, old.friction());
    problem.X_WO_start = X * problem.X_WO_start;
    for (Segment& segment : plan.segments) {
      for (Eigen::VectorXd& q : segment.positions) q[0] += turn;
      for (Eigen::Isometry3d& X_WO : segment.object_poses) X_WO = X * X_WO;
    }
    const Tube after = tube(problem, plan);
    ASSERT_EQ(before.position.size(), after.position.size());
    for (std::size_t row = 0; row < before.position.size(); ++row) {
      EXPECT_NEAR(before.position[row], after.position[row], 1e-6);
      EXPECT_NEAR(before.angle[row], after.angle[row], 1e-5);
    }
  }
}

TEST(Tube, APlanWithoutASlideHasNone) {
  EXPECT_TRUE(tube(simple_problem(), Plan{}).position.empty());
}

TEST(Tube, AWristThatGivesWayTrails) {
  Problem problem = simple_problem();
  problem.hand.finger_model = FingerModel::impedance;
  problem.hand.wrist_stiffness = 600;
  const Plan plan = slide::plan(problem, {}, seeded(1));
  ASSERT_TRUE(plan) << plan.reason;
  const double trail = trailing(problem, plan).sliding;
  EXPECT_GT(*std::max_element(plan.tube.position.begin(), plan.tube.position.end()), trail);
}

TEST(Tube, CheckRefusesOneThatIsTooNarrowOrNone) {
  const Problem problem = simple_problem();
  const Plan good = slide::plan(problem, {}, seeded(1));
  ASSERT_TRUE(good);
  EXPECT_EQ(joined(check(problem, good)), "");
  const auto refused = [&](const auto& edit) {
    Plan plan = good;
    edit(plan.tube);
    return joined(check(problem, plan));
  };
  const std::string shape = "tube: must have a bound of at least 0 for each row of the slide";
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refused([](Tube& t) { t.position.back() -= 5e-4; }).find("m off, not"),
            std::string::npos);
  EXPECT_NE(refused([](Tube& t) { t.angle.front() *= 0.9; }).find("tube row 0: the object may be"),
            std::string::npos);
  EXPECT_NE(refused([](Tube& t) { t.position[1] = nan; }).find(shape), std::string::npos);
  EXPECT_NE(refused([](Tube& t) { t.angle[1] = -1; }).find(shape), std::string::npos);
  EXPECT_NE(refused([](Tube& t) { t.angle.pop_back(); }).find(shape), std::string::npos);
  EXPECT_NE(refused([](Tube& t) { t.position.clear(); }).find(shape), std::string::npos);
  EXPECT_EQ(refused([](Tube& t) { t = Tube{}; }), "");  // claims nothing
  EXPECT_EQ(refused([](Tube& t) {
              for (double& p : t.position) p *= 2;
            }),
            "");
}

TEST(Tube, CheckRefusesAnEndThatFrictionDoesNotReach) {
  Problem problem = simple_problem();
  Plan plan = slide::plan(problem, {}, seeded(1));
  ASSERT_TRUE(plan);
  plan.tube = {};
  problem.object = problem.object.with_mass(40 * problem.object.mass());
  EXPECT_NE(joined(check(problem, plan)).find("tube: friction may leave"), std::string::npos);
  Options any;
  any.refuse_lag = false;
  EXPECT_EQ(joined(check(problem, plan, any)).find("tube:"), std::string::npos);
}

TEST(Tube, WhatNoPadCanDragIsRefusedAtOnceWithTheNumber) {
  Problem problem = simple_problem();
  problem.object = problem.object.with_mass(8);
  const Plan plan = slide::plan(problem, {}, seeded(1));
  EXPECT_EQ(plan.status, Status::cannot_drag);
  EXPECT_NE(plan.reason.find("times the friction that the pad has"), std::string::npos);
  EXPECT_NE(plan.reason.find("object.mass 8 kg"), std::string::npos) << plan.reason;
  EXPECT_GT(least_drag(problem), 1);
  EXPECT_LT(least_drag(simple_problem()), 1);
  Options any;
  any.refuse_lag = false;
  EXPECT_TRUE(slide::plan(problem, any, seeded(1)));
}

TEST(Tube, HeavyObjectsArePressedWhereThePadHoldsThem) {
  std::mt19937_64 rng(11);
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Object object = objects()[0].with_mass(0.8);
    const Problem problem =
        make_problem(tables()[0], object, random_pose(tables()[0], object, rng));
    const Plan plan = slide::plan(problem, {}, seeded(seed, 5));
    if (!plan) continue;
    ++solved;
    EXPECT_EQ(joined(check(problem, plan)), "");
    EXPECT_LE(drag_load(problem, plan), 1.3);
  }
  EXPECT_GE(solved, 4);
}

}  // namespace
}  // namespace graspless::slide
