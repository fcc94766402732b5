# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""State at the end of a stage of a chain, read from the rows of its plan."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from ..tasks.chain import HOLDING, ON_SUPPORT, Held, State

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix


def begins(plan: Any) -> tuple[Matrix | None, Matrix]:
    """Joints and object at the first moment of a plan that is solved: [dof] or None, X_WO."""
    return _moment(plan, first=True)


def ends(plans: Sequence[Any]) -> State:
    """Returns the state at the end of the last of some solved plans, one after the other."""
    plan = plans[-1]
    q, X_WO = _moment(plan, first=False)
    return State(X_WO, q, _held(plans), corners(plan, X_WO))


def corners(plan: Any, X_WO: Matrix) -> Matrix | None:
    """[N, 3] of the object's convex hull in the world; None of a cloud, whose points say less."""
    thing = plan.task.problem.object
    if plan.kind == "fingertip":
        p_O = np.array(thing.hull)
    elif plan.kind in ON_SUPPORT:
        ring = np.array(thing.outline.vertices)
        heights = (0.0, float(thing.thickness))
        p_O = np.concatenate([np.column_stack([ring, np.full(len(ring), z)]) for z in heights])
    else:
        return None
    p_W: Matrix = p_O @ X_WO[:3, :3].T + X_WO[:3, 3]
    return p_W


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
    if plan.kind not in HOLDING:
        return None
    closes = next(p for p in reversed(plans) if p.kind != "carry").segments[-1]
    q_open = np.asarray(closes.positions[0])
    if plan.kind == "carry":
        return None if fields.place else Held(problem.arm, problem.frame, fields, q_open)
    frame = problem.hand.frame if plan.kind == "clasp" else problem.hand.grasp_frame
    return Held(problem.hand.arm, frame, fields, q_open)
