// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/urdf/tree.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <tinyxml.h>
#include <urdf_model/utils.h>

#include "robot/urdf/capsules.hpp"
#include "robot/xml.hpp"

namespace graspless::robot {
namespace {

// Tables of a robot grow with the product of both. urdfdom recurses once a link of a chain.
constexpr std::size_t kMaxLinks = 10000;
constexpr int kMaxChain = 1000;
constexpr std::size_t kMostNamed = 5;  // links or joints in one warning

struct Edge {
  std::string joint, parent, child;
};

[[noreturn]] void fail(const TiXmlElement& element, const std::string& message) {
  robot::fail(element, "URDF", message);
}

std::string attribute(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  if (!value || !*value) {
    fail(element, "<" + element.ValueStr() + "> has no attribute '" + name + "'");
  }
  return value;
}

/// The attribute 'link' of the joint's <parent> or <child>, which must be one of the links.
std::string link_of(const TiXmlElement& joint, const char* role,
                    const std::set<std::string>& links) {
  const TiXmlElement* element = joint.FirstChildElement(role);
  const std::string where = "joint '" + attribute(joint, "name") + "'";
  if (!element) fail(joint, where + " has no <" + role + ">");
  const std::string link = attribute(*element, "link");
  if (links.count(link) == 0)
    fail(*element, where + ": its " + role + " '" + link + "' is not a link of the robot");
  return link;
}

void check_limit(const TiXmlElement& joint, const std::string& type) {
  if (type != "revolute" && type != "prismatic") return;
  const TiXmlElement* limit = joint.FirstChildElement("limit");
  // urdfdom would read a missing bound as 0; a joint without both could not move.
  if (!limit || (!limit->Attribute("lower") && !limit->Attribute("upper"))) {
    fail(joint, type + " joint '" + attribute(joint, "name") +
                    "' has no limits; give <limit lower=... upper=... effort=... velocity=...>" +
                    (type == "revolute" ? " or make it continuous" : ""));
  }
}

/// Checks the types of joints. A floating or planar joint is accepted where it connects the root
/// alone, as many files of mobile robots write it; returns a warning about each.
std::vector<std::string> check_types(const TiXmlElement& robot, const std::string& root) {
  static const std::set<std::string> kTypes = {"revolute", "continuous", "prismatic", "fixed"};
  std::vector<std::string> warnings;
  for (auto* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
    const std::string type = attribute(*e, "type");
    const std::string what = "joint '" + attribute(*e, "name") + "' is of type '" + type + "'";
    if (kTypes.count(type) > 0) {
      check_limit(*e, type);
    } else if (type != "floating" && type != "planar") {
      fail(*e, what + "; choose from revolute, continuous, prismatic, fixed");
    } else if (e->FirstChildElement("parent")->Attribute("link") != root) {
      fail(*e, what +
                   ", which is possible at the root alone; choose from revolute, continuous, "
                   "prismatic, fixed");
    } else {
      warnings.push_back("URDF line " + std::to_string(e->Row()) + ": " + what +
                         "; treated as fixed");
    }
  }
  return warnings;
}

/// Writes `quantity="0"`, which stands for unknown, where a <limit> has none. The URDF
/// specification requires it, but no planner needs it. Returns a warning that names the joints;
/// empty if none lacks it.
std::string complete_limits(TiXmlElement& robot, const char* quantity) {
  std::string joints;
  for (auto* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
    TiXmlElement* limit = e->FirstChildElement("limit");
    if (!limit || limit->Attribute(quantity)) continue;
    limit->SetAttribute(quantity, "0");
    joints += (joints.empty() ? "'" : ", '") + attribute(*e, "name") + "'";
  }
  if (joints.empty()) return "";
  return std::string("URDF: <limit> without ") + quantity + ", which is taken as unknown: joints " +
         joints;
}

/// "'a', 'b' and 3 more" for a, b and so on.
std::string few_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i)
    text += (i > 0 ? ", '" : "'") + names[i] + "'";
  if (names.size() > kMostNamed)
    text += " and " + std::to_string(names.size() - kMostNamed) + " more";
  return text;
}

