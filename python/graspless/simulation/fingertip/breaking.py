# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smallest disturbance that breaks a motion, compared with the stability z of the plan."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import TaskError
from ..settings import Break
from .disturbed import Disturbed

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...fingertip import Plan


@dataclass(frozen=True)
class Breaking:
    """Result for one row of a plan.

    Attributes
    ----------
    segment, row : int
        Which.
    smallest : float
        Factor of `direction` that breaks the motion [N], to a fiftieth; inf: none did, up to
        `tried`; 0: the motion does not even hold without.
    direction : int
        Of the task's disturbance directions: that of the smallest; -1: it was none of them.
    lost : float
        As `smallest`, of what moves a corner 5 mm off: more than the fingers' springs give. Never
        below `smallest`.
    tried : float
        The greatest factor that was tried [N].
    undisturbed : float
        How far a corner was from its planned place without any wrench, at worst [m].
    misplaced : float
        How far a finger's spring was bent without any wrench, at worst, since the places were
        zeroed [m]: by errors of its place on the object, and by the object's own motion.
    stability, compliant_stability, withstands : float
        What the plan says of the row [N].
    place_tolerance : float
        What it says of the fingers' places [m].
    """

    segment: int
    row: int
    smallest: float
    direction: int
    lost: float
    tried: float
    undisturbed: float
    misplaced: float
    stability: float
    compliant_stability: float
    withstands: float
    place_tolerance: float

    @property
    def promised(self) -> float:
        """What the row withstands with its fingers where they were [N]."""
        if not self.place_tolerance > 0:
            return 0.0
        return self.withstands * max(0.0, 1 - self.misplaced / self.place_tolerance)

    def as_dict(self) -> dict[str, Any]:
        """Returns all values and ratios by name; None if nothing broke the motion.

        There is a `promised_ratio` only where something is promised.
        """
        z, compliant = self.stability, max(self.compliant_stability, 1e-12)
        found = {
            "segment": self.segment,
            "row": self.row,
            "smallest": _finite(self.smallest),
            "direction": self.direction,
            "lost": _finite(self.lost),
            "tried": self.tried,
            "undisturbed": _finite(self.undisturbed),
            "z": self.stability,
            "compliant": self.compliant_stability,
            "withstands": self.withstands,
            "place_tolerance": self.place_tolerance,
            "misplaced": _finite(self.misplaced),
            "promised": self.promised,
            "ratio": _finite(self.smallest / z),
            "lost_ratio": _finite(self.lost / z),
            "compliant_ratio": _finite(self.smallest / compliant),
            "withstands_ratio": _finite(self.smallest / max(self.withstands, 1e-12)),
        }
        if self.promised > 0:
            found["promised_ratio"] = _finite(self.smallest / self.promised)
        return found


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def disturb(plan: Plan, row: tuple[int, int] | None = None) -> dict[str, Any]:
    """Runs `break_test`; returns its result in plain types."""
    return break_test(plan, row).as_dict()


def break_test(
    plan: Plan,
    row: tuple[int, int] | None = None,
    settings: Break | None = None,
    directions: Sequence[int] | None = None,
) -> Breaking:
    """Increases wrenches along the directions of the task until a corner is off by 1 and 5 mm.

    The object begins at rest a little before the row. A spring carries it until the fingers have
    their nominal forces, and then lets go gradually. The object moves slowly past the row, while
    the wrench comes and stays. Before that, the fingers' places are zeroed once more: they have
    their nominal forces then, as the plan says. Where friction is an interval, that of
    fingers and planes is its lower end: z never falls as the fingers' and sticking contacts' cones
    grow. Along sliding contacts the least z may be at another coefficient of the planes, which is
    not looked for.

    Parameters
    ----------
    plan : Plan
        One that is solved.
    row : (int, int), optional
        Segment and row; the plan's weakest unless given.
    settings : Break, optional
    directions : sequence of int, optional
        Those of the task's directions that are tried, in this order; all unless given.

    Raises
    ------
    TaskError
        No such row.
    """
    s, i = row or plan.weakest or (-1, -1)
    if not (0 <= s < len(plan.segments) and 0 <= i < len(plan.segments[s])):
        raise TaskError(f"row: ({s}, {i}): the plan has no such segment and row")
    segment = plan.segments[s]
    z = float(segment.stability[i])
    settings = settings or Break()
    trial = Disturbed(plan, segment, i, settings, directions)
    smallest, direction = trial.smallest(z, settings.distance)
    # What moves a corner 5 mm has moved it 1 mm before; but either is known to a fiftieth only, the
    # searches try other factors, and the second may end just below the first.
    lost = smallest
    if settings.lost_distance > settings.distance:
        lost = max(smallest, trial.smallest(z, settings.lost_distance)[0])
    return Breaking(
        s, i, smallest, direction, lost, settings.largest * z, trial.undisturbed,
        trial.misplaced, z, float(segment.compliant_stability[i]), float(segment.withstands[i]),
        float(segment.place_tolerance[i]),
    )  # fmt: skip
