// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of MoveIt's SRDF that a planner needs: groups, group states, disabled collisions.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include <tinyxml.h>
#include <urdf_model/utils.h>

#include "graspless/watch.hpp"

#include "robot/model.hpp"
#include "robot/xml.hpp"
#include "text.hpp"

namespace graspless::robot {
namespace {

constexpr double kStateSlack = 1e-3;  // SRDF files hold limits rounded to a few digits [rad or m]

constexpr std::size_t kMaxGroupDepth = 100;  // of groups in groups, which are read by recursion

/// Reads an SRDF item by item. An item with a fault, for instance the name of a link that the URDF
/// does not have, is skipped with a warning: files that come with robots have many. Using a group
/// or state with a fault is an error.
class SrdfReader {
 public:
  SrdfReader(const TiXmlElement& root, Robot::Model& model) : root_(root), model_(model) {
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      links_.emplace(model.frame_names[i], static_cast<int>(i));
      if (i > 0) joints_.emplace(model.links[i].joint_name, static_cast<int>(i));
    }
  }

  void read() {
    for_each(root_, "virtual_joint",
             [&](const TiXmlElement& e) { virtual_joints_.insert(attribute(e, "name")); });
    for_each(root_, "group", [&](const TiXmlElement& e) { elements_[attribute(e, "name")] = &e; });
    for (const auto& [name, element] : elements_) {
      open_.clear();
      if (model_.group_faults.count(name) == 0) tolerate([&, e = element] { read_group(*e); });
    }
    for_each(root_, "group_state", [&](const TiXmlElement& e) { read_state(e); });
    Pairs disabled;
    for_each(root_, "disable_default_collisions",
             [&](const TiXmlElement& e) { add_all(link(e, "link"), disabled); });
    for_each(root_, "enable_collisions", [&](const TiXmlElement& e) { disabled.erase(pair(e)); });
    for_each(root_, "disable_collisions", [&](const TiXmlElement& e) { disabled.insert(pair(e)); });
    for (const auto& [a, b] : disabled)
      if (a != b) model_.ignored_pairs.emplace(a, b);
  }

 private:
  using Pair = std::pair<int, int>;  // of links, the smaller index first
  using Pairs = std::set<Pair>;

  /// Runs `function` on each child, and makes a warning of what it throws.
  template <typename Function>
  void for_each(const TiXmlElement& parent, const char* name, Function function) {
    for (auto* e = parent.FirstChildElement(name); e; e = e->NextSiblingElement(name)) {
      poll();
      tolerate([&] { function(*e); });
    }
  }

  template <typename Function>
  void tolerate(Function function) {
    try {
      function();
    } catch (const std::invalid_argument& error) {
      model_.warnings.push_back(std::string(error.what()) + "; skipped");
    }
  }

  /// Runs `function` on each child. What it throws is the fault of the item that they are part of.
  template <typename Function>
  static void for_parts(const TiXmlElement& parent, const char* name, Function function) {
    for (auto* e = parent.FirstChildElement(name); e; e = e->NextSiblingElement(name)) function(*e);
  }

  [[noreturn]] static void fail(const TiXmlElement& element, const std::string& message) {
    robot::fail(element, "SRDF", message);
  }

  static std::string attribute(const TiXmlElement& element, const char* name) {
    const char* value = element.Attribute(name);
    if (!value) fail(element, "<" + element.ValueStr() + "> has no attribute '" + name + "'");
    return value;
  }

  int link(const TiXmlElement& element, const char* name) const {
    const std::string link = attribute(element, name);
    const auto found = links_.find(link);
    if (found == links_.end()) fail(element, "the URDF has no link '" + link + "'");
    return found->second;
  }

  /// The link that the named joint carries; null for a virtual joint, which the URDF does not have.
  const Link* carried(const TiXmlElement& element) const {
    const std::string name = attribute(element, "name");
    const auto found = joints_.find(name);
    if (found != joints_.end()) return &model_.links[found->second];
    if (virtual_joints_.count(name) == 0) fail(element, "the URDF has no joint '" + name + "'");
    return nullptr;
  }

  /// Fixed and mimic joints are skipped: they have no value of their own.
  static bool has_value(const Link* link) { return link && link->joint >= 0 && !link->is_mimic; }

  static void add(const Link* link, std::set<int>& joints) {
    if (has_value(link)) joints.insert(link->joint);
  }

  void add_chain(const TiXmlElement& chain, std::set<int>& joints) const {
    const int base = link(chain, "base_link"), tip = link(chain, "tip_link");
    int i = tip;
    for (; i > 0 && i != base; i = model_.links[i].parent) add(&model_.links[i], joints);
    if (i == base) return;
    fail(chain, "chain: link '" + model_.frame_names[tip] + "' is not below link '" +
                    model_.frame_names[base] + "'");
  }

  const std::vector<int>& read_group(const TiXmlElement& group) {
    const std::string name = attribute(group, "name");
    const auto done = model_.groups.find(name);
    if (done != model_.groups.end()) return done->second;
    try {
      return model_.groups[name] = joints_of(group, name);
    } catch (const std::invalid_argument& error) {
      model_.group_faults.emplace(name, error.what());
      throw;
    }
  }

