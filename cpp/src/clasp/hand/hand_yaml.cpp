// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads the description of a hand from YAML. validate() checks it against the robot.
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "graspless/clasp/hand.hpp"

#include "geometry/read_text.hpp"
#include "geometry/words.hpp"

namespace graspless::clasp {
namespace {

const std::vector<std::string> kFields{"arm",  "hand",   "frame",   "forward", "sideways",
                                       "open", "closed", "fingers", "thumb"};

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

class HandReader {
 public:
  explicit HandReader(const std::string& what) : what_(what) {}

  Hand read(const std::string& text) const {
    const YAML::Node root = parse(text);
    check_keys(root, "a hand", kFields);
    for (const char* field : {"frame", "forward", "sideways", "fingers", "thumb"}) {
      if (!root[field]) fail(root, std::string("a hand needs '") + field + "'");
    }
    Hand hand;
    read_name(root, "arm", hand.arm);
    read_name(root, "hand", hand.hand);
    read_name(root, "frame", hand.frame);
    read_pre_shapes(root, hand);
    read_name(root, "closed", hand.closed);
    hand.forward_H = read_direction(root["forward"], "forward");
    hand.sideways_H = read_direction(root["sideways"], "sideways");
    hand.fingers = read_fingers(root["fingers"]);
    hand.thumb = read_finger(root["thumb"], "thumb", "thumb");
    return hand;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw std::invalid_argument(what_ + ":" + std::to_string(line) + ": " + message);
  }

  [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const {
    fail(node.Mark().line + 1, message);
  }

  YAML::Node parse(const std::string& text) const {
    try {
      return YAML::Load(text);
    } catch (const YAML::ParserException& error) {
      fail(error.mark.line + 1, "not YAML: " + error.msg);
    }
  }

  /// Requires a mapping with unique keys from `allowed`. An empty `allowed` permits any key.
  void check_keys(const YAML::Node& node, const std::string& owner,
                  const std::vector<std::string>& allowed) const {
    if (!node.IsMap()) fail(node, owner + " must be a mapping of names to values");
    std::set<std::string> seen;
    for (const auto& entry : node) {
      if (!entry.first.IsScalar()) fail(entry.first, "a key of " + owner + " must be a word");
      const std::string key = entry.first.Scalar();
      if (!seen.insert(key).second) fail(entry.first, owner + " has '" + key + "' twice");
      bool known = allowed.empty();
      for (const std::string& name : allowed) known = known || name == key;
      if (known) continue;
      fail(entry.first, "unknown key '" + key + "' of " + owner + "; choose from " + join(allowed));
    }
  }

  void read_name(const YAML::Node& owner, const std::string& field, std::string& name) const {
    const YAML::Node node = owner[field];
    if (!node) return;
    if (!node.IsScalar() || node.Scalar().empty()) fail(node, field + " must be a name");
    name = node.Scalar();
  }

  /// Reads one pre-shape, or a list of them.
  void read_pre_shapes(const YAML::Node& root, Hand& hand) const {
    const YAML::Node node = root["open"];
    if (!node || node.IsScalar()) return read_name(root, "open", hand.open);
    if (!node.IsSequence() || node.size() == 0)
      fail(node, "open must be a name, or a list of names");
    std::vector<std::string> names(node.size());
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (!node[i].IsScalar() || node[i].Scalar().empty())
        fail(node[i], "open[" + std::to_string(i) + "] must be a name");
      names[i] = node[i].Scalar();
    }
    hand.open = names.front();
    hand.pre_shapes.assign(names.begin() + 1, names.end());
  }

  double read_number(const YAML::Node& node, const std::string& field) const {
    const std::optional<double> value =  // yaml-cpp reads numbers by the program's locale
        node.IsScalar() ? geometry::to_number(node.Scalar()) : std::nullopt;
    if (value && std::isfinite(*value)) return *value;
    fail(node, field + " must be a finite number" +
                   (node.IsScalar() ? ", not '" + node.Scalar() + "'" : std::string()));
  }

  Eigen::Vector3d read_vector(const YAML::Node& node, const std::string& field) const {
    if (!node.IsSequence()) fail(node, field + " must be a list of 3 numbers");
    if (node.size() != 3) {
      fail(node, field + " must be a list of 3 numbers, not of " + std::to_string(node.size()));
    }
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i) {
      vector[i] = read_number(node[i], field + "[" + std::to_string(i) + "]");
    }
    return vector;
  }

  /// Normalises a vector of any length.
  Eigen::Vector3d read_direction(const YAML::Node& node, const std::string& field) const {
    const Eigen::Vector3d vector = read_vector(node, field);
    const double length = vector.norm();
    if (!(length > 1e-9 && std::isfinite(length))) fail(node, field + " must not be zero");
    return vector / length;
  }

  CurveNode read_node(const YAML::Node& node, const std::string& field) const {
    check_keys(node, field, {"link", "point"});
    if (!node["link"]) fail(node, field + " needs 'link'");
    CurveNode corner;
    read_name(node, "link", corner.link);
    if (node["point"]) corner.p_L = read_vector(node["point"], field + ".point");
    return corner;
  }

  Finger read_finger(const YAML::Node& node, const std::string& name,
                     const std::string& field) const {
    if (!node.IsSequence() || node.size() < 2) {
      fail(node, field + " must be a list of at least 2 nodes, from the palm to the tip");
    }
    Finger finger{name, {}};
    for (std::size_t i = 0; i < node.size(); ++i) {
      finger.nodes.push_back(read_node(node[i], field + "[" + std::to_string(i) + "]"));
    }
    return finger;
  }

  std::vector<Finger> read_fingers(const YAML::Node& node) const {
    check_keys(node, "fingers", {});
    std::vector<Finger> fingers;
    for (const auto& entry : node) {
      const std::string name = entry.first.Scalar();
      fingers.push_back(read_finger(entry.second, name, "fingers." + name));
    }
    if (fingers.empty()) fail(node, "fingers must name at least one finger besides the thumb");
    return fingers;
  }

  std::string what_;
};

}  // namespace

Hand hand_from_yaml(const std::string& text, const std::string& what) {
  return HandReader(what).read(text);
}

Hand hand_from_yaml_file(const std::string& path) {
  return hand_from_yaml(geometry::read_text(path), path);
}

}  // namespace graspless::clasp
