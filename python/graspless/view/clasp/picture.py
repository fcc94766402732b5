# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a clasp: the robot at three moments, the loops, the hand, and the virtual linking."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from ... import frames
from ...report import the
from .. import raster
from ..bodies import LOOP, vertices_of
from ..figures import INK, draw_panel, failure, new_figure
from ..loops import draw_cloud
from . import bodies, stage
from .film import film, linking

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...clasp import Plan
    from ...frames import Matrix
    from ..bodies import Body
    from ..film import Film
    from ..raster import Camera

    Placed = list[tuple[Body, Matrix]]

PANEL = (560, 400)  # pixels
THROUGH = 0.75  # visibility of hidden loops and curves


def draw(plan: Plan) -> Figure:
    """Returns the picture of a plan."""
    shown = film(plan)
    figure = new_figure(15, 7.6)
    grid = figure.add_gridspec(
        2, 3, width_ratios=[1, 1, 1], left=0.01, right=0.985, bottom=0.075, top=0.865,
        wspace=0.04, hspace=0.1,
    )  # fmt: skip
    scene, rows = stage.Scene(plan, shown), stage.moments(plan)
    view = stage.camera(scene, [row for row, _ in rows], PANEL)
    places = [grid[0, 0], grid[0, 1], grid[0, 2]] if len(rows) > 1 else [grid[:, :2]]
    for place, (row, caption) in zip(places, rows, strict=True):
        axes = figure.add_subplot(place)
        draw_panel(axes, _render(scene, row, scene.solid(row), view), caption, pad=3)
        if row == 0 or len(rows) == 1:
            _draw_tree(axes, plan, view)
    if len(rows) > 1:
        _draw_loops(figure.add_subplot(grid[1, 0]), plan, shown)
        last = rows[-1][0]
        near = stage.close_camera(scene, last, PANEL)
        axes = figure.add_subplot(grid[1, 1])
        picture = _render(scene, last, scene.solid(last, near), near)
        draw_panel(axes, picture, "close-up: finger curves and chords", pad=3)
        _draw_linking(_inset(figure, grid[1, 2]), plan, shown)
    else:
        _draw_loops(figure.add_subplot(grid[0, 2]), plan, shown)
    figure.suptitle(headline(plan), x=0.015, y=0.975, ha="left", fontsize=14, color=INK)
    _draw_key(figure, plan)
    return figure


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    problem = plan.task.problem
    if not plan:
        return failure(plan)
    assert plan.stability is not None
    loops = len(problem.object.loops.found)
    which = "" if loops == 1 else f" by loop {plan.loop or 0} of {loops} (from 0)"
    held = "secure" if plan.stability.secure else "not secure"
    margin = f"{held}, margin {plan.stability.margin:.2f}"
    return f"{problem.robot.name} clasps {the(problem.object.name)}{which}: {margin}"


def _render(scene: stage.Scene, row: int, solid: Placed, view: Camera) -> Matrix:
    """Renders a row in which loops and curves show through whatever hides them."""
    lines, thing = scene.lines(row), (scene.object, scene.shown.object_poses[row])
    middle = vertices_of([thing]).mean(axis=0)
    whole = raster.render_past(scene.obstacles, [*solid, *lines], middle, view, *PANEL)
    if not lines:
        return whole
    return raster.over(raster.render(lines, view, *PANEL), whole, THROUGH)


def _draw_tree(axes: Any, plan: Plan, view: Camera) -> None:
    """Draws nodes and branches of the search tree, and the path to the clasp."""
    points = plan.tree.p_W
    if not len(points):
        return
    xy = view.project(points, *PANEL)[:, :2]
    parents = np.array(plan.tree.parents)
    axes.add_collection(
        LineCollection(
            list(np.stack([xy, xy[parents]], axis=1)), colors=[bodies.NODE], linewidths=0.6
        )
    )
    axes.plot(*xy.T, ".", ms=2, color=bodies.NODE)
    if plan.tree.path:
        path = xy[list(plan.tree.path)]
        axes.plot(*path.T, "-", lw=2, color=bodies.PATH, solid_capstyle="round")
        axes.plot(*path[-1], "o", ms=5, color=bodies.PATH, mec="w", mew=0.8)
    axes.set_xlim(0, PANEL[0])
    axes.set_ylim(PANEL[1], 0)


