// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "graspless/watch.hpp"

#include "clasp/center.hpp"
#include "clasp/grip.hpp"
#include "clasp/parameters.hpp"
#include "clasp/search/task_space.hpp"
#include "clasp/squeeze.hpp"
#include "scene/rows.hpp"

namespace graspless::clasp {

using planning::Path;

namespace {

constexpr int kPruningRounds = 60;  // costs little beside the search

/// Randomised path pruning of Section IV-D. Keeps both ends.
Path pruned(Query& query, Path path) {
  std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>>
      refused;  // the same pairs are drawn repeatedly
  const planning::Connect straight = [&](const Eigen::VectorXd& a,
                                         const Eigen::VectorXd& b) -> std::optional<Path> {
    const auto pair = std::make_pair(a, b);
    if (query.clock.is_out() || std::count(refused.begin(), refused.end(), pair) > 0)
      return std::nullopt;
    if (query.is_motion_free(a, b)) return Path{a, b};
    refused.push_back(pair);
    return std::nullopt;
  };
  return planning::shortcut(std::move(path), straight, kPruningRounds, query.rng);
}

Segment segment(const std::string& name, const Path& path, TaskSpace& task_space,
                const Eigen::VectorXd& weights) {
  Segment segment{name, planning::subdivided(path, scene::kRowStep, weights), {}};
  const auto rows = static_cast<Eigen::Index>(segment.positions.size());
  segment.virtual_linking.resize(task_space.kinematics().num_curves(), rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    poll();
    task_space.project(segment.positions[i]);
    segment.virtual_linking.col(i) = task_space.linking_of_curves();
  }
  return segment;
}

std::string most_frequent(const std::map<std::string, std::int64_t>& refusals) {
  std::vector<std::pair<std::int64_t, std::string>> sorted;
  for (const auto& [why, times] : refusals) sorted.emplace_back(times, why);
  std::sort(sorted.rbegin(), sorted.rend());
  std::ostringstream out;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, sorted.size()); ++i) {
    out << (i ? ", " : "; most often: ") << sorted[i].second << " (" << sorted[i].first << ")";
  }
  return out.str();
}

/// Widths of the gap in the best ring and of the object there, if one was computed.
std::string widths_of_ring(const Query& query) {
  const Certificate& ring = query.best_ring;
  if (ring.between[0].empty() || ring.gap <= 0) return "";
  const double given = 2 * query.options.stability.penetration;  // by the links on both sides
  std::ostringstream out;
  out << "; the hand that came nearest leaves a gap of " << std::lround(1000 * ring.gap)
      << " mm between " << ring.between[0] << " and " << ring.between[1] << ", in the test "
      << std::lround(1000 * (ring.gap + given)) << " mm (options.stability.penetration)";
  return out.str();
}

/// Counts the clasps that were refused, and names the efforts that the best of them lacks.
std::string insecure(const Query& query) {
  const robot::Robot& robot = query.problem.robot;
  const StabilityOptions& load = query.options.stability;
  std::ostringstream out;
  out << "clasps were found, but the object came free of ";
  const std::int64_t tests = query.statistics.stability_tests;
  out << (query.num_escaped == tests ? "all" : std::to_string(query.num_escaped) + " of") << ' '
      << tests << " in the stability test";
  if (query.most_withstood > 0) {
    const double most = std::floor(100 * query.most_withstood) / 100;  // less than the load
    out << ", and a sudden load of " << load.force << " N and " << load.torque
        << " Nm forces open the others, which hold with two fingers: they withstand " << most
        << " N or less (effort limits of the hand: ";
    for (const int joint : robot.group(query.problem.hand.hand)) {
      out << robot.joint_names()[joint] << ": " << robot.max_effort()[joint]
          << (robot.step_weights()[joint] > 1 ? " N; " : " Nm; ");
    }
    out << "options.stability.force and torque set the load)";
  }
  if (query.best_pinch.press > 0) {
    out.precision(3);
    out << "; pinched with " << query.best_pinch.press << " N a finger, friction resists "
        << std::floor(1000 * query.best_pinch.load) / 1000 << " of this load at most";
  }
  return out.str();
}

