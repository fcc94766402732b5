# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Start of a stage, taken from the end of the stage before it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames
from ..carry.model import Object
from ..robots import robot_meshes
from ..scenes import planar_pose
from ..shapes import PlanarPose
from ..slide.build import build_object
from ..slide.resolve import support_pose
from ..source import at
from ..statement import pose_of
from .joints import ON_SUPPORT
from .lying import SAME, lying

if TYPE_CHECKING:
    from ...frames import Matrix
    from ..source import Location, Source
    from .stage import Stage, StageSource

LEAST_DOWN = 0.01  # [m]
BOTTOM = 0.02  # height of the points on which an object stands [m]
MUST_NOT = "must not be given: a stage starts where the one before it ended"


@dataclass(frozen=True)
class Held:
    """Held object, as described for a carry.

    Attributes
    ----------
    arm : str
        Group of the joints that carry the hand.
    frame : str
        Link to which the object is fixed.
    fields : SlideTask, PinchTask, ClaspTask or CarryTask
        Fields of the stage that grasped it.
    q_open : array [dof]
        All joints just before the hand closed [rad or m].
    way_out : array [N, dof] or None
        Configurations along which the open hand can leave the object [rad or m]; None: straight.
    points : array [N, 3]
        Of the surface of an object that may hang, in O [m].
    hanging : callable
        Returns the pose X_WO [4, 4] at which a loose object hangs in the hand, or None if the hand
        holds it fast. Raises TaskError if the hand would lose it.
    """

    arm: str
    frame: str
    fields: Any
    q_open: Matrix
    way_out: Matrix | None
    points: Matrix
    hanging: Callable[[], Matrix | None]


@dataclass(frozen=True)
class State:
    """State at the end of a stage.

    Attributes
    ----------
    X_WO : array [4, 4]
    q : array [dof] or None
        All joints [rad or m]; None if the fingertips have no arm.
    held : Held or None
        None if the hand holds nothing.
    corners : array [N, 3] or None
        Vertices of the object's convex hull in the world [m], after a fingertip plan.
    com : array [3] or None
        Centre of mass of the object in the world [m], after a fingertip plan.
    """

    X_WO: Matrix
    q: Matrix | None
    held: Held | None
    corners: Matrix | None = None
    com: Matrix | None = None


def hold_place(stage: StageSource) -> None:
    """Adds a placeholder for the start of a later stage; raises TaskError if it has its own."""
    own, above = stage.parts[0]
    for place in _starts(stage.data):
        if own.depth((*above, *place)) == len(above) + len(place):
            raise own.error((*above, *place), MUST_NOT)
    if stage.data["kind"] in ON_SUPPORT and isinstance(stage.data.get("object"), dict):
        thing = stage.data["object"]
        stage.data["object"] = thing | {"pose": {}, "frame": "object"}


def _starts(data: dict[str, Any]) -> list[Location]:
    """Returns the fields in which a task of this kind gives its start."""
    if data["kind"] == "carry":
        held = ("robot", "arm", "frame", "object", "pose", "hanging", "support")
        return [(field,) for field in (*held, "open", "way_out", "down")]
    if data["kind"] != "fingertip":
        return [("object", "pose"), ("robot", "home")]
    moves = ("slide", "turn", "tumble")
    places: list[Location] = [("robot", "home"), ("motion", "path")]
    places += [("motion", name, "pose") for name in moves]
    places += [("motion", "sequence", 0, name, "pose") for name in moves]
    return [*places, ("motion", "lattice", "start"), ("motion", "goal", "start")]


def start_at(stage: Stage, state: State) -> Any:
    """Returns the fields of a stage that starts at the end of another, or raises TaskError."""
    fields = stage.fields
    if stage.kind == "carry":
        return _carry(fields, state)
    if stage.kind in ON_SUPPORT:
        with at(stage.source, "object"):
            changes = _slide(fields, state, stage.source)
    else:
        changes = _clasp(fields, state) if stage.kind == "clasp" else _fingertip(fields, state)
    return fields.model_copy(update=_robot(fields, state) | changes)


def _robot(fields: Any, state: State) -> dict[str, Any]:
    if fields.robot is None or state.q is None:
        return {}
    return {"robot": fields.robot.model_copy(update={"home": np.asarray(state.q).tolist()})}


def _slide(fields: Any, state: State, source: Source) -> dict[str, Any]:
    """Places the outline at the pose of the object. Fingertips have another frame for it."""
    thing = fields.object
    if state.corners is None or state.com is None:
        return {"object": thing.model_copy(update={"pose": _flat(fields, state.X_WO)})}
    if thing.cloud is not None or thing.points is not None:
        raise ValueError("an outline is needed to find where it lies")
    X_SW = np.linalg.inv(support_pose(fields.support))
    corners_S = state.corners @ X_SW[:3, :3].T + X_SW[:3, 3]
    com_S = X_SW[:3, :3] @ state.com + X_SW[:3, 3]
    pose = lying(corners_S, com_S, build_object(thing, source, thin=False))
    return {"object": thing.model_copy(update={"pose": pose})}


