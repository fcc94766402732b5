# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A hand that closes into a fist: its thumb, the joints that bend its fingers, its directions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import scene
from .pairs import touching

if TYPE_CHECKING:
    from ..frames import Matrix
    from .palm import Finger, Palm
    from .tree import Tree

BENDS = 0.7  # cosine: the axis of a joint that bends a finger is along the finger's main axis
OPENED, CLOSED = 0.1, 0.9  # fractions of a joint's range, from its open end
BACK = 1.0  # largest angle by which the base of an open finger bends back [rad]
SPREADS = 5  # values that are tried for a joint that spreads a finger or turns the thumb
INSIDE = 0.005  # depth of a curve's corner in a finger or the palm [m]


@dataclass(frozen=True)
class Fist:
    """A hand with its thumb.

    Attributes
    ----------
    thumb : int
        Number of the finger that the others close against.
    drivers : tuple of str
        Independent joints of the hand.
    open, closed : array [dof]
        Configurations; joints that do not bend a finger are the same in both.
    forward_W, sideways_W : array [3]
        Directions towards a bar that is clasped and along it, at `open`.
    tips_L : list of (int, array [3])
        Link of the end of each finger, and the end's position in it [m].
    X_WH : array [4, 4]
        Between the tips at `open`: Z from the palm to them, X along `sideways_W`.
    is_sure : bool
        False if the thumb might be another finger.
    """

    thumb: int
    drivers: tuple[str, ...]
    open: Matrix
    closed: Matrix
    forward_W: Matrix
    sideways_W: Matrix
    tips_L: list[tuple[int, Matrix]]
    X_WH: Matrix
    is_sure: bool


class Fingers:
    """Measures the fingers of a hand on a resting arm."""

    def __init__(self, tree: Tree, palm: Palm) -> None:
        self.tree, self.palm = tree, palm
        self.robot = tree.robot
        self.rest = np.asarray(self.robot.clamp(np.zeros(self.robot.dof)))
        self.tips = [self._tip(finger) for finger in palm.fingers]
        self.axes = [self._axis(finger) for finger in palm.fingers]

    def _tip(self, finger: Finger) -> tuple[int, Matrix]:
        """Point in the last link, INSIDE its end that is farthest from its frame."""
        link = finger.links(self.tree)[-1]
        cloud = self.tree.points[link]
        middle = (cloud.min(axis=0) + cloud.max(axis=0)) / 2
        base = self.tree.cloud([finger.links(self.tree)[0]], self.tree.poses(self.rest))
        X_WL = self.tree.poses(self.rest)[link]
        away = X_WL[:3, :3].T @ (X_WL[:3, :3] @ middle + X_WL[:3, 3] - base.mean(axis=0))
        heights = cloud @ away
        end = cloud[heights > heights.max() - 0.05 * max(float(np.ptp(heights)), 1e-9)]
        point = (end.min(axis=0) + end.max(axis=0)) / 2
        back = middle - point
        length = float(np.linalg.norm(back))
        return link, point + back * min(1.0, INSIDE / max(length, 1e-9))

    def tip(self, number: int, q: Matrix) -> Matrix:
        """Position of a finger's tip in W [m]."""
        link, p_LT = self.tips[number]
        X_WL = np.asarray(self.robot.pose(link, q))
        return np.asarray(X_WL[:3, :3] @ p_LT + X_WL[:3, 3])

    def base(self, number: int) -> Matrix:
        """Position of a finger's first joint in W [m]."""
        return np.asarray(self.robot.pose(self.palm.fingers[number].bodies[0], self.rest))[:3, 3]

    def joint_axes(self, finger: Finger) -> Matrix:
        """Axes of a finger's joints in W; (N, 3)."""
        found = []
        for body in finger.bodies:
            joint = self.tree.joint(body)
            assert joint is not None
            axis = np.asarray(self.robot.pose(body, self.rest))[:3, :3] @ joint.axis_L
            found.append(axis / np.linalg.norm(axis))
        return np.array(found)

    def _axis(self, finger: Finger) -> Matrix:
        """Direction that most axes of a finger's joints share, of either sign."""
        axes = self.joint_axes(finger)
        return np.asarray(np.linalg.eigh(axes.T @ axes)[1][:, -1])

    def bending(self, number: int) -> list[str]:
        """Independent joints that bend a finger."""
        finger = self.palm.fingers[number]
        axes = self.joint_axes(finger)
        along = np.abs(axes @ self.axes[number]) > BENDS
        bodies = [body for body, bends in zip(finger.bodies, along, strict=True) if bends]
        return self.tree.drivers(bodies)


