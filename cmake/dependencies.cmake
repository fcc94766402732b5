# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the core is built on, each as one target with SYSTEM includes.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(urdfdom REQUIRED)
find_package(fcl REQUIRED)
find_package(CGAL REQUIRED)
find_package(Threads REQUIRED)

# The SRDF is read with TinyXML, which urdfdom 3 links but urdfdom 4 does not.
find_library(GRASPLESS_TINYXML_LIBRARY tinyxml REQUIRED)

# The target of its config changed its name with 0.8.
find_library(GRASPLESS_YAML_LIBRARY yaml-cpp REQUIRED)

# GLPK comes without a config.
find_library(GRASPLESS_GLPK_LIBRARY glpk REQUIRED)
find_path(GRASPLESS_GLPK_INCLUDE_DIR glpk.h REQUIRED)

# OMPL_LIBRARIES drags in ODE and most of Boost; the planners need libompl alone.
find_package(ompl REQUIRED)
find_library(GRASPLESS_OMPL_LIBRARY ompl REQUIRED)

# All of them, for the library and for the tests and benchmarks that link its objects.
add_library(graspless_dependencies INTERFACE)
target_include_directories(graspless_dependencies SYSTEM INTERFACE "${GRASPLESS_GLPK_INCLUDE_DIR}" "${OMPL_INCLUDE_DIR}")
target_link_libraries(graspless_dependencies INTERFACE
  Eigen3::Eigen ompl urdfdom::urdfdom_model "${GRASPLESS_TINYXML_LIBRARY}" fcl CGAL::CGAL
  "${GRASPLESS_GLPK_LIBRARY}" "${GRASPLESS_YAML_LIBRARY}" Threads::Threads)
