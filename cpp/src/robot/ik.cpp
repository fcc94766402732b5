// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/ik.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "robot/closed_form.hpp"
#include "robot/damped_least_squares.hpp"
#include "robot/model.hpp"
#include "robot/names.hpp"
#include "robot/wraps.hpp"
#include "text.hpp"

namespace graspless::robot {

/// The links on the path to a frame: before the group, moved by the group, and after it.
struct Split {
  int base = 0;               // the link that carries the first joint of the group
  std::vector<int> group;     // links that the group moves
  std::vector<int> after;     // links after the last of these, up to and including the frame
  bool moves_before = false;  // joints before the group move the base
  bool moves_within = false;  // joints outside the group lie between its joints
  bool moves_after = false;   // joints after the group move the frame
};

namespace {

using Eigen::Isometry3d;
using Eigen::VectorXd;

constexpr double kSame = 1e-4;  // solutions this close in every joint count as equal [rad or m]

Split split(const Robot::Model& model, int frame, const std::vector<int>& group) {
  Split split;
  for (const int i : model.paths[frame]) {
    const Link& link = model.links[i];
    if (link.joint >= 0 && contains(group, link.joint)) {
      if (split.group.empty()) split.base = link.parent;
      for (const int j : split.after) split.moves_within |= model.links[j].joint >= 0;
      split.after.clear();
      split.moves_after = false;
      split.group.push_back(i);
    } else if (!split.group.empty()) {
      split.after.push_back(i);
      split.moves_after |= link.joint >= 0;
    } else {
      split.moves_before |= link.joint >= 0;
    }
  }
  return split;
}

void check_group(const Robot& robot, int frame, const std::vector<int>& group) {
  const Robot::Model& model = robot.model();
  if (frame < 0 || frame >= static_cast<int>(model.links.size())) {
    throw std::invalid_argument("frame must be in [0, " + std::to_string(model.links.size()) +
                                "), not " + std::to_string(frame));
  }
  if (group.empty()) throw std::invalid_argument("group must name at least one joint");
  for (std::size_t i = 0; i < group.size(); ++i) {
    const int joint = group[i];
    if (joint < 0 || joint >= robot.dof()) {
      throw std::invalid_argument("group: joint index must be in [0, " +
                                  std::to_string(robot.dof()) + "), not " + std::to_string(joint));
    }
    const std::string& name = model.joint_names[joint];
    if (std::count(group.begin(), group.end(), joint) > 1) {
      throw std::invalid_argument("group: joint '" + name + "' occurs twice");
    }
    const auto& movers = model.movers[frame];
    const auto moves = [&](int link) { return model.links[link].joint == joint; };
    if (std::none_of(movers.begin(), movers.end(), moves)) {
      throw std::invalid_argument("group: joint '" + name + "' does not move frame '" +
                                  model.frame_names[frame] + "'");
    }
  }
}

void check_options(const Ik::Options& options) {
  if (!(options.tolerance > 0)) throw std::invalid_argument("tolerance must be positive");
  require_within("lean", options.lean, 0, Ik::kMostLean);
  if (options.max_iterations < 1) throw std::invalid_argument("max_iterations must be positive");
  if (options.restarts < 0) throw std::invalid_argument("restarts must not be negative");
  require_within("free_samples", options.free_samples, 0, 10000);
}

/// A whole turn of a joint changes nothing, unless it is prismatic or another joint mimics it.
std::vector<bool> turning(const Robot::Model& model, const std::vector<int>& group) {
  std::vector<bool> turns;
  for (const int joint : group) {
    const auto holds_back = [&](const Link& link) {
      return link.joint == joint && (link.prismatic || link.is_mimic);
    };
    turns.push_back(std::none_of(model.links.begin(), model.links.end(), holds_back));
  }
  return turns;
}

std::optional<ClosedForm> detect(const Robot::Model& model, const Split& split,
                                 const std::vector<int>& group) {
  const std::size_t n = group.size();
  if ((n != 6 && n != 7) || split.group.size() != n || split.moves_within) return {};
  const VectorXd zero = VectorXd::Zero(model.lower.size());
  std::vector<Screw> screws;
  Isometry3d X_PL = Isometry3d::Identity();
  for (const int i : model.paths[split.group.back()]) {
    const Link& link = model.links[i];
    const bool is_before = screws.empty() && i != split.group[0];
    if (is_before) continue;
    place(link, zero, Isometry3d(X_PL), X_PL);
    const std::size_t next = screws.size();
    if (i != split.group[next]) continue;
    if (link.prismatic || link.is_mimic || link.joint != group[next]) return {};
    screws.push_back({X_PL.linear() * link.axis_L, X_PL.translation()});
  }
  return ClosedForm::detect(screws, X_PL);
}

double uniform(double lower, double upper, std::mt19937_64& rng) {
  return lower + (upper - lower) * std::uniform_real_distribution<double>(0, 1)(rng);
}

/// Returns the distinct columns, nearest to `q` first.
std::vector<VectorXd> sorted(const Eigen::MatrixXd& columns, int count, const VectorXd& q) {
  std::vector<VectorXd> solutions;
  for (int i = 0; i < count; ++i) {
    const auto same = [&](const VectorXd& other) {
      return (other - columns.col(i)).cwiseAbs().maxCoeff() < kSame;
    };
    if (std::none_of(solutions.begin(), solutions.end(), same))
      solutions.emplace_back(columns.col(i));
  }
  std::stable_sort(solutions.begin(), solutions.end(), [&](const VectorXd& a, const VectorXd& b) {
    return (a - q).squaredNorm() < (b - q).squaredNorm();
  });
  return solutions;
}

}  // namespace

struct Ik::Impl {
  Impl(const Robot& robot_, int frame_, std::vector<int> group_, const Options& options_)
      : robot(robot_),
        frame(frame_),
        group(std::move(group_)),
        options(options_),
        path(split(robot.model(), frame, group)),
        turns(turning(robot.model(), group)),
        closed_form(detect(robot.model(), path, group)),
        wraps(robot.lower(), robot.upper(), group, wrapped(), options.whole_turns),
        X_PW(robot.pose(path.base, VectorXd::Zero(robot.dof())).inverse()),
        X_FE(pose_after(VectorXd::Zero(robot.dof())).inverse()) {}

