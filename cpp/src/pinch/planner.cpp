// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "graspless/pinch/pinch.hpp"

#include "pinch/grasps.hpp"
#include "planning/obstruction.hpp"
#include "planning/plan_within.hpp"
#include "robot/moved_links.hpp"
#include "scene/rows.hpp"
#include "slide/contact_space.hpp"
#include "slide/hand_motion.hpp"

namespace graspless::pinch {

using planning::Path;

namespace {

constexpr double kGraspStep = 0.01;    // between waypoints of the straight motion [m]
constexpr double kUneven = 0.003;      // gap left at one finger when the other touches [m]
constexpr double kPast = 0.002;        // by which faces that turn may pass those of the object [m]
constexpr std::size_t kSolutions = 4;  // of inverse kinematics, for each hand pose
constexpr std::size_t kSearched = 4;   // poses to which a tree is grown
constexpr int kIterations = 400;       // of each
constexpr const char* kReach = "reach";

/// An arm with fewer than six joints reaches a pose only if its axes are exactly parallel or
/// square. URDFs round them, and tables lean: so may the hand.
robot::Ik make_ik(const Problem& problem, const slide::Arm& arm) {
  constexpr double kRounded = 2e-5, kLean = 0.01;  // [m], [rad]
  robot::Ik::Options options;
  if (arm.joints().size() < 6) {
    options.tolerance = kRounded;
    options.lean = kLean;
  }
  options.whole_turns = false;  // they touch the same things
  return robot::Ik(problem.robot, problem.robot.frame(problem.hand.grasp_frame), arm.joints(),
                   options);
}

/// The motion onto the object, without the way from home.
struct Pinch {
  Grasp grasp;
  Path straight;  // of the arm
  std::vector<Eigen::VectorXd> close;
};

/// Working state of one plan().
class Search {
 public:
  Search(const Problem& problem, const Options& options, planning::Clock& clock, std::uint64_t seed)
      : problem_(problem),
        options_(options),
        clock_(clock),
        rng_(seed),
        jaw_(problem, options),
        arm_(problem, jaw_.open().q),
        ik_(make_ik(problem, arm_)),
        scene_(slide::make_scene(problem)),
        hand_(problem.robot, arm_, scene_, options.resolution, statistics_.ik_calls) {
    scene_.move_object(scene_.world().body(slide::kObjectBody), problem.X_WO_start);
  }

  Plan run() {
    Plan plan;
    plan.opening = jaw_.widest();
    if (const auto [a, b] = scene_.collision(problem_.q_home); !a.empty()) {
      plan.status = Status::start_in_collision;
      plan.reason = "at home, " + planning::contact(a, b);
      return plan;
    }
    Grasps grasps = find_grasps(problem_, options_, jaw_);
    statistics_.faces = static_cast<std::int64_t>(grasps.num_faces);
    plan.status = grasps.status;
    plan.reason = grasps.reason;
    if (!grasps.all.empty()) search(grasps.all, plan);
    statistics_.seconds = clock_.seconds();
    statistics_.collision_checks = scene_.world().num_checks();
    plan.statistics = statistics_;
    return plan;
  }

 private:
  /// Tries the grasps; then half of the approach for those to which the arm could not follow all.
  void search(const std::vector<Grasp>& grasps, Plan& plan) {
    plan.reason = beyond_reach(grasps);
    plan.status = Status::not_reached;
    if (!plan.reason.empty()) return;
    std::vector<std::size_t> all(
        std::min(grasps.size(), static_cast<std::size_t>(options_.grasps)));
    std::iota(all.begin(), all.end(), 0);
    if (search(grasps, all, options_.approach, plan)) return;
    if (search(grasps, std::exchange(not_followed_, {}), options_.approach / 2, plan)) return;
    fail(plan);
  }

