# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Carries in the simulation of a chain: which chains are simulated, and the program of servos."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import timing
from ..errors import TaskError
from .slide.program import HOLD, RAISE, SQUEEZE, Program, motions, rest, stretch

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .._plan import Plan as AnyPlan
    from ..frames import Matrix
    from .settings import Slide

OPEN, RETREAT = "open", "retreat"


def require_simulated(task: Any) -> None:
    """Raises TaskError unless all stages of a chain are simulated; see `chain`."""
    stages = task.problem.stages
    kinds = [stage.kind for stage in stages]
    has_arm = kinds[0] == "fingertip" and task.problem.first.arm is not None
    first, *others = kinds[1:] if has_arm and len(kinds) > 1 else kinds
    if others[-2:] == ["carry", "slide"]:  # from where it was put down
        others.pop()
    drags = next((s for s in stages if s.kind == "carry" and s.fields.rests_on), None)
    if first == "clasp" and drags is not None:
        raise TaskError(
            f"stage '{drags.name}' drags the object over {', '.join(drags.fields.rests_on)}, but a "
            "clasped object is simulated only while it is lifted; to simulate the clasp alone, "
            "plan it as a task of its own"
        )
    is_known = first in ("slide", "pinch") or (first == "clasp" and others and not has_arm)
    if not is_known or set(others) - {"carry"}:
        raise TaskError(
            f"a chain of {', '.join(kinds)} is not simulated (a slide, a pinch or a clasp and the "
            "carries that lift it are, also with a slide from where it was put down; the first two "
            "also after one motion by the fingertips of an arm): plan its stages as tasks of their "
            "own, and simulate those plans"
        )


def with_carries(
    program: Program, carries: Sequence[AnyPlan], timestep: float, later: Any, settings: Slide
) -> Program:
    """Returns the program of a slide with its lift replaced by the motions of carries.

    Parameters
    ----------
    program : Program
    carries : list of plans
        Plans of kind carry.
    timestep : float
        Time step [s].
    later : slide.Plan or None
        Slide of the object from where it was put down.
    settings : Slide
        Pauses of that slide.
    """
    begin, hold = program.last(SQUEEZE) + 1, program.names.index(HOLD)
    names, moved = _motions(carries, timestep)
    carried = [values for name, values in zip(names, moved, strict=True) if name == RAISE]
    squeeze = program.positions[begin - 1] - carried[0][0]
    raised = np.concatenate(carried) + squeeze
    still = int(np.count_nonzero(program.phase == hold))
    parts = [(RAISE, raised), (HOLD, np.repeat(raised[-1:], still, axis=0))]
    for name, values in zip(names, moved, strict=True):
        if name == OPEN:  # the squeeze goes, too
            left = np.linspace(1, 0, len(values))[:, None]
            parts.append((OPEN, values + left * squeeze))
        elif name == RETREAT:
            parts.append((RETREAT, values))
            if later is not None:
                parts += motions(timing.time(later), timestep, settings)
            parts.append(rest(parts[-1][1], timestep, settings))
    names = list(dict.fromkeys([*program.names, *(name for name, _ in parts)]))
    positions = np.concatenate([program.positions[:begin], *(values for _, values in parts)])
    phases = [np.full(len(values), names.index(name)) for name, values in parts]
    return dataclasses.replace(
        program,
        positions=positions,
        velocities=np.gradient(positions, timestep, axis=0),
        phase=np.concatenate([program.phase[:begin], *phases]),
        names=names,
    )


def _motions(carries: Sequence[AnyPlan], timestep: float) -> tuple[list[str], list[Matrix]]:
    """Returns the motions of carries at even times, each with the name of its phase."""
    names, moved = [], []
    for stage in carries:
        trajectory = timing.time(stage)
        for i, segment in enumerate(trajectory.segments):
            names.append(segment.name if segment.name in (OPEN, RETREAT) else RAISE)
            moved.append(stretch(trajectory, i, timestep))
    return names, moved
