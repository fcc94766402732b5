// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graspless/fingertip/options.hpp"
#include "graspless/mechanics/withstands.hpp"

namespace graspless::fingertip {

/// Contacts of a row, and the control modes of its fingers.
struct RowContacts {
  mechanics::ContactSet set;
  mechanics::ControlModes best;
};

/// Nominal forces of a row, and what it withstands with them.
struct RowForces {
  std::optional<mechanics::Equilibrium> nominal;
  double compliant_stability = 0;
  mechanics::Promise promise;
};

/// Forces of every row, by options.threads. They do not depend on the number of threads.
std::vector<RowForces> forces_of(const std::vector<RowContacts>& rows, const Options& options,
                                 const mechanics::Yield& yield);

}  // namespace graspless::fingertip
