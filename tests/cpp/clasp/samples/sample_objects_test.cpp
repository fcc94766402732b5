// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/sample_objects.hpp"

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "graspless/geometry/loops.hpp"
#include "graspless/geometry/sampling.hpp"

#include "complaint.hpp"

namespace graspless::clasp {
namespace {

const std::map<std::string, std::size_t> kHoles{
    {"purse", 1}, {"bag", 1}, {"travel_bag", 1}, {"lawn_mower", 2}, {"chair", 7}};

Eigen::Matrix3Xd cloud(const std::string& name) {
  return geometry::sample_surface(sample_object(name), 2000);
}

Eigen::Matrix3Xd noisy(Eigen::Matrix3Xd points, double deviation) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> normal(0, deviation);
  for (double& value : points.reshaped()) value += normal(rng);
  return points;
}

Eigen::Matrix3Xd seen_from(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& viewpoint) {
  return points(Eigen::all, geometry::visible_points(points, viewpoint));
}

TEST(SampleObjects, StandOnTheFloorAboutTheMiddle) {
  for (const std::string& name : sample_object_names()) {
    const Eigen::Matrix3Xd points = cloud(name);
    const Eigen::Vector3d lower = points.rowwise().minCoeff(), upper = points.rowwise().maxCoeff();
    EXPECT_NEAR(lower.z(), 0, 0.005) << name;
    EXPECT_GE(lower.z(), -1e-9) << name;
    EXPECT_LT((lower + upper).head<2>().norm() / 2, 0.005) << name;
    EXPECT_GT((upper - lower).minCoeff(), 0.08) << name;
    EXPECT_LT((upper - lower).maxCoeff(), 1.2) << name;
  }
}

TEST(SampleObjects, HaveTheirHoles) {
  ASSERT_EQ(sample_object_names().size(), kHoles.size());
  for (const auto& [name, holes] : kHoles) {
    const geometry::Loops loops = geometry::shortest_loops(cloud(name));
    EXPECT_EQ(loops.status, geometry::LoopStatus::found) << name;
    EXPECT_EQ(loops.found.size(), holes) << name;
    EXPECT_TRUE(loops.meridians.empty()) << name;
    for (const geometry::Loop& loop : loops.found) EXPECT_GT(loop.length, 0.36) << name;
  }
}

TEST(SampleObjects, HaveTheirHolesInNoise) {
  for (const auto& [name, holes] : kHoles) {
    const Eigen::Matrix3Xd points = cloud(name);
    const double half = geometry::spacing(points) / 2;
    EXPECT_EQ(geometry::shortest_loops(noisy(points, half)).found.size(), holes) << name;
  }
}

// Of the chair some holes are hidden behind the seat from every side.
TEST(SampleObjects, ShowTheirHolesFromOneSide) {
  for (const auto& [name, holes] : kHoles) {
    const Eigen::Vector3d eye(1.5, 1, 1.2);
    const Eigen::Matrix3Xd points = seen_from(cloud(name), eye);
    EXPECT_TRUE(geometry::shortest_loops(points).found.empty()) << name;  // it may be of one view
    const auto rays = geometry::rays_from_viewpoints(points, eye);
    const std::size_t found = geometry::shortest_loops(points, {}, rays).found.size();
    EXPECT_LE(found, holes) << name;
    EXPECT_GE(found, name == "chair" ? 4 : holes) << name;
  }
}

TEST(SampleObjects, ScaleWithTheirClouds) {
  for (const std::string& name : sample_object_names()) {
    const Eigen::Matrix3Xd half = geometry::sample_surface(sample_object(name, 0.5), 500);
    const Eigen::Matrix3Xd whole = geometry::sample_surface(sample_object(name), 500);
    EXPECT_NEAR(half.row(2).maxCoeff(), whole.row(2).maxCoeff() / 2, 0.01) << name;
    EXPECT_NEAR(geometry::spacing(half), geometry::spacing(whole) / 2, 0.001) << name;
  }
}

TEST(SampleObjects, SaysWhatThereIs) {
  EXPECT_EQ(complaint([] { sample_object("sofa"); }),
            "sample object must be one of purse, bag, travel_bag, lawn_mower, chair, not 'sofa'");
  expect_refused([] { sample_object("purse", 0); }, "scale must be in (0, 1000], not 0");
  expect_refused([] { sample_object("purse", std::nan("")); }, "not nan");
}

}  // namespace
}  // namespace graspless::clasp
