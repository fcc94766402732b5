# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of the motion in a task file to poses."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames
from ..._core import fingertip
from ..shapes import pose_matrix
from ..source import at
from ..statement import pose_fields, struct_fields
from .motion import MOST_SEGMENTS

if TYPE_CHECKING:
    from ...frames import Matrix
    from ..shapes import Pose
    from ..source import Location, Source
    from . import motion as model

    Motion = fingertip.Path | fingertip.Lattice | fingertip.Goal

DIRECTIONS = {"+x": [1, 0, 0], "-x": [-1, 0, 0], "+y": [0, 1, 0], "-y": [0, -1, 0]}
MOST_TURNS = 2  # of an object; more are degrees taken for radians
UP = np.array([0.0, 0.0, 1.0])


def build_motion(
    motion: model.Motion, thing: fingertip.Object, floor: fingertip.Plane, source: Source
) -> Motion:
    """Returns the planner's motion. Error messages name the place in `source`."""
    place = ("motion", motion.first_of())
    with at(source, *place):
        if motion.path is not None:
            return fingertip.Path(np.array([pose_matrix(pose) for pose in motion.path]))
        if motion.lattice is not None:
            lattice = motion.lattice
            return fingertip.Lattice(
                X_WO_start=_start(lattice.start, thing, floor),
                X_WO_goal=pose_matrix(lattice.goal),
                lower=np.array(lattice.lower),
                upper=np.array(lattice.upper),
                counts=(lattice.counts[0], lattice.counts[1], lattice.counts[2]),
            )
        if motion.goal is not None:
            goal = motion.goal
            given = {
                name: value
                for name in ("slide_step", "turn_step", "max_tumbles")
                if (value := getattr(goal, name)) is not None
            }
            return fingertip.Goal(
                X_WO_start=_start(goal.start, thing, floor),
                X_WO_goal=pose_matrix(goal.pose),
                **given,
            )
    if motion.sequence is None:
        return _Walk(thing, floor, source).step(motion, ("motion",))
    walk = _Walk(thing, floor, source)
    paths = [walk.step(step, ("motion", "sequence", i)) for i, step in enumerate(motion.sequence)]
    if (segments := sum(len(path.X_WO) - 1 for path in paths)) > MOST_SEGMENTS:
        what = f"has {segments} segments together; at most {MOST_SEGMENTS} can be"
        raise source.error(("motion", "sequence"), what)
    with at(source, *place):
        return fingertip.join(paths)


def motion_fields(motion: Motion) -> dict[str, Any]:
    """Returns the fields of the planner's motion in a task file."""
    if isinstance(motion, fingertip.Path):
        return {"path": [pose_fields(X_WO) for X_WO in motion.X_WO]}
    start, goal = pose_fields(motion.X_WO_start), pose_fields(motion.X_WO_goal)
    if isinstance(motion, fingertip.Goal):
        how = struct_fields(motion, ["slide_step", "turn_step", "max_tumbles"])
        return {"goal": {"start": start, "pose": goal} | how}
    how = struct_fields(motion, ["lower", "upper", "counts"])
    return {"lattice": {"start": start, "goal": goal} | how}


def standing(thing: fingertip.Object, floor: fingertip.Plane) -> Matrix:
    """Returns X_WO of an object that stands on the floor over the origin, without rotation."""
    return frames.translation([0, 0, floor.offset - np.asarray(thing.hull)[:, 2].min()])


def _start(pose: Pose | None, thing: fingertip.Object, floor: fingertip.Plane) -> Matrix:
    return standing(thing, floor) if pose is None else pose_matrix(pose)


