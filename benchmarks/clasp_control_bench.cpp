// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one projection and one control step of the clasp planner cost: a ring of 100 corners in the
// hand of the KR 5, the configuration never the same twice.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "clasp/search/controller.hpp"

namespace graspless::clasp {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct Setting {
  explicit Setting(const std::string& name)
      : stem(std::string(GRASPLESS_URDF_DIR) + "/" + name),
        robot(robot::Robot::from_urdf_file(stem + ".urdf")),
        hand(hand_from_yaml_file(stem + ".clasp.yaml")) {
    q = robot.state("home");
    const Eigen::Vector3d p = look_at_hand(q);
    loop.resize(3, 100);
    for (int i = 0; i < 100; ++i) {
      const double angle = 2 * M_PI * i / 100;
      loop.col(i) = p + 0.2 * (ahead * (1 - std::cos(angle)) + along * std::sin(angle));
      if (i % 5 == 0) targets.push_back({loop.col(i), along});
    }
    x << p, 1;
  }

  Vector3d look_at_hand(const VectorXd& at) {
    HandKinematics kinematics(robot, hand);
    kinematics.update(at);
    ahead = kinematics.forward_W();
    along = kinematics.sideways_W();
    const Eigen::Matrix3Xd& p = kinematics.nodes();
    return (p.rowwise().minCoeff() + p.rowwise().maxCoeff()) / 2;
  }

  /// The k-th of many places near home.
  const VectorXd& place(int k) {
    moved = q.array() + 1e-4 * ((k & 1) == 0 ? 1 : -1);
    return moved;
  }

  std::string stem;
  robot::Robot robot;
  Hand hand;
  VectorXd q, moved;
  Vector3d ahead, along;
  Eigen::Matrix3Xd loop;
  std::vector<geometry::ClaspTarget> targets;
  TaskPoint x;
};

void projection_and_jacobians(benchmark::State& state, const std::string& name) {
  Setting s(name);
  TaskSpace tasks(s.robot, s.hand, s.loop, s.targets);
  MatrixXd position, alignment, linking;
  int k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tasks.project(s.place(++k)));
    tasks.position_jacobian(position);
    tasks.alignment_jacobian(alignment);
    tasks.linking_jacobian(linking);
    benchmark::DoNotOptimize(linking.data());
  }
  state.counters["linked"] = tasks.linking();
}

void control_step(benchmark::State& state, const std::string& name) {
  Setting s(name);
  TaskSpace tasks(s.robot, s.hand, s.loop, s.targets);
  Controller controller(tasks, s.robot, s.hand, {});
  VectorXd q_new;
  int k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(controller.step(s.place(++k), s.x, 0.12, q_new));
  }
}

BENCHMARK_CAPTURE(projection_and_jacobians, sdh, "kr5_sdh");
BENCHMARK_CAPTURE(projection_and_jacobians, dlr, "kr5_dlr");
BENCHMARK_CAPTURE(projection_and_jacobians, icub, "kr5_icub");
BENCHMARK_CAPTURE(projection_and_jacobians, armar, "kr5_armar");
BENCHMARK_CAPTURE(control_step, sdh, "kr5_sdh");
BENCHMARK_CAPTURE(control_step, dlr, "kr5_dlr");
BENCHMARK_CAPTURE(control_step, icub, "kr5_icub");
BENCHMARK_CAPTURE(control_step, armar, "kr5_armar");

}  // namespace
}  // namespace graspless::clasp
