# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a carry: the robot at three moments of the path."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...report.carry import moved
from .. import raster
from ..figures import INK, draw_panel, new_figure
from .film import film
from .stage import Scene, camera

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...carry import Plan

PANEL = (520, 420)  # pixels


def draw(plan: Plan) -> Figure:
    """Returns the picture of a plan."""
    shown = film(plan)
    scene = Scene(shown)
    last = len(shown.times) - 1
    rows = [0, last // 2, last] if last > 1 else [0]
    captions = ["1  start", "2  halfway", "3  goal"] if len(rows) > 1 else ["start"]
    view = camera(scene, rows, PANEL)
    figure = new_figure(15, 4.7)
    grid = figure.add_gridspec(1, 3, left=0.01, right=0.99, bottom=0.02, top=0.84, wspace=0.03)
    for k, row in enumerate(rows):
        axes = figure.add_subplot(grid[0, k] if len(rows) > 1 else grid[0, :])
        picture = raster.render([*scene.still, *scene.moving(row)], view, *PANEL)
        draw_panel(axes, picture, captions[k], pad=3)
    figure.suptitle(headline(plan), x=0.015, y=0.96, ha="left", fontsize=14, color=INK)
    return figure


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    problem = plan.task.problem
    if not plan:
        name = problem.object.name
        return f"{name}: {plan.status.name.replace('_', ' ')}: {plan.reason.split(';')[0]}"
    return f"{problem.robot.name} {moved(plan)}"
