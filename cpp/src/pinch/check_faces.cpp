// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "graspless/watch.hpp"

#include "pinch/check_contacts.hpp"

namespace graspless::pinch {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr double kOnLine = 1e-6;    // [m]
constexpr double kOffFace = 0.004;  // of a contact from a noisy outline [m]
constexpr double kSlack = 0.10;     // of slopes that are measured in two ways

class FacesExamination {
 public:
  FacesExamination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem), plan_(plan), options_(options) {}

  std::vector<std::string> run() {
    const double thickness = problem_.object.thickness();
    for (int i = 0; i < 2; ++i) {
      const std::string where = "contact " + std::to_string(i);
      const double off = problem_.object.outline().depth(contact(i).head<2>());
      if (std::abs(off) > kOffFace) fault(where, "is " + figure(off) + " m inside the outline");
      if (contact(i).z() < 0 || contact(i).z() > thickness - options_.clearance + kOnLine)
        fault(where, "is not on a face of the object");
    }
    const Vector2d com = problem_.object.com().head<2>(),
                   line = (contact(1) - contact(0)).head<2>().normalized(),
                   arm = com - contact(0).head<2>();
    const double lever = std::abs(arm.x() * line.y() - arm.y() * line.x());
    if (lever > options_.max_lever + kOnLine)
      fault("plan", "the centre of mass is " + figure(lever) + " m from the line of contacts");
    for (int i = 0; i < 2; ++i) check_face(i, i == 0 ? Vector2d(-line) : line);
    return faults_;
  }

 private:
  void fault(const std::string& where, const std::string& what) {
    faults_.push_back(where + ": " + what);
  }
  static std::string figure(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
  }
  Vector3d contact(int i) const { return plan_.contacts_O.col(i); }

  /// The outline around a contact leans by no more than the friction allows, to both sides of it.
  void check_face(int i, const Vector2d& outward) {
    constexpr double kHalf = 0.004;  // [m]
    const std::string where = "contact " + std::to_string(i);
    for (const auto& [from, to] : {std::pair(-kHalf, kHalf), {-kHalf, 0.0}, {0.0, kHalf}}) {
      const std::optional<double> slope = slope_around(contact(i).head<2>(), outward, from, to);
      if (slope && std::atan(std::abs(*slope)) > std::atan(options_.friction) + kSlack)
        fault(where,
              "the face leans by a tangent of " + figure(*slope) + ", which exceeds the friction");
    }
    if (!slope_around(contact(i).head<2>(), outward, -kHalf, kHalf))
      fault(where, "there is no face around it");
  }

  /// Slope of the line that fits best the outline beside p, between two distances along the face;
  /// nothing if there is no outline.
  std::optional<double> slope_around(const Vector2d& p, const Vector2d& outward, double from,
                                     double to) const {
    constexpr double kBehind = 0.008, kSpacing = 2e-4;  // [m]
    const Vector2d along(-outward.y(), outward.x());
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    const geometry::Polygon& outline = problem_.object.outline();
    for (int k = 0; k < outline.size(); ++k) {
      poll();
      const geometry::Polygon::Edge edge = outline.edge(k);
      if (edge.inward.dot(outward) >= 0) continue;  // it faces the other way
      const int count = std::max(1, static_cast<int>((edge.b - edge.a).norm() / kSpacing));
      for (int j = 0; j < count; ++j) {
        const Vector2d off = edge.a + (edge.b - edge.a) * (j + 0.5) / count - p;
        const double u = along.dot(off), v = outward.dot(off);
        if (u < from || u > to || std::abs(v) > kBehind) continue;
        n += 1, x += u, y += v, xx += u * u, xy += u * v;
      }
    }
    const double spread = n > 0 ? xx - x * x / n : 0;
    if (spread <= 0) return std::nullopt;
    return (xy - x * y / n) / spread;
  }

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of_faces(const Problem& problem, const Plan& plan,
                                         const Options& options) {
  return FacesExamination(problem, plan, options).run();
}

}  // namespace graspless::pinch
