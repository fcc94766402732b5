# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""State at the end of a stage of a chain, read from the rows of its plan."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import carry, clasp, frames
from ..errors import TaskError
from ..tasks.chain import HOLDING, Held, State

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix

UNLINKED = 1e-9  # virtual linking of a finger that has left the loop


def begins(plan: Any) -> tuple[Matrix | None, Matrix]:
    """Joints and object at the first moment of a plan that is solved: [dof] or None, X_WO."""
    return _moment(plan, first=True)


def ends(plans: Sequence[Any]) -> State:
    """Returns the state at the end of the last of some solved plans, one after the other."""
    plan = plans[-1]
    q, X_WO = _moment(plan, first=False)
    if plan.kind != "fingertip":
        return State(X_WO, q, _held(plans))
    thing, (R, p) = plan.task.problem.object, (X_WO[:3, :3], X_WO[:3, 3])
    return State(X_WO, q, _held(plans), np.array(thing.hull) @ R.T + p, R @ thing.com + p)


def join(plans: Sequence[Any]) -> dict[str, Any]:
    """Returns the state after the last of some plans in the form of a plan file."""
    state = ends(plans)
    how = "held" if state.held else "regrasp" if state.q is None else "arm"
    q = None if state.q is None else np.asarray(state.q).tolist()
    return {"how": how, "X_WO": frames.to_row(state.X_WO), "positions": q}


def _moment(plan: Any, first: bool) -> tuple[Matrix | None, Matrix]:
    row = 0 if first else -1
    if plan.kind == "fingertip":
        moved = [segment for segment in plan.segments if len(segment.X_WO)]
        joints = plan.joint_segments
        q = joints[row].positions[row] if joints else None
        return q, moved[row].X_WO[row]
    segments = [segment for segment in plan.segments if len(segment)]
    return segments[row].positions[row], segments[row].object_poses[row]


def _held(plans: Sequence[Any]) -> Held | None:
    plan = plans[-1]
    problem, fields = plan.task.problem, plan.task.fields
    if plan.kind not in HOLDING or (plan.kind == "slide" and problem.X_WO_end is not None):
        return None
    grasp = next(p for p in reversed(plans) if p.kind != "carry")
    q_open = np.asarray(grasp.segments[-1].positions[0])
    out = _way_out(grasp)
    if plan.kind == "carry":
        if fields.place:
            return None
        arm, frame, points = problem.arm, problem.frame, _points(problem.object)
        return Held(arm, frame, fields, q_open, out, points, lambda: _hangs_on(plan))
    frame = problem.hand.frame if plan.kind == "clasp" else problem.hand.grasp_frame
    points = problem.object.loops.surface.points if plan.kind == "clasp" else np.empty((0, 3))
    return Held(problem.hand.arm, frame, fields, q_open, out, points, lambda: _hangs(plan))


def _points(thing: Any) -> Matrix:
    """[N, 3] vertices of the meshes of a held object, in O."""
    meshes = [placed for placed in thing.shapes if hasattr(placed.shape, "vertices")]
    found = [
        np.asarray(mesh.shape.vertices) @ mesh.X_BG[:3, :3].T + mesh.X_BG[:3, 3] for mesh in meshes
    ]
    return np.concatenate(found) if found else np.empty((0, 3))


def _way_out(grasp: Any) -> Matrix | None:
    """[N, dof] the way on which the hand came into a clasp, back to where no finger is linked with
    the loop and the hand is as far away as after a straight retreat; None for other grasps.
    """
    if grasp.kind != "clasp":
        return None
    problem, reach = grasp.task.problem, grasp.segments[0]
    frame = problem.robot.frame(problem.hand.frame)
    out: Matrix = np.asarray(reach.positions)[::-1]
    places = np.array([problem.robot.pose(frame, q)[:3, 3] for q in out])
    is_away = np.linalg.norm(places - places[0], axis=1) >= carry.Options().retreat
    is_out = np.max(reach.virtual_linking, axis=1)[::-1] <= UNLINKED
    enough = np.flatnonzero(is_away & is_out)
    return out[: enough[0] + 1] if enough.size else out


def _hangs(plan: Any) -> Matrix | None:
    """[4, 4] X_WO at which the object hangs after a clasp; None if friction holds it fast.

    Raises TaskError if it would slide out of the closed hand.
    """
    if plan.kind != "clasp" or plan.pinch is not None:
        return None
    found = clasp.find_hang(plan.task.problem, plan.segments[-1].positions[-1], plan.loop)
    if not found.holds:
        raise TaskError(
            f"nothing but friction would keep the object in the closed hand: by its weight, it "
            f"sinks {1000 * found.drop:.0f} mm and turns {np.degrees(found.swing):.0f} deg, and is "
            "out of it"
        )
    return np.asarray(found.X_WO)


def _hangs_on(plan: Any) -> Matrix | None:
    """Does the same at the end of a carry: the object hangs as it did at its start."""
    problem = plan.task.problem
    if problem.X_WO_hanging is None:
        return None
    robot, frame = problem.robot, problem.robot.frame(problem.frame)
    X_FW = np.linalg.inv(robot.pose(frame, problem.q_start))
    X_WF = np.asarray(robot.pose(frame, plan.segments[-1].positions[-1]))
    found: Matrix = X_WF @ X_FW @ problem.X_WO_hanging
    return found