  std::vector<int> joints_of(const TiXmlElement& group, const std::string& name) {
    if (!open_.insert(name).second) fail(group, "group '" + name + "' contains itself");
    if (open_.size() > kMaxGroupDepth) {
      fail(group, "group '" + name + "' is contained in " + std::to_string(open_.size() - 1) +
                      " others, more than " + std::to_string(kMaxGroupDepth - 1));
    }
    std::set<int> joints;
    for_parts(group, "joint", [&](const TiXmlElement& e) { add(carried(e), joints); });
    for_parts(group, "link",
              [&](const TiXmlElement& e) { add(&model_.links[link(e, "name")], joints); });
    for_parts(group, "chain", [&](const TiXmlElement& e) { add_chain(e, joints); });
    for_parts(group, "group", [&](const TiXmlElement& e) {
      for (const int joint : inner_group(e)) joints.insert(joint);
    });
    open_.erase(name);
    return {joints.begin(), joints.end()};
  }

  const std::vector<int>& inner_group(const TiXmlElement& element) {
    const std::string name = attribute(element, "name");
    const auto fault = model_.group_faults.find(name);
    if (fault != model_.group_faults.end()) throw std::invalid_argument(fault->second);
    const auto found = elements_.find(name);
    if (found == elements_.end()) fail(element, "the SRDF has no group '" + name + "'");
    return read_group(*found->second);
  }

  double read_value(const TiXmlElement& element, int joint) {
    const std::string name = attribute(element, "name"), text = attribute(element, "value");
    double value = 0;
    try {
      value = urdf::strToDouble(text.c_str());  // the same under any locale
    } catch (const std::runtime_error&) {
      fail(element, "joint '" + name + "': '" + text + "' is not a number");
    }
    const double lower = model_.hard_lower[joint], upper = model_.hard_upper[joint];
    if (!(value >= lower - kStateSlack && value <= upper + kStateSlack)) {
      fail(element, "joint '" + name + "': " + text + " is outside its limits " + figure(lower) +
                        " to " + figure(upper));
    }
    const double kept = std::clamp(value, model_.lower[joint], model_.upper[joint]);
    if (std::abs(value - kept) > kStateSlack)
      model_.warnings.push_back("a state has joint '" + name + "' at " + text +
                                ", beyond its soft limit " + figure(kept) + ", which is used");
    return kept;
  }

  /// States of the same name are merged: an arm's "home" and a hand's "home" make the robot's.
  void read_state(const TiXmlElement& state) {
    const std::string name = attribute(state, "name");
    const Eigen::VectorXd rest =
        Eigen::VectorXd::Zero(model_.lower.size()).cwiseMax(model_.lower).cwiseMin(model_.upper);
    Eigen::VectorXd& q = model_.states.emplace(name, rest).first->second;
    try {
      const char* group = state.Attribute("group");
      if (group && elements_.count(group) == 0) {
        fail(state, "the SRDF has no group '" + std::string(group) + "'");
      }
      std::set<int>& named = model_.state_joints[name];
      for_parts(state, "joint", [&](const TiXmlElement& e) { set_joint(e, q, named); });
    } catch (const std::invalid_argument& error) {
      model_.state_faults.emplace(name, error.what());
      throw;
    }
  }

  void set_joint(const TiXmlElement& element, Eigen::VectorXd& q, std::set<int>& named) {
    if (is_base(element)) return;
    const Link* link = carried(element);
    if (!has_value(link)) return;
    q[link->joint] = read_value(element, link->joint);
    named.insert(link->joint);
  }

  /// True for an unknown joint with several values: the base of a robot that is taken to float.
  bool is_base(const TiXmlElement& element) {
    const std::string name = attribute(element, "name"), text = attribute(element, "value");
    std::istringstream words(text);
    std::string word;
    if (joints_.count(name) > 0 || !(words >> word >> word)) return false;
    tolerate([&] { fail(element, "joint '" + name + "' is not in the URDF"); });
    return true;
  }

  Pair pair(const TiXmlElement& element) const {
    return std::minmax({link(element, "link1"), link(element, "link2")});
  }

  void add_all(int one, Pairs& pairs) const {
    for (int other = 0; other < static_cast<int>(model_.links.size()); ++other)
      pairs.insert(std::minmax({one, other}));
  }

  const TiXmlElement& root_;
  Robot::Model& model_;
  std::unordered_map<std::string, int> links_, joints_;  // index of a link, and of the one carried
  std::set<std::string> virtual_joints_;
  std::map<std::string, const TiXmlElement*> elements_;
  std::set<std::string> open_;  // groups being read, to detect one that contains itself
};

}  // namespace

void read_srdf(const std::string& xml, Robot::Model& model) {
  TiXmlDocument document;
  parse_xml(xml, "SRDF", document);
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (!robot) throw std::invalid_argument("SRDF: there is no <robot> element");
  SrdfReader(*robot, model).read();
  for (const auto& [name, fault] : model.state_faults) model.states.erase(name);
}

}  // namespace graspless::robot
