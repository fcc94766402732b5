// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fuzz targets by name. A target runs one case and throws if a law is broken; a crash, a hang
// or a report of a sanitizer is a find as well. main.cpp gives them to libFuzzer, and
// replay_test.cpp runs them on regressions/NAME/*, with any compiler.
#pragma once

#include <array>

#include "fuzz/bytes.hpp"

namespace graspless::fuzz {

void read_obj(Bytes bytes);
void read_off(Bytes bytes);
void read_ply(Bytes bytes);
void read_stl(Bytes bytes);
void read_urdf(Bytes bytes);
void read_srdf(Bytes bytes);
void read_hand(Bytes bytes);
void solve_mechanics(Bytes bytes);
void use_polygon(Bytes bytes);
void find_loops(Bytes bytes);
void plan_slide(Bytes bytes);
void plan_fingertip(Bytes bytes);

struct Target {
  const char* name;
  void (*run)(Bytes);
};

constexpr std::array<Target, 12> kTargets{{{"obj", read_obj},
                                           {"off", read_off},
                                           {"ply", read_ply},
                                           {"stl", read_stl},
                                           {"urdf", read_urdf},
                                           {"srdf", read_srdf},
                                           {"hand", read_hand},
                                           {"mechanics", solve_mechanics},
                                           {"polygon", use_polygon},
                                           {"loops", find_loops},
                                           {"slide", plan_slide},
                                           {"fingertip", plan_fingertip}}};

}  // namespace graspless::fuzz
