// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/slide.hpp"

#include <atomic>
#include <fstream>
#include <iterator>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "paths.hpp"
#include "slide/problems.hpp"
#include "slide/task/hand_frames.hpp"

namespace graspless::slide {
namespace {

void expect_holds(const Problem& problem, const Options& options, std::uint64_t seed) {
  const Plan found = plan(problem, options, seeded(seed));
  ASSERT_TRUE(found) << "seed " << seed << ": " << found.reason;
  EXPECT_EQ(joined(check(problem, found, options)), "") << "seed " << seed;
}

TEST(Plan, HoldsOnEveryTableWithEveryObject) {
  std::mt19937_64 rng(1);
  std::uint64_t seed = 1;
  for (const Support& table : tables()) {
    for (const Object& object : objects()) {
      expect_holds(make_problem(table, object, random_pose(table, object, rng)), {}, seed++);
    }
  }
}

TEST(Plan, HoldsInThePapersOwnTerms) {
  std::mt19937_64 rng(2);
  std::uint64_t seed = 1;
  for (const double range : {0.0, 0.005, 0.02}) {
    for (const Support& table : tables()) {
      Problem problem = make_problem(table, objects()[1], random_pose(table, objects()[1], rng));
      problem.hand.finger_model = FingerModel::impedance;  // without its shift
      problem.hand.wrist_stiffness = 600;
      Options options;
      options.com_margin = 0.001;
      options.tip_margin = 0;
      options.rim_margin = 0;
      options.min_depth = 0.005;
      options.max_depth = 0.005 + range;
      expect_holds(problem, options, seed++);
    }
  }
}

TEST(Plan, KeepsLinksApart) {
  std::mt19937_64 rng(3);
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Support& table = tables()[seed % tables().size()];
    const Object& object = objects()[seed % objects().size()];
    const Plan found =
        plan(make_problem(table, object, random_pose(table, object, rng)), {}, seeded(seed));
    ASSERT_TRUE(found) << "seed " << seed << ": " << found.reason;
    for (const Segment& segment : found.segments) {
      for (const Eigen::VectorXd& q : segment.positions)
        EXPECT_TRUE(are_links_apart(wam(), q, 0.0019)) << "seed " << seed << ", " << segment.name;
    }
  }
}

TEST(Plan, BeginsWhereLinksAreNear) {
  Problem problem = simple_problem();
  problem.q_home = bent_home(5e-4);
  expect_holds(problem, {}, 1);
}

TEST(Plan, PressesFarEnoughFromTheRim) {
  std::mt19937_64 rng(5);
  int near = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Problem problem =
        make_problem(tables()[0], objects()[2], random_pose(tables()[0], objects()[2], rng));
    planning::Budget budget;
    budget.seed = seed;
    Options anywhere;
    anywhere.rim_margin = 0;
    const Plan kept = plan(problem, {}, budget), free = plan(problem, anywhere, budget);
    ASSERT_TRUE(kept && free);
    EXPECT_TRUE(check(problem, kept).empty());
    EXPECT_TRUE(check(problem, free, anywhere).empty());
    const std::vector<std::string> faults = check(problem, free);
    if (faults.empty()) continue;
    EXPECT_NE(faults.front().find("from the object's rim"), std::string::npos) << faults.front();
    ++near;
  }
  EXPECT_GT(near, 0);
}

TEST(Plan, AlgorithmOneAsWrittenHoldsToo) {
  std::mt19937_64 rng(3);
  Options options;
  options.search = Search::paper;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Support& table = tables()[seed - 1];
    expect_holds(make_problem(table, objects()[0], random_pose(table, objects()[0], rng)), options,
                 seed);
  }
}

/// Distance between the poses at both ends of a slide, in the mean over the object's points [m].
double travel(const Problem& problem, const Plan& plan) {
  const Eigen::Isometry3d moved = plan.X_WO_goal * problem.X_WO_start.inverse();
  const Eigen::Matrix2Xd& points = problem.object.points();
  double sum = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d p = problem.X_WO_start * Eigen::Vector3d(points(0, i), points(1, i), 0);
    sum += (moved * p - p).norm();
  }
  return sum / static_cast<double>(points.cols());
}

TEST(Plan, SlidesLessFarThanAlgorithmOne) {
  std::mt19937_64 rng(1);
  Options paper;
  paper.search = Search::paper;
  double way = 0, papers_way = 0;
  for (const Support& table : tables()) {
    for (const Object& object : objects()) {
      const Problem problem = make_problem(table, object, random_pose(table, object, rng));
      const Plan near = plan(problem, {}, seeded(1)), any = plan(problem, paper, seeded(1));
      ASSERT_TRUE(near && any);
      way += travel(problem, near);
      papers_way += travel(problem, any);
    }
  }
  EXPECT_LT(way, 0.85 * papers_way);
}

