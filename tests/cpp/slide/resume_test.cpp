// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/resume.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "graspless/robot/ik.hpp"

#include "complaint.hpp"
#include "paths.hpp"
#include "slide/contact.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

constexpr double kDegree = M_PI / 180;

/// A solved plan of the simple problem, the same for all tests.
const Plan& whole() {
  static const Plan found = plan(simple_problem(), {}, seeded(1));
  if (!found) throw std::runtime_error(found.reason);
  return found;
}

const Segment& slide_of(const Plan& plan) {
  for (const Segment& segment : plan.segments) {
    if (segment.name == "slide") return segment;
  }
  throw std::runtime_error("no slide");
}

Interruption at_row(const Plan& plan, std::size_t row) {
  const Segment& slide = slide_of(plan);
  return {slide.positions.at(row), slide.object_poses.at(row), plan.X_WO_goal};
}

/// The middle of the slide.
Interruption midway(const Plan& plan = whole()) {
  return at_row(plan, slide_of(plan).positions.size() / 2);
}

Eigen::Isometry3d shifted(const Eigen::Isometry3d& X_WO, double x, double y, double z = 0) {
  return Eigen::Translation3d(x, y, z) * X_WO;
}

Eigen::Isometry3d turned(const Eigen::Isometry3d& X_WO, double angle, const Eigen::Vector3d& axis) {
  return X_WO * Eigen::AngleAxisd(angle, axis);
}

TEST(Resume, GoesOnFromEveryRowOfAnUndisturbedSlide) {
  std::mt19937_64 rng(1);
  std::uint64_t seed = 1;
  for (const Support& table : tables()) {
    for (const Object& object : objects()) {
      const Problem problem = make_problem(table, object, random_pose(table, object, rng));
      const Plan plan = slide::plan(problem, {}, seeded(seed++));
      ASSERT_TRUE(plan) << plan.reason;
      const std::size_t rows = slide_of(plan).positions.size();
      for (std::size_t row = 0; row < rows; row += std::max<std::size_t>(1, rows / 5)) {
        const Interruption at = at_row(plan, row);
        const Plan rest = resume(problem, at, {}, seeded(seed));
        ASSERT_TRUE(rest) << rest.reason << " at row " << row << " of " << rows;
        EXPECT_EQ(joined(check(problem, rest)), "");
        EXPECT_EQ(rest.segments.front().name, "slide");
        EXPECT_EQ(rest.segments.front().positions.front(), at.q);
        EXPECT_TRUE(rest.segments.front().object_poses.front().isApprox(at.X_WO, 1e-9));
        EXPECT_GT(rest.overhang, Options{}.min_overhang);
      }
    }
  }
}

TEST(Resume, ReachesTheSameGoalWhereItFits) {
  const Plan rest = resume(simple_problem(), midway(), {}, seeded(3));
  ASSERT_TRUE(rest);
  EXPECT_TRUE(rest.X_WO_goal.isApprox(whole().X_WO_goal, 1e-9));
  EXPECT_NEAR(rest.overhang, whole().overhang, 1e-9);
}

TEST(Resume, TakesAnotherGoalWhereTheFormerOneIsBlocked) {
  int other_edge = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Problem problem = make_problem(tables()[1], objects()[0], flat(0.6, 0.05, 0.3));
    const Plan first = plan(problem, {}, seeded(seed));
    ASSERT_TRUE(first) << first.reason;
    const Eigen::Isometry3d outside =
        first.X_WH_grasp * Eigen::Translation3d(0, 0, -0.1) * Eigen::Isometry3d::Identity();
    const geometry::PlacedShape block{geometry::Box{{0.04, 0.04, 0.04}},
                                      Eigen::Isometry3d::Identity()};
    problem.obstacles = {{"block", {block}, outside}};
    const Plan rest = resume(problem, at_row(first, 2), {}, seeded(3));
    ASSERT_TRUE(rest) << rest.reason;
    EXPECT_EQ(joined(check(problem, rest)), "");
    EXPECT_FALSE(rest.X_WO_goal.isApprox(first.X_WO_goal, 1e-3));
    const auto edge_of = [&](const Plan& plan) {
      return problem.support.polygon().nearest_edge(plan.X_WO_goal.translation().head<2>()).a;
    };
    other_edge += (edge_of(rest) - edge_of(first)).norm() > 1e-9 ? 1 : 0;
  }
  EXPECT_GT(other_edge, 0);
}

