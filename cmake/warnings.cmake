# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
function(graspless_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A false alarm of GCC 12 whenever a variant of Eigen matrices (geometry::Shape) is copied from a list.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
  endif()
  if(GRASPLESS_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
