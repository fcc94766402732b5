# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments of the papers, run by `graspless bench` in a checkout."""