  /// Lengths, if all grasps are farther than the arm reaches.
  std::string beyond_reach(const std::vector<Grasp>& grasps) const {
    const robot::Robot& robot = problem_.robot;
    const auto span = robot::span_of(robot, robot.group(problem_.hand.arm),
                                     robot.frame(problem_.hand.grasp_frame), problem_.q_home);
    if (!span) return "";
    double nearest = std::numeric_limits<double>::infinity();
    for (const Grasp& grasp : grasps)
      nearest = std::min(nearest, (grasp.X_WH.translation() - span->base_W).norm());
    if (nearest <= span->most) return "";
    return robot::beyond(robot, *span, "the hand", "its nearest pose", nearest);
  }

  bool search(const std::vector<Grasp>& grasps, const std::vector<std::size_t>& tried,
              double approach, Plan& plan) {
    std::vector<Pinch> unreached;  // no straight motion leads there
    for (const std::size_t i : tried) {
      if (unreached.size() == kSearched || !clock_.spend()) break;
      tried_ = std::max(tried_, i + 1);
      is_too_long_ = false;
      for (const Eigen::VectorXd& q : configurations(grasps[i])) {
        bool is_uneven = false;
        std::optional<Pinch> pinch = add_motion(grasps[i], q, approach, is_uneven);
        if (is_uneven) break;  // so it is with every configuration of the arm
        if (!pinch) continue;
        if (add_approach(*pinch, 0, plan)) return true;
        unreached.push_back(std::move(*pinch));
        break;
      }
      if (is_too_long_) not_followed_.push_back(i);
    }
    for (const Pinch& pinch : unreached) {
      if (clock_.is_out()) break;
      if (add_approach(pinch, kIterations, plan)) return true;
      refuse("no way from home");
    }
    return false;
  }

  void refuse(const std::string& why) { ++statistics_.refusals[why]; }

  /// Collision-free configurations that put the hand that comes at a pose, the nearest to home
  /// first.
  std::vector<Eigen::VectorXd> configurations(const Grasp& grasp) {
    ++statistics_.ik_calls;
    std::vector<Eigen::VectorXd> found;
    const auto all = ik_.solve_all(grasp.X_WH, arm_.open(), rng_);
    if (all.empty()) refuse(kReach);
    for (const Eigen::VectorXd& q : all) {
      if (found.size() == kSolutions) break;
      if (scene_.is_free(q)) {
        found.push_back(q);
      } else {
        const auto [a, b] = scene_.collision(q);
        refuse(a.empty() ? "joint limits" : "collision of " + a + " with " + b);
      }
    }
    return found;
  }

  /// Closes the hand, and moves it straight to where it closes, the last bit sideways if one jaw
  /// opens too little; nothing if it cannot. One finger may touch before the other (`is_uneven`).
  std::optional<Pinch> add_motion(const Grasp& grasp, const Eigen::VectorXd& q, double approach,
                                  bool& is_uneven) {
    slide::HandMotion::Closing closing = hand_.close(arm_.part(q));
    const auto& [a, b] = closing.touching;
    if (!slide::is_finger_on_object(problem_.hand, a, b)) {
      refuse(a.empty() ? "closing: nothing touches" : "closing: " + a + " touches " + b);
      return std::nullopt;
    }
    const Grip end = jaw_.at(closing.rows.back());
    if (end.gap > grasp.faces.width + kUneven) {
      refuse("closing: one finger touches before the other");
      is_uneven = true;
      return std::nullopt;
    }
    if (!is_by_faces(end, grasp.faces.width)) {
      refuse("closing: a part of a finger other than its face touches");
      return std::nullopt;
    }
    std::vector<Eigen::Isometry3d> outwards;
    const double shift = grasp.shift;
    const int aside = shift == 0 ? 0 : slide::pieces(std::abs(shift), kGraspStep),
              steps = slide::pieces(approach, kGraspStep);
    for (int i = 1; i <= aside; ++i)
      outwards.push_back(grasp.X_WH * Eigen::Translation3d(0, shift * i / aside, 0));
    for (int i = 1; i <= steps; ++i) {
      const double back = -approach * i / steps;
      outwards.push_back(grasp.X_WH * Eigen::Translation3d(0, shift, back));
    }
    const auto out = hand_.track(ik_, arm_.part(q), outwards);
    if (!out) {
      refuse("straight approach");
      is_too_long_ = true;
      return std::nullopt;
    }
    return Pinch{grasp, Path(out->rbegin(), out->rend()), std::move(closing.rows)};
  }

