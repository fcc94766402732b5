// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <stdexcept>
#include <utility>

#include "graspless/carry/carry.hpp"

#include "carry/check_held.hpp"
#include "scene/rows.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using Faults = std::vector<std::string>;

/// Replays one plan and collects its faults.
class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem),
        plan_(plan),
        options_(options),
        held_(problem, options),
        hanging_(hanging_replay(problem, options)),
        way_{problem.object.X_WB, problem.X_WO_goal, options.max_twist} {
    if (hanging_) hanging_->ignore_touched(problem.q_start);
  }

  /// Proves what lies between the rows.
  scene::EdgeCertificate certify() {
    require_shape();
    scene::EdgeCertificateMaker certificate;
    auto doubts = way_.prove(held_, carried(), options_);
    for (auto& doubt : held_.prove_free(carried())) doubts.push_back(std::move(doubt));
    if (hanging_)
      for (auto& doubt : hanging_->prove_free(carried())) doubts.push_back(std::move(doubt));
    certificate.add(carried().name, carried().positions, std::move(doubts));
    return certificate.take();
  }

  Faults run() {
    faults_ = shape_faults(problem_, plan_, {"carry"});
    if (!faults_.empty()) return faults_;
    check_rows();
    check_object_poses();
    replay();
    check_end();
    return faults_;
  }

 private:
  const Segment& carried() const { return plan_.segments[0]; }

  void fault(std::size_t row, const std::string& what) {
    faults_.push_back("carry row " + std::to_string(row) + ": " + what);
  }

  void require_shape() {
    const Faults wrong = shape_faults(problem_, plan_, {"carry"});
    if (!wrong.empty()) throw std::invalid_argument("plan: cannot be certified; " + wrong.front());
  }

  void check_rows() {
    if ((carried().positions[0] - problem_.q_start).lpNorm<Eigen::Infinity>() > kSame)
      fault(0, "is not q_start");
    scene::check_rows(problem_.robot, problem_.q_start, kSame, carried().positions,
                      [&](std::size_t row, const std::string& what) { fault(row, what); });
    for (std::size_t row = 0; row < carried().positions.size(); ++row) {
      if (moved(problem_, false, problem_.q_start, carried().positions[row]) > kSame)
        fault(row, "a joint outside the arm's group moves");
    }
  }

  void check_object_poses() {
    for (std::size_t row = 0; row < carried().positions.size(); ++row) {
      if (!scene::is_same(carried().object_poses[row], held_.object_at(carried().positions[row]),
                          kSame))
        fault(row, "the object moves relative to the hand");
    }
  }

  void replay() {
    std::size_t faulty_row = carried().positions.size();  // one fault per row is enough
    scene::replay_rows(problem_.robot, carried().positions,
                       [&](std::size_t row, const VectorXd& q) {
                         if (row == faulty_row) return;
                         const Isometry3d X_WO = held_.object_at(q);
                         auto touching = held_.touching(q, X_WO);
                         if (touching.empty() && hanging_)
                           touching = hanging_->touching(q, hanging_->object_at(q));
                         const std::string off = way_.fault_of(X_WO, options_);
                         if (touching.empty() && off.empty()) return;
                         faulty_row = row;
                         fault(row, touching.empty() ? off : "collision " + touching.front());
                       });
  }

  void check_end() {
    const Vector3d missing =
        carried().object_poses.back().translation() - problem_.X_WO_goal.translation();
    const double turned =
        angle_between(carried().object_poses.back().linear(), problem_.X_WO_goal.linear());
    const double allowed = options_.max_twist + options_.angle_tolerance;
    if (missing.norm() > options_.tolerance || turned > allowed + kSame)
      fault(carried().positions.size() - 1, "the object is not at its goal");
  }

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  HeldReplay held_;
  std::optional<HeldReplay> hanging_;
  StraightWay way_;
  Faults faults_;
};

}  // namespace

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  if (problem.places) return check_places(problem, plan, options);
  return Examination(problem, plan, options).run();
}

scene::EdgeCertificate certify(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  if (problem.places) return certify_places(problem, plan, options);
  return Examination(problem, plan, options).certify();
}

}  // namespace graspless::carry
