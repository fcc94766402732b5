// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/pinch/pinch.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "pinch/faces.hpp"
#include "pinch/jaw.hpp"
#include "pinch/things.hpp"
#include "slide/contact_space.hpp"

namespace graspless::pinch {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using slide::Object;

/// Distance between the fingers at the end, across the contacts, computed with tiny steps of FK.
double final_gap(const Problem& problem, const Plan& plan) {
  return Jaw(problem).gap(plan.segments.back().positions.back());
}

TEST(Pinch, PinchesBoxesAndDiscsWhereverTheyStand) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> length(0.03, 0.15), width(0.01, 0.045), height(0.03, 0.15),
      yaw(-3, 3), x(0.5, 0.75), y(-0.2, 0.2);
  for (int i = 0; i < 20; ++i) {
    const geometry::Polygon outline =
        i % 4 == 0 ? slide::disc(width(rng) / 2, 24, {0, 0}) : rectangle(length(rng), width(rng));
    const Problem problem = standing(outline, height(rng), x(rng), y(rng), yaw(rng));
    const Plan found = pinch::plan(problem);
    ASSERT_TRUE(found) << i << ": " << found.reason;
    EXPECT_EQ(joined(check(problem, found)), "");
    const Vector3d across = found.contacts_O.col(1) - found.contacts_O.col(0);
    EXPECT_NEAR(across.norm(), final_gap(problem, found), 3e-3);
    EXPECT_LE(across.norm(), found.opening);
    EXPECT_LE(found.friction, Options{}.friction);
  }
}

/// Both normals of a polygon without noise are within the cone about the line of contacts.
TEST(Pinch, ContactsAreAntipodal) {
  for (const double yaw : {0.0, 0.3, 1.1}) {
    const geometry::Polygon outline = rectangle(0.12, 0.04);
    const Problem problem = standing(outline, 0.06, 0.6, 0, yaw);
    const Plan found = pinch::plan(problem);
    ASSERT_TRUE(found) << found.reason;
    const Vector2d a = found.contacts_O.col(0).head<2>(), b = found.contacts_O.col(1).head<2>();
    const Vector2d along = (b - a).normalized();
    for (const Vector2d& p : {a, b}) {
      const Vector2d inward = outline.nearest_edge(p).inward;
      EXPECT_GE(std::abs(inward.dot(along)), std::cos(std::atan(Options{}.friction)));
      EXPECT_NEAR(outline.depth(p), 0, 1e-3);
    }
    EXPECT_GT(outline.nearest_edge(a).inward.dot(along), 0);
    EXPECT_LT(outline.nearest_edge(b).inward.dot(along), 0);
  }
}

TEST(Pinch, RefusesByLengths) {
  const Plan wide = pinch::plan(standing(rectangle(0.2, 0.12), 0.06));
  EXPECT_EQ(wide.status, Status::too_wide);
  EXPECT_NE(wide.reason.find("120 mm wide where it is narrowest, the hand opens 54 mm"),
            std::string::npos)
      << wide.reason;
  const Plan flat = pinch::plan(standing(rectangle(0.2, 0.03), 0.005));
  EXPECT_EQ(flat.status, Status::too_flat);
  EXPECT_EQ(flat.reason.rfind("5.0 mm high; ", 0), 0U) << flat.reason;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at))
    text.replace(at, old.size(), by), at += by.size();
  return text;
}

/// The opening of the T42 if the first shape of each finger, at its joint, is a box so wide.
double opening_with(const std::string& width) {
  Problem problem = standing(rectangle(0.12, 0.04), 0.06);
  const std::string sphere = "\"0 0 0\"/><geometry><sphere radius=\"0.013\"/>";
  const std::string box = "\"0 0 0\"/><geometry><box size=\"0.02 " + width + " 0.02\"/>";
  problem.robot =
      robot::Robot::from_urdf(replaced(problem.robot.urdf(), sphere, box), problem.robot.options());
  return Jaw(problem).opening();
}

TEST(Jaw, IsAsWideAsTheEndsOfItsFingers) {
  Problem problem = standing(rectangle(0.12, 0.04), 0.06);
  const double opening = Jaw(problem).opening();
  problem.hand.fingers.emplace_back("hand_base");  // behind both fingers, and wider
  EXPECT_EQ(Jaw(problem).opening(), opening);
  EXPECT_EQ(opening_with("0.02"), opening_with("0.07"));
}

