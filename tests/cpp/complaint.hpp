// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace graspless {

/// What std::invalid_argument says; empty, and a failure, when nothing is thrown.
template <typename Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

/// The call is refused, with a message that names `words`.
template <typename Call>
void expect_refused(Call call, const std::string& words) {
  const std::string said = complaint(call);
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

/// Faults in one text, a line each.
inline std::string joined(const std::vector<std::string>& faults) {
  std::string all;
  for (const std::string& fault : faults) all += fault + "\n";
  return all;
}

}  // namespace graspless
