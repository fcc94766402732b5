// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/problem.hpp"
#include "graspless/scene/scene.hpp"

#include "clasp/free_space/links_against_object.hpp"

namespace graspless::clasp {

/// Where robot, object and obstacles do not touch. FCL against the triangles of K_d is the judge;
/// spheres around the links and the object's clearance settle the clear cases before it. Limits and
/// self-collision included. K_d is a surface: a link wholly inside the object would not touch it,
/// but no motion that is looked at in small steps gets it there. Not shared between threads.
class GRASPLESS_API FreeSpace {
 public:
  explicit FreeSpace(const Problem& problem);

  bool is_free(const Eigen::VectorXd& q);
  /// Whether the straight motion is: what is_free(q) says at its ends and at even steps of at most
  /// `resolution` in any joint; stretches that bounds on the motion prove free are not stepped
  /// through.
  bool is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution);
  /// The first touching pair at q, by name, by FCL; empty names when free.
  std::pair<std::string, std::string> collision(const Eigen::VectorXd& q);

  std::int64_t num_checks() const { return checks_; }  ///< configurations looked at
  /// Links tested against the object by FCL.
  std::int64_t num_fcl_checks() const { return object_.num_fcl_checks(); }

 private:
  /// A link that is not yet known to stay clear of the object over a stretch of motion.
  struct OpenLink {
    int link;
    double motion;                   // bound on how far it moves in one step [m]
    double clear_first, clear_last;  // of the object, at the ends of the stretch [m]
    double clear_middle = 0;
  };

  void place(const Eigen::VectorXd& q);
  bool misses_object();
  bool open_links(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps);
  bool is_stretch_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& step, int first, int last,
                       std::size_t begin);
  bool look_at_middle(const Eigen::VectorXd& q, int steps_before, int steps_after,
                      std::size_t begin);
  void open_half(std::size_t begin, std::size_t end, bool second, int steps);

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  robot::Robot robot_;
  std::string object_name_;
  scene::Scene scene_;  // all but the object
  LinksAgainstObject object_;
  std::vector<int> links_;  // that move
  bool base_touches_object_ = false;
  robot::Poses X_WL_;
  std::vector<OpenLink> open_;  // a stack of stretches
  std::int64_t checks_ = 0;
};

}  // namespace graspless::clasp
