// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Part of check(): proof of what lies between the rows.
#include "scene/edges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "slide/check/band_prover.hpp"
#include "slide/check/replay.hpp"

namespace graspless::slide {
namespace {

/// The object that follows the finger: bounds on its path.
class FollowingObject {
 public:
  FollowingObject(const Problem& problem, const Segment& slide, int fingertip,
                  const std::function<ReplayedFinger(const Eigen::VectorXd&)>& finger)
      : problem_(problem), slide_(slide), fingertip_(fingertip), finger_(finger) {
    const ReplayedFinger start = finger_(slide.positions.front());
    const Eigen::Isometry3d X_SO = problem.support.X_WS().inverse() * slide.object_poses.front();
    for (const auto& p_O : problem.object.outline().vertices().colwise()) {
      const Eigen::Vector3d p_S = X_SO * Eigen::Vector3d(p_O.x(), p_O.y(), 0);
      radius_ = std::max(radius_, (p_S.head<2>() - start.effective).norm());
    }
    const auto& map = problem.object.heights();  // whose cells reach beyond the outline
    if (map) radius_ += map->cell * std::sqrt(2.0);
  }

  /// Bound on the length of the path of each of the object's points on a part of an edge [m].
  double path(std::size_t edge, double t0, double t1) const {
    constexpr double kPart = 0.125;  // the bounds of a longer part are poor
    const Eigen::VectorXd& from = slide_.positions[edge];
    const Eigen::VectorXd step = slide_.positions[edge + 1] - from;
    const scene::FrameRates rates = scene::frame_rates(problem_.robot, fingertip_, step);
    const int parts = std::max(1, static_cast<int>(std::ceil((t1 - t0) / kPart)));
    const double width = (t1 - t0) / parts;
    double sum = 0;
    ReplayedFinger before = finger_(from + t0 * step);
    for (int i = 1; i <= parts; ++i) {
      const ReplayedFinger now = finger_(from + (t0 + i * width) * step);
      const FingerSpan span = finger_span(problem_.hand, before, now, rates, width);
      sum += span.effective_path + radius_ * span.turn;
      before = now;
    }
    return sum;
  }

 private:
  const Problem& problem_;
  const Segment& slide_;
  int fingertip_;
  std::function<ReplayedFinger(const Eigen::VectorXd&)> finger_;
  double radius_ = 0;  // farthest point of the object from the contact [m]
};

}  // namespace

scene::EdgeCertificate Examination::certify() {
  if (!has_shape()) throw std::invalid_argument("plan: cannot be certified; " + faults_.front());
  scene::EdgeCertificateMaker certificate;
  for (const Segment& segment : plan_.segments) {
    std::vector<scene::Doubt> doubts = BandProver(*this, segment).run();
    for (scene::Doubt& doubt : prove_free(segment)) doubts.push_back(std::move(doubt));
    certificate.add(segment.name, segment.positions, std::move(doubts));
  }
  return certificate.take();
}

std::vector<scene::Doubt> Examination::prove_free(const Segment& segment) const {
  Replay world = strict_.with(contacts_of(segment.name));
  const Eigen::Isometry3d& X_WO_first = segment.object_poses.front();
  world.move_object(X_WO_first);
  scene::Companion object;
  if (segment.name == "slide") {
    object.body = world.object();
    const Finger start = finger(segment.positions.front());
    object.place = [this, &world, &X_WO_first, start](std::size_t, double,
                                                      const robot::Poses& X_WL) {
      const Eigen::Isometry3d& X_WF = X_WL[fingertip_];
      world.move_object(followed(X_WO_first, start, finger(X_WF)));
    };
    const FollowingObject path(problem_, segment, fingertip_,
                               [this](const Eigen::VectorXd& q) { return finger(q); });
    object.length = [path](std::size_t edge, double t0, double t1) {
      return path.path(edge, t0, t1);
    };
  }
  return scene::EdgeProver(segment.name, segment.positions, world.bodies(), object).run();
}

scene::EdgeCertificate certify(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem, options);
  return Examination(problem, plan, options).certify();
}

}  // namespace graspless::slide
