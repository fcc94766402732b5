// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/xml.hpp"

#include <algorithm>
#include <stdexcept>

#include <tinyxml.h>

namespace graspless::robot {
namespace {

/// Returns the index behind the next `end`, or the length of the text.
std::size_t behind(const std::string& xml, const std::string& end, std::size_t from) {
  const std::size_t found = xml.find(end, from);
  return found == std::string::npos ? xml.size() : found + end.size();
}

/// True if TinyXML takes the character behind a '<' for the start of a name.
bool starts_name(const std::string& xml, std::size_t i) {
  const auto c = i < xml.size() ? static_cast<unsigned char>(xml[i]) : 0;
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c >= 127;
}

/// Returns the index behind the '>' of a start tag. Quoted values may hold one, too.
std::size_t behind_tag(const std::string& xml, std::size_t from) {
  for (std::size_t i = from; i < xml.size(); ++i) {
    if (xml[i] == '>') return i + 1;
    if (xml[i] == '"' || xml[i] == '\'') i = behind(xml, std::string(1, xml[i]), i + 1) - 1;
  }
  return xml.size();
}

}  // namespace

// Divides the text as TinyXML does.
void require_shallow(const std::string& xml, const std::string& what) {
  int depth = 0;
  for (std::size_t i = xml.find('<'); i != std::string::npos; i = xml.find('<', i)) {
    if (xml.compare(i, 4, "<!--") == 0) {
      i = behind(xml, "-->", i + 4);
    } else if (xml.compare(i, 9, "<![CDATA[") == 0) {
      i = behind(xml, "]]>", i + 9);
    } else if (!starts_name(xml, i + 1)) {
      if (xml.compare(i, 2, "</") == 0) depth = std::max(0, depth - 1);
      i = behind(xml, ">", i);
    } else {
      const std::size_t start = i;
      i = behind_tag(xml, i);
      if (i >= 2 && xml[i - 2] == '/' && xml[i - 1] == '>') continue;
      if (++depth <= kMaxXmlDepth) continue;
      const auto line = 1 + std::count(xml.begin(), xml.begin() + start, '\n');
      throw std::invalid_argument(what + " line " + std::to_string(line) +
                                  ": elements may be nested " + std::to_string(kMaxXmlDepth) +
                                  " deep at most, but these are deeper");
    }
  }
}

void fail(const TiXmlElement& element, const std::string& what, const std::string& message) {
  throw std::invalid_argument(what + " line " + std::to_string(element.Row()) + ": " + message);
}

void parse_xml(const std::string& xml, const std::string& what, TiXmlDocument& document) {
  require_shallow(xml, what);
  document.Parse(xml.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.ErrorId() == TiXmlBase::TIXML_ERROR_DOCUMENT_EMPTY)
    throw std::invalid_argument(what + ": not XML: has no element");
  if (document.Error()) {
    throw std::invalid_argument(what + " line " + std::to_string(document.ErrorRow()) +
                                ": not XML: " + document.ErrorDesc());
  }
}

}  // namespace graspless::robot
