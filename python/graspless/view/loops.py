# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a point cloud's loops."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.ticker import FuncFormatter, MaxNLocator, NullLocator

from .bodies import LOOP, TRAIL
from .figures import INK, as_png, new_figure
from .raster import Camera

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from .. import geometry
    from ..frames import Matrix
    from .bodies import Color

PANEL = (800, 640)  # pixels
ELEVATIONS = (0.38, 0.8, 1.2)  # [rad], in order of preference


def draw(points: ArrayLike, loops: geometry.Loops) -> bytes:
    """Draws a cloud with its loops, and the Betti curve; returns the bytes of a PNG file.

    Parameters
    ----------
    points : array [N, 3]
        The point cloud [m].
    loops : geometry.Loops
        Its loops.
    """
    cloud = np.asarray(points, dtype=float)
    figure = new_figure(13, 6.2)
    grid = figure.add_gridspec(
        1, 3, width_ratios=[1.2, 0.5, 1], left=0.01, right=0.985, bottom=0.09, top=0.9, wspace=0
    )
    rings = [np.asarray(loop.points) for loop in loops.found]
    axes = figure.add_subplot(grid[0])
    draw_cloud(axes, cloud, rings, None, _camera(cloud, rings), PANEL)
    for k, loop in enumerate(loops.found):
        color = _hue(k, len(rings))
        thick = f"{100 * loop.thickness:.2g} cm" if loop.thickness > 0 else "unknown"
        label = f"{k}: {loop.length:.3g} m, {thick}"
        axes.plot([], [], lw=3, color=color, label=label)
    if rings:
        key = {"fontsize": 9, "frameon": False, "title": "loop: length, thickness"}
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), alignment="left", **key)
    _draw_betti(figure.add_subplot(grid[2]), loops)
    return as_png(figure)


def draw_cloud(
    axes: Any,
    cloud: Matrix,
    rings: Sequence[Matrix],
    clasped: int | None,
    view: Camera,
    shape: tuple[int, int],
) -> None:
    """Draws points, nearer ones darker, and rings in front of them.

    Parameters
    ----------
    axes : matplotlib axes
    cloud : array [N, 3]
    rings : sequence of array [K, 3]
        Closed polylines.
    clasped : int or None
        Index of the ring to highlight; None: each ring has its own colour.
    view : Camera
    shape : tuple of int
        Width and height of the picture.
    """
    xy = view.project(cloud, *shape)
    xy = xy[np.argsort(xy[:, 2])]
    light = float(xy[:, 2].min() - 0.8 * np.ptp(xy[:, 2]))
    size = float(np.clip(9000 / len(cloud), 0.4, 9))
    axes.scatter(*xy[:, :2].T, s=size, c=xy[:, 2], cmap="YlOrBr", lw=0, vmin=light)
    for k, ring in enumerate(rings):
        place = view.project(ring, *shape)[:, :2]
        color = _hue(k, len(rings)) if clasped is None else TRAIL if k == clasped else LOOP
        width = 2.8 if clasped in (None, k) else 1.8
        axes.plot(*np.vstack([place, place[:1]]).T, lw=width, color=color, solid_joinstyle="round")
    axes.set_xlim(0, shape[0])
    axes.set_ylim(shape[1], 0)
    axes.set_aspect("equal")
    loops = f"{len(rings)} loop{'s' if len(rings) != 1 else ''}"
    caption = f"{loops} in {len(cloud)} points (dark: near)"
    axes.set_title(caption, fontsize=11, color=INK, loc="left", pad=3)
    axes.set_axis_off()


def _draw_betti(axes: Any, loops: geometry.Loops) -> None:
    """Draws the Betti curve, where most found loops exist, and the chosen longest edge d."""
    edges, numbers = np.array(loops.betti.max_edge_length), np.array(loops.betti.loops)
    if len(edges):
        axes.step(edges, numbers, where="post", color=INK, lw=1.4, label="number of loops")
    chosen = loops.complex.max_edge_length
    plateau = loops.plateau
    if plateau.loops and plateau.lower > 0:
        upper = plateau.upper if math.isfinite(plateau.upper) else edges.max()
        shade = {"color": "#f1e8da", "lw": 0, "zorder": 0}
        axes.axvspan(plateau.lower, upper, label="found loops exist", **shade)
    if chosen > 0:
        axes.axvline(
            chosen, color="#b3261e", lw=1.2, ls=(0, (6, 3)), label=f"chosen: {chosen:.3g} m"
        )
    axes.set_xscale("log")
    if len(edges) and edges.min() > 0:
        middle = float(np.median(edges))
        low, high = max(edges.min(), middle / 10), max(edges.max(), 1.2 * chosen)
        axes.set_xlim(low, high)
        decades = 10.0 ** np.arange(np.floor(np.log10(low)), np.log10(high) + 1)
        ticks = [t for t in np.outer(decades, [1, 2, 5]).ravel() if low <= t <= high]
        few = MaxNLocator(5).tick_values(low, high)
        axes.set_xticks(ticks if len(ticks) > 1 else few[(few >= low) & (few <= high)])
    axes.set_yscale("symlog", linthresh=10)
    most = int(numbers.max(initial=1))
    axes.set_yticks([n for n in (0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000) if n <= most])
    axes.set_ylim(0, 1.15 * max(most, 2))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    title = {"fontsize": 11, "color": INK, "loc": "left"}
    axes.set_title("number of loops by longest edge of the complex", pad=22, **title)
    axes.legend(
        fontsize=9, frameon=False, loc="lower left", bbox_to_anchor=(-0.01, 0.995), ncols=3,
        borderaxespad=0.1, columnspacing=1.2,
    )  # fmt: skip
    axes.set_xlabel("longest edge [m]", fontsize=9, color=INK)
    axes.tick_params(labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _camera(cloud: Matrix, rings: Sequence[Matrix]) -> Camera:
    """Places the camera where it looks into most of the loops."""
    axes = [np.linalg.svd(ring - ring.mean(axis=0))[2][2] for ring in rings]
    best: tuple[float, Matrix] | None = None
    for elevation in ELEVATIONS:
        for azimuth in np.radians(np.arange(0, 360, 10) - 60):
            level = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
            toward = np.cos(elevation) * level + np.sin(elevation) * np.array([0.0, 0.0, 1.0])
            score = sum(min(abs(float(toward @ axis)), 0.8) for axis in axes)
            needed = 1.0 if elevation == ELEVATIONS[0] else 1.15
            if best is None or score > needed * best[0] + 1e-9:
                best = score, toward
    assert best is not None
    middle = (cloud.min(axis=0) + cloud.max(axis=0)) / 2
    eye = middle + 4 * float(np.ptp(cloud, axis=0).max()) * best[1]
    return Camera(eye, middle).fitted(cloud, *PANEL)


def _hue(k: int, count: int) -> Color:
    """Returns one of `count` distinguishable colours."""
    from matplotlib import colormaps

    red, green, blue, _ = colormaps["turbo"]((k + 0.5) / max(count, 1))
    return 0.85 * red, 0.85 * green, 0.85 * blue
