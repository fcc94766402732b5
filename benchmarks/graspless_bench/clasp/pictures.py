# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the clasp planner's results."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib
from matplotlib.figure import Figure

from ..style import COLORS, STYLE

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row

MARKERS = "osD^v"


def draw(result: Row, directory: Path) -> None:
    """Draws the pictures of a grid into the folder of its file."""
    if result["grid"] == "paper":
        _draw_linking(result["rows"], directory / "clasp_linking.png")


def _draw_linking(rows: Sequence[Row], path: Path) -> None:
    """Draws Figure 6: least against largest linking of each clasp's curves."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9, 4), layout="constrained")
        panels = figure.subplots(1, 2)
        _draw_extremes(panels[0], rows, "gauss", "|Gauss linking integral|, fingers as they are")
        _draw_extremes(panels[1], rows, "virtual_linking", "|virtual linking|")
        figure.legend(
            *panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=9, fontsize=8
        )
        figure.savefig(path, dpi=110)


def _draw_extremes(axes: Any, rows: Sequence[Row], key: str, title: str) -> None:
    hands = list(dict.fromkeys(row["hand"] for row in rows))
    objects = list(dict.fromkeys(row["object"] for row in rows))
    for row in rows:
        if row["found"]:
            color, marker = COLORS[hands.index(row["hand"])], MARKERS[objects.index(row["object"])]
            axes.plot(row[f"{key}_min"], row[f"{key}_max"], marker, color=color, alpha=0.7)
    for hand, color in zip(hands, COLORS, strict=False):
        axes.plot([], [], "s", color=color, label=hand)
    for name, marker in zip(objects, MARKERS, strict=False):
        axes.plot([], [], marker, color="gray", label=name)
    axes.set(title=title, xlabel="least of the hand's curves", ylabel="largest")
    axes.grid(alpha=0.3)
