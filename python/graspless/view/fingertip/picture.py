# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a fingertip plan: the object at some moments, and its stability along the motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D

from ... import frames
from ...report import count, the
from .. import raster
from ..bodies import obstacles
from ..figures import DPI, INK, draw_panel, failure, new_figure
from . import bodies, carried, curves
from .moments import largest_force, moments
from .stage import camera, swept

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from ...fingertip import Plan
    from ...frames import Matrix
    from ...tasks import Task
    from ..bodies import Body
    from ..raster import Camera
    from .moments import Moment

ACROSS = 5  # panels in a row
WIDTH = 15.0  # of the figure [inches]
HEAD, CURVES, FOOT = 0.5, 2.6, 0.55  # heights [inches]
GAP = 0.3  # for the chart's key, below the robot [inches]
WALLS = 0.5  # transparency of walls
TITLE = {"pad": 2, "y": 0.985}
HIDDEN = 0.3  # visibility of hidden fingertips and forces


def draw(plan: Plan) -> Figure:
    """Returns the picture of a plan."""
    shown = moments(plan)
    across = len(shown) if len(shown) <= ACROSS else -(-len(shown) // 2)
    down = -(-len(shown) // across)
    panel = WIDTH / max(across, 2)
    tall = 0.72 * panel if across < 4 else 0.9 * panel
    rows = [tall] * down
    arm = carried.moments(plan)
    if arm:
        rows.append(WIDTH / len(arm) + GAP)
    if plan.segments:
        rows.append(CURVES)
    heights = [HEAD, *rows]
    figure = new_figure(WIDTH, sum(heights) + FOOT)
    grid = figure.add_gridspec(
        len(heights), 1, height_ratios=heights, left=0.045, right=0.985,
        bottom=FOOT / figure.get_figheight(), top=1, hspace=0.04,
    )  # fmt: skip
    _draw_head(figure.add_subplot(grid[0]), plan)
    scene = _Scene(plan.task, shown, (round(panel * DPI), round(0.92 * tall * DPI)))
    for k, moment in enumerate(shown):
        row = grid[1 + k // across].subgridspec(1, across, wspace=0.02)
        number = f"{k + 1}  " if len(shown) > 1 else ""
        axes = figure.add_subplot(row[k % across])
        draw_panel(axes, scene.render(moment), number + moment.caption, **TITLE)
        for finger, place in enumerate(scene.places(moment)):
            axes.annotate(
                str(finger), place, ha="center", va="center", fontsize=8, color="white",
                weight="bold",
            )  # fmt: skip
    if arm:
        row = grid[1 + down].subgridspec(1, len(arm), wspace=0.02)
        side = round(0.95 * WIDTH / len(arm) * DPI)
        pictures = carried.render(plan, scene.camera.eye - scene.camera.target, (side, side))
        for k, (picture, caption) in enumerate(pictures):
            draw_panel(figure.add_subplot(row[k]), picture, caption, **TITLE)
    if plan.segments:
        curves.draw(figure.add_subplot(grid[len(heights) - 1]), plan)
    return figure


class _Scene:
    """Parts that all panels share: the camera, the floor and the largest force."""

    def __init__(self, task: Task, shown: Sequence[Moment], shape: tuple[int, int]) -> None:
        self.task, self.shape = task, shape
        self.largest = largest_force(shown)
        points = swept(task, shown)
        tails = [bodies.arrow_ends(task, moment, self.largest) for moment in shown]
        tails_W = np.concatenate([ends.reshape(-1, 3) for ends in tails])
        eye = np.eye(4)
        floor = bodies.floor_body(task, points)
        ground = [part.vertices for part in floor.parts]
        everything = np.concatenate([points, tails_W[tails_W.any(axis=1)], *ground])
        self.camera: Camera = camera(task, shown, everything, shape)
        self.still: list[tuple[Body, Matrix]] = [(floor, eye)] if floor.parts else []
        self.still += obstacles(task)
        self.walls = [(body, eye) for body in bodies.wall_bodies(task, points)]
        self.thing = bodies.object_body(task)
        radius = task.problem.fingers.radius
        self.tips = {
            mode: bodies.fingertip_body(radius, color) for mode, color in bodies.MODES.items()
        }

    def render(self, moment: Moment) -> Matrix:
        """Renders a moment; walls, and whatever hides fingertips or forces, are transparent."""
        fingers = [
            (self.tips[mode], frames.translation(center))
            for mode, center in zip(moment.modes, moment.centers_W, strict=True)
            if np.isfinite(center).all()
        ]
        forces = bodies.arrows(self.task, moment, self.largest)
        whole = [*self.still, *fingers, *forces, (self.thing, moment.X_WO)]
        picture = self._render(whole)
        if self.walls:
            picture = _mix(self._render([*whole, *self.walls]), picture, WALLS)
        if fingers:
            picture = raster.over(self._render([*fingers, *forces]), picture, HIDDEN)
        return picture

    def places(self, moment: Moment) -> Matrix:
        """Returns the pixels of the fingertips, [n, 2]; NaN for those off the object."""
        return self.camera.project(moment.centers_W, *self.shape)[:, :2]

    def _render(self, placed: Sequence[tuple[Body, Matrix]]) -> Matrix:
        return raster.render(placed, self.camera, *self.shape)


def _mix(front: Matrix, back: Matrix, share: float) -> Matrix:
    """Blends two pictures with opacity: `share` is that of the one behind."""
    opacity = (1 - share) * front[..., 3:] + share * back[..., 3:]
    color = (1 - share) * front[..., :3] * front[..., 3:] + share * back[..., :3] * back[..., 3:]
    return np.concatenate([color / np.maximum(opacity, 1e-6), opacity], axis=2)


def _draw_head(axes: Any, plan: Plan) -> None:
    """Draws the headline and the key of the colours."""
    axes.set_axis_off()
    axes.set_xlim(0, 1)
    axes.set_ylim(0, 1)
    axes.text(0, 0.42, headline(plan), fontsize=14, color=INK, va="center")
    if not plan.segments:
        return
    balls = [
        Line2D([], [], ls="", marker="o", ms=10, mfc=color, mec=INK, mew=0.6, label=label)
        for color, label in (
            (bodies.POSITION, "fingertip in position control"),
            (bodies.FORCE, "in force control"),
        )
    ]
    arrow = Line2D(
        [], [], ls="-", lw=2.5, marker=">", ms=8, color=bodies.ARROW, label="nominal contact force"
    )
    axes.legend(
        handles=[*balls, arrow], loc="center right", bbox_to_anchor=(1, 0.42), ncols=3,
        fontsize=10, frameon=False, handletextpad=0.4, columnspacing=1.4,
    )  # fmt: skip


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    if not plan and not plan.segments:
        return failure(plan)
    name = the(plan.task.problem.object.name)
    names = dict.fromkeys(s.name for s in plan.segments if s.name != "regrasp")
    verbs = [f"{word[:-1]}ing" if word.endswith("e") else f"{word}ing" for word in names]
    tips = count(plan.task.problem.fingers.count, "fingertips")
    grips = f", {count(plan.regrasps, 'regrasps')}" if plan.regrasps else ""
    moves = " and ".join(verbs).capitalize()
    return f"{moves} {name} with {tips}{grips}"
