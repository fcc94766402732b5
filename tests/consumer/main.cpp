// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include <graspless/fingertip/fingertip.hpp>
#include <graspless/slide/slide.hpp>

using namespace graspless;

// Pushes a block over the floor with two fingertips; prints the cost [m].
int push_a_block() {
  const auto block = fingertip::Object::box("block", {0.05, 0.1, 0.05}, 1.0);
  const Eigen::Isometry3d X_WO_start(Eigen::Translation3d(0, 0, 0.025));
  const fingertip::Problem problem{block,
                                   fingertip::Fingers{},
                                   {fingertip::Plane{}},
                                   {0.5, 0.5},
                                   fingertip::slide_path(X_WO_start, {0.1, 0, 0}, 30)};
  const fingertip::Plan plan = fingertip::plan(problem);
  if (!plan || !fingertip::check(problem, plan).empty()) {
    std::cerr << plan.reason << "\n";
    return 1;
  }
  std::cout << plan.cost << "\n";
  return 0;
}

// Slides a card to the edge of a table with the WAM and grasps it there: argv[1] is
// urdf/wam_t42.urdf. Then pushes a block.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto wam = robot::Robot::from_urdf_file(argv[1]);

  Eigen::Matrix2Xd card_outline(2, 4), table_outline(2, 4);
  card_outline << -0.06, 0.06, 0.06, -0.06, -0.04, -0.04, 0.04, 0.04;
  table_outline << 0.3, 1.0, 1.0, 0.3, -0.35, -0.35, 0.35, 0.35;
  const auto card = slide::Object::from_polygon("card", geometry::Polygon(card_outline), 0.003);
  const slide::Support table(geometry::Polygon(table_outline), Eigen::Isometry3d::Identity());
  const Eigen::Isometry3d X_WO_start(Eigen::Translation3d(0.62, 0.08, 0));

  const slide::Problem problem{wam, slide::Hand{}, card, table, X_WO_start, {}, wam.state("home")};
  const slide::Plan plan = slide::plan(problem);
  if (!plan) {
    std::cerr << plan.reason << "\n";
    return 1;
  }
  for (const std::string& fault : slide::check(problem, plan)) std::cerr << fault << "\n";
  std::cout << wam.name() << " " << plan.segments.size() << "\n";
  return push_a_block();
}
