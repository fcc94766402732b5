// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/thread_search.hpp"

#include <gtest/gtest.h>

#include "graspless/geometry/linking.hpp"

#include "clasp/grip.hpp"
#include "clasp/ring_problem.hpp"

namespace graspless::clasp {
namespace {

/// A ring with a hole of 36 mm, for one finger of 27 mm and the thumb.
Problem narrow_ring() {
  Problem problem = ring_problem();
  problem.object = Object::from_cloud("narrow ring", ring_cloud(0.022, 0.008, 40));
  problem.hand.fingers.resize(1);
  return problem;
}

struct Threaded {
  Threaded()
      : clock(planning::Budget{std::numeric_limits<double>::infinity(), 100, 1, {}}, 4e9),
        query(problem, options, clock, 1, hand_width(problem)),
        search(query, choose_targets(query, problem.q_start, plan).front(), problem.q_start) {}

  /// Runs cycles until a sample is found.
  bool found() {
    for (int i = 0; i < 100; ++i) {
      if (search.cycle()) return true;
    }
    return false;
  }

  const Problem problem = narrow_ring();
  const Options options;
  planning::Clock clock;
  Plan plan;
  Query query;
  ThreadSearch search;
};

TEST(ThreadSearch, PutsAFingerOrTheThumbThroughTheHole) {
  Threaded t;
  const geometry::Loops& loops = t.problem.object.loops();
  const Eigen::Matrix3Xd loop_W = t.problem.X_WO * loops.found[0].points;
  for (int sample = 0; sample < 5; ++sample) {
    ASSERT_TRUE(t.found());
    const Eigen::VectorXd q = t.search.path().back();
    EXPECT_TRUE(t.query.free.is_free(q));
    HandKinematics hand(t.problem.robot, t.problem.hand);
    hand.update(q);
    EXPECT_GT(std::abs(geometry::virtual_linking(loop_W, hand.curve_points(0))), 0.3);
    double least = 1;  // from the hole's centre to the curve
    const Eigen::Matrix3Xd curve = hand.curve_points(0);
    for (Eigen::Index i = 0; i + 1 < curve.cols(); ++i) {
      for (double u = 0; u <= 1; u += 0.01) {
        const Eigen::Vector3d p = (1 - u) * curve.col(i) + u * curve.col(i + 1);
        least = std::min(least, (p - t.problem.X_WO.translation()).norm());
      }
    }
    EXPECT_LT(least, 0.018);
  }
  EXPECT_GT(t.search.effort().cycles, 0);
}

TEST(ThreadSearch, LeadsThereFromTheStart) {
  Threaded t;
  int connected = 0;
  for (int sample = 0; sample < 10 && connected < 2; ++sample) {
    ASSERT_TRUE(t.found());
    planning::Path reach = t.search.path();
    const Eigen::VectorXd q = reach.back();
    if (!t.search.connect(reach)) continue;
    ++connected;
    EXPECT_EQ(reach.front(), t.problem.q_start);
    EXPECT_EQ(reach.back(), q);
    for (std::size_t i = 1; i < reach.size(); ++i)
      EXPECT_TRUE(t.query.is_motion_free(reach[i - 1], reach[i])) << "row " << i;
    const Tree tree = t.search.tree();
    EXPECT_EQ(tree.path.size(), reach.size());
    EXPECT_EQ(tree.p_W.cols(), static_cast<Eigen::Index>(reach.size()));
    EXPECT_EQ(tree.path.front(), tree.parents.front());
  }
  EXPECT_EQ(connected, 2);
}

}  // namespace
}  // namespace graspless::clasp
