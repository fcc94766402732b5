// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>
#include <queue>
#include <random>

#include <gtest/gtest.h>

#include "graspless/fingertip/fingertip.hpp"

#include "complaint.hpp"
#include "fingertip/model/screw.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

Eigen::Isometry3d on_floor(double x, double y, double yaw, double height = 0.025) {
  Eigen::Isometry3d X(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  X.translation() << x, y, height;
  return X;
}

/// A block of 5 x 6 x 5 cm at the origin, to be brought to a pose of the lattice.
Problem block_problem(const Eigen::Vector3d& goal, const Eigen::Vector3d& lower,
                      const Eigen::Vector3d& upper, const std::array<int, 3>& counts) {
  Lattice lattice;
  lattice.X_WO_start = on_floor(0, 0, 0);
  lattice.X_WO_goal = on_floor(goal.x(), goal.y(), goal.z());
  lattice.lower = lower;
  lattice.upper = upper;
  lattice.counts = counts;
  return {Object::box("block", {0.05, 0.06, 0.05}, 1), {}, {Plane{}}, {0.5, 0.5}, lattice, {}};
}

Options coarse(int locations_per_side) {
  Options options;
  options.locations_per_side = locations_per_side;
  options.explain = false;
  return options;
}

/// What the engine of the options finds, before a plan is made of it.
Route route_of(const Problem& problem, const Options& options) {
  SearchContext context(problem, options);
  const PoseGraph graph(problem, std::get<Lattice>(problem.motion), context.locations,
                        context.instants, options);
  planning::Clock clock{planning::Budget{}};
  Statistics statistics;
  return search(graph, context, clock, statistics);
}

/// Dijkstra over poses and placements, arc by arc, with none of the lattice's code.
class BruteForce {
 public:
  BruteForce(const Problem& problem, const Options& options)
      : lattice_(std::get<Lattice>(problem.motion)), options_(options), context_(problem, options) {
    list_placements(kNoFingers, 0, problem.fingers.count);
    for (int p = 0; p < num_poses(); ++p) add_pose(p);
  }

  double cost() {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const std::size_t count = placements_.size(), goal = index_of(lattice_.X_WO_goal);
    std::vector<double> best(count * poses_.size(), kInfinity);
    const auto push = [&](double g, std::size_t pose, std::size_t placement) {
      double& known = best[pose * count + placement];
      if (g < known) open.push({known = g, pose * count + placement});
    };
    const std::size_t start = index_of(lattice_.X_WO_start);
    for (std::size_t i = 0; i < count; ++i) {
      if (is_feasible(*poses_[start], 0, placements_[i])) push(0, start, i);
    }
    while (!open.empty()) {
      const auto [g, node] = open.top();
      open.pop();
      const std::size_t pose = node / count, placement = node % count;
      if (g > best[node]) continue;
      if (pose == goal) return g;
      for (const auto& [to, graph] : arcs_[pose]) {
        if (is_feasible(*graph, 1, placements_[placement])) {
          push(g + arc(*graph, placements_[placement]), to, placement);
        }
      }
      for (std::size_t other = 0; other < count; ++other) {
        const Placement kept = common(placements_[placement], placements_[other]);
        if (num_fingers(kept) + 1 != num_fingers(placements_[placement])) continue;
        if (!is_feasible(*poses_[pose], 0, placements_[other])) continue;
        if (z(rest_[pose], kept) > 0) push(g + options_.regrasp_cost, pose, other);
      }
    }
    return kInfinity;
  }

 private:
  int num_poses() const { return lattice_.counts[0] * lattice_.counts[1] * lattice_.counts[2]; }
  std::array<int, 3> cell(int p) const {
    return {p % lattice_.counts[0], p / lattice_.counts[0] % lattice_.counts[1],
            p / lattice_.counts[0] / lattice_.counts[1]};
  }
  double value(int axis, int i) const {
    const int n = lattice_.counts[axis];
    return n == 1
               ? lattice_.lower[axis]
               : lattice_.lower[axis] + (lattice_.upper[axis] - lattice_.lower[axis]) * i / (n - 1);
  }
  Eigen::Isometry3d X_WO(int p) const {
    const auto c = cell(p);
    Eigen::Isometry3d X = lattice_.X_WO_start;
    X.linear() = Eigen::AngleAxisd(value(2, c[2]), Eigen::Vector3d::UnitZ()) * X.linear();
    X.translation() += Eigen::Vector3d(value(0, c[0]), value(1, c[1]), 0);
    return X;
  }
  std::size_t index_of(const Eigen::Isometry3d& X) const {
    for (int p = 0; p < num_poses(); ++p) {
      if (X_WO(p).isApprox(X, 1e-9)) return static_cast<std::size_t>(p);
    }
    throw std::logic_error("not on the lattice");
  }
  void list_placements(const Placement& fingers, int first, int missing) {
    if (missing == 0) placements_.push_back(fingers);
    for (int l = first; missing > 0 && l < context_.locations.size(); ++l) {
      list_placements(with(fingers, l), l + 1, missing - 1);
    }
  }
  /// Nothing when the object cannot move so.
  std::unique_ptr<PoseGraph> query(int from, int to) {
    try {
      return std::make_unique<PoseGraph>(context_.problem, Path{{X_WO(from), X_WO(to)}},
                                         context_.locations, context_.instants, options_);
    } catch (const std::invalid_argument&) {
      return nullptr;
    }
  }
  void add_pose(int p) {
    arcs_.emplace_back();
    poses_.emplace_back();
    rest_.push_back(-1);
    for (int to = 0; to < num_poses(); ++to) {
      const auto a = cell(p), b = cell(to);
      const bool is_near =
          std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
      if (to == p || !is_near) continue;
      auto arc = query(p, to);
      if (arc == nullptr) continue;
      if (!poses_.back()) poses_.back() = query(p, to);
      arcs_.back().emplace_back(static_cast<std::size_t>(to), std::move(arc));
    }
    if (poses_.back()) {
      rest_.back() = context_.instants.add(resting_state(X_WO(p), mechanics::Vector6d::Zero()));
    }
  }
  static Placement common(const Placement& a, const Placement& b) {
    Placement kept = kNoFingers;
    for (const std::int32_t l : a) {
      if (l >= 0 && std::find(b.begin(), b.end(), l) != b.end()) kept = with(kept, l);
    }
    return kept;
  }
  double z(int instant, const Placement& placement) {
    return context_.evaluators.front().stability(instant, placement);
  }
  double arc(const PoseGraph& graph, const Placement& placement) {
    std::vector<double> zs;
    for (int j = 0; j < options_.samples_per_arc; ++j)
      zs.push_back(z(graph.instant(0, j), placement));
    return arc_cost(graph, 0, placement, zs);
  }

  const Lattice& lattice_;
  const Options& options_;
  SearchContext context_;
  std::vector<Placement> placements_;
  std::vector<std::vector<std::pair<std::size_t, std::unique_ptr<PoseGraph>>>> arcs_;
  std::vector<std::unique_ptr<PoseGraph>> poses_;
  std::vector<int> rest_;
};

TEST(Lattice, SlideAlongOneAxisIsThePathsSlide) {
  const Problem problem = block_problem({0.1, 0, 0}, {0, 0, 0}, {0.1, 0, 0}, {21, 1, 1});
  Problem as_path = problem;
  as_path.motion = slide_path(on_floor(0, 0, 0), {0.1, 0, 0}, 20);
  const Plan plan = fingertip::plan(problem), expected = fingertip::plan(as_path);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan.cost, expected.cost, 1e-9);
  EXPECT_NEAR(plan.lower_bound, plan.cost, 1e-12);
  ASSERT_EQ(plan.segments.size(), 1U);
  EXPECT_EQ(plan.segments[0].name, "slide");
  EXPECT_EQ(plan.segments[0].X_WO.size(), 21U);
  EXPECT_TRUE(check(problem, plan).empty()) << check(problem, plan).front();
}

