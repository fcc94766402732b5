// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "mechanics/contact_sets.hpp"

namespace graspless::mechanics {
namespace {

TEST(Normalized, MendsLengthsAlone) {
  const ContactSet good = sliding_cuboid();
  for (const double length : {1e-200, 1e-3, 7.0, 1e200}) {
    ContactSet set = good;
    for (Contact& contact : set.contacts) contact.n_O *= length;
    set.fingers[1].n_O *= length;
    EXPECT_THROW(validate(set), std::invalid_argument);
    set = normalized(set);
    EXPECT_NO_THROW(validate(set));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_TRUE(set.contacts[i].n_O.isApprox(good.contacts[i].n_O, 1e-15));
    }
    EXPECT_TRUE(set.fingers[1].n_O.isApprox(good.fingers[1].n_O, 1e-15));
  }
}

TEST(Normalized, RefusesWhatHasNoDirection) {
  ContactSet set = sliding_cuboid();
  set.contacts[2].n_O.setZero();
  expect_refused([&] { normalized(set); }, "contacts[2].n_O");
  set = sliding_cuboid();
  set.fingers[0].n_O[1] = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { normalized(set); }, "fingers[0].n_O");
}

}  // namespace
}  // namespace graspless::mechanics
