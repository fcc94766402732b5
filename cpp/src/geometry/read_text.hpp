// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace graspless::geometry {

/// Returns the content of a file. Throws std::invalid_argument that starts with the path, and says
/// why the file cannot be read.
std::string read_text(const std::string& path);

}  // namespace graspless::geometry
