// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace graspless::robot {

constexpr int kMaxXmlDepth = 100;

/// Throws std::invalid_argument that starts with `what` and names the line where elements are
/// nested deeper than kMaxXmlDepth. TinyXML recurses once a level, so it would overflow the stack.
void require_shallow(const std::string& xml, const std::string& what);

}  // namespace graspless::robot
