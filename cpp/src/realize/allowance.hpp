// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// What a touch may be, for realize() and its check() alike.
#pragma once

namespace graspless::fingertip {

/// How deep the links of a touching fingertip may reach into the object along the contact's normal
/// [m]: what the tolerance on positions and rounding take.
inline double contact_allowance(double position_tolerance) { return 2 * position_tolerance + 1e-4; }

}  // namespace graspless::fingertip
