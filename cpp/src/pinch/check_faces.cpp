// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "pinch/check_contacts.hpp"
#include "pinch/face_measure.hpp"
#include "text.hpp"

namespace graspless::pinch {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr double kOnLine = 1e-6;    // [m]
constexpr double kOffFace = 0.004;  // of a contact from a noisy outline [m]

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
    double friction = 0;
    for (int i = 0; i < 2; ++i)
      friction = std::max(friction, check_face(i, i == 0 ? Vector2d(-line) : line));
    if (!(plan_.friction >= friction))
      fault("plan", "friction must be at least the " + figure(friction) + " that its slopes need");
    for (const std::string& what :
         faults_of_load(problem_, plan_, options_, std::max(friction, plan_.friction), 0))
      fault("plan", what);
    return faults_;
  }

 private:
  void fault(const std::string& where, const std::string& what) {
    faults_.push_back(where + ": " + what);
  }
  Vector3d contact(int i) const { return plan_.contacts_O.col(i); }

  /// The outline around a contact leans by no more than the friction allows. Returns the least
  /// coefficient that its slope needs, as measured in two ways.
  double check_face(int i, const Vector2d& outward) {
    const std::string where = "contact " + std::to_string(i);
    const std::optional<double> slope =
        steepest_around(problem_.object.outline(), contact(i).head<2>(), outward);
    if (!slope) {
      fault(where, "there is no face around it");
      return 0;
    }
    if (!is_held(*slope, options_.friction)) {
      fault(where,
            "the face leans by a tangent of " + figure(*slope) + ", which exceeds the friction");
    }
    return least_friction(*slope);
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