TEST(Plan, RunsOnATiltedTableThatIsNotConvex) {
  const Eigen::Isometry3d X_WS = Eigen::Translation3d(0.35, -0.4, 0.05) *
                                 Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, -1, 0).normalized());
  const Support table(geometry::l_shape(), X_WS);
  const Problem problem = make_problem(table, objects()[0], flat(0.15, 0.4, 1));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_holds(problem, {}, seed);
}

TEST(Plan, RunsOnASixJointArm) {
  Problem problem{
      kr5(), Hand{}, objects()[0], tables()[0], flat(0.6, 0.1, 0.2), {}, kr5().state("home")};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_holds(problem, {}, seed);
}

TEST(Plan, GoesRoundOtherObjectsOnTheTable) {
  Problem problem = simple_problem();
  const auto block = [](double x, double y) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.05));
  };
  const geometry::PlacedShape box{geometry::Box{{0.06, 0.06, 0.1}}, Eigen::Isometry3d::Identity()};
  problem.obstacles = {{"left", {box}, block(0.55, 0.25)},
                       {"right", {box}, block(0.78, 0.22)},
                       {"near", {box}, block(0.5, -0.1)}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_holds(problem, {}, seed);
}

TEST(Plan, TakesAPointCloudAndACenterOfMass) {
  Eigen::Matrix3Xd cloud(3, 0);
  const Eigen::Matrix2Xd grid = geometry::sample_grid(geometry::square(0.12), 0.005);
  cloud.resize(3, grid.cols());
  cloud << grid, Eigen::RowVectorXd::Constant(grid.cols(), 0.004);
  const Object object = Object::from_cloud("tile", cloud).with_com({0.02, 0.01, 0.002});
  EXPECT_NEAR(object.thickness(), 0.004, 1e-12);
  expect_holds(make_problem(tables()[0], object, flat(0.7, -0.1, 2)), {}, 1);
}

TEST(Plan, IsTheSameForTheSameSeed) {
  for (const Search search : {Search::fast, Search::paper}) {
    Options options;
    options.search = search;
    const Plan a = plan(simple_problem(), options, seeded(5)),
               b = plan(simple_problem(), options, seeded(5));
    ASSERT_TRUE(a);
    ASSERT_EQ(a.segments.size(), b.segments.size());
    for (std::size_t i = 0; i < a.segments.size(); ++i) {
      EXPECT_EQ(a.segments[i].positions, b.segments[i].positions);
    }
    EXPECT_EQ(a.statistics.collision_checks, b.statistics.collision_checks);
    const Plan c = plan(simple_problem(), options, seeded(6));
    EXPECT_NE(a.segments[2].positions, c.segments[2].positions);
  }
}

TEST(Plan, LeavesItsProblemAlone) {
  const Problem problem = simple_problem();
  const Plan first = plan(problem, {}, seeded(1));
  plan(problem, {}, seeded(2));
  EXPECT_EQ(plan(problem, {}, seeded(1)).segments[2].positions, first.segments[2].positions);
}

// --- Not found ---

TEST(Plan, SaysThatTheObjectIsOutOfReach) {
  const Support far(geometry::square(0.5), Eigen::Isometry3d(Eigen::Translation3d(1.1, 0, 0)));
  const Plan none = plan(make_problem(far, objects()[0], flat(0, 0, 0)), {}, seeded(1, 0.2));
  EXPECT_FALSE(none);
  EXPECT_EQ(none.status, Status::no_start_root);
  EXPECT_GT(none.statistics.refusals.at("start: reach"), 0);
  EXPECT_NE(none.reason.find("reach"), std::string::npos);
  EXPECT_TRUE(none.segments.empty());
}

TEST(Plan, SaysThatNoPairCanBeValid) {
  Options options;
  options.min_overhang = 0.08;  // of a 10 cm square whose middle must stay inside
  const Plan none = plan(simple_problem(), options, seeded(1, 0.5));
  EXPECT_FALSE(none);
  EXPECT_TRUE(none.status == Status::no_valid_pair || none.status == Status::not_connected);
  EXPECT_GT(none.statistics.refusals.at("goal: overhang against centre of mass"), 0);
  EXPECT_NE(none.reason.find("overhang"), std::string::npos) << none.reason;
}

