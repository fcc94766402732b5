// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places on a motion are numbered by the rows: 3.5 is the middle of the edge from row 3 to row 4.
//
// The law is that of scene_motion.cpp: two bodies that are at least d1 and d2 apart at two places,
// and approach each other by at most M in between, stay at least (d1 + d2 - M) / 2 apart. Where
// that proves nothing, the place in the middle is looked at for the pairs that are left. Between
// two rows this goes on until M is below kFinest: an edge is either proven for every t, or it is
// said that it is not.
#include "scene/edges.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "graspless/watch.hpp"

#include "collision/overlap.hpp"
#include "text.hpp"

namespace graspless::scene {
namespace {

constexpr double kFar = 1e3;  // a motion that is not bounded, without the trouble of infinity [m]
constexpr double kRounded = 1e-9;  // steps between segments that are one configuration [rad or m]
constexpr double kNarrowest = 1.0 / (1 << 24);  // part of an edge; for such motions

}  // namespace

std::string to_string(Verdict verdict) { return planning::name_of(verdict); }

std::string Doubt::text() const {
  const std::string where =
      segment + " row " + std::to_string(row) + ", t = " + figure(t, 3) + " from the row before: ";
  const std::string how_much = figure(amount, 3) + " " + unit;
  return where + condition +
         (verdict == Verdict::refuted ? ", by " + how_much : ", not excluded within " + how_much);
}

std::size_t EdgeCertificate::num_certified() const {
  std::size_t doubted = 0;
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    const bool is_same =
        i > 0 && doubts[i].segment == doubts[i - 1].segment && doubts[i].row == doubts[i - 1].row;
    doubted += doubts[i].row > 0 && !is_same;
  }
  return num_edges - doubted;
}

EdgeProver::EdgeProver(const std::string& segment, const std::vector<Eigen::VectorXd>& rows,
                       Replay& replay, const Companion& companion)
    : segment_(segment),
      rows_(rows),
      replay_(replay),
      world_(replay.world()),
      companion_(companion),
      doubts_(rows.empty() ? 0 : rows.size() - 1) {}

std::vector<Doubt> EdgeProver::run() {
  if (rows_.size() < 2) return {};
  find_motions();
  const Stretch whole = stretch(0, static_cast<double>(rows_.size() - 1));
  open_all(whole);
  prove(whole, 0);
  refute_swallowed();
  std::vector<Doubt> found;
  for (auto& doubt : doubts_) {
    if (doubt) found.push_back(std::move(*doubt));
  }
  return found;
}

/// Looks at both ends, and opens the pairs that may touch in between.
void EdgeProver::open_all(const Stretch& whole) {
  open_.clear();
  for (int i = 0; i < world_.num_pairs(); ++i) open_.push_back({i, 0, 0});
  bound_at(whole.first, &OpenPair::bound_first, 0, [&](const OpenPair& pair) {
    return (motion(pair.index, whole) + kMargin) / 2;  // the other end adds the rest
  });
  // A body that is outside a closed mesh here, and never touches it, stays outside.
  for (const OpenPair& pair : open_) {
    if (world_.swallows(pair.index)) refute(pair.index, whole.first);
  }
  bound_at(whole.last, &OpenPair::bound_last, 0, [&](const OpenPair& pair) {
    return motion(pair.index, whole) + 2 * kMargin - pair.bound_first;
  });
  const auto is_proven = [&](const OpenPair& pair) {
    return pair.bound_first + pair.bound_last > motion(pair.index, whole) + kMargin;
  };
  open_.erase(std::remove_if(open_.begin(), open_.end(), is_proven), open_.end());
}

/// Refutes the edges on which a body is inside a closed mesh that it has entered on a doubted edge:
/// there, nothing touches the surface.
void EdgeProver::refute_swallowed() {
  for (std::size_t edge = 0; edge < doubts_.size(); ++edge) {
    if (!doubts_[edge]) continue;
    const auto end = static_cast<double>(edge + 1);
    place(end);
    for (int i = 0; i < world_.num_pairs(); ++i) {
      if (world_.swallows(i)) refute(i, end);  // the next edge, too
    }
  }
}

