// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Search for a motion that takes a loop out of a hand that does not move.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/clearance.hpp"

#include "clasp/certificate/still_hand.hpp"
#include "clasp/stability/balls.hpp"

namespace graspless::clasp {

/// Grows trees of poses from the clasp. Computations are in O, where the hand moves.
class WayOut {
 public:
  /// `curve_O`: the loop, 3 x n in O; `ring`: that it is linked with.
  WayOut(const StillHand& hand, const HandRing& ring, const Eigen::Matrix3Xd& curve_O,
         collision::Clearance& clearance, std::uint64_t seed);

  /// Distance of the hand from the object at the clasp, a lower bound [m].
  double clearance_at_start() const { return at_start_; }
  /// Moves the hand away from the object until the clearance is `enough`, and begins there from
  /// now on. The loop stays linked. Takes at most `moves`. Returns the clearance.
  double settle(double enough, int moves);
  /// Searches for a motion on which every ball stays at least `clearance` [m] away from the object,
  /// or is no deeper in it. Takes at most `moves`.
  bool exists(double clearance, int moves);
  std::int64_t num_moves() const { return moves_; }

 private:
  /// A rigid motion of the hand in O, from the clasp.
  struct Pose {
    Eigen::Quaterniond turn;
    Eigen::Vector3d p_OC;
  };
  struct Node {
    Pose pose;
    double away;  // distance of the loop from the hand's centre [m]
  };

  /// Neighbouring balls. Least of clear_ and largest of far_ [m].
  struct Group {
    BallGroup balls;
    double clear, far;
  };

  bool find_near(const Pose& pose, double shift, double angle);
  template <typename Visit>
  bool all_near(const Pose& pose, double shift, double angle, Visit visit) const;
  Eigen::Vector3d moved(const Pose& pose, const Eigen::Vector3d& p_C) const {
    return pose.turn * p_C + pose.p_OC;
  }
  double spare(const Pose& pose, Eigen::Index ball);
  double away(const Pose& pose) const;
  bool is_linked(const Pose& pose) const;
  bool is_free(const Pose& pose);
  bool is_free(const Pose& from, const Pose& to);
  bool stays_free(Eigen::Index ball, const Pose& from, double at_from, const Pose& to, double at_to,
                  double travel);
  Pose gate();
  Pose outwards(const Pose& from);
  Pose nearby(const Pose& from, double most);
  std::size_t pick();
  bool go(std::size_t node, const Pose& to);

  Eigen::Matrix3Xd p_CB_;        // centres of the balls at the clasp, relative to C [m]
  Eigen::VectorXd radii_, far_;  // radius and distance from C [m]
  Eigen::Matrix3Xd ring_C_, curve_O_;
  Eigen::Vector3d gap_C_, across_C_;  // middle and direction of the gap
  double reach_;
  collision::Clearance& clearance_;
  std::mt19937_64 rng_;
  const Pose clasp_;
  Eigen::VectorXd clear_;  // distance of each ball from the object at the clasp [m]
  std::vector<Group> groups_;
  Eigen::Index last_touched_ = 0;                      // a ball that was too near lately
  std::vector<std::pair<Eigen::Index, double>> near_;  // balls, and what each has to spare
  Pose start_;
  double at_start_ = 0;
  double level_ = 0;  // clearance of the current search [m]
  std::vector<Node> tree_;
  std::int64_t moves_ = 0;
};

}  // namespace graspless::clasp
