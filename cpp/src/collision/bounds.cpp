// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/bounds.hpp"

#include <algorithm>

namespace graspless::collision {
namespace {

// Squared sine of the angle below which two segments count as parallel.
constexpr double kParallel = 1e-12;

double exact_bound(const Core& a, const Placement& at_a, const Core& b, const Placement& at_b,
                   const Eigen::Vector3d& shift_W) {
  const Eigen::Vector3d h_a = at_a.X_WC.linear().col(2) * a.half.z();
  const Eigen::Vector3d h_b = at_b.X_WC.linear().col(2) * b.half.z();
  return segment_distance(at_a.X_WC.translation(), h_a, at_b.X_WC.translation() + shift_W, h_b) -
         a.radius - b.radius;
}

double clamp_to_segment(double t) { return std::clamp(t, -1.0, 1.0); }

}  // namespace

Eigen::Vector3d half_in_world(const Core& core, const Eigen::Matrix3d& R_WC) {
  if (core.is_exact_segment)
    return ((R_WC.col(2).cwiseAbs() * core.half.z()).array() + core.radius).matrix();
  return ((R_WC.cwiseAbs() * core.half).array() + core.radius).matrix();
}

// Points m_a + s h_a and m_b + t h_b with s, t in [-1, 1] (Ericson, Real-Time Collision
// Detection, 5.1.9): the pair nearest on the lines, s clamped, then t nearest to it, clamped, then
// s nearest to that.
double segment_distance(const Eigen::Vector3d& m_a, const Eigen::Vector3d& h_a,
                        const Eigen::Vector3d& m_b, const Eigen::Vector3d& h_b) {
  const Eigen::Vector3d r = m_a - m_b;
  const double aa = h_a.squaredNorm(), bb = h_b.squaredNorm(), ab = h_a.dot(h_b);
  const double ar = h_a.dot(r), br = h_b.dot(r);
  const double determinant = aa * bb - ab * ab;
  double s =
      determinant > kParallel * aa * bb ? clamp_to_segment((ab * br - ar * bb) / determinant) : 0;
  const double t = bb > 0 ? clamp_to_segment((ab * s + br) / bb) : 0;
  if (aa > 0) s = clamp_to_segment((ab * t - ar) / aa);
  return (r + s * h_a - t * h_b).norm();
}

double oriented_bound(const Core& a, const Placement& at_a, const Core& b, const Placement& at_b,
                      const Eigen::Vector3d& shift_W) {
  if (a.is_exact_segment && b.is_exact_segment) return exact_bound(a, at_a, b, at_b, shift_W);
  const Eigen::Vector3d p_ab_W = at_b.X_WC.translation() + shift_W - at_a.X_WC.translation();
  const Eigen::Matrix3d R_ab = at_a.X_WC.linear().transpose() * at_b.X_WC.linear();
  const Eigen::Matrix3d extent = R_ab.cwiseAbs();
  const double in_a = box_gap(at_a.X_WC.linear().transpose() * p_ab_W, a.half + extent * b.half);
  const double in_b =
      box_gap(at_b.X_WC.linear().transpose() * p_ab_W, b.half + extent.transpose() * a.half);
  return std::max(in_a, in_b) - a.radius - b.radius;
}

double shape_distance_bound(const Core& a, const Placement& at_a, const Core& b,
                            const Placement& at_b, const Eigen::Vector3d& shift_W, double enough) {
  const Eigen::Vector3d p_ab_W = at_b.X_WC.translation() + shift_W - at_a.X_WC.translation();
  const double in_world = box_gap(p_ab_W, at_a.half_W + at_b.half_W);
  if (in_world >= enough) return in_world;
  return std::max(in_world, oriented_bound(a, at_a, b, at_b, shift_W));
}

}  // namespace graspless::collision
