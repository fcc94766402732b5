# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Moments of a plan: poses of the object and its fingers, and the moments to draw."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ...report.fingertip import travelled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...fingertip import Plan, Segment
    from ...frames import Matrix

MOST = 8  # moments of a picture
LONG = 0.45  # share of the motion above which a segment's middle is drawn too


@dataclass(frozen=True)
class Moment:
    """Object and its n fingers at one moment.

    Attributes
    ----------
    X_WO : array [4, 4]
    centers : array [n, 3]
        Centres of the fingertips' spheres, in O [m].
    forces : array [n, 3]
        Nominal forces on the object, in O [N].
    modes : list of str
        position, force, or free for a finger that is off the object.
    name : str
        Name of the segment.
    caption : str
        Caption of the moment's picture.
    q : array [dof], optional
        Configuration of the robot that moves the fingers [rad or m].
    X_WP : array [4, 4], optional
        Planned pose of the object, for a moment of a simulation.
    """

    X_WO: Matrix
    centers: Matrix
    forces: Matrix
    modes: list[str]
    name: str
    caption: str = ""
    q: Matrix | None = None
    X_WP: Matrix | None = None

    @property
    def centers_W(self) -> Matrix:  # noqa: N802
        """Centres of the fingertips, [n, 3] in the world [m]."""
        return frames.transform(self.X_WO, self.centers)

    @property
    def forces_W(self) -> Matrix:  # noqa: N802
        """Nominal forces, [n, 3] in the world [N]."""
        return np.asarray(self.forces @ self.X_WO[:3, :3].T)


def at(plan: Plan, segment: Segment, row: int, X_WO: Matrix | None = None) -> Moment:
    """Returns the moment of a segment's row, at another pose of the object if one is given.

    Fingers that are off the object have NaN as centres.
    """
    radius = plan.task.problem.fingers.radius
    touches = segment.touches[row]
    modes = [
        mode if touching else "free"
        for mode, touching in zip(segment.modes[row], touches, strict=True)
    ]
    return Moment(
        segment.object_poses[row] if X_WO is None else X_WO,
        segment.fingers[row] - radius * segment.normals[row],
        np.where(touches[:, None], segment.nominal_forces[row], 0.0),
        modes,
        segment.name,
    )


def start_of(plan: Plan) -> Moment:
    """Returns the start of a plan without motion: the object without fingers."""
    motion = plan.task.problem.motion
    X_WO = motion.X_WO[0] if hasattr(motion, "X_WO") else motion.X_WO_start
    return Moment(np.asarray(X_WO), np.empty((0, 3)), np.empty((0, 3)), [], "start", "start")


def moments(plan: Plan) -> list[Moment]:
    """Returns the start, both sides of each regrasp, the middle of long motions, and the goal."""
    parts = [(i, s) for i, s in enumerate(plan.segments) if s.name != "regrasp" and len(s)]
    if not parts:
        return [start_of(plan)]
    found: list[Moment] = []
    moving = [segment for _, segment in parts]
    for k, (i, segment) in enumerate(parts):
        first, last = k == 0, k == len(moving) - 1
        same = k > 0 and _same_grip(moving[k - 1], segment)
        if not same:
            caption = "start" if first else f"after regrasp{_reached(plan, i, 0)}"
            found.append(replace(at(plan, segment, 0, segment.X_WO[0]), caption=caption))
        if len(moving) == 1 or len(segment) > LONG * sum(map(len, moving)):
            middle = len(segment) // 2
            caption = f"{segment.name}{_reached(plan, i, middle)}"
            found.append(replace(at(plan, segment, middle), caption=caption))
        next_same = not last and _same_grip(segment, moving[k + 1])
        if last or not next_same or segment.name != moving[k + 1].name:
            what = f"after the {segment.name}" if next_same else "before regrasp"
            caption = "goal" if last else what + _reached(plan, i, len(segment))
            row = len(segment) - 1
            found.append(replace(at(plan, segment, row, segment.X_WO[-1]), caption=caption))
    if len(found) > MOST:
        kept = sorted({round(i) for i in np.linspace(0, len(found) - 1, MOST)})
        found = [found[i] for i in kept]
    return found


def largest_force(shown: Sequence[Moment]) -> float:
    """Returns the largest nominal force of some moments [N], above 0."""
    return max([1e-9, *(float(np.linalg.norm(m.forces, axis=1).max(initial=0.0)) for m in shown)])


def progress(segments: Sequence[Segment]) -> list[Matrix]:
    """Returns the progress of each segment's rows [N]: the number of lattice poses passed."""
    passed = 0.0
    found: list[Matrix] = []
    for segment in segments:
        arcs = len(segment.X_WO) - 1
        rows = len(segment)
        found.append(np.asarray(passed + (np.arange(rows) + 0.5) * (arcs / max(rows, 1)), float))
        passed += arcs
    return found


def measure(segments: Sequence[Segment]) -> tuple[float, str]:
    """Returns the motion per pose of the lattice and its unit, if all segments have one name."""
    names = {segment.name for segment in segments if segment.name != "regrasp"}
    arcs = sum(len(segment.X_WO) - 1 for segment in segments if segment.name != "regrasp")
    if len(names) != 1 or not arcs:
        return 1.0, "pose of the lattice"
    name = names.pop()
    total = sum(travelled(segment.X_WO, name) for segment in segments)
    unit = f"{name} [cm]" if name == "slide" else f"{name} [degrees]"
    return total / arcs, unit


def _same_grip(before: Segment, after: Segment) -> bool:
    return bool(np.allclose(before.fingers[-1], after.fingers[0], atol=1e-9, equal_nan=True))


def _reached(plan: Plan, k: int, row: int) -> str:
    """Returns the progress of the motion at a row of segment k: ", 36°", ", 5 cm", or nothing."""
    segments = plan.segments
    segment = segments[k]
    each, unit = measure(segments)
    passed = sum(len(other.X_WO) - 1 for other in segments[:k])
    here = passed + row * (len(segment.X_WO) - 1) / max(len(segment), 1)
    if unit.endswith("[cm]"):
        return f", {here * each:.3g} cm"
    return f", {here * each:.3g}°" if unit.endswith("[degrees]") else ""
