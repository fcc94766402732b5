// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/mechanics/stability.hpp"

namespace graspless::mechanics {

/// Equal to what the engines promise.
inline bool same(double z1, double z2) {
  return z1 == z2 || std::abs(z1 - z2) <= 1e-9 * std::max({1.0, z1, z2});
}

/// Contact sets for tests: a box on a floor, symmetric and degenerate or random.
class Sets {
 public:
  explicit Sets(unsigned seed) : rng_(seed) {}

  /// Contacts as a planner makes them: vertices of a box that slide or stick, twice, along an edge,
  /// or in a corner of floor and wall, and a round foot; fingers on a grid.
  ContactSet box(int fingers) {
    begin(Eigen::Vector3d(5, chance(2) ? 10 : 5, chance(2) ? 10 : 5));
    const int kind = whole(0, 5);
    if (kind <= 2) vertices(kind == 0 ? ContactMode::stick : ContactMode::slide);
    if (kind == 2) vertices(ContactMode::slide);
    if (kind == 3) edge(real(0.05, 1.5));
    if (kind == 4) corner();
    if (kind == 5) foot();
    for (int i = 0; i < fingers; ++i) add_finger(whole(0, 2), chance(2) ? 1 : -1);
    return set_;
  }

  /// The same without any symmetry.
  ContactSet any(int fingers) {
    begin(Eigen::Vector3d(real(3, 8), real(3, 8), real(3, 8)));
    const double mu = real(0.2, 1.2);
    for (int i = whole(2, 12); i > 0; --i) {
      const bool wall = chance(4);
      const Eigen::Vector3d at = wall ? Eigen::Vector3d(1, real(-1, 1), real(-1, 1))
                                      : Eigen::Vector3d(real(-1, 1), real(-1, 1), -1);
      const Eigen::Vector3d n = wall ? Eigen::Vector3d(-1, 0, 0) : Eigen::Vector3d(0, 0, 1);
      touch(at, (n + 0.3 * unit()).normalized(),
            chance(3) ? ContactMode::slide : ContactMode::stick);
      set_.contacts.back().friction = mu;
      set_.contacts.back().t_O = unit();
    }
    for (int i = 0; i < fingers; ++i) {
      add_finger(whole(0, 2), chance(2) ? 1 : -1);
      Finger& finger = set_.fingers.back();
      finger.n_O = (finger.n_O + 0.2 * unit()).normalized();
      finger.friction = real(0.3, 1.2);
      finger.max_normal_force = real(3, 20);
    }
    set_.known_wrench_O.head<3>() = Eigen::Vector3d(real(-1, 1), real(-1, 1), -9.8);
    return set_;
  }

  std::vector<FingerMode> modes(int fingers) {
    std::vector<FingerMode> drawn;
    for (int i = 0; i < fingers; ++i) {
      drawn.push_back(chance(2) ? FingerMode::force : FingerMode::position);
    }
    return drawn;
  }

  double real(double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng_); }
  int whole(int a, int b) { return std::uniform_int_distribution<int>(a, b)(rng_); }
  bool chance(int one_in) { return whole(1, one_in) == 1; }
  Eigen::Vector3d unit() {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(rng_), normal(rng_), normal(rng_)).normalized();
  }

 private:
  void begin(const Eigen::Vector3d& size) {
    set_ = ContactSet();
    half_ = size / 2;
    const Eigen::Vector3d square = size.cwiseAbs2();
    set_.wrench_scale = wrench_scale(
        1, Eigen::Vector3d((Eigen::Vector3d::Constant(square.sum()) - square) / 12).asDiagonal());
    set_.known_wrench_O = gravity_wrench(1, Eigen::Vector3d(0, 0, -9.8));
  }
  void touch(const Eigen::Vector3d& corner, const Eigen::Vector3d& n, ContactMode mode) {
    set_.contacts.push_back({corner.cwiseProduct(half_), n, 0.5, mode, Eigen::Vector3d::UnitX()});
  }
  void vertices(ContactMode mode) {
    for (int i = 0; i < 4; ++i) {
      touch({(i & 1) != 0 ? 1. : -1., (i & 2) != 0 ? 1. : -1., -1.}, Eigen::Vector3d::UnitZ(),
            mode);
    }
  }
  void edge(double turned) {
    const Eigen::Vector3d up(std::sin(turned), 0, std::cos(turned));
    for (const double y : {-1., 1.}) touch({1, y, -1}, up, ContactMode::stick);
    set_.known_wrench_O.head<3>() = -9.8 * up;
  }
  void corner() {
    vertices(ContactMode::stick);
    for (int i = 0; i < 4; ++i) {
      touch({1, (i & 1) != 0 ? 1. : -1., (i & 2) != 0 ? 1. : -1.}, -Eigen::Vector3d::UnitX(),
            ContactMode::stick);
    }
  }
  void foot() {
    for (int i = 0; i < 12; ++i) {
      const double angle = i * std::acos(-1.0) / 6;
      touch({std::cos(angle), std::sin(angle), -1}, Eigen::Vector3d::UnitZ(),
            i % 2 == 0 ? ContactMode::slide : ContactMode::stick);
    }
  }
  void add_finger(int axis, int side) {
    Finger finger;
    if (axis == 2) side = 1;  // not under the floor
    for (int k = 0; k < 3; ++k) finger.p_OC[k] = half_[k] * ((2 * whole(0, 6) + 1) / 7.0 - 1);
    finger.p_OC[axis] = side * half_[axis];
    finger.n_O = -side * Eigen::Vector3d::Unit(axis);
    finger.friction = 0.7;
    set_.fingers.push_back(finger);
  }

  std::mt19937 rng_;
  ContactSet set_;
  Eigen::Vector3d half_;
};

}  // namespace graspless::mechanics
