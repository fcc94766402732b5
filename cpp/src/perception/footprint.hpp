// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projections of objects onto their support.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "perception/clusters.hpp"

namespace graspless::perception {

/// The pixels of a cluster in one view, as an image.
class PixelSet {
 public:
  PixelSet(const Cluster& cluster, int view);
  /// Index of a pixel in its cluster; -1: it is none of its pixels.
  int at(int u, int v) const {
    if (!box_.contains(Eigen::Vector2i(u, v))) return -1;
    return index_(v - box_.min().y(), u - box_.min().x());
  }
  bool has(int u, int v) const { return at(u, v) >= 0; }
  /// True if the pixel and its four neighbours belong to the cluster.
  bool has_around(int u, int v) const {
    return has(u, v) && has(u - 1, v) && has(u + 1, v) && has(u, v - 1) && has(u, v + 1);
  }

 private:
  Eigen::AlignedBox2i box_;
  LabelImage index_;
};

/// One set for each view.
std::vector<PixelSet> sets_of(const Cluster& cluster, std::size_t views);

/// Cells of the support, in its frame S, that the object covers: one piece without holes. Flat
/// objects are as high as `thickness` everywhere.
Raster footprint_of(const Cluster& cluster, const std::vector<PixelSet>& sets, const Region& region,
                    const std::vector<Sighting>& sightings, bool is_flat, double thickness);

}  // namespace graspless::perception
