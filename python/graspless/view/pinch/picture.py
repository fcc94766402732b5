# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a pinch: the robot at three moments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...report import the
from ...report.pinch import width
from .. import raster
from ..bodies import obstacles
from ..figures import failure, panels
from ..slide.film import film
from ..slide.stage import camera, placed

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
    beside, places = obstacles(plan.task), shown.object_poses[:, :3, 3]
    drawn = [
        (raster.render_past(beside, placed(shown, row), places[row], view, *PANEL), text)
        for row, text in moments
    ]
    return panels(headline(plan), drawn)


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    problem = plan.task.problem
    if not plan:
        return failure(plan)
    pinched = f"{problem.robot.name} pinches {the(problem.object.name)}"
    return f"{pinched} where it is {1000 * width(plan):.0f} mm wide"
