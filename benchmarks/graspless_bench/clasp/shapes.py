# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects whose holes are known, made of parts: thin frames, vessels with and without handles."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import geometry

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    Points = np.ndarray[Any, np.dtype[np.float64]]

CORNERS = 24  # of a circle
RIM = 48  # corners of a vessel's circle


@dataclasses.dataclass(frozen=True)
class Shape:
    """An object with the number of its holes.

    Attributes
    ----------
    name : str
        Name in results.
    holes : int
        Number of handles of the solid (its genus).
    parts : list of PlacedShape
        In O [m].
    """

    name: str
    holes: int
    parts: list[geometry.PlacedShape]


def bar(points: Any, radius: float) -> list[geometry.PlacedShape]:
    """Returns a round bar [m] along a polyline ([n, 3], in O [m])."""
    parts = []
    corners = np.asarray(points, dtype=float)
    for a, b in zip(corners[:-1], corners[1:], strict=True):
        z = (b - a) / np.linalg.norm(b - a)
        x = np.cross(z, [0, 0, 1] if abs(z[2]) < 0.9 else [1, 0, 0])
        x /= np.linalg.norm(x)
        X_OG = np.eye(4)
        X_OG[:3, :3] = np.column_stack([x, np.cross(z, x), z])
        X_OG[:3, 3] = (a + b) / 2
        capsule = geometry.Capsule(radius, float(np.linalg.norm(b - a)))
        parts.append(geometry.PlacedShape(capsule, X_OG))
    return parts


def bars(segments: Iterable[Any], radius: float) -> list[geometry.PlacedShape]:
    """Returns a round bar for every polyline."""
    return [part for segment in segments for part in bar(segment, radius)]


def arc(
    middle: Sequence[float],
    radius: float,
    first: float = 0,
    last: float = 2 * np.pi,
    axes: tuple[int, int] = (0, 1),
    aspect: float = 1,
) -> Points:
    """Returns a polyline [n, 3] along an arc of an ellipse about `middle` [m]; angles in rad."""
    count = max(3, round(CORNERS * abs(last - first) / (2 * np.pi)))
    angles = np.linspace(first, last, count + 1)
    points: Points = np.tile(np.asarray(middle, dtype=float), (count + 1, 1))
    points[:, axes[0]] += radius * np.cos(angles)
    points[:, axes[1]] += radius * aspect * np.sin(angles)
    return points


def turned(profile: Any) -> list[geometry.PlacedShape]:
    """Returns the solid of a closed profile ([n, 2]: radius, z [m]) turned about z."""
    profile = np.asarray(profile, dtype=float)
    n, angles = len(profile), 2 * np.pi * np.arange(RIM) / RIM
    rings = [
        np.column_stack([r * np.cos(angles), r * np.sin(angles), np.full(RIM, z)])
        for r, z in profile
    ]
    i, k = np.meshgrid(np.arange(n - 1), np.arange(RIM), indexing="ij")
    a, b = i * RIM + k, i * RIM + (k + 1) % RIM
    c, d = a + RIM, b + RIM
    triangles = np.concatenate([np.stack([a, b, c], -1), np.stack([b, d, c], -1)]).reshape(-1, 3)
    # A ring on the axis is a single point.
    vertices = np.concatenate(rings)
    _, first, index = np.unique(
        np.round(vertices, 9), axis=0, return_index=True, return_inverse=True
    )
    triangles = index.reshape(-1)[triangles]
    keep = (
        (triangles[:, 0] != triangles[:, 1])
        & (triangles[:, 1] != triangles[:, 2])
        & (triangles[:, 0] != triangles[:, 2])
    )
    mesh = geometry.Mesh(vertices[first], triangles[keep].astype(np.int32))
    return [geometry.PlacedShape(mesh)]


def vessel(radius: float, height: float, wall: float, widening: float = 1) -> Any:
    """Returns a round vessel that is open above, as a solid of revolution."""
    top = radius * widening
    outside = [(0, 0), (radius, 0), (top, height)]
    inside = [(top - wall, height), (radius - wall, wall), (0, wall)]
    return turned(outside + inside)


def box(size: Sequence[float], middle: Sequence[float]) -> list[geometry.PlacedShape]:
    X_OG = np.eye(4)
    X_OG[:3, 3] = middle
    return [geometry.PlacedShape(geometry.Box(np.asarray(size, dtype=float)), X_OG)]