std::string reason(const Query& query, const Plan& plan) {
  const std::int64_t count = plan.statistics.cycles;
  const std::string cycles = std::to_string(count) + (count == 1 ? " cycle" : " cycles");
  std::ostringstream out;
  switch (plan.status) {
    case Status::solved:
      out << "loop " << plan.loop << (plan.pinch ? " pinched after " : " clasped after ") << cycles;
      break;
    case Status::interrupted:
      out << "interrupted after " << cycles;
      break;
    case Status::not_secure:
      out << insecure(query) << query.clock.note() << widths_of_ring(query);
      break;
    default:
      out << "no motion to a clasp found in " << cycles << query.clock.note()
          << most_frequent(plan.statistics.refusals);
  }
  return out.str();
}

/// Result of the test of a pinch, if the hand has two fingers and friction holds the object.
std::optional<Pinch> pinched(Query& query, const Eigen::VectorXd& q) {
  if (!query.may_pinch()) return std::nullopt;
  const Pinch pinch = query.pinching().test(q, query.options.friction, query.options.stability);
  if (pinch.load >= query.best_pinch.load && pinch.press > 0) query.best_pinch = pinch;
  return pinch.holds ? std::optional(pinch) : std::nullopt;
}

/// Force that a clasp must withstand to be accepted [N].
double enough(const Query& query) {
  const bool must_withstand =
      query.options.must_be_secure && query.problem.hand.fingers.size() == 1;
  return must_withstand ? query.options.stability.force : 0;
}

/// Runs the stability test and, if it fails, that of a pinch. If the clasp must hold, the loop that
/// escapes in the first sequence, or a load that is too large, ends the first of them.
void test(Query& query, int loop, Clasp& clasp) {
  const double before = query.clock.seconds();
  const Eigen::VectorXd& q = clasp.close.back();
  if (!query.tester) query.tester.emplace(query.problem);
  const Eigen::Matrix3Xd& loop_O = query.problem.object.loops().found[loop].points;
  const StabilityOptions& options = query.options.stability;
  if (query.options.must_be_secure) {
    clasp.stability = query.tester->test_quickly(q, loop_O, options, enough(query));
  } else {
    clasp.stability = query.tester->test(q, loop_O, options);
  }
  if (!clasp.stability.secure) clasp.pinch = pinched(query, q);
  if (clasp.pinch && query.options.must_be_secure)
    clasp.stability = query.tester->test(q, loop_O, options);
  ++query.statistics.stability_tests;
  query.statistics.stability_seconds += query.clock.seconds() - before;
}

/// Keeps the ring of the hand that held the loop best, of clasps that the object came free of.
/// Computed seldom, as it takes time.
void remember_escape(Query& query, int loop, const Clasp& clasp) {
  if (clasp.stability.margin > query.best_margin) {
    query.best_margin = clasp.stability.margin;
    query.best_closed = clasp.close.back();
    query.best_loop = loop;
  }
  if (++query.num_escaped < query.next_ring) return;
  query.next_ring = 2 * query.num_escaped;
  CertificateOptions bound;
  bound.moves = 0;
  query.best_ring = certificate(query.problem, query.best_closed, query.best_loop, bound);
}

/// Tests a closed hand. Returns why the clasp is refused; empty if it is not.
std::string test_closed(Query& query, ClaspSearch& search, Clasp& clasp) {
  const Eigen::VectorXd& q = clasp.close.back();
  if (!search.is_linked(clasp.reach.back()) || !search.is_clasped(q)) {
    return "clasp: a finger loses the loop while it closes";
  }
  const geometry::ClaspTarget* held = search.held_target_W(q);
  if (!held) return "clasp: away from every target";
  clasp.target_W = *held;
  test(query, search.task().loop, clasp);
  if (!query.options.must_be_secure || clasp.stability.secure || clasp.pinch) return "";
  if (clasp.stability.checks == 0 && clasp.stability.escapes == 0) return kBlocked;
  const double withstands = clasp.stability.withstands;
  if (withstands == 0 || withstands >= enough(query)) {
    remember_escape(query, search.task().loop, clasp);
    return kNotSecure;
  }
  query.most_withstood = std::max(query.most_withstood, withstands);
  return kForcedOpen;
}

/// Warns of handles that are too thick for the hand, a likely reason for failure.
void warn_of_thick_handles(const Problem& problem,
                           const std::vector<std::unique_ptr<ClaspSearch>>& searches, Plan& plan) {
  std::set<int> loops;  // several searches can have one loop
  for (const auto& search : searches) loops.insert(search->task().loop);
  for (const int loop : loops) {
    const double thickness = problem.object.loops().found[loop].thickness;
    if (!is_too_thick(problem.robot, problem.hand, thickness)) continue;
    std::ostringstream out;
    out << "loop " << loop << ": its handle of " << std::lround(1000 * thickness)
        << " mm is too thick for this hand to close around; only friction can hold it";
    plan.warnings.push_back(out.str());
  }
}