TEST(Plan, SaysWhatHomeTouches) {
  Problem problem = simple_problem();
  problem.obstacles = {{"wall",
                        {{geometry::Box{{2, 2, 2}}, Eigen::Isometry3d::Identity()}},
                        Eigen::Isometry3d(Eigen::Translation3d(0.5, 0, 1.0))}};
  const Plan none = plan(problem);
  EXPECT_EQ(none.status, Status::start_in_collision);
  EXPECT_NE(none.reason.find("wall"), std::string::npos);
}

TEST(Plan, EndsOnTimeAndByIterations) {
  Options options;
  options.min_overhang = 0.08;
  const Plan timed = plan(simple_problem(), options, seeded(1, 0.3));
  EXPECT_LT(timed.statistics.seconds, 0.3 + 0.05);
  planning::Budget budget = seeded(1);
  budget.iterations = 10;
  EXPECT_EQ(plan(simple_problem(), options, budget).statistics.iterations, 10);
}

TEST(Plan, CanBeStopped) {
  Options options;
  options.min_overhang = 0.08;
  planning::Budget budget = seeded(1, 1000);
  std::atomic<bool> stop{false};
  budget.interrupted = [&] { return stop.load(); };
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  const Plan none = plan(simple_problem(), options, budget);
  other.join();
  EXPECT_EQ(none.status, Status::interrupted);
  EXPECT_LT(none.statistics.seconds, 10);
}

// --- Bad input ---

