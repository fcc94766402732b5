// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parts of a slide query: discs and squares on the square table, in the paper's terms.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/planning/vector_states.hpp"
#include "graspless/slide/resume.hpp"

#include "slide/query.hpp"
#include "slide/regions.hpp"
#include "slide/search.hpp"

namespace graspless::slide {
namespace {

using Eigen::VectorXd;
using planning::BandProjection;

constexpr std::size_t kSamples = 256;

Options paper_terms() {
  Options options;
  options.com_margin = 0.001;
  options.tip_margin = 0;
  options.rim_margin = 0;
  return options;
}

geometry::Polygon rectangle(double x, double y, double width, double height) {
  Eigen::Matrix2Xd corners(2, 4);
  corners << x, x + width, x + width, x, y, y, y + height, y + height;
  return geometry::Polygon(corners);
}

/// A square of 10 cm somewhere on the table.
Problem make_problem(std::mt19937_64& rng) {
  static const robot::Robot robot =
      robot::Robot::from_urdf_file(std::string(GRASPLESS_URDF_DIR) + "/wam_t42.urdf");
  static const Object object =
      Object::from_polygon("square", rectangle(-0.05, -0.05, 0.1, 0.1), 0.005);
  static const Support table(rectangle(0.3, -0.35, 0.7, 0.7), Eigen::Isometry3d::Identity());
  VectorXd home(robot.dof());
  home << 0, 0.2, 0, 2.0, 0, 0.94, 0, 0;
  Hand hand;
  hand.finger_model = FingerModel::impedance;  // the contact at the commanded tip, as in the paper
  hand.wrist_stiffness = 600;
  std::uniform_real_distribution<double> offset(-0.27, 0.27), yaw(0, 6.28);
  Eigen::Isometry3d X_WO(Eigen::Translation3d(0.65 + offset(rng), offset(rng), 0));
  X_WO.rotate(Eigen::AngleAxisd(yaw(rng), Eigen::Vector3d::UnitZ()));
  return {robot, hand, object, table, X_WO, {}, home};
}

Problem make_problem() {
  std::mt19937_64 rng(1);
  return make_problem(rng);
}

Plan solved(const Problem& problem) {
  Plan plan = slide::plan(problem, paper_terms());
  if (!plan) throw std::runtime_error("the benchmark's problem was not solved: " + plan.reason);
  return plan;
}

/// Configurations of the arm that press on the object, and the same after a step of `length` [rad]
/// in a random direction.
std::vector<VectorXd> draw_steps(Query& query, double length) {
  const auto si = make_space(query);
  const StartRegion region(si, query);
  ompl::base::ScopedState<> state(si);
  std::normal_distribution<double> normal;
  std::vector<VectorXd> arms;
  while (arms.size() < kSamples) {
    if (!region.try_sample(state.get())) continue;
    VectorXd step(query.arm.dof());
    for (double& x : step) x = normal(query.rng);
    arms.emplace_back(planning::vector(state.get(), step.size()) + length * step.normalized());
  }
  return arms;
}

void BM_SlideProjection(benchmark::State& state) {
  const Problem problem = make_problem();
  Options options = paper_terms();
  options.min_depth = 0.005;
  options.max_depth = 0.005 + static_cast<double>(state.range(0)) / 1000;
  planning::Clock clock({});
  Query query(problem, options, clock, 1);
  const auto arms = draw_steps(query, 0.1);
  std::size_t i = 0, projected = 0;
  VectorXd arm;
  for (auto _ : state) {
    arm = arms[i++ % kSamples];
    projected += query.contact.project(arm);
  }
  state.counters["success"] = static_cast<double>(projected) / static_cast<double>(i);
}
BENCHMARK(BM_SlideProjection)->ArgName("range_mm")->Arg(0)->Arg(5)->Arg(20);

void BM_SlideConstraintRows(benchmark::State& state) {
  const Problem problem = make_problem();
  const Options options = paper_terms();
  planning::Clock clock({});
  Query query(problem, options, clock, 1);
  const auto arms = draw_steps(query, 0.1);
  BandProjection::Values value(3);
  BandProjection::Jacobian J(3, query.arm.dof());
  std::size_t i = 0;
  for (auto _ : state) {
    query.contact.rows(arms[i++ % kSamples], value, state.range(0) ? &J : nullptr);
    benchmark::DoNotOptimize(value);
  }
}
BENCHMARK(BM_SlideConstraintRows)->ArgName("jacobian")->Arg(0)->Arg(1);

void BM_SlideIsValid(benchmark::State& state) {
  const Problem problem = make_problem();
  const Options options = paper_terms();
  planning::Clock clock({});
  Query query(problem, options, clock, 1);
  const auto arms = draw_steps(query, 0);
  const auto carried = query.carried_from(arms.front());
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(query.contact.is_valid(arms[i++ % kSamples], carried));
  }
}
BENCHMARK(BM_SlideIsValid);

void BM_SlideQuery(benchmark::State& state) {
  const Problem problem = make_problem();
  const Options options = paper_terms();
  planning::Clock clock({});
  for (auto _ : state) benchmark::DoNotOptimize(Query(problem, options, clock, 1));
}
BENCHMARK(BM_SlideQuery);

void BM_SlideCheck(benchmark::State& state) {
  const Problem problem = make_problem();
  const Plan plan = solved(problem);
  for (auto _ : state) benchmark::DoNotOptimize(check(problem, plan, paper_terms()));
  std::size_t rows = 0;
  for (const Segment& segment : plan.segments) rows += segment.positions.size();
  state.counters["rows"] = static_cast<double>(rows);
}
BENCHMARK(BM_SlideCheck)->Unit(benchmark::kMillisecond);

std::vector<Problem> make_problems(std::mt19937_64& rng) {
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < 64; ++i) problems.push_back(make_problem(rng));
  return problems;
}

