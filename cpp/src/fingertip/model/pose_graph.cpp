// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Poses and arcs of a path, and what is the same for paths and lattices.
#include "fingertip/model/pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "graspless/watch.hpp"

#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

/// Adds a state's instant; names the pose if that is refused.
int add_at(Instants& instants, const mechanics::BodyState& state, std::size_t pose,
           const char* where) {
  try {
    return instants.add(state);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + " (" + where + " pose " +
                                std::to_string(pose) + ")");
  }
}

/// One instant stands for all samples that are the same.
void merge(std::vector<int>& instants) {
  const auto count = std::count(instants.begin(), instants.end(), instants.front());
  if (count == static_cast<std::ptrdiff_t>(instants.size())) instants.resize(1);
}

enum class Touch { nothing, wall, inside_wall };

/// How the object meets the walls; it touches the floor everywhere.
Touch touch_walls(const Problem& problem, const Eigen::Isometry3d& X_WO) {
  const double tolerance = kContactTolerance * problem.object.size();
  Touch found = Touch::nothing;
  for (std::size_t i = 1; i < problem.planes.size(); ++i) {
    const Plane& plane = problem.planes[i];
    const Eigen::RowVector3d n_O = plane.n_W.transpose() * X_WO.linear();
    const double height =
        (n_O * problem.object.hull()).minCoeff() + plane.n_W.dot(X_WO.translation()) - plane.offset;
    if (height < -tolerance) return Touch::inside_wall;
    if (height <= tolerance) found = Touch::wall;
  }
  return found;
}

}  // namespace

bool is_level(const Problem& problem) {
  constexpr double kLevel = 1e-9;
  const Eigen::Vector3d& g_W = problem.gravity_W;
  return g_W.cross(problem.planes.front().n_W).norm() <= kLevel * g_W.norm();
}

PoseGraph::PoseGraph(const Problem& problem, const Path& path, const Locations& locations_in,
                     Instants& instants, const Options& options_in)
    : options(options_in),
      locations(locations_in),
      num_fingers(problem.fingers.count),
      problem_(problem),
      instants_(instants),
      num_locations_(locations_in.size()),
      goal_(static_cast<int>(path.X_WO.size()) - 1),
      X_WO_(path.X_WO),
      clearance_(problem) {
  const int P = options.samples_per_arc;
  for (std::size_t i = 0; i + 1 < X_WO_.size(); ++i) {
    add_motion(screw_between(X_WO_[i], X_WO_[i + 1]));
    std::vector<int> samples;
    for (int j = 0; j < P; ++j) {
      const Eigen::Isometry3d X_WO_j = along_screw(X_WO_[i], twist_O_[i], (j + 0.5) / P);
      samples.push_back(add_at(instants, moving_state(X_WO_j, twist_O_[i]), i, "after"));
    }
    merge(samples);
    kinds_.push_back(std::move(samples));
  }
  for (std::size_t i = 0; i < X_WO_.size(); ++i) {
    const bool is_last = i + 1 == X_WO_.size();
    const mechanics::Vector6d& twist = twist_O_[i - (is_last ? 1 : 0)];
    rest_.push_back(add_at(instants, resting_state(X_WO_[i], twist), i, "at"));
    turns_.push_back(static_cast<int>(i));
    kinds_of_.push_back(is_last ? -1 : static_cast<int>(i));
    next_.push_back(is_last ? -1 : static_cast<int>(i) + 1);
  }
  free_.assign(X_WO_.size(), 1);  // or validate() would have refused the path
  make_clearance_table();
  keep_to_start();
}

void PoseGraph::make_clearance_table() {
  constexpr std::size_t kPart = 1 << 20;  // bytes between two polls
  const std::size_t count = X_WO_.size() * num_locations_;
  clear_.reserve(count);
  while (clear_.size() < count) {
    poll();
    clear_.resize(std::min(count, clear_.size() + kPart), -1);
  }
}

/// Where the fingers are given at the start, no other location can be used there.
void PoseGraph::keep_to_start() {
  const std::vector<int>& start = locations.start();
  for (int l = 0; !start.empty() && l < locations.size(); ++l) {
    if (std::find(start.begin(), start.end(), l) == start.end()) block(start_, l);
  }
}

void PoseGraph::add_motion(const mechanics::Vector6d& twist_O) {
  twist_O_.push_back(twist_O);
  poll();
  for (int l = 0; l < locations.size(); ++l) {
    displacements_.push_back(sphere_speed(twist_O, locations[l]) / options.samples_per_arc);
  }
}

int PoseGraph::instant(int arc, int sample) const {
  const std::vector<int>& samples = instants(arc);
  return samples[samples.size() == 1 ? 0 : sample];
}

int PoseGraph::rest_instant(int pose) const {
  int& known = rest_[pose];
  if (known == kUnknown) {
    known = instants_.add(resting_state(X_WO(pose), mechanics::Vector6d::Zero()));
  }
  return known;
}

