# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours and fonts of all pictures of results."""

from __future__ import annotations

from typing import Any

COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
STYLE: Any = {"font.size": 9, "axes.spines.top": False, "axes.spines.right": False}
