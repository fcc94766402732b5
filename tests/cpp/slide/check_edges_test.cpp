// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// certify() must prove good plans, agree with dense sampling, and refute what check() cannot see.
#include <gtest/gtest.h>

#include "scene/rows.hpp"
#include "slide/check/band_prover.hpp"
#include "slide/check/replay.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

std::string texts(const scene::EdgeCertificate& certificate) {
  std::string all;
  for (const scene::Doubt& doubt : certificate.doubts) all += doubt.text() + "\n";
  return all;
}

Problem random_problem(int i) {
  std::mt19937_64 rng(static_cast<std::uint64_t>(100 + i));
  const Support& table = tables()[static_cast<std::size_t>(i) % 4];
  const Object& object = objects()[static_cast<std::size_t>(i / 4) % 3];
  return make_problem(table, object, random_pose(table, object, rng));
}

/// The plan with one edge instead of each of its edges: rows at joint steps of 1e-4 rad.
Plan densely(const Problem& problem, Plan plan, std::size_t every) {
  plan.tube = {};  // its rows are others
  for (Segment& segment : plan.segments) {
    Segment dense{segment.name, {segment.positions[0]}, {segment.object_poses[0]}};
    for (std::size_t row = 1; row < segment.positions.size(); ++row) {
      const Eigen::VectorXd from = segment.positions[row - 1], to = segment.positions[row];
      const int steps =
          row % every == 0 ? static_cast<int>(problem.robot.step(from, to) / 1e-4) + 1 : 1;
      for (int k = 1; k <= steps; ++k) {
        dense.positions.push_back(from + (to - from) * k / steps);
        dense.object_poses.push_back(segment.object_poses[row]);
      }
    }
    segment = dense;
  }
  return plan;
}

TEST(Certify, ProvesPlansInWhichDenseSamplingFindsNothing) {
  std::size_t edges = 0, proven = 0;
  for (int i = 0; i < 12; ++i) {
    const Problem problem = random_problem(i);
    const Plan found = plan(problem, {}, seeded(static_cast<std::uint64_t>(i)));
    ASSERT_TRUE(found);
    const scene::EdgeCertificate certificate = certify(problem, found);
    edges += certificate.num_edges;
    proven += certificate.num_certified();
    if (!certificate) continue;
    for (const std::string& fault : check(problem, densely(problem, found, 61))) {
      // The object's poses and the warnings are those of the rows.
      const bool is_of_rows = fault.find("follow the contact") != std::string::npos ||
                              fault.find("warnings: the plan lacks") != std::string::npos;
      if (!is_of_rows) ADD_FAILURE() << i << " " << fault;
    }
  }
  EXPECT_GT(edges, 1000u);
  EXPECT_GE(proven, edges - edges / 50);
}

class CertifyOne : public ::testing::Test {
 protected:
  CertifyOne() : problem_(simple_problem()), plan_(plan(problem_, {}, seeded(1))) {}

  const Segment& segment(const std::string& name) const {
    for (const Segment& s : plan_.segments) {
      if (s.name == name) return s;
    }
    throw std::logic_error(name);
  }
  Eigen::Vector3d tip(const Eigen::VectorXd& q) const {
    return problem_.robot.pose(problem_.robot.frame("left_fingertip"), q).translation();
  }
  void add_ball(const Eigen::Vector3d& p, double radius) {
    problem_.obstacles = {{"ball",
                           {{geometry::Sphere{radius}, Eigen::Isometry3d::Identity()}},
                           Eigen::Isometry3d(Eigen::Translation3d(p))}};
  }

  Problem problem_;
  Plan plan_;
};

TEST_F(CertifyOne, EveryEdgeIsProven) {
  const scene::EdgeCertificate certificate = certify(problem_, plan_);
  EXPECT_TRUE(certificate) << texts(certificate);
  std::size_t edges = 0;
  for (const Segment& s : plan_.segments) edges += s.positions.size() - 1;
  EXPECT_EQ(certificate.num_edges, edges);
  EXPECT_EQ(certificate.num_certified(), edges);
}

/// Balls that grow until the samples of check() would touch them: the motion between the samples
/// does.
TEST_F(CertifyOne, RefutesAnObstacleThatIsTouchedOnlyBetweenTheSamples) {
  int refuted = 0, mutants = 0;
  for (const char* name : {"approach", "reach", "lift", "slide", "press"}) {
    const auto& rows = segment(name).positions;
    for (std::size_t row = 1 + rows.size() / 4; row < rows.size(); row += 1 + rows.size() / 2) {
      const Eigen::VectorXd middle = rows[row - 1] + 0.47 * (rows[row] - rows[row - 1]);
      const Eigen::Vector3d along = tip(rows[row]) - tip(rows[row - 1]);
      const Eigen::Vector3d p =
          tip(middle) + 0.08 * along.cross(Eigen::Vector3d(0.3, 0.2, 0.9)).normalized();
      double clear = 1e-4, touching = 0.1;
      while (touching - clear > 1e-8) {
        const double radius = (clear + touching) / 2;
        add_ball(p, radius);
        (check(problem_, plan_).empty() ? clear : touching) = radius;
      }
      if (clear < 1e-3) continue;  // no room for a ball
      ++mutants;
      add_ball(p, clear);
      ASSERT_TRUE(check(problem_, plan_).empty());
      const scene::EdgeCertificate certificate = certify(problem_, plan_);
      for (const scene::Doubt& doubt : certificate.doubts) {
        EXPECT_NE(doubt.condition.find("ball"), std::string::npos) << doubt.text();
      }
      refuted += !certificate;
      add_ball(p, clear / 2);
      EXPECT_TRUE(certify(problem_, plan_)) << texts(certify(problem_, plan_));
    }
  }
  EXPECT_GE(mutants, 3);
  EXPECT_EQ(refuted, mutants);
}

