# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a slide: from above, and the robot at four moments."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.path import Path

from ... import frames
from ...report import the
from .. import raster
from ..bodies import OBJECT, TRAIL, obstacles
from ..figures import INK, draw_panel, failure, hull, new_figure
from . import stage
from .film import film

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...frames import Matrix
    from ...slide import Plan
    from ..film import Film

TABLE, BAND, BAND_EDGE = "#e6d9c3", "#f1e8da", "#b8a88c"
OUTLINE = "#8a5a00"
EDGE = "#1f6f4a"
OBSTACLE = "#7f93ab"
PANEL = (560, 350)  # pixels
LETTER = 0.62  # width of a letter over its height, at most


def draw(plan: Plan) -> Figure:
    """Returns the picture of a plan."""
    shown = film(plan)
    figure = new_figure(15, 6.5)
    grid = figure.add_gridspec(
        2, 3, width_ratios=[1.1, 1, 1], left=0.045, right=0.99, bottom=0.155, top=0.88,
        wspace=0.05, hspace=0.1,
    )  # fmt: skip
    _draw_slide(figure.add_subplot(grid[:, 0]), shown)
    camera = stage.camera(shown, *PANEL)
    moments, beside = stage.moments(shown), obstacles(plan.task)
    for k, (row, caption) in enumerate(moments):
        alone = len(moments) == 1
        axes = figure.add_subplot(grid[:, 1:] if alone else grid[k // 2, 1 + k % 2])
        p_WO, around = shown.object_poses[row][:3, 3], stage.placed(shown, row)
        picture = raster.render_past(beside, around, p_WO, camera, *PANEL)
        draw_panel(axes, picture, caption, pad=3)
    _draw_key(figure, shown)
    figure.suptitle(headline(plan), x=0.045, y=0.975, ha="left", fontsize=14, color=INK)
    return figure


def headline(plan: Plan) -> str:
    """Returns a title: the result of the plan, or the reason of failure."""
    if not plan:
        return failure(plan)
    distance = np.linalg.norm(plan.X_WO_goal[:3, 3] - plan.X_WO_start[:3, 3])
    problem = plan.task.problem
    moved = f"{problem.robot.name} slides {the(problem.object.name)} {distance * 100:.0f} cm"
    is_left = problem.X_WO_end is not None
    return f"{moved} and leaves it there" if is_left else f"{moved} to the edge and grasps it there"


def _draw_key(figure: Any, shown: Film) -> None:
    """Explains every line, area and mark."""
    first, last = (Patch(fc=OBJECT, alpha=alpha) for alpha in (0.16, 0.95))
    handles: dict[str, Any] = {
        "object at the start": (first, Line2D([], [], color=OUTLINE, ls="--", lw=1.4)),
        "object in between": Patch(fc=(*OBJECT, 0.16), ec=OUTLINE, lw=0.5),
        "object at the end": (last, Line2D([], [], color=OUTLINE, lw=1.4)),
        "centre of mass": Line2D([], [], ls=":", color=INK, lw=1, marker="o", mfc="w", mec=INK),
        "fingertip": Line2D([], [], color=TRAIL, lw=2.4),
        "goal band of the fingertip": Patch(fc=BAND, ec=BAND_EDGE),
        "edge for the grasp, overhang": Line2D([], [], color=EDGE, lw=3),
        "obstacle": Patch(fc=OBSTACLE, ec=INK),
        "robot's base": Line2D([], [], ls="", marker="s", ms=10, color="#9aa0a6", mec=INK),
    }
    if not shown.plan:
        for name in ("in between", "at the end"):
            del handles[f"object {name}"]
        del handles["fingertip"]
    is_left = shown.plan.task.problem.X_WO_end is not None
    if is_left:
        del handles["goal band of the fingertip"]
    if is_left or not shown.plan:
        del handles["edge for the grasp, overhang"]
    if not obstacles(shown.plan.task):
        del handles["obstacle"]
    figure.legend(
        list(handles.values()), list(handles), loc="lower left", bbox_to_anchor=(0.035, 0.0),
        ncols=5, fontsize=9.5, frameon=False, columnspacing=2.2,
    )  # fmt: skip


def _draw_slide(axes: Any, shown: Film) -> None:
    """Draws the slide from above, in S."""
    task = shown.plan.task
    support, thing = task.problem.support, task.problem.object
    X_SW = np.linalg.inv(np.asarray(support.X_WS))
    table = np.asarray(support.polygon.vertices)
    axes.set_aspect("equal")
    is_left = task.problem.X_WO_end is not None
    color = TABLE if is_left else BAND
    _fill(axes, table, facecolor=color, edgecolor=INK, linewidth=1.6, zorder=1)
    for core in [] if is_left else getattr(support.goal_band, "core", []):
        ring = np.asarray(core.vertices)
        _fill(axes, ring, facecolor=TABLE, edgecolor=BAND_EDGE, linewidth=0.8, zorder=2)
    rings: dict[str, list[Matrix]] = {}
    for body, X_WB in obstacles(task):
        points_S = [frames.transform(X_SW @ X_WB, part.vertices) for part in body.parts]
        of_parts = [hull(points[:, :2]) for points in points_S]
        is_below = max(points[:, 2].max() for points in points_S) < 0
        order = 0 if is_below else 3
        for ring in of_parts:
            _fill(axes, ring, facecolor=INK, edgecolor=INK, linewidth=1.6, zorder=order)
        for ring in of_parts:  # hides the lines within
            _fill(axes, ring, facecolor=OBSTACLE, linewidth=0, zorder=order)
        if not is_below:
            rings[body.name] = of_parts
    outline = np.asarray(thing.outline.vertices)
    poses = [X_SW @ X_WO for X_WO in _along(shown)]
    for k, X_SO in enumerate(poses):
        first, last = k == 0, k == len(poses) - 1
        ring = outline @ X_SO[:2, :2].T + X_SO[:2, 3]
        axes.fill(*ring.T, color=OBJECT, alpha=0.95 if last else 0.16, zorder=4, lw=0)
        style = "--" if first else "-"
        width = 1.4 if first or last else 0.5
        axes.plot(*np.vstack([ring, ring[:1]]).T, style, color=OUTLINE, lw=width, zorder=5)
    com = np.array([(X @ [*np.asarray(thing.com), 1.0])[:2] for X in poses])
    axes.plot(*com.T, ":", color=INK, lw=1, zorder=6)
    axes.plot(*com[-1], "o", ms=9, mfc="w", mec=INK, zorder=7)
    axes.plot(*com[-1], "+", ms=9, color=INK, zorder=8)
    _draw_trail(axes, shown, X_SW)
    base = X_SW @ np.append(shown.link_poses[0, 0, :3, 3], 1)
    axes.plot(*base[:2], "s", ms=11, color="#9aa0a6", mec=INK, zorder=3)
    ends = outline @ poses[-1][:2, :2].T + poses[-1][:2, 3]
    _frame(axes, np.vstack([table, base[None, :2], ends]))
    _name_obstacles(axes, rings)
    if shown.plan and not is_left:
        _draw_overhang(axes, shown, outline, poses[-1])


def _name_obstacles(axes: Any, rings: dict[str, list[Matrix]]) -> None:
    """Writes names into the largest part that is seen of each obstacle, or beside a small one."""
    size = 8.0  # [points]
    axes.apply_aspect()
    for name, of_parts in rings.items():
        clipped = [Path(ring, closed=True).clip_to_bbox(axes.viewLim) for ring in of_parts]
        seen = [ring for ring in (np.asarray(path.vertices) for path in clipped) if len(ring)]
        if not seen:
            continue
        ring = max(seen, key=_area)
        width, height = 72 / axes.figure.dpi * np.ptp(axes.transData.transform(ring), axis=0)
        center, low = (ring.min(axis=0) + ring.max(axis=0)) / 2, ring.min(axis=0)
        fits = LETTER * size * len(name) < 0.8 * width and 1.5 * size < height and _is_wide(ring)
        axes.annotate(
            name, center if fits else (center[0], low[1]), (0, 0) if fits else (0, -3),
            textcoords="offset points", ha="center", va="center" if fits else "top", fontsize=size,
            zorder=9, color="w" if fits else INK,
        )  # fmt: skip


def _is_wide(ring: Matrix) -> bool:
    """True unless an outline is a bar, which fills little of the box around it."""
    return _area(ring) > 0.5 * float(np.prod(np.ptp(ring, axis=0)))


def _area(ring: Matrix) -> float:
    x, y = ring.T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2


def _frame(axes: Any, points: Matrix) -> None:
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.08 * (high - low).max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_xlabel("x on the support [m]", fontsize=9)
    axes.set_ylabel("y [m]", fontsize=9)
    axes.tick_params(labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _draw_trail(axes: Any, shown: Film, X_SW: Matrix) -> None:
    rows = shown.rows("slide")
    if len(rows) < 2:
        return
    tips = shown.frame(shown.plan.task.problem.hand.fingertip)[rows, :3, 3]
    tips = frames.transform(X_SW, tips)[:, :2]
    axes.plot(*tips.T, color=TRAIL, lw=2.4, zorder=10)
    axes.plot(*tips[0], "o", ms=6, color=TRAIL, zorder=10)
    far = np.flatnonzero(np.linalg.norm(tips - tips[-1], axis=1) > 0.025)
    back = far[-1] if len(far) else 0
    arrow = {"arrowstyle": "-|>", "color": TRAIL, "lw": 2.4, "mutation_scale": 16}
    axes.annotate("", tips[-1], tips[back], arrowprops=arrow, zorder=10)


def _draw_overhang(axes: Any, shown: Film, outline: Matrix, X_SO: Matrix) -> None:
    """Draws an arrow from the edge to the point of the object that sticks out farthest."""
    ring = outline @ X_SO[:2, :2].T + X_SO[:2, 3]
    polygon = shown.plan.task.problem.support.polygon
    out = ring[[polygon.depth(p) < 0 for p in ring]]
    edge = polygon.nearest_edge(out.mean(axis=0) if len(out) else X_SO[:2, 3])
    inward = np.asarray(edge.inward)
    depth = (ring - np.asarray(edge.a)) @ inward
    tip = ring[depth.argmin()]
    foot = tip - inward * depth.min()
    along = np.stack([np.asarray(edge.a), np.asarray(edge.b)])
    axes.plot(*along.T, color=EDGE, lw=3, zorder=3, solid_capstyle="butt")
    arrow: dict[str, Any] = {"arrowstyle": "<|-|>", "color": EDGE, "lw": 1.2}
    arrow |= {"shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
    axes.annotate("", tip, foot, arrowprops=arrow, zorder=11)
    text = axes.annotate(
        f"overhang {shown.plan.overhang * 100:.1f} cm", tip, -6 * inward, fontsize=9,
        textcoords="offset points", color=EDGE, zorder=11,
    )  # fmt: skip
    table = axes.transData.transform_path(Path(np.asarray(polygon.vertices), closed=True))
    for side, rise in _sides(inward):
        text.set(ha=side, va=rise)
        if not table.intersects_bbox(text.get_window_extent(), filled=False):
            break


def _sides(inward: Matrix) -> list[tuple[str, str]]:
    """Returns alignments of a text beyond an edge, whichever direction that is on the page."""
    side = {-1: "left", 0: "center", 1: "right"}[round(float(inward[0]))]
    rise = {-1: "bottom", 0: "center", 1: "top"}[round(float(inward[1]))]
    if side == "center":
        return [(other, rise) for other in ("center", "right", "left")]
    return [(side, other) for other in (rise, "bottom", "top")]


def _along(shown: Film) -> list[Matrix]:
    """Returns up to seven poses of the object, evenly spaced along its path."""
    rows = shown.rows("slide")
    if len(rows) < 2:
        return [shown.object_poses[-1]]
    steps = np.linalg.norm(np.diff(shown.object_poses[rows, :3, 3], axis=0), axis=1)
    length = np.concatenate([[0.0], np.cumsum(steps)])
    wanted = np.linspace(0, length[-1], 7)
    return [shown.object_poses[rows[i]] for i in np.searchsorted(length, wanted - 1e-12)]


def _fill(axes: Any, ring: Matrix, **style: Any) -> None:
    axes.fill(*ring.T, **style)
