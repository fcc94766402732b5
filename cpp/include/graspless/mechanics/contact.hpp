// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::mechanics {

using Vector6d = Eigen::Matrix<double, 6, 1>;  ///< wrench or twist, linear part first
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix6Xd = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Physical bounds of all planners' input. Beyond them, rounding errors of the linear programs reach
// the size of the answers.
constexpr double kMinForce = 1e-6;      ///< least force limit [N]
constexpr double kMaxForce = 1e6;       ///< largest force, as limit or load [N]
constexpr double kMinMass = 1e-9;       ///< [kg]
constexpr double kMaxMass = 1e5;        ///< [kg]; it weighs nearly kMaxForce
constexpr double kMaxGravity = 1e3;     ///< largest acceleration [m/s^2]
constexpr double kMaxFriction = 1e4;    ///< largest coefficient of friction
constexpr double kMinDirection = 1e-3;  ///< least length of a disturbance's direction l_i
constexpr double kMaxDirection = 1e3;   ///< its largest length

enum class ContactMode {
  stick,  ///< any force within the friction cone
  slide,  ///< a force on the cone's edge against the motion
};

/// Point contact between the object and its environment.
struct Contact {
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d n_O = Eigen::Vector3d::UnitZ();  ///< into the object, unit
  double friction = 0.5;                           ///< coefficient, in [0, kMaxFriction]
  ContactMode mode = ContactMode::stick;
  /// Direction along the surface, of any length. Sliding: the direction in which the object moves.
  /// Sticking: the direction of the first edge of the friction cone; tangent() chooses one for
  /// zero.
  Eigen::Vector3d t_O = Eigen::Vector3d::Zero();
};

/// Fingertip in one-point contact with the object. It does not slide.
struct Finger {
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d n_O = Eigen::Vector3d::UnitZ();  ///< into the object, unit
  double friction = 0.5;                           ///< coefficient, in [0, kMaxFriction]
  double max_normal_force = 10;                    ///< f_max, in [kMinForce, kMaxForce] [N]
  Eigen::Vector3d t_O = Eigen::Vector3d::Zero();   ///< first edge of the cone; zero: any
};

enum class FingerMode {
  position,  ///< any force within the cone and the limit, as a passive reaction
  force,     ///< a commanded normal force, and any tangential force within the cone
};

/// All contacts of an object at one instant of a quasi-static motion, in the object's frame O.
struct ContactSet {
  std::vector<Contact> contacts;
  std::vector<Finger> fingers;
  Eigen::Vector3d com_O = Eigen::Vector3d::Zero();  ///< centre of mass, origin of moments [m]
  /// Q_known: wrench in O about the centre of mass, such as gravity's [N, N m].
  Vector6d known_wrench_O = Vector6d::Zero();
  /// R^1/2: matrix that scales a wrench in O about the centre of mass before it is measured.
  Matrix6d wrench_scale = Matrix6d::Identity();
  int cone_edges = 6;  ///< s: number of edges of a polyhedral friction cone, 3 to 1000
};

/// Throws std::invalid_argument that names the field and its value, prefixed by `what`. Refused are
/// values that are not finite, friction and forces outside the bounds above, positions beyond
/// geometry::kMaxLength, moments beyond kMaxForce at that distance, normals that are not unit
/// vectors (normalized() corrects those), sliding contacts without a direction along the surface,
/// cones of fewer than three edges, more than kMaxFingers fingers, and a scale that is singular or
/// has values beyond 1e9.
GRASPLESS_API void validate(const ContactSet& set, const std::string& what = "contact set");

/// Returns the set with unit normals. Throws std::invalid_argument for a normal of length zero.
GRASPLESS_API ContactSet normalized(ContactSet set, const std::string& what = "contact set");

constexpr int kMaxFingers = 4;  ///< maximum number of fingers in a contact set

/// Returns a unit tangent at a contact with normal n_O: the part of t_O along the surface. Where
/// that vanishes, the axis after the one on which n_O is longest (in the order x, y, z, x) takes
/// the place of t_O. It is also the first grid axis of a face with this normal.
GRASPLESS_API Eigen::Vector3d tangent(const Eigen::Vector3d& n_O, const Eigen::Vector3d& t_O);

/// Unit edges c_1 ... c_s (3 x s) of the polyhedral cone inscribed in Coulomb's cone. The first
/// edge leans towards `tangent` (unit, normal to n_O); the others follow counter-clockwise about
/// n_O at equal angles.
GRASPLESS_API Eigen::Matrix3Xd friction_cone(const Eigen::Vector3d& n_O, double friction, int edges,
                                             const Eigen::Vector3d& tangent);

/// R^1/2 of Eqs. (7) and (8): forces are kept, moments are divided by sqrt(J_i / M), both along the
/// principal axes of the inertia about the centre of mass [kg m^2]. Where principal axes are not
/// unique, they are chosen nearest to the axes of O. Throws std::invalid_argument unless the mass
/// is positive and the inertia is symmetric, positive definite and fulfils the triangle inequality.
GRASPLESS_API Matrix6d wrench_scale(double mass, const Eigen::Matrix3d& inertia_O);

/// Wrench of gravity on a mass [kg] about its centre, for an acceleration in O [m/s^2]. Throws
/// std::invalid_argument for a mass outside [kMinMass, kMaxMass] or values beyond kMaxGravity.
GRASPLESS_API Vector6d gravity_wrench(double mass, const Eigen::Vector3d& gravity_O);

/// {l_i} (6 x 76): vertices of a polyhedron around the unit sphere in scaled wrench space. They are
/// k times the axes, in both directions, and k/sqrt(6) times the corners of the cube, with k = 2
/// sqrt(3 - sqrt 6). The facets touch the sphere.
GRASPLESS_API Matrix6Xd disturbance_directions();

}  // namespace graspless::mechanics
