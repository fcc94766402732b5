// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

class TiXmlDocument;
class TiXmlElement;

namespace graspless::robot {

constexpr int kMaxXmlDepth = 100;

/// Throws std::invalid_argument that starts with `what` and names the line where elements are
/// nested deeper than kMaxXmlDepth. TinyXML recurses once a level, so it would overflow the stack.
void require_shallow(const std::string& xml, const std::string& what);

/// Throws std::invalid_argument that starts with `what` and names the element's line.
[[noreturn]] void fail(const TiXmlElement& element, const std::string& what,
                       const std::string& message);

/// Parses XML of any depth up to kMaxXmlDepth. Throws std::invalid_argument that starts with `what`
/// and names the line of a fault.
void parse_xml(const std::string& xml, const std::string& what, TiXmlDocument& document);

}  // namespace graspless::robot
