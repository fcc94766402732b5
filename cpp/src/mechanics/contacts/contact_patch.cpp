// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Contacts of a polyhedron with planes, as points that stick or slide.
#include "graspless/mechanics/contact_patch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/geometry/shape.hpp"

#include "geometry/require_points.hpp"
#include "mechanics/contacts/patch_corners.hpp"
#include "text.hpp"

namespace graspless::mechanics {
namespace {

// Speeds below this fraction of the motion's own are rounding errors.
constexpr double kStill = 1e-9;

std::string text(const Eigen::Vector3d& v) {
  // Clears -0 and rounding errors.
  const auto clean = [](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; };
  std::ostringstream out;
  out << "(" << clean(v.x()) << ", " << clean(v.y()) << ", " << clean(v.z()) << ")";
  return out.str();
}

void validate_plane(const Plane& plane, const std::string& what) {
  require(plane.n_W.allFinite() && std::abs(plane.n_W.norm() - 1) <= 1e-6, what + ".n_W",
          plane.n_W.norm(), "must be of length 1");
  require_within(what + ".offset", plane.offset, -geometry::kMaxLength, geometry::kMaxLength, " m");
  require_within(what + ".friction", plane.friction, 0, kMaxFriction);
}

void validate_arguments(const Eigen::Matrix3Xd& vertices_O, const Eigen::Vector3d& com_O,
                        const std::vector<Plane>& planes, const BodyState& state,
                        double tolerance) {
  require(vertices_O.cols() > 0, "vertices_O", 0, "must hold at least one vertex");
  geometry::require_points(vertices_O, "vertices_O");
  geometry::require_points(com_O, "com_O");
  for (std::size_t i = 0; i < planes.size(); ++i) {
    validate_plane(planes[i], "planes[" + std::to_string(i) + "]");
  }
  geometry::require_pose(state.X_WO, "state.X_WO");
  if (!state.twist_W.allFinite()) throw std::invalid_argument("state.twist_W must be finite");
  require_within("tolerance", tolerance, 0, geometry::kMaxLength, " m");
}

/// Motion of the object in W, and the speed below which one of its points stands still.
struct Motion {
  Motion(const Eigen::Matrix3Xd& vertices_O, const Eigen::Vector3d& com_O, const BodyState& state,
         double tolerance)
      : at_rest(state.at_rest),
        R_WO(state.X_WO.linear()),
        p_WO(state.X_WO.translation()),
        v(state.twist_W.head<3>()),
        omega(state.twist_W.tail<3>()),
        p_WV(state.X_WO * vertices_O) {
    v_com = velocity(state.X_WO * com_O);
    const double size = (vertices_O.colwise() - com_O).colwise().norm().maxCoeff();
    // A point that touches only within the tolerance may be that far from its axis of rotation.
    still = kStill * (v_com.norm() + omega.norm() * size) + tolerance * omega.norm();
    turns = omega.norm() * size > kStill * v_com.norm();
  }
  Eigen::Vector3d velocity(const Eigen::Vector3d& p_W) const { return v + omega.cross(p_W - p_WO); }
  /// Returns the direction, in O, of a velocity along a plane. Zero if the point stands still.
  Eigen::Vector3d along_O(const Eigen::Vector3d& n_W, const Eigen::Vector3d& velocity_W) const {
    const Eigen::Vector3d t_W = velocity_W - n_W.dot(velocity_W) * n_W;
    if (!(t_W.norm() > still)) return Eigen::Vector3d::Zero();
    return R_WO.transpose() * t_W.normalized();
  }

