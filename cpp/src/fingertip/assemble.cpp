// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a route to a plan: which finger is where, control modes and forces of every sample, the cost
// by its definition.
#include <algorithm>
#include <limits>

#include "graspless/watch.hpp"

#include "fingertip/model/locations.hpp"
#include "fingertip/model/screw.hpp"
#include "fingertip/planner.hpp"
#include "fingertip/row_forces.hpp"

namespace graspless::fingertip {
namespace {

using mechanics::Vector6d;

constexpr double kNoRotation = 1e-9;  // [rad]
constexpr double kParallel = 1e-6;

/// How an arc carries the object.
std::string name_of(const Eigen::Isometry3d& X_WO, const Vector6d& twist_O, const Plane& floor) {
  const Eigen::Vector3d omega_W = X_WO.linear() * twist_O.tail<3>();
  if (omega_W.norm() < kNoRotation) return "slide";
  return omega_W.cross(floor.n_W).norm() <= kParallel * omega_W.norm() ? "turn" : "tumble";
}

class Assembler {
 public:
  Assembler(const Locations& locations, Instants& instants, Evaluator& evaluator, Plan& plan)
      : problem_(instants.problem()),
        options_(instants.options()),
        locations_(locations),
        instants_(instants),
        evaluator_(evaluator),
        plan_(plan),
        yield_{problem_.object.hull(), options_.max_yield} {}

  void run(const std::vector<Stage>& stages) {
    const Placement& first = stages.front().placement;
    slots_ = locations_.start();  // finger by finger, where it is given
    if (slots_.empty()) slots_.assign(first.begin(), first.begin() + num_fingers(first));
    for (std::size_t i = 0; i < stages.size(); ++i) {
      if (i > 0) regrasp(stages, i);
      displace(stages[i]);
    }
    add_forces();
    if (!turns_in_plane_) return;
    plan_.warnings.push_back(
        "a face turns about its normal while it slides: the friction of its corners understates "
        "what the whole face resists, so the object may turn less readily than planned");
  }

 private:
  void displace(const Stage& stage) {
    Segment* segment = nullptr;
    for (std::size_t k = 0; k + 1 < stage.X_WO.size(); ++k) {
      const Eigen::Isometry3d& X_WO = stage.X_WO[k];
      const Vector6d twist_O = screw_between(X_WO, stage.X_WO[k + 1]);
      const std::string name = name_of(X_WO, twist_O, problem_.planes.front());
      if (segment == nullptr || segment->name != name) {
        plan_.segments.emplace_back();
        segment = &plan_.segments.back();
        segment->name = name;
        segment->X_WO.push_back(X_WO);
      }
      add_arc(X_WO, twist_O, *segment);
      segment->X_WO.push_back(stage.X_WO[k + 1]);
    }
  }

  void add_arc(const Eigen::Isometry3d& X_WO, const Vector6d& twist_O, Segment& segment) {
    const int P = options_.samples_per_arc;
    double weight = 0, speed = 0;
    for (int j = 0; j < P; ++j) {
      poll();
      const Eigen::Isometry3d X_WO_j = along_screw(X_WO, twist_O, (j + 0.5) / P);
      segment.rows.push_back(row(moving_state(X_WO_j, twist_O), -1));
      weight += (1 + options_.stability_weight / segment.rows.back().stability) / P;
    }
    for (const int l : slots_) speed = std::max(speed, sphere_speed(twist_O, locations_[l]));
    plan_.cost += speed * weight;  // (9)
  }