/// Distance from the contact to the outline of an object that lies flat about its measured centre
/// of mass; negative beside it.
double inside_of_outline(const Problem& problem, const Interruption& at) {
  const Hand& hand = problem.hand;
  const Eigen::Isometry3d X_WF = problem.robot.pose(problem.robot.frame(hand.fingertip), at.q);
  const Planar contact =
      effective_tip(hand, tip(X_WF), problem.object.thickness(), Options{}.pitch);
  const Eigen::Vector3d com_O = problem.object.com(), com_W = at.X_WO * com_O;
  const double yaw = std::atan2(at.X_WO.linear()(1, 0), at.X_WO.linear()(0, 0));
  const Eigen::Vector2d p_OC =
      com_O.head<2>() + Eigen::Rotation2Dd(-yaw) * (contact.translation() - com_W.head<2>()).eval();
  return problem.object.outline().depth(p_OC);
}

TEST(Resume, FollowsTheMeasuredObject) {
  std::mt19937_64 rng(4);
  std::uniform_real_distribution<double> offset(-0.02, 0.02), yaw(-10 * kDegree, 10 * kDegree);
  const Problem problem = simple_problem();
  int solved = 0, lost = 0;
  constexpr int kPlans = 4, kCases = 60;
  std::vector<Plan> plans;
  for (int i = 0; i < kPlans; ++i) {
    plans.push_back(plan(problem, {}, seeded(static_cast<std::uint64_t>(i) + 1)));
    ASSERT_TRUE(plans.back()) << plans.back().reason;
  }
  for (int i = 0; i < kCases; ++i) {
    const Plan& whole = plans[i % kPlans];
    std::uniform_int_distribution<std::size_t> row(0, slide_of(whole).positions.size() - 1);
    Interruption at = at_row(whole, row(rng));
    at.X_WO = turned(shifted(at.X_WO, offset(rng), offset(rng), offset(rng) / 4), yaw(rng),
                     Eigen::Vector3d::UnitZ());
    at.X_WO = turned(at.X_WO, yaw(rng) / 2, Eigen::Vector3d::UnitX());
    const Plan rest = resume(problem, at, {}, seeded(i));
    if (inside_of_outline(problem, at) < Options{}.rim_margin - 0.001) {
      EXPECT_EQ(rest.status, Status::contact_lost) << rest.reason;
      ++lost;
      continue;
    }
    ASSERT_TRUE(rest) << rest.reason;
    ++solved;
    EXPECT_EQ(joined(check(problem, rest)), "") << i;
    const Eigen::Isometry3d& first = rest.segments.front().object_poses.front();
    const Eigen::Vector3d com = problem.object.com();
    EXPECT_LT((first * com - at.X_WO * com).head<2>().norm(), 1e-9);
    EXPECT_NEAR(first.translation().z(), 0, 1e-12);
  }
  EXPECT_GT(solved, kCases / 2);
  EXPECT_GT(lost, 0);
}

TEST(Resume, TakesMeasuredJointsToTheNearestThatPress) {
  const Problem problem = simple_problem();
  std::mt19937_64 rng(7);
  std::normal_distribution<double> noise(0, 0.01);
  for (int i = 0; i < 30; ++i) {
    Interruption at = midway();
    for (double& q : at.q) q += std::clamp(noise(rng), -0.02, 0.02);
    at.q = at.q.cwiseMax(problem.robot.lower()).cwiseMin(problem.robot.upper());
    const Plan rest = resume(problem, at, {}, seeded(i));
    if (!rest) {
      EXPECT_EQ(rest.status, Status::contact_lost) << rest.reason;
      continue;
    }
    EXPECT_EQ(joined(check(problem, rest)), "") << i;
    EXPECT_LE(problem.robot.step(at.q, rest.segments.front().positions.front()), kMaxCorrection);
  }
}