/// Closes the hand at the end of the reach, and closer if the object comes free of it and the hole
/// is small. Returns why the clasp is refused; empty if it is not.
std::string close_and_test(Query& query, ClaspSearch& search, Clasp& clasp) {
  close_centered(query, clasp.reach, clasp.close);
  const std::string why = test_closed(query, search, clasp);
  const bool may_squeeze = (why == kNotSecure || why == kBlocked) &&
                           is_small(query.problem, search.task().loop, query.width);
  if (!may_squeeze || !squeeze(search, clasp.reach, clasp.close)) return why;
  return test_closed(query, search, clasp);
}

}  // namespace

std::optional<Clasp> close_clasp(ClaspSearch& search) {
  Query& query = search.query();
  for (const bool squared : {false, true}) {
    Clasp clasp;
    clasp.reach = search.path();
    if (squared) {
      const geometry::ClaspTarget* held = search.held_target_W(clasp.reach.back());
      if (!held || !square_up(query, *held, clasp.reach)) break;
    }
    std::string why = close_and_test(query, search, clasp);
    if (why.empty() && !search.connect(clasp.reach)) why = "clasp: no way found to it";
    if (why.empty()) return clasp;
    query.refuse(why);
    if (!query.may_pinch()) break;
  }
  return std::nullopt;
}

void assemble(ClaspSearch& search, Clasp clasp, Plan& plan) {
  Query& query = search.query();
  const Problem& problem = query.problem;
  const LoopTask& task = search.task();
  TaskSpace task_space(problem.robot, problem.hand, task.points_W, task.targets_W);
  if (problem.q_start != clasp.reach.front()) {
    clasp.reach.insert(clasp.reach.begin(), problem.q_start);
  }
  const Eigen::VectorXd& weights = query.problem.robot.step_weights();
  plan.segments = {segment("reach", pruned(query, std::move(clasp.reach)), task_space, weights),
                   segment("close", clasp.close, task_space, weights)};
  plan.loop = task.loop;
  for (const Finger& finger : problem.hand.fingers) plan.fingers.push_back(finger.name);
  plan.pre_shape = problem.hand.open;
  const Eigen::Isometry3d X_OW = problem.X_WO.inverse();
  plan.target = {X_OW * clasp.target_W.point, X_OW.linear() * clasp.target_W.tangent};
  plan.min_linking = task.options.min_linking;
  plan.stability = clasp.stability;
  plan.pinch = clasp.pinch;
  plan.tree = search.tree();
  plan.status = Status::solved;  // last: the clock may end the pruning
}

void Query::add(const Query& other) {
  const Statistics& s = other.statistics;
  statistics.stability_seconds += s.stability_seconds;
  statistics.stability_tests += s.stability_tests;
  statistics.collision_checks += other.free.num_checks();
  statistics.fcl_checks += other.free.num_fcl_checks();
  for (const auto& [why, times] : s.refusals) statistics.refusals[why] += times;
  most_withstood = std::max(most_withstood, other.most_withstood);
  num_escaped += other.num_escaped;
  if (other.best_pinch.load > best_pinch.load) best_pinch = other.best_pinch;
  if (other.best_margin <= best_margin) return;
  best_margin = other.best_margin;
  if (!other.best_ring.between[0].empty()) best_ring = other.best_ring;
}

void conclude(const Query& query, const std::vector<std::unique_ptr<ClaspSearch>>& searches,
              Plan& plan) {
  Statistics& s = plan.statistics;
  s = query.statistics;
  s.seconds = query.clock.seconds();
  s.collision_checks += query.free.num_checks();
  s.fcl_checks += query.free.num_fcl_checks();
  for (const auto& search : searches) {
    const Effort effort = search->effort();
    s.cycles += effort.cycles;
    s.nodes += effort.nodes;
    s.restarts += effort.restarts;
    s.control_steps += effort.control_steps;
  }
  if (!plan) warn_of_thick_handles(query.problem, searches, plan);
  if (plan.reason.empty()) plan.reason = reason(query, plan);
}

}  // namespace graspless::clasp
