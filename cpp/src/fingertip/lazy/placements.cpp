// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All placements that the bounds allow, finger by finger, and first bounds from a few of them.
#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {

namespace {

using Step = StabilityBounds::Step;

constexpr std::size_t kPolledLocations = 256;  // between two polls
constexpr std::size_t kParts = 16;             // looked at together by all threads
constexpr std::size_t kFirst = 8;              // locations of the first finger in a part

/// Rows of the table of bounds at one instant, side by side for all locations.
struct Rows {
  Rows(const StabilityBounds& bounds, int instant, const std::vector<int>& locations)
      : used(static_cast<std::size_t>(bounds.used(instant))), best(used, 0.0F) {
    if (used == 0) return;
    offsets.assign(bounds.offsets(instant), bounds.offsets(instant) + used);
    all.reserve(locations.size() * used);
    for (const int location : locations) {
      const float* h = bounds.block(instant, location);
      all.insert(all.end(), h, h + used);
      for (std::size_t k = 0; k < used; ++k) best[k] = std::max(best[k], h[k]);
    }
  }
  std::size_t used;
  std::vector<float> offsets, all, best;  // best: of all locations
};

/// Depth-first over fingers. Sums of the table's rows over the fingers so far bound what any
/// completion can reach: those with the best location for each missing finger.
class Enumeration {
 public:
  Enumeration(const PoseGraph& graph, const StabilityBounds& bounds, int count,
              const std::vector<int>& locations, const std::vector<int>& instants, float needed,
              const Rows& rows, const std::function<bool(const Placement&)>& found)
      : graph_(graph),
        bounds_(bounds),
        count_(count),
        locations_(locations),
        instants_(instants),
        found_(found),
        needed_(needed),
        rows_(rows),
        sums_(static_cast<std::size_t>(count + 1) * rows.used) {
    std::copy(rows.offsets.begin(), rows.offsets.end(), sums_.begin());
  }

  /// With the first finger at the locations from `begin` to before `end`.
  bool run(std::size_t begin, std::size_t end) { return place(0, begin, end); }

 private:
  float* sum(int depth) { return sums_.data() + static_cast<std::size_t>(depth) * rows_.used; }

  bool is_apart(int depth, int location) const {
    for (int i = 0; i < depth && i < mechanics::kMaxFingers; ++i) {
      if (!graph_.locations.are_apart(placement_[i], location)) {
        return false;
      }
    }
    return true;
  }

  // Returns true if the sums with `missing` more fingers at their best reach what is needed. The
  // functionals that refused the last placement are the first to be asked.
  bool extend(int depth, std::size_t at, int missing) {
    if (rows_.used == 0) return true;
    const float* h = rows_.all.data() + at * rows_.used;
    const auto is_short = [&](std::size_t i) {
      Eigen::Map<Step> to(sum(depth + 1) + i);
      to = Eigen::Map<const Step>(sum(depth) + i) + Eigen::Map<const Step>(h + i);
      const Step reach =
          to + static_cast<float>(missing) * Eigen::Map<const Step>(rows_.best.data() + i);
      return reach.minCoeff() < needed_;
    };
    if (is_short(refused_)) return false;
    for (std::size_t i = 0; i < rows_.used; i += kStep) {
      if (!is_short(i)) continue;
      refused_ = i;
      return false;
    }
    return true;
  }

  bool place(int depth, std::size_t begin, std::size_t end) {
    if (depth >= count_ || depth >= mechanics::kMaxFingers) return accept();
    poll();
    const int missing = count_ - depth - 1;
    for (std::size_t i = begin;
         i < end && i + static_cast<std::size_t>(missing) < locations_.size(); ++i) {
      if (i % kPolledLocations == 0) poll();
      if (!extend(depth, i, missing) || !is_apart(depth, locations_[i])) continue;
      placement_[depth] = locations_[i];
      if (!place(depth + 1, i + 1, locations_.size())) return false;
      placement_[depth] = -1;
    }
    return true;
  }

  bool accept() {
    for (std::size_t i = 1; i < instants_.size(); ++i) {
      if (bounds_.bound(instants_[i], placement_) < needed_) return true;
    }
    return found_(placement_);
  }

  const PoseGraph& graph_;
  const StabilityBounds& bounds_;
  const int count_;
  const std::vector<int>& locations_;
  const std::vector<int>& instants_;
  const std::function<bool(const Placement&)>& found_;
  const float needed_;
  const Rows& rows_;
  std::size_t refused_ = 0;
  std::vector<float> sums_;
  Placement placement_ = kNoFingers;
};

constexpr int kRounds = 12;          // at an instant
constexpr std::size_t kEach = 2;     // placements solved a round
constexpr double kMany = 60000;      // placements that represent all
constexpr double kStagnation = 0.9;  // what is left of them, when it no longer pays

/// Every so many-th location, such that there are at most kMany placements.
std::vector<int> thinned(const std::vector<int>& locations, int count) {
  double placements = 1;
  for (int i = 0; i < count; ++i) {
    placements *= (static_cast<double>(locations.size()) - i) / (i + 1);
  }
  const double stride = std::max(1.0, std::pow(placements / kMany, 1.0 / count));
  std::vector<int> some;
  for (double i = 0; i < static_cast<double>(locations.size()); i += stride) {
    some.push_back(locations[static_cast<std::size_t>(i)]);
  }
  return some;
}

}  // namespace

