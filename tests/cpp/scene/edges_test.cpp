// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/edges.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "robot/robots.hpp"

namespace graspless::scene {
namespace {

using Eigen::VectorXd;
using geometry::PlacedShape;

Eigen::Isometry3d at(const Eigen::Vector3d& p) {
  return Eigen::Isometry3d(Eigen::Translation3d(p));
}

/// A few balls, boxes and dented boxes around the robot.
void add_clutter(Replay& replay, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 6; ++i) {
    const double angle = 2 * M_PI * unit(rng), radius = 0.25 + 0.6 * unit(rng);
    const Eigen::Vector3d p(radius * std::cos(angle), radius * std::sin(angle), 1.2 * unit(rng));
    const double size = 0.02 + 0.15 * unit(rng);
    const geometry::Shape shape = i % 2 == 0 ? geometry::Shape(geometry::Sphere{size / 2})
                                             : geometry::Shape(geometry::Box{{size, size, size}});
    replay.add({"clutter " + std::to_string(i), {PlacedShape{shape}}, at(p)});
  }
}

/// Rows at equal steps of at most 0.05 rad on a random straight motion.
std::vector<VectorXd> random_rows(const robot::Robot& robot, std::mt19937_64& rng) {
  const VectorXd from = robot::random_q(robot, rng), to = robot::random_q(robot, rng);
  const int steps = static_cast<int>(std::ceil(0.2 * robot.step(from, to) / 0.05));
  std::vector<VectorXd> rows;
  for (int i = 0; i <= steps; ++i) rows.push_back(from + 0.2 * i / steps * (to - from));
  return rows;
}

/// Number of configurations that touch, at joint steps of 1e-4 rad on an edge.
int count_touching(Replay& replay, const VectorXd& from, const VectorXd& to) {
  const int steps = std::max(1, static_cast<int>(std::ceil(replay.robot().step(from, to) / 1e-4)));
  int touching = 0;
  robot::Poses X_WL;
  for (int i = 0; i <= steps; ++i) {
    replay.robot().forward(from + (to - from) * i / steps, X_WL);
    replay.place(X_WL);
    touching += replay.world().collides();
  }
  return touching;
}

TEST(EdgeProver, AgreesWithDenseSampling) {
  std::mt19937_64 rng(17);
  int proven = 0, refuted = 0;
  for (int sample = 0; sample < 60; ++sample) {
    Replay replay(sample % 2 == 0 ? robot::wam() : robot::kr5());
    add_clutter(replay, rng);
    const std::vector<VectorXd> rows = random_rows(replay.robot(), rng);
    const std::vector<Doubt> doubts = EdgeProver("move", rows, replay, {}).run();
    std::vector<bool> is_doubted(rows.size(), false);
    for (const Doubt& doubt : doubts) {
      is_doubted[doubt.row] = true;
      EXPECT_EQ(doubt.verdict, Verdict::refuted) << doubt.text();
      const VectorXd q = rows[doubt.row - 1] + doubt.t * (rows[doubt.row] - rows[doubt.row - 1]);
      EXPECT_GT(count_touching(replay, q, q), 0) << doubt.text();
      ++refuted;
    }
    for (std::size_t row = 1; row < rows.size(); row += 7) {
      if (is_doubted[row]) continue;
      EXPECT_EQ(count_touching(replay, rows[row - 1], rows[row]), 0) << sample << " " << row;
      ++proven;
    }
  }
  EXPECT_GT(proven, 30);
  EXPECT_GT(refuted, 100);
}

/// Amount by which an edge is refuted on which a fingertip passes over a ball, `depth` deeper than
/// it could without a touch; 0 if it is proven.
double graze(double depth) {
  Replay replay(robot::wam());
  const robot::Robot& robot = replay.robot();
  VectorXd from = robot.state("home"), to = from;
  to[0] += 0.05;  // about the vertical
  const Eigen::Vector3d p =
      robot.pose(robot.frame("left_fingertip"), (from + to) / 2).translation();
  const int ball = replay.add("ball", collision::Solid({{geometry::Sphere{0.01}}}), false);
  const auto touches = [&](double t, double below) {
    replay.world().set_pose(ball, at(p - below * Eigen::Vector3d::UnitZ()));
    robot::Poses X_WL;
    robot.forward(from + t * (to - from), X_WL);
    replay.place(X_WL);
    return replay.world().collides();
  };
  const auto touches_anywhere = [&](double below) {
    for (int i = 0; i <= 500; ++i) {
      if (touches(i / 500.0, below)) return true;
    }
    return false;
  };
  double near = 0, far = 1;
  while (far - near > 1e-9) {
    (touches_anywhere((near + far) / 2) ? near : far) = (near + far) / 2;
  }
  EXPECT_FALSE(touches(0, near - depth) || touches(1, near - depth)) << "rows must be free";
  const std::vector<VectorXd> rows{from, to};
  const auto doubts = EdgeProver("move", rows, replay, {}).run();
  if (doubts.empty()) return 0;
  EXPECT_EQ(doubts.front().condition.find("collision"), 0u);
  return doubts.front().verdict == Verdict::refuted ? doubts.front().amount : -1;
}

TEST(EdgeProver, FindsWhatTouchesOnlyBetweenTwoRows) {
  EXPECT_EQ(graze(-1e-5), 0);
  EXPECT_EQ(graze(-2e-6), 0);
  EXPECT_GT(graze(2e-6), 0);
  EXPECT_GT(graze(2e-5), 0);
}

/// A closed box with a dent in its top.
geometry::Mesh dented_box(double half) {
  geometry::Mesh box;
  box.vertices.resize(3, 9);
  for (int i = 0; i < 8; ++i)
    box.vertices.col(i) << (i & 1 ? half : -half), (i & 2 ? half : -half), (i & 4 ? half : -half);
  box.vertices.col(8) << 0, 0, 0.9 * half;
  box.triangles.resize(3, 14);
  box.triangles << 0, 1, 4, 5, 7, 6, 0, 2, 1, 3, 0, 1, 2, 3,  //
      2, 2, 5, 7, 6, 4, 4, 4, 3, 7, 1, 5, 6, 6,               //
      1, 3, 8, 8, 8, 8, 2, 6, 5, 5, 4, 4, 3, 7;
  return box;
}

TEST(EdgeProver, FindsABodyThatIsSwallowed) {
  const geometry::Mesh room = dented_box(5);  // around the whole robot
  for (const double aside : {0.0, 20.0}) {
    Replay replay(robot::wam());
    replay.add({"room", {PlacedShape{room}}, at({aside, 0, 0})});
    const VectorXd home = replay.robot().state("home");
    VectorXd to = home;
    to[0] += 0.05;
    const std::vector<VectorXd> rows{home, to};
    const auto doubts = EdgeProver("move", rows, replay, {}).run();
    EXPECT_EQ(doubts.size(), aside == 0 ? 1u : 0u);
    EXPECT_EQ(replay.touching(home).empty(), aside != 0);
  }
}

TEST(EdgeProver, DoubtsTheEdgesOnWhichABodyIsInsideAClosedMesh) {
  Replay replay(robot::wam());
  const int ball = replay.add({"ball", {PlacedShape{geometry::Sphere{0.002}}}, at({3, 3, 0})});
  const int box = replay.add({"box", {PlacedShape{dented_box(0.3)}}, at({2, 3, 0})});
  replay.world().add_pair(ball, box);
  constexpr double kStep = 0.097;  // of the box, along x; it covers the ball from 2.7 to 3.3
  const std::vector<VectorXd> rows(21, replay.robot().state("home"));
  Companion moving;
  moving.body = box;
  moving.place = [&](std::size_t edge, double t, const robot::Poses&) {
    replay.world().set_pose(box, at({2 + kStep * (static_cast<double>(edge) + t), 3, 0}));
  };
  moving.length = [](std::size_t, double t0, double t1) { return kStep * (t1 - t0); };
  std::set<std::size_t> doubted;
  for (const Doubt& doubt : EdgeProver("move", rows, replay, moving).run()) {
    EXPECT_EQ(doubt.verdict, Verdict::refuted) << doubt.text();
    doubted.insert(doubt.row);
  }
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const double from = 2 + kStep * static_cast<double>(row - 1), to = from + kStep;
    EXPECT_EQ(doubted.count(row) == 1, to > 2.698 && from < 3.302) << row;
  }
}

}  // namespace
}  // namespace graspless::scene
