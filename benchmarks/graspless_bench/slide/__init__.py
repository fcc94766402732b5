# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments of Hang, Morgan and Dollar 2019, with other planners for comparison."""
