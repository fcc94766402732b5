# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Check that the stages of a chain are those of its task and continue each other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from ..errors import TaskError
from ..tasks.chain import ON_SUPPORT, start_at
from ..tasks.chain.lying import SAME, convex_hull
from .state import begins, ends, join

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .._core.robot import Robot
    from ..frames import Matrix
    from ..plan_files.chain import Join, Segment
    from ..tasks.chain import Stage

SAME_JOINTS = 1e-9  # [rad or m]
SAME_POSE = 1e-6  # [m, rad]; a slide lays its object flat
ABSENT = ("end",)  # fields of tasks that say something by being absent


def check_joins(
    asked: Sequence[Stage],
    names: list[str],
    stages: Sequence[Any],
    joins: Sequence[Join],
    contents: Sequence[Segment],
) -> list[str]:
    """Returns the faults between the stages of a solved plan; `asked` are those of its task."""
    if [stage.name for stage in asked] != names:
        return ["plan: the stages are not those of the task"]
    if len(joins) != len(stages) - 1:
        return ["plan: there is not one join between each two stages"]
    faults = []
    for k, stage in enumerate(stages[1:], start=1):
        where = f"stage {k} '{names[k]}'"
        faults += [f"{where}: {fault}" for fault in _continuity(stages[:k], stage)]
        if join(stages[:k]) != joins[k - 1].model_dump(mode="json"):
            faults.append(f"{where}: the join before it is not what the stage before it left")
    for k, stage in enumerate(stages):
        wrong = _wrong_task(stage, asked[k], stages[:k])
        faults += [f"stage {k} '{names[k]}': {wrong}"] if wrong else []
    return faults + _check_contents(contents, stages)


def _wrong_task(stage: Any, asked: Stage, before: Sequence[Any]) -> str:
    """Returns the difference between the task of a stage and the chain's, or an empty text."""
    try:
        fields = asked.fields if not before else start_at(asked, ends(before))
    except TaskError as error:
        return f"cannot start where the stage before it ended: {error}"
    wrong = differs(_plain(fields), _plain(stage.task.fields))
    return "" if wrong is None else f"{wrong} is not what the chain's task says"


def differs(asked: Any, given: Any, place: str = "") -> str | None:
    """Returns the first field where `given` differs from `asked`.

    Missing ones may be anything, except those of `ABSENT`.
    """
    if isinstance(asked, dict) and isinstance(given, dict):
        for key, value in asked.items():
            if (value is not None or key in ABSENT) and key not in ("budget", "files"):
                wrong = differs(value, given.get(key), f"{place}.{key}" if place else key)
                if wrong is not None:
                    return wrong
        return None
    return None if asked == given else place


def _plain(fields: Any) -> dict[str, Any]:
    """Returns the requested fields in plain types, as in a task file."""
    document: dict[str, Any] = fields.model_dump(mode="json")
    return document


def _continuity(earlier: Sequence[Any], stage: Any) -> list[str]:
    before, state, (q, X_WO) = earlier[-1], ends(earlier), begins(stage)
    faults = []
    if (q is None) != (state.q is None):
        faults.append("has an arm, or none, other than the stage before it")
    elif q is not None and state.q is not None:
        if before.joint_names != stage.joint_names:
            faults.append("has other joints than the stage before it")
        elif (apart := np.abs(q - state.q)).max() > SAME_JOINTS:
            carrier = stage.task.arm or stage.task.problem
            gap = _largest(apart, carrier.robot)
            faults.append(f"a joint starts {gap} from where the stage before it ended")
    if state.corners is not None and stage.kind in ON_SUPPORT:  # each has a frame of its own
        off, same = _uncovered(state.corners, stage.task.problem, X_WO), SAME
    else:
        off, same = _apart(X_WO, state.X_WO), SAME_POSE
    if off > same:
        faults.append(f"the object starts {off:.3g} m or rad from where the stage before it ended")
    return faults


def _largest(apart: Matrix, robot: Robot) -> str:
    """Returns the largest of motions of all joints, with its unit; 1 mm counts as 0.01 rad."""
    joint = int(np.argmax(apart * robot.step_weights))
    return f"{apart[joint]:.3g} {'m' if robot.step_weights[joint] > 1 else 'rad'}"


def _uncovered(corners_W: Matrix, problem: Any, X_WO: Matrix) -> float:
    """Returns the distance of corners from those of a prism on its support [m].

    It is the larger of the Hausdorff distance, seen from above, and the differences in height.
    """
    X_SW = np.linalg.inv(problem.support.X_WS)
    p_S, X_SO = corners_W @ X_SW[:3, :3].T + X_SW[:3, 3], X_SW @ X_WO
    ring, thickness = np.asarray(problem.object.outline.vertices), problem.object.thickness
    p, q = convex_hull(p_S[:, :2]), convex_hull(ring @ X_SO[:2, :2].T + X_SO[:2, 3])
    apart = np.linalg.norm(p[:, None] - q[None], axis=2)
    heights = np.abs(p_S[:, 2].min() - X_SO[2, 3]), np.abs(np.ptp(p_S[:, 2]) - thickness)
    return float(max(apart.min(axis=0).max(), apart.min(axis=1).max(), *heights))


def _apart(X_A: Matrix, X_B: Matrix) -> float:
    """Distance and angle between two poses, the larger [m, rad]."""
    return max(float(np.linalg.norm(X_A[:3, 3] - X_B[:3, 3])), frames.angle(X_A, X_B))


def _check_contents(contents: Sequence[Segment], stages: Sequence[Any]) -> list[str]:
    """Returns a fault if the list of all segments differs from the stages."""
    listed = [(s.name, s.stage, s.segment) for s in contents]
    found = [
        (segment.name, k, i)
        for k, stage in enumerate(stages)
        for i, segment in enumerate(stage.segments)
    ]
    return [] if listed == found else ["plan: the list of segments is not that of the stages"]
