// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Converts a URDF to the tables of Robot::Model. Joints are always looked up by name: urdfdom keeps
// them in a map, where joint10 comes before joint2.
#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include "geometry/turn.hpp"
#include "robot/link_shapes.hpp"
#include "robot/model.hpp"
#include "robot/names.hpp"
#include "robot/urdf/tree.hpp"
#include "text.hpp"

namespace graspless::robot {
namespace {

using Eigen::Vector3d;

constexpr double kLimitSlack = 1e-3;  // URDF files hold limits rounded to a few digits [rad or m]

/// Collects urdfdom's messages while an instance lives. urdfdom reports errors on the console only,
/// and sometimes continues without the faulty element.
class Complaints : public console_bridge::OutputHandler {
 public:
  Complaints() : lock_(mutex()) { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    text_ += (text_.empty() ? "" : "; ") + text;
  }
  const std::string& text() const { return text_; }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;  // the handler is global to the process
    return instance;
  }
  std::lock_guard<std::mutex> lock_;
  std::string text_;
};

urdf::ModelInterfaceSharedPtr parse(const std::string& xml) {
  Complaints complaints;
  const urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDF(xml);
  if (!complaints.text().empty()) throw std::invalid_argument("URDF: " + complaints.text());
  if (!urdf) throw std::invalid_argument("URDF: urdfdom rejects it without a message");
  return urdf;
}

constexpr double kRadPerMeter = 10;  // Robot::step_weights() of prismatic joints

/// Floating and planar joints, which occur at the root alone, are treated as fixed.
bool is_movable(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS ||
         joint.type == urdf::Joint::PRISMATIC;
}
bool is_independent(const urdf::Joint& joint) { return is_movable(joint) && !joint.mimic; }

void check_finite(double value, const std::string& joint, const std::string& what) {
  if (std::isfinite(value)) return;
  throw std::invalid_argument("joint '" + joint + "': " + what + " must be finite, not " +
                              figure(value));
}

/// Lower and upper bound [rad or m].
std::pair<double, double> bounds(const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::CONTINUOUS) return {-M_PI, M_PI};
  const double lower = joint.limits->lower, upper = joint.limits->upper;
  check_finite(lower, joint.name, "lower");
  check_finite(upper, joint.name, "upper");
  if (lower > upper) {
    throw std::invalid_argument("joint '" + joint.name + "': lower " + figure(lower) +
                                " is above upper " + figure(upper));
  }
  return {lower, upper};
}

/// Soft limits of <safety_controller> within the bounds: controllers stop a joint there. Both are 0
/// in files that give only its gains.
std::pair<double, double> soft_bounds(const urdf::Joint& joint, std::pair<double, double> hard,
                                      Robot::Model& model) {
  if (!joint.safety || joint.type == urdf::Joint::CONTINUOUS) return hard;
  const double lower = joint.safety->soft_lower_limit, upper = joint.safety->soft_upper_limit;
  if (!(lower < upper)) return hard;
  if (lower < hard.second && upper > hard.first)
    return {std::max(lower, hard.first), std::min(upper, hard.second)};
  model.warnings.push_back("the soft limits of joint '" + joint.name +
                           "' are beyond its limits; ignored");
  return hard;
}

/// A limit of 0 means none: many files write it for "unknown". Warns of one below 0.
double positive_or_infinity(double value, const std::string& what, Robot::Model& model) {
  if (value > 0) return value;
  if (value < 0) model.warnings.push_back(what + " is " + figure(value) + ", taken for no limit");
  return std::numeric_limits<double>::infinity();
}

void read_limits(const std::vector<urdf::JointConstSharedPtr>& joints, Robot::Model& model) {
  const auto n = static_cast<Eigen::Index>(joints.size());
  for (auto* field : {&model.lower, &model.upper, &model.hard_lower, &model.hard_upper,
                      &model.max_velocity, &model.max_effort}) {
    field->setConstant(n, std::numeric_limits<double>::infinity());
  }
  model.step_weights.setOnes(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const urdf::Joint& joint = *joints[i];
    if (joint.type == urdf::Joint::PRISMATIC) model.step_weights(i) = kRadPerMeter;
    const auto hard = bounds(joint);
    std::tie(model.hard_lower(i), model.hard_upper(i)) = hard;
    std::tie(model.lower(i), model.upper(i)) = soft_bounds(joint, hard, model);
    if (!joint.limits) continue;
    const std::string of = " of joint '" + joint.name + "'";
    model.max_velocity(i) =
        positive_or_infinity(joint.limits->velocity, "the velocity limit" + of, model);
    model.max_effort(i) =
        positive_or_infinity(joint.limits->effort, "the effort limit" + of, model);
  }
}

/// The joint that drives another: value = multiplier * value of `joint` + offset. Resolves mimics
/// of mimics.
struct Source {
  std::string joint;
  double multiplier = 1;
  double offset = 0;
};

Source find_source(const urdf::ModelInterface& urdf, const urdf::Joint& joint) {
  Source source{joint.name};
  std::size_t steps = 0;
  for (const urdf::Joint* j = &joint; j->mimic;) {
    const urdf::JointMimic& mimic = *j->mimic;
    const auto target = urdf.joints_.find(mimic.joint_name);
    const std::string where = "joint '" + joint.name + "': mimicked joint";
    if (target == urdf.joints_.end()) throw_unknown(mimic.joint_name, keys(urdf.joints_), where);
    if (++steps > urdf.joints_.size()) {
      throw std::invalid_argument("joint '" + joint.name + "' mimics itself");
    }
    check_finite(mimic.multiplier, j->name, "mimic multiplier");
    check_finite(mimic.offset, j->name, "mimic offset");
    source.offset += source.multiplier * mimic.offset;
    source.multiplier *= mimic.multiplier;
    j = target->second.get();
    source.joint = j->name;
  }
  if (!is_movable(*urdf.joints_.at(source.joint))) {
    throw std::invalid_argument("joint '" + joint.name + "' mimics '" + source.joint +
                                "', which is fixed");
  }
  return source;
}

