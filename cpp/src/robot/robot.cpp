// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/robot.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/robot/description.hpp"

#include "geometry/read_text.hpp"
#include "robot/model.hpp"
#include "robot/names.hpp"
#include "text.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Turns columns of X: X * Rot(angle) about a coordinate axis.
void turn(int axis, double angle, Isometry3d& X) {
  const double c = std::cos(angle), s = std::sin(angle);
  auto u = X.matrix().col((axis + 1) % 3), v = X.matrix().col((axis + 2) % 3);
  const Eigen::Vector4d before = u;
  u = c * before + s * v;
  v = c * v - s * before;
}

void check_size(const VectorXd& q, const Robot::Model& model) {
  if (q.size() == model.lower.size()) return;
  throw std::invalid_argument("q must have " + std::to_string(model.lower.size()) +
                              " values, one for each independent joint, not " +
                              std::to_string(q.size()));
}

void check_frame(int frame, const Robot::Model& model) {
  if (frame >= 0 && frame < static_cast<int>(model.links.size())) return;
  throw std::invalid_argument("frame must be in [0, " + std::to_string(model.links.size()) +
                              "), not " + std::to_string(frame));
}

void require_sound(const std::map<std::string, std::string>& faults, const std::string& name,
                   const std::string& what) {
  const auto fault = faults.find(name);
  if (fault == faults.end()) return;
  throw std::invalid_argument(what + " '" + name + "' cannot be used: " + fault->second);
}

bool exists(const std::string& path) { return std::ifstream(path).good(); }

}  // namespace

// Works on columns of 4 x 4 matrices, which fill whole vector registers.
void place(const Link& link, const VectorXd& q, const Isometry3d& X_WP, Isometry3d& X_WL) {
  const auto& P = X_WP.matrix();
  const auto& J = link.X_PJ.matrix();
  auto& L = X_WL.matrix();
  const auto in_world = [&](int j) {
    return P.col(0) * J(0, j) + P.col(1) * J(1, j) + P.col(2) * J(2, j);
  };
  if (link.is_parent_turned) {
    for (int j = 0; j < 3; ++j) L.col(j) = in_world(j);
  } else {
    L.leftCols<3>() = P.leftCols<3>();
  }
  L.col(3) = in_world(3) + P.col(3);
  if (link.joint < 0) return;
  const double value = link.sign * (link.multiplier * q[link.joint] + link.offset);
  if (link.prismatic) {
    L.col(3) += value * L.col(link.axis);
  } else {
    turn(link.axis, value, X_WL);
  }
  if (link.is_axis_turned) X_WL.linear() = X_WL.linear() * link.R_JL;
}

Robot Robot::from_urdf(const std::string& xml, const Options& options) {
  geometry::require_pose(options.X_WB, "X_WB");
  auto model = std::make_shared<Model>(read_urdf(xml, options));
  model->urdf = xml;
  model->options = options;
  model->ignored_pairs = neighbours(*model);
  model->reach = reach_bounds(*model);
  if (!options.srdf.empty()) read_srdf(options.srdf, *model);
  return Robot(std::move(model));
}

