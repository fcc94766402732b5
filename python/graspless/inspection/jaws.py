# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two fingers that open and close: their states, and the axes of the hand."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from .. import scene

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..frames import Matrix
    from .palm import Finger, Palm
    from .tree import Tree

SNAP = np.cos(np.radians(20))  # axes of the hand within this angle of a link's are that link's
TIP_ZONE = 0.015  # length of a finger's end that is measured [m]
GAP = 0.0005  # between the closed fingers, if they would touch [m]
SMALLEST_STROKE = 0.001  # of a hand that opens and closes [m]
STRETCHED = 0.7  # open fingers reach this fraction of their length out of the hand
MAX_STATES = 1700  # states of the hand that are compared


@dataclass(frozen=True)
class Jaws:
    """Two fingers, the one that slides first.

    Attributes
    ----------
    fingers : tuple of Finger
    drivers : tuple of str
        Independent joints of the hand.
    open, closed : array [dof]
        Configurations; joints of the arm are at 0, or their limit next to it.
    R_WH : array [3, 3]
        Axes of the hand at `open`: Z out of it, Y from the second finger to the first.
    opening, smallest : float
        Distance between the open and between the closed fingers [m].
    touches : bool
        True if the fingers touch before their joints reach a limit.
    is_aligned : bool
        True if the axes of the hand are those of a link.
    """

    fingers: tuple[Finger, Finger]
    drivers: tuple[str, ...]
    open: Matrix
    closed: Matrix
    R_WH: Matrix
    opening: float
    smallest: float
    touches: bool
    is_aligned: bool


