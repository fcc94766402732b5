# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a perceived scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke

from .figures import INK, as_png, hull, new_figure

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..perception import Object, Scene, Support

EDGES = {"real": "#1a7f37", "image_border": "#b58900", "occluded": "#b3261e"}
HALO = withStroke(linewidth=3, foreground="white")  # where a text crosses a line
TOP, THING, CUT, HIDDEN = "#efe9df", "#3b6ea5", "#d08770", "#5a5a5a"


def draw(scene: Scene) -> bytes:
    """Draws a scene from above, one panel for each support with objects; returns a PNG file."""
    shown = [s for s in scene.supports if any(o.support == s.name for o in scene.objects)]
    shown = shown or list(scene.supports[:1])
    count = max(1, len(shown))
    figure = new_figure(max(6.4 * count, 8.0), 6.6)
    panels = figure.subplots(1, count, squeeze=False)[0]
    for axes, support in zip(panels, shown, strict=False):
        _draw_support(axes, support, scene)
    if not shown:
        panels[0].text(0.5, 0.5, scene.reason, ha="center", va="center", wrap=True, color=INK)
        panels[0].set_axis_off()
    lines = [
        Line2D([], [], color=color, lw=3, label=name.replace("_", " "))
        for name, color in EDGES.items()
    ]
    lower: dict[str, Any] = {"loc": "lower center", "frameon": False, "fontsize": 9, "ncols": 3}
    lower |= {"columnspacing": 1.2, "handlelength": 1.6}
    figure.legend(handles=lines, bbox_to_anchor=(0.26, 0), title="edge of a support", **lower)
    areas = [
        Patch(facecolor=THING, edgecolor=INK, lw=0.8, alpha=0.85, label="object"),
        Patch(facecolor=CUT, edgecolor=INK, lw=0.8, alpha=0.85, label="cut off by the image"),
        Patch(facecolor="none", edgecolor=HIDDEN, hatch="////", lw=0, alpha=0.45, label="unseen"),
    ]
    figure.legend(handles=areas, bbox_to_anchor=(0.73, 0), title="area", **lower)
    if any(thing.warnings for thing in scene.objects):
        about = "(!): has warnings; graspless see prints them"
        figure.text(0.985, 0.955, about, ha="right", fontsize=9, color=INK)
    figure.subplots_adjust(left=0.08, right=0.97, bottom=0.17, top=0.9, wspace=0.2)
    return as_png(figure)


def _draw_support(axes: Any, support: Support, scene: Scene) -> None:
    ring = _in_world(support.X_WS, support.polygon)
    axes.fill(*ring.T, color=TOP, lw=0)
    hulls = [hull(space.vertices[:, :2]) for space in scene.unseen if _is_over(space, support)]
    axes.add_collection(
        PolyCollection(hulls, facecolors="none", edgecolors=HIDDEN, hatch="////", lw=0, alpha=0.45)
    )
    for a, b, label in zip(ring, np.roll(ring, -1, axis=0), support.edges, strict=True):
        axes.plot(*np.array([a, b]).T, color=EDGES[str(label)], lw=3, solid_capstyle="round")
    for thing in scene.objects:
        if thing.support == support.name:
            _draw_object(axes, thing)
    axes.set_aspect("equal")
    axes.margins(0.06)
    axes.set_xlabel("x [m]", fontsize=9, color=INK)
    axes.set_ylabel("y [m]", fontsize=9, color=INK)
    axes.tick_params(labelsize=8)
    least = f"objects of {1000 * support.least_thickness:.1f} mm can be seen"
    height = round(support.X_WS[2, 3], 3) + 0.0  # no minus zero
    title = f"{support.name} at {height:.3f} m; {least}"
    axes.set_title(title, fontsize=11, color=INK, loc="left")


def _draw_object(axes: Any, thing: Object) -> None:
    ring = _in_world(thing.X_WO, thing.outline)
    color = CUT if thing.touches_border else THING
    axes.fill(*ring.T, facecolor=color, edgecolor=INK, lw=0.8, alpha=0.85)
    # Of what is not flat, the standard error is that of noise alone.
    error = f" ± {1000 * thing.thickness_error:.1f}" if thing.is_flat else ""
    name = f"{thing.name} (!)" if thing.warnings else thing.name
    text = f"{name}\n{1000 * thing.thickness:.1f}{error} mm"  # narrow: others may be near
    middle = (ring[:, 0].min() + ring[:, 0].max()) / 2
    axes.annotate(
        text, (middle, ring[:, 1].max()), xytext=(0, 4), textcoords="offset points",
        ha="center", fontsize=8.5, color=INK, zorder=9, path_effects=[HALO],
    )  # fmt: skip


def _is_over(space: Any, support: Support) -> bool:
    """True if unseen space begins at the height of a support."""
    p_S = (space.vertices - support.X_WS[:3, 3]) @ support.X_WS[:3, 2]
    return bool(abs(p_S.min()) < 1e-3)


def _in_world(X: Matrix, corners: Matrix) -> Matrix:
    return np.asarray(corners @ X[:2, :2].T + X[:2, 3])
