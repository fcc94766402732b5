// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/robot/ik.hpp"

#include "clasp/search/clasp_search.hpp"

namespace graspless::clasp {

/// Search for a clasp of a loop around a small hole: puts the last part of a finger or of the thumb
/// through the hole at random, so that the hand may close around the handle there, and looks for a
/// way to this place afterwards. For a grip of one finger and the thumb. TaskSpaceRRT hardly finds
/// such places, because a hand that moves towards the handle meets the rim.
class ThreadSearch : public ClaspSearch {
 public:
  /// Throws std::invalid_argument if the arm is not a chain that ends at the palm.
  ThreadSearch(Query& query, const LoopTask& task, const Eigen::VectorXd& q_start);

  /// Goes on with the samples of a cycle. Returns true at one that is free and linked.
  bool cycle() override;
  planning::Path path() override { return {q_}; }
  /// Moves the hand back along the finger, and on to the start by a free path.
  bool connect(planning::Path& reach) override;
  Tree tree() const override { return tree_; }
  Effort effort() const override { return effort_; }

 private:
  /// A finger or the thumb, with the joints of the hand that move its tip.
  struct Digit {
    CurveNode before, tip;
    std::vector<int> joints;
  };

  Digit digit(const Finger& finger) const;
  Eigen::Vector3d in_palm(const CurveNode& node) const;
  bool sample();
  Eigen::Isometry3d placed_W(const Digit& digit);
  planning::Path way_out();
  void set_tree(const planning::Path& reach);

  Eigen::VectorXd q_start_;
  robot::Ik ik_;
  int palm_;
  std::array<Digit, 2> digits_;
  Eigen::Vector3d center_W_, normal_W_;  // of the hole
  double width_;                         // of the hole [m]
  int samples_ = 0;                      // of this cycle
  Eigen::VectorXd q_;                    // the sample
  Eigen::Vector3d along_W_;              // direction of its finger in the hole
  double beyond_ = 0;                    // length of its finger behind the hole [m]
  robot::Poses X_WL_;
  Tree tree_;
  Effort effort_;
};

}  // namespace graspless::clasp