  bool at_rest, turns = false;
  Eigen::Matrix3d R_WO;
  Eigen::Vector3d p_WO, v, omega, v_com;
  Eigen::Matrix3Xd p_WV;
  double still = 0;
};

/// Describes the fault of a vertex that would move into the plane.
std::string entering(const Motion& motion, const Plane& plane, std::size_t touching,
                     const Eigen::Vector3d& p_W) {
  const std::string where =
      "the vertex at " + text(p_W) + " would move into plane '" + plane.name + "'";
  if (!motion.turns || touching == 1) return where;
  const char* what = touching == 2 ? "the edge" : "the face";
  return std::string(what) + " on plane '" + plane.name + "' cannot turn about the axis " +
         text(motion.omega.normalized()) + ": " + where;
}

/// Returns the vertices that touch a plane and do not leave it. Sets `fault` if one enters it.
std::vector<int> touching(const Motion& motion, const Plane& plane, double tolerance,
                          std::string* fault) {
  std::vector<int> touch;
  for (int i = 0; i < static_cast<int>(motion.p_WV.cols()); ++i) {
    const double height = plane.n_W.dot(motion.p_WV.col(i)) - plane.offset;
    if (height <= tolerance) touch.push_back(i);
    if (height < -tolerance && fault->empty()) {
      *fault = "the vertex at " + text(motion.p_WV.col(i)) + " lies " + figure(-height) +
               " m inside plane '" + plane.name + "'";
    }
  }
  if (motion.at_rest) return touch;
  std::vector<int> remain;
  for (const int i : touch) {
    const double rising = plane.n_W.dot(motion.velocity(motion.p_WV.col(i)));
    if (rising <= motion.still) remain.push_back(i);
    if (rising < -motion.still && fault->empty()) {
      *fault = entering(motion, plane, touch.size(), motion.p_WV.col(i));
    }
  }
  return remain;
}

/// Returns those of `vertices` that are corners of their hull in the plane.
std::vector<int> corners(const Motion& motion, const Plane& plane, const std::vector<int>& vertices,
                         double tolerance) {
  const Eigen::Vector3d t_W = tangent(plane.n_W, Eigen::Vector3d::Zero());
  Eigen::Matrix<double, 2, 3> P;
  P << t_W.transpose(), plane.n_W.cross(t_W).transpose();
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    points.col(k) = P * (motion.p_WV.col(vertices[k]) - motion.p_WO);
  }
  std::vector<int> kept = patch_corners(points, tolerance);
  for (int& k : kept) k = vertices[k];
  return kept;
}

Contact contact(const Motion& motion, const Plane& plane, const Eigen::Matrix3Xd& vertices_O,
                int vertex) {
  Contact contact;
  contact.p_OC = vertices_O.col(vertex);
  contact.n_O = motion.R_WO.transpose() * plane.n_W;
  contact.friction = plane.friction;
  contact.t_O = motion.along_O(plane.n_W, motion.velocity(motion.p_WV.col(vertex)));
  const bool slides = !motion.at_rest && !contact.t_O.isZero(0);
  contact.mode = slides ? ContactMode::slide : ContactMode::stick;
  if (!slides) contact.t_O = motion.along_O(plane.n_W, motion.v_com);
  return contact;
}

/// Describes the fault of an edge that turns about another axis than itself: its two ends then do
/// not represent the points between them.
std::string edge_fault(const Motion& motion, const Plane& plane, const std::vector<int>& patch) {
  if (motion.at_rest || !motion.turns || patch.size() != 2) return "";
  const Eigen::Vector3d along = motion.p_WV.col(patch[1]) - motion.p_WV.col(patch[0]);
  // This is the difference of the ends' velocities, each of which is known to within `still`.
  if (motion.omega.cross(along).norm() <= 2 * motion.still) return "";
  return "the edge along " + text(along.normalized()) + " on plane '" + plane.name +
         "' cannot turn about the axis " + text(motion.omega.normalized()) +
         ": its two ends do not stand for it";
}

}  // namespace

ContactPatches contact_patches(const Eigen::Matrix3Xd& vertices_O, const Eigen::Vector3d& com_O,
                               const std::vector<Plane>& planes, const BodyState& state,
                               double tolerance) {
  validate_arguments(vertices_O, com_O, planes, state, tolerance);
  const Motion motion(vertices_O, com_O, state, tolerance);
  ContactPatches patches;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i];
    const std::vector<int> touch = touching(motion, plane, tolerance, &patches.fault);
    const std::vector<int> patch = corners(motion, plane, touch, tolerance);
    if (patches.fault.empty()) patches.fault = edge_fault(motion, plane, patch);
    for (const int vertex : patch) {
      patches.contacts.push_back(contact(motion, plane, vertices_O, vertex));
      patches.plane.push_back(static_cast<int>(i));
    }
    // A face that still touches turns about its normal, or not at all.
    if (patch.size() > 2 && motion.turns && !motion.at_rest) patches.turns_in_plane = true;
  }
  return patches;
}

}  // namespace graspless::mechanics
