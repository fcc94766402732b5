// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/urdf/capsules.hpp"

#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <tinyxml.h>
#include <urdf_model/pose.h>
#include <urdf_model/utils.h>

#include "robot/xml.hpp"

namespace graspless::robot {
namespace {

TiXmlElement* capsule_of(TiXmlElement& element) {
  TiXmlElement* geometry = element.FirstChildElement("geometry");
  return geometry ? geometry->FirstChildElement("capsule") : nullptr;
}

std::string text_of(const TiXmlElement& capsule, const char* attribute) {
  const char* value = capsule.Attribute(attribute);
  if (value) return value;
  fail(capsule, "URDF", "<capsule> has no attribute '" + std::string(attribute) + "'");
}

/// Pose of an element's shape in its link. Throws urdf::ParseError.
urdf::Pose origin_of(const TiXmlElement& element) {
  urdf::Pose pose;
  const TiXmlElement* origin = element.FirstChildElement("origin");
  if (origin && origin->Attribute("xyz")) pose.position.init(origin->Attribute("xyz"));
  if (origin && origin->Attribute("rpy")) pose.rotation.init(origin->Attribute("rpy"));
  return pose;
}

void move_to(const urdf::Vector3& p, TiXmlElement& element) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << p.x << ' ' << p.y << ' ' << p.z;
  TiXmlElement* origin = element.FirstChildElement("origin");
  if (!origin) origin = element.InsertEndChild(TiXmlElement("origin"))->ToElement();
  origin->SetAttribute("xyz", text.str());
}

void set_shape(const TiXmlElement& shape, TiXmlElement& element) {
  TiXmlElement* geometry = element.FirstChildElement("geometry");
  geometry->ReplaceChild(capsule_of(element), shape);
}

/// Replaces the capsule of one element. Adds an element for the sphere at each end.
void replace(TiXmlElement& element) {
  const std::string radius = text_of(*capsule_of(element), "radius"),
                    length = text_of(*capsule_of(element), "length");
  urdf::Pose X_LG = origin_of(element);  // not constant: urdfdom's sum of vectors asks for that
  TiXmlElement cylinder("cylinder"), sphere("sphere");
  cylinder.SetAttribute("radius", radius);
  cylinder.SetAttribute("length", length);
  sphere.SetAttribute("radius", radius);
  const double half = urdf::strToDouble(length.c_str()) / 2;
  for (const double end : {-half, half}) {
    TiXmlElement copy(element);
    set_shape(sphere, copy);
    move_to(X_LG.position + X_LG.rotation * urdf::Vector3(0, 0, end), copy);
    element.Parent()->InsertAfterChild(&element, copy);
  }
  set_shape(cylinder, element);
}

}  // namespace

bool replace_capsules(TiXmlElement& robot) {
  std::vector<TiXmlElement*> found;
  for (auto* link = robot.FirstChildElement("link"); link; link = link->NextSiblingElement("link"))
    for (const char* use : {"collision", "visual"})
      for (auto* e = link->FirstChildElement(use); e; e = e->NextSiblingElement(use))
        if (capsule_of(*e)) found.push_back(e);
  for (TiXmlElement* element : found) {
    try {
      replace(*element);
    } catch (const std::runtime_error& error) {  // of urdfdom, about a number
      fail(*element, "URDF", std::string("<capsule>: ") + error.what());
    }
  }
  return !found.empty();
}

}  // namespace graspless::robot
