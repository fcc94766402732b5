// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs every file that a fuzzer once found a fault with: tests/fuzz/regressions/TARGET/NAME.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "cpp/paths.hpp"
#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Replay, BreaksNoLaw) {
  int replayed = 0;
  for (const Target& target : kTargets) {
    const fs::path folder = fs::path(checkout_file("tests/fuzz/regressions")) / target.name;
    if (!fs::is_directory(folder)) continue;  // nothing was found yet
    for (const auto& entry : fs::directory_iterator(folder)) {
      const auto bytes = bytes_of(entry.path());
      EXPECT_NO_THROW(target.run({bytes.data(), bytes.size()})) << entry.path();
      ++replayed;
    }
  }
  EXPECT_GT(replayed, 0);
}

}  // namespace
}  // namespace graspless::fuzz