void for_each_placement(const PoseGraph& graph, const StabilityBounds& bounds, int count,
                        const std::vector<int>& locations, const std::vector<int>& instants,
                        float needed, Crew& crew,
                        const std::function<bool(const Placement&)>& found) {
  const Rows rows(bounds, instants.front(), locations);
  const std::size_t size = locations.size();
  // Of more fingers, the placements with one location of the first would take much memory.
  if (count != 2) {
    Enumeration(graph, bounds, count, locations, instants, needed, rows, found).run(0, size);
    return;
  }
  std::vector<std::vector<Placement>> parts(kParts);
  for (std::size_t first = 0; first < size; first += kParts * kFirst) {
    crew.share(kParts, [&](std::size_t part) {
      parts[part].clear();
      const std::function<bool(const Placement&)> keep = [&](const Placement& placement) {
        parts[part].push_back(placement);
        return true;
      };
      const std::size_t begin = first + part * kFirst;
      Enumeration(graph, bounds, count, locations, instants, needed, rows, keep)
          .run(begin, std::min(size, begin + kFirst));
    });
    for (const std::vector<Placement>& part : parts) {
      for (const Placement& placement : part) {
        if (!found(placement)) return;
      }
    }
  }
}

void seed_bounds(LazyState& lazy, const std::vector<int>& locations,
                 const std::vector<int>& instants) {
  const std::vector<int> some = thinned(locations, lazy.count);
  for (const int instant : instants) {
    std::vector<Placement> left;
    for_each_placement(lazy.graph, lazy.bounds, lazy.count, some, {instant}, lazy.min_stability,
                       lazy.crew, [&](const Placement& placement) {
                         left.push_back(placement);
                         return true;
                       });
    const auto& slots = lazy.candidates.instants();
    const auto slot = std::find(slots.begin(), slots.end(), instant);
    double drawn = 0.5;
    int idle = 0;
    for (int round = 0; round < kRounds && !left.empty() && idle < 2; ++round) {
      if (lazy.clock.is_out()) return;
      std::vector<StabilityQuery> queries;
      for (std::size_t i = 0; i < std::min(kEach, left.size()); ++i) {
        drawn = std::fmod(drawn + 0.6180339887498949, 1.0);
        const Placement& placement =
            left[static_cast<std::size_t>(drawn * static_cast<double>(left.size()))];
        const int c = lazy.candidates.open(placement);
        lazy.candidates.request_slot(c, static_cast<int>(slot - slots.begin()), queries);
      }
      if (queries.empty()) break;
      lazy.solve(queries);
      const std::size_t before = left.size();
      const auto refused = [&](const Placement& placement) {
        return static_cast<double>(lazy.bounds.bound(instant, placement)) <
               lazy.graph.options.min_stability;
      };
      left.erase(std::remove_if(left.begin(), left.end(), refused), left.end());
      idle = static_cast<double>(left.size()) > kStagnation * static_cast<double>(before) ? idle + 1
                                                                                          : 0;
    }
  }
}

void link_ends(LazyState& lazy) {
  std::size_t count = 0;
  for (const int arc : {0, lazy.graph.num_arcs() - 1}) {
    const std::vector<int> locations = clear_locations(lazy.graph, arc, arc + 1);
    const std::vector<int> instants = lazy.candidates.instants(arc);
    seed_bounds(lazy, locations, instants);
    for_each_placement(lazy.graph, lazy.bounds, lazy.count, locations, instants, lazy.min_stability,
                       lazy.crew, [&](const Placement& placement) {
                         lazy.hubs.link(placement);
                         if (++count % LazyState::kWatch == 0) lazy.watch_memory();
                         return true;
                       });
  }
  lazy.hubs.rank(lazy.crew);
}

void open_all(LazyState& lazy) {
  lazy.candidates.keep_inner_arcs();
  for (int arc = 0; arc < lazy.graph.num_arcs(); ++arc) {
    for_each_placement(lazy.graph, lazy.bounds, lazy.count,
                       clear_locations(lazy.graph, arc, arc + 1), lazy.candidates.instants(arc),
                       lazy.min_stability, lazy.crew, [&](const Placement& placement) {
                         const int c = lazy.candidates.open(placement);
                         if (static_cast<std::size_t>(c) % LazyState::kWatch == 0) {
                           lazy.watch_memory();
                         }
                         return true;
                       });
  }
  lazy.candidates.refresh_all();
  lazy.hubs.unlink_all();
  for (int c = 0; c < lazy.candidates.size(); ++c) {
    poll();
    lazy.hubs.link(lazy.candidates.placement(c), c);
  }
}

std::vector<int> clear_locations(const PoseGraph& graph, int first, int last) {
  std::vector<int> clear;
  for (int location = 0; location < graph.locations.size(); ++location) {
    poll();
    bool is_clear = true;
    for (int pose = first; pose <= last && is_clear; ++pose) {
      is_clear = graph.is_clear(pose, location);
    }
    if (is_clear) clear.push_back(location);
  }
  return clear;
}

}  // namespace graspless::fingertip
