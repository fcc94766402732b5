// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <functional>

#include <gtest/gtest.h>

#include "carry/place_search.hpp"
#include "carry/problems.hpp"
#include "complaint.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

TEST(CarryPlace, PutsTheObjectWhereItIsAsked) {
  for (const robot::Robot* robot : {&wam(), &kr5()}) {
    for (const double yaw : {0.0, 1.0, -2.0}) {
      const Problem problem = over_table(*robot, {on_table(0.5, -0.2, yaw)});
      Plan found = plan(problem);
      ASSERT_TRUE(found) << found.reason;
      EXPECT_EQ(faults_of(problem, found), "");
      EXPECT_EQ(found.place, 0);
      const Isometry3d end = segment(found, "retreat").object_poses.back();
      EXPECT_LT((end.matrix() - on_table(0.5, -0.2, yaw).matrix()).norm(), 1e-6);
      EXPECT_TRUE(certify(problem, found));
    }
  }
}

TEST(CarryPlace, HoldsTheObjectLevelOnTheWay) {
  Options options;
  options.max_tilt = 0.03;
  const Problem problem = over_table(wam(), {on_table(0.5, -0.2, 0.6)});
  Plan found = plan(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(faults_of(problem, found, options), "");
  for (const Isometry3d& X : segment(found, "transfer").object_poses)
    EXPECT_GT(-(X.linear() * Vector3d::UnitZ()).z(), std::cos(0.03) - 1e-9);
}

TEST(CarryPlace, GoesOnToTheNextPlaceIfOneIsTaken) {
  Problem problem = over_table(wam(), {on_table(0.5, -0.2), on_table(0.6, 0.2)});
  problem.obstacles.push_back(
      box("cup", {0.05, 0.05, 0.1}, moved(Isometry3d::Identity(), {0.5, -0.2, kTop + 0.05})));
  const Plan found = plan(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(found.place, 1);
  EXPECT_EQ(faults_of(problem, found), "");
  problem.places->X_WO.pop_back();
  const Plan none = plan(problem);
  EXPECT_EQ(none.status, Status::no_place);
  EXPECT_NE(none.reason.find("'cup'"), std::string::npos) << none.reason;
}

TEST(CarryPlace, SaysThatTheBudgetRanOut) {
  const Problem problem = over_table(wam(), {on_table(3, 0), on_table(0.6, 0.2)});
  planning::Budget budget;
  budget.iterations = 0;
  EXPECT_EQ(plan(problem, {}, budget).reason,
            "no place was tried; the budget ran out before everything was tried");
  budget.iterations = 1;
  EXPECT_EQ(plan(problem, {}, budget).reason,
            "none of the 1 places tried works; most frequent obstruction: out of the arm's reach; "
            "the budget ran out before everything was tried");
  budget.iterations = 2;
  EXPECT_TRUE(plan(problem, {}, budget));
}

TEST(CarryPlace, GoesAroundObstacles) {
  Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  problem.obstacles.push_back(
      box("wall", {0.3, 0.01, 0.4}, moved(Isometry3d::Identity(), {0.6, -0.05, kTop + 0.2})));
  const Plan found = plan(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(faults_of(problem, found), "");
  EXPECT_GT(found.segments[0].positions.size(), 10U);
}

TEST(CarryPlace, NeedsRoomForTheOpenHand) {
  Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  const Vector3d beside(0.5, -0.2 + 0.045, kTop + 0.04);  // where a finger opens
  problem.obstacles.push_back(
      box("post", {0.02, 0.02, 0.08}, moved(Isometry3d::Identity(), beside)));
  const Plan found = plan(problem);
  EXPECT_EQ(found.status, Status::no_place);
  EXPECT_NE(found.reason.find("'post'"), std::string::npos) << found.reason;
}

TEST(CarryPlace, SaysThatTheArmDoesNotReach) {
  const Plan found = plan(over_table(wam(), {on_table(3, 0)}));
  EXPECT_EQ(found.status, Status::no_place);
  EXPECT_NE(found.reason.find("reach"), std::string::npos) << found.reason;
}

TEST(CarryPlace, IsTheSameEveryTime) {
  const Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  const Plan a = plan(problem), b = plan(problem);
  for (std::size_t i = 0; i < a.segments.size(); ++i)
    EXPECT_EQ(a.segments[i].positions, b.segments[i].positions);
}

/// A change of a good plan, and words of the fault that check() must find.
struct Mutant {
  std::string words;
  std::function<void(Plan&)> change;
};

TEST(CarryPlaceCheck, FindsWhatIsWrong) {
  const Problem problem = over_table(wam(), {on_table(0.5, -0.2), on_table(0.6, 0.2)});
  const Plan good = plan(problem);
  ASSERT_TRUE(good) << good.reason;
  const int finger = wam().joint("left_finger_joint"), elbow = wam().group("arm")[3];
  const auto middle = [](Plan& p, const std::string& name) -> VectorXd& {
    auto& rows = segment(p, name).positions;
    return rows[rows.size() / 2];
  };
  const std::vector<Mutant> mutants{
      {"segments are not transfer, lower", [](Plan& p) { p.segments.pop_back(); }},
      {"segments are not transfer, lower",
       [](Plan& p) { std::swap(p.segments[0], p.segments[1]); }},
      {"reached must be 1", [](Plan& p) { p.reached = 0.5; }},
      {"place must lie in", [](Plan& p) { p.place = 2; }},
      {"is not at its place", [](Plan& p) { p.place = 1; }},
      {"is not q_start", [&](Plan& p) { segment(p, "transfer").positions[0][elbow] += 1e-3; }},
      {"moves relative to the hand",
       [](Plan& p) { segment(p, "lower").object_poses[3].translation().x() += 1e-4; }},
      {"off its straight path", [&](Plan& p) { middle(p, "lower")[elbow] += 0.01; }},
      {"outside the arm's group", [&](Plan& p) { middle(p, "transfer")[finger] += 0.01; }},
      {"outside the arm's group", [&](Plan& p) { middle(p, "retreat")[finger] += 0.01; }},
      {"the arm moves", [&](Plan& p) { middle(p, "open")[elbow] += 0.01; }},
      {"leaves its straight path", [&](Plan& p) { middle(p, "retreat")[elbow] += 0.01; }},
      {"retreat away",
       [](Plan& p) {
         segment(p, "retreat").positions.resize(2);
         segment(p, "retreat").object_poses.resize(2);
       }},
      {"is not at its place",
       [](Plan& p) { segment(p, "retreat").object_poses.back().translation().z() -= 1e-3; }},
      {"a value that is not finite", [&](Plan& p) { middle(p, "open")[elbow] = NAN; }},
  };
  for (const Mutant& mutant : mutants) {
    Plan bad = good;
    mutant.change(bad);
    const std::string faults = faults_of(problem, bad);
    EXPECT_NE(faults.find(mutant.words), std::string::npos) << mutant.words << " in: " << faults;
  }
}

TEST(CarryPlaceCheck, FindsWhatIsTouched) {
  const Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  const Plan good = plan(problem);
  ASSERT_TRUE(good);
  const auto with_post = [&](const Vector3d& at) {
    Problem other = problem;
    other.obstacles.push_back(
        box("post", {0.004, 0.004, 0.004}, moved(Isometry3d::Identity(), at)));
    return faults_of(other, good);
  };
  for (const Segment& part : good.segments) {
    const Vector3d at =
        wam().pose(wam().frame("left_finger"), part.positions.back()) * Vector3d::Zero();
    EXPECT_NE(with_post(at).find("post"), std::string::npos) << part.name;
  }
  Problem tighter = problem;  // tilts more than it may
  Options options;
  options.max_tilt = 1e-5;
  EXPECT_NE(faults_of(tighter, good, options).find("max_tilt"), std::string::npos);
  options = {};
  options.height = 0.1;
  EXPECT_NE(faults_of(problem, good, options).find("height"), std::string::npos);
}

TEST(CarryPlaceCheck, TestsTheOpenHandAgainstTheObject) {
  Problem problem = over_table(wam(), {on_table(0.5, -0.2)});
  Plan found = plan(problem);
  ASSERT_TRUE(found);
  problem.places->q_open = problem.q_start;  // a hand that stays closed touches a wider bar
  problem.object = box("box", {0.10, 0.055, 0.03}, problem.object.X_WB);
  segment(found, "open").positions.assign(1, segment(found, "open").positions.front());
  segment(found, "open").object_poses.resize(1);
  for (VectorXd& q : segment(found, "retreat").positions)
    q[wam().joint("left_finger_joint")] = problem.q_start[wam().joint("left_finger_joint")];
  EXPECT_NE(faults_of(problem, found).find("retreat row 0: collision"), std::string::npos)
      << faults_of(problem, found);
}

TEST(CarryPlaceValidate, NamesTheField) {
  const Problem good = over_table(wam(), {on_table(0.5, -0.2), on_table(0.6, 0.2)});
  const auto refused = [&](auto change, const char* words) {
    Problem bad = good;
    change(*bad.places);
    expect_refused([&] { plan(bad); }, words);
  };
  refused([](Places& p) { p.on = "shelf"; }, "places.on: there is no obstacle 'shelf'");
  refused([](Places& p) { p.X_WO.clear(); }, "places.X_WO");
  refused([](Places& p) { p.X_WO[1].translation().x() = NAN; }, "places.X_WO[1]");
  refused([](Places& p) { p.X_WO[1].linear() = Eigen::Matrix3d::Identity(); }, "places.X_WO[1]");
  refused([](Places& p) { p.normal_W *= 2; }, "normal_W must have unit length");
  refused([](Places& p) { p.q_open.conservativeResize(3); }, "places.q_open");
  refused([](Places& p) { p.way_out = {p.q_open, Eigen::VectorXd::Zero(3)}; }, "places.way_out[1]");
  Options options;
  options.max_tilt = 0;
  expect_refused([&] { plan(good, options); }, "options.max_tilt");
}

}  // namespace
}  // namespace graspless::carry