  /// The finger that is not where it was moves to the place that is new.
  void regrasp(const std::vector<Stage>& stages, std::size_t i) {
    const Placement& next = stages[i].placement;
    const auto is_new = [&](int l) {
      return std::find(slots_.begin(), slots_.end(), l) == slots_.end();
    };
    const auto moved = std::find_if(slots_.begin(), slots_.end(), [&](int l) {
      return std::find(next.begin(), next.end(), l) == next.end();
    });
    if (moved == slots_.end()) return;
    Segment segment;
    segment.name = "regrasp";
    segment.finger = static_cast<int>(moved - slots_.begin());
    segment.X_WO = {stages[i].X_WO.front()};
    segment.rows = {row(resting_state(segment.X_WO.front(), twist_at(stages, i)), segment.finger)};
    plan_.segments.push_back(std::move(segment));
    plan_.cost += options_.regrasp_cost;  // (10)
    ++plan_.regrasps;
    *moved = *std::find_if(next.begin(), next.end(), is_new);
  }

  /// The motion that goes on after stage i begins. No route ends with a regrasp.
  static Vector6d twist_at(const std::vector<Stage>& stages, std::size_t i) {
    while (stages.at(i).X_WO.size() < 2) ++i;
    return screw_between(stages[i].X_WO[0], stages[i].X_WO[1]);
  }

  /// One sample without its forces, with finger `lifted` off the object (-1: none).
  Row row(const mechanics::BodyState& state, int lifted) {
    const int instant = instants_.add(state);
    if (instant != last_instant_ || lifted != last_lifted_ || slots_ != last_slots_) {
      last_ = make_row(instant, lifted);
      last_instant_ = instant;
      last_lifted_ = lifted;
      last_slots_ = slots_;
    }
    last_.X_WO = state.X_WO;
    contacts_of_row_.push_back(contacts_.size() - 1);
    return last_;
  }

  Row make_row(int instant, int lifted) {
    std::vector<int> fingers, at;
    std::vector<FingerMode> previous;
    for (int i = 0; i < static_cast<int>(slots_.size()); ++i) {
      if (i == lifted) continue;
      fingers.push_back(i);
      at.push_back(slots_[i]);
      if (!modes_.empty()) previous.push_back(modes_[i]);
    }
    turns_in_plane_ = turns_in_plane_ || instants_[instant].turns_in_plane;
    contacts_.push_back({contact_set(instants_[instant], locations_, problem_.fingers, at),
                         evaluator_.control_modes(instant, at, previous)});
    const mechanics::ControlModes& best = contacts_.back().best;
    if (best.modes.size() != fingers.size()) {
      throw std::logic_error("no modes of the fingers hold a row that the search called stable");
    }
    Row row;
    row.stability = best.stability.z;
    modes_.resize(slots_.size(), FingerMode::position);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      row.fingers.push_back(standing_at(locations_[slots_[i]]));
    }
    if (lifted >= 0) row.fingers[lifted].touches = false;
    for (std::size_t k = 0; k < fingers.size(); ++k) {
      const auto i = static_cast<std::size_t>(fingers[k]);
      const auto column = static_cast<Eigen::Index>(k);
      modes_[i] = row.fingers[i].mode = best.modes[k];
      row.fingers[i].commanded_force = best.stability.commanded_forces[column];
    }
    return row;
  }

  /// Nominal forces of all rows, and what they withstand.
  void add_forces() {
    const std::vector<RowForces> all = forces_of(contacts_, options_, yield_);
    std::size_t next = 0;
    for (Segment& segment : plan_.segments) {
      for (Row& row : segment.rows) set_forces(all[contacts_of_row_[next++]], row);
    }
  }

  static void set_forces(const RowForces& forces, Row& row) {
    if (!forces.nominal) return;
    row.nominal_margin = forces.nominal->margin;
    row.compliant_stability = forces.compliant_stability;
    row.withstands = forces.promise.withstands;
    row.place_tolerance = forces.promise.place_tolerance;
    Eigen::Index column = 0;
    for (FingerState& finger : row.fingers) {
      if (finger.touches) finger.nominal_force_O = forces.nominal->finger_forces_O.col(column++);
    }
  }

  static FingerState standing_at(const Location& location) {
    FingerState state;
    state.p_OC = location.p_OC;
    state.n_O = location.n_O;
    return state;
  }