class _Walk:
    """Pose of the object, from one step of a motion to the next."""

    def __init__(self, thing: fingertip.Object, floor: fingertip.Plane, source: Source) -> None:
        self.thing, self.floor, self.source = thing, floor, source
        self.X_WO: Matrix | None = None

    def step(self, step: Any, place: Location) -> fingertip.Path:
        name = step.first_of("slide", "turn", "tumble")
        fields = getattr(step, name)
        if self.X_WO is None:
            self.X_WO = _start(fields.pose, self.thing, self.floor)
        elif fields.pose is not None:
            what = "must not be given: a step starts where the one before it ended"
            raise self.source.error((*place, name, "pose"), what)
        turns = abs(getattr(fields, "angle", None) or 0.0) / (2 * math.pi)
        if turns > MOST_TURNS:
            what = f"is more than {MOST_TURNS} turns; angles are in radians"
            raise self.source.error((*place, name, "angle"), what)
        if turns > 1 + 1e-3:
            what = "is more than a turn; angles are in radians"
            self.source.warn((*place, name, "angle"), what)
        with at(self.source, *place, name):
            path: fingertip.Path = getattr(self, f"_{name}")(fields, self.X_WO)
        self.X_WO = np.asarray(path.X_WO)[-1]
        return path

    def _slide(self, slide: model.Slide, X_WO: Matrix) -> fingertip.Path:
        return fingertip.slide_path(X_WO, np.array(slide.translation), slide.segments)

    def _turn(self, turn: model.Turn, X_WO: Matrix) -> fingertip.Path:
        com_W = X_WO[:3, :3] @ np.asarray(self.thing.com) + X_WO[:3, 3]
        point = com_W if turn.point is None else np.array(turn.point)
        return fingertip.turn_path(X_WO, point, np.array(turn.axis), turn.angle, turn.segments)

    def _tumble(self, tumble: model.Tumble, X_WO: Matrix) -> fingertip.Path:
        corners_W = np.asarray(self.thing.hull) @ X_WO[:3, :3].T + X_WO[:3, 3]
        if tumble.over is None:
            point, axis = np.array(tumble.point), np.array(tumble.axis)
            angle = tumble.angle or 0.0  # the model has asked for it
        else:
            point, axis = edge(corners_W, self.floor.offset, tumble.over, self.thing.size)
            angle = tumble.angle or angle_to_next_face(corners_W, point, axis)
        return fingertip.turn_path(X_WO, point, axis, angle, tumble.segments)


def edge(p_W: Matrix, height: float, side: str, size: float) -> tuple[Matrix, Matrix]:
    """A corner and the unit axis of the edge over which an object tumbles towards a side.

    Parameters
    ----------
    p_W : array [N, 3]
        Corners of its convex hull [m].
    height : float
        Of the floor [m].
    side : str
        +x, -x, +y or -y of the world.
    size : float
        Of the object [m].
    """
    foot = p_W[np.abs(p_W[:, 2] - height) < 1e-6 * max(size, 1e-3)]
    if len(foot) < 2:
        low = 1000 * (np.sort(p_W[:, 2])[:2] - height)
        raise ValueError(
            f"the object stands on no edge: its lowest two corners are {low[0] + 0.0:.3g} mm and "
            f"{low[1]:.3g} mm above the floor; give a pose in which it stands on an edge or a face"
        )
    towards = np.array(DIRECTIONS[side], dtype=float)
    center = foot.mean(axis=0)
    # Around the foot by angle: the edge whose outward normal looks most towards the side.
    around = foot[np.argsort(np.arctan2(*(foot - center)[:, 1::-1].T))]
    best: tuple[float, Matrix, Matrix] | None = None
    for a, b in zip(around, np.roll(around, -1, axis=0), strict=True):
        along = (b - a) / max(float(np.linalg.norm(b - a)), 1e-12)
        outward = float(np.cross(along, UP) @ towards)
        if best is None or outward > best[0]:
            best = outward, a, along
    assert best is not None
    # Counter-clockwise seen from above, a right-handed turn about the edge goes outwards.
    return best[1], best[2]


def angle_to_next_face(p_W: Matrix, point: Matrix, axis: Matrix) -> float:
    """Returns the angle of a turn about an edge until another corner touches the floor [rad]."""
    arms = p_W - point
    inward = np.cross(UP, axis)
    angles = np.arctan2(arms @ UP, arms @ inward)  # above the floor, seen along the edge
    beside = np.linalg.norm(arms - np.outer(arms @ axis, axis), axis=1) > 1e-9 + 1e-6 * np.ptp(arms)
    steepest = float(angles[beside].max())
    return math.pi - steepest
