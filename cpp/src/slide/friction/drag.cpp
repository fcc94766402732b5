// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/friction/drag.hpp"

#include <cmath>

namespace graspless::slide {
namespace {

/// Sum of a_i / (1 - t + t mu_i)^2 and its derivative; a_i = mu_i (mu_i - 1) c_i^2.
struct Balance {
  Eigen::Array3d mu, c;

  double value(double t) const { return (mu * (mu - 1) * (c / (1 - t + t * mu)).square()).sum(); }
  double slope(double t) const {
    const Eigen::Array3d nearer = 1 - t + t * mu;
    return -2 * (mu * ((mu - 1) * c).square() / (nearer * nearer * nearer)).sum();
  }
  /// The root in (0, 1). The sum falls from value(0) > 0 to value(1) < 0.
  double root() const {
    constexpr int kMost = 100;
    constexpr double kPrecise = 1e-10;
    double low = 0, high = 1, t = 0;
    for (int i = 0; i < kMost && high - low > kPrecise; ++i) {
      const double now = value(t);
      (now > 0 ? low : high) = t;
      const double newton = t - now / slope(t);
      const double next = newton > low && newton < high ? newton : (low + high) / 2;
      if (std::abs(next - t) < kPrecise) return next;
      t = next;
    }
    return t;
  }
};

}  // namespace

// In scaled coordinates with x along TC, (v_x, v_y, w turn), H_p is the unit matrix times that of a
// force, and H_s has the eigenvalues mu_i relative to it. With the components c_i of the pad's
// twist, the object's are c_i / (1 + l mu_i), where l = |slip| / |V| in both metrics. Their
// definition gives sum mu_i (mu_i - 1) c_i^2 / (1 + l mu_i)^2 = 0, solved for t = l / (1 + l).
Eigen::Vector3d dragged(const Drag& drag, const Eigen::Vector2d& p_TC, const Eigen::Vector3d& pad) {
  const double R = drag.ratio * drag.ratio, w = drag.pad;
  if (!(R < 1e12)) return Eigen::Vector3d::Zero();  // the finger hardly presses
  const double e = p_TC.norm(), k = e / w, s = drag.radius / w;
  const Eigen::Vector2d x = e > 0 ? Eigen::Vector2d(p_TC / e) : Eigen::Vector2d::UnitX();
  const Eigen::Vector3d u(x.dot(pad.head<2>()), x.x() * pad.y() - x.y() * pad.x(), w * pad.z());
  const Eigen::Vector3d F(R * u.x(), R * (u.y() + k * u.z()),
                          R * (k * u.y() + (k * k + s * s) * u.z()));
  if (F.dot(F) <= F.dot(u)) return pad;  // the support's wrench is inside the pad's limit surface
  // Eigenvalues of [[1, k], [k, k^2 + s^2]].
  const double mean = (1 + k * k + s * s) / 2, apart = (1 - k * k - s * s) / 2;
  const double largest = mean + std::hypot(apart, k);
  const double angle = std::atan2(k, apart) / 2, C = std::cos(angle), S = std::sin(angle);
  Balance balance;
  balance.mu << R, R * largest, R * s * s / largest;
  balance.c << u.x(), C * u.y() + S * u.z(), C * u.z() - S * u.y();
  if (balance.value(1) >= 0) return Eigen::Vector3d::Zero();
  const double t = balance.root();
  const Eigen::Array3d v = balance.c * (1 - t) / (1 - t + t * balance.mu);
  const double across = C * v[1] - S * v[2], turn = S * v[1] + C * v[2];
  return {x.x() * v[0] - x.y() * across, x.y() * v[0] + x.x() * across, turn / w};
}

}  // namespace graspless::slide
