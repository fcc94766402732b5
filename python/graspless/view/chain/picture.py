# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a chain: the pictures of its stages below each other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...kinds import part
from ..figures import DPI, new_figure
from .stages import stages_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from ...chain import Plan


def draw(plan: Plan) -> Figure:
    """Draws the pictures of the stages on one page."""
    stages = [stage for _, stage in stages_of(plan)]
    drawn = [_pixels(part("view", stage.kind, "picture").draw(stage)) for stage in stages]
    width, height = max(p.shape[1] for p in drawn), sum(p.shape[0] for p in drawn)
    page = new_figure(width / DPI, height / DPI)
    for picture in drawn:
        height -= picture.shape[0]
        page.figimage(picture, 0, height, origin="upper")
    return page


def _pixels(figure: Figure) -> NDArray[np.uint8]:
    """[height, width, 4]"""
    canvas: Any = figure.canvas
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())