def _draw_loops(axes: Any, plan: Plan, shown: Film) -> None:
    """Draws the point cloud with its loops, from a side that looks into the hole."""
    problem = plan.task.problem
    X_WO = shown.object_poses[0]
    cloud = frames.transform(X_WO, problem.object.points)
    middle = (cloud.min(axis=0) + cloud.max(axis=0)) / 2
    eye = middle + 4 * bodies.size(plan.task) * stage.direction(plan, shown)
    view = raster.Camera(eye, middle).fitted(cloud, *PANEL)
    rings = [frames.transform(X_WO, loop.points) for loop in problem.object.loops.found]
    draw_cloud(axes, cloud, rings, -1 if plan.loop is None else plan.loop, view, PANEL)
    if plan.target is not None:
        spot = view.project(frames.transform(X_WO, [plan.target.point]), *PANEL)[0]
        axes.plot(*spot[:2], "o", ms=7, mfc="w", mec=INK, mew=1)


def _inset(figure: Any, place: Any) -> Any:
    """Returns axes with room for their labels inside a cell of the grid."""
    inner = place.subgridspec(1, 1)
    axes = figure.add_subplot(inner[0])
    box = axes.get_position()
    axes.set_position([box.x0 + 0.035, box.y0, box.width - 0.035, box.height])
    return axes


def _draw_linking(axes: Any, plan: Plan, shown: Film) -> None:
    """Draws the virtual linking of every finger curve at each row, and the threshold."""
    found = linking(plan)
    fingers = plan.fingers or [finger.name for finger in plan.task.problem.hand.fingers]
    rows = np.arange(len(found))
    first = len(plan.segments[0])
    axes.axvspan(first - 0.5, len(found) - 1, color="#f1e8da", lw=0, zorder=0)
    # Unlike those of loops, curves and chords beside it.
    colors = [(0.15, 0.17, 0.20), (0.80, 0.47, 0.05), (0.45, 0.52, 0.10), (0.45, 0.27, 0.15)]
    for k in range(found.shape[1]):
        name = fingers[k].replace("_", " ")
        axes.plot(rows, found[:, k], lw=1.9, color=colors[k % len(colors)], label=name)
    axes.axhline(plan.min_linking, color="#b3261e", lw=1.1, ls=(0, (6, 3)), label="least allowed")
    late = first > 0.85 * len(found)
    axes.text(
        len(found) - 1 if late else first, 1.015, "hand closes", fontsize=9, color=INK, va="bottom",
        ha="right" if late else "left", transform=axes.get_xaxis_transform(),
    )  # fmt: skip
    axes.set_xlim(0, max(len(found) - 1, 1))
    axes.set_ylim(0, 1.02)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_title("virtual linking (1: closed ring)", fontsize=11, color=INK, loc="left", pad=3)
    axes.set_xlabel("row of the plan", fontsize=9, color=INK)
    axes.tick_params(labelsize=8)
    axes.legend(fontsize=8.5, frameon=False, loc="best")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _draw_key(figure: Any, plan: Plan) -> None:
    """Explains every colour."""
    lines = [
        (bodies.CLASPED, "-", "clasped loop"),
        (LOOP, "-", "other loops"),
        (bodies.CURVE, "-", "finger curve"),
        (bodies.CHORD, "-", "its chord"),
        (bodies.NODE, "-", "search tree"),
        (bodies.PATH, "-", "path found"),
    ]
    if not plan:
        lines = lines[1:4]
    elif len(plan.task.problem.object.loops.found) < 2:
        lines.pop(1)
    handles = [
        Line2D([], [], color=color, ls=ls, lw=2.5, label=label) for color, ls, label in lines
    ]
    if plan.target is not None:
        target: dict[str, Any] = {"marker": "o", "ms": 7, "mfc": "w", "mec": INK}
        handles.insert(1, Line2D([], [], ls="", label="target", **target))
    figure.legend(
        handles=handles, loc="upper left", bbox_to_anchor=(0.008, 0.955), ncols=len(handles),
        fontsize=10, frameon=False, handlelength=1.4, columnspacing=1.4,
    )  # fmt: skip
