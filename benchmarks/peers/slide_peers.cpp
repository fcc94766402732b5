// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide_peers.hpp"

#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "graspless/planning/vector_states.hpp"

#include "ompl_peers.hpp"
#include "slide/assemble.hpp"
#include "slide/motions.hpp"
#include "slide/query.hpp"
#include "slide/regions.hpp"
#include "slide/search.hpp"

namespace graspless::benchmarks {

namespace ob = ompl::base;
using planning::Path;
using planning::vector;

namespace {

/// One given state.
class OneState : public planning::SampleableRegion {
 public:
  OneState(const ob::SpaceInformationPtr& si, const Eigen::VectorXd& arm)
      : planning::SampleableRegion(si), arm_(arm) {}
  bool try_sample(ob::State* state) const override {
    vector(state, arm_.size()) = arm_;
    return true;
  }
  std::optional<double> try_sample_partner(const ob::State*, ob::State* goal,
                                           double) const override {
    try_sample(goal);
    return 0;
  }
  unsigned int maxSampleCount() const override { return 1; }

 private:
  Eigen::VectorXd arm_;
};

constexpr double kAnyCost = std::numeric_limits<double>::infinity();

planning::Budget endless(std::uint64_t seed) {
  planning::Budget budget;
  budget.seconds = std::numeric_limits<double>::infinity();
  budget.seed = seed;
  return budget;
}

}  // namespace

struct PairProblem::Impl {
  Impl(const slide::Problem& given, const slide::Options& options, std::uint64_t seed)
      : problem(given),
        options(options),
        clock(endless(seed)),
        query(problem, this->options, clock, seed),
        motions(query) {}

  bool draw(PairDraw how);
  std::optional<Path> run_forest(Peer peer, planning::Clock& clock);

  slide::Problem problem;
  slide::Options options;
  planning::Clock clock;
  slide::Query query;
  slide::Motions motions;
  std::optional<std::pair<Eigen::VectorXd, Eigen::VectorXd>> pair;
};

bool PairProblem::Impl::draw(PairDraw how) {
  constexpr int kStarts = 200;
  constexpr int kGoals = 2000;  // for one start
  const auto si = slide::make_space(query);
  const slide::StartRegion starts(si, query);
  const slide::GoalRegion goals(si, query, motions);
  ob::ScopedState<> start(si), goal(si);
  const int n = query.arm.dof();
  for (int i = 0; i < kStarts; ++i) {
    if (!starts.try_sample(start.get())) continue;
    for (int j = 0; j < (how == PairDraw::fitting ? 1 : kGoals); ++j) {
      const bool drawn =
          how == PairDraw::fitting
              ? goals.try_sample_partner(start.get(), goal.get(), kAnyCost).has_value()
              : goals.try_sample(goal.get());
      if (!drawn || !goals.isStartGoalPairValid(start.get(), goal.get())) continue;
      pair.emplace(vector(start.get(), n), vector(goal.get(), n));
      return true;
    }
  }
  return false;
}

std::optional<Path> PairProblem::Impl::run_forest(Peer peer, planning::Clock& clock) {
  const auto si = slide::make_space(query);
  std::shared_ptr<ob::GoalSampleableRegion> goals;
  if (peer == Peer::cbirrt2) {
    goals = std::make_shared<slide::GoalRegion>(si, query, motions);
  } else {
    goals = std::make_shared<OneState>(si, pair->second);
  }
  const auto search =
      slide::make_search(query, si, std::make_shared<OneState>(si, pair->first), goals);
  search.planner->set_connect_first(peer == Peer::forest);
  const auto status =
      search.planner->solve(ob::PlannerTerminationCondition([&] { return !clock.spend(); }));
  if (status != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;
  return planning::to_path(search.problem->getSolutionPath(), query.arm.dof());
}

PairProblem::PairProblem(const slide::Problem& problem, const slide::Options& options,
                         PairDraw draw, std::uint64_t seed) {
  slide::validate(problem);
  slide::validate(options);
  impl_ = std::make_unique<Impl>(problem, options, seed);
  impl_->draw(draw);
}

PairProblem::~PairProblem() = default;

bool PairProblem::has_pair() const { return impl_->pair.has_value(); }

const Eigen::VectorXd& PairProblem::start() const {
  if (!has_pair()) throw std::logic_error("no pair was found");
  return impl_->pair->first;
}

const Eigen::VectorXd& PairProblem::goal() const {
  if (!has_pair()) throw std::logic_error("no pair was found");
  return impl_->pair->second;
}

bool PairProblem::is_valid(const Eigen::VectorXd& arm) {
  return impl_->query.contact.is_valid(arm, impl_->query.carried_from(start()));
}

slide::Plan PairProblem::completed(const Path& path) {
  slide::Plan plan;
  plan.joint_names = impl_->problem.robot.joint_names();
  slide::assemble(impl_->query, impl_->motions, slide::slid_along(impl_->query, path), plan);
  plan.reason = slide::to_string(plan.status);
  return plan;
}

Answer PairProblem::run(Peer peer, const planning::Budget& budget) {
  const bool is_ours = peer == Peer::forest || peer == Peer::cbirrt || peer == Peer::cbirrt2;
  impl_->query.rng.seed(budget.seed);
  planning::Clock clock(budget);
  const auto path = is_ours ? impl_->run_forest(peer, clock)
                            : run_ompl(peer, impl_->query, start(), goal(), clock, budget.seed);
  Answer answer;
  answer.seconds = clock.seconds();
  if (path) {
    answer.plan = completed(*path);
  } else if (clock.was_interrupted()) {
    answer.plan.status = slide::Status::interrupted;
  }
  answer.plan.reason = slide::to_string(answer.plan.status);
  return answer;
}

}  // namespace graspless::benchmarks
