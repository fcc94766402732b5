# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments of Stork, Pokorny and Kragic 2013, with a Grasp-RRT for comparison."""

GRIDS = ("paper", "chair", "tolerance", "small", "grasp_rrt", "loops", "holes")