TEST(Lattice, TurnInPlaceOnASlopeIsThePathsTurn) {
  Problem problem = block_problem({0, 0, 0.8}, {0, 0, 0}, {0, 0, 0.8}, {1, 1, 5});
  problem.gravity_W = {2.5, 0, -9.5};
  Problem as_path = problem;
  Path turn;
  for (int i = 0; i <= 4; ++i) turn.X_WO.push_back(on_floor(0, 0, 0.2 * i));
  as_path.motion = turn;
  const Plan plan = fingertip::plan(problem), expected = fingertip::plan(as_path);
  ASSERT_TRUE(plan) << plan.reason;
  EXPECT_NEAR(plan.cost, expected.cost, 1e-9);
  EXPECT_TRUE(check(problem, plan).empty()) << check(problem, plan).front();
}

TEST(Lattice, TurnInPlaceIsThePathsTurn) {
  const Problem problem = block_problem({0, 0, M_PI / 2}, {0, 0, 0}, {0, 0, M_PI / 2}, {1, 1, 16});
  Problem as_path = problem;
  as_path.motion =
      turn_path(on_floor(0, 0, 0), Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), M_PI / 2, 15);
  const Plan plan = fingertip::plan(problem), expected = fingertip::plan(as_path);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan.cost, expected.cost, 1e-9);
  EXPECT_TRUE(check(problem, plan).empty()) << check(problem, plan).front();
}