class Measure:
    """Measures two fingers in states of the hand. All directions are in W, with a resting arm."""

    def __init__(self, tree: Tree, palm: Palm, fingers: tuple[Finger, Finger]) -> None:
        self.tree, self.palm, self.fingers = tree, palm, fingers
        self.rest = np.asarray(tree.robot.clamp(np.zeros(tree.robot.dof)))
        bodies = [b for finger in fingers if not finger.is_fixed for b in finger.bodies]
        self.drivers = tree.drivers(bodies)
        self.columns = [tree.robot.joint(name) for name in self.drivers]
        self.lower, self.upper = (
            np.asarray(limit)[self.columns] for limit in (tree.robot.lower, tree.robot.upper)
        )
        self.out = self._outward()
        self.across: Matrix | None = None
        self._chosen: list[NDArray[np.int64]] | None = None
        self._world = scene.Scene(tree.robot)
        for a, b in self._world.world.pairs:
            self._world.world.remove_pair(a, b)
        for a, b in product(fingers[0].links(tree), fingers[1].links(tree)):
            bodies_ab = (self._world.link_body(a), self._world.link_body(b))
            self._world.world.add_pair(*bodies_ab)

    def q(self, state: Matrix) -> Matrix:
        """Returns the configuration with the hand's joints in a state."""
        q: Matrix = self.rest.copy()
        q[self.columns] = state
        return q

    def given(self, name: str) -> Matrix | None:
        """Returns the hand's joints in a state of the SRDF, if it has that."""
        q = self.tree.state(name, self.drivers)
        return None if q is None else q[self.columns]

    def poses(self, state: Matrix) -> Matrix:
        return self.tree.poses(self.q(state))

    def _clouds(self, state: Matrix) -> list[Matrix]:
        X_WL = self.poses(state)
        return [self.tree.cloud(finger.links(self.tree), X_WL) for finger in self.fingers]

    def touches(self, state: Matrix) -> bool:
        """True if a link of one finger touches a link of the other.

        A jaw always touches the link that it turns in, so only the ends of jaws are compared.
        """
        if not any(finger.is_fixed for finger in self.fingers):
            return self._world.collision(self.q(state)) is not None
        return self.across is not None and self.gap(state, self.across) < 0

    def ends(self, state: Matrix) -> tuple[Matrix, Matrix]:
        """Returns the points at the ends of both fingers; (N, 3) each [m]."""
        clouds = self._clouds(state)
        chosen = self._chosen or [at_end(cloud, self.out) for cloud in clouds]
        first, second = (cloud[at] for cloud, at in zip(clouds, chosen, strict=True))
        return first, second

    def keep_ends(self, state: Matrix) -> None:
        """Lets ends() return the points that are at the ends in a state, in all states."""
        self._chosen = [at_end(cloud, self.out) for cloud in self._clouds(state)]

    def spread(self, state: Matrix) -> float:
        """Returns the distance between the middles of both ends, across the hand [m]."""
        first, second = self.ends(state)
        between = middle(second) - middle(first)
        return float(np.linalg.norm(between - self.out * (between @ self.out)))

    def gap(self, state: Matrix, across: Matrix) -> float:
        """Returns the free distance between both ends along a direction; negative: they overlap."""
        first, second = self.ends(state)
        return float((second @ across).min() - (first @ across).max())

    def _outward(self) -> Matrix:
        """Direction from the palm to the fingers when stretched, or the nearest axis of a link."""
        farthest, best = -1.0, np.zeros(3)
        for t in np.linspace(0, 1, 9):
            X_WL = self.poses(self.lower + t * (self.upper - self.lower))
            origin = X_WL[self.palm.link(self.tree)][:3, 3]
            clouds = [self.tree.cloud(f.links(self.tree), X_WL) - origin for f in self.fingers]
            far = [np.linalg.norm(cloud, axis=1) for cloud in clouds]
            reach = sum(float(distances.max()) for distances in far)
            if reach > farthest + 1e-6:
                ends = [middle(c[d > 0.9 * d.max()]) for c, d in zip(clouds, far, strict=True)]
                farthest, best = reach, np.mean(ends, axis=0)
        return snapped(best, self.axes(self.poses(self.lower)))

    def stretch(self, state: Matrix) -> float:
        """Returns how far the shorter finger reaches out of the hand from its joint [m]."""
        X_WL = self.poses(state)
        found = []
        for finger in self.fingers:
            if not finger.is_fixed:
                cloud = self.tree.cloud(finger.links(self.tree), X_WL)
                found.append(float(((cloud - X_WL[finger.bodies[0]][:3, 3]) @ self.out).max()))
        return min(found)

    def unevenness(self, state: Matrix) -> float:
        """Returns how much farther one of two moving fingers reaches than the other [m]."""
        if any(finger.is_fixed for finger in self.fingers):
            return 0.0
        first, second = (float((cloud @ self.out).max()) for cloud in self._clouds(state))
        return abs(first - second)

    def axes(self, X_WL: Matrix) -> Matrix:
        """Axes of the palm's links; (N, 3)."""
        return np.vstack([X_WL[link][:3, :3].T for link in self.tree.members[self.palm.body]])


def at_end(cloud: Matrix, out: Matrix) -> NDArray[np.int64]:
    """Indices of the points of a finger within TIP_ZONE of its end."""
    heights = cloud @ out
    return np.flatnonzero(heights > heights.max() - TIP_ZONE)


def middle(points: Matrix) -> Matrix:
    """Returns the centre of the box around points."""
    return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2)


def snapped(direction: Matrix, axes: Matrix) -> Matrix:
    """Returns a unit vector along `direction`, or the nearest of the axes if it is near."""
    unit = direction / max(float(np.linalg.norm(direction)), 1e-12)
    cosines = axes @ unit
    best = int(np.argmax(np.abs(cosines)))
    return np.asarray(axes[best] * np.sign(cosines[best]) if abs(cosines[best]) > SNAP else unit)