  /// True if fingers that have closed hold an object of some width by their faces, not by what is
  /// beside these: jaws that turn reach over low objects.
  bool is_by_faces(const Grip& end, double width) const {
    const std::optional<Grip> meant = jaw_.at_width(width);
    const auto& heights = problem_.object.heights();  // whose faces are staircases of cells
    const double past = kPast + (heights ? 2 * heights->cell : 0);
    return end.gap >= width - past &&
           (!meant ||
            std::abs(end.contact_H.x() - meant->contact_H.x()) <= problem_.hand.pad_width / 2);
  }

  bool add_approach(const Pinch& pinch, int iterations, Plan& plan) {
    const auto free = hand_.free_path(arm_.part(problem_.q_home), pinch.straight.front(),
                                      iterations, rng_, [&] { return clock_.is_out(); });
    if (!free || !hand_.is_free(problem_.q_home, arm_.open())) return false;
    Path approach;
    if (problem_.q_home != arm_.open()) approach.push_back(problem_.q_home);
    for (const Eigen::VectorXd& arm : *free) approach.push_back(arm_.full(arm));
    append("approach", approach, plan);
    Path straight;
    for (const Eigen::VectorXd& arm : pinch.straight) straight.push_back(arm_.full(arm));
    append("grasp", straight, plan);
    append("close", pinch.close, plan);
    plan.status = Status::solved;
    plan.reason.clear();
    plan.X_WH_grasp =
        problem_.robot.pose(problem_.robot.frame(problem_.hand.grasp_frame), straight.back());
    plan.friction = pinch.grasp.faces.friction;
    plan.max_mass = pinch.grasp.faces.max_mass;
    plan.contacts_O.resize(3, 2);
    plan.contacts_O.topRows<2>() << pinch.grasp.faces.first, pinch.grasp.faces.second;
    plan.contacts_O.row(2).setConstant(pinch.grasp.height);
    return true;
  }

  void append(const std::string& name, const Path& path, Plan& plan) const {
    const Path rows = planning::subdivided(path, scene::kRowStep, problem_.robot.step_weights());
    plan.segments.push_back(
        {name, rows, std::vector<Eigen::Isometry3d>(rows.size(), problem_.X_WO_start)});
  }

  /// Poses out of reach, such as those from a side, say less than the others.
  void fail(Plan& plan) {
    auto refusals = statistics_.refusals;
    plan.reason = "none of " + std::to_string(tried_) + " hand poses works";
    if (refusals.size() > 1 && refusals.count(kReach) > 0) {
      plan.reason += ", " + std::to_string(refusals[kReach]) + " of them are out of reach";
      refusals.erase(kReach);
    }
    plan.reason += planning::obstruction(refusals, clock_.ran_out());
    plan.status = clock_.was_interrupted() ? Status::interrupted : Status::not_reached;
  }

  const Problem& problem_;
  const Options& options_;
  planning::Clock& clock_;
  std::mt19937_64 rng_;
  Statistics statistics_;
  std::size_t tried_ = 0;                  // hand poses
  bool is_too_long_ = false;               // the approach to the present one
  std::vector<std::size_t> not_followed_;  // those to which the arm could not follow the approach
  Jaw jaw_;
  slide::Arm arm_;
  robot::Ik ik_;
  scene::Scene scene_;
  slide::HandMotion hand_;
};

}  // namespace

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  planning::Clock clock(budget, options.max_memory);
  Plan plan = planning::plan_within(clock, "shapes and outlines of fewer corners", [&] {
    validate(problem, false);
    validate(options);
    return Search(problem, options, clock, budget.seed).run();
  });
  plan.statistics.iterations = clock.iterations();
  plan.joint_names = problem.robot.joint_names();
  return plan;
}

void validate(const Options& options) { planning::require_in_range("options.", options); }

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::pinch
