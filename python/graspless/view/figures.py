# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for matplotlib figures."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from ..frames import Matrix

INK = (0.15, 0.17, 0.20)
DPI = 110  # pixels per inch


def new_figure(width: float, height: float, dpi: int = DPI) -> Figure:
    """Returns a white page; sizes in inches."""
    figure = Figure(figsize=(width, height), dpi=dpi, facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def as_png(figure: Figure) -> bytes:
    """Returns the bytes of a PNG file."""
    file = io.BytesIO()
    figure.savefig(file, format="png")
    return file.getvalue()


def draw_panel(axes: Any, picture: Matrix, caption: str, **title: Any) -> None:
    """Draws a rendered picture with a caption."""
    axes.imshow(picture, interpolation="antialiased")
    axes.set_title(caption, fontsize=11, color=INK, loc="left", **title)
    axes.set_axis_off()
