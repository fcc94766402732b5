# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plan as one picture: the slide from above, and the robot at four moments of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import raster
from ..bodies import OBJECT, obstacles
from ..figures import INK, as_png, draw_panel, new_figure
from . import stage
from .film import film

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...plans.slide import Plan
    from ..film import Film

TRAIL = (0.78, 0.10, 0.32)
PANEL = (560, 350)  # pixels


def draw(plan: Plan) -> bytes:
    """The picture as the bytes of a PNG file."""
    shown = film(plan)
    figure = new_figure(15, 6.5)
    grid = figure.add_gridspec(
        2, 3, width_ratios=[1.1, 1, 1], left=0.045, right=0.99, bottom=0.07, top=0.89,
        wspace=0.05, hspace=0.1,
    )  # fmt: skip
    _draw_slide(figure.add_subplot(grid[:, 0]), shown)
    camera = stage.camera(shown, *PANEL)
    moments = stage.moments(shown)
    for k, (row, caption) in enumerate(moments):
        alone = len(moments) == 1
        axes = figure.add_subplot(grid[:, 1:] if alone else grid[k // 2, 1 + k % 2])
        picture = raster.render(stage.placed(shown, row), camera, *PANEL)
        draw_panel(axes, picture, caption, pad=3)
    figure.suptitle(_headline(plan), x=0.045, y=0.975, ha="left", fontsize=14, color=INK)
    return as_png(figure)


def _headline(plan: Plan) -> str:
    name = plan.task.problem.object.name
    if not plan:
        return f"{name}: {plan.status.replace('_', ' ')}: {plan.reason.split(';')[0]}"
    distance = np.linalg.norm(plan.X_WO_goal[:3, 3] - plan.task.problem.X_WO_start[:3, 3])
    robot = plan.task.problem.robot.name
    return f"{robot} slides the {name} {distance * 100:.0f} cm to the edge and grasps it there"


def _draw_slide(axes: Any, shown: Film) -> None:
    """The slide seen from above, in S."""
    task = shown.plan.task
    support, thing = task.problem.support, task.problem.object
    X_SW = np.linalg.inv(np.asarray(support.X_WS))
    table = np.asarray(support.polygon.vertices)
    axes.set_aspect("equal")
    _fill(axes, table, facecolor="#f1e8da", edgecolor=INK, linewidth=1.6, zorder=1)
    for core in getattr(support.goal_band, "core", []):
        ring = np.asarray(core.vertices)
        _fill(axes, ring, facecolor="#e6d9c3", edgecolor="#b8a88c", linewidth=0.8, zorder=2)
    for body, X_WB in obstacles(task):
        points = body.parts[0].vertices @ X_WB[:3, :3].T + X_WB[:3, 3]
        ring = _hull((points @ X_SW[:3, :3].T + X_SW[:3, 3])[:, :2])
        _fill(axes, ring, facecolor="#7f93ab", edgecolor=INK, linewidth=0.8, zorder=3)
        center = ring.mean(axis=0)
        axes.annotate(body.name, center, ha="center", va="center", fontsize=8, zorder=9, color="w")
    outline = np.asarray(thing.outline.vertices)
    poses = [X_SW @ X_WO for X_WO in _along(shown)]
    for k, X_SO in enumerate(poses):
        first, last = k == 0, k == len(poses) - 1
        ring = outline @ X_SO[:2, :2].T + X_SO[:2, 3]
        axes.fill(*ring.T, color=OBJECT, alpha=0.95 if last else 0.16, zorder=4, lw=0)
        style = "--" if first else "-"
        width = 1.4 if first or last else 0.5
        axes.plot(*np.vstack([ring, ring[:1]]).T, style, color="#8a5a00", lw=width, zorder=5)
    com = np.array([(X @ [*np.asarray(thing.com), 1.0])[:2] for X in poses])
    axes.plot(*com.T, ":", color=INK, lw=1, zorder=6)
    axes.plot(*com[-1], "o", ms=9, mfc="w", mec=INK, zorder=7)
    axes.plot(*com[-1], "+", ms=9, color=INK, zorder=8, label="centre of mass")
    _draw_trail(axes, shown, X_SW)
    if shown.plan:
        _draw_overhang(axes, shown, outline, poses[-1])
    base = X_SW @ np.append(shown.link_poses[0, 0, :3, 3], 1)
    axes.plot(*base[:2], "s", ms=11, color="#9aa0a6", mec=INK, zorder=3, label="robot's base")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), fontsize=9, frameon=False, ncols=3)
    ends = outline @ poses[-1][:2, :2].T + poses[-1][:2, 3]
    _frame(axes, np.vstack([table, base[None, :2], ends]))


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
    tips = (tips @ X_SW[:3, :3].T + X_SW[:3, 3])[:, :2]
    axes.plot(*tips.T, color=TRAIL, lw=2.4, zorder=10, label="fingertip")
    axes.plot(*tips[0], "o", ms=6, color=TRAIL, zorder=10)
    far = np.flatnonzero(np.linalg.norm(tips - tips[-1], axis=1) > 0.025)
    back = far[-1] if len(far) else 0
    arrow = {"arrowstyle": "-|>", "color": TRAIL, "lw": 2.4, "mutation_scale": 16}
    axes.annotate("", tips[-1], tips[back], arrowprops=arrow, zorder=10)