  /// Angles of the closed form are those of any turn. Its free joint keeps the given value.
  std::vector<bool> wrapped() const {
    std::vector<bool> wrapped = closed_form ? std::vector<bool>(turns.size(), true) : turns;
    if (has_free_joint()) wrapped[closed_form->free_joint()] = false;
    return wrapped;
  }

  bool has_free_joint() const { return closed_form && closed_form->free_joint() >= 0; }

  void check(const VectorXd& q) const {
    if (q.size() == robot.dof()) return;
    throw std::invalid_argument("q must have " + std::to_string(robot.dof()) + " values, not " +
                                std::to_string(q.size()));
  }

  /// Pose of the frame in the group's last link.
  Isometry3d pose_after(const VectorXd& q) const {
    Isometry3d X_EF = Isometry3d::Identity();
    for (const int i : path.after) place(robot.model().links[i], q, Isometry3d(X_EF), X_EF);
    return X_EF;
  }

  /// Required pose of the group's last link, in the frame of the link that carries the group.
  Isometry3d target(const Isometry3d& X_WF, const VectorXd& q) const {
    const Isometry3d X_WE = X_WF * (path.moves_after ? pose_after(q).inverse() : X_FE);
    return (path.moves_before ? robot.pose(path.base, q).inverse() : X_PW) * X_WE;
  }

  int sample_free(const Isometry3d& X_WF, const VectorXd& q, std::mt19937_64& rng,
                  Eigen::MatrixXd& solutions) const {
    const Isometry3d X_PE = target(X_WF, q);
    if (!has_free_joint()) return closed_form->solve(X_PE, 0, q, wraps, 0, solutions);
    const int joint = group[closed_form->free_joint()];
    int count = closed_form->solve(X_PE, q[joint], q, wraps, 0, solutions);
    const double lower = robot.lower()[joint], upper = robot.upper()[joint];
    const double width = (upper - lower) / std::max(1, options.free_samples);
    for (int i = 0; i < options.free_samples; ++i) {
      const double value = lower + width * uniform(i, i + 1, rng);
      count = closed_form->solve(X_PE, value, q, wraps, count, solutions);
    }
    return count;
  }