TEST(Plan, RefusesBadOptions) {
  const auto with = [](auto set) {
    Options options;
    set(options);
    return [options] { plan(simple_problem(), options); };
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(with([](Options& o) { o.max_depth = 0.001; }), "options.max_depth");
  expect_refused(with([](Options& o) { o.min_depth = -1; }), "options.min_depth");
  expect_refused(with([&](Options& o) { o.pitch = nan; }), "options.pitch");
  expect_refused(with([](Options& o) { o.pitch_tolerance = -0.1; }), "options.pitch_tolerance");
  expect_refused(with([](Options& o) { o.root_scale = 0; }), "options.root_scale");
  expect_refused(with([](Options& o) { o.min_overhang = -0.02; }), "options.min_overhang");
  expect_refused(with([](Options& o) { o.com_margin = -1; }), "options.com_margin");
  expect_refused(with([](Options& o) { o.range = 0; }), "options.range");
  expect_refused(with([](Options& o) { o.resolution = 1; }), "options.resolution");
  const double inf = std::numeric_limits<double>::infinity();
  expect_refused(with([&](Options& o) { o.lift_height = inf; }), "options.lift_height");
  expect_refused(with([](Options& o) { o.grasp_approach = 1e6; }), "options.grasp_approach");
  expect_refused(with([](Options& o) { o.max_depth = 0.08; }), "flexure_length");  // bent flat
  expect_refused([] { plan(simple_problem(), {}, seeded(1, -1)); }, "budget.seconds");
}

TEST(Plan, RefusesBadProblems) {
  const auto with = [](auto set) {
    Problem problem = simple_problem();
    set(problem);
    return [problem] { plan(problem); };
  };
  expect_refused(with([](Problem& p) { p.X_WO_start.translation().x() = 5; }), "off the support");
  expect_refused(with([](Problem& p) { p.X_WO_start.translation().z() = 0.1; }), "height");
  expect_refused(with([](Problem& p) {
                   p.X_WO_start.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
                 }),
                 "tilt");
  expect_refused(with([](Problem& p) { p.q_home.resize(3); }), "q_home");
  expect_refused(with([](Problem& p) { p.q_home[1] = 9; }), "outside its limits");
  expect_refused(with([](Problem& p) { p.hand.fingertip = "thumb"; }), "thumb");
  expect_refused(with([](Problem& p) { p.hand.arm = "leg"; }), "leg");
  expect_refused(with([](Problem& p) { p.hand.open = "ajar"; }), "ajar");
  expect_refused(with([](Problem& p) { p.hand.flexure_length = 0; }), "flexure_length");
  expect_refused(with([](Problem& p) { p.hand.sliding_finger.clear(); }), "hand.sliding_finger");
  expect_refused(with([](Problem& p) { p.hand.fingers = {"left_fingertip"}; }), "hand.fingers");
  expect_refused(with([](Problem& p) { p.hand.fingertip = "base_link"; }), "not carried");
  expect_refused(with([](Problem& p) { p.X_WO_start.linear()(0, 1) += 0.1; }), "X_WO_start");
  const Obstacle box{"box",
                     {{geometry::Box{{.1, .1, .1}}, Eigen::Isometry3d::Identity()}},
                     Eigen::Isometry3d(Eigen::Translation3d(2, 0, 0))};
  expect_refused(with([&](Problem& p) { p.obstacles = {box, box}; }), "obstacles[1].name 'box'");
  expect_refused(with([&](Problem& p) { p.obstacles = {box}, p.obstacles[0].name = "object"; }),
                 "obstacles[0].name 'object'");
  expect_refused(with([&](Problem& p) { p.obstacles = {box}, p.obstacles[0].shapes.clear(); }),
                 "obstacles[0].shapes");
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A robot with the WAM's SRDF.
robot::Robot wam_of(const std::string& xml) {
  robot::Robot::Options options;
  options.srdf = text_of(urdf_file("wam_t42.srdf"));
  return robot::Robot::from_urdf(xml, options);
}

/// The WAM's URDF with an attribute of a fixed joint's origin replaced.
robot::Robot wam_with(const std::string& link, const std::string& attribute,
                      const std::string& value) {
  std::string xml = text_of(urdf_file("wam_t42.urdf"));
  const auto child = xml.find("<child link=\"" + link + "\"");
  const auto joint = xml.rfind("<joint", child), end = xml.find("</joint>", child);
  const auto origin = xml.find("<origin", joint);
  const auto at = xml.find(attribute + "=\"", origin);
  if (origin < end && at < xml.find("/>", origin)) {
    xml.replace(at + 5, xml.find('"', at + 5) - at - 5, value);
  } else {
    xml.insert(origin + 7, " " + attribute + "=\"" + value + "\"");
  }
  return wam_of(xml);
}

TEST(Plan, JointsOfNeitherArmNorHandStay) {
  Problem problem = simple_problem();
  std::string xml = text_of(urdf_file("wam_t42.urdf"));
  xml.insert(xml.rfind("</robot>"),
             "<link name='head'/><joint name='head_turn' type='revolute'>"
             "<parent link='base_link'/><child link='head'/><axis xyz='0 0 1'/>"
             "<limit lower='-1' upper='1' velocity='1' effort='1'/></joint>");
  problem.robot = wam_of(xml);
  problem.q_home = problem.robot.state("home");
  const int head = problem.robot.joint("head_turn");
  problem.q_home[head] = 0.3;
  Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  for (const Segment& segment : found.segments) {
    for (const Eigen::VectorXd& q : segment.positions) EXPECT_EQ(q[head], 0.3);
  }
  EXPECT_TRUE(check(problem, found).empty());
  for (Eigen::VectorXd& q : found.segments[2].positions) q[head] = 0;
  EXPECT_FALSE(check(problem, found).empty());
}

TEST(Plan, RefusesAFingerWithoutAShape) {
  Problem problem = simple_problem();
  problem.hand.fingers = {"left_finger", "right_fingertip"};
  expect_refused([&] { plan(problem); },
                 "hand.fingers, besides those of hand.sliding_finger, must name a link with a "
                 "collision shape");
}

// The finger ends 0.11 m from its joint.
TEST(Plan, RefusesATipFrameThatIsNotOnTheFinger) {
  const auto with = [](const std::string& xyz) {
    return [=] {
      Problem problem = simple_problem();
      problem.robot = wam_with("left_fingertip", "xyz", xyz);
      plan(problem);
    };
  };
  expect_refused(with("0 0 0.09"), "hand.fingertip 'left_fingertip'");
  expect_refused(with("0 0 0.09"), " mm below the contact");
  expect_refused(with("0 0 0.13"), " mm above the contact");
  EXPECT_NO_THROW(with("0 0 0.1097")());
}

TEST(Plan, RefusesToDriveARigidFingerIntoTheTable) {
  for (const FingerModel model : {FingerModel::none, FingerModel::rigid_guarded}) {
    const auto with = [model](double max_depth) {
      return [=] {
        Problem problem = simple_problem();
        problem.hand.finger_model = model;
        Options options;
        options.max_depth = max_depth;
        plan(problem, options);
      };
    };
    expect_refused(with(0.025), "options.max_depth");
    expect_refused(with(0.0031), "options.max_depth");
  }
}

TEST(Plan, RefusesAnImpedanceWithoutItsStiffness) {
  Problem problem = simple_problem();
  problem.hand.finger_model = FingerModel::impedance;
  expect_refused([=] { plan(problem); }, "hand.wrist_stiffness");
  problem.hand.wrist_stiffness = 100;  // 9 N would be at 90 mm
  expect_refused([=] { plan(problem); }, "hand.wrist_stiffness");
}

/// Depths of the commanded tip below the top face while the object slides [m].
std::vector<double> depths(const Problem& problem, const Plan& plan) {
  std::vector<double> found;
  for (const Segment& segment : plan.segments) {
    if (segment.name != "slide") continue;
    for (const Eigen::VectorXd& q : segment.positions) {
      const Eigen::Isometry3d X_WF =
          problem.robot.pose(problem.robot.frame(problem.hand.fingertip), q);
      found.push_back(problem.object.thickness() - X_WF.translation().z());
    }
  }
  return found;
}

TEST(Plan, RigidFingersHoldAtTheDepthsOfTheirModels) {
  std::mt19937_64 rng(8);
  for (const FingerModel model :
       {FingerModel::none, FingerModel::rigid_guarded, FingerModel::impedance}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Problem problem =
          make_problem(tables()[0], objects()[0], random_pose(tables()[0], objects()[0], rng));
      problem.hand.finger_model = model;
      problem.hand.wrist_stiffness = 600;
      expect_holds(problem, {}, seed);
      const Plan found = plan(problem, {}, seeded(seed));
      const DepthBand band = depth_band(problem.hand, {});
      EXPECT_EQ(band.max, model == FingerModel::impedance ? 1.5 * 9 / 600 : 0);
      for (const double depth : depths(problem, found)) {
        EXPECT_GE(depth, band.min - 5.1e-4);
        EXPECT_LE(depth, band.max + 5.1e-4);
      }
    }
  }
}

// Without a grasp on the object itself, the hand would close on the hole or between the prongs.
TEST(Plan, GraspsRingsAndForksOnTheirMaterial) {
  Eigen::Matrix3Xd ring(3, 0);
  for (double x = -0.06; x <= 0.06; x += 0.006) {
    for (double y = -0.06; y <= 0.06; y += 0.006) {
      const double r = std::hypot(x, y);
      if (r > 0.06 || r < 0.042) continue;
      ring.conservativeResize(3, ring.cols() + 1);
      ring.rightCols<1>() << x, y, 0.005;
    }
  }
  const geometry::Polygon fork(columns({{-.06, -.05},
                                        {.06, -.05},
                                        {.06, .06},
                                        {.03, .06},
                                        {.03, -.02},
                                        {-.03, -.02},
                                        {-.03, .06},
                                        {-.06, .06}}));
  std::mt19937_64 rng(9);
  for (const Object& object :
       {Object::from_cloud("ring", ring), Object::from_polygon("fork", fork, .005)}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Problem problem =
          make_problem(tables()[0], object, random_pose(tables()[0], object, rng));
      const Plan found = plan(problem, {}, seeded(seed));
      ASSERT_TRUE(found) << found.reason;
      EXPECT_EQ(joined(check(problem, found)), "") << object.name() << " " << seed;
      const Eigen::Vector3d p_OH = found.X_WO_goal.inverse() * found.X_WH_grasp.translation();
      const double nearest =
          (object.points().colwise() - p_OH.head<2>()).colwise().norm().minCoeff();
      EXPECT_LT(nearest, 1.25 * object.spacing()) << object.name() << " " << seed;
    }
  }
}

