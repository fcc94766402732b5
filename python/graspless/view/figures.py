# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for matplotlib figures."""

from __future__ import annotations

import io
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .._plan import Plan
    from ..frames import Matrix

INK = (0.15, 0.17, 0.20)
DPI = 110  # pixels per inch
LETTERS = 110  # of a title, at most


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


def failure(plan: Plan) -> str:
    """Returns the title of a plan without motion: the beginning of its reason, on one line.

    A title that is too long ends after a whole word, with an ellipsis.
    """
    name, status = plan.task.problem.object.name, str(plan.status).replace("_", " ")
    title = f"{name}: {status}: {plan.reason.split(';')[0]}"
    lines = textwrap.wrap(title, LETTERS - 2, break_on_hyphens=False)
    return f"{lines[0]} …" if len(lines) > 1 else lines[0]


def hull(points: Matrix) -> Matrix:
    """Returns corners of the convex hull of points in the plane [N, 2], in order."""
    from scipy.spatial import ConvexHull

    return np.asarray(points[ConvexHull(points, qhull_options="QJ").vertices])


def panels(title: str, shown: Sequence[tuple[Matrix, str]]) -> Figure:
    """Returns up to three rendered pictures beside each other, each with its caption."""
    figure = new_figure(15, 4.7)
    grid = figure.add_gridspec(1, 3, left=0.01, right=0.99, bottom=0.02, top=0.84, wspace=0.03)
    for k, (picture, caption) in enumerate(shown):
        axes = figure.add_subplot(grid[0, k] if len(shown) > 1 else grid[0, :])
        draw_panel(axes, picture, caption, pad=3)
    figure.suptitle(title, x=0.015, y=0.96, ha="left", fontsize=14, color=INK)
    return figure
