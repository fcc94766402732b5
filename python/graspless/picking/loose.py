# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects that hang loose in a closed hand, and how they are put down.

A clasp does not hold its object still. By its weight it sinks in the hand and swings until its
centre of mass is as low as the hand lets it be. It is put down along the way on which it sinks,
until its bottom rests, and on until the hand is around it as it was when it closed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import carry
from ..tasks.chain.start import off_place

if TYPE_CHECKING:
    from .wish import Wish

CLEAR = 0.02  # of the lowest point over the support, where it begins to be lowered [m]
LEVEL = 0.05  # largest tilt of the hand on the way: the object hangs plumb, not with the hand [rad]
LITTLE = 0.02  # from its place, that an object may well stand [m]
MOST = 0.04  # from its place, that it may stand: the hand would meet it on its way out [m]


@dataclass(frozen=True)
class Sway:
    """How an object hangs in the hand, beside how it stands.

    Attributes
    ----------
    off : float
        Largest distance of a point of its bottom from its place, seen from above, when it has come
        down as it sinks in the hand [m]: it may stand as far off.
    sunk : float
        How much lower its lowest point is [m].
    askew : float
        Angle between its vertical and the plumb line [rad].
    """

    off: float = 0.0
    sunk: float = 0.0
    askew: float = 0.0

    def __str__(self) -> str:
        return (
            f"it hangs up to {np.degrees(self.askew):.0f} deg askew in the closed hand, and may "
            f"stand {1000 * self.off:.0f} mm off its place"
        )


def sway_of(held: Any, wish: Wish) -> Sway | None:
    """Returns how the object of a carry hangs in the hand; None if the hand holds it fast."""
    problem = held.task.problem
    if problem.X_WO_hanging is None:
        return None
    points = np.asarray(wish.thing.points)
    stands, hangs = (
        points @ X[:3, :3].T + X[:3, 3] for X in (problem.object.X_WB, problem.X_WO_hanging)
    )
    upright = problem.object.X_WB[:3, 2] @ problem.X_WO_hanging[:3, 2]
    return Sway(
        off=off_place(points, problem.object.X_WB, problem.X_WO_hanging),
        sunk=max(0.0, float(stands[:, 2].min() - hangs[:, 2].min())),
        askew=float(np.arccos(np.clip(upright, -1, 1))),
    )


def place_options(sway: Sway | None) -> dict[str, Any]:
    """Returns the options of the stage that puts the object down; none if it is held fast."""
    if sway is None:
        return {}
    height = max(float(carry.Options().height), sway.sunk + CLEAR)
    return {"options": {"height": height, "max_tilt": LEVEL}}


def refusal(sway: Sway | None, held: Any, wish: Wish) -> str:
    """Says why an object that hangs would not stand up again where it is put down, or nothing.

    It touches the support with one side of its outline first, and stands up if its centre of mass
    is on the inner side of that. The mean of the points of its surface counts as that centre.
    """
    if sway is None:
        return ""
    mean = np.concatenate(
        [np.asarray(placed.shape.vertices) for placed in held.task.problem.object.shapes]
    ).mean(axis=0)
    inside = max(0.0, float(wish.outline.depth(mean[:2])))
    most = float(np.arctan2(inside, mean[2]))
    if sway.askew < most:
        far = f"{sway}; at most {1000 * MOST:.0f} mm are allowed"
        return far if sway.off > MOST else ""
    return (
        f"it would hang {np.degrees(sway.askew):.0f} deg askew in the closed hand, and from "
        f"{np.degrees(most):.0f} deg on it falls over when it is put down"
    )
