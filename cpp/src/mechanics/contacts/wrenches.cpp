// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Columns of Eq. (3), scaled: wrenches of the edges of all cones.
#include "mechanics/contacts/wrenches.hpp"

#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "mechanics/contacts/cones.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kNoise = 1e-12;  // relative size below which a component is a rounding error

/// R^1/2 W C of edges at one point. Rounding errors are cleared, since they would act like a lever.
Matrix6Xd wrenches(const ContactSet& set, const Eigen::Vector3d& p_OC,
                   const Eigen::Matrix3Xd& edges) {
  const Eigen::Vector3d lever = p_OC - set.com_O;
  Matrix6Xd generators(6, edges.cols());
  for (Eigen::Index j = 0; j < edges.cols(); ++j) {
    Vector6d wrench;
    wrench << edges.col(j), lever.cross(edges.col(j));
    wrench = set.wrench_scale * wrench;
    const double noise = kNoise * wrench.cwiseAbs().maxCoeff();
    generators.col(j) = (wrench.array().abs() < noise).select(0.0, wrench);
  }
  return generators;
}

FingerWrenches wrenches_of(const ContactSet& set, const Finger& finger) {
  const Eigen::Matrix3Xd edges = cone_of(finger, set.cone_edges);
  FingerWrenches wrench;
  wrench.generators = wrenches(set, finger.p_OC, edges);
  wrench.normal = edges.transpose() * finger.n_O;
  wrench.max_normal_force = finger.max_normal_force;
  return wrench;
}

}  // namespace

Eigen::Matrix3Xd cone_of(const Contact& contact, int cone_edges) {
  const Eigen::Vector3d t = tangent(contact.n_O, contact.t_O);
  if (contact.mode == ContactMode::stick) {
    return friction_cone(contact.n_O, contact.friction, cone_edges, t);
  }
  return (contact.n_O - contact.friction * t).normalized();
}

Eigen::Matrix3Xd cone_of(const Finger& finger, int cone_edges) {
  return friction_cone(finger.n_O, finger.friction, cone_edges, tangent(finger.n_O, finger.t_O));
}

ContactSet with_round_cones(ContactSet set) {
  constexpr int kRound = 12;
  set.cone_edges *= (kRound + set.cone_edges - 1) / set.cone_edges;
  return set;
}

EnvironmentWrenches wrenches_of_environment(const ContactSet& set) {
  Eigen::Index columns = 0;
  for (const Contact& contact : set.contacts) {
    columns += contact.mode == ContactMode::stick ? set.cone_edges : 1;
  }
  EnvironmentWrenches environment;
  environment.generators.resize(6, columns);
  Eigen::Index next = 0;
  for (const Contact& contact : set.contacts) {
    const Matrix6Xd part = wrenches(set, contact.p_OC, cone_of(contact, set.cone_edges));
    environment.generators.middleCols(next, part.cols()) = part;
    next += part.cols();
  }
  environment.known = set.wrench_scale * set.known_wrench_O;
  return environment;
}

std::vector<FingerWrenches> wrenches_of_fingers(const ContactSet& set) {
  std::vector<FingerWrenches> all;
  for (const Finger& finger : set.fingers) all.push_back(wrenches_of(set, finger));
  return all;
}

EnvironmentWrenches environment_wrenches(const ContactSet& set) {
  validate(set);
  return wrenches_of_environment(set);
}

FingerWrenches finger_wrenches(const ContactSet& set, int finger) {
  validate(set);
  if (finger < 0 || finger >= static_cast<int>(set.fingers.size())) {
    throw std::invalid_argument("finger must be an index of contact set.fingers, which has " +
                                std::to_string(set.fingers.size()) + ", not " +
                                std::to_string(finger));
  }
  return wrenches_of(set, set.fingers[finger]);
}

}  // namespace graspless::mechanics