def _flat(fields: Any, X_WO: Matrix) -> PlanarPose:
    """Returns the pose of an object that lies on the support of a slide or a pinch."""
    X_WS = support_pose(fields.support)
    X_SO = np.linalg.inv(X_WS) @ X_WO
    tilt = float(np.degrees(np.arccos(np.clip(X_SO[2, 2], -1, 1))))
    if abs(X_SO[2, 3]) > SAME or np.linalg.norm(X_SO[:2, 2]) > SAME:
        where = f"{1000 * X_SO[2, 3]:.1f} mm over it, tilted by {tilt:.1f} degrees"
        raise ValueError(f"does not lie flat on the support: {where}")
    return PlanarPose(**planar_pose(X_WS, X_WO))


def _clasp(fields: Any, state: State) -> dict[str, Any]:
    return {"object": fields.object.model_copy(update={"pose": pose_of(state.X_WO)})}


def _fingertip(fields: Any, state: State) -> dict[str, Any]:
    """Returns the motion with its first pose. The model ensures that there is one motion."""
    motion, pose = fields.motion, pose_of(state.X_WO)
    name = motion.first_of()
    moved = getattr(motion, name)
    if name == "sequence":
        first = moved[0]
        step = first.first_of()
        started = getattr(first, step).model_copy(update={"pose": pose})
        moved = [first.model_copy(update={step: started}), *moved[1:]]
    else:
        moved = moved.model_copy(update={"start" if name in ("lattice", "goal") else "pose": pose})
    return {"motion": motion.model_copy(update={name: moved})}


def _carry(fields: Any, state: State) -> Any:
    """Takes the missing fields of a carry from the stage before it."""
    held = state.held
    assert held is not None  # the chain was looked at when it was read
    before = held.fields
    if before.kind == "carry":
        thing, support = before.object, before.support
    else:
        how = "slide" if before.kind in ON_SUPPORT else before.kind
        thing = Object.model_validate({"name": before.object.name, how: before.object})
        support = getattr(before, "support", None)
    update = {
        "robot": before.robot.model_copy(update={"home": np.asarray(state.q).tolist()}),
        "arm": held.arm,
        "frame": held.frame,
        "object": thing,
        "pose": pose_of(state.X_WO),
        "support": support,
    }
    if not fields.rests_on and (X_WO := held.hanging()) is not None:
        update["hanging"] = pose_of(X_WO)
        if fields.place is not None:
            down = state.X_WO[:3, :3].T @ sinking(held.points, state.X_WO, X_WO)
            update["down"] = down.tolist()
    if fields.place is not None:
        update["open"] = np.asarray(held.q_open).tolist()
        update["way_out"] = None if held.way_out is None else held.way_out.tolist()
    if fields.obstacles is None:
        update["obstacles"] = before.obstacles
    taken = set(before.files)
    if fields.obstacles is not None:
        taken &= {str(path) for path in robot_meshes(before.robot)}
    update["files"] = fields.files | {name: before.files[name] for name in taken}
    return fields.model_copy(update=update)


def sinking(points: Matrix, X_WO: Matrix, X_WO_hanging: Matrix) -> Matrix:
    """Returns the way in W on which the bottom of a loose object goes when it begins to hang [3].

    It leads down by `LEAST_DOWN` at least, and sideways no more than down.
    """
    stands, hangs = (frames.transform(X, points) for X in (X_WO, X_WO_hanging))
    bottom = stands[:, 2] < stands[:, 2].min() + BOTTOM
    way: Matrix = (hangs - stands)[bottom].mean(axis=0)
    down = max(LEAST_DOWN, float(stands[:, 2].min() - hangs[:, 2].min()))
    way[:2] *= min(1.0, down / max(float(np.linalg.norm(way[:2])), 1e-12))
    way[2] = -down
    return way


def off_place(points: Matrix, X_WO: Matrix, X_WO_hanging: Matrix) -> float:
    """Returns how far from its place a point of the bottom of a loose object may stand [m].

    It has come down as it sinks in the hand, and is seen from above.
    """
    stands, hangs = (frames.transform(X, points) for X in (X_WO, X_WO_hanging))
    bottom = stands[:, 2] < stands[:, 2].min() + BOTTOM
    left = hangs - stands - sinking(points, X_WO, X_WO_hanging)
    return float(np.linalg.norm(left[bottom, :2], axis=1).max())