TEST_F(CertifyOne, RefutesBandsThatAreLeftBetweenTheSamples) {
  // The largest depth, pitch or turn of the samples is below that of the motion.
  double deepest = 0;
  for (const Segment& s : plan_.segments) {
    if (s.name != "slide" && s.name != "press" && s.name != "lift") continue;
    scene::replay_rows(problem_.robot, s.positions, [&](std::size_t, const Eigen::VectorXd& q) {
      deepest = std::max(deepest, problem_.object.thickness() - tip(q).z());
    });
  }
  Options options;
  options.max_depth = deepest - 5e-4 + 1e-9;  // kHeightTolerance
  EXPECT_TRUE(check(problem_, plan_, options).empty());
  options.max_depth = deepest - 6e-4;
  const scene::EdgeCertificate certificate = certify(problem_, plan_, options);
  ASSERT_FALSE(certificate);
  EXPECT_EQ(certificate.doubts.front().verdict, scene::Verdict::refuted);
  EXPECT_NE(texts(certificate).find("depth"), std::string::npos) << texts(certificate);
}

TEST_F(CertifyOne, BoundsHoldBetweenTheEnds) {
  std::mt19937_64 rng(9);
  const Options options;
  for (const FingerModel model : {FingerModel::flexure, FingerModel::rigid_guarded}) {
    problem_.hand.finger_model = model;
    const Examination examination(problem_, plan_, options);
    const int frame = problem_.robot.frame("left_fingertip");
    const auto& rows = segment("slide").positions;
    for (std::size_t row = 1; row < rows.size(); ++row) {
      Eigen::VectorXd step = rows[row] - rows[row - 1];
      for (auto& joint : step) joint += std::uniform_real_distribution<double>(-.03, .03)(rng);
      const auto finger = [&](double t) { return examination.finger(rows[row - 1] + t * step); };
      const ReplayedFinger from = finger(0), to = finger(0.5);
      const FingerSpan span = finger_span(problem_.hand, from, to,
                                          scene::frame_rates(problem_.robot, frame, step), 0.5);
      double path = 0, turn = 0;
      ReplayedFinger before = from;
      for (int k = 1; k <= 50; ++k) {
        const ReplayedFinger now = finger(k / 100.0);
        constexpr double kTiny = 1e-12;
        EXPECT_LE(span.min_depth, now.depth + kTiny);
        EXPECT_GE(span.max_depth, now.depth - kTiny);
        EXPECT_LE(span.min_pitch, now.pitch + kTiny);
        EXPECT_GE(span.max_pitch, now.pitch - kTiny);
        EXPECT_LE(span.min_bent, now.bent + kTiny);
        EXPECT_GE(span.max_bent, now.bent - kTiny);
        EXPECT_GE(span.max_roll, std::abs(now.roll) - kTiny);
        EXPECT_LE(span.min_other_finger_up, now.other_finger_up + kTiny);
        const double s = k / 50.0;
        const auto off = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                             const Eigen::Vector2d& p) { return (p - a - s * (b - a)).norm(); };
        EXPECT_LE(off(from.commanded, to.commanded, now.commanded), span.commanded_off + kTiny);
        EXPECT_LE(off(from.effective, to.effective, now.effective), span.effective_off + kTiny);
        EXPECT_LE(off(from.heading, to.heading, now.heading), span.heading_off + kTiny);
        path += (now.effective - before.effective).norm();
        turn += (now.heading - before.heading).norm();
        before = now;
      }
      EXPECT_LE(path, span.effective_path + 1e-12);
      EXPECT_LE(turn, span.turn + 1e-12);
    }
  }
}

TEST_F(CertifyOne, ASegmentThatJumpsIsDoubted) {
  for (Segment& s : plan_.segments) {
    if (s.name == "lift") s.positions.front()[0] += 5e-7;
  }
  EXPECT_TRUE(check(problem_, plan_).empty());
  const scene::EdgeCertificate certificate = certify(problem_, plan_);
  ASSERT_EQ(certificate.doubts.size(), 1u);
  EXPECT_EQ(certificate.doubts.front().segment, "lift");
  EXPECT_EQ(certificate.doubts.front().row, 0u);
  EXPECT_EQ(certificate.num_certified(), certificate.num_edges);
}

TEST_F(CertifyOne, WhatIsNoPlanThrows) {
  Plan missing = plan_;
  missing.segments.pop_back();
  EXPECT_THROW(certify(problem_, missing), std::invalid_argument);
  EXPECT_THROW(certify(problem_, Plan{}), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::slide