/// The WAM with the jaws of a parallel gripper: plates of 20 x 10 mm that end at its fingertips.
robot::Robot with_plates() {
  std::string urdf = slide::wam().urdf();
  urdf = replaced(urdf, "0 0 0.0485\"/><geometry><cylinder radius=\"0.013\" length=\"0.097\"/>",
                  "0 0 0.055\"/><geometry><box size=\"0.02 0.01 0.11\"/>");
  urdf = replaced(urdf, "<sphere radius=\"0.013\"/>", "<sphere radius=\"0.001\"/>");
  for (const std::string side : {"left", "right"}) {
    urdf = replaced(urdf, side + "_finger_joint\" type=\"revolute\"",
                    side + "_finger_joint\" type=\"prismatic\"");
  }
  const std::string limits = " lower=\"0\" upper=\"1.2\"";
  urdf = replaced(urdf, "\"1 0 0\"/><limit" + limits, "\"0 -1 0\"/><limit" + limits);
  urdf = replaced(urdf, "\"-1 0 0\"/><limit" + limits, "\"0 1 0\"/><limit" + limits);
  robot::Robot::Options options = slide::wam().options();
  options.srdf = replaced(options.srdf, "value=\"0.281\"", "value=\"0.0345\"");
  return robot::Robot::from_urdf(replaced(urdf, limits, " lower=\"0\" upper=\"0.035\""), options);
}

/// With contacts near the ends of the pads, the hand closes on lower objects.
TEST(Pinch, TakesLowObjectsWithTheEndsOfItsPads) {
  Problem problem = standing(rectangle(0.16, 0.02), 0.012);
  problem.robot = with_plates();
  problem.hand.finger_model = slide::FingerModel::none;
  const Plan deep = pinch::plan(problem);
  EXPECT_EQ(deep.status, Status::too_flat) << deep.reason;
  Options options;
  options.depth = 0.003;
  options.height = 0;
  const Plan found = pinch::plan(problem, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found, options)), "");
  EXPECT_NEAR(found.contacts_O(2, 0), options.clearance + options.depth, 1e-3);
}

/// A box before the same hand, whose right jaw does not move: the gap is 36 to 70 mm.
Problem before_fixed_jaw(double yaw) {
  Problem problem = standing(rectangle(0.09, 0.045), 0.05, 0.6, 0.1, yaw);
  const robot::Robot plates = with_plates();
  std::string urdf = replaced(plates.urdf(), "right_finger_joint\" type=\"prismatic",
                              "right_finger_joint\" type=\"fixed");
  urdf = replaced(urdf, "<mimic joint=\"left_finger_joint\"/>", "");
  problem.robot = robot::Robot::from_urdf(urdf, plates.options());
  problem.hand.finger_model = slide::FingerModel::none;
  return problem;
}

/// True if the hand comes down without touching the object if that stands `off` across the faces.
bool comes_beside(const Problem& problem, const Plan& found, double off) {
  scene::Scene scene = slide::make_scene(problem);
  const Vector3d across = (found.contacts_O.col(1) - found.contacts_O.col(0)).normalized();
  scene.move_object(scene.world().body(slide::kObjectBody),
                    problem.X_WO_start * Eigen::Translation3d(off * across));
  const int frame = problem.robot.frame(problem.hand.grasp_frame);
  const auto& rows = found.segments[1].positions;
  return std::all_of(rows.begin(), rows.end(), [&](const Eigen::VectorXd& q) {
    const double above =
        -(found.X_WH_grasp.inverse() * problem.robot.pose(frame, q)).translation().z();
    return above < 1e-3 || scene.is_free(q);
  });
}

TEST(Pinch, AFixedJawComesAsideOfTheObject) {
  const Options narrow = [] {
    Options options;
    options.margin = 0;
    return options;
  }();
  for (const double yaw : {0.0, 0.4, 1.4, 1.55, 2.5}) {
    const Problem problem = before_fixed_jaw(yaw);
    for (const double margin : {0.002, 0.008}) {
      Options options;
      options.margin = margin;
      const Plan found = pinch::plan(problem, options);
      ASSERT_TRUE(found) << yaw << ": " << found.reason;
      EXPECT_EQ(joined(check(problem, found, options)), "");
      for (const double side : {-1, 1})
        EXPECT_TRUE(comes_beside(problem, found, side * (margin - 3e-4))) << yaw;
    }
    const Plan touching = pinch::plan(problem, narrow);
    if (!touching) continue;  // rounding decides
    EXPECT_EQ(joined(check(problem, touching, narrow)), "");
    EXPECT_CONTAINS(joined(check(problem, touching)), "a finger passes at");
  }
}

