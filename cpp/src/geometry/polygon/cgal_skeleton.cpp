// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Uses CGAL's straight skeleton, licensed under GPL-3-or-later, and so is every binary that
// contains this file.
#include <cstddef>
#include <deque>
#include <exception>
#include <stdexcept>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/create_offset_polygons_2.h>

#include "graspless/watch.hpp"

#include "geometry/polygon/cgal_polygon.hpp"

namespace CGAL::CGAL_SS_i {

/// In place of CGAL's own cache of times, a vector that copies gigabytes at once as it grows: for
/// up to 9 s with 20,000 corners, in which nothing polls. This one grows without copying.
template <class FT>
struct Info_cache<boost::optional<Rational<FT>>> {
  using Info = boost::optional<Rational<FT>>;

  bool IsCached(std::size_t i) const { return i < known_.size() && known_[i].first; }
  const Info& Get(std::size_t i) const { return known_[i].second; }
  void Set(std::size_t i, const Info& info) {
    if (known_.size() <= i) known_.resize(i + 1);
    known_[i] = {true, info};
  }
  void Reset(std::size_t i) {
    if (IsCached(i)) known_[i].first = false;
  }

 private:
  std::deque<std::pair<bool, Info>> known_;
};

}  // namespace CGAL::CGAL_SS_i

namespace graspless::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Skeleton = CGAL::Straight_skeleton_2<Kernel>;

/// Polls while CGAL builds a skeleton, in time quadratic in the corners. CGAL swallows exceptions
/// of the visitor, so this one keeps it.
struct Poller : CGAL::Dummy_straight_skeleton_builder_2_visitor<Skeleton> {
  template <class Edge>
  void on_contour_edge_entered(const Edge&) const {
    poll_now();
  }
  template <class Vertex>
  void on_vertex_processed(const Vertex&) const {
    poll_now();
  }
  template <class Vertex>
  void on_initial_events_collected(const Vertex&, bool, bool) const {
    poll_now();
  }
  template <class Vertex>
  void on_split_event_created(const Vertex&) const {
    poll_now();
  }
  void poll_now() const {
    try {
      poll();
    } catch (...) {
      ended = std::current_exception();
      throw;
    }
  }
  mutable std::exception_ptr ended;
};

/// The part of the skeleton that an offset of this width needs.
boost::shared_ptr<Skeleton> skeleton(const CGAL::Polygon_2<Kernel>& polygon, double width) {
  using Traits = CGAL::Straight_skeleton_builder_traits_2<Kernel>;
  const Poller poller;
  CGAL::Straight_skeleton_builder_2<Traits, Skeleton, Poller> builder(width, Traits(), poller);
  builder.enter_contour(polygon.vertices_begin(), polygon.vertices_end());
  auto result = builder.construct_skeleton();
  if (poller.ended) std::rethrow_exception(poller.ended);
  return result;
}

}  // namespace

std::vector<Eigen::Matrix2Xd> contract(const Eigen::Matrix2Xd& vertices, double width) {
  CGAL::Polygon_2<Kernel> polygon;
  for (const auto& p : vertices.colwise()) polygon.push_back({p.x(), p.y()});
  std::vector<Eigen::Matrix2Xd> out;
  const auto bones = skeleton(polygon, width);
  if (!bones) throw std::runtime_error("the outline has no straight skeleton");
  for (const auto& piece : CGAL::create_offset_polygons_2<CGAL::Polygon_2<Kernel>>(width, *bones)) {
    Eigen::Matrix2Xd v(2, static_cast<Eigen::Index>(piece->size()));
    for (std::size_t i = 0; i < piece->size(); ++i) {
      v.col(i) << (*piece)[i].x(), (*piece)[i].y();
    }
    out.push_back(v);
  }
  return out;
}

}  // namespace graspless::geometry