Robot Robot::from_urdf_file(const std::string& path, Options options) {
  const std::string xml = geometry::read_text(path);
  const std::filesystem::path file(path), folder = file.parent_path();
  if (options.directory.empty()) options.directory = folder.empty() ? "." : folder.string();
  const std::string srdf = std::filesystem::path(file).replace_extension(".srdf").string();
  if (options.srdf.empty() && exists(srdf)) options.srdf = geometry::read_text(srdf);
  try {
    options.packages = find_packages({xml, options.srdf, options.packages, options.directory});
    return from_urdf(xml, options);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

Robot Robot::from_urdf_file(const std::string& path) { return from_urdf_file(path, Options{}); }

const std::string& Robot::name() const { return model_->name; }

const std::string& Robot::urdf() const { return model_->urdf; }

const Robot::Options& Robot::options() const { return model_->options; }
int Robot::dof() const { return static_cast<int>(model_->joint_names.size()); }
const std::vector<std::string>& Robot::joint_names() const { return model_->joint_names; }
const VectorXd& Robot::lower() const { return model_->lower; }
const VectorXd& Robot::upper() const { return model_->upper; }
const VectorXd& Robot::max_velocity() const { return model_->max_velocity; }
const VectorXd& Robot::max_effort() const { return model_->max_effort; }
const VectorXd& Robot::step_weights() const { return model_->step_weights; }
const Isometry3d& Robot::X_WB() const { return model_->X_WB; }
const std::vector<std::string>& Robot::frame_names() const { return model_->frame_names; }
const std::vector<LinkShape>& Robot::shapes() const { return model_->shapes; }
const std::set<std::pair<int, int>>& Robot::ignored_pairs() const { return model_->ignored_pairs; }
std::vector<std::string> Robot::group_names() const { return keys(model_->groups); }
std::vector<std::string> Robot::state_names() const { return keys(model_->states); }

int Robot::frame(const std::string& link) const {
  return index_of(link, model_->frame_names, "link");
}

int Robot::parent(int frame) const {
  check_frame(frame, *model_);
  return model_->links[frame].parent;
}

int Robot::joint(const std::string& name) const {
  return index_of(name, model_->joint_names, "joint");
}

const std::vector<std::string>& Robot::warnings() const { return model_->warnings; }

const std::vector<int>& Robot::group(const std::string& name) const {
  require_sound(model_->group_faults, name, "group");
  return at(model_->groups, name, "group");
}

const VectorXd& Robot::state(const std::string& name) const {
  require_sound(model_->state_faults, name, "state");
  return at(model_->states, name, "state");
}

VectorXd Robot::state(const std::string& name, const VectorXd& others) const {
  const VectorXd& state = this->state(name);
  require_configuration(*this, others, "others");
  VectorXd q = others;
  for (const int joint : model_->state_joints.at(name)) q[joint] = state[joint];
  return q;
}

const VectorXd& Robot::reach(int link) const {
  check_frame(link, *model_);
  return model_->reach[link];
}

void Robot::forward(const VectorXd& q, Poses& X_WL) const {
  check_size(q, *model_);
  const std::vector<Link>& links = model_->links;
  X_WL.resize(links.size());
  X_WL[0] = model_->X_WB;
  for (std::size_t i = 1; i < links.size(); ++i) place(links[i], q, X_WL[links[i].parent], X_WL[i]);
}

void Robot::forward_to(int frame, const VectorXd& q, Poses& X_WL) const {
  check_size(q, *model_);
  check_frame(frame, *model_);
  const std::vector<Link>& links = model_->links;
  X_WL.resize(links.size());
  X_WL[0] = model_->X_WB;
  for (const int i : model_->paths[frame]) place(links[i], q, X_WL[links[i].parent], X_WL[i]);
}

Isometry3d Robot::pose(int frame, const VectorXd& q) const {
  check_size(q, *model_);
  check_frame(frame, *model_);
  Isometry3d X_WP = model_->X_WB, X_WL = X_WP;
  for (const int i : model_->paths[frame]) {
    place(model_->links[i], q, X_WP, X_WL);
    X_WP = X_WL;
  }
  return X_WL;
}

void Robot::jacobian(int frame, const Poses& X_WL,
                     Eigen::Matrix<double, 6, Eigen::Dynamic>& J) const {
  check_frame(frame, *model_);
  if (X_WL.size() != model_->links.size()) {
    throw std::invalid_argument("X_WL must come from forward() or forward_to() of this robot");
  }
  J.setZero(6, dof());
  const Vector3d p_WF = X_WL[frame].translation();
  for (const int i : model_->movers[frame]) {
    const Link& link = model_->links[i];
    const Vector3d axis_W = X_WL[i].linear() * (link.multiplier * link.axis_L);
    auto column = J.col(link.joint);  // summed: several joints may mimic one
    if (link.prismatic) {
      column.head<3>() += axis_W;
    } else {
      column.head<3>() += axis_W.cross(p_WF - X_WL[i].translation());
      column.tail<3>() += axis_W;
    }
  }
}

Eigen::Matrix<double, 6, Eigen::Dynamic> Robot::jacobian(int frame, const VectorXd& q) const {
  Poses X_WL;
  forward_to(frame, q, X_WL);
  Eigen::Matrix<double, 6, Eigen::Dynamic> J;
  jacobian(frame, X_WL, J);
  return J;
}

double Robot::step(const VectorXd& q1, const VectorXd& q2) const {
  check_size(q1, *model_);
  check_size(q2, *model_);
  return (q2 - q1).cwiseProduct(model_->step_weights).lpNorm<Eigen::Infinity>();
}

VectorXd Robot::clamp(const VectorXd& q) const {
  check_size(q, *model_);
  return q.cwiseMax(model_->lower).cwiseMin(model_->upper);
}

bool Robot::is_within(const VectorXd& q, double tolerance) const {
  check_size(q, *model_);
  return (q.array() >= model_->lower.array() - tolerance).all() &&
         (q.array() <= model_->upper.array() + tolerance).all();
}

void require_configuration(const Robot& robot, const VectorXd& q, const std::string& field) {
  if (q.size() != robot.dof()) {
    throw std::invalid_argument(field + " has " + std::to_string(q.size()) + " values for " +
                                std::to_string(robot.dof()) + " joints");
  }
  for (int i = 0; i < robot.dof(); ++i) {
    constexpr int kDigits = 9;  // limits are exceeded by little
    if (q[i] >= robot.lower()[i] - 1e-9 && q[i] <= robot.upper()[i] + 1e-9) continue;
    throw std::invalid_argument(
        field + ": joint '" + robot.joint_names()[i] + "' is " + figure(q[i], kDigits) +
        ", outside its limits [" + figure(robot.lower()[i], kDigits) + ", " +
        figure(robot.upper()[i], kDigits) + "] " + (robot.step_weights()[i] > 1 ? "m" : "rad"));
  }
}

bool is_configuration(const Robot& robot, const VectorXd& q) {
  constexpr double kFar = 1000;  // keeps links within geometry::kMaxLength [m]
  if (q.size() != robot.dof() || !q.allFinite()) return false;
  const auto slides = robot.step_weights().array() > 1;
  return (!slides || q.array().abs() <= kFar).all();
}

}  // namespace graspless::robot
