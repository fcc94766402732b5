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

enum class ContactMode {
  stick,  ///< any force within the friction cone
  slide,  ///< a force on the cone's edge against the motion
};

/// A point where the object touches its environment.
struct Contact {
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d n_O = Eigen::Vector3d::UnitZ();  ///< into the object, unit
  double friction = 0.5;                           ///< coefficient
  ContactMode mode = ContactMode::stick;
  /// Along the surface, of any length. Sliding: where the object moves to there. Sticking: the
  /// direction of the cone's first edge; zero leaves the choice to tangent().
  Eigen::Vector3d t_O = Eigen::Vector3d::Zero();
};

/// A fingertip in one-point contact with the object; it does not slide.
struct Finger {
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d n_O = Eigen::Vector3d::UnitZ();  ///< into the object, unit
  double friction = 0.5;                           ///< coefficient
  double max_normal_force = 10;                    ///< f_max [N]
  Eigen::Vector3d t_O = Eigen::Vector3d::Zero();   ///< the cone's first edge; zero: any
};

enum class FingerMode {
  position,  ///< any force within cone and limit, passively
  force,     ///< a commanded normal force, any tangential one within the cone
};

/// All that touches an object at one instant of a quasi-static motion, in the object's frame O.
struct ContactSet {
  std::vector<Contact> contacts;
  std::vector<Finger> fingers;
  Eigen::Vector3d com_O = Eigen::Vector3d::Zero();  ///< moments are taken about it [m]
  /// Q_known: a wrench in O about the centre of mass, such as gravity's [N, N m].
  Vector6d known_wrench_O = Vector6d::Zero();
  /// R^1/2: what a wrench in O about the centre of mass is multiplied with to be measured.
  Matrix6d wrench_scale = Matrix6d::Identity();
  int cone_edges = 6;  ///< s
};

/// Throws std::invalid_argument that names the field and its value, prefixed by `what`: values that
/// are not finite, friction or force limits that are not positive, a normal that is not a unit one
/// (normalized() mends those), a slide without a direction along the surface, fewer than three
/// edges in a cone, more than kMaxFingers fingers, a scale that is not regular.
GRASPLESS_API void validate(const ContactSet& set, const std::string& what = "contact set");

/// The same set with unit normals. Throws std::invalid_argument on one without a direction.
GRASPLESS_API ContactSet normalized(ContactSet set, const std::string& what = "contact set");

constexpr int kMaxFingers = 4;

/// A unit tangent at a contact with normal n_O: t_O without its normal part; when that vanishes,
/// the grid axis of a face with this normal: with a the axis on which n_O is longest, the next one
/// in the order x, y, z, x, without its normal part.
GRASPLESS_API Eigen::Vector3d tangent(const Eigen::Vector3d& n_O, const Eigen::Vector3d& t_O);

/// Unit edges c_1 ... c_s (3 x s) of the polyhedral cone inscribed in Coulomb's; the first lies
/// over `tangent` (unit, normal to n_O), the others follow counter-clockwise about n_O at equal
/// angles.
GRASPLESS_API Eigen::Matrix3Xd friction_cone(const Eigen::Vector3d& n_O, double friction, int edges,
                                             const Eigen::Vector3d& tangent);

/// R^1/2 of Eqs. (7) and (8): forces as they are, moments divided by sqrt(J_i / M), both along the
/// principal axes of the inertia about the centre of mass [kg m^2]. Where the inertia leaves axes
/// free, those of O are kept. Throws std::invalid_argument unless the mass is positive and the
/// inertia symmetric positive definite with the triangle inequality.
GRASPLESS_API Matrix6d wrench_scale(double mass, const Eigen::Matrix3d& inertia_O);

/// Gravity's wrench on a mass [kg], for an acceleration in O [m/s^2].
GRASPLESS_API Vector6d gravity_wrench(double mass, const Eigen::Vector3d& gravity_O);

/// {l_i}: vertices of a polyhedron about the unit sphere in scaled wrench space (6 x 76): k times
/// the axes and k/sqrt(6) times the corners of the cube, k = 2 sqrt(3 - sqrt 6). Its facets touch
/// the sphere.
GRASPLESS_API Matrix6Xd disturbance_directions();

}  // namespace graspless::mechanics