TEST(Plan, NamesTheLinksThatTouch) {
  Problem problem = simple_problem();
  problem.obstacles = {{"lid",
                        {{geometry::Box{{0.6, 0.6, 0.02}}, Eigen::Isometry3d::Identity()}},
                        Eigen::Isometry3d(Eigen::Translation3d(0.65, 0, 0.05))}};
  planning::Budget budget = seeded(1);
  budget.iterations = 20;
  const Plan none = plan(problem, {}, budget);
  EXPECT_EQ(none.status, Status::no_start_root);
  EXPECT_NE(none.reason.find("start: collision of "), std::string::npos) << none.reason;
  EXPECT_NE(none.reason.find("lid"), std::string::npos) << none.reason;
  // The lid is 20 mm thick and touches nothing but links, so none needs to move far.
  double deep = 0;
  const auto at = none.reason.find("about ");
  ASSERT_NE(at, std::string::npos) << none.reason;
  ASSERT_EQ(
      std::sscanf(none.reason.c_str() + at, "about %lf mm deep with left_fingertip at (", &deep), 1)
      << none.reason;
  EXPECT_GT(deep, 1) << none.reason;
  EXPECT_LT(deep, 300) << none.reason;
}

TEST(Plan, RefusesAnObjectOutOfReachAtOnce) {
  const Problem near = simple_problem();
  double refused = 0;  // the first way of the table that is refused [m]
  for (double way = 0; way < 2; way += 0.05) {
    const Eigen::Isometry3d away(Eigen::Translation3d(way, 0, 0));
    Problem problem = near;
    problem.support = Support(near.support.polygon(), away * near.support.X_WS());
    problem.X_WO_start = away * near.X_WO_start;
    planning::Budget budget = seeded(1);
    budget.iterations = 300;
    const Plan found = plan(problem, {}, budget);
    const bool is_refused = found.reason.find("out of the arm's reach") != std::string::npos;
    EXPECT_TRUE(is_refused || refused == 0) << way;
    if (!is_refused) continue;
    EXPECT_EQ(found.status, Status::no_start_root);
    EXPECT_EQ(found.statistics.iterations, 0);
    EXPECT_TRUE(found.segments.empty());
    if (refused == 0) refused = way;
  }
  EXPECT_GT(refused, 0.2);
  EXPECT_LT(refused, 1.5);
}

