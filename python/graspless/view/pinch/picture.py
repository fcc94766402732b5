# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a pinch: the robot at three moments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...report.pinch import width
from .. import raster
from ..figures import INK, draw_panel, new_figure
from ..slide.stage import camera, placed
from .film import film

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...pinch import Plan

PANEL = (520, 420)  # pixels
MOMENTS = {"approach": "above the object", "grasp": "fingers beside it", "close": "pinched"}


def draw(plan: Plan) -> Figure:
    """Returns the picture of a plan."""
    shown = film(plan)
    found = [(int(shown.rows(name)[-1]), text) for name, text in MOMENTS.items() if plan]
    moments = [(row, f"{k}  {text}") for k, (row, text) in enumerate(found, start=1)]
    moments = moments or [(0, "start")]
    view = camera(shown, *PANEL, [row for row, _ in moments])
    figure = new_figure(15, 4.7)
    grid = figure.add_gridspec(1, 3, left=0.01, right=0.99, bottom=0.02, top=0.84, wspace=0.03)
    for k, (row, caption) in enumerate(moments):
        axes = figure.add_subplot(grid[0, k] if len(moments) > 1 else grid[0, :])
        draw_panel(axes, raster.render(placed(shown, row), view, *PANEL), caption, pad=3)
    figure.suptitle(headline(plan), x=0.015, y=0.96, ha="left", fontsize=14, color=INK)
    return figure


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    problem = plan.task.problem
    name = problem.object.name
    if not plan:
        return f"{name}: {plan.status.name.replace('_', ' ')}: {plan.reason.split(';')[0]}"
    return f"{problem.robot.name} pinches the {name} where it is {1000 * width(plan):.0f} mm wide"