double quantile(std::vector<double> values, double fraction) {
  const auto count = static_cast<double>(values.size());
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(fraction * (count - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Runs `query` with a seed of its own each time; the time is the mean, counters are quantiles.
template <class Query>
void run_seeded(benchmark::State& state, const Query& query) {
  std::vector<double> times;
  for (auto _ : state) {
    planning::Budget budget;
    budget.seed = times.size();
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(query(times.size(), budget));
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    times.push_back(spent.count());
  }
  state.counters["median_ms"] = quantile(times, 0.5);
  state.counters["p99_ms"] = quantile(times, 0.99);
}

/// A query a time over 64 poses.
void BM_SlidePlan(benchmark::State& state) {
  std::mt19937_64 rng(1);
  const std::vector<Problem> problems = make_problems(rng);
  run_seeded(state, [&](std::size_t i, const planning::Budget& budget) {
    return slide::plan(problems[i % problems.size()], paper_terms(), budget);
  });
}
BENCHMARK(BM_SlidePlan)->Unit(benchmark::kMillisecond)->MinTime(1);

/// A row of the plan's slide, with the object up to 10 mm and 10 degrees aside.
Interruption interrupted(const Plan& plan, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> share(0, 1), angle(-3.14, 3.14), turn(-0.1745, 0.1745);
  const auto slide = std::find_if(plan.segments.begin(), plan.segments.end(),
                                  [](const Segment& s) { return s.name == "slide"; });
  const std::size_t row = rng() % slide->positions.size();
  const double aside = 0.01 * std::sqrt(share(rng)), direction = angle(rng);
  const Eigen::Translation3d shift(aside * std::cos(direction), aside * std::sin(direction), 0);
  const Eigen::AngleAxisd yaw(turn(rng), Eigen::Vector3d::UnitZ());
  return {slide->positions[row], shift * slide->object_poses[row] * yaw, plan.X_WO_goal};
}

/// An interruption a time over 1024, 16 of each of 64 plans; `solved` is the share that goes on.
void BM_SlideResume(benchmark::State& state) {
  std::mt19937_64 rng(1);
  const std::vector<Problem> problems = make_problems(rng);
  std::vector<Interruption> interruptions;
  for (int round = 0; round < 16; ++round) {
    for (const Problem& problem : problems)
      interruptions.push_back(interrupted(solved(problem), rng));
  }
  std::size_t solved = 0, count = 0;
  run_seeded(state, [&](std::size_t i, const planning::Budget& budget) {
    const Plan rest = resume(problems[i % problems.size()], interruptions[i % interruptions.size()],
                             paper_terms(), budget);
    solved += rest ? 1 : 0;
    ++count;
    return rest.segments.size();
  });
  state.counters["solved"] = static_cast<double>(solved) / static_cast<double>(count);
}
BENCHMARK(BM_SlideResume)->Unit(benchmark::kMillisecond)->Iterations(1024);

}  // namespace
}  // namespace graspless::slide