/// The bound on which that refusal rests.
TEST(Plan, NoFingertipGetsFartherThanTheArmReaches) {
  std::mt19937 rng(2);
  for (const char* name : {"wam_t42.urdf", "kr5_t42.urdf"}) {
    const robot::Robot robot = robot::Robot::from_urdf_file(urdf_file(name));
    const int tip = robot.frame("left_fingertip"), base = robot.frame(robot.frame_names()[1]);
    double farthest = 0;
    for (int i = 0; i < 2000; ++i) {
      Eigen::VectorXd q(robot.dof());
      for (int j = 0; j < q.size(); ++j) {
        q[j] = std::uniform_real_distribution<double>(robot.lower()[j], robot.upper()[j])(rng);
      }
      farthest = std::max(
          farthest, (robot.pose(tip, q).translation() - robot.pose(base, q).translation()).norm());
    }
    EXPECT_LT(farthest, robot.reach(tip)(robot.group("arm")).maxCoeff());
    EXPECT_GT(farthest, 0.5 * robot.reach(tip)(robot.group("arm")).maxCoeff());
  }
}

TEST(Plan, SaysHowDeepTheLinksTouchAtHome) {
  Problem problem = simple_problem();
  const Eigen::Vector3d p =
      problem.robot.pose(problem.robot.frame("grasp"), problem.q_home).translation();
  problem.obstacles = {{"wall",
                        {{geometry::Box{{1, 1, 1}}, Eigen::Isometry3d::Identity()}},
                        Eigen::Isometry3d(Eigen::Translation3d(p - Eigen::Vector3d(0, 0, 0.51)))}};
  const Plan none = plan(problem);
  EXPECT_EQ(none.status, Status::start_in_collision);
  EXPECT_NE(none.reason.find("touches 'wall', about "), std::string::npos) << none.reason;
  EXPECT_NE(none.reason.find(" mm deep"), std::string::npos) << none.reason;
}

TEST(Plan, SaysWhichCollisionIsInTheWayBesidesReach) {
  Problem problem = simple_problem();
  problem.obstacles = {{"floor",
                        {{geometry::Box{{3, 3, 0.01}}, Eigen::Isometry3d::Identity()}},
                        Eigen::Isometry3d(Eigen::Translation3d(1, 0, -0.02))}};
  planning::Budget budget = seeded(1);
  budget.iterations = 300;
  const Plan none = plan(problem, {}, budget);
  EXPECT_FALSE(none);
  EXPECT_NE(none.reason.find("collision of "), std::string::npos) << none.reason;
  EXPECT_NE(none.reason.find(" deep with "), std::string::npos) << none.reason;
}

TEST(Plan, SaysWhatTheOpenHandNeedsBesidesTheObject) {
  const Problem p = simple_problem();
  const Eigen::VectorXd q = p.robot.state("open", p.q_home);
  const std::string text = jaw_lengths(p, q, p.X_WO_start, "left_finger");
  double low = 1e9, high = -1e9;
  for (const auto& shape : p.robot.shapes()) {
    const std::string& link = p.robot.frame_names()[shape.link];
    if (link != "left_finger" && link != "right_finger") continue;
    const Eigen::Isometry3d X_WL = p.robot.pose(shape.link, q);
    const Eigen::Vector3d up_L = X_WL.linear().transpose() * Eigen::Vector3d::UnitZ();
    high = std::max(high, X_WL.translation().z() + geometry::extent(shape.placed, up_L));
    low = std::min(low, X_WL.translation().z() - geometry::extent(shape.placed, -up_L));
  }
  const auto at = text.find("the hand needs ");
  ASSERT_NE(at, std::string::npos) << text;
  double below = 0, above = 0;
  ASSERT_EQ(
      std::sscanf(text.c_str() + at, "the hand needs %lf mm below the object and %lf mm above it",
                  &below, &above),
      2)
      << text;
  EXPECT_NEAR(below, -1000 * low, 1) << text;
  EXPECT_NEAR(above, 1000 * (high - p.object.thickness()), 1) << text;
  EXPECT_NE(text.find("left_finger is "), std::string::npos) << text;
  EXPECT_NE(text.find(" thick, the object "), std::string::npos) << text;
}

