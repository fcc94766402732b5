// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "graspless/planning/fields.hpp"

namespace graspless::slide {

/// Model of how the sliding finger yields when it presses on the object.
enum class FingerModel { none, flexure, impedance, rigid_guarded };

/// Table of the values: name and text.
constexpr auto choices(FingerModel) {
  using planning::Choice;
  return std::array{
      Choice{FingerModel::none, "none",
             "Rigid, on an arm that holds its position: depth 0, and at most 3 mm, which a pad "
             "gives way."},
      Choice{FingerModel::flexure, "flexure",
             "Bends about one flexure: the contact moves ahead of the commanded tip. Depth 5 to 25 "
             "mm."},
      Choice{
          FingerModel::impedance, "impedance",
          "Rigid, on an arm under impedance control: the wrist gives way without turning, so the "
          "contact is below the commanded tip. Depth 0.5 to 1.5 times press_force / "
          "wrist_stiffness."},
      Choice{FingerModel::rigid_guarded, "rigid_guarded",
             "Rigid, on an arm that moves down until it touches and then holds press_force: depth "
             "0."}};
}

/// Description of the hand: names from the robot's URDF and SRDF, and the pad that slides. fields()
/// describes them. The default stiffness presses with 9 N at a depth of 15 mm.
struct Hand {
  std::string arm = "arm";
  std::string fingertip = "left_fingertip";
  std::vector<std::string> sliding_finger = {"left_finger"};
  std::vector<std::string> fingers = {"left_finger", "right_finger"};
  std::string grasp_frame = "grasp";
  std::string open = "open";
  std::string closed = "closed";
  FingerModel finger_model = FingerModel::flexure;
  double flexure_length = 0.11;
  double tip_radius = 0.005;
  double flexure_stiffness = 4.6;
  double wrist_stiffness = 0;
  double press_force = 9;
  double pad_width = 0.032;
  double pad_friction = 1.16;
};

/// Table of the members: name, unit, text and range.
inline auto fields(const Hand&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"arm", &Hand::arm, "", "Group of joints that carry the hand, base to wrist."},
      Field{"fingertip", &Hand::fingertip, "",
            "Frame F: X along the line contact, Z out of the tip, Y towards the other finger."},
      Field{"sliding_finger", &Hand::sliding_finger, "",
            "Links that may press into object and support."},
      Field{"fingers", &Hand::fingers, "", "Links that close on the object."},
      Field{"grasp_frame", &Hand::grasp_frame, "",
            "Frame H: origin between the open tips, Z out of the hand, Y from finger to finger."},
      Field{"open", &Hand::open, "", "State of the hand's joints while it slides and reaches."},
      Field{"closed", &Hand::closed, "",
            "State that the hand closes towards, until it touches the object."},
      Field{"finger_model", &Hand::finger_model, "",
            "Model of how the sliding finger yields when it presses on the object."},
      Field{"flexure_length", &Hand::flexure_length, "m", "Distance from the flexure to the tip.",
            Range::left_open(0, 1)},
      Field{"tip_radius", &Hand::tip_radius, "m", "Radius of the pad that rolls on the object.",
            Range::left_open(0, 0.1)},
      Field{"flexure_stiffness", &Hand::flexure_stiffness, "Nm/rad", "Stiffness of the flexure.",
            Range::left_open(0, 1000)},
      Field{"wrist_stiffness", &Hand::wrist_stiffness, "N/m",
            "Stiffness of the arm's impedance control in translation. finger_model impedance needs "
            "it.",
            Range::closed(0, 1e5)},
      Field{"press_force", &Hand::press_force, "N",
            "Normal force that a finger without a flexure presses with.",
            Range::left_open(0, 1000)},
      Field{"pad_width", &Hand::pad_width, "m", "Length of the line contact.",
            Range::left_open(0, 0.2)},
      Field{"pad_friction", &Hand::pad_friction, "",
            "Coefficient of friction between pad and object.", Range::left_open(0, 10)});
}

}  // namespace graspless::slide