bool EdgeProver::has_companion(int pair) const {
  const auto [a, b] = world_.pair(pair);
  return companion_.body >= 0 && (a == companion_.body || b == companion_.body);
}

Eigen::VectorXd EdgeProver::motion_per_joint(int pair) const {
  const auto carrier = [&](int body) -> Carrier {
    if (body == companion_.body && companion_.carrier) return *companion_.carrier;
    if (body >= replay_.num_links()) return {};
    return {replay_.link_of(body), {Eigen::Vector3d::Zero(), world_.radius(body)}};
  };
  const auto [a, b] = world_.pair(pair);
  // A companion on its own way, and an allowance along an axis of the world, do not turn with a
  // link.
  const bool in_world =
      (has_companion(pair) && !companion_.carrier) || !world_.shift(pair).isZero(0);
  return relative_reach(replay_.robot(), carrier(a), carrier(b), in_world);
}

void EdgeProver::find_motions() {
  const auto num_rows = static_cast<Eigen::Index>(rows_.size());
  place(0);  // sets the allowances
  Eigen::MatrixXd per_joint(replay_.robot().dof(), world_.num_pairs());
  for (int i = 0; i < world_.num_pairs(); ++i) per_joint.col(i) = motion_per_joint(i);
  joint_motion_ = Eigen::MatrixXd::Zero(world_.num_pairs(), num_rows);
  companion_motion_.assign(rows_.size(), 0);
  for (Eigen::Index row = 1; row < num_rows; ++row) {
    const auto edge = static_cast<std::size_t>(row - 1);
    joint_motion_.col(row) = joint_motion_.col(row - 1) +
                             per_joint.transpose() * (rows_[edge + 1] - rows_[edge]).cwiseAbs();
    const double alone = companion_.length ? companion_.length(edge, 0, 1) : 0;
    companion_motion_[edge + 1] = companion_motion_[edge] + (alone < kFar ? alone : kFar);
  }
}

EdgeProver::Stretch EdgeProver::stretch(double first, double last) const {
  const double row = std::floor(first);
  if (row == first && std::floor(last) == last) {
    return {first, last,
            companion_motion_[static_cast<std::size_t>(last)] -
                companion_motion_[static_cast<std::size_t>(first)]};
  }
  const double alone =
      companion_.length ? companion_.length(static_cast<std::size_t>(row), first - row, last - row)
                        : 0;
  return {first, last, alone < kFar ? alone : kFar};
}

/// Bound on how far a pair's bodies approach each other on a stretch.
double EdgeProver::motion(int pair, const Stretch& stretch) const {
  const auto row = static_cast<Eigen::Index>(stretch.first);
  const auto end = static_cast<Eigen::Index>(std::ceil(stretch.last));
  const double part = std::min(stretch.last - stretch.first, 1.0);  // of an edge
  const double by_joints = part * (joint_motion_(pair, end) - joint_motion_(pair, row));
  return by_joints + (has_companion(pair) ? stretch.companion : 0);
}

void EdgeProver::place(double where) {
  const auto last = static_cast<double>(rows_.size() - 1);
  const double row = std::min(std::floor(where), last - 1);
  const auto edge = static_cast<std::size_t>(row);
  const double t = where - row;
  replay_.robot().forward(rows_[edge] + t * (rows_[edge + 1] - rows_[edge]), X_WL_);
  replay_.place(X_WL_);
  if (companion_.place) companion_.place(edge, t, X_WL_);
}

/// Writes a lower bound on the distance of the open pairs from `begin` on, with all bodies at a
/// place. Pairs that touch there are refuted.
void EdgeProver::bound_at(double where, double OpenPair::*bound, std::size_t begin,
                          const std::function<double(const OpenPair&)>& enough) {
  place(where);
  for (std::size_t i = begin; i < open_.size(); ++i) {
    OpenPair& pair = open_[i];
    pair.*bound = world_.proven_distance(pair.index, enough(pair));
    if (pair.*bound <= kMargin && world_.touches(pair.index)) refute(pair.index, where);
  }
}

