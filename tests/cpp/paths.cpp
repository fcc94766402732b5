// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paths.hpp"

namespace graspless {

std::string checkout_file(const std::string& name) { return GRASPLESS_ROOT "/" + name; }

std::string urdf_file(const std::string& name) {
  return checkout_file(name.empty() ? "urdf" : "urdf/" + name);
}

std::string data_file(const std::string& name) {
  return checkout_file(name.empty() ? "tests/data" : "tests/data/" + name);
}

}  // namespace graspless
