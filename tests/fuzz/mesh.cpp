// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "graspless/geometry/shape.hpp"

#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

/// A file in memory where there is such a folder.
std::string mesh_path(const std::string& extension) {
  const std::filesystem::path memory("/dev/shm");
  const auto folder =
      std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("graspless_fuzz_" + std::to_string(getpid()) + extension);
}

void read(Bytes bytes, const std::string& extension) {
  const std::string path = mesh_path(extension);
  std::ofstream(path, std::ios::binary) << bytes.rest();
  const auto remove = [&](auto*) { std::filesystem::remove(path); };
  const std::unique_ptr<void, decltype(remove)> guard(&bytes, remove);
  accepts([&] {
    const geometry::Mesh mesh = geometry::read_mesh(path);
    require(mesh.vertices.allFinite(), "vertices are finite");
    require(mesh.triangles.cols() > 0, "a mesh has a triangle");
    require(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertices.cols(),
            "indices refer to vertices");
  });
}

}  // namespace

void read_obj(Bytes bytes) { read(bytes, ".obj"); }
void read_off(Bytes bytes) { read(bytes, ".off"); }
void read_ply(Bytes bytes) { read(bytes, ".ply"); }
void read_stl(Bytes bytes) { read(bytes, ".stl"); }

}  // namespace graspless::fuzz
