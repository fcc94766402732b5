// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The graph of contact states: faces of the convex hull, joined by the edges between them.
#include "fingertip/goal/contact_states.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "graspless/watch.hpp"

#include "fingertip/model/mesh.hpp"
#include "geometry/convex_hull.hpp"

namespace graspless::fingertip {
namespace {

// Least distance of the centre of mass from the edges of a face to count as over it, by the
// object's size.
constexpr double kTipping = 1e-6;

/// The face of each triangle.
std::vector<int> face_of_triangles(const std::vector<Face>& faces, Eigen::Index triangles) {
  std::vector<int> owner(triangles, -1);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const int t : faces[i].triangles) owner[t] = static_cast<int>(i);
  }
  return owner;
}

TumbleEdge edge_between(const Face& from, const Face& to, int to_index,
                        const Eigen::Vector3d& p_O) {
  // The rotation from the outward normal of `to` to that of `from` brings `to` down.
  const Eigen::Vector3d across = to.n_O.cross(from.n_O);
  return {to_index, p_O, across.normalized(), std::atan2(across.norm(), to.n_O.dot(from.n_O))};
}

bool has_edge_to(const ContactState& state, int face) {
  return std::any_of(state.edges.begin(), state.edges.end(),
                     [&](const TumbleEdge& edge) { return edge.to == face; });
}

}  // namespace

ContactStates::ContactStates(const Object& object) {
  const geometry::Mesh hull = geometry::convex_hull(object.hull());
  const std::vector<Face> faces = find_faces(hull, object.size());
  corners_O_ = hull.vertices;
  for (const Face& face : faces) all_.push_back({face.n_O, face.offset, true, {}});

  const std::vector<int> owner = face_of_triangles(faces, hull.triangles.cols());
  std::map<std::pair<int, int>, int> sides;  // directed edge of the mesh -> face to its left
  for (Eigen::Index t = 0; t < hull.triangles.cols(); ++t) {
    poll();
    for (int k = 0; k < 3; ++k) {
      sides[{hull.triangles(k, t), hull.triangles((k + 1) % 3, t)}] = owner[t];
    }
  }
  for (const auto& [ends, from] : sides) {
    const auto reverse = sides.find({ends.second, ends.first});
    if (from < 0 || reverse == sides.end()) continue;
    const int to = reverse->second;
    if (to < 0 || to == from) continue;
    ContactState& state = all_[from];
    const Eigen::Vector3d a = corners_O_.col(ends.first), b = corners_O_.col(ends.second);
    // Seen from outside, the face lies to the left of its edges.
    const Eigen::Vector3d inward = (-state.n_O).cross((b - a).normalized());
    if (inward.dot(object.com() - a) <= kTipping * object.size()) state.is_stable = false;
    if (has_edge_to(state, to)) continue;  // an edge in pieces
    state.edges.push_back(edge_between(faces[from], faces[to], to, a));
  }
}

int ContactStates::standing(const Eigen::Isometry3d& X_WO, const Plane& plane,
                            double tolerance) const {
  const Eigen::VectorXd heights =
      (plane.n_W.transpose() * (X_WO * corners_O_)).transpose().array() - plane.offset;
  const double reach = corners_O_.cwiseAbs().maxCoeff() + tolerance;
  for (int i = 0; i < size(); ++i) {
    poll();
    const ContactState& state = (*this)[i];
    const Eigen::Vector3d n_W = X_WO.linear() * state.n_O;
    if (n_W.dot(plane.n_W) < 0.99 || heights.minCoeff() < -tolerance) continue;
    // Every corner of the face must be down.
    bool is_down = true;
    for (Eigen::Index k = 0; k < corners_O_.cols() && is_down; ++k) {
      const double within = state.n_O.dot(corners_O_.col(k)) - state.offset;
      if (within <= 1e-6 * reach) is_down = heights[k] <= tolerance;
    }
    if (is_down) return i;
  }
  return -1;
}

std::vector<int> ContactStates::tumbles_to(int goal) const {
  std::vector<int> tumbles(all_.size(), -1);
  tumbles[goal] = 0;
  std::vector<int> queue{goal};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    // Edges lead both ways.
    for (const TumbleEdge& edge : (*this)[queue[next]].edges) {
      int& count = tumbles[edge.to];
      if (count >= 0) continue;
      count = tumbles[queue[next]] + 1;
      queue.push_back(edge.to);
    }
  }
  return tumbles;
}

namespace {

struct Enumeration {
  const ContactStates& states;
  std::vector<int> left;  // tumbles needed from each face
  std::size_t limit;
  TumbleSequence current;
  std::vector<TumbleSequence> found;

  void extend(int before, int face, int tumbles) {
    const int needed = left[face];
    if (needed < 0 || needed > tumbles || found.size() >= limit) return;
    if (tumbles == 0) found.push_back(current);
    for (const TumbleEdge& edge : states[face].edges) {
      poll();
      if (tumbles == 0 || edge.to == before) continue;
      current.push_back(&edge);
      extend(face, edge.to, tumbles - 1);
      current.pop_back();
    }
  }
};

}  // namespace

std::vector<TumbleSequence> tumble_sequences(const ContactStates& states, int from, int to,
                                             int tumbles, int limit) {
  Enumeration all{states, states.tumbles_to(to), static_cast<std::size_t>(limit), {}, {}};
  all.extend(-1, from, tumbles);
  return all.found;
}

Eigen::Isometry3d tumbled(const Eigen::Isometry3d& X_WO, const TumbleEdge& edge) {
  return X_WO * Eigen::Translation3d(edge.p_O) * Eigen::AngleAxisd(edge.angle, edge.axis_O) *
         Eigen::Translation3d(-edge.p_O);
}

}  // namespace graspless::fingertip
