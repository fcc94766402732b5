// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connects the targets to libFuzzer: graspless_fuzz --target=NAME [libFuzzer's flags] [FOLDER...]
#include <cstdlib>
#include <iostream>
#include <string>
#include <typeinfo>

#include "fuzz/targets.hpp"

namespace {

const graspless::fuzz::Target* chosen = nullptr;

[[noreturn]] void refuse_arguments() {
  std::cerr << "Give --target=NAME, one of:";
  for (const auto& target : graspless::fuzz::kTargets) std::cerr << ' ' << target.name;
  std::cerr << '\n';
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string flag = "--target=";
  for (int i = 1; i < *argc; ++i) {
    const std::string argument = (*argv)[i];
    if (argument.rfind(flag, 0) != 0) continue;
    for (const auto& target : graspless::fuzz::kTargets) {
      if (argument == flag + target.name) chosen = &target;
    }
  }
  if (!chosen) refuse_arguments();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    chosen->run({data, size});
  } catch (const std::exception& error) {
    std::cerr << typeid(error).name() << ": " << error.what() << '\n';
    std::abort();
  }
  return 0;
}