TEST(Plan, RefusesFramesThatDoNotLieInTheHand) {
  const auto with = [](const std::string& link, const std::string& rpy) {
    return [=] {
      Problem problem = simple_problem();
      problem.robot = wam_with(link, "rpy", rpy);
      plan(problem);
    };
  };
  expect_refused(with("grasp", "0 0 1.5708"), "finger to finger");
  expect_refused(with("grasp", "3.1416 0 0"), "out of the hand");
  expect_refused(with("left_fingertip", "3.1416 0 0"), "out of the tip");
  expect_refused(with("left_fingertip", "0 0 0"), "towards the other finger");
}

TEST(Object, RefusesWhatIsNotThinOrNotThere) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> n(0, 0.05);
  Eigen::Matrix3Xd blob(3, 500);
  for (auto& value : blob.reshaped()) value = n(rng);
  expect_refused([&] { Object::from_cloud("blob", blob); }, "thin");
  expect_refused([&] { Object::from_cloud("none", Eigen::Matrix3Xd(3, 0)); }, "at least 3");
  blob(1, 7) = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { Object::from_cloud("holey", blob); }, "1 points that are not finite");
  expect_refused([&] { Object::from_polygon("brick", geometry::square(.1), .08); }, "not thin");
  EXPECT_TRUE(Object::from_polygon("loaf", geometry::square(.1), .07).is_thin());
  expect_refused([&] { Object::from_polygon("film", geometry::square(.1), 0); }, "thickness");
  expect_refused([&] { Object::from_polygon("hall", geometry::square(100), .001); },
                 "spacing 0.006 m gives 2.77778e+08 points on 100 x 100 m");
  expect_refused([&] { objects()[0].with_com({1, 0, 0}); }, "com");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { objects()[0].with_com({0, 0, nan}); }, "com");
  expect_refused([&] { objects()[0].with_mass(-1); }, "mass");
  expect_refused([&] { objects()[0].with_mass(1e6); }, "mass must lie in [1e-09, 100000] kg");
  expect_refused([&] { objects()[0].scaled(0); }, "scale must lie in [1e-06, 1e+06], not 0");
  expect_refused([&] { objects()[0].scaled(1e300); }, "scale must lie in");
  expect_refused([&] { objects()[0].scaled(0.02); }, "thick");
  expect_refused([&] { Object::from_cloud("far", 1e160 * Eigen::Matrix3Xd::Random(3, 9)); },
                 "must lie within 10000 m of the origin along x and y");
}

/// The drag of the support, below the finger, has a lever of the thickness.
TEST(Object, RefusesWhatFrictionOfTheSupportWouldTip) {
  const Object loaf = Object::from_polygon("loaf", geometry::square(.1), .07);
  const auto on = [&](double friction) {
    const Support table(geometry::square(.8), flat(.7, 0, 0), 0.04, 0.06, friction);
    return make_problem(table, loaf, flat(0, 0, 0));
  };
  Options options;
  options.friction_spread = 0.2;
  EXPECT_NO_THROW(validate(on(.59), options));
  expect_refused(
      [&] { validate(on(.6), options); },
      "support.friction must be at most 0.595238, not 0.6, or drag would tip object 'loaf'");
}