/// True if every edge of a stretch is already known not to be free. On an edge that is undecided,
/// only coarse steps still look for a touch.
bool EdgeProver::is_settled(const Stretch& stretch) const {
  constexpr double kCoarse = 1.0 / 64;
  for (auto edge = static_cast<std::size_t>(stretch.first);
       static_cast<double>(edge) < stretch.last; ++edge) {
    if (!doubts_[edge]) return false;
    const bool is_coarse = stretch.last - stretch.first >= kCoarse;
    if (doubts_[edge]->verdict == Verdict::undecided && is_coarse) return false;
  }
  return true;
}

/// Proves the open pairs from `begin` on, or doubts an edge.
void EdgeProver::prove(const Stretch& whole, std::size_t begin) {
  if (begin == open_.size() || is_settled(whole)) return;
  poll();
  const double half = (whole.first + whole.last) / 2;
  const double middle = whole.last - whole.first > 1 ? std::floor(half) : half;
  const Stretch before = stretch(whole.first, middle), after = stretch(middle, whole.last);
  bound_at(middle, &OpenPair::bound_middle, begin, [&](const OpenPair& pair) {
    return std::max(motion(pair.index, before) - pair.bound_first,
                    motion(pair.index, after) - pair.bound_last) +
           2 * kMargin;
  });
  const std::size_t end = open_.size();
  for (std::size_t i = begin; i < end; ++i) keep(open_[i], after, true);
  const std::size_t first_half = open_.size();
  for (std::size_t i = begin; i < end; ++i) keep(open_[i], before, false);
  prove(before, first_half);
  open_.resize(first_half);
  prove(after, end);
  open_.resize(end);
}

/// Opens a pair for one half of a stretch unless it is proven there, or the half is too small to
/// divide.
void EdgeProver::keep(const OpenPair& pair, const Stretch& half, bool second) {
  const OpenPair kept{pair.index, second ? pair.bound_middle : pair.bound_first,
                      second ? pair.bound_last : pair.bound_middle};
  const double approach = motion(pair.index, half);
  if (kept.bound_first + kept.bound_last > approach + kMargin) return;
  const double width = half.last - half.first;
  if ((width <= 1 && approach <= kFinest) || width < kNarrowest) {
    return doubt(pair.index, (half.first + half.last) / 2,
                 std::max(kept.bound_first, kept.bound_last));
  }
  open_.push_back(kept);
}

void EdgeProver::doubt(int pair, double where, double gap) {
  const auto edge = static_cast<std::size_t>(where);
  if (doubts_[edge]) return;
  doubts_[edge] = Doubt{segment_,
                        edge + 1,
                        where - std::floor(where),
                        Verdict::undecided,
                        "collision " + pair_name(pair),
                        gap};
}

/// Refutes the edge on which a place lies, or both edges that meet there.
void EdgeProver::refute(int pair, double where) {
  const auto [a, b] = world_.pair(pair);
  const double row = std::floor(where);
  const auto last = static_cast<double>(doubts_.size() - 1);
  std::vector<double> edges{std::min(row, last)};
  if (row == where && row > 0 && row <= last) edges.push_back(row - 1);
  for (const double first : edges) {
    auto& known = doubts_[static_cast<std::size_t>(first)];
    if (known && known->verdict == Verdict::refuted) continue;
    known = Doubt{
        segment_,         static_cast<std::size_t>(first) + 1, where - first,
        Verdict::refuted, "collision " + pair_name(pair),      collision::overlap(world_, a, b)};
  }
}

std::string EdgeProver::pair_name(int pair) const {
  const auto [a, b] = world_.pair(pair);
  return world_.name(a) + " - " + world_.name(b);
}

void EdgeCertificateMaker::add(const std::string& segment, const std::vector<Eigen::VectorXd>& rows,
                               std::vector<Doubt> doubts) {
  const double gap = before_.size() > 0 ? (rows.front() - before_).lpNorm<Eigen::Infinity>() : 0;
  if (gap > kRounded) {
    doubts.push_back({segment, 0, 0, Verdict::undecided, "a motion to the first row", gap});
  }
  std::stable_sort(doubts.begin(), doubts.end(),
                   [](const Doubt& a, const Doubt& b) { return a.row < b.row; });
  certificate_.num_edges += rows.size() - 1;
  std::move(doubts.begin(), doubts.end(), std::back_inserter(certificate_.doubts));
  before_ = rows.back();
}

}  // namespace graspless::scene
