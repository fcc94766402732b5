// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/prepared.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <list>
#include <mutex>
#include <optional>
#include <utility>

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

/// The meshes that were asked for last, as long as they have at most `most` triangles together.
class Kept {
 public:
  explicit Kept(Eigen::Index most) : most_(most) {}

  std::optional<CollisionShape> find(const geometry::Mesh& mesh, std::uint64_t hash) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.hash == hash && is_same(entry.mesh, mesh);
    });
    if (found == entries_.end()) return std::nullopt;
    entries_.splice(entries_.begin(), entries_, found);
    return found->shape;
  }

  void add(const geometry::Mesh& mesh, std::uint64_t hash, const CollisionShape& shape) {
    if (size_of(mesh) > most_) return;
    std::list<Entry> added, old;  // made and destroyed while others can ask
    added.push_back({hash, mesh, shape});
    const std::lock_guard lock(mutex_);
    entries_.splice(entries_.begin(), added);
    for (count_ += size_of(mesh); count_ > most_; count_ -= size_of(old.front().mesh))
      old.splice(old.begin(), entries_, std::prev(entries_.end()));
  }

 private:
  struct Entry {
    std::uint64_t hash;
    geometry::Mesh mesh;
    CollisionShape shape;
  };
  std::mutex mutex_;
  std::list<Entry> entries_;  // the last one first
  Eigen::Index most_, count_ = 0;
};

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
  if (std::optional<CollisionShape> found = kept.find(mesh, hash)) return *std::move(found);
  CollisionShape shape = make(mesh);
  kept.add(mesh, hash, shape);
  return shape;
}

}  // namespace graspless::collision
