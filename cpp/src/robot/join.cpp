// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins the XML of two robots. Elements that graspless does not read, like transmissions, are kept.
#include <filesystem>
#include <functional>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include <tinyxml.h>

#include "graspless/geometry/pose.hpp"
#include "graspless/robot/description.hpp"

#include "robot/names.hpp"
#include "robot/urdf/tree.hpp"
#include "robot/xml.hpp"

namespace graspless::robot {
namespace {

using Names = std::set<std::string>;
using Renaming = std::map<std::string, std::string>;

const std::string kDefaultPrefix = "gripper_";

std::string attribute_or_empty(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

/// Names of the children of a kind.
Names names_of(const TiXmlElement& parent, const char* kind) {
  Names names;
  for (auto* e = parent.FirstChildElement(kind); e; e = e->NextSiblingElement(kind)) {
    names.insert(attribute_or_empty(*e, "name"));
  }
  return names;
}

/// New names of a gripper's elements of a kind that clash with the arm's, or of all of them.
Renaming rename(const TiXmlElement& arm, const TiXmlElement& gripper, const char* kind,
                const std::string& prefix) {
  const Names taken = names_of(arm, kind), own = names_of(gripper, kind);
  Renaming names;
  for (const std::string& name : own) {
    if (prefix.empty() && taken.count(name) == 0) continue;
    const std::string next = (prefix.empty() ? kDefaultPrefix : prefix) + name;
    if (taken.count(next) > 0 || (prefix.empty() && own.count(next) > 0)) {
      throw std::invalid_argument("prefix: " + std::string(kind) + " '" + next +
                                  "' occurs in both descriptions; give another prefix");
    }
    names.emplace(name, next);
  }
  return names;
}

void apply(const Renaming& names, TiXmlElement& element, const char* attribute) {
  const auto found = names.find(attribute_or_empty(element, attribute));
  if (found != names.end()) element.SetAttribute(attribute, found->second.c_str());
}

void for_all(TiXmlElement& root, const std::function<void(TiXmlElement&)>& use) {
  for (auto* e = root.FirstChildElement(); e; e = e->NextSiblingElement()) {
    use(*e);
    for_all(*e, use);
  }
}

void append_children(const TiXmlElement& from, TiXmlElement& to) {
  for (auto* e = from.FirstChildElement(); e; e = e->NextSiblingElement()) to.InsertEndChild(*e);
}

std::string printed(const TiXmlElement& robot) {
  TiXmlPrinter printer;
  printer.SetIndent("  ");
  robot.Accept(&printer);
  return "<?xml version=\"1.0\"?>\n" + printer.Str();
}

/// One of the two descriptions.
struct Side {
  const Description* description;
  UrdfTree tree;
  TiXmlDocument urdf, srdf;
  TiXmlElement no_srdf{"robot"};

  TiXmlElement& robot() { return *urdf.FirstChildElement("robot"); }
  TiXmlElement& semantics() {
    TiXmlElement* robot = srdf.FirstChildElement("robot");
    return robot ? *robot : no_srdf;
  }
};

/// Makes the paths of meshes absolute; leaves those of packages that were not found.
void resolve_meshes(const Description& description, TiXmlElement& robot) {
  Description found = description;
  found.packages = find_packages(description);
  for_all(robot, [&](TiXmlElement& e) {
    const std::string name = attribute_or_empty(e, "filename");
    if (e.ValueStr() != "mesh" || name.empty()) return;
    try {
      const std::filesystem::path path = std::filesystem::absolute(mesh_path(name, found));
      e.SetAttribute("filename", ("file://" + path.lexically_normal().string()).c_str());
    } catch (const std::invalid_argument&) {
    }
  });
}

void read_side(const Description& description, const std::string& what, Side& side) {
  try {
    side.description = &description;
    side.tree = read_urdf_tree(description.urdf);
    parse_xml(description.urdf, "URDF", side.urdf);
    if (!description.srdf.empty()) parse_xml(description.srdf, "SRDF", side.srdf);
    resolve_meshes(description, side.robot());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(what + ": " + error.what());
  }
}

/// New names of everything in the gripper.
struct Renamings {
  Renaming links, joints, materials, groups;
};

void rename_urdf(const Renamings& names, TiXmlElement& gripper) {
  for_all(gripper, [&](TiXmlElement& e) {
    const std::string& tag = e.ValueStr();
    if (tag == "link") apply(names.links, e, "name");
    if (tag == "joint") apply(names.joints, e, "name");
    if (tag == "parent" || tag == "child") apply(names.links, e, "link");
    if (tag == "mimic") apply(names.joints, e, "joint");
    if (tag == "material") apply(names.materials, e, "name");
    if (tag != "gazebo") return;
    const bool is_link = names.links.count(attribute_or_empty(e, "reference")) > 0;
    apply(is_link ? names.links : names.joints, e, "reference");
  });
}

void rename_srdf(const Renamings& names, TiXmlElement& gripper) {
  for_all(gripper, [&](TiXmlElement& e) {
    const std::string& tag = e.ValueStr();
    if (tag == "link") apply(names.links, e, "name");
    if (tag == "joint" || tag == "passive_joint") apply(names.joints, e, "name");
    if (tag == "group") apply(names.groups, e, "name");
    for (const char* link :
         {"base_link", "tip_link", "link1", "link2", "parent_link", "child_link"}) {
      apply(names.links, e, link);
    }
    if (tag == "disable_default_collisions") apply(names.links, e, "link");
    for (const char* group : {"group", "parent_group"}) apply(names.groups, e, group);
  });
}

/// Fixes floating and planar joints of the gripper: they are allowed at the root alone.
void weld(TiXmlElement& gripper) {
  for (auto* e = gripper.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
    const std::string type = attribute_or_empty(*e, "type");
    if (type == "floating" || type == "planar") e->SetAttribute("type", "fixed");
  }
}

std::string text_of(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << v[0] << ' ' << v[1] << ' '
       << v[2];
  return text.str();
}

/// Roll, pitch and yaw as URDF has them: about the fixed axes X, Y, Z [rad].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& R) {
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  if (std::hypot(R(0, 0), R(1, 0)) < 1e-9) return {std::atan2(-R(1, 2), R(1, 1)), pitch, 0};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

void append_mount(const Mount& mount, const std::string& root, TiXmlElement& robot) {
  std::string name = "gripper_mount";
  for (const Names taken = names_of(robot, "joint"); taken.count(name) > 0;) name += '_';
  TiXmlElement joint("joint"), parent("parent"), child("child"), origin("origin");
  joint.SetAttribute("name", name.c_str());
  joint.SetAttribute("type", "fixed");
  parent.SetAttribute("link", mount.link.c_str());
  child.SetAttribute("link", root.c_str());
  origin.SetAttribute("xyz", text_of(mount.X_MG.translation()).c_str());
  origin.SetAttribute("rpy", text_of(roll_pitch_yaw(mount.X_MG.linear())).c_str());
  for (const TiXmlElement* part : {&parent, &child, &origin}) joint.InsertEndChild(*part);
  robot.InsertEndChild(joint);
}

/// Reduces the gripper to a link and all that it carries.
void keep_below(const std::string& root, Side& gripper) {
  TiXmlElement& robot = gripper.robot();
  const Names links = names_of(robot, "link");
  if (links.count(root) == 0) throw_unknown(root, {links.begin(), links.end()}, "root");
  Names kept{root};
  for (const std::string& name : gripper.tree.joints) {  // depth first: parents come before
    for (auto* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
      if (attribute_or_empty(*e, "name") != name) continue;
      const std::string parent = attribute_or_empty(*e->FirstChildElement("parent"), "link");
      if (kept.count(parent) > 0)
        kept.insert(attribute_or_empty(*e->FirstChildElement("child"), "link"));
    }
  }
  const auto is_kept = [&](const TiXmlElement& e) {
    if (e.ValueStr() == "link") return kept.count(attribute_or_empty(e, "name")) > 0;
    if (e.ValueStr() != "joint") return e.ValueStr() == "material";
    return kept.count(attribute_or_empty(*e.FirstChildElement("parent"), "link")) > 0;
  };
  for (TiXmlElement* e = robot.FirstChildElement(); e;) {
    TiXmlElement* next = e->NextSiblingElement();
    if (!is_kept(*e)) robot.RemoveChild(e);
    e = next;
  }
  gripper.tree.root = root;
  gripper.srdf.Clear();
}

void check_mount(const Mount& mount, TiXmlElement& arm) {
  geometry::require_pose(mount.X_MG, "mount.X_MG");
  const Names links = names_of(arm, "link");
  if (links.count(mount.link) > 0) return;
  throw_unknown(mount.link, {links.begin(), links.end()}, "mount");
}

/// Declares the namespaces of one element in another one, whose own stay.
void copy_namespaces(const TiXmlElement& from, TiXmlElement& to) {
  for (const TiXmlAttribute* each = from.FirstAttribute(); each; each = each->Next()) {
    const std::string name = each->Name();
    if (name.rfind("xmlns", 0) == 0 && !to.Attribute(each->Name()))
      to.SetAttribute(each->Name(), each->Value());
  }
}

}  // namespace

Description join(const Description& arm, const Description& gripper, const Mount& mount) {
  Side a, g;
  read_side(arm, "arm", a);
  read_side(gripper, "gripper", g);
  check_mount(mount, a.robot());
  if (!mount.root.empty()) keep_below(mount.root, g);
  const auto renamed = [&](const char* kind) {
    return rename(a.robot(), g.robot(), kind, mount.prefix);
  };
  const Renamings names{renamed("link"), renamed("joint"), renamed("material"),
                        rename(a.semantics(), g.semantics(), "group", mount.prefix)};
  rename_urdf(names, g.robot());
  rename_srdf(names, g.semantics());
  weld(g.robot());

  TiXmlElement& robot = a.robot();
  TiXmlElement& semantics = a.semantics();
  const std::string name =
      attribute_or_empty(robot, "name") + "_" + attribute_or_empty(g.robot(), "name");
  robot.SetAttribute("name", name.c_str());
  semantics.SetAttribute("name", name.c_str());
  copy_namespaces(g.robot(), robot);
  const auto root = names.links.find(g.tree.root);
  append_children(g.robot(), robot);
  append_mount(mount, root == names.links.end() ? g.tree.root : root->second, robot);
  append_children(g.semantics(), semantics);

  Description joined{printed(robot), "", arm.packages, ""};
  if (!arm.srdf.empty() || g.srdf.FirstChildElement("robot")) joined.srdf = printed(semantics);
  joined.packages.insert(gripper.packages.begin(), gripper.packages.end());
  return joined;
}

}  // namespace graspless::robot
