// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of MoveIt's SRDF that a planner needs: groups, group states, disabled collisions.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <tinyxml.h>
#include <urdf_model/utils.h>

#include "robot/model.hpp"
#include "robot/names.hpp"
#include "robot/xml_depth.hpp"

namespace graspless::robot {
namespace {

constexpr double kStateSlack = 1e-3;  // SRDF files hold limits rounded to a few digits [rad or m]

constexpr std::size_t kMaxGroupDepth = 100;  // of groups in groups, which are read by recursion

class SrdfReader {
 public:
  SrdfReader(const TiXmlElement& root, Robot::Model& model) : root_(root), model_(model) {}

  void read() {
    for_each(root_, "group", [&](const TiXmlElement& e) { elements_[attribute(e, "name")] = &e; });
    for (const auto& [name, element] : elements_) read_group(name, *element);
    for_each(root_, "group_state", [&](const TiXmlElement& e) { read_state(e); });
    for_each(root_, "disable_collisions", [&](const TiXmlElement& e) { disable(e); });
  }

 private:
  template <typename Function>
  static void for_each(const TiXmlElement& parent, const char* name, Function function) {
    for (auto* e = parent.FirstChildElement(name); e; e = e->NextSiblingElement(name)) function(*e);
  }

  [[noreturn]] static void fail(const TiXmlElement& element, const std::string& message) {
    throw std::invalid_argument("SRDF line " + std::to_string(element.Row()) + ": " + message);
  }

  static std::string attribute(const TiXmlElement& element, const char* name) {
    const char* value = element.Attribute(name);
    if (!value) fail(element, "<" + element.ValueStr() + "> has no attribute '" + name + "'");
    return value;
  }

  /// Runs a look-up and adds the line number to what it throws.
  template <typename Function>
  static auto located(const TiXmlElement& element, Function function) {
    try {
      return function();
    } catch (const std::invalid_argument& error) {
      fail(element, error.what());
    }
  }

  int link(const TiXmlElement& element, const char* name) const {
    const std::string link = attribute(element, name);
    return located(element, [&] { return index_of(link, model_.frame_names, "link"); });
  }

  /// The link that the named joint of the URDF carries.
  const Link& carried(const TiXmlElement& element) const {
    const std::string name = attribute(element, "name");
    std::vector<std::string> names;
    for (std::size_t i = 1; i < model_.links.size(); ++i)
      names.push_back(model_.links[i].joint_name);
    const int i = located(element, [&] { return index_of(name, names, "joint"); });
    return model_.links[static_cast<std::size_t>(i) + 1];
  }

  /// Fixed and mimic joints are skipped: they have no value of their own.
  static void add(const Link& link, std::set<int>& joints) {
    if (link.joint >= 0 && !link.is_mimic) joints.insert(link.joint);
  }

  void add_chain(const TiXmlElement& chain, std::set<int>& joints) const {
    const int base = link(chain, "base_link"), tip = link(chain, "tip_link");
    int i = tip;
    for (; i > 0 && i != base; i = model_.links[i].parent) add(model_.links[i], joints);
    if (i == base) return;
    fail(chain, "chain: link '" + model_.frame_names[tip] + "' is not below link '" +
                    model_.frame_names[base] + "'");
  }

  const std::vector<int>& read_group(const std::string& name, const TiXmlElement& group) {
    const auto done = model_.groups.find(name);
    if (done != model_.groups.end()) return done->second;
    if (!open_.insert(name).second) fail(group, "group '" + name + "' contains itself");
    if (open_.size() > kMaxGroupDepth) {
      fail(group, "group '" + name + "' is contained in " + std::to_string(open_.size() - 1) +
                      " others, more than " + std::to_string(kMaxGroupDepth - 1));
    }
    std::set<int> joints;
    for_each(group, "joint", [&](const TiXmlElement& e) { add(carried(e), joints); });
    for_each(group, "link",
             [&](const TiXmlElement& e) { add(model_.links[link(e, "name")], joints); });
    for_each(group, "chain", [&](const TiXmlElement& e) { add_chain(e, joints); });
    for_each(group, "group", [&](const TiXmlElement& e) {
      const std::string inner = attribute(e, "name");
      const auto* element = located(e, [&] { return at(elements_, inner, "group"); });
      for (const int joint : read_group(inner, *element)) joints.insert(joint);
    });
    open_.erase(name);
    return model_.groups[name] = std::vector<int>(joints.begin(), joints.end());
  }

  double read_value(const TiXmlElement& element, int joint) const {
    const std::string name = attribute(element, "name"), text = attribute(element, "value");
    double value = 0;
    try {
      value = urdf::strToDouble(text.c_str());  // the same under any locale
    } catch (const std::runtime_error&) {
      fail(element, "joint '" + name + "': '" + text + "' is not a number");
    }
    const double lower = model_.lower[joint], upper = model_.upper[joint];
    if (!(value >= lower - kStateSlack && value <= upper + kStateSlack)) {
      fail(element, "joint '" + name + "': " + text + " is outside its limits " +
                        std::to_string(lower) + " to " + std::to_string(upper));
    }
    return std::clamp(value, lower, upper);
  }

  /// States of the same name are merged: an arm's "home" and a hand's "home" make the robot's.
  void read_state(const TiXmlElement& state) {
    const std::string group = attribute(state, "group");
    located(state, [&] { return at(model_.groups, group, "group"); });
    const Eigen::VectorXd rest =
        Eigen::VectorXd::Zero(model_.lower.size()).cwiseMax(model_.lower).cwiseMin(model_.upper);
    Eigen::VectorXd& q = model_.states.emplace(attribute(state, "name"), rest).first->second;
    for_each(state, "joint", [&](const TiXmlElement& e) {
      const Link& link = carried(e);
      if (link.joint >= 0 && !link.is_mimic) q[link.joint] = read_value(e, link.joint);
    });
  }

  void disable(const TiXmlElement& element) {
    const int a = link(element, "link1"), b = link(element, "link2");
    if (a != b) model_.ignored_pairs.emplace(std::min(a, b), std::max(a, b));
  }

  const TiXmlElement& root_;
  Robot::Model& model_;
  std::map<std::string, const TiXmlElement*> elements_;
  std::set<std::string> open_;  // groups being read, to detect one that contains itself
};

}  // namespace

void read_srdf(const std::string& xml, Robot::Model& model) {
  require_shallow(xml, "SRDF");
  TiXmlDocument document;
  document.Parse(xml.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    throw std::invalid_argument("SRDF line " + std::to_string(document.ErrorRow()) +
                                ": not XML: " + document.ErrorDesc());
  }
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (!robot) throw std::invalid_argument("SRDF: there is no <robot> element");
  SrdfReader(*robot, model).read();
}

}  // namespace graspless::robot
