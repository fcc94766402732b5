// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/torsion.hpp"

#include <random>

#include <gtest/gtest.h>

#include "graspless/robot/ik.hpp"

#include "problems.hpp"
#include "slide/contact.hpp"

namespace graspless::slide {
namespace {

Problem with(double support_friction, double pad_width) {
  Hand hand;
  hand.pad_width = pad_width;
  const Support& table = tables()[0];
  const Support support(table.polygon(), table.X_WS(), 0.04, 0.06, support_friction);
  return {wam(), hand, objects()[0], support, flat(.65, 0, 0), {}, wam().state("home")};
}

/// Whether the pad holds an object that turns by k per length: both limit surfaces, written out.
bool keeps_up(const Problem& p, double radius, double press, double k) {
  const double drag = p.support.friction() * (press + p.object.mass() * 9.81);
  const double speed = std::hypot(1, radius * k);
  const double force = drag / speed, torque = drag * radius * radius * k / speed;
  const double grip = p.hand.pad_friction * press, w = p.hand.pad_width / 4;
  return std::hypot(force / grip, torque / (grip * w)) <= 1;
}

TEST(Torsion, TheBoundIsWhereTheLimitSurfacesMeet) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> unit(0, 1);
  int finite = 0, never = 0, always = 0;
  for (int i = 0; i < 2000; ++i) {
    const Problem p = with(0.05 + 1.4 * unit(rng), 0.005 + 0.1 * unit(rng));
    const double radius = 0.005 + 0.1 * unit(rng), press = 0.2 + 20 * unit(rng);
    const double k = max_turn_per_length(p, radius, press);
    if (k == 0) {
      EXPECT_FALSE(keeps_up(p, radius, press, 0));
      ++never;
    } else if (std::isinf(k)) {
      EXPECT_TRUE(keeps_up(p, radius, press, 1e6));
      ++always;
    } else {
      EXPECT_TRUE(keeps_up(p, radius, press, k * (1 - 1e-9)));
      EXPECT_FALSE(keeps_up(p, radius, press, k * (1 + 1e-6)));
      ++finite;
    }
  }
  EXPECT_GT(std::min({finite, never, always}), 20);
}

TEST(Torsion, TheFingerPressesAsItsSpringSays) {
  const Hand hand;
  EXPECT_EQ(press_force(hand, 0, 0.8), 0);
  // The work of the press is the spring's energy: dE = N dz.
  double energy = 0;
  const double pitch = 0.7, step = 1e-6;
  for (double z = step / 2; z < 0.02; z += step) energy += press_force(hand, z, pitch) * step;
  const double bent = pitch - std::asin(std::sin(pitch) - 0.02 / hand.flexure_length);
  EXPECT_NEAR(energy, hand.flexure_stiffness * bent * bent / 2, 1e-6);
}

TEST(Torsion, ADraggingFingerIsInBalanceAboutItsFlexure) {
  const Hand hand;
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int lifted = 0, jammed = 0, balanced = 0;
  for (int i = 0; i < 4000; ++i) {
    const double depth = 0.02 * unit(rng), pitch = 0.5 + 0.5 * unit(rng);
    const double along = 2 * unit(rng) - 1, friction = 1.5 * unit(rng), weight = 30 * unit(rng);
    const double N = dragging_force(hand, depth, pitch, along, friction, weight);
    const double L = hand.flexure_length, bent = std::asin(std::sin(pitch) - depth / L);
    const Eigen::Vector2d tip(L * std::cos(bent), -L * std::sin(bent));
    const auto torque = [&](double press) {  // of what acts on the tip, less the spring's
      const Eigen::Vector2d force(-along * friction * (press + weight), press);
      return tip.x() * force.y() - tip.y() * force.x() - hand.flexure_stiffness * (pitch - bent);
    };
    if (N == 0) {
      EXPECT_GE(torque(0), 0);  // the pull alone bends it so far
      ++lifted;
    } else if (std::isinf(N)) {
      EXPECT_LT(torque(1e9), 0);  // no press holds it
      ++jammed;
    } else {
      EXPECT_NEAR(torque(N), 0, 1e-9 * (1 + N));
      ++balanced;
    }
  }
  EXPECT_GT(std::min({lifted, jammed, balanced}), 20);
  EXPECT_EQ(dragging_force(hand, 0.015, 0.8, 0, 0.3, 10), press_force(hand, 0.015, 0.8));
}

/// A plan whose finger goes `distance` along its heading and turns by `turn`, at a depth of 15 mm.
Plan slide(const Problem& problem, double distance, double turn) {
  Plan plan;
  const robot::Ik ik(problem.robot, problem.robot.frame(problem.hand.fingertip),
                     problem.robot.group(problem.hand.arm));
  Segment segment{"slide", {}, {}};
  Eigen::VectorXd q = problem.q_home;
  std::mt19937_64 rng(1);
  for (int i = 0; i <= 20; ++i) {
    const double yaw = turn * i / 20;
    const Eigen::Vector2d p(.6 + distance * i / 20, 0);
    const Eigen::Isometry3d X_WF =
        tip_pose(p, problem.object.thickness() - .015, {std::cos(yaw), std::sin(yaw)}, 0.785);
    const auto all = ik.solve_all(X_WF, q, rng);
    if (all.empty()) throw std::runtime_error("out of reach");
    q = all.front();
    segment.positions.push_back(q);
    segment.object_poses.push_back(flat(p.x(), p.y(), yaw));
  }
  plan.segments.push_back(segment);
  return plan;
}

TEST(Torsion, AStraightSlideNeverLagsAndATurnOnTheSpotLagsByItself) {
  const Problem rough = with(0.6, 0.01);
  const Turning straight = turning(rough, slide(rough, 0.1, 0));
  EXPECT_NEAR(straight.max_turn_rate, 0, 1e-9);
  EXPECT_NEAR(straight.lag, 0, 1e-9);
  EXPECT_GT(straight.allowed_turn_rate, 0);
  const Turning turned = turning(rough, slide(rough, 1e-4, 0.5));
  EXPECT_NEAR(turned.lag, 0.5, 0.02);
  EXPECT_EQ(turned.max_turn_rate, 0);  // no step is long enough for a rate
  const Problem smooth = with(0.05, 0.1);
  EXPECT_NEAR(turning(smooth, slide(smooth, 1e-4, 0.5)).lag, 0, 1e-9);
}

TEST(Torsion, TheLoadIsForceAndTorqueOfTheSupportAgainstThePads) {
  for (const double mass : {0.05, 1.0}) {
    for (const double aside : {0.0, 0.02}) {
      for (const double way : {0.03, -0.03}) {
        Problem p = with(0.3, 0.032);
        p.object = p.object.with_mass(mass).with_com({0, aside, 0.0025});
        const double along = way > 0 ? 1 : -1, weight = mass * 9.81;
        const double N = dragging_force(p.hand, .015, .785, along, .3, weight);
        const double force = .3 * (N + weight), torque = .3 * weight * aside;
        const double grip = p.hand.pad_friction * N, w = .032 / 4;
        const double load = std::hypot(force / grip, torque / (grip * w));
        EXPECT_NEAR(drag_load(p, slide(p, way, 0)), load, 1e-3 * load);
      }
    }
  }
}

TEST(Torsion, APlanWithoutASlidePromisesNothing) {
  EXPECT_EQ(turning(with(0.6, 0.01), Plan{}).lag, 0);
  EXPECT_EQ(drag_load(with(0.6, 0.01), Plan{}), 0);
  EXPECT_EQ(trailing(with(0.6, 0.01), Plan{}).sliding, 0);
}

// A rigid finger presses with the force that is wanted, or that the wrist's stiffness makes of the
// depth; the drag does not change it.
TEST(Torsion, ARigidFingerIsHeldToTheSameLimits) {
  Problem p = with(0.6, 0.01);
  const double weight = p.object.mass() * 9.81;
  p.hand.press_force = 7;
  p.hand.wrist_stiffness = 500;
  for (const FingerModel model : {FingerModel::none, FingerModel::rigid_guarded}) {
    p.hand.finger_model = model;
    EXPECT_EQ(press_force(p.hand, 0.001, 0.785), 7);
    EXPECT_EQ(dragging_force(p.hand, 0.001, 0.785, 1, 0.3, weight), 7);
    EXPECT_GT(turning(p, slide(p, 1e-4, 0.5)).lag, 0);
    EXPECT_GT(drag_load(p, slide(p, 0.1, 0)), 0);
  }
  p.hand.finger_model = FingerModel::impedance;
  EXPECT_DOUBLE_EQ(press_force(p.hand, 0.012, 0.785), 6);
  EXPECT_DOUBLE_EQ(dragging_force(p.hand, 0.012, 0.785, -1, 0.3, weight), 6);
}

/// Distances of the object from the commanded tip at the end of a slide, and after the lift: a
/// spring that pulls a pad on an object on a support, in small steps in which each surface sticks
/// or slips.
std::pair<double, double> trail(const Problem& p, double press) {
  const double K = p.hand.wrist_stiffness, weight = p.object.mass() * 9.81;
  double command = 0, pad = 0, object = 0;
  const auto settle = [&](double N) {
    const double drag = p.support.friction() * (N + weight), grip = p.hand.pad_friction * N;
    const double excess = K * (command - pad) - std::min(drag, grip);
    if (excess <= 0) return;  // both stick
    pad += excess / K;
    if (drag <= grip) object += excess / K;
  };
  for (; command < 0.2; command += 1e-5) settle(press);
  const double sliding = command - object;
  for (double N = press; N > 0; N -= press / 1e5) settle(N);
  return {sliding, command - object};
}

TEST(Torsion, AWristThatGivesWayTrailsAsASpringBehindFriction) {
  for (const double friction : {0.2, 0.6}) {
    for (const double mass : {0.05, 0.5}) {
      Problem p = with(friction, 0.032);
      p.object = p.object.with_mass(mass);
      p.hand.finger_model = FingerModel::impedance;
      p.hand.wrist_stiffness = 600;
      const auto [sliding, left] = trail(p, 600 * .015);
      const Trailing found = trailing(p, slide(p, 0.1, 0));
      EXPECT_NEAR(found.sliding, sliding, 5e-5);
      EXPECT_NEAR(found.left, left, 5e-5);
      EXPECT_LT(found.left, found.sliding);
    }
  }
  for (const FingerModel model :
       {FingerModel::none, FingerModel::flexure, FingerModel::rigid_guarded}) {
    Problem p = with(0.3, 0.032);
    p.hand.finger_model = model;
    p.hand.wrist_stiffness = 600;
    EXPECT_EQ(trailing(p, slide(p, 0.1, 0)).sliding, 0);
  }
}

/// Options of a search that knows no friction.
Options warned_only() {
  Options options;
  options.refuse_lag = false;
  return options;
}

TEST(Torsion, AnObjectThatEndsShortOfThePlanIsWarnedOf) {
  Problem problem = with(0.3, 0.032);
  problem.hand.finger_model = FingerModel::impedance;
  problem.hand.wrist_stiffness = 600;
  problem.hand.press_force = 40;
  for (const double mass : {0.05, 0.8}) {
    problem.object = problem.object.with_mass(mass);
    Options options = warned_only();
    options.max_depth = 40.0 / 600 / 2;
    const Plan plan = slide::plan(problem, options);
    ASSERT_TRUE(plan) << plan.reason;
    const bool told =
        std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const std::string& warning) {
          return warning.find("gives way to the friction") != std::string::npos;
        });
    EXPECT_EQ(told, mass > 0.5);
  }
}

