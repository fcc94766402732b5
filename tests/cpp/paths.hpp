// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of this checkout. Only paths.cpp is compiled with its path, so that ccache can share the
// other objects between checkouts.
#pragma once

#include <string>

namespace graspless {

/// Returns the path of a file of the checkout.
std::string checkout_file(const std::string& name);

/// Returns the path of a file in urdf/; of the folder itself for an empty name.
std::string urdf_file(const std::string& name = "");

/// Returns the path of a file in tests/data/; of the folder itself for an empty name.
std::string data_file(const std::string& name = "");

}  // namespace graspless
