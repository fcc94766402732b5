// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Unit edges, in O, of the cone of forces that a contact or a finger can exert on the object. A
/// sliding contact has only one: c' of Eq. (1), against the motion.
Eigen::Matrix3Xd cone_of(const Contact& contact, int cone_edges);
Eigen::Matrix3Xd cone_of(const Finger& finger, int cone_edges);

/// Returns the set with cones of at least 12 edges that contain its own. They are within 4 % of
/// Coulomb's cone.
ContactSet with_round_cones(ContactSet set);

}  // namespace graspless::mechanics
