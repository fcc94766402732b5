// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/read_text.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace graspless::geometry {

std::string read_text(const std::string& path) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(path + ": cannot be read: " + why);
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(std::generic_category().message(errno));
  std::string text;
  for (char block[1 << 16]; file.read(block, sizeof block) || file.gcount() > 0;)
    text.append(block, static_cast<std::size_t>(file.gcount()));
  if (file.bad()) refuse("reading failed");
  return text;
}

}  // namespace graspless::geometry