TEST(Torsion, APadThatCannotDragTheObjectIsWarnedOf) {
  const Problem problem = with(3, 0.03);
  const Plan plan = slide::plan(problem, warned_only());
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_NE(plan.warnings.front().find("cannot drag"), std::string::npos);
}

TEST(Torsion, AnObjectTooHeavyForThePadIsWarnedOf) {
  int warned = 0, quiet = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const double mass : {0.05, 1.0, 3.0}) {
      Problem problem = with(0.3, 0.032);
      problem.object = problem.object.with_mass(mass);
      planning::Budget budget;
      budget.seed = seed;
      const Plan plan = slide::plan(problem, warned_only(), budget);
      ASSERT_TRUE(plan);
      const bool heavy = drag_load(problem, plan) > 1;
      const bool told =
          !plan.warnings.empty() && plan.warnings.front().find("cannot drag") != std::string::npos;
      EXPECT_EQ(told, heavy);
      EXPECT_FALSE(heavy && mass < 0.1);
      (heavy ? warned : quiet) += 1;
    }
  }
  EXPECT_GT(std::min(warned, quiet), 3);
}

TEST(Torsion, APlanThatTurnsFastIsWarnedOf) {
  int warned = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Problem problem = with(0.8, 0.008);
    planning::Budget budget;
    budget.seed = seed;
    const Plan plan = slide::plan(problem, warned_only(), budget);
    ASSERT_TRUE(plan);
    const bool lags = turning(problem, plan).lag > 2 * M_PI / 180;
    EXPECT_EQ(plan.warnings.size(), lags || drag_load(problem, plan) > 1 ? 1u : 0u);
    warned += lags;
  }
  EXPECT_GT(warned, 0);
}

}  // namespace
}  // namespace graspless::slide
