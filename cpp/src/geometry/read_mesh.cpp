// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In a file of its own because CGAL's readers are slow to compile.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

constexpr std::array<const char*, 4> kExtensions{".stl", ".obj", ".off", ".ply"};

[[noreturn]] void refuse_file(const std::string& path, const std::string& fault) {
  throw std::invalid_argument("mesh '" + path + "' " + fault);
}

void require_scale(const Eigen::Vector3d& scale) {
  if (scale.allFinite() && scale.cwiseAbs().minCoeff() > 0) return;
  std::ostringstream fault;
  fault << "scale must be finite and not zero, not (" << scale.transpose() << ")";
  throw std::invalid_argument(fault.str());
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(kExtensions.begin(), kExtensions.end(), extension) == kExtensions.end()) {
    refuse_file(path, "has extension '" + extension + "'; choose from .stl, .obj, .off, .ply");
  }
  return extension;
}

/// Numbers of elements stated in the header of a .ply file.
std::vector<double> counts_of_ply(std::istream& file) {
  std::vector<double> counts;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word, name;
    double count = 0;
    words >> word;
    if (word == "end_header") break;
    if (word == "element" && words >> name >> count) counts.push_back(count);
  }
  return counts;
}

/// Numbers of vertices and faces stated in the header of an .off file.
std::vector<double> counts_of_off(std::istream& file, const std::string& path) {
  std::vector<double> counts;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) {
      if (word == "BINARY") refuse_file(path, "is a binary .off file; save it as text");
      if (word.find("OFF") != std::string::npos) continue;
      counts.push_back(std::strtod(word.c_str(), nullptr));
      if (counts.size() == 2) return counts;
    }
  }
  return counts;
}

/// CGAL's readers reserve memory for the numbers stated in the header. Every element takes at least
/// a byte, so larger numbers than the file's size are wrong.
void require_plausible_header(const std::string& path, const std::string& extension) {
  if (extension != ".ply" && extension != ".off") return;
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::ifstream file(path, std::ios::binary);
  for (const double count : extension == ".ply" ? counts_of_ply(file) : counts_of_off(file, path)) {
    if (count > size)
      refuse_file(path, "is damaged: its header states more elements than the file can hold");
  }
}

Soup read_soup(const std::string& path) {
  Soup soup;
  try {
    if (CGAL::IO::read_polygon_soup(path, soup.points, soup.polygons)) return soup;
  } catch (const std::exception& error) {
    refuse_file(path, std::string("cannot be read: ") + error.what());
  }
  refuse_file(path, "cannot be read: it is damaged, or its format does not match its extension");
}

/// Splits each polygon into a fan of triangles. Drops triangles that repeat a vertex.
Eigen::Matrix3Xi triangulate(const Soup& soup, const std::string& path) {
  std::vector<Eigen::Vector3i> triangles;
  for (const auto& polygon : soup.polygons) {
    for (const std::size_t corner : polygon) {
      if (corner >= soup.points.size()) {
        refuse_file(path, "refers to vertex " + std::to_string(corner) + " of " +
                              std::to_string(soup.points.size()));
      }
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Eigen::Vector3i t(static_cast<int>(polygon[0]), static_cast<int>(polygon[i - 1]),
                              static_cast<int>(polygon[i]));
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
  }
  Eigen::Matrix3Xi columns(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = triangles[i];
  return columns;
}

}  // namespace

Mesh read_mesh(const std::string& path, const Eigen::Vector3d& scale) {
  require_scale(scale);
  const std::string extension = extension_of(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) refuse_file(path, "is missing");
  require_plausible_header(path, extension);

  const Soup soup = read_soup(path);
  Mesh mesh;
  mesh.vertices.resize(3, static_cast<Eigen::Index>(soup.points.size()));
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Point& p = soup.points[i];
    mesh.vertices.col(static_cast<Eigen::Index>(i)) =
        scale.cwiseProduct(Eigen::Vector3d(p.x(), p.y(), p.z()));
  }
  mesh.triangles = triangulate(soup, path);
  if (mesh.triangles.cols() == 0) refuse_file(path, "is empty: it has no triangle");
  if (scale.prod() < 0)
    mesh.triangles.row(1).swap(mesh.triangles.row(2));  // a reflection flips the orientation
  validate(mesh, "mesh '" + path + "'");
  return mesh;
}

}  // namespace graspless::geometry