/// A loaf that is pressed near an end, and pushed towards it, would be pressed down beyond it.
TEST(Plan, ALoafIsNotDraggedOverItsEdge) {
  const auto outline =
      geometry::Polygon(columns({{-.06, -.03}, {.06, -.03}, {.06, .03}, {-.06, .03}}));
  Options options;
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Support table(tables()[0].polygon(), tables()[0].X_WS(), 0.04, 0.06, 0.45);
    const Problem problem =
        make_problem(table, Object::from_polygon("loaf", outline, .044).with_mass(.3),
                     flat(0.6, 0.1 * static_cast<double>(seed) / 6, 0.3));
    const Plan found = plan(problem, options, seeded(seed, 5));
    if (!found) continue;
    ++solved;
    EXPECT_TRUE(check(problem, found, options).empty());
    const double ahead = 1.3 * 0.45 * 0.044;  // of the centre of pressure
    const auto& slide = *std::find_if(found.segments.begin(), found.segments.end(),
                                      [](const Segment& s) { return s.name == "slide"; });
    const auto& X_WO = slide.object_poses;
    const int F = problem.robot.frame(problem.hand.fingertip);
    for (std::size_t i = 0; i + 1 < X_WO.size(); ++i) {
      const Eigen::Vector3d tip = problem.robot.pose(F, slide.positions[i]).translation(),
                            com = X_WO[i].translation(), moved = X_WO[i + 1].translation() - com;
      if (moved.norm() < 2e-3) continue;
      const double N = 9, W = 0.3 * 9.81;  // the press differs a little with the depth
      Eigen::Vector3d p = (N * tip + W * com) / (N + W) + ahead * moved.normalized();
      p = X_WO[i].inverse() * p;
      EXPECT_GE(outline.depth(p.head<2>()), -0.012);
    }
  }
  EXPECT_GT(solved, 0);
}

TEST(Object, CenterOfMassOfADistribution) {
  Eigen::Matrix3Xd points(3, 2);
  points << 0, 1, 0, 0, 0, 0;
  EXPECT_TRUE(center_of_mass(points, Eigen::Vector2d(1, 3)).isApprox(Eigen::Vector3d(0.75, 0, 0)));
  expect_refused([&] { center_of_mass(points, Eigen::Vector3d(1, 1, 1)); }, "masses");
  expect_refused([&] { center_of_mass(points, Eigen::Vector2d(1, -1)); }, "masses");
  expect_refused([&] { center_of_mass(points, Eigen::Vector2d(0, 0)); }, "masses");
}

// Only there can it be, even of an object of uneven density that is not convex.
TEST(Object, HasItsCenterOfMassInTheHullOfItsOutline) {
  Eigen::Matrix2Xd corners(2, 4);  // an arrow head, hollow on the left
  corners << -.06, .06, -.06, -.02, -.04, 0, .04, 0;
  const Object object = Object::prism("arrow", geometry::Polygon(corners), .003, .006);
  const std::vector<Eigen::Vector3d> within{{-.05, 0, .001}, {-.06, .04, .003}, {0, .02, 0}};
  for (const Eigen::Vector3d& com : within) EXPECT_EQ(object.with_com(com).com(), com);
  // The mean of points on an edge may be off it by rounding.
  const Eigen::Vector3d on_edge(.02 + 1e-17, .04 / 3 + 1e-15, .003 + 1e-18);
  EXPECT_EQ(object.with_com(on_edge).com(), on_edge);
  const std::vector<Eigen::Vector3d> outside{
      {.05, .035, .001}, {-.061, 0, .001}, {0, 0, -.001}, {0, 0, .004}};
  for (const Eigen::Vector3d& com : outside) {
    expect_refused([&] { object.with_com(com); },
                   "must lie within the convex hull of the outline of object 'arrow', at a height "
                   "from 0 to 0.003 m");
  }
}

TEST(Support, RefusesNonsense) {
  const Eigen::Isometry3d steep(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitX()));
  expect_refused([&] { Support(geometry::square(1), steep); }, "tilted");
  expect_refused([&] { Support(geometry::square(1), Eigen::Isometry3d::Identity(), -1); }, "slab");
  expect_refused([&] { Support(geometry::square(1), steep, 1e300); },
                 "slab must lie in [1e-06, 10000] m, not 1e+300");
  expect_refused([&] { Support(geometry::square(1), steep, .04, 1e300); },
                 "band width must lie in [1e-06, 10000] m, not 1e+300");
  expect_refused([&] { Support(geometry::square(1), steep, .04, .06, 1e300); },
                 "friction must lie in [1e-06, 10000], not 1e+300");
  expect_refused([&] { Support(geometry::square(1), Eigen::Isometry3d::Identity(), .04, 0); },
                 "band");
  const Support support(geometry::square(1), Eigen::Isometry3d::Identity());
  EXPECT_TRUE(support.is_usable(3));
  expect_refused([&] { support.is_usable(4); }, "edge must be in [0, 4), not 4");
  expect_refused([&] { support.is_usable(-1); }, "edge must be in [0, 4), not -1");
}

}  // namespace
}  // namespace graspless::slide