def find_jaws(tree: Tree, palm: Palm, fingers: tuple[Finger, Finger]) -> Jaws:
    """Returns the states and axes of two fingers.

    Raises
    ------
    ValueError
        No joint moves the fingers apart.
    """
    measure = Measure(tree, palm, fingers)
    opened = measure.given("open")
    opened = _open(measure) if opened is None else opened
    measure.keep_ends(opened)
    first, second = measure.ends(opened)
    X_WL = measure.poses(opened)
    across = middle(second) - middle(first)
    across -= measure.out * (across @ measure.out)
    sideways = snapped(across, _perpendicular(measure.axes(X_WL), measure.out))
    sideways -= measure.out * (sideways @ measure.out)
    sideways /= np.linalg.norm(sideways)
    measure.across = sideways
    shut = measure.given("closed")
    closed, touches = (shut, True) if shut is not None else _closed(measure, opened, sideways)
    opening, smallest = (measure.gap(state, sideways) for state in (opened, closed))
    if not opening - smallest > SMALLEST_STROKE:
        names = " and ".join(finger.name(tree) for finger in fingers)
        raise ValueError(
            f"no joint moves {names} together: the gap between their ends is "
            f"{opening * 1000:.1f} mm at most and {smallest * 1000:.1f} mm at least"
        )
    R_WH = np.column_stack([np.cross(-sideways, measure.out), -sideways, measure.out])
    return Jaws(
        fingers, tuple(measure.drivers), measure.q(opened), measure.q(closed), R_WH,
        opening, smallest, touches, _are_aligned(R_WH, measure.axes(X_WL)),
    )  # fmt: skip


def _are_aligned(R_WH: Matrix, axes: Matrix) -> bool:
    return bool((np.abs(axes @ R_WH).max(axis=0) > 1 - 1e-6).all())


def _perpendicular(axes: Matrix, out: Matrix) -> Matrix:
    """Those axes that are across the hand; any direction is as good if there are none."""
    found = axes[np.abs(axes @ out) < 1e-3]
    return found if len(found) else np.zeros((1, 3))


def _states(measure: Measure) -> Matrix:
    """States of the hand over the range of its joints; (N, joints)."""
    count = len(measure.drivers)
    steps = max(2, min(65, int(MAX_STATES ** (1 / count))))
    if steps**count <= MAX_STATES:
        grid = np.array(list(product(np.linspace(0, 1, steps), repeat=count)))
    else:
        grid = np.random.default_rng(1).random((MAX_STATES, count))
    return np.asarray(measure.lower + grid * (measure.upper - measure.lower))


def _open(measure: Measure) -> Matrix:
    """Returns the state with the ends farthest apart, in which the fingers do not touch."""
    states = _states(measure)
    stretch = np.array([measure.stretch(state) for state in states])
    longest = stretch.max()  # negative, if the fingers' joints are in front of their tips
    states = states[stretch >= longest - (1 - STRETCHED) * abs(longest)]
    spreads = np.array([measure.spread(state) - measure.unevenness(state) for state in states])
    for i in np.argsort(-np.round(spreads, 6), kind="stable"):
        if not measure.touches(states[i]):
            return np.asarray(states[i])
    names = " and ".join(finger.name(measure.tree) for finger in measure.fingers)
    raise ValueError(f"{names} touch in every state of {', '.join(measure.drivers)}")


def _nearest(measure: Measure, opened: Matrix, i: int, value: float, across: Matrix) -> float:
    """Returns the smallest gap while one joint moves halfway to a limit [m]."""
    gaps = []
    for fraction in (0.05, 0.2, 0.5):
        state = opened.copy()
        state[i] += fraction * (value - opened[i])
        gaps.append(measure.gap(state, across))
    return min(gaps)


def _closed(measure: Measure, opened: Matrix, across: Matrix) -> tuple[Matrix, bool]:
    """Returns the state in which the fingers are GAP apart, or as near as their joints go."""
    target = opened.copy()
    for i, limits in enumerate(zip(measure.lower, measure.upper, strict=True)):
        ways = [(_nearest(measure, opened, i, limit, across), float(limit)) for limit in limits]
        if min(ways)[0] < measure.gap(opened, across) - 1e-9:
            target[i] = min(ways)[1]

    def at(t: float) -> Matrix:
        return np.asarray(opened + t * (target - opened))

    steps = np.linspace(0, 1, 65)
    hit = next((i for i, t in enumerate(steps) if measure.touches(at(t))), None)
    if hit is None:
        return target, False
    low, high = float(steps[max(hit - 1, 0)]), float(steps[hit])
    for _ in range(30):
        half = (low + high) / 2
        low, high = (low, half) if measure.touches(at(half)) else (half, high)
    speed = measure.gap(at(0.98 * low), across) - measure.gap(at(low), across)
    back = 0.02 * low * GAP / max(speed, GAP / 50)
    return at(max(0.0, low - back)), True
