// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/surroundings.hpp"

#include <cmath>
#include <stdexcept>

#include "graspless/scene/scene.hpp"
#include "graspless/slide/resume.hpp"

#include "robot/names.hpp"
#include "slide/arm.hpp"
#include "slide/check/examination.hpp"

namespace graspless::slide {
namespace {

void require_segment(const std::string& name) {
  const auto& names = segment_names();
  if (robot::contains(names, name)) return;
  std::string choices;
  for (const std::string& known : names) choices += (choices.empty() ? "" : ", ") + known;
  throw std::invalid_argument("segment '" + name + "' is none of " + choices);
}

/// The robot alone, whose links keep a distance where the arm moves them.
scene::Scene links_apart(const Problem& problem) {
  const Arm arm(problem);
  scene::Scene links(problem.robot);
  links.keep_links_apart(kShiftedClearance, arm.joints(), {problem.q_home, arm.open()});
  return links;
}

/// Ends all tests between robot and object.
void ignore_object(Replay& world) {
  for (int body = 0; body < world.bodies().num_links(); ++body) {
    world.bodies().world().remove_pair(body, world.object());
  }
}

}  // namespace

struct Surroundings::State {
  State(const Problem& given, const Options& options)
      : problem(given),
        free(problem, allowed_depths(problem.hand, options).max),
        pressed(free.with(Contacts::press)),
        links(links_apart(problem)) {
    ignore_object(free);
    ignore_object(pressed);
  }

  const Problem problem;
  Replay free, pressed;
  scene::Scene links;
};

Surroundings::Surroundings(const Problem& problem, const Options& options) {
  validate(problem, options);
  state_ = std::make_unique<State>(problem, options);
}
Surroundings::~Surroundings() = default;
Surroundings::Surroundings(Surroundings&&) noexcept = default;
Surroundings& Surroundings::operator=(Surroundings&&) noexcept = default;

const Problem& Surroundings::problem() const { return state_->problem; }

std::vector<std::string> Surroundings::touching(const std::string& segment,
                                                const Eigen::VectorXd& q,
                                                const Eigen::Isometry3d& X_WO, double rise) {
  require_segment(segment);
  validate(state_->problem, Interruption{q, X_WO, std::nullopt});
  if (!std::isfinite(rise)) throw std::invalid_argument("rise must be finite");
  Replay& world = contacts_of(segment) == Contacts::press ? state_->pressed : state_->free;
  world.raise_support(rise);
  std::vector<std::string> found = world.touching(q, X_WO);
  if (!found.empty()) return found;
  const auto [a, b] = state_->links.collision(q);
  if (!a.empty()) found.push_back(a + " - " + b);
  return found;
}

}  // namespace graspless::slide
