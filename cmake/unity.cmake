# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Both functions keep a first build short, and both are off with GRASPLESS_UNITY=OFF, where every file must include
# what it uses.

# Compiles each folder of a target's sources as one translation unit: Eigen, CGAL and pybind11 are instantiated once a
# folder. A file with a UNITY_GROUP of its own goes there. A file with compile options of its own stays alone, and reads
# no precompiled header, which has other options.
function(graspless_unity target)
  if(NOT GRASPLESS_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    get_source_file_property(own_options ${source} COMPILE_OPTIONS)
    get_source_file_property(own_group ${source} UNITY_GROUP)
    if(own_options)
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    elseif(NOT own_group)
      get_filename_component(folder ${source} DIRECTORY)
      file(RELATIVE_PATH folder ${CMAKE_CURRENT_SOURCE_DIR} ${folder})
      string(REPLACE "/" "_" folder ${folder})
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
    endif()
  endforeach()
endfunction()

# Parses headers once for all units of a target. Give those of other projects only: a change of one of our own would
# compile everything anew.
function(graspless_precompile target)
  if(GRASPLESS_UNITY)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
