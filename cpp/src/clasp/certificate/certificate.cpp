// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/certificate.hpp"

#include <algorithm>
#include <vector>

#include "clasp/certificate/core.hpp"
#include "clasp/certificate/still_hand.hpp"
#include "clasp/certificate/way_out.hpp"
#include "clasp/parameters.hpp"

namespace graspless::clasp {
namespace {

constexpr int kShares = 8;  // of all moves: what one clearance may take

/// A ring of the hand and a loop of the object that are linked, if the ring has points.
struct Link {
  HandRing ring;
  CoreLoop loop;
};

Link link_of(const StillHand& hand, const Eigen::Matrix3Xd& loop_O, const Core& core) {
  const std::vector<int> near = hand.balls_outside(core);
  Link link{hand.ring(loop_O, 0, near), {loop_O, 0}};
  if (link.ring.points_O.cols() == 0) return link;
  const CoreLoop inside = core.loop(link.ring.points_O);
  if (!(inside.radius > 0)) return link;
  const HandRing around = hand.ring(inside.points, inside.radius, near);
  return around.points_O.cols() > 0 ? Link{around, inside} : link;
}

/// Clearance on a way out that was found, at most `upper` minus the tolerance. From there on, the
/// distance from the upper bound doubles until a search succeeds; then the gap is halved.
double way_out(WayOut& search, double upper, double nothing_left,
               const CertificateOptions& options) {
  const int share = std::max(1, options.moves / kShares);
  const auto left = [&] { return options.moves - static_cast<int>(search.num_moves()); };
  const auto exists = [&](double clearance) {
    return left() > 0 && search.exists(clearance, std::min(share, left()));
  };
  double found = nothing_left, failed = upper, step = options.tolerance;
  while (left() > 0 && upper - step > nothing_left) {
    if (exists(upper - step)) {
      found = upper - step;
      break;
    }
    failed = upper - step;
    step *= 2;
  }
  while (left() > 0 && failed - found > options.tolerance && upper - found > options.tolerance) {
    const double half = (failed + found) / 2;
    (exists(half) ? found : failed) = half;
  }
  return found;
}

}  // namespace

void validate(const CertificateOptions& options) {
  planning::require_in_range("certificate.", options);
}

Certificate certificate(const Problem& problem, const Eigen::VectorXd& q, int loop,
                        const CertificateOptions& options) {
  validate(problem);
  validate(options);
  robot::require_configuration(problem.robot, q, "q");
  const Eigen::Matrix3Xd& loop_O = loop_points(problem, loop);
  const StillHand hand(problem, q);
  const double nothing_left = hand.radii.size() > 0 ? -hand.radii.maxCoeff() : 0;
  Certificate result;
  result.lower = nothing_left;
  const Link link = link_of(hand, loop_O, problem.object.core());
  if (link.ring.points_O.cols() == 0) {
    result.upper = kUnlinked;
    return result;
  }
  result.upper = link.ring.clearance;
  result.caged = result.upper < 0;
  result.thickness = 2 * link.loop.radius;
  result.gap = link.ring.gap;
  for (std::size_t i = 0; i < 2; ++i) {
    const int of_ball = hand.links[link.ring.balls[i]];
    result.between[i] = problem.robot.frame_names()[of_ball];
  }
  if (options.moves == 0) return result;
  const auto clearance = problem.object.borrow_outer_clearance();
  WayOut search(hand, link.ring, link.loop.points, *clearance, options.seed);
  const double wanted = result.upper - options.tolerance;
  if (wanted > search.clearance_at_start()) search.settle(wanted, options.moves / kShares);
  result.lower = way_out(search, result.upper, nothing_left, options);
  result.moves = search.num_moves();
  return result;
}

}  // namespace graspless::clasp
