# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Experiment `graspless bench robots`: from the URDFs of other people's robots to plans."""
