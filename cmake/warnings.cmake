# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
function(graspless_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion)
  if(GRASPLESS_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
