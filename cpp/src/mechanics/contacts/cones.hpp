// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Unit edges, in O, of the forces that a contact or a finger can put on the object. A contact that
/// slides has one: c' of Eq. (1), against the motion.
Eigen::Matrix3Xd cone_of(const Contact& contact, int cone_edges);
Eigen::Matrix3Xd cone_of(const Finger& finger, int cone_edges);

/// The same set with cones of 12 edges or more, which hold its own: within 4 % of Coulomb's.
ContactSet with_round_cones(ContactSet set);

}  // namespace graspless::mechanics
