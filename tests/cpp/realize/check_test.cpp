// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Each promise of a realization, broken in turn.
#include <functional>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "realize/plans.hpp"

namespace graspless::fingertip {
namespace {

/// The cube between two arms, grasped anew half way.
class FingertipRealizeCheck : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Eigen::VectorXd home = Eigen::VectorXd::Zero(6);
    home[0] = 1.2;
    home[3] = -1.2;
    sound_ = new Realization(realize(given().problem, given().plan, two_arms(), two_tips(), home));
  }
  static void TearDownTestSuite() { delete sound_; }
  void SetUp() override { ASSERT_TRUE(*sound_) << sound_->reason; }

  static const CubeSlide& given() {
    static const CubeSlide cube;
    return cube;
  }
  static std::string examine(const Realization& realization) {
    return joined(check(given().problem, given().plan, two_arms(), two_tips(), realization));
  }
  /// What check() says when a sound realization was spoilt.
  static std::string spoilt(const std::function<void(Realization&)>& spoil) {
    Realization copy = *sound_;
    spoil(copy);
    return examine(copy);
  }

  static Realization* sound_;
};
Realization* FingertipRealizeCheck::sound_ = nullptr;

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(FingertipRealizeCheck, ASoundOneHolds) { EXPECT_EQ(examine(*sound_), ""); }

TEST_F(FingertipRealizeCheck, NotFound) {
  EXPECT_SAYS(examine(Realization()), "realization: not found");
}

TEST_F(FingertipRealizeCheck, AMissingSegment) {
  EXPECT_SAYS(spoilt([](Realization& r) { r.segments.pop_back(); }), "segments are approach");
}

TEST_F(FingertipRealizeCheck, RowsWithoutPoses) {
  EXPECT_SAYS(spoilt([](Realization& r) { r.segments[2].X_WO.pop_back(); }),
              "joint segment 2 (slide), row 0: needs rows");
}

TEST_F(FingertipRealizeCheck, AValueThatIsNotFinite) {
  EXPECT_SAYS(spoilt([](Realization& r) { r.segments[1].positions[2][0] = NAN; }),
              "joint segment 1 (touch), row 2: has the wrong size");
}

TEST_F(FingertipRealizeCheck, FingersGivenTwice) {
  EXPECT_SAYS(spoilt([](Realization& r) {
                r.finger_of_fingertip = {0, 0};
              }),
              "finger_of_fingertip");
}

TEST_F(FingertipRealizeCheck, FingersSwapped) {
  const auto said =
      spoilt([](Realization& r) { std::swap(r.finger_of_fingertip[0], r.finger_of_fingertip[1]); });
  EXPECT_SAYS(said, "from its place");
}

TEST_F(FingertipRealizeCheck, AJump) {
  const auto said = spoilt([](Realization& r) {
    auto& s = r.segments[2];
    s.positions.erase(s.positions.begin() + 1, s.positions.end() - 1);
    s.X_WO.erase(s.X_WO.begin() + 1, s.X_WO.end() - 1);
  });
  EXPECT_SAYS(said, "a joint moves by");
  EXPECT_SAYS(said, "the object is not where the plan's motion continues");
}

TEST_F(FingertipRealizeCheck, AFingertipOffItsPlace) {
  const auto said = spoilt([](Realization& r) { r.segments[2].positions[3][2] += 0.002; });
  EXPECT_SAYS(said, "(slide), row 3: finger");
  EXPECT_SAYS(said, "from its place");
}

TEST_F(FingertipRealizeCheck, AFingertipTooDeepInTheObject) {
  const auto said = spoilt([](Realization& r) {
    for (auto& q : r.segments[2].positions) q[0] -= 0.01;
  });
  EXPECT_SAYS(said, "left_3 - cube touch");
}

TEST_F(FingertipRealizeCheck, AnObjectThatMovesByItself) {
  const auto said = spoilt([](Realization& r) { r.segments[0].X_WO[1].translation().x() += 0.01; });
  EXPECT_SAYS(said, "(approach), row 1: the object moves");
}

TEST_F(FingertipRealizeCheck, AnObjectThatStopsShort) {
  const auto said = spoilt([](Realization& r) {
    r.segments[2].X_WO.pop_back();
    r.segments[2].positions.pop_back();
  });
  EXPECT_SAYS(said, "does not come to the end of the plan's motion");
  EXPECT_SAYS(said, "does not continue the segment before it");
}

TEST_F(FingertipRealizeCheck, AFingerThatReachesThroughTheObject) {
  const auto said = spoilt([](Realization& r) {
    auto& reach = r.segments[4];
    for (std::size_t i = 1; i + 1 < reach.positions.size(); ++i)
      reach.positions[i].tail(3) =
          r.segments[3].positions.front().tail(3) + Eigen::Vector3d(0.1, 0, 0);
  });
  EXPECT_SAYS(said, "right_3 - cube touch");
}

TEST_F(FingertipRealizeCheck, AScrubThatIsBelittled) {
  EXPECT_SAYS(spoilt([](Realization& r) { r.segments[2].scrub *= 0.5; }),
              "(slide), row 0: scrub is ");
}

TEST_F(FingertipRealizeCheck, AHomeThatIsNotComeBackTo) {
  const auto said = spoilt([](Realization& r) {
    r.segments.back().positions.pop_back();
    r.segments.back().X_WO.pop_back();
  });
  EXPECT_SAYS(said, "does not end where the approach began");
}

TEST_F(FingertipRealizeCheck, JointsBeyondTheirLimits) {
  const auto said = spoilt([](Realization& r) { r.segments[0].positions[0][1] = 2.6; });
  EXPECT_SAYS(said, "(approach), row 0: leaves the joint limits");
}

}  // namespace
}  // namespace graspless::fingertip