/// Returns a warning that names the links that are seen in pictures, but that planning does not
/// know; empty if there are none.
std::string invisible_links(const TiXmlElement& robot) {
  std::vector<std::string> links;
  for (auto* e = robot.FirstChildElement("link"); e; e = e->NextSiblingElement("link")) {
    if (e->FirstChildElement("visual") && !e->FirstChildElement("collision"))
      links.push_back(attribute(*e, "name"));
  }
  if (links.empty()) return "";
  return "URDF: links with a <visual> but no <collision>, which planning lets pass through "
         "everything: " +
         few_of(links) + "; give each a <collision>, or leave out its <visual>";
}

bool is_zero(const char* text) {
  try {
    return text && urdf::strToDouble(text) == 0;  // the same under any locale
  } catch (const std::runtime_error&) {
    return false;  // urdfdom refuses it
  }
}

/// Returns a warning that names the joints with a velocity limit of 0, which many files write for
/// "unknown"; empty if there are none. Limits of joints that mimic others, or do not move, are not
/// used.
std::string zero_velocities(const TiXmlElement& robot) {
  static const std::set<std::string> kMoving = {"revolute", "continuous", "prismatic"};
  std::vector<std::string> joints;
  for (auto* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
    const TiXmlElement* limit = e->FirstChildElement("limit");
    if (!limit || e->FirstChildElement("mimic") || kMoving.count(attribute(*e, "type")) == 0)
      continue;
    if (is_zero(limit->Attribute("velocity"))) joints.push_back(attribute(*e, "name"));
  }
  if (joints.empty()) return "";
  return "URDF: <limit> with velocity 0, which is taken as unknown; give the largest speed in "
         "rad/s or m/s: joints " +
         few_of(joints);
}

/// Removes each <inertial> that lacks the mass or the inertia, so that its link has neither.
/// Returns a warning that names the links; empty if none does.
std::string drop_partial_inertials(TiXmlElement& robot) {
  std::string links;
  for (auto* e = robot.FirstChildElement("link"); e; e = e->NextSiblingElement("link")) {
    TiXmlElement* inertial = e->FirstChildElement("inertial");
    if (!inertial) continue;
    if (inertial->FirstChildElement("mass") && inertial->FirstChildElement("inertia")) continue;
    e->RemoveChild(inertial);
    links += (links.empty() ? "'" : ", '") + attribute(*e, "name") + "'";
  }
  if (links.empty()) return "";
  return "URDF: <inertial> without mass or inertia, which planning ignores and simulation needs: "
         "links " +
         links;
}

std::set<std::string> declared_links(const TiXmlElement& robot) {
  std::set<std::string> links;
  for (auto* e = robot.FirstChildElement("link"); e; e = e->NextSiblingElement("link")) {
    const std::string name = attribute(*e, "name");
    if (!links.insert(name).second) fail(*e, "link '" + name + "' occurs twice");
  }
  if (links.empty()) fail(robot, "the robot has no links");
  if (links.size() > kMaxLinks) {
    fail(robot, "the robot has " + std::to_string(links.size()) + " links, more than " +
                    std::to_string(kMaxLinks));
  }
  return links;
}

std::vector<Edge> read_edges(const TiXmlElement& robot, const std::set<std::string>& links) {
  std::vector<Edge> edges;
  std::set<std::string> names;
  std::map<std::string, std::string> carrier;  // the joint that carries a link
  for (auto* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
    const Edge edge{attribute(*e, "name"), link_of(*e, "parent", links),
                    link_of(*e, "child", links)};
    if (!names.insert(edge.joint).second) fail(*e, "joint '" + edge.joint + "' occurs twice");
    const auto [other, is_first] = carrier.emplace(edge.child, edge.joint);
    if (!is_first) {
      fail(*e, "link '" + edge.child + "' has two parent joints, '" + other->second + "' and '" +
                   edge.joint + "': a closed chain, which is not supported; remove one of them");
    }
    edges.push_back(edge);
  }
  return edges;
}

