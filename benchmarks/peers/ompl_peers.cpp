// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ompl_peers.hpp"

#include <algorithm>
#include <utility>

#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/Constraint.h>
#include <ompl/base/spaces/constraint/AtlasStateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/base/spaces/constraint/TangentBundleStateSpace.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "graspless/planning/vector_states.hpp"

namespace graspless::benchmarks {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using planning::BandProjection;
using slide::Query;

namespace {

constexpr int kRows = 3;
constexpr double kTolerance = 1e-4;  // OMPL's own default

/// No line of OMPL's on our output, in this scope.
class Silence {
 public:
  Silence() { ompl::msg::noOutputHandler(); }
  ~Silence() { ompl::msg::restorePreviousOutputHandler(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

/// Height, sine of the pitch and roll of the fingertip are what they are at the start.
class HeldContact : public ob::Constraint {
 public:
  HeldContact(Query& query, const Eigen::VectorXd& start)
      : ob::Constraint(static_cast<unsigned>(query.arm.dof()), kRows, kTolerance),
        query_(query),
        held_(kRows),
        projection_(make_projection(start)) {}

  void function(const Eigen::Ref<const Eigen::VectorXd>& arm,
                Eigen::Ref<Eigen::VectorXd> out) const override {
    BandProjection::Values value(kRows);
    query_.contact.rows(arm, value, nullptr);
    out = value - held_;
  }

  void jacobian(const Eigen::Ref<const Eigen::VectorXd>& arm,
                Eigen::Ref<Eigen::MatrixXd> out) const override {
    BandProjection::Values value(kRows);
    BandProjection::Jacobian J(kRows, query_.arm.dof());
    query_.contact.rows(arm, value, &J);
    out = J;
  }

  // OMPL's own calls Eigen's JacobiSVD, over which Debian's OMPL and KDL disagree.
  bool project(Eigen::Ref<Eigen::VectorXd> arm) const override {
    Eigen::VectorXd q = arm;
    const bool projected = projection_.project(q);
    arm = q;
    return projected;
  }

 private:
  BandProjection make_projection(const Eigen::VectorXd& start) {
    query_.contact.rows(start, held_, nullptr);
    const BandProjection::Values slack = BandProjection::Values::Constant(kRows, kTolerance / 2);
    return BandProjection(
        [this](const auto& arm, auto& value, auto* J) { query_.contact.rows(arm, value, J); },
        {held_, held_, slack}, {query_.arm.lower(), query_.arm.upper()});
  }

  Query& query_;
  BandProjection::Values held_;
  BandProjection projection_;
};

using ConstrainedState = ob::ConstrainedStateSpace::StateType;

/// What ContactSpace::is_valid asks besides the constraint: this is the state space's to keep, and
/// the tangent bundle keeps it only at the end.
bool is_valid(Query& query, const slide::ContactSpace::Carried& carried,
              const Eigen::VectorXd& arm) {
  const bool within = ((arm - query.arm.lower()).array() >= 0).all() &&
                      ((query.arm.upper() - arm).array() >= 0).all();
  const slide::Tip tip = query.contact.tip_at(arm);
  const slide::Planar contact = query.contact.effective_tip_at(arm);
  const geometry::Polygon& Q = query.problem.support.polygon();
  return within && tip.other_finger_up && Q.contains(tip.position) &&
         Q.depth(contact.translation()) >= query.options.tip_margin &&
         query.contact.scene_with_object_at(query.contact.carry(carried, arm))
             .is_free(query.arm.full(arm));
}

/// A constrained space, its space information and what planners are asked for.
struct Setup {
  ob::SpaceInformationPtr si;
  std::shared_ptr<ob::ProblemDefinition> problem;
};

bool is_atlas(Peer peer) {
  return peer == Peer::atlas_rrt_connect || peer == Peer::tangent_bundle_rrt_connect;
}

std::shared_ptr<ob::ConstrainedStateSpace> make_space(Peer peer, const ob::StateSpacePtr& ambient,
                                                      const ob::ConstraintPtr& constraint) {
  switch (peer) {
    case Peer::atlas_rrt_connect:
      return std::make_shared<ob::AtlasStateSpace>(ambient, constraint);
    case Peer::tangent_bundle_rrt_connect:
      return std::make_shared<ob::TangentBundleStateSpace>(ambient, constraint);
    default:
      return std::make_shared<ob::ProjectedStateSpace>(ambient, constraint);
  }
}

Setup make_setup(Peer peer, Query& query, const Eigen::VectorXd& start,
                 const Eigen::VectorXd& goal) {
  const auto constraint = std::make_shared<HeldContact>(query, start);
  const auto space =
      make_space(peer, planning::make_box(query.arm.lower(), query.arm.upper()), constraint);
  Setup s;
  if (peer == Peer::tangent_bundle_rrt_connect) {
    s.si = std::make_shared<ob::TangentBundleSpaceInformation>(space);
  } else {
    s.si = std::make_shared<ob::ConstrainedSpaceInformation>(space);
  }
  s.si->setStateValidityChecker(
      [&query, carried = query.carried_from(start)](const ob::State* state) {
        return is_valid(query, carried, *state->as<ConstrainedState>());
      });
  s.si->setup();

  ob::ScopedState<> from(space), to(space);
  from->as<ConstrainedState>()->copy(start);
  to->as<ConstrainedState>()->copy(goal);
  if (is_atlas(peer)) {
    space->as<ob::AtlasStateSpace>()->anchorChart(from.get());
    space->as<ob::AtlasStateSpace>()->anchorChart(to.get());
  }
  s.problem = std::make_shared<ob::ProblemDefinition>(s.si);
  s.problem->setStartAndGoalStates(from, to);
  return s;
}

template <class Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  constexpr double kRange = 1.0;  // [rad]; of 0.25, 0.5, 1 and OMPL's own guess the best for each
  auto planner = std::make_shared<Planner>(si);
  planner->setRange(kRange);
  return planner;
}

ob::PlannerPtr make_planner(Peer peer, const ob::SpaceInformationPtr& si) {
  return peer == Peer::projected_biest ? make<og::BiEST>(si) : make<og::RRTConnect>(si);
}

/// The path's states and those between them, each brought onto the constraint.
std::optional<planning::Path> densely(const Setup& setup, const ob::Constraint& constraint) {
  const auto& states = setup.problem->getSolutionPath()->as<og::PathGeometric>()->getStates();
  planning::Path path;
  const auto append = [&](const ob::State* state) {
    Eigen::VectorXd arm = *state->as<ConstrainedState>();
    if (!constraint.project(arm)) return false;
    if (path.empty() || arm != path.back()) path.push_back(arm);
    return true;
  };
  bool whole = append(states.front());
  for (std::size_t i = 1; i < states.size() && whole; ++i) {
    std::vector<ob::State*> between;
    setup.si->getMotionStates(states[i - 1], states[i], between, 0, false, true);
    whole = std::all_of(between.begin(), between.end(), append) && append(states[i]);
    setup.si->freeStates(between);
  }
  return whole ? std::optional(path) : std::nullopt;
}

}  // namespace

std::optional<planning::Path> run_ompl(Peer peer, Query& query, const Eigen::VectorXd& start,
                                       const Eigen::VectorXd& goal, planning::Clock& clock,
                                       std::uint64_t seed) {
  const Silence silence;
  // Global to the process; it complains of a second call, but the generators made from here on
  // follow it.
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0xffffffff) + 1);
  const Setup setup = make_setup(peer, query, start, goal);
  const ob::PlannerPtr planner = make_planner(peer, setup.si);
  planner->setProblemDefinition(setup.problem);
  planner->setup();
  const auto status =
      planner->solve(ob::PlannerTerminationCondition([&] { return clock.is_out(); }));
  if (status != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;
  return densely(setup,
                 *setup.si->getStateSpace()->as<ob::ConstrainedStateSpace>()->getConstraint());
}

}  // namespace graspless::benchmarks
