// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Wrenches (in O, about the centre of mass) that the contacts of the environment can supply
/// together, where that has a closed form with round cones.
class Support {
 public:
  explicit Support(const ContactSet& set);
  /// True for two contacts that stick to one plane and for three or more, not on a line, that slide
  /// on it in one direction. The other functions are for these alone.
  bool is_closed_form() const { return is_edge_ || !facets_.empty(); }
  /// Largest t up to `most` such that all wrenches from w to w + t change can be supplied. Both are
  /// taken to lie in the space that the contacts' forces span.
  double within(const Vector6d& w, const Vector6d& change, double most) const;
  /// Largest e such that w + changes * errors can be supplied for all errors whose every three
  /// entries have length e at most; possibly less for an edge, where the largest changes of the
  /// forces at its two ends are taken to come together.
  double tolerates(const Vector6d& w, const Matrix6Xd& changes) const;

 private:
  void find_facets(const ContactSet& set);
  std::array<Eigen::Vector3d, 2> across_edge(const Vector6d& w) const;
  bool edge_supplies(const Vector6d& w) const;
  double edge_tolerates(const Vector6d& w, const Matrix6Xd& changes) const;

  bool is_edge_ = false;
  // Two sticking contacts.
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();  // p_1 - com
  Eigen::Vector3d along_ = Eigen::Vector3d::Zero();  // p_2 - p_1
  Eigen::Vector3d unit_ = Eigen::Vector3d::Zero();   // along it
  double length_ = 0, squared_ = 0;                  // of along_
  Eigen::Vector3d n_ = Eigen::Vector3d::Zero();      // normal
  double friction_ = 0;
  std::vector<Vector6d> facets_;  // sliding contacts supply w if facet . w >= 0 for all
};

}  // namespace graspless::mechanics