def _wheel(spokes: int, radius: float, bar_radius: float) -> Shape:
    angles = 2 * np.pi * np.arange(spokes) / spokes
    rim = [[radius * np.cos(t), radius * np.sin(t), 0] for t in angles]
    parts = bar(arc((0, 0, 0), radius), bar_radius)
    parts += bars([[(0, 0, 0), end] for end in rim], 0.7 * bar_radius)
    return Shape(f"wheel of {spokes}", spokes, parts)


def _bicycle_frame() -> Shape:
    seat, head, down, crank = (0, 0, 0.45), (0.55, 0, 0.45), (0.58, 0, 0.35), (0.1, 0, 0)
    lines: list[Any] = [(seat, head, down, crank, seat)]
    for y in (-0.06, 0.06):
        lines.append((seat, (-0.4, y, 0.02), crank))
    return Shape("bicycle frame", 3, bars(lines, 0.014))


def _basket(cells: int, size: float, height: float, wire: float, handle: bool) -> Shape:
    """Wires along the sides and the bottom, and a rim; one hole less than meshes of a sphere."""
    xs = np.linspace(-size / 2, size / 2, cells + 1)
    lines: list[Any] = []
    for x in xs:
        lines.append([(x, -size / 2, height), (x, -size / 2, 0)])
        lines.append([(x, -size / 2, 0), (x, size / 2, 0)])
        lines.append([(x, size / 2, 0), (x, size / 2, height)])
    for y in xs:
        lines.append([(-size / 2, y, 0), (size / 2, y, 0)])
        if abs(y) < size / 2 - 1e-9:
            for x in (-size / 2, size / 2):
                lines.append([(x, y, 0), (x, y, height)])
    h = size / 2
    lines.append([(-h, -h, height), (h, -h, height), (h, h, height), (-h, h, height)])
    lines.append([(-h, h, height), (-h, -h, height)])
    holes = cells * cells + 4 * cells
    if handle:
        lines.append(arc((0, 0, height), h, 0, np.pi, (0, 2), 1.2))
        holes += 1
    return Shape(
        f"basket of {cells}" + (" with handle" if handle else ""), holes, bars(lines, wire)
    )


def _ladder(rungs: int, width: float, step: float, radius: float) -> Shape:
    top = (rungs - 1) * step
    lines = [[(x, 0, -step / 2), (x, 0, top + step / 2)] for x in (0, width)]
    lines += [[(0, 0, k * step), (width, 0, k * step)] for k in range(rungs)]
    return Shape(f"ladder of {rungs}", rungs - 1, bars(lines, radius))


def _mug(scale: float = 1, handle: float = 0.028, bar_radius: float = 0.005) -> Shape:
    parts = vessel(0.04 * scale, 0.095 * scale, 0.004 * scale)
    ear = arc((0.038 * scale, 0, 0.05 * scale), handle * scale, -np.pi / 2, np.pi / 2, (0, 2), 1.35)
    return Shape(
        "mug" if scale == 1 else f"mug x{scale:g}", 1, parts + bar(ear, bar_radius * scale)
    )


def _pitcher() -> Shape:
    parts = vessel(0.055, 0.23, 0.004, 1.15)
    ear = arc((0.058, 0, 0.13), 0.04, -np.pi / 2, np.pi / 2, (0, 2), 1.9)
    return Shape("pitcher", 1, parts + bar(ear, 0.008))


def _teapot() -> Shape:
    parts = turned([(0, 0), (0.05, 0), (0.075, 0.05), (0.05, 0.1), (0, 0.11)])
    parts += bar(arc((-0.062, 0, 0.055), 0.045, np.pi / 2, 3 * np.pi / 2, (0, 2), 0.8), 0.006)
    parts += bar([(0.06, 0, 0.04), (0.12, 0, 0.1)], 0.01)
    return Shape("teapot", 1, parts)


def _kettle() -> Shape:
    parts = turned([(0, 0), (0.08, 0), (0.07, 0.12), (0.02, 0.14), (0, 0.14)])
    parts += bar(arc((0, 0, 0.11), 0.065, 0, np.pi, (0, 2), 1.6), 0.007)
    return Shape("kettle", 1, parts)