TEST(Resume, RefusesJointsFarFromTheContact) {
  const Problem problem = simple_problem();
  int far = 0;
  for (const int joint : problem.robot.group("arm")) {
    for (const double angle : {-0.15, 0.15}) {
      Interruption at = midway();
      at.q[joint] += angle;
      const Plan rest = resume(problem, at, {}, seeded(1));
      if (rest) {
        EXPECT_EQ(joined(check(problem, rest)), "") << joint;
      } else {
        EXPECT_EQ(rest.status, Status::contact_lost) << rest.reason;
        far += rest.reason.find("from the nearest configuration") < 200 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(far, 0);
}

void expect_goes_on(const Problem& problem, std::uint64_t seed) {
  const Plan first = plan(problem, {}, seeded(seed));
  ASSERT_TRUE(first) << first.reason;
  Interruption at = at_row(first, slide_of(first).positions.size() / 2);
  at.X_WO = problem.support.X_WS() *
            shifted(problem.support.X_WS().inverse() * at.X_WO, 0.003, -0.002, 0.004);
  Options options;
  options.rim_margin = 0.001;
  const Plan rest = resume(problem, at, options, seeded(seed)),
             anew = restart(problem, at, options, seeded(seed));
  ASSERT_TRUE(rest) << rest.reason;
  EXPECT_EQ(joined(check(problem, rest, options)), "");
  ASSERT_TRUE(anew) << anew.reason;
  EXPECT_EQ(joined(check(problem, anew, options)), "");
}

TEST(Resume, WorksWithEveryFingerModel) {
  for (const FingerModel model :
       {FingerModel::none, FingerModel::impedance, FingerModel::rigid_guarded}) {
    Problem problem = simple_problem();
    problem.hand.finger_model = model;
    if (model == FingerModel::impedance) problem.hand.wrist_stiffness = 600;
    expect_goes_on(problem, 1);
  }
}

TEST(Resume, WorksOnATiltedTableAndWithSixJoints) {
  const Eigen::Isometry3d X_WS = Eigen::Translation3d(0.35, -0.4, 0.05) *
                                 Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, -1, 0).normalized());
  expect_goes_on(make_problem(Support(geometry::l_shape(), X_WS), objects()[0], flat(0.15, 0.4, 1)),
                 1);
  expect_goes_on(
      {kr5(), Hand{}, objects()[0], tables()[0], flat(0.6, 0.1, 0.2), {}, kr5().state("home")}, 2);
}

TEST(Resume, StopsInTime) {
  planning::Budget budget = seeded(1);
  budget.interrupted = [] { return true; };
  EXPECT_EQ(resume(simple_problem(), midway(), {}, budget).status, Status::interrupted);
  EXPECT_EQ(restart(simple_problem(), midway(), {}, budget).status, Status::interrupted);
  budget = seeded(1);
  budget.iterations = 0;
  EXPECT_FALSE(resume(simple_problem(), midway(), {}, budget));
}

struct Lost {
  Interruption at;
  Status status;
  std::string reason;
};

TEST(Resume, SaysWhyNoSlideCanGoOn) {
  const Problem problem = simple_problem();
  const Interruption good = midway();
  const auto moved = [&](const Eigen::Isometry3d& X_WO) { return Interruption{good.q, X_WO, {}}; };
  const auto with_q = [&](const Eigen::VectorXd& q) { return Interruption{q, good.X_WO, {}}; };
  const Eigen::VectorXd closed = problem.robot.state("closed", good.q),
                        ajar = good.q + 0.3 * (closed - good.q);
  const std::vector<Lost> cases{
      {moved(shifted(good.X_WO, 0, 0, 0.03)), Status::off_support, "30 mm above the support"},
      {moved(shifted(good.X_WO, 0, 0, -0.4)), Status::off_support, "400 mm below the support"},
      {moved(turned(good.X_WO, 0.3, Eigen::Vector3d::UnitY())), Status::off_support, "tilted by"},
      {moved(turned(good.X_WO, M_PI, Eigen::Vector3d::UnitY())), Status::off_support, "tilted by"},
      {moved(shifted(good.X_WO, 0.2, 0)), Status::contact_lost, "beside the object"},
      {with_q(problem.q_home), Status::contact_lost, "above the object's top face"},
      {with_q(whole().segments[3].positions.back()), Status::contact_lost, "above the object's"},
      {with_q(ajar), Status::contact_lost, "joint 'left_finger_joint'"},
  };
  for (const Lost& lost : cases) {
    const Plan rest = resume(problem, lost.at, {}, seeded(1));
    EXPECT_EQ(rest.status, lost.status) << rest.reason;
    EXPECT_NE(rest.reason.find(lost.reason), std::string::npos) << rest.reason;
    EXPECT_TRUE(rest.segments.empty());
    EXPECT_FALSE(rest);
  }
}

TEST(Resume, KeepsAwayFromTheRim) {
  const Problem problem = simple_problem();
  Interruption at = midway();
  Options edge;
  edge.rim_margin = 0;
  // Moves the object until the contact comes near its outline.
  bool near = false;
  for (double x = 0; x < 0.1 && !near; x += 0.001) {
    const Interruption there{at.q, shifted(at.X_WO, x, 0), {}};
    const Plan kept = resume(problem, there, {}, seeded(1));
    if (kept) continue;
    EXPECT_EQ(kept.status, Status::contact_lost);
    EXPECT_NE(kept.reason.find("options.rim_margin"), std::string::npos) << kept.reason;
    EXPECT_TRUE(resume(problem, there, edge, seeded(1)));
    near = true;
  }
  EXPECT_TRUE(near);
}

TEST(Resume, StopsAtAnObstacleThatTouches) {
  Problem problem = simple_problem();
  const Eigen::Isometry3d X_WO = midway().X_WO;
  const geometry::PlacedShape box{geometry::Box{{0.02, 0.02, 0.02}}, Eigen::Isometry3d::Identity()};
  problem.obstacles = {{"box", {box}, Eigen::Isometry3d(Eigen::Translation3d(X_WO.translation()))}};
  const Plan rest = resume(problem, midway(), {}, seeded(1));
  EXPECT_EQ(rest.status, Status::start_in_collision);
  EXPECT_NE(rest.reason.find("'box'"), std::string::npos) << rest.reason;
}

TEST(Restart, LiftsOffAndBeginsAnewWhereTheContactIsLost) {
  const Problem problem = simple_problem();
  int lost = 0;
  for (const double x : {0.0, 0.02, 0.05, 0.1, 0.15}) {
    const Interruption at{midway().q, shifted(midway().X_WO, x, 0.01), {}};
    if (!resume(problem, at, {}, seeded(1, 1))) ++lost;
    const Plan anew = restart(problem, at, {}, seeded(1));
    ASSERT_TRUE(anew) << anew.reason;
    EXPECT_EQ(joined(check(problem, anew)), "") << x;
    ASSERT_EQ(anew.segments.size(), 8U);
    EXPECT_EQ(anew.segments.front().name, "retreat");
    EXPECT_EQ(anew.segments.front().positions.front(), at.q);
    EXPECT_TRUE(anew.segments[1].object_poses.front().isApprox(at.X_WO, 1e-9));
  }
  EXPECT_GT(lost, 1);
}

TEST(Restart, BeginsAboveTheObjectToo) {
  const Problem problem = simple_problem();
  const std::vector<Eigen::VectorXd>& lift = whole().segments[3].positions;
  for (const Eigen::VectorXd& q : {problem.q_home, lift.back(), lift[lift.size() / 2]}) {
    const Plan anew = restart(problem, {q, midway().X_WO, {}}, {}, seeded(2));
    ASSERT_TRUE(anew) << anew.reason;
    EXPECT_EQ(joined(check(problem, anew)), "");
  }
}

TEST(Restart, SaysWhyItCannotBegin) {
  const Problem problem = simple_problem();
  const Interruption good = midway();
  const Eigen::VectorXd closed = problem.robot.state("closed", good.q);
  const Eigen::Isometry3d beyond = shifted(good.X_WO, 1.0 - good.X_WO.translation().x() + 0.02, 0);
  const std::vector<Lost> cases{
      {{good.q, shifted(good.X_WO, 0, 0, 0.03), {}}, Status::off_support, "above the support"},
      {{good.q, beyond, {}}, Status::off_support, "centre of mass is beyond"},
      {{closed, good.X_WO, {}}, Status::contact_lost, "the hand is not open"},
  };
  for (const Lost& lost : cases) {
    const Plan anew = restart(problem, lost.at, {}, seeded(1));
    EXPECT_EQ(anew.status, lost.status) << anew.reason;
    EXPECT_NE(anew.reason.find(lost.reason), std::string::npos) << anew.reason;
    EXPECT_TRUE(anew.segments.empty());
  }
}

TEST(Restart, DoesNotLeaveAHollowObjectThatTipsOverACorner) {
  Problem problem = simple_problem();
  const geometry::Polygon& Q = problem.support.polygon();
  const Eigen::Vector2d corner = Q.vertices().col(0);
  const Object plate = Object::from_polygon("plate", disc(0.09, 60, {0, 0}), 0.01);
  Eigen::Isometry3d X_SO = Eigen::Isometry3d::Identity();
  X_SO.translation().head<2>() = corner + 0.06 * (Q.centroid() - corner).normalized();
  const Interruption at{problem.q_home, problem.support.X_WS() * X_SO, {}};
  problem.object = plate;
  EXPECT_EQ(restart(problem, at, {}, seeded(1)).reason.find("centre of mass"), std::string::npos);
  problem.object = plate.with_hollow(true);
  const Plan anew = restart(problem, at, {}, seeded(1));
  EXPECT_EQ(anew.status, Status::off_support) << anew.reason;
  EXPECT_NE(anew.reason.find("the part of the rim that is on the support"), std::string::npos);
}

TEST(Restart, CheckFindsARetreatThatDragsTheObject) {
  const Problem problem = simple_problem();
  const Plan good = restart(problem, midway(), {}, seeded(1));
  ASSERT_TRUE(good) << good.reason;
  EXPECT_EQ(joined(check(problem, good)), "");
  Plan edited = good;
  Segment& retreat = edited.segments.front();
  for (std::size_t i = 1; i + 1 < retreat.positions.size(); ++i) retreat.positions[i][0] += 0.01;
  EXPECT_NE(joined(check(problem, edited)).find("the contact moves"), std::string::npos);
  edited = good;
  edited.segments.erase(edited.segments.begin());
  EXPECT_NE(joined(check(problem, edited)).find("segments are not slide"), std::string::npos);
}

TEST(Resume, RefusesWhatIsNoState) {
  const Problem problem = simple_problem();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto complaint_of = [&](const Interruption& at) {
    return complaint([&] { resume(problem, at); });
  };
  Interruption at = midway();
  at.q[1] = nan;
  EXPECT_NE(complaint_of(at).find("q must have"), std::string::npos);
  at = midway();
  at.q.conservativeResize(3);
  EXPECT_NE(complaint_of(at).find("finite values, not 3"), std::string::npos);
  at = midway();
  at.X_WO.linear() *= 2;
  EXPECT_NE(complaint_of(at).find("X_WO"), std::string::npos);
  at = midway();
  at.X_WO.translation().x() = nan;
  EXPECT_NE(complaint_of(at).find("X_WO"), std::string::npos);
  at = midway();
  at.X_WO_goal->linear().col(0) *= -1;
  EXPECT_NE(complaint_of(at).find("X_WO_goal"), std::string::npos);
}

TEST(Resume, IsTheSameForTheSameSeed) {
  Interruption at = midway();
  at.X_WO = turned(shifted(at.X_WO, 0.004, -0.006), 0.1, Eigen::Vector3d::UnitZ());
  at.X_WO_goal.reset();
  const Plan a = resume(simple_problem(), at, {}, seeded(5)),
             b = resume(simple_problem(), at, {}, seeded(5));
  ASSERT_TRUE(a) << a.reason;
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    EXPECT_EQ(a.segments[i].positions, b.segments[i].positions);
  }
}