Vector3d unit_axis(const urdf::Joint& joint) {
  const Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  const double norm = axis.norm();
  if (!std::isfinite(norm) || norm < 1e-9) {
    throw std::invalid_argument("joint '" + joint.name + "': its axis must not be zero");
  }
  return axis / norm;
}

/// Returns the index of the coordinate axis that `axis` is parallel to, or -1.
int principal_axis(const Vector3d& axis) {
  for (int i = 0; i < 3; ++i) {
    if (axis.cwiseAbs() == Vector3d::Unit(i)) return i;
  }
  return -1;
}

/// Sets the axis of the joint. One that is no coordinate axis is turned onto z.
void set_motion(Link& link) {
  const int principal = principal_axis(link.axis_L);
  if (principal >= 0) {
    link.axis = principal;
    link.sign = link.axis_L[principal];
    return;
  }
  const Eigen::Matrix3d R_LZ = geometry::turn_from_z(link.axis_L).toRotationMatrix();
  link.X_PJ.linear() *= R_LZ;
  link.R_JL = R_LZ.transpose();
  link.is_axis_turned = true;
}

Link read_link(const urdf::ModelInterface& urdf, const urdf::Joint& joint,
               const Robot::Model& model) {
  Link link;
  link.parent = index_of(joint.parent_link_name, model.frame_names, "link");
  link.joint_name = joint.name;
  link.X_PJ = to_isometry(joint.parent_to_joint_origin_transform);
  if (!link.X_PJ.matrix().allFinite()) {
    throw std::invalid_argument("joint '" + joint.name + "': its origin is not finite");
  }
  if (!is_movable(joint)) return link;
  const Source source = find_source(urdf, joint);
  link.joint = index_of(source.joint, model.joint_names, "joint");
  link.is_mimic = joint.mimic != nullptr;
  link.prismatic = joint.type == urdf::Joint::PRISMATIC;
  link.multiplier = source.multiplier;
  link.offset = source.offset;
  link.axis_L = unit_axis(joint);
  set_motion(link);
  return link;
}

/// Warns of a mimic joint that leaves its own limits, which are ignored.
void compare_limits(const urdf::Joint& joint, const Link& link, Robot::Model& model) {
  if (!joint.mimic || !joint.limits || joint.type == urdf::Joint::CONTINUOUS) return;
  const double at_lower = link.multiplier * model.lower[link.joint] + link.offset;
  const double at_upper = link.multiplier * model.upper[link.joint] + link.offset;
  const auto [least, most] = std::minmax(at_lower, at_upper);
  if (least >= joint.limits->lower - kLimitSlack && most <= joint.limits->upper + kLimitSlack) {
    return;
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "joint '" << joint.name << "' mimics '" << joint.mimic->joint_name << "' and moves in ["
       << least << ", " << most << "], beyond its own limits [" << joint.limits->lower << ", "
       << joint.limits->upper << "]; these are ignored";
  model.warnings.push_back(text.str());
}

void read_joints(const urdf::ModelInterface& urdf, const UrdfTree& tree, Robot::Model& model) {
  std::vector<urdf::JointConstSharedPtr> independent;
  for (const std::string& name : tree.joints) {
    const urdf::JointConstSharedPtr joint = urdf.getJoint(name);
    if (!is_independent(*joint)) continue;
    independent.push_back(joint);
    model.joint_names.push_back(name);
  }
  read_limits(independent, model);
}

void read_links(const urdf::ModelInterface& urdf, const UrdfTree& tree, Robot::Model& model) {
  model.links.emplace_back();
  model.frame_names.push_back(tree.root);
  for (const std::string& name : tree.joints) {
    const urdf::JointConstSharedPtr joint = urdf.getJoint(name);
    Link& link = model.links.emplace_back(read_link(urdf, *joint, model));
    link.is_parent_turned = link.X_PJ.linear() != Eigen::Matrix3d::Identity();
    compare_limits(*joint, link, model);
    model.frame_names.push_back(joint->child_link_name);
  }
}

void make_paths(Robot::Model& model) {
  model.paths.resize(model.links.size());
  model.movers.resize(model.links.size());
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    model.paths[i] = model.paths[link.parent];
    model.movers[i] = model.movers[link.parent];
    model.paths[i].push_back(static_cast<int>(i));
    if (link.joint >= 0) model.movers[i].push_back(static_cast<int>(i));
  }
}

void read_shapes(const urdf::ModelInterface& urdf, const Robot::Options& options,
                 Robot::Model& model) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const urdf::LinkConstSharedPtr link = urdf.getLink(model.frame_names[i]);
    for (geometry::PlacedShape& placed : link_shapes(*link, options)) {
      model.shapes.push_back({static_cast<int>(i), std::move(placed)});
    }
  }
}

}  // namespace

Robot::Model read_urdf(const std::string& xml, const Robot::Options& options) {
  UrdfTree tree = read_urdf_tree(xml);
  const urdf::ModelInterfaceSharedPtr urdf = parse(tree.xml);
  Robot::Model model;
  model.warnings = std::move(tree.warnings);
  model.name = urdf->getName();
  model.X_WB = options.X_WB;
  read_joints(*urdf, tree, model);
  read_links(*urdf, tree, model);
  make_paths(model);
  read_shapes(*urdf, options, model);
  return model;
}

}  // namespace graspless::robot
