// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/prepared.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "collision/recent.hpp"

namespace graspless::collision {
namespace {

// Triangles, or vertices: 0.2 kB each, 1 kB once FCL is asked.
constexpr Eigen::Index kMost = 50'000;        // of all small meshes that are kept
constexpr Eigen::Index kSmall = kMost / 2;    // of a small mesh
constexpr Eigen::Index kLargest = 1'000'000;  // of all large meshes that are kept

/// Mixes the bytes of a matrix into a hash.
template <class Matrix>
std::uint64_t mixed(std::uint64_t hash, const Matrix& matrix) {
  const auto* bytes = reinterpret_cast<const char*>(matrix.data());
  const std::size_t size = static_cast<std::size_t>(matrix.size()) * sizeof(*matrix.data());
  std::uint64_t word = 0;
  for (std::size_t i = 0; i + sizeof word <= size; i += sizeof word) {
    std::memcpy(&word, bytes + i, sizeof word);
    hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29U;
  }
  return hash;
}

std::uint64_t hash_of(const geometry::Mesh& mesh) {
  const auto count = static_cast<std::uint64_t>(mesh.triangles.cols());
  return mixed(mixed(count, mesh.vertices), mesh.triangles);
}

Eigen::Index size_of(const geometry::Mesh& mesh) {
  return std::max(mesh.triangles.cols(), mesh.vertices.cols());
}

struct HashedMesh {
  std::uint64_t hash;
  geometry::Mesh mesh;
};
using Kept = Recent<HashedMesh, CollisionShape>;

/// Where a mesh of this size is kept. Large ones, such as the scan of a room, do not displace those
/// of a robot.
Kept& kept_of(Eigen::Index size) {
  // Never destroyed: a thread may still plan when others end.
  static Kept &small = *new Kept(kMost), &large = *new Kept(kLargest);
  return size > kSmall ? large : small;
}

}  // namespace

bool is_same(const geometry::Mesh& a, const geometry::Mesh& b) {
  return a.vertices.cols() == b.vertices.cols() && a.triangles.cols() == b.triangles.cols() &&
         a.vertices == b.vertices && a.triangles == b.triangles;
}

CollisionShape prepared(const geometry::Mesh& mesh,
                        const std::function<CollisionShape(const geometry::Mesh&)>& make) {
  Kept& kept = kept_of(size_of(mesh));
  const std::uint64_t hash = hash_of(mesh);
  const auto is_it = [&](const HashedMesh& key) {
    return key.hash == hash && is_same(key.mesh, mesh);
  };
  if (std::optional<CollisionShape> found = kept.find(is_it)) return *std::move(found);
  CollisionShape shape = make(mesh);
  kept.add({hash, mesh}, shape, size_of(mesh));
  return shape;
}

}  // namespace graspless::collision
