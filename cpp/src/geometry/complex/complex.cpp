// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Filtration: computes the simplices at construction, and persistence on first use.
#include "graspless/geometry/complex.hpp"

#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include <Eigen/Eigenvalues>

#include "graspless/watch.hpp"

#include "geometry/complex/delaunay.hpp"
#include "geometry/complex/plateaus.hpp"
#include "geometry/complex/reduction.hpp"
#include "geometry/complex/simplices.hpp"
#include "geometry/require_points.hpp"

namespace graspless::geometry {
namespace {

/// Ratio of thickness to length below which a cloud counts as flat.
constexpr double kFlat = 1e-6;

bool is_flat(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred * centred.transpose(),
                                                            Eigen::EigenvaluesOnly);
  return axes.eigenvalues()[0] <= kFlat * kFlat * axes.eigenvalues()[2];
}

void check_span(const Delaunay& delaunay, const Eigen::Matrix3Xd& points, const std::string& what) {
  if (delaunay.num_vertices < 4) {
    throw std::invalid_argument(what + " must hold at least 4 distinct points, not " +
                                std::to_string(delaunay.num_vertices));
  }
  if (delaunay.dimension < 3 || is_flat(points)) {
    throw std::invalid_argument(what + " must span a volume; all " + std::to_string(points.cols()) +
                                " lie in a plane or on a line");
  }
}

Simplices triangulated(const Eigen::Matrix3Xd& points, const std::string& what) {
  require_points(points, what);
  const Delaunay triangulation = delaunay(points);
  check_span(triangulation, points, what);
  return simplices(points, triangulation);
}

}  // namespace

struct Filtration::Data {
  Eigen::Matrix3Xd points;
  Simplices simplices;
  mutable std::once_flag ranked, reduced;
  mutable std::optional<Ranking> ranking;
  mutable std::optional<BettiCurve> betti;
  mutable std::optional<Reduction> reduction;

  const BettiCurve& curve() const {
    std::call_once(ranked, [this] {
      ranking = geometry::ranking(simplices);
      betti = betti_curve(*ranking);
    });
    return *betti;
  }
  const Reduction& reduce() const {
    curve();
    std::call_once(reduced, [this] { reduction.emplace(*ranking); });
    return *reduction;
  }
};

Filtration::Filtration(const Eigen::Matrix3Xd& points, const std::string& what) {
  auto data = std::make_shared<Data>();
  data->simplices = triangulated(points, what);
  data->points = points;
  data_ = std::move(data);
}

const Eigen::Matrix3Xd& Filtration::points() const { return data_->points; }
int Filtration::num_vertices() const { return data_->simplices.num_vertices; }

Complex Filtration::complex(double max_edge_length) const {
  const Simplices& all = data_->simplices;
  Complex result;
  result.points = data_->points;
  result.max_edge_length = max_edge_length;
  result.edges.resize(2, static_cast<Eigen::Index>(all.edges.size()));
  Eigen::Index n = 0;
  for (std::size_t e = 0; e < all.edges.size(); ++e) {
    poll();
    if (!(all.lengths[e] < max_edge_length)) continue;
    result.edges.col(n++) << all.edges[e][0], all.edges[e][1];
  }
  result.edges.conservativeResize(2, n);
  result.triangles.resize(3, static_cast<Eigen::Index>(all.triangles.size()));
  n = 0;
  for (const auto& triangle : all.triangles) {
    poll();
    if (!(triangle.longest_edge < max_edge_length)) continue;
    result.triangles.col(n++) << triangle.vertices[0], triangle.vertices[1], triangle.vertices[2];
  }
  result.triangles.conservativeResize(3, n);
  return result;
}

const std::vector<PersistencePair>& Filtration::persistence() const {
  return data_->reduce().pairs();
}

const BettiCurve& Filtration::betti() const { return data_->curve(); }

std::vector<Plateau> Filtration::plateaus(double lasting_ratio) const {
  return geometry::plateaus(persistence(), lasting_ratio);
}

PersistencePair Filtration::span(const std::vector<int>& cycle, double max_edge_length) const {
  const std::vector<int>& rank = data_->reduce().ranking().rank;
  std::vector<int> edges;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const int a = cycle[i], b = cycle[(i + 1) % cycle.size()];
    const auto n = static_cast<int>(data_->points.cols());
    const int edge = a >= 0 && b >= 0 && a < n && b < n ? data_->simplices.edge(a, b) : -1;
    if (edge < 0 || !(data_->simplices.lengths[static_cast<std::size_t>(edge)] < max_edge_length)) {
      throw std::invalid_argument("cycle goes from point " + std::to_string(a) + " to " +
                                  std::to_string(b) + ", which is no edge shorter than " +
                                  std::to_string(max_edge_length) + " m");
    }
    edges.push_back(rank[static_cast<std::size_t>(edge)]);
  }
  return data_->reduce().span(edges, max_edge_length);
}

}  // namespace graspless::geometry