def find_fist(tree: Tree, palm: Palm) -> Fist:
    """Returns thumb, states and directions of a hand with several fingers.

    Raises
    ------
    ValueError
        No joint bends a finger towards the others.
    """
    fingers = Fingers(tree, palm)
    numbers = range(len(palm.fingers))
    ends = {name: end for k in numbers for name, end in _bent(fingers, k).items()}
    if not ends:
        names = ", ".join(finger.name(tree) for finger in palm.fingers)
        raise ValueError(f"no joint bends one of the fingers {names} towards the others")
    opened, closed = fingers.rest.copy(), fingers.rest.copy()
    for name, (first, last) in ends.items():
        column = tree.robot.joint(name)
        opened[column] = first + OPENED * (last - first)
        closed[column] = first + CLOSED * (last - first)
    thumb, is_sure = _thumb(fingers, opened, closed)
    drivers = palm.drivers(tree)
    _oppose(fingers, thumb, [name for name in drivers if name not in ends], opened, closed)
    _until_free(tree, palm, opened, closed)
    for name, q in (("open", opened), ("closed", closed)):
        given = tree.state(name, drivers)
        if given is not None:
            columns = [tree.robot.joint(driver) for driver in drivers]
            q[columns] = given[columns]
    sideways = _sideways(fingers, thumb)
    half = (opened + closed) / 2
    others = [k for k in numbers if k != thumb]
    # The thumb counts as much as all the fingers that it meets.
    inside, bases = (
        (np.mean([at(k) for k in others], axis=0) + at(thumb)) / 2
        for at in (lambda k: fingers.tip(k, half), fingers.base)
    )
    forward = inside - bases
    forward -= sideways * (forward @ sideways)
    forward /= max(float(np.linalg.norm(forward)), 1e-9)
    X_WH = _between(fingers, opened, sideways, bases)
    return Fist(
        thumb, tuple(drivers), opened, closed, forward, sideways, fingers.tips, X_WH, is_sure
    )


def _between(fingers: Fingers, opened: Matrix, sideways: Matrix, bases: Matrix) -> Matrix:
    tips = [fingers.tip(k, opened) for k in range(len(fingers.palm.fingers))]
    middle = np.mean(tips, axis=0)
    out = middle - bases
    out -= sideways * (out @ sideways)
    out /= max(float(np.linalg.norm(out)), 1e-9)
    X_WH = np.eye(4)
    X_WH[:3, :3] = np.column_stack([sideways, np.cross(out, sideways), out])
    X_WH[:3, 3] = middle
    return X_WH


def _bent(fingers: Fingers, number: int) -> dict[str, tuple[float, float]]:
    """Open and closed end of each joint that bends a finger towards the others' bases."""
    robot = fingers.robot
    others = [fingers.base(k) for k in range(len(fingers.palm.fingers)) if k != number]
    target = np.mean(others, axis=0)
    found: dict[str, tuple[float, float]] = {}
    for name in fingers.bending(number):
        column = robot.joint(name)
        limits = float(robot.lower[column]), float(robot.upper[column])
        near = []
        for limit in limits:
            q = fingers.rest.copy()
            q[column] = 0.7 * limit + 0.3 * q[column]
            near.append(float(np.linalg.norm(fingers.tip(number, q) - target)))
        wide = abs(limits[1]) > 1.5 * abs(limits[0]), abs(limits[0]) > 1.5 * abs(limits[1])
        towards_upper = wide[0] or (not wide[1] and near[1] < near[0])
        first, last = limits if towards_upper else limits[::-1]
        back = BACK if not found else 0.0  # a finger bends back at its base alone
        if first * last < 0 and abs(first) > back:
            first = float(np.copysign(back, first))
        found[name] = first, last
    return found


def _thumb(fingers: Fingers, opened: Matrix, closed: Matrix) -> tuple[int, bool]:
    """Number of the thumb: by its name, or the finger that closes against the others."""
    tree, palm = fingers.tree, fingers.palm
    for k, finger in enumerate(palm.fingers):
        if any("thumb" in tree.links[link].lower() for link in finger.links(tree)):
            return k, True
    half = (opened + closed) / 2
    moves = np.array(
        [fingers.tip(k, half) - fingers.tip(k, opened) for k in range(len(palm.fingers))]
    )
    moves /= np.maximum(np.linalg.norm(moves, axis=1, keepdims=True), 1e-9)
    alike = (moves @ moves.T).sum(axis=1)
    order = np.argsort(alike)
    return int(order[0]), bool(alike[order[1]] - alike[order[0]] > 0.3)


def _oppose(fingers: Fingers, thumb: int, names: list[str], opened: Matrix, closed: Matrix) -> None:
    """Turns the thumb's other joints so that its tip meets those of the fingers."""
    robot, tree = fingers.robot, fingers.tree
    own = set(tree.drivers(list(fingers.palm.fingers[thumb].bodies)))
    others = [k for k in range(len(fingers.palm.fingers)) if k != thumb]
    for column in [robot.joint(name) for name in names if name in own]:
        best = (np.inf, float(opened[column]))
        for value in np.linspace(robot.lower[column], robot.upper[column], SPREADS):
            q = (opened + closed) / 2
            q[column] = value
            away = min(
                float(np.linalg.norm(fingers.tip(thumb, q) - fingers.tip(k, q))) for k in others
            )
            best = min(best, (away, float(value)))
        opened[column] = closed[column] = best[1]


def _until_free(tree: Tree, palm: Palm, opened: Matrix, closed: Matrix) -> None:
    """Closes an open hand that touches itself a little, until it does not."""
    made = scene.Scene(tree.robot)
    hand = {tree.links[link] for link in tree.links_below(palm.body)}
    step = (closed - opened) / 20
    always = touching(made, hand, (opened + closed) / 2)
    for _ in range(8):
        if touching(made, hand, opened) <= always:
            return
        opened += step


def _sideways(fingers: Fingers, thumb: int) -> Matrix:
    """Direction of the axes about which the fingers bend; positive along the largest component."""
    axes = np.array([axis for k, axis in enumerate(fingers.axes) if k != thumb])
    found = np.linalg.eigh(axes.T @ axes)[1][:, -1]
    return np.asarray(found * np.sign(found[np.argmax(np.abs(found))]))
