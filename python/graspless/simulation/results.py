# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What became of the object."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from ..plans import Plan
    from .variation import Variation


@dataclass(frozen=True)
class Recording:
    """What moved, at even times.

    Attributes
    ----------
    times : array [N]
        [s].
    positions : array [N, dof]
        As they were, not as commanded [rad or m]; no columns without an arm.
    object_poses : array [N, 4, 4]
        X_WO.
    fingers : array [N, n, 3]
        Centres of the fingertips in the world [m], of fingertip plans; else n is 0.
    names : list of str
        What went on.
    planned_poses : array [N, 4, 4], optional
        X_WO as the plan has it at that moment, for a viewer to show beside what happened.
    """

    times: Matrix
    positions: Matrix
    object_poses: Matrix
    fingers: Matrix
    names: list[str]
    planned_poses: Matrix | None = None

    @staticmethod
    def of_arm(rows: Sequence[tuple[float, Matrix, Matrix, str]]) -> Recording:
        """Of an arm's rows: time, positions, X_WO, name."""
        times, positions, poses, names = zip(*rows, strict=True)
        fingers = np.zeros((len(times), 0, 3))
        return Recording(
            np.array(times), np.array(positions), np.array(poses), fingers, list(names)
        )


@dataclass(frozen=True)
class Trial:
    """One execution of a plan.

    Attributes
    ----------
    variation : Variation
        What differed from the plan's model.
    failures : tuple of str
        Names out of the kind's FAILURES, in the order in which they were seen; none: it held.
    measures : dict
        Figures by name out of the kind's MEASURES; one that was not reached is missing.
    seconds : float
        Of computation.
    recording : Recording or None
        Where one was asked for.
    """

    variation: Variation
    failures: tuple[str, ...]
    measures: dict[str, float]
    seconds: float
    recording: Recording | None = None

    def __bool__(self) -> bool:
        return not self.failures

    def as_dict(self) -> dict[str, Any]:
        """In plain types, without the recording; None for what is no number, as JSON has none."""
        known = {n: v if math.isfinite(v) else None for n, v in self.measures.items()}
        return {
            "held": bool(self),
            "failures": list(self.failures),
            "measures": known,
            "variation": self.variation.as_dict(),
            "seconds": self.seconds,
        }


@dataclass(frozen=True)
class Simulation:
    """The trials of a plan: the first is nominal, the others are varied. True if all held."""

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
        """How many trials held."""
        return sum(map(bool, self.trials))

    @property
    def failures(self) -> dict[str, int]:
        """How many trials failed in what way, the most frequent first."""
        return dict(Counter(f for trial in self.trials for f in trial.failures).most_common())

    def as_dict(self) -> dict[str, Any]:
        """In plain types."""
        return {
            "kind": self.plan.kind,
            "seed": self.seed,
            "trials": len(self.trials),
            "held": self.held,
            "failures": self.failures,
            "rows": [trial.as_dict() for trial in self.trials],
        }
