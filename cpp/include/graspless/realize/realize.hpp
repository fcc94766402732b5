// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/fingertip/fingertip.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/planning/fields.hpp"
#include "graspless/robot/robot.hpp"
#include "graspless/scene/certificate.hpp"

namespace graspless::fingertip {

/// Parts of a robot that carry the fingertips.
struct Carrier {
  /// Frames at the centres of the fingertips' spheres, one for each finger of the plan.
  std::vector<std::string> fingertips = {"left_tip_center", "right_tip_center"};
  /// Links that may touch the object, for each fingertip: those that carry its sphere.
  std::vector<std::vector<std::string>> links = {{"left_finger"}, {"right_finger"}};
};

/// Options of realize(); fields() describes them.
struct RealizeOptions {
  double approach = 0.03;
  double resolution = 0.01;
  double max_jump = 0.05;
  double position_tolerance = 1e-4;
  int restarts = 40;
  int solutions = 8;
  int plans = 8;
  double max_scrub = 3e-4;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const RealizeOptions&) {
  using planning::Field, planning::Range;
  using Options = RealizeOptions;
  return std::make_tuple(
      Field{"approach", &Options::approach, "m",
            "Distance over which a finger approaches and leaves the surface along its normal. "
            "Where the hand does not open so far, a half, a quarter or an eighth of it.",
            Range::positive()},
      Field{"resolution", &Options::resolution, "rad",
            "Largest joint step between checked configurations.",
            Range::right_open(1e-4, Range{}.upper)},
      Field{"max_jump", &Options::max_jump, "rad or m", "Largest joint step between two rows.",
            Range::positive()},
      Field{"position_tolerance", &Options::position_tolerance, "m",
            "Largest distance of a fingertip from its planned position, at rows and between them.",
            Range::positive()},
      Field{"restarts", &Options::restarts, "",
            "Number of rounds of initial configurations to search from.", Range::closed(1, 1e6)},
      Field{"solutions", &Options::solutions, "",
            "Number of solutions to find; the one with the least scrub is kept.",
            Range::closed(1, 1e6)},
      Field{"plans", &Options::plans, "",
            "Number of fingertip plans to try: the best one, then those with fingertips nearer to "
            "each other.",
            Range::closed(1, 1e6)},
      Field{"max_scrub", &Options::max_scrub, "m",
            "Slip of a fingertip on its contact in a segment, above which further fingertip plans "
            "are tried. If all slip as far, that with the least scrub is kept.",
            Range::not_negative()});
}

/// Part of a joint motion. Consecutive rows differ by at most max_jump in any joint.
struct JointSegment {
  /// "approach", "touch", "slide", "turn", "tumble", "release", "reach" or "retreat". A regrasp is
  /// release, reach and touch.
  std::string name;
  std::vector<Eigen::VectorXd> positions;
  std::vector<Eigen::Isometry3d> X_WO;
  int plan_segment = -1;  ///< index of the plan's segment that it carries out; -1 for free motions
  /// Largest distance by which a touching finger slips on its contact during the segment [m]. The
  /// contacts of the plan are fixed points. A fingertip that rotates about another axis than the
  /// normal slips by its radius times that rotation.
  double scrub = 0;
};

/// Joint paths that carry a plan's fingertips, or the reason why there are none.
struct Realization {
  bool found = false;
  std::string reason;  ///< segment, row and finger that fail, and the reason
  std::vector<std::string> joint_names;
  std::vector<int> finger_of_fingertip;  ///< index of the plan's finger for each fingertip
  std::vector<JointSegment> segments;
  explicit operator bool() const { return found; }
};

/// Finds joint paths that carry a plan's fingertips: from q_home to the first grip, through every
/// row and regrasp, and back to q_home. At every row, inverse kinematics puts the centres of the
/// fingertips where the plan has them. The paths are continuous and within the joint limits, and
/// nothing touches but fingertips and object. All joints that move a fingertip take part. The
/// object moves only as the plan says. All links except the root must stay out of the planes. A
/// touching finger's links may penetrate the object by a few tenths of a millimetre, because of
/// position_tolerance. Tries every assignment of fingertips to fingers. Throws
/// std::invalid_argument on unknown frames or links, a home outside the limits, or a plan that is
/// not solved.
GRASPLESS_API Realization realize(const Problem& problem, const Plan& plan,
                                  const robot::Robot& robot, const Carrier& carrier,
                                  const Eigen::VectorXd& q_home, const RealizeOptions& options = {},
                                  const planning::Budget& budget = {});

/// A plan of the fingertips and the joint paths that carry it out.
struct CarriedPlan {
  Plan plan;
  Realization realization;
};

/// Calls plan() and realize(). If the robot cannot carry the best plan out, or only with a scrub
/// beyond max_scrub, plans whose fingertips are nearer together are tried: most often, the hand
/// does not open as wide as the best one needs. A plan that is not the best has a warning, and the
/// lower bound of the best. If there are joint paths for none, the best plan is returned with the
/// status not_realized. realize() never takes more than half of the time that is left, unless it is
/// the last call. Throws as plan() and realize() do.
GRASPLESS_API CarriedPlan plan_carried(const Problem& problem, const Options& options,
                                       const robot::Robot& robot, const Carrier& carrier,
                                       const Eigen::VectorXd& q_home,
                                       const RealizeOptions& realize_options = {},
                                       const planning::Budget& budget = {});

/// Checks joint paths against problem and plan: joint limits and steps, fingertips within the
/// tolerance of the plan's, collisions by FCL, and the object's poses. Returns one fault per entry;
/// empty if the paths are valid.
/// `options`: those of realize().
[[nodiscard]] GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                                           const robot::Robot& robot,
                                                           const Carrier& carrier,
                                                           const Realization& realization,
                                                           const RealizeOptions& options = {});

/// Proves what check() samples: on every edge of the joint paths, for every t, nothing touches that
/// may not, and the fingertips keep their tolerances. The object moves on a screw from row to row.
/// See slide::certify(). Throws std::invalid_argument if the paths were not found or are malformed.
[[nodiscard]] GRASPLESS_API scene::EdgeCertificate certify(const Problem& problem, const Plan& plan,
                                                           const robot::Robot& robot,
                                                           const Carrier& carrier,
                                                           const Realization& realization,
                                                           const RealizeOptions& options = {});

}  // namespace graspless::fingertip
