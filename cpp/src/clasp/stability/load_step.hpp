// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A small motion of the object under a load, between contacts that it may close and joints of the
// hand that may yield.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/mechanics/contact.hpp"

namespace graspless::clasp {

constexpr double kMove = 2;  ///< largest step in a coordinate [mm]
constexpr double kGive = 2;  ///< largest work by which the hand yields in a step [N mm]

/// Constraint row . move <= gap + opens . yield. Lengths are in mm.
struct LoadContact {
  Eigen::Index point;  ///< identifies the contact in all steps under one load
  mechanics::Vector6d row;
  Eigen::VectorXd opens;  ///< how far the contact retreats for each joint
  double gap;
};

/// Contacts of the object at one pose, found when they are needed.
class LoadContacts {
 public:
  virtual ~LoadContacts() = default;
  /// Contact of a point; null if it has none.
  virtual const LoadContact* at(Eigen::Index point) = 0;
  /// All contacts that a move passes if joints yield, and perhaps others, in the order of the
  /// points.
  virtual std::vector<const LoadContact*> near(const mechanics::Vector6d& move,
                                               const Eigen::VectorXd& yield) = 0;
};

/// A motion of the object that is stopped by contacts, and the effort that it demands of the hand.
struct LoadStep {
  mechanics::Vector6d move = mechanics::Vector6d::Zero();  ///< [mm]
  double effort = 0;         ///< largest effort of a joint, as a fraction of its limit
  Eigen::Index yields = -1;  ///< the joint that yields most, by the work of its motor; -1: none
  bool is_free = false;      ///< no contact presses
};

/// Finds the steps under one load by linear programs. A program holds few contacts: those that
/// stopped earlier steps, and those that its solution would pass. The solution is optimal for all
/// contacts.
class LoadStepper {
 public:
  /// `limits`: of the efforts of the joints, in the units of LoadContact::opens. `give`: work by
  /// which the hand may yield, which makes efforts unique [N mm]; little, lest a joint give way for
  /// a whole step.
  explicit LoadStepper(Eigen::VectorXd limits, double give = kGive)
      : limits_(std::move(limits)), give_(give) {}

  LoadStep step(const mechanics::Vector6d& load, LoadContacts& contacts);

 private:
  Eigen::VectorXd limits_;
  double give_;
  std::set<Eigen::Index> points_;  // of contacts that were in a program
};

}  // namespace graspless::clasp