// With one start, Algorithm 1 finds a plan with about every second seed before its roots are spent.
TEST(Resume, WorksWithAlgorithmOneAsWritten) {
  constexpr std::uint64_t kPlans = 4, kSeeds = 6;
  Options options;
  options.search = Search::paper;
  const Problem problem = simple_problem();
  for (std::uint64_t i = 1; i <= kPlans; ++i) {
    const Plan first = plan(problem, {}, seeded(i));
    ASSERT_TRUE(first) << first.reason;
    Plan rest;
    for (std::uint64_t seed = 1; !rest && seed <= kSeeds; ++seed) {
      planning::Budget budget = seeded(seed, 60);
      budget.iterations = 2000;
      rest = resume(problem, midway(first), options, budget);
    }
    ASSERT_TRUE(rest) << rest.reason;
    EXPECT_EQ(joined(check(problem, rest, options)), "");
  }
}

TEST(Resume, CheckFindsWhatWasEdited) {
  const Problem problem = simple_problem();
  const Plan good = resume(problem, midway(), {}, seeded(1));
  ASSERT_TRUE(good);
  const auto faults_after = [&](const auto& edit) {
    Plan edited = good;
    edit(edited);
    return joined(check(problem, edited));
  };
  EXPECT_EQ(faults_after([](Plan&) {}), "");
  const auto has = [](const std::string& faults, const std::string& what) {
    return faults.find(what) != std::string::npos;
  };
  EXPECT_TRUE(has(faults_after([](Plan& p) { p.resumed.reset(); }), "segments are not approach"));
  EXPECT_TRUE(has(faults_after([](Plan& p) { p.resumed->q[0] += 0.1; }), "was interrupted"));
  EXPECT_TRUE(has(faults_after([](Plan& p) { p.resumed->X_WO.translation().x() += 0.01; }),
                  "not at its start"));
  EXPECT_TRUE(has(faults_after([](Plan& p) { p.resumed->X_WO.translation().z() += 0.03; }),
                  "does not lie flat"));
  EXPECT_TRUE(has(faults_after([](Plan& p) { p.resumed->q.conservativeResize(2); }), "resumed"));
  EXPECT_TRUE(has(faults_after([](Plan& p) {
                    for (auto& X : p.segments[0].object_poses) X.translation().y() += 0.05;
                    p.resumed->X_WO.translation().y() += 0.05;
                  }),
                  "contact"));
}

