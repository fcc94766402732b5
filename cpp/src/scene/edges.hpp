// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graspless/scene/certificate.hpp"

#include "scene/motion.hpp"
#include "scene/replay.hpp"

/// Proof that nothing touches on the edges between the rows of a motion.
namespace graspless::scene {

/// A body that moves beside the robot's links.
struct Companion {
  int body = -1;  ///< index in the world; -1: there is none
  /// Places it, and sets allowances that turn with it, at `t` on the edge from row `edge` on. The
  /// links are already placed, at X_WL.
  std::function<void(std::size_t edge, double t, const robot::Poses& X_WL)> place;
  /// Bound on the length of the path of each of its points from t0 to t1 [m].
  std::function<double(std::size_t edge, double t0, double t1)> length;
  /// Instead of `length`: the link that carries it.
  std::optional<Carrier> carrier;
};

/// Proves the edges of one segment against collisions.
class EdgeProver {
 public:
  /// Everything is kept by reference. There must be a row, and no value may be NaN or infinite.
  EdgeProver(const std::string& segment, const std::vector<Eigen::VectorXd>& rows, Replay& replay,
             const Companion& companion);

  /// Returns one doubt for each edge that is not proven free.
  std::vector<Doubt> run();

 private:
  /// A pair that may touch between two places.
  struct OpenPair {
    int index;
    double bound_first, bound_last;  // lower bounds on its distance at both places [m]
    double bound_middle = 0;
  };

  /// A part of the motion: whole rows, or a part of one edge.
  struct Stretch {
    double first, last;
    double companion;  // bound on the path of the companion's points [m]
  };

  void find_motions();
  Stretch stretch(double first, double last) const;
  Eigen::VectorXd motion_per_joint(int pair) const;
  void refute_swallowed();
  bool has_companion(int pair) const;
  double motion(int pair, const Stretch& stretch) const;
  void open_all(const Stretch& whole);
  void place(double where);
  void bound_at(double where, double OpenPair::*bound, std::size_t begin,
                const std::function<double(const OpenPair&)>& enough);
  void prove(const Stretch& stretch, std::size_t begin);
  void keep(const OpenPair& pair, const Stretch& half, bool second);
  void doubt(int pair, double where, double gap);
  void refute(int pair, double where);
  bool is_settled(const Stretch& stretch) const;
  std::string pair_name(int pair) const;

  const std::string segment_;
  const std::vector<Eigen::VectorXd>& rows_;
  Replay& replay_;
  collision::World& world_;
  const Companion& companion_;
  robot::Poses X_WL_;
  // Bounds on how far the bodies of a pair approach each other from row 0 to each row [m]: by the
  // joints for each pair, and by the companion.
  Eigen::MatrixXd joint_motion_;
  std::vector<double> companion_motion_;
  std::vector<OpenPair> open_;  // a stack of stretches
  std::vector<std::optional<Doubt>> doubts_;
};

/// Collects the doubts of a plan's segments.
class EdgeCertificateMaker {
 public:
  /// Adds the next segment and its doubts, in any order. A segment that does not begin exactly
  /// where the one before ends is doubted.
  void add(const std::string& segment, const std::vector<Eigen::VectorXd>& rows,
           std::vector<Doubt> doubts);
  EdgeCertificate take() { return std::move(certificate_); }

 private:
  EdgeCertificate certificate_;
  Eigen::VectorXd before_;  // last row of the segment before
};

}  // namespace graspless::scene