std::string find_root(const TiXmlElement& robot, std::set<std::string> links,
                      const std::vector<Edge>& edges) {
  for (const Edge& edge : edges) links.erase(edge.child);
  if (links.empty()) fail(robot, "no link is the root: the joints form a cycle");
  if (links.size() > 1) {
    fail(robot, "there is more than one root link: '" + *links.begin() + "' and '" +
                    *std::next(links.begin()) + "'; connect them with a joint");
  }
  return *links.begin();
}

/// Appends the joints below `link`. Uses an explicit stack because a chain may be long.
std::vector<std::string> depth_first(const std::string& root, const std::vector<Edge>& edges) {
  std::multimap<std::string, const Edge*> below;  // keeps the order of the file among equals
  for (const Edge& edge : edges) below.emplace(edge.parent, &edge);
  std::vector<std::string> order;
  std::vector<const Edge*> stack;
  const auto push_children = [&](const std::string& link) {
    const auto [first, last] = below.equal_range(link);
    for (auto it = last; it != first;) stack.push_back((--it)->second);
  };
  push_children(root);
  while (!stack.empty()) {
    const Edge* edge = stack.back();
    stack.pop_back();
    order.push_back(edge->joint);
    push_children(edge->child);
  }
  return order;
}

/// Refuses chains of more than kMaxChain joints. `edges` in any order, `order` from the root on.
void check_chains(const TiXmlElement& robot, const std::vector<Edge>& edges,
                  const std::vector<std::string>& order) {
  std::map<std::string, const Edge*> by_joint;
  for (const Edge& edge : edges) by_joint.emplace(edge.joint, &edge);
  std::map<std::string, int> depth;  // of a link
  for (const std::string& joint : order) {
    const Edge& edge = *by_joint.at(joint);
    const int joints = depth[edge.child] = depth[edge.parent] + 1;
    if (joints > kMaxChain) {
      fail(robot, "link '" + edge.child + "' is " + std::to_string(joints) +
                      " joints away from the root, more than " + std::to_string(kMaxChain));
    }
  }
}

}  // namespace

UrdfTree read_urdf_tree(const std::string& xml) {
  TiXmlDocument document;
  parse_xml(xml, "URDF", document);
  TiXmlElement* robot = document.FirstChildElement("robot");
  if (!robot) throw std::invalid_argument("URDF: there is no <robot> element");
  const std::set<std::string> links = declared_links(*robot);
  const std::vector<Edge> edges = read_edges(*robot, links);
  UrdfTree tree;
  tree.root = find_root(*robot, links, edges);
  tree.joints = depth_first(tree.root, edges);
  // Every link has one parent and there is one root, so joints that were not reached form a cycle.
  if (tree.joints.size() < edges.size()) fail(*robot, "some of the joints form a cycle");
  check_chains(*robot, edges, tree.joints);
  tree.warnings = check_types(*robot, tree.root);
  if (const std::string warning = invisible_links(*robot); !warning.empty())
    tree.warnings.insert(tree.warnings.begin(), warning);  // the gravest; tasks print the first
  if (const std::string warning = zero_velocities(*robot); !warning.empty())
    tree.warnings.push_back(warning);
  bool is_changed = replace_capsules(*robot);
  for (const std::string& warning :
       {complete_limits(*robot, "effort"), complete_limits(*robot, "velocity"),
        drop_partial_inertials(*robot)}) {
    if (warning.empty()) continue;
    tree.warnings.push_back(warning);
    is_changed = true;
  }
  TiXmlPrinter printer;
  if (is_changed) document.Accept(&printer);
  tree.xml = is_changed ? printer.Str() : xml;
  return tree;
}

}  // namespace graspless::robot
