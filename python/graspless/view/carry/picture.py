# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a carry: the robot at three moments of the path."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...report.carry import moved
from .. import raster
from ..figures import failure, panels
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
    places = shown.object_poses[:, :3, 3]
    drawn = [
        raster.render_past(scene.still, scene.moving(row), places[row], view, *PANEL)
        for row in rows
    ]
    return panels(headline(plan), list(zip(drawn, captions, strict=True)))


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    problem = plan.task.problem
    if not plan:
        return failure(plan)
    return f"{problem.robot.name} {moved(plan)}"