  /// Returns the group's joints of q, with revolute joints wrapped to [-pi, pi], so that equal
  /// solutions compare equal.
  void reduce(VectorXd& values) const {
    for (std::size_t i = 0; i < group.size(); ++i) {
      auto& value = values[i];
      if (turns[i]) value = std::remainder(value, 2 * M_PI);
    }
  }

  int descend(const Isometry3d& X_WF, const VectorXd& q, std::mt19937_64& rng,
              Eigen::MatrixXd& solutions) const {
    DampedLeastSquares solver(robot, frame, group);
    const auto n = static_cast<Eigen::Index>(group.size());
    int count = 0;
    for (int attempt = 0; attempt <= options.restarts; ++attempt) {
      VectorXd answer = q;  // joints outside the group stay there
      for (const int joint : group) {
        const double lower = robot.lower()[joint], upper = robot.upper()[joint];
        answer[joint] =
            attempt > 0 ? uniform(lower, upper, rng) : std::clamp(q[joint], lower, upper);
      }
      if (!solver.solve(X_WF, options, attempt > 0, answer)) continue;
      VectorXd values(n);
      for (Eigen::Index i = 0; i < n; ++i) values[i] = answer[group[i]];
      reduce(values);
      count = wraps.append(values.data(), q, count, solutions);
    }
    return count;
  }

  Robot robot;
  int frame;
  std::vector<int> group;
  Options options;
  Split path;
  std::vector<bool> turns;  // true for joints of the group that may make whole turns
  std::optional<ClosedForm> closed_form;
  Wraps wraps;
  Isometry3d X_PW;  // pose of the link that carries the group, if no joint before it moves
  Isometry3d X_FE;  // pose of the group's last link, if no joint after it moves
};

Ik::Ik(const Robot& robot, int frame, std::vector<int> group, const Options& options) {
  check_group(robot, frame, group);
  check_options(options);
  impl_ = std::make_shared<const Impl>(robot, frame, std::move(group), options);
}

bool Ik::is_closed_form() const { return impl_->closed_form.has_value(); }
const std::vector<int>& Ik::group() const { return impl_->group; }
std::optional<int> Ik::free_joint() const {
  if (!impl_->has_free_joint()) return {};
  return impl_->group[impl_->closed_form->free_joint()];
}

int Ik::solve_free(const Isometry3d& X_WF, double value, const VectorXd& q,
                   Eigen::MatrixXd& solutions) const {
  if (!is_closed_form()) {
    throw std::logic_error(
        "solve_free() needs an arm with a closed form; check is_closed_form() first");
  }
  impl_->check(q);
  return impl_->closed_form->solve(impl_->target(X_WF, q), value, q, impl_->wraps, 0, solutions);
}

void Ik::solve_free(const Isometry3d& X_WF, double value, const VectorXd& q,
                    std::vector<VectorXd>& solutions) const {
  Eigen::MatrixXd columns;
  const int count = solve_free(X_WF, value, q, columns);
  for (int i = 0; i < count; ++i) solutions.emplace_back(columns.col(i));
}

std::vector<VectorXd> Ik::solve_all(const Isometry3d& X_WF, const VectorXd& q,
                                    std::mt19937_64& rng) const {
  impl_->check(q);
  Eigen::MatrixXd solutions;
  const int count = is_closed_form() ? impl_->sample_free(X_WF, q, rng, solutions)
                                     : impl_->descend(X_WF, q, rng, solutions);
  return sorted(solutions, count, q);
}

std::optional<VectorXd> Ik::solve_near(const Isometry3d& X_WF, const VectorXd& q) const {
  impl_->check(q);
  DampedLeastSquares solver(impl_->robot, impl_->frame, impl_->group);
  VectorXd answer = q;
  for (const int joint : impl_->group) {
    answer[joint] = std::clamp(q[joint], impl_->robot.lower()[joint], impl_->robot.upper()[joint]);
  }
  if (!solver.solve(X_WF, impl_->options, false, answer)) return {};
  return answer;
}

}  // namespace graspless::robot
