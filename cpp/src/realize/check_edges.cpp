// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// certify() of a realization: proof of what check_motion.cpp samples between the rows.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "realize/examination.hpp"
#include "scene/bands.hpp"
#include "scene/edges.hpp"

namespace graspless::realize {
namespace {

/// Bounds on the object's screw between two rows, per unit of t.
struct ScrewRates {
  double turn;   // [rad]
  double speed;  // of the object's origin, which is constant [m]
};

/// The origin's path is an arc of the angle `turn` over its chord, or a stretched one.
ScrewRates screw_rates(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB) {
  const double turn =
      Eigen::AngleAxisd(Eigen::Matrix3d(X_WA.linear().transpose() * X_WB.linear())).angle();
  const double chord = (X_WB.translation() - X_WA.translation()).norm();
  return {turn, turn > 1e-6 ? chord * (turn / 2) / std::sin(turn / 2) : chord * (1 + turn)};
}

}  // namespace

scene::EdgeCertificate Examination::certify() {
  expect_phases();
  if (!has_shape() || !assigns_fingertips()) {
    throw std::invalid_argument("realization: cannot be certified; " + faults_.front());
  }
  scene::EdgeCertificateMaker certificate;
  for (segment_ = 0; segment_ < phases_.size(); ++segment_) {
    const JointSegment& segment = realization_.segments[segment_];
    std::vector<scene::Doubt> doubts = prove_tips(segment, phases_[segment_]);
    for (auto& doubt : prove_free(segment, phases_[segment_])) doubts.push_back(std::move(doubt));
    certificate.add(segment_name(), segment.positions, std::move(doubts));
  }
  return certificate.take();
}

std::vector<scene::Doubt> Examination::prove_free(const JointSegment& segment, const Phase& phase) {
  const std::vector<Replay::Allowed> allowed = allowances(phase);
  const auto pose = [&](std::size_t edge, double t) {
    return on_screw(segment.X_WO[edge], segment.X_WO[edge + 1], t);
  };
  scene::Companion object;
  object.body = replay_.object();
  object.place = [&](std::size_t edge, double t, const robot::Poses&) {
    replay_.place(pose(edge, t), allowed);
  };
  // A point of the object, moved by an allowance that turns with it.
  const double radius =
      replay_.bodies().world().radius(object.body) + contact_allowance(options_.position_tolerance);
  object.length = [&, radius](std::size_t edge, double t0, double t1) {
    const ScrewRates rates = screw_rates(segment.X_WO[edge], segment.X_WO[edge + 1]);
    return (t1 - t0) * (rates.speed + radius * rates.turn);
  };
  return scene::EdgeProver(segment_name(), segment.positions, replay_.bodies(), object).run();
}

/// Bounds check_tips() on each edge. In the object's frame, a fingertip's path has at most the
/// second derivative of its own in the world, of the object's, and of Coriolis.
std::vector<scene::Doubt> Examination::prove_tips(const JointSegment& segment, const Phase& phase) {
  using Tips = std::vector<Eigen::Vector3d>;
  std::vector<scene::Doubt> doubts;
  for (std::size_t edge = 0; edge + 1 < segment.positions.size(); ++edge) {
    const Eigen::VectorXd& from = segment.positions[edge];
    const Eigen::VectorXd step = segment.positions[edge + 1] - from;
    const auto place = [&](double t) {
      robot_.forward(from + t * step, X_WL_);
      const auto X_WO = on_screw(segment.X_WO[edge], segment.X_WO[edge + 1], t);
      Tips tips;
      for (std::size_t i = 0; i < phase.places.size(); ++i) {
        tips.push_back(tip_O(i, X_WO) - center_O(i, phase));
      }
      return tips;
    };
    const std::vector<double> bends = tip_bends(segment, edge, step);
    const auto slack = [&](double t0, const Tips& first, double t1, const Tips& last) {
      scene::Slack slack;
      for (std::size_t i = 0; i < phase.places.size(); ++i) {
        add_tip(phase, i, first[i], last[i], bends[i] * (t1 - t0) * (t1 - t0) / 8, slack);
      }
      return slack;
    };
    const auto doubt = scene::find_doubt(segment_name(), edge, place, slack);
    if (doubt) doubts.push_back(*doubt);
  }
  return doubts;
}

/// Bounds on the second derivative of each fingertip's path in the object's frame [m].
std::vector<double> Examination::tip_bends(const JointSegment& segment, std::size_t edge,
                                           const Eigen::VectorXd& step) {
  const Eigen::Isometry3d &X_WA = segment.X_WO[edge], &X_WB = segment.X_WO[edge + 1];
  const ScrewRates object = screw_rates(X_WA, X_WB);
  std::vector<double> bends;
  for (const int frame : frame_of_finger_) {
    const scene::FrameRates tip = scene::frame_rates(robot_, frame, step);
    const Eigen::Vector3d first = robot_.pose(frame, segment.positions[edge]).translation(),
                          last = robot_.pose(frame, segment.positions[edge + 1]).translation();
    const double speed = (last - first).norm() + tip.curvature / 2;
    const double reach = (first - X_WA.translation()).norm() + speed + object.speed;
    bends.push_back(tip.curvature + object.turn * object.speed +
                    2 * object.turn * (speed + object.speed) + object.turn * object.turn * reach);
  }
  return bends;
}

/// `first` and `last`: places relative to the contact's at both ends, in O; in between, the tip
/// keeps within `off` of the straight line.
void Examination::add_tip(const Phase& phase, std::size_t finger, const Eigen::Vector3d& first,
                          const Eigen::Vector3d& last, double off, scene::Slack& slack) const {
  const double tolerance = options_.position_tolerance + 1e-9;
  if (phase.holds[finger]) {
    slack.add(tolerance - std::max(first.norm(), last.norm()) - off,
              "distance of a fingertip from its place");
  }
  if (!phase.moves[finger]) return;
  const Eigen::Vector3d out_O = -phase.places[finger].n_O;
  const double low = std::min(first.dot(out_O), last.dot(out_O)),
               high = std::max(first.dot(out_O), last.dot(out_O));
  const double aside =
      std::max((first - first.dot(out_O) * out_O).norm(), (last - last.dot(out_O) * out_O).norm());
  slack.add(tolerance - aside - off, "distance of a fingertip from its normal");
  slack.add(std::min(low + tolerance, options_.approach + tolerance - high) - off,
            "distance of a fingertip along its normal");
}

}  // namespace graspless::realize

namespace graspless::fingertip {

scene::EdgeCertificate certify(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                               const Carrier& carrier, const Realization& realization,
                               const RealizeOptions& options) {
  realize::validate_realization(problem, plan, robot, carrier, options);
  return realize::Examination(problem, plan, robot, carrier, realization, options).certify();
}

}  // namespace graspless::fingertip
