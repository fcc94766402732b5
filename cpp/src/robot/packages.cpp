// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths of meshes, and folders of the packages in them.
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <tinyxml.h>

#include "graspless/robot/description.hpp"
#include "graspless/watch.hpp"

#include "robot/xml.hpp"

namespace graspless::robot {
namespace {

namespace fs = std::filesystem;

const std::string kPackage = "package://", kFile = "file://";

bool starts_with(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

/// Name of the package and path in it, of package://NAME/PATH. Some files have one slash more.
struct PackageFile {
  std::string package, path;
};

bool names_file(const std::string& uri) {
  const std::size_t start = uri.find_first_not_of('/', kPackage.size());
  return start != std::string::npos && uri.find('/', start) != std::string::npos;
}

PackageFile split(const std::string& uri) {
  if (!names_file(uri)) throw std::invalid_argument("'" + uri + "' names no file");
  const std::size_t start = uri.find_first_not_of('/', kPackage.size());
  const std::size_t slash = uri.find('/', start);
  const std::size_t path = uri.find_first_not_of('/', slash);
  return {uri.substr(start, slash - start), path == std::string::npos ? "" : uri.substr(path)};
}

/// Entries of an environment variable that holds paths.
std::vector<fs::path> paths_in(const char* variable) {
  std::vector<fs::path> paths;
  const char* value = std::getenv(variable);
  std::istringstream entries(value ? value : "");
  for (std::string entry; std::getline(entries, entry, ':');) {
    if (!entry.empty()) paths.emplace_back(entry);
  }
  return paths;
}

std::string shown(const char* variable) {
  const char* value = std::getenv(variable);
  return std::string(variable) + (value && *value ? " (" + std::string(value) + ")" : " (not set)");
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Finds packages for the meshes of one URDF.
class PackageFinder {
 public:
  explicit PackageFinder(const std::string& directory)
      : ros_(paths_in("ROS_PACKAGE_PATH")), ament_(paths_in("AMENT_PREFIX_PATH")) {
    std::error_code ignored;
    if (directory.empty()) return;
    fs::path folder = fs::weakly_canonical(fs::absolute(directory, ignored), ignored);
    if (!folder.has_filename()) folder = folder.parent_path();
    for (; folder.has_relative_path(); folder = folder.parent_path()) above_.push_back(folder);
  }

  /// The folder of a package that contains `path`, else any folder of it, else a folder above the
  /// URDF that contains `path`: that of a package whose folder has another name. Else "".
  std::string find(const PackageFile& file) const {
    std::string fallback;
    if (file.package == "." || file.package == "..") return fallback;
    for (const fs::path& folder : candidates(file.package)) {
      if (!is_folder(folder)) continue;
      if (is_file(folder / file.path)) return folder.string();
      if (fallback.empty()) fallback = folder.string();
    }
    for (const fs::path& folder : above_) {
      if (fallback.empty() && is_file(folder / file.path)) fallback = folder.string();
    }
    return fallback;
  }

  std::string places() const {
    std::string text =
        "looked in packages, " + shown("ROS_PACKAGE_PATH") + ", " + shown("AMENT_PREFIX_PATH");
    if (!above_.empty()) text += " and in the folders above '" + above_.front().string() + "'";
    return text;
  }

 private:
  std::vector<fs::path> candidates(const std::string& package) const {
    std::vector<fs::path> folders;
    const auto add = [&](const fs::path& folder) {
      if (folder.filename() == package) folders.push_back(folder);
      folders.push_back(folder / package);
    };
    for (const fs::path& folder : ros_) add(folder);
    for (const fs::path& prefix : ament_) folders.push_back(prefix / "share" / package);
    for (const fs::path& folder : above_) add(folder);
    return folders;
  }

  std::vector<fs::path> ros_, ament_, above_;
};

/// Calls `use` with the name of each mesh below an element. The XML is shallow.
template <typename Function>
void for_meshes(const TiXmlElement& element, const Function& use) {
  for (auto* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
    const char* name = e->Attribute("filename");
    if (name && e->ValueStr() == "mesh") use(std::string(name));
    for_meshes(*e, use);
  }
}

}  // namespace

std::string mesh_path(const std::string& name, const Description& description) {
  if (starts_with(name, kPackage)) {
    const PackageFile file = split(name);
    const auto found = description.packages.find(file.package);
    if (found != description.packages.end()) return found->second + "/" + file.path;
    throw std::invalid_argument("mesh '" + name + "': the folder of package '" + file.package +
                                "' is not known; give it in packages");
  }
  if (starts_with(name, kFile)) return name.substr(kFile.size());
  if (starts_with(name, "/") || description.directory.empty()) return name;
  return description.directory + "/" + name;
}

std::map<std::string, std::string> find_packages(const Description& description) {
  require_shallow(description.urdf, "URDF");
  TiXmlDocument document;
  document.Parse(description.urdf.c_str(), nullptr, TIXML_ENCODING_UTF8);
  std::map<std::string, std::string> packages = description.packages;
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (document.Error() || !robot) return packages;  // the reader of robots says what is wrong
  const PackageFinder finder(description.directory);
  std::set<std::string> missing;  // meshes of packages that were not found
  const auto look_up = [&](const std::string& name, const std::string& what) {
    poll();
    if (!starts_with(name, kPackage) || (what.empty() && !names_file(name))) return;
    const PackageFile file = split(name);
    if (packages.count(file.package) > 0) return;
    const std::string folder = missing.count(name) > 0 ? "" : finder.find(file);
    if (!folder.empty()) {
      packages.emplace(file.package, folder);
    } else if (missing.insert(name); !what.empty()) {
      throw std::invalid_argument(what + ": mesh '" + name + "': package '" + file.package +
                                  "' was not found; " + finder.places());
    }
  };
  for (auto* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    const char* name = link->Attribute("name");
    const std::string what = "collision shape of link '" + std::string(name ? name : "") + "'";
    for (auto* e = link->FirstChildElement(); e; e = e->NextSiblingElement()) {
      const bool collides = e->ValueStr() == "collision";
      for_meshes(*e, [&](const std::string& mesh) { look_up(mesh, collides ? what : ""); });
    }
  }
  return packages;
}

}  // namespace graspless::robot