def _bucket() -> Shape:
    parts = vessel(0.1, 0.22, 0.006, 1.25)
    return Shape("bucket", 1, parts + bar(arc((0, 0, 0.2), 0.122, 0, np.pi, (0, 2), 1.4), 0.005))


def _pan() -> Shape:
    """A pan whose handle ends in an eye."""
    parts = vessel(0.1, 0.04, 0.004, 1.1) + bar([(0.105, 0, 0.03), (0.24, 0, 0.05)], 0.009)
    return Shape("pan with an eye", 1, parts + bar(arc((0.265, 0, 0.05), 0.02), 0.006))


def _scissors(opening: float) -> Shape:
    lines: list[Any] = []
    for side in (-1, 1):
        lines.append([(0, 0, 0), (-side * np.sin(opening) * 0.09, 0.09 * np.cos(opening), 0)])
        lines.append([(0, 0, 0), (side * 0.03, -0.05, 0)])
        lines.append(arc((side * 0.033, -0.078, 0), 0.02, aspect=1.5))
    return Shape("scissors", 2, bars(lines, 0.0045))


def _glasses() -> Shape:
    lines: list[Any] = [arc((side * 0.034, 0, 0), 0.026, aspect=0.8) for side in (-1, 1)]
    lines.append([(-0.008, 0.004, 0), (0.008, 0.004, 0)])
    for side in (-1, 1):
        lines.append([(side * 0.06, 0.005, 0), (side * 0.068, 0.005, -0.12)])
    return Shape("eyeglasses", 2, bars(lines, 0.002))


def _chair() -> Shape:
    """Four legs with stretchers on two heights, a seat and a back of two slats."""
    a, seat = 0.2, 0.45
    parts = box((2 * a + 0.04, 2 * a + 0.04, 0.03), (0, 0, seat))
    lines: list[Any] = []
    corners = [(-a, -a), (a, -a), (a, a), (-a, a)]
    for x, y in corners:
        lines.append([(x, y, 0.015), (x, y, seat if x > 0 else 0.9)])
    for p, q in zip(corners, corners[1:] + corners[:1], strict=True):
        lines.append([(*p, 0.2), (*q, 0.2)])
    for z in (0.65, 0.88):
        lines.append([(-a, -a, z), (-a, a, z)])
    return Shape("chair", 4 + 2, parts + bars(lines, 0.014))


def _bag() -> Shape:
    lines = [arc((0, y, 0.3), 0.08, 0, np.pi, (0, 2), 1.5) for y in (-0.04, 0.04)]
    return Shape("bag of two handles", 2, box((0.3, 0.12, 0.3), (0, 0, 0.15)) + bars(lines, 0.007))


def _handlebar() -> Shape:
    """Holes of three sizes side by side."""
    lines: list[Any] = [[(-0.3, 0, 0), (0.3, 0, 0)]]
    for x, radius in ((-0.2, 0.028), (0, 0.045), (0.2, 0.09)):
        lines.append(arc((x, 0, 0), radius, 0, np.pi))
    return Shape("handlebar", 3, bars(lines, 0.006))


def _torus(radius: float, tube: float, name: str) -> Shape:
    return Shape(name, 1, bar(arc((0, 0, 0), radius), tube))


def _tape() -> Shape:
    ring = [(0.038, -0.012), (0.052, -0.012), (0.052, 0.012), (0.038, 0.012), (0.038, -0.012)]
    return Shape("roll of tape", 1, turned(ring))


def _spade() -> Shape:
    lines = [[(0, 0, 0), (0, 0, 0.6)], [(0, 0, 0.6), (-0.05, 0, 0.7), (0.05, 0, 0.7), (0, 0, 0.6)]]
    return Shape("spade", 1, box((0.18, 0.012, 0.25), (0, 0, -0.1)) + bars(lines, 0.013))


def _crate() -> Shape:
    """An open box whose two ends have a slot to hold it by."""
    a, b, h, t = 0.4, 0.28, 0.22, 0.012
    parts = box((a, b, t), (0, 0, t / 2))
    for y in (-b / 2, b / 2):
        parts += box((a, t, h), (0, y, h / 2))
    for x in (-a / 2, a / 2):
        parts += box((t, b, 0.13), (x, 0, 0.065)) + box((t, b, 0.04), (x, 0, 0.2))
        for y in (-1, 1):
            parts += box((t, 0.08, h), (x, y * (b / 2 - 0.04), h / 2))
    return Shape("crate", 2, parts)


