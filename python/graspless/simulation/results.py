# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of a simulation."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Sequence

    from .._plan import Plan
    from ..frames import Matrix
    from .variation import Variation


@dataclass(frozen=True, eq=False)
class Recording:
    """Recorded motion, at even times. It equals only itself.

    Attributes
    ----------
    times : array [N]
        Times [s].
    positions : array [N, dof]
        Actual joint positions, not the commanded ones [rad or m]; no columns without an arm.
    object_poses : array [N, 4, 4]
        Poses X_WO of the object.
    fingers : array [N, n, 3]
        Centres of the fingertips in the world [m]; n is 0 except for fingertip plans.
    names : list of str
        Name of the phase at each time.
    planned_poses : array [N, 4, 4], optional
        Planned poses X_WO at the same times, for a viewer to show beside the actual ones.
    """

    times: Matrix
    positions: Matrix
    object_poses: Matrix
    fingers: Matrix
    names: list[str]
    planned_poses: Matrix | None = None

    def __repr__(self) -> str:
        return f"<Recording of {len(self.times)} moments, {max(self.times, default=0):.2f} s>"

    @staticmethod
    def of_arm(rows: Sequence[tuple[float, Matrix, Matrix, str]]) -> Recording:
        """Returns the recording of an arm from rows of time, positions, X_WO and name."""
        times, positions, poses, names = zip(*rows, strict=True)
        fingers = np.zeros((len(times), 0, 3))
        return Recording(
            np.array(times), np.array(positions), np.array(poses), fingers, list(names)
        )


@dataclass(frozen=True)
class Trial:
    """Execution of a plan.

    Attributes
    ----------
    variation : Variation
        Differences from the model of the plan.
    failures : tuple of str
        Names of failures, of the FAILURES of the kind, in order of time; empty if the plan held.
    measures : dict
        Measured values by name, of the MEASURES of the kind; without those that were not reached.
    seconds : float
        Computation time [s].
    recording : Recording or None
        Recording, if requested.
    touched : tuple of str or None
        Names of the two bodies of the first forbidden contact; None in fingertip plans.
    """

    variation: Variation
    failures: tuple[str, ...]
    measures: dict[str, float]
    seconds: float
    recording: Recording | None = None
    touched: tuple[str, str] | None = None

    def __bool__(self) -> bool:
        return not self.failures

    def as_dict(self) -> dict[str, Any]:
        """Returns the trial in plain types without its recording; values not finite are None."""
        known = {n: v if math.isfinite(v) else None for n, v in self.measures.items()}
        return {
            "held": bool(self),
            "failures": list(self.failures),
            "touched": self.touched and list(self.touched),
            "measures": known,
            "variation": self.variation.as_dict(),
            "seconds": self.seconds,
        }


@dataclass(frozen=True)
class Running:
    """A trial to be run step by step by somebody else, who may change the commands.

    Attributes
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
    object_pose : callable
        Returns the present pose X_WO of the object [4, 4].
    steps : generator
        Before each physics step it sets `data.ctrl` to the commands of the plan, and yields the
        name of the phase; it returns the Trial.
    """

    model: Any
    data: Any
    object_pose: Callable[[], Matrix]
    steps: Generator[str, None, Trial]


def drained(steps: Generator[str, None, Trial]) -> Trial:
    """Runs all steps with the commands of the plan; returns the trial."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            trial: Trial = end.value
            return trial


@dataclass(frozen=True)
class Simulation:
    """Trials of a plan: the first is nominal, the others are varied. True if all held."""

    plan: Plan
    seed: int
    trials: list[Trial]

    def __bool__(self) -> bool:
        return all(self.trials)

    def __repr__(self) -> str:
        failed = ", ".join(f"{name} {times}" for name, times in self.failures.items())
        return f"<Simulation: {self.held} of {len(self.trials)} held{failed and ': ' + failed}>"

    @property
    def held(self) -> int:
        """Number of trials that held."""
        return sum(map(bool, self.trials))

    @property
    def failures(self) -> dict[str, int]:
        """Number of trials by kind of failure, the most frequent first."""
        return dict(Counter(f for trial in self.trials for f in trial.failures).most_common())

    def as_dict(self) -> dict[str, Any]:
        """Returns the simulation in plain types."""
        return {
            "kind": self.plan.kind,
            "seed": self.seed,
            "trials": len(self.trials),
            "held": self.held,
            "failures": self.failures,
            "rows": [trial.as_dict() for trial in self.trials],
        }
