// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class TiXmlElement;

namespace graspless::robot {

/// Replaces each `<capsule radius length>` by a cylinder of that length between two spheres. URDF
/// has no capsules, but some tools write them. Returns true if there was one.
bool replace_capsules(TiXmlElement& robot);

}  // namespace graspless::robot
