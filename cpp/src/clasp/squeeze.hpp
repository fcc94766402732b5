// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clasp/search/clasp_search.hpp"

namespace graspless::clasp {

/// Closes the hand tighter: moves the arm a little at random with the fingers a little open, closes
/// them again, and keeps what lets them close further, until that fails often. The reach is
/// continued to where the fingers close last. Returns false, and leaves both paths, if nothing is
/// better.
bool squeeze(ClaspSearch& search, planning::Path& reach, planning::Path& close);

}  // namespace graspless::clasp
