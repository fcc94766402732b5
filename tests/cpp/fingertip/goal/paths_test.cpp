// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "fingertip/goal/goal.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

Eigen::Isometry3d upright(double x, double y, double yaw, double height) {
  Eigen::Isometry3d X(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  X.translation() << x, y, height;
  return X;
}

struct Case {
  Problem problem{Object::box("block", {0.05, 0.06, 0.1}, 1), {}, {Plane{}}, {0.5, 0.5}, {}, {}};
  Goal goal;
  ContactStates states{problem.object};
  int start_face = -1;

  explicit Case(const Eigen::Isometry3d& X_WO_start) {
    goal.X_WO_start = X_WO_start;
    start_face = states.standing(X_WO_start, problem.planes.front(), 1e-9);
  }
  std::vector<TumbleSequence> sequences(int tumbles) const {
    const int to = states.standing(goal.X_WO_goal, problem.planes.front(), 1e-9);
    return tumble_sequences(states, start_face, to, tumbles, 100);
  }
};

/// Along the path the motion from pose to pose is a slide along, or a turn about, the floor's
/// normal, or a turn about an edge on the floor; steps are no longer than asked for.
void expect_legal(const Case& given, const Path& path) {
  for (std::size_t i = 0; i + 1 < path.X_WO.size(); ++i) {
    const Eigen::Isometry3d &X = path.X_WO[i], &X_next = path.X_WO[i + 1];
    const mechanics::Vector6d twist_O = screw_between(X, X_next);
    const Eigen::Vector3d omega_W = X.linear() * twist_O.tail<3>();
    EXPECT_LE(omega_W.norm(), given.goal.turn_step * (1 + 1e-6));
    const bool is_level = omega_W.head<2>().norm() < 1e-9;
    const double lowest = (X * given.problem.object.hull()).row(2).minCoeff();
    EXPECT_NEAR(lowest, 0, 1e-9);
    if (is_level) {
      EXPECT_NEAR(X.translation().z(), X_next.translation().z(), 1e-9);
      const Eigen::Vector3d com = given.problem.object.com();
      EXPECT_LE((X_next * com - X * com).norm(), given.goal.slide_step * (1 + 1e-6));
    } else {
      EXPECT_NEAR(omega_W.z(), 0, 1e-9);
    }
  }
}

TEST(GoalPaths, EndAtTheGoalWhateverTheOrder) {
  Case given(upright(0.1, 0.2, 0.3, 0.05));
  const Eigen::Isometry3d on_its_side =
      Eigen::Isometry3d(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX()));
  given.goal.X_WO_goal = upright(-0.1, 0.15, -1.1, 0.03) * on_its_side;
  for (const int tumbles : {1, 2, 3}) {
    const auto sequences = given.sequences(tumbles);
    EXPECT_FALSE(sequences.empty());
    for (const TumbleSequence& sequence : sequences) {
      const auto paths =
          goal_paths(given.problem, given.goal, given.states, given.start_face, sequence);
      // Turn and slide at any two times; at the same time also in the other order, or as one.
      const auto times = static_cast<std::size_t>(tumbles + 1);
      EXPECT_EQ(paths.size(), times * times + 2 * times);
      for (const Path& path : paths) {
        EXPECT_TRUE(path.X_WO.front().isApprox(given.goal.X_WO_start, 1e-12));
        EXPECT_TRUE(path.X_WO.back().isApprox(given.goal.X_WO_goal, 1e-9));
        expect_legal(given, path);
      }
    }
  }
}

TEST(GoalPaths, WithoutTumblesASlideIsASlide) {
  Case given(upright(0, 0, 0.4, 0.05));
  given.goal.X_WO_goal = upright(0.1, 0, 0.4, 0.05);
  given.goal.slide_step = 0.1 / 30;
  const auto paths =
      goal_paths(given.problem, given.goal, given.states, given.start_face, TumbleSequence{});
  ASSERT_EQ(paths.size(), 1U);
  const Path slide = slide_path(given.goal.X_WO_start, {0.1, 0, 0}, 30);
  ASSERT_EQ(paths[0].X_WO.size(), slide.X_WO.size());
  for (std::size_t i = 0; i < slide.X_WO.size(); ++i) {
    EXPECT_TRUE(paths[0].X_WO[i].isApprox(slide.X_WO[i], 1e-12));
  }
}

TEST(GoalPaths, HalfATurnGoesBothWays) {
  Case given(upright(0, 0, 0, 0.05));
  given.goal.X_WO_goal = upright(0, 0, std::acos(-1.0), 0.05);
  const auto paths =
      goal_paths(given.problem, given.goal, given.states, given.start_face, TumbleSequence{});
  ASSERT_EQ(paths.size(), 2U);
  const auto first_turn = [](const Path& path) {
    return screw_between(path.X_WO[0], path.X_WO[1])[5];
  };
  EXPECT_NEAR(first_turn(paths[0]), -first_turn(paths[1]), 1e-12);
}

TEST(GoalPaths, TumblingThereNeedsNoSlide) {
  Case given(upright(0, 0, 0, 0.05));
  const TumbleEdge& edge = given.states[given.start_face].edges.front();
  given.goal.X_WO_goal = tumbled(given.goal.X_WO_start, edge);
  const auto sequences = given.sequences(1);
  ASSERT_EQ(sequences.size(), 1U);
  const auto paths =
      goal_paths(given.problem, given.goal, given.states, given.start_face, sequences.front());
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].X_WO.size(), 31U);
}

TEST(GoalPaths, TumblesAloneRollAlongTheFloor) {
  Case given(upright(0.1, 0.2, 0.3, 0.05));
  given.goal.X_WO_goal = given.goal.X_WO_start;  // only the faces matter
  for (const TumbleSequence& sequence : given.sequences(3)) {
    const Path path = tumbles_alone(given.goal, sequence);
    EXPECT_EQ(path.X_WO.size(), 91U);
    expect_legal(given, path);
    Eigen::Isometry3d X_WO = given.goal.X_WO_start;
    for (const TumbleEdge* edge : sequence) X_WO = tumbled(X_WO, *edge);
    EXPECT_TRUE(path.X_WO.back().isApprox(X_WO, 1e-9));
  }
}

}  // namespace
}  // namespace graspless::fingertip