def _draw_overhang(axes: Any, shown: Film, outline: Matrix, X_SO: Matrix) -> None:
    """An arrow from the edge to the part of the object that sticks out furthest."""
    ring = outline @ X_SO[:2, :2].T + X_SO[:2, 3]
    polygon = shown.plan.task.problem.support.polygon
    edge = polygon.nearest_edge(X_SO[:2, 3])
    inward = np.asarray(edge.inward)
    depth = (ring - np.asarray(edge.a)) @ inward
    tip = ring[depth.argmin()]
    foot = tip - inward * depth.min()
    along = np.stack([np.asarray(edge.a), np.asarray(edge.b)])
    axes.plot(*along.T, color="#1f6f4a", lw=3, zorder=3, solid_capstyle="butt")
    arrow: dict[str, Any] = {"arrowstyle": "<|-|>", "color": "#1f6f4a", "lw": 1.2}
    arrow |= {"shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
    axes.annotate("", tip, foot, arrowprops=arrow, zorder=11)
    # Beside the tip, on the outside, whichever way that is on the page.
    side = {-1: "left", 0: "center", 1: "right"}[round(float(inward[0]))]
    rise = {-1: "bottom", 0: "center", 1: "top"}[round(float(inward[1]))]
    axes.annotate(
        f"overhang {shown.plan.overhang * 100:.1f} cm", tip, -6 * inward, fontsize=9,
        textcoords="offset points", color="#1f6f4a", ha=side, va=rise, zorder=11,
    )  # fmt: skip


def _along(shown: Film) -> list[Matrix]:
    """Up to seven poses of the object, evenly along its way."""
    rows = shown.rows("slide")
    if len(rows) < 2:
        return [shown.object_poses[-1]]
    way = np.linalg.norm(np.diff(shown.object_poses[rows, :3, 3], axis=0), axis=1)
    length = np.concatenate([[0.0], np.cumsum(way)])
    wanted = np.linspace(0, length[-1], 7)
    return [shown.object_poses[rows[i]] for i in np.searchsorted(length, wanted - 1e-12)]


def _fill(axes: Any, ring: Matrix, **style: Any) -> None:
    axes.fill(*ring.T, **style)


def _hull(points: Matrix) -> Matrix:
    """The convex hull of points in the plane (monotone chain)."""
    ordered = sorted(map(tuple, points.tolist()))

    def half(some: list[Any]) -> list[Any]:
        chain: list[Any] = []
        for p in some:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))


def _turn(a: Any, b: Any, c: Any) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