  const Problem& problem_;
  const Options& options_;
  const Locations& locations_;
  Instants& instants_;
  Evaluator& evaluator_;
  Plan& plan_;
  mechanics::Yield yield_;
  std::vector<int> slots_;         // where each finger is
  std::vector<FingerMode> modes_;  // of each finger in the row before
  std::vector<RowContacts> contacts_;
  std::vector<std::size_t> contacts_of_row_;  // in the order of the rows
  // Rows of equal mechanics are equal but for the pose.
  Row last_;
  int last_instant_ = -1, last_lifted_ = -1;
  std::vector<int> last_slots_;
  bool turns_in_plane_ = false;
};

/// Nominal forces follow the object's turns from row to row. Beyond the first and the last row of a
/// segment they stay as they are in O, where gravity goes on turning: that takes from the margins.
void subtract_drift(const Problem& problem, Plan& plan) {
  const double mass = problem.object.mass();
  const auto drift = [&](const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    return mass * ((a.linear() - b.linear()).transpose() * problem.gravity_W).norm();
  };
  const auto subtract = [](double change, Row& row) {
    const double left = std::max(0.0, row.withstands - change);
    if (row.withstands > 0) row.place_tolerance *= left / row.withstands;
    row.withstands = left;
  };
  for (Segment& segment : plan.segments) {
    if (segment.finger >= 0) continue;
    Row &first = segment.rows.front(), &last = segment.rows.back();
    const double before = drift(first.X_WO, segment.X_WO.front());
    const double after = drift(last.X_WO, segment.X_WO.back());
    subtract(before, first);
    subtract(after, last);
  }
}

void find_weakest(Plan& plan) {
  double least = std::numeric_limits<double>::infinity();
  plan.withstands = plan.place_tolerance = least;
  for (std::size_t s = 0; s < plan.segments.size(); ++s) {
    for (std::size_t r = 0; r < plan.segments[s].rows.size(); ++r) {
      const Row& row = plan.segments[s].rows[r];
      plan.withstands = std::min(plan.withstands, row.withstands);
      plan.place_tolerance = std::min(plan.place_tolerance, row.place_tolerance);
      if (!(row.stability < least)) continue;
      least = row.stability;
      plan.weakest_segment = static_cast<int>(s);
      plan.weakest_row = static_cast<int>(r);
    }
  }
}

/// The plan holds while the fingers are on the object. At its ends they are not.
void warn_of_falling(const Problem& problem, const std::vector<Stage>& stages, Plan& plan) {
  const auto warn = [&](const Eigen::Isometry3d& X_WO, const std::string& pose,
                        const std::string& until) {
    if (stands_alone(problem, X_WO)) return;
    plan.warnings.push_back("the object does not stay at the " + pose +
                            " pose by itself: without fingers, floor and walls cannot balance its "
                            "weight there; let something hold it " +
                            until);
  };
  if (problem.fingers.start.empty()) {  // else they are there already
    warn(stages.front().X_WO.front(), "first", "until the fingers press");
  }
  warn(stages.back().X_WO.back(), "last", "before the fingers leave");
}

}  // namespace

std::vector<Stage> stages_of(const PoseGraph& graph, const Route& route) {
  std::vector<Stage> stages;
  for (const Node& node : route.nodes) {
    if (stages.empty() || stages.back().placement != node.placement) {
      stages.push_back({node.placement, {}});
    }
    stages.back().X_WO.push_back(graph.X_WO(node.pose));
  }
  return stages;
}

void assemble(const std::vector<Stage>& stages, const Locations& locations, Instants& instants,
              Evaluator& evaluator, Plan& plan) {
  plan.cost = 0;
  plan.regrasps = 0;
  plan.segments.clear();
  Assembler(locations, instants, evaluator, plan).run(stages);
  subtract_drift(instants.problem(), plan);
  find_weakest(plan);
  warn_of_falling(instants.problem(), stages, plan);
}

}  // namespace graspless::fingertip