TEST(Lattice, YawsAWholeTurnApartAreTheSame) {
  // To -90 degrees: three quarters of the way round, or one quarter back over the seam.
  Problem problem = block_problem({0, 0, -M_PI / 2}, {0, 0, 0}, {0, 0, 2 * M_PI}, {1, 1, 33});
  const Plan plan = fingertip::plan(problem);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan.segments[0].X_WO.size(), 9U);
  EXPECT_TRUE(check(problem, plan).empty()) << check(problem, plan).front();
}

TEST(Lattice, MirroredProblemsCostTheSame) {
  const std::array<int, 3> counts = {5, 5, 5};
  const Problem left =
      block_problem({0.04, 0.02, 0.4}, {-0.04, -0.04, -0.4}, {0.04, 0.04, 0.4}, counts);
  const Problem right =
      block_problem({0.04, -0.02, -0.4}, {-0.04, -0.04, -0.4}, {0.04, 0.04, 0.4}, counts);
  const Options options = coarse(3);
  const Plan a = plan(left, options), b = plan(right, options);
  ASSERT_TRUE(a);
  ASSERT_TRUE(b);
  EXPECT_NEAR(a.cost, b.cost, 1e-9);
}

double uniform(std::mt19937& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

/// A block on a lattice of 4 x 4 x 4 poses, beside a wall if asked.
std::pair<Problem, Options> random_case(std::mt19937& random, bool has_wall) {
  const double step = uniform(random, 0.01, 0.03), turn = uniform(random, 0.1, 0.4);
  const Eigen::Vector3d last(3 * step, 3 * step, 3 * turn);
  const Eigen::Vector3d goal(step * static_cast<double>(random() % 4), 3 * step,
                             turn * static_cast<double>(random() % 4));
  Problem problem = block_problem(goal, Eigen::Vector3d::Zero(), last, {4, 4, 4});
  problem.fingers.max_normal_force = uniform(random, 2.5, 8);
  if (has_wall) problem.planes.push_back({"wall", -Eigen::Vector3d::UnitY(), -3 * step - 0.06});
  Options options = coarse(2);
  options.min_stability = uniform(random, 0.1, 0.5);
  return {problem, options};
}

TEST(Lattice, CostsWhatBruteForceFinds) {
  std::mt19937 random(3);
  std::map<int, int> by_regrasps;
  for (int i = 0; i < 8; ++i) {
    auto [problem, options] = random_case(random, i % 3 == 0);
    problem.fingers.friction = {0.5, 0.5};
    const Plan plan = fingertip::plan(problem, options);
    const double expected = BruteForce(problem, options).cost();
    if (expected == kInfinity) {
      EXPECT_EQ(plan.status, Status::unstable) << i;
      ++by_regrasps[-1];
    } else {
      ASSERT_TRUE(plan) << i << ": " << plan.reason << ", but " << expected;
      EXPECT_NEAR(plan.cost, expected, 1e-9 * expected) << i;
      EXPECT_NEAR(plan.lower_bound, expected, 1e-9 * expected) << i;
      ++by_regrasps[plan.regrasps];
      EXPECT_TRUE(check(problem, plan, options).empty()) << check(problem, plan, options).front();
    }
  }
  // Of each kind there was one.
  EXPECT_GT(by_regrasps[0], 0);
  EXPECT_GT(by_regrasps[1], 0);
}

TEST(Lattice, WeighsARegraspAgainstADearRoute) {
  // A regrasp costs less than the way that the fingers would be spared.
  const Problem problem = block_problem({0.06, 0.06, 1.2}, {0, 0, 0}, {0.06, 0.06, 1.2}, {4, 4, 4});
  Options options = coarse(2);
  options.stability_weight = 1;  // so that the best grip of each arc matters
  int regrasps = 0;
  for (const double regrasp_cost : {0.0001, 0.003, 0.03}) {
    options.regrasp_cost = regrasp_cost;
    const Plan plan = fingertip::plan(problem, options);
    ASSERT_TRUE(plan);
    const double expected = BruteForce(problem, options).cost();
    EXPECT_LE(plan.lower_bound, expected * (1 + 1e-9)) << regrasp_cost;
    EXPECT_NEAR(plan.cost, expected, 1e-9 * expected) << regrasp_cost;
    regrasps += plan.regrasps;
  }
  EXPECT_GT(regrasps, 0);
}

TEST(Lattice, EnginesAgree) {  // they sum costs in different orders
  std::mt19937 random(5);
  std::map<int, int> by_regrasps;
  for (int i = 0; i < 12; ++i) {
    auto [problem, options] = random_case(random, i % 3 == 0);
    if (i % 4 == 3) options.regrasp_cost = uniform(random, 0.001, 0.01);
    const Route fast = route_of(problem, options);
    for (const Search engine : {Search::paper, Search::dijkstra}) {
      options.search = engine;
      const Route oracle = route_of(problem, options);
      ASSERT_TRUE(oracle.is_complete && fast.is_complete) << i;
      ASSERT_EQ(oracle.found, fast.found) << i;
      EXPECT_DOUBLE_EQ(oracle.cost, fast.cost) << i;
      if (!oracle.found) continue;
      const Plan plan = fingertip::plan(problem, options);
      EXPECT_DOUBLE_EQ(plan.cost, fast.cost) << i;
      EXPECT_EQ(plan.lower_bound, plan.cost) << i;
      EXPECT_TRUE(check(problem, plan, options).empty()) << i;
    }
    ++by_regrasps[fast.found ? num_regrasps(fast) : -1];
  }
  EXPECT_GT(by_regrasps[0], 0);
  EXPECT_GT(by_regrasps[1] + by_regrasps[2], 0);
}

TEST(Lattice, DoesNotOutgrowItsMemory) {
  Problem problem = block_problem({0.1, 0, 0}, {0, 0, 0}, {0.1, 0, 0}, {21, 1, 1});
  Options options = coarse(2);
  options.max_memory = 1e3;
  Plan found = plan(problem, options);
  EXPECT_EQ(found.status, Status::out_of_memory);
  EXPECT_EQ(found.reason.find("motion.counts: the lattice would need"), 0) << found.reason;
  problem = block_problem({0.1, 0, 0}, {0, 0, 0}, {0.1, 0.1, 1}, {11, 11, 11});
  options = coarse(4);
  options.search = Search::dijkstra;
  options.max_memory = 3e6;
  planning::Budget budget;
  budget.seconds = kInfinity;
  found = plan(problem, options, budget);
  EXPECT_EQ(found.status, Status::out_of_memory);
}

TEST(Lattice, SlidesAlongAWallItTouches) {
  Problem problem = block_problem({0.06, 0, 0}, {0, -0.02, 0}, {0.06, 0, 0}, {7, 3, 1});
  problem.planes.push_back({"wall", -Eigen::Vector3d::UnitY(), -0.03});
  const Options options = coarse(4);
  const Plan plan = fingertip::plan(problem, options);
  ASSERT_TRUE(plan) << plan.reason;
  // No fingertip fits between the block and the wall.
  for (const FingerState& finger : plan.segments[0].rows[0].fingers) {
    EXPECT_GT(finger.n_O.y(), -0.5);
  }
  EXPECT_TRUE(check(problem, plan, options).empty()) << check(problem, plan, options).front();
}

TEST(Lattice, GoesRoundAnObstacle) {
  Problem problem = block_problem({0.2, 0, 0}, {0, -0.1, 0}, {0.2, 0.1, 0}, {11, 11, 1});
  const Options options = coarse(4);
  const double straight = plan(problem, options).cost;
  problem.obstacles.push_back(
      {"post", {{geometry::Box{{0.02, 0.02, 0.02}}}}, on_floor(0.1, 0, 0, 0.02)});
  const Plan plan = fingertip::plan(problem, options);
  ASSERT_TRUE(plan) << plan.reason;
  EXPECT_GT(plan.cost, straight * 1.05);
  EXPECT_TRUE(check(problem, plan, options).empty()) << check(problem, plan, options).front();
}

TEST(Lattice, SaysThatThereIsNoWay) {
  Problem problem = block_problem({0.2, 0, 0}, {0, 0, 0}, {0.2, 0, 0}, {11, 1, 1});
  problem.obstacles.push_back(
      {"bar", {{geometry::Box{{0.02, 1, 0.02}}}}, on_floor(0.1, 0, 0, 0.02)});
  const Plan plan = fingertip::plan(problem, coarse(4));
  EXPECT_EQ(plan.status, Status::no_location);
  EXPECT_EQ(plan.limit, "reach of the lattice");

  std::get<Lattice>(problem.motion).counts = {2, 1, 1};  // no pose touches the bar
  const Plan over = fingertip::plan(problem, coarse(4));
  EXPECT_EQ(over.status, Status::no_location);
  EXPECT_EQ(over.limit, "reach of the lattice");
}

TEST(Lattice, FingersTooWeakAreUnstable) {
  Problem problem = block_problem({0.03, 0.03, 0}, {0, 0, 0}, {0.03, 0.03, 0}, {4, 4, 1});
  problem.fingers.max_normal_force = 0.5;
  EXPECT_EQ(plan(problem, coarse(2)).status, Status::unstable);
}

TEST(Lattice, RefusesWhatIsNoLattice) {
  const auto refused = [](const Problem& problem, const std::string& words) {
    expect_refused([&] { plan(problem, coarse(4)); }, words);
  };
  const Eigen::Vector3d lower(0, 0, 0), upper(0.1, 0.1, 1);
  refused(block_problem({0.1, 0.033, 0}, lower, upper, {11, 11, 11}), "lattice along y");
  refused(block_problem({0.2, 0, 0}, lower, upper, {11, 11, 11}), "lattice along x");
  refused(block_problem({0.1, 0, 0.55}, lower, upper, {11, 11, 11}), "lattice along yaw");
  refused(block_problem({0.1, 0, 0}, lower, upper, {11, 0, 11}), "counts must be 1");
  refused(block_problem({0, 0, 0}, lower, upper, {11, 11, 11}), "must differ");
  refused(block_problem({9e-7, 9e-7, 0}, lower, upper, {11, 11, 11}), "must differ");
  refused(block_problem({0.1, 0, M_PI}, lower, {0.1, 0.1, M_PI}, {11, 11, 2}), "more than 3 rad");
  Problem problem = block_problem({0.1, 0, 0}, lower, upper, {11, 11, 11});
  problem.planes.push_back({"wall", -Eigen::Vector3d::UnitX(), -0.11});
  refused(problem, "inside plane 'wall'");
  problem = block_problem({0.1, 0, 0}, lower, upper, {11, 11, 11});
  std::get<Lattice>(problem.motion).X_WO_goal =
      on_floor(0.1, 0, 0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY());
  refused(problem, "same face");
}

}  // namespace
}  // namespace graspless::fingertip