/// The contacts are as near to the asked height as the fingers and the top allow.
TEST(Pinch, TakesTheHeightThatIsAskedFor) {
  const Problem problem = standing(rectangle(0.1, 0.03), 0.12);
  Options options;
  for (const double height : {0.03, 0.05, 0.08}) {
    options.height = height;
    const Plan found = pinch::plan(problem, options);
    ASSERT_TRUE(found) << found.reason;
    EXPECT_EQ(joined(check(problem, found, options)), "");
    EXPECT_DOUBLE_EQ(found.contacts_O(2, 0), height);
  }
  options.height = 1;
  const Plan top = pinch::plan(problem, options);
  ASSERT_TRUE(top) << top.reason;
  EXPECT_DOUBLE_EQ(top.contacts_O(2, 0), 0.12 - options.clearance);
}

/// Unless a height is asked for, the fingers keep a little more than the least clearance.
TEST(Pinch, KeepsOffTheSupportWhereTheObjectIsHigher) {
  Problem problem = standing(rectangle(0.1, 0.02), 0.022);
  problem.robot = with_plates();
  problem.hand.finger_model = slide::FingerModel::none;
  Options options;
  const Plan spare = pinch::plan(problem, options);
  options.height = 0.011;
  const Plan nearest = pinch::plan(problem, options);
  ASSERT_TRUE(spare && nearest) << spare.reason << nearest.reason;
  EXPECT_NEAR(nearest.contacts_O(2, 0), 0.01 + options.clearance, 1e-3);
  EXPECT_NEAR(spare.contacts_O(2, 0) - nearest.contacts_O(2, 0), 0.002, 1e-4);
}

/// A bar whose outline a noisy camera saw.
geometry::Polygon ragged_bar(unsigned seed) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> off(0, 0.0022);
  std::uniform_real_distribution<double> step(0.003, 0.008);
  std::vector<Vector2d> low, high;
  for (double x = -0.08; x < 0.08; x += step(rng)) low.emplace_back(x, -0.008 + off(rng));
  for (double x = 0.08; x > -0.08; x -= step(rng)) high.emplace_back(x, 0.008 + off(rng));
  low.insert(low.end(), high.begin(), high.end());
  return geometry::Polygon(geometry::columns(low));
}

TEST(Pinch, PlansOnRaggedOutlinesHold) {
  int solved = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Problem problem = standing(ragged_bar(seed), 0.03);
    const Plan found = pinch::plan(problem);
    if (!found) continue;
    ++solved;
    EXPECT_EQ(joined(check(problem, found)), "") << seed;
  }
  EXPECT_GT(solved, 150);
}

TEST(Pinch, RefusesFacesThatAreNotOpposite) {
  const geometry::Polygon wedge(geometry::columns({{0, 0}, {0.05, -0.04}, {0.05, 0.04}}));
  Options options;
  options.friction = 0.1;
  const Plan found = pinch::plan(standing(wedge, 0.06), options);
  EXPECT_EQ(found.status, Status::too_slippery) << found.reason;
}

TEST(Pinch, AvoidsObstaclesOrNamesThem) {
  Problem problem = standing(rectangle(0.1, 0.03), 0.05, 0.6, 0, 0);
  const Plan open = pinch::plan(problem);
  ASSERT_TRUE(open);
  const auto box = [](const Vector3d& size) {
    return std::vector<geometry::PlacedShape>{{geometry::Box{size}}};
  };
  for (const double side : {-1.0, 1.0}) {
    problem.obstacles.push_back({side < 0 ? "left" : "right", box({0.4, 0.02, 0.16}),
                                 Eigen::Isometry3d(Eigen::Translation3d(0.6, side * 0.03, 0.08))});
  }
  const Plan walled = pinch::plan(problem);
  ASSERT_FALSE(walled);
  EXPECT_EQ(walled.status, Status::not_reached);
  EXPECT_NE(walled.reason.find("collision"), std::string::npos) << walled.reason;
}

TEST(Pinch, IsTheSameEveryTime) {
  const Problem problem = standing(rectangle(0.1, 0.03), 0.05);
  const Plan a = pinch::plan(problem), b = pinch::plan(problem);
  ASSERT_TRUE(a);
  for (std::size_t i = 0; i < a.segments.size(); ++i)
    EXPECT_EQ(a.segments[i].positions, b.segments[i].positions);
}