/// Configurations that press where a plan does at `row`, with links as near as plans never bring
/// them.
std::vector<Eigen::VectorXd> near_configurations(const Problem& problem, const Plan& plan,
                                                 std::size_t row) {
  const int F = problem.robot.frame(problem.hand.fingertip);
  const robot::Ik ik(problem.robot, F, problem.robot.group(problem.hand.arm), {});
  const Eigen::VectorXd& q = slide_of(plan).positions.at(row);
  const Eigen::Isometry3d X_WF = problem.robot.pose(F, q);
  const int joint = *ik.free_joint();
  std::vector<Eigen::VectorXd> near, solutions;
  for (double value = problem.robot.lower()[joint]; value < problem.robot.upper()[joint];
       value += 5e-4) {
    solutions.clear();
    ik.solve_free(X_WF, value, q, solutions);
    for (const Eigen::VectorXd& solution : solutions) {
      const bool is_near = !are_links_apart(problem.robot, solution, 1.5e-3);
      if (is_near && are_links_apart(problem.robot, solution, 1e-4)) near.push_back(solution);
    }
  }
  return near;
}

TEST(Resume, GoesOnWhereLinksAreNear) {
  const Problem problem = simple_problem();
  const std::size_t row = slide_of(whole()).positions.size() / 2;
  int found = 0, solved = 0, lifted = 0;
  for (const Eigen::VectorXd& q : near_configurations(problem, whole(), row)) {
    const Interruption at{q, slide_of(whole()).object_poses.at(row), std::nullopt};
    ++found;
    solved += static_cast<bool>(resume(problem, at, {}, seeded(1)));
    lifted += static_cast<bool>(restart(problem, at, {}, seeded(1)));
    if (found == 6) break;
  }
  ASSERT_GT(found, 0);
  EXPECT_GT(solved, 0);
  EXPECT_GT(lifted, 0);
}

}  // namespace
}  // namespace graspless::slide