int PoseGraph::rest_instant(int pose, int next_pose) const {
  if (is_path()) return rest_instant(pose);
  return instants_.add(resting_state(X_WO(pose), screw_between(X_WO(pose), X_WO(next_pose))));
}

void PoseGraph::block(int pose, int location) { clear_[pose * num_locations_ + location] = 0; }

bool PoseGraph::is_arc_clear(int pose, int move, int location) const {
  return clearance_.is_off_obstacles_along(X_WO(pose), twist_O_[motion(pose, move)],
                                           locations[location].center_O, options.samples_per_arc);
}

bool PoseGraph::is_free(int pose) const {
  std::int8_t& known = free_[pose];
  if (known < 0) {
    const bool is_inside = touch_walls(problem_, X_WO(pose)) == Touch::inside_wall;
    known = !is_inside && clearance_.obstacle_at(X_WO(pose)).empty() ? 1 : 0;
  }
  return known != 0;
}

int PoseGraph::find_kind(int pose, int move) const {
  const int to = next(pose, move);
  if (to < 0 || !is_free(pose) || !is_free(to)) return -1;
  const mechanics::Vector6d& twist = twist_O_[motion(pose, move)];
  const int P = options.samples_per_arc;
  if (!clearance_.obstacle_along(X_WO(pose), twist, P).empty()) return -1;
  std::vector<mechanics::BodyState> states;
  bool touches = false;
  for (int j = 0; j < P; ++j) {
    const Eigen::Isometry3d X_WO_j = along_screw(X_WO(pose), twist, (j + 0.5) / P);
    const Touch found = touch_walls(problem_, X_WO_j);
    if (found == Touch::inside_wall) return -1;
    touches = touches || found == Touch::wall;
    states.push_back(moving_state(X_WO_j, twist));
  }
  if (touches) return add_kind(states);
  int& on_floor = floor_kinds_[motion(pose, move)];
  if (on_floor == kUnknown) {
    if (is_level(problem_)) states.resize(1);  // mechanics stay the same
    on_floor = add_kind(states);
  }
  return on_floor;
}

/// The kind with these samples; -1 if points cannot stand for their contacts, or the object would
/// enter a wall.
int PoseGraph::add_kind(const std::vector<mechanics::BodyState>& states) const {
  std::vector<int> samples;
  try {
    for (const auto& state : states) samples.push_back(instants_.add(state));
  } catch (const std::invalid_argument&) {
    return -1;
  }
  merge(samples);
  kinds_.push_back(std::move(samples));
  return num_kinds() - 1;
}

std::int64_t PoseGraph::memory() const {
  return static_cast<std::int64_t>(X_WO_.size() * (sizeof(Eigen::Isometry3d) + sizeof(int)) +
                                   (kinds_of_.size() + next_.size()) * sizeof(int) + clear_.size() +
                                   displacements_.size() * sizeof(double));
}

bool is_feasible(const PoseGraph& graph, int pose, const Placement& placement) {
  const int count = num_fingers(placement);
  for (int i = 0; i < count; ++i) {
    const int a = placement[i];
    if (!graph.is_clear(pose, a)) return false;
    for (int j = 0; j < i; ++j) {
      if (!graph.locations.are_apart(a, placement[j])) return false;
    }
  }
  return true;
}

bool is_arc_clear(const PoseGraph& graph, int pose, int move, const Placement& placement) {
  return std::all_of(placement.begin(), placement.begin() + num_fingers(placement),
                     [&](int location) { return graph.is_arc_clear(pose, move, location); });
}

bool has_room(const PoseGraph& graph, int pose, const Placement& placement, int location) {
  if (!graph.is_clear(pose, location)) return false;
  return std::none_of(placement.begin(), placement.end(), [&](int other) {
    return other >= 0 && (other == location || !graph.locations.are_apart(other, location));
  });
}

double displacement(const PoseGraph& graph, int motion, const Placement& placement) {
  double most = 0;
  for (const std::int32_t location : placement) {
    if (location < 0) break;
    most = std::max(most, graph.displacement(motion, location));
  }
  return most;
}

double arc_weight(const PoseGraph& graph, const std::vector<double>& z) {
  double weight = 0;
  for (int j = 0; j < graph.options.samples_per_arc; ++j) {
    const double z_j = z[z.size() == 1 ? 0 : static_cast<std::size_t>(j)];
    if (!(z_j > 0)) return std::numeric_limits<double>::infinity();
    weight += 1 + graph.options.stability_weight / z_j;
  }
  return weight;
}

double arc_cost(const PoseGraph& graph, int motion, const Placement& placement,
                const std::vector<double>& z) {
  const double weight = arc_weight(graph, z);
  if (!std::isfinite(weight)) return weight;
  return displacement(graph, motion, placement) * weight;  // (9): every finger moves evenly
}

int num_regrasps(const Route& route) {
  int count = 0;
  for (std::size_t i = 1; i < route.nodes.size(); ++i) {
    if (route.nodes[i].pose == route.nodes[i - 1].pose) ++count;
  }
  return count;
}

}  // namespace graspless::fingertip