TEST(Pinch, CheckFindsEditedPlans) {
  const Problem problem = standing(rectangle(0.1, 0.03), 0.05);
  const Plan sound = pinch::plan(problem);
  ASSERT_TRUE(sound);
  const auto faulty = [&](const Plan& edited) { return !check(problem, edited).empty(); };
  Plan plan = sound;
  plan.contacts_O(1, 0) += 0.02;
  EXPECT_TRUE(faulty(plan));
  plan = sound;
  plan.contacts_O.row(2).setConstant(0.06);
  EXPECT_TRUE(faulty(plan));
  plan = sound;
  plan.segments[2].positions.pop_back();
  plan.segments[2].object_poses.pop_back();
  plan.segments[2].positions.back() = plan.segments[2].positions.front();  // never closed
  EXPECT_TRUE(faulty(plan));
  plan = sound;
  plan.segments[1].positions[1][0] += 0.03;
  EXPECT_TRUE(faulty(plan));
  plan = sound;
  plan.X_WH_grasp.translate(Vector3d(0, 0.01, 0));
  EXPECT_TRUE(faulty(plan));
  plan = sound;
  plan.segments[0].object_poses[0].translate(Vector3d(0, 0.01, 0));
  EXPECT_TRUE(faulty(plan));
  plan = sound;
  std::swap(plan.segments[0], plan.segments[1]);
  EXPECT_TRUE(faulty(plan));
}

TEST(Pinch, CertifiesWhatItPlans) {
  const Problem problem = standing(rectangle(0.1, 0.03), 0.05);
  const Plan found = pinch::plan(problem);
  ASSERT_TRUE(found);
  const scene::EdgeCertificate certificate = certify(problem, found);
  EXPECT_GT(certificate.num_edges, 10);
  EXPECT_TRUE(certificate) << certificate.doubts.front().text();
}

TEST(Pinch, RefusesBadOptions) {
  Options options;
  options.friction = -1;
  EXPECT_NE(complaint([&] { validate(options); }).find("options.friction"), std::string::npos);
}

/// The width of opposite faces is the support function's, for every direction.
TEST(Faces, EncloseTheOutline) {
  const geometry::Polygon outline = slide::disc(0.03, 60, {0.01, -0.02});
  for (const Faces& faces : opposite_faces(outline, {0.01, -0.02}, 0.01)) {
    EXPECT_LE(faces.width, 0.06 + 1e-9);
    const Vector2d along(std::cos(faces.yaw), std::sin(faces.yaw));
    EXPECT_NEAR((faces.second - faces.first).dot(along), faces.width, 1e-9);
    // On a disc, an offset of l from the middle takes a friction of l / sqrt(r^2 - l^2); the pad
    // reaches 5 mm farther.
    const auto needed = [](double l) { return l / std::sqrt(0.03 * 0.03 - l * l); };
    if (faces.lever > 0.02) continue;
    EXPECT_GE(faces.friction, needed(faces.lever) - 0.1);
    EXPECT_LE(faces.friction, needed(faces.lever + 0.005) + 0.1);
  }
}

/// A flat pad touches what is outermost along it: there the contacts are, and there the faces are
/// opposite each other.
TEST(Faces, OfLongPadsAreWhereThePadsTouch) {
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> radius(0.01, 0.04), squash(0.4, 1), noise(-0.0005, 0.0005);
  for (int i = 0; i < 20; ++i) {
    const double r = radius(rng), flat = squash(rng);
    Eigen::Matrix2Xd corners(2, 60);
    for (Eigen::Index k = 0; k < corners.cols(); ++k) {
      const double angle = 2 * M_PI * static_cast<double>(k) / 60, here = r + noise(rng);
      corners.col(k) << here * std::cos(angle), flat * here * std::sin(angle);
    }
    const geometry::Polygon outline(corners);
    const std::vector<Faces> found = opposite_faces(outline, Vector2d::Zero(), 0.02);
    ASSERT_FALSE(found.empty()) << i;
    for (const Faces& pair : found) {
      const Vector2d across(std::cos(pair.yaw), std::sin(pair.yaw)), along(-across.y(), across.x());
      for (const auto& [p, outward] : {std::pair(pair.first, -1.0), {pair.second, 1.0}}) {
        EXPECT_NEAR(outline.depth(p), 0, 0.002);
        for (const double u :
             {-0.008, -0.004, 0.0, 0.004, 0.008})  // the outline is between the pads
          EXPECT_FALSE(outline.contains(p + outward * 5e-4 * across + u * along));
      }
    }
  }
}

TEST(Jaw, OpensAsTheShapesSay) {
  const Problem problem = standing(rectangle(0.1, 0.03), 0.05);
  const Jaw jaw(problem);
  EXPECT_NEAR(jaw.opening(), 0.054, 1e-6);  // capsules of radius 13 mm, 80 mm apart
  for (const double width : {0.01, 0.03, 0.05}) {
    const auto grip = jaw.at_width(width);
    ASSERT_TRUE(grip);
    EXPECT_NEAR(grip->gap, width, 1e-4);
    EXPECT_NEAR(grip->contact_H.y(), 0, 1e-9);  // both fingers close evenly
  }
  EXPECT_FALSE(jaw.at_width(0.06));
}

}  // namespace
}  // namespace graspless::pinch
