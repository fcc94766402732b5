# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments of Maeda and Arai 2005, and larger ones."""