def with_holes() -> list[Shape]:
    """Returns objects that have holes, most of them of several sizes."""
    return [
        _wheel(5, 0.3, 0.012),
        _wheel(12, 0.3, 0.008),
        _bicycle_frame(),
        _basket(3, 0.24, 0.1, 0.005, False),
        _basket(2, 0.3, 0.15, 0.006, True),
        _ladder(5, 0.3, 0.25, 0.014),
        _mug(),
        _mug(1.6, 0.024, 0.004),
        _pitcher(),
        _teapot(),
        _kettle(),
        _bucket(),
        _pan(),
        _scissors(0.2),
        _glasses(),
        _chair(),
        _bag(),
        _handlebar(),
        _torus(0.045, 0.015, "thick ring"),
        _tape(),
        _spade(),
        _crate(),
    ]


def without_holes() -> list[Shape]:
    """Returns objects that have none, though some have openings, rims and gaps."""
    apple = turned([(0, 0.01), (0.02, 0), (0.04, 0.035), (0.03, 0.07), (0.01, 0.072), (0, 0.06)])
    bottle = turned([(0, 0), (0.035, 0), (0.035, 0.15), (0.013, 0.19), (0.013, 0.23), (0, 0.23)])
    tray = box((0.3, 0.2, 0.006), (0, 0, 0.003))
    for s in (-1, 1):
        tray += box((0.3, 0.006, 0.05), (0, s * 0.1, 0.025))
        tray += box((0.006, 0.2, 0.05), (s * 0.15, 0, 0.025))
    gap = 0.5
    headphones = bar(arc((0, 0, 0), 0.08, -np.pi / 2 + gap, 3 * np.pi / 2 - gap), 0.007)
    for angle in (-np.pi / 2 + gap, 3 * np.pi / 2 - gap):
        X_OG = np.eye(4)
        X_OG[:3, 3] = 0.08 * np.array([np.cos(angle), np.sin(angle), 0])
        headphones.append(geometry.PlacedShape(geometry.Sphere(0.022), X_OG))
    hook = np.concatenate([[(0.04, 0, 0.25)], arc((0, 0, 0), 0.04, 0, -1.3 * np.pi, (0, 2))])
    fork = bar([(0, 0, 0), (0, 0, 0.12)], 0.004) + bar([(-0.012, 0, 0.12), (0.012, 0, 0.12)], 0.003)
    fork += bars([[(x, 0, 0.12), (x, 0, 0.17)] for x in (-0.012, -0.004, 0.004, 0.012)], 0.0016)
    plug = [(0.02, 0, 0), (0.02, 0, 0.04)]
    return [
        Shape("box", 0, box((0.16, 0.06, 0.21), (0, 0, 0))),
        Shape("ball", 0, [geometry.PlacedShape(geometry.Sphere(0.05))]),
        Shape("apple", 0, apple),
        Shape("bottle", 0, bottle),
        Shape("cup", 0, vessel(0.035, 0.1, 0.003, 1.2)),
        Shape("bowl", 0, vessel(0.03, 0.055, 0.004, 2.6)),
        Shape("plate", 0, vessel(0.08, 0.02, 0.004, 1.5)),
        Shape("tray", 0, tray),
        Shape("headphones", 0, headphones),
        Shape("open ring", 0, bar(arc((0, 0, 0), 0.06, 0.15, 2 * np.pi - 0.15), 0.006)),
        Shape("hook", 0, bar(hook, 0.006)),
        Shape("fork", 0, fork),
        Shape(
            "stool",
            0,
            box((0.3, 0.3, 0.03), (0, 0, 0.45))
            + bars(
                [[(x, y, 0), (x, y, 0.44)] for x in (-0.12, 0.12) for y in (-0.12, 0.12)], 0.015
            ),
        ),
        Shape(
            "plug",
            0,
            box((0.06, 0.04, 0.03), (0, 0, -0.015))
            + bars([plug, [(-x, y, z) for x, y, z in plug]], 0.004),
        ),
    ]
