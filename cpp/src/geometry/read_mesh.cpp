// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In a file of its own because CGAL's reader is slow to compile.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include "graspless/geometry/shape.hpp"
#include "graspless/watch.hpp"

#include "geometry/polygon/cgal_polygon.hpp"
#include "geometry/read_obj.hpp"
#include "geometry/read_off.hpp"
#include "geometry/read_ply.hpp"

namespace graspless::geometry {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

constexpr std::array<const char*, 4> kExtensions{".stl", ".obj", ".off", ".ply"};
constexpr std::array<const char*, 3> kForeign{".dae", ".glb", ".gltf"};  // for a MeshReader

MeshReader& foreign_reader() {
  static MeshReader reader;
  return reader;
}

template <typename List>
bool contains(const List& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

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
  if (contains(kExtensions, extension)) return extension;
  if (!contains(kForeign, extension)) {
    refuse_file(path, "has extension '" + extension +
                          "'; choose from .stl, .obj, .off, .ply, .dae, .glb, .gltf");
  }
  if (!foreign_reader()) {
    refuse_file(path, "has extension '" + extension +
                          "', which is read in Python only; convert it to .stl or .obj, or give a "
                          "reader to set_mesh_reader()");
  }
  return extension;
}

thread_local std::size_t file_size = 0;  // of the file that CGAL reads [bytes]

/// A vector for CGAL's reader, which reserves memory for the numbers that a file states. Every
/// element takes at least a byte, so a number above the file's size is wrong.
template <typename T>
struct Bounded : std::vector<T> {
  void resize(std::size_t size) {
    if (size > file_size) {
      throw std::length_error("it states " + std::to_string(size) + " elements, but has only " +
                              std::to_string(file_size) + " bytes");
    }
    std::vector<T>::resize(size);
  }
};

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// True of a .stl file that states that it has no triangle. CGAL finds none in any other text.
bool is_empty_stl(const std::string& path) {
  constexpr std::size_t kHeader = 84;  // of a binary file, with the number of triangles [bytes]
  if (file_size == 0 || file_size == kHeader) return true;
  const std::string text = text_of(path);
  const auto has = [&text](const char* word) { return text.find(word) != std::string::npos; };
  return has("endsolid") && !has("vertex");
}

PolygonSoup read_stl(const std::string& path) {
  Bounded<Point> points;
  Bounded<Bounded<std::size_t>> polygons;
  file_size = std::filesystem::file_size(path);
  const auto read = [&](bool is_binary) {
    std::ifstream file(path, std::ios::binary);
    file.imbue(std::locale::classic());  // a decimal point, whatever the program's locale
    CGAL::IO::set_mode(file, is_binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
    points.clear();
    polygons.clear();
    return CGAL::IO::read_STL(file, points, polygons, CGAL::parameters::use_binary_mode(is_binary));
  };
  const bool is_read = read(true) || read(false);
  if (!is_read || (polygons.empty() && !is_empty_stl(path))) {
    throw std::invalid_argument("it is damaged, or its format does not match its extension");
  }
  PolygonSoup soup;
  for (const Point& p : points) soup.points.emplace_back(p.x(), p.y(), p.z());
  for (auto& polygon : polygons) soup.polygons.push_back(std::move(polygon));
  return soup;
}

PolygonSoup read_soup(const std::string& path, const std::string& extension) {
  try {
    if (extension == ".stl") return read_stl(path);
    if (extension == ".obj") {
      std::ifstream file(path, std::ios::binary);
      return read_obj(file);
    }
    const std::string text = text_of(path);
    return extension == ".off" ? read_off(text) : read_ply(text);
  } catch (const std::exception& error) {
    refuse_file(path, std::string("cannot be read: ") + error.what());
  }
}

using Corners = std::vector<std::size_t>;

/// Splits a face into pieces that are covered by the fan from their first corner.
std::vector<Corners> fans_of(const Corners& face, const std::vector<Eigen::Vector3d>& points) {
  const auto count = static_cast<Eigen::Index>(face.size());
  Eigen::Matrix3Xd corners(3, count);
  for (Eigen::Index i = 0; i < count; ++i) corners.col(i) = points[face[i]];
  Eigen::Matrix3Xd areas = Eigen::Matrix3Xd::Zero(3, count);  // of the fan from the first corner
  for (Eigen::Index i = 2; i < count; ++i)
    areas.col(i) = (corners.col(i - 1) - corners.col(0)).cross(corners.col(i) - corners.col(0));
  const Eigen::Vector3d normal = areas.rowwise().sum();
  if (((normal.transpose() * areas).array() >= 0).all()) return {face};
  const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.normalized().cross(x);
  Eigen::Matrix2Xd flat(2, count);
  flat << x.transpose() * corners, y.transpose() * corners;
  if (!is_simple(flat)) return {face};  // it crosses itself, and has no inside
  std::vector<Corners> pieces;
  for (const Eigen::Matrix2Xd& part : convex_partition(flat)) {
    Corners& piece = pieces.emplace_back();
    for (const auto& p : part.colwise()) {
      Eigen::Index i = 0;
      while (flat.col(i) != p) ++i;  // the pieces have no other corners
      piece.push_back(face[i]);
    }
  }
  return pieces;
}

/// Splits each face into triangles. Drops triangles that repeat a vertex.
Eigen::Matrix3Xi triangulate(const PolygonSoup& soup, const std::string& path) {
  std::vector<Eigen::Vector3i> triangles;
  const auto add = [&triangles](const Corners& fan) {
    for (std::size_t i = 2; i < fan.size(); ++i) {
      const Eigen::Vector3i t(static_cast<int>(fan[0]), static_cast<int>(fan[i - 1]),
                              static_cast<int>(fan[i]));
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
  };
  for (const Corners& face : soup.polygons) {
    poll();
    for (const std::size_t corner : face) {
      if (corner >= soup.points.size()) {
        refuse_file(path, "refers to vertex " + std::to_string(corner) + " of " +
                              std::to_string(soup.points.size()));
      }
    }
    if (face.size() <= 3)
      add(face);
    else
      for (const Corners& fan : fans_of(face, soup.points)) add(fan);
  }
  Eigen::Matrix3Xi columns(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) columns.col(i) = triangles[i];
  return columns;
}

Mesh read_own(const std::string& path, const std::string& extension) {
  const PolygonSoup soup = read_soup(path, extension);
  Mesh mesh;
  mesh.vertices.resize(3, static_cast<Eigen::Index>(soup.points.size()));
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    poll();
    mesh.vertices.col(i) = soup.points[i];
  }
  mesh.triangles = triangulate(soup, path);
  return mesh;
}

}  // namespace

void set_mesh_reader(MeshReader reader) { foreign_reader() = std::move(reader); }

Mesh read_mesh(const std::string& path, const Eigen::Vector3d& scale) {
  require_scale(scale);
  const std::string extension = extension_of(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) refuse_file(path, "is missing");

  Mesh mesh = contains(kExtensions, extension) ? read_own(path, extension) : foreign_reader()(path);
  mesh.vertices = scale.asDiagonal() * mesh.vertices;
  if (mesh.triangles.cols() == 0) refuse_file(path, "is empty: it has no triangle");
  if (scale.prod() < 0)
    mesh.triangles.row(1).swap(mesh.triangles.row(2));  // a reflection flips the orientation
  validate(mesh, "mesh '" + path + "'");
  return mesh;
}

}  // namespace graspless::geometry
