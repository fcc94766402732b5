# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The chain of joints that carries a hand, and its home."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from .. import frames, scene
from .._core import robot as robots

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from ..frames import Matrix
    from ..scene import Scene
    from .pairs import Pair
    from .tree import Tree

MANY = 8  # largest number of joints of an arm that is marked as sure
SAMPLES = 1500  # configurations from which the home is chosen
OFTEN, OFTEN_SAMPLES = 0.5, 60  # pairs touch often in more than this fraction of the samples
MARGIN = 0.1  # distance kept from the limits, as a fraction of the joint's range
# Distances of the hand from the base and heights over it, as fractions of the arm's reach. Arms on
# a torso reach tables that are below their base.
DISTANCES = (0.45, 0.55, 0.35, 0.65)
HEIGHTS = ((0.4, 0.3, 0.5, 0.2), (0.1,), (0.0, -0.2, -0.4))
ABOVE = 0.05  # height over the plane in which a robot stands, as a fraction of the reach
# Depth of the elbow below the line from shoulder to wrist that still counts as up, as a fraction of
# the reach.
LOW = 0.01
HIGHER = 16  # further places tried once a home with the elbow down was found


@dataclass(frozen=True)
class Arm:
    """Joints between the last fork and the palm."""

    base: int
    joints: tuple[str, ...]
    reason: str
    is_sure: bool


def find_arm(tree: Tree, palm: int) -> Arm:
    """Returns the arm that carries a palm; it has no joints if the palm is the root."""
    path = tree.path(palm)
    own = set(tree.drivers(path[1:]))
    forks = [
        k
        for k, body in enumerate(path[:-1])
        if any(_is_part(tree, child, own) for child in tree.children[body] if child != path[k + 1])
    ]
    first = forks[-1] if forks else 0
    base = path[first]
    joints = tuple(tree.drivers(path[first + 1 :]))
    reason = f"{len(joints)} joints in a row from {tree.links[base]} to {tree.links[palm]}"
    if forks:
        others = len(path[1 : first + 1])
        reason += f"; {tree.links[base]} carries other parts, too"
        reason += f", and {others} joints below it do not move" if others else ""
    if len(joints) > MANY:
        reason += "; some may belong to a floating base; make these fixed"
    return Arm(base, joints, reason, first == 0 and len(joints) <= MANY)


def _is_part(tree: Tree, body: int, own: set[str]) -> bool:
    """Returns True unless a body is a mere frame, or follows the arm's `own` joints."""
    return tree.has_shape(body) and not own.issuperset(tree.drivers(tree.below(body)))


@dataclass(frozen=True)
class Home:
    """Configuration at the start."""

    q: Matrix
    reason: str
    is_sure: bool


def find_home(
    tree: Tree, arm: Arm, placed: tuple[str, Matrix], pairs: Iterable[Pair], q_open: Matrix
) -> Home | None:
    """Returns a free configuration with the hand open, away from limits, pointing down if possible.

    Parameters
    ----------
    tree : Tree
    arm : Arm
    placed : str and array [4, 4]
        Link and pose in it of the frame between the tips, whose Z is out of the hand.
    pairs : iterable of pairs of str
        Links that are not tested against each other.
    q_open : array [dof]
        The hand's joints when open.

    Returns
    -------
    Home or None
        None if no free configuration was found.
    """
    search = _Search(tree, arm, placed, pairs, q_open)
    if not any(search.is_free(search.draw()) for _ in range(OFTEN_SAMPLES)):
        return None
    down = search.pointing_down()
    if down is not None:
        reason = "free of collision, away from the limits, the hand points down"
        elbow = "" if search.is_elbow_up(down) else ", with the elbow down"
        if search.is_above(down, 0.0):
            return Home(down, reason + elbow, True)
        low = "; a table on which the robot stands would be in the way of the hand"
        return Home(down, reason + elbow + low, False)
    level = search.drawn()
    if level is None:
        return None
    return Home(level, "free of collision and away from the limits", False)


def often_touching(tree: Tree, arm: Arm, pairs: Iterable[Pair], q_open: Matrix) -> list[Pair]:
    """Returns the pairs that touch in most configurations of the arm."""
    search = _Search(tree, arm, (tree.links[0], np.eye(4)), pairs, q_open)
    count: Counter[Pair] = Counter()
    for _ in range(OFTEN_SAMPLES):
        search.scene.is_free(search.draw())
        for a, b in search.scene.world.all_collisions():
            count[search.scene.world.name(a), search.scene.world.name(b)] += 1
    return [pair for pair, times in count.items() if times > OFTEN * OFTEN_SAMPLES]


class _Search:
    def __init__(
        self,
        tree: Tree,
        arm: Arm,
        placed: tuple[str, Matrix],
        pairs: Iterable[Pair],
        q_open: Matrix,
    ) -> None:
        robot = tree.robot
        self.tree, self.robot, self.q_open = tree, robot, q_open
        self.link = robot.frame(placed[0])
        self.X_LH = placed[1]
        self.columns = [robot.joint(name) for name in arm.joints]
        self.lower, self.upper = (
            np.asarray(limit)[self.columns] for limit in (robot.lower, robot.upper)
        )
        self.scene: Scene = scene.Scene(robot)
        for pair in pairs:
            self.scene.world.remove_pair(*pair)
        self.rng = np.random.default_rng(1)
        self.base = np.asarray(robot.pose(arm.base, q_open))[:3, 3]
        drawn = [self.draw() for _ in range(200)]
        tips = np.array([self._pose(q)[:3, 3] for q in drawn])
        self.reach = float(np.linalg.norm(tips - self.base, axis=1).max())
        self.two = drawn[:2]  # configurations

    @cached_property
    def elbows(self) -> list[int]:
        """Links from the arm's second joint to its last one, from the base outwards."""
        if not self.columns:
            return []
        a, b = self.two
        turned, bent = a.copy(), b.copy()
        turned[self.columns[-1]] = b[self.columns[-1]]
        bent[self.columns[0]] = a[self.columns[0]]

        def stays(link: int, q: Matrix) -> bool:
            return np.allclose(self.robot.pose(link, a), self.robot.pose(link, q), atol=1e-9)

        return [
            link
            for link in reversed(self.tree.line(self.link))
            if stays(link, turned) and not stays(link, bent)
        ]

    def draw(self) -> Matrix:
        q: Matrix = self.q_open.copy()
        t = MARGIN + (1 - 2 * MARGIN) * self.rng.random(len(self.columns))
        q[self.columns] = self.lower + t * (self.upper - self.lower)
        return q

    def _pose(self, q: Matrix) -> Matrix:
        return np.asarray(self.robot.pose(self.link, q) @ self.X_LH)

    def room(self, q: Matrix) -> float:
        """Smallest distance to a limit, as a fraction of the joint's range."""
        values, span = q[self.columns], self.upper - self.lower
        moves = span > 0  # a joint whose limits are equal is always in its middle
        nearest = np.minimum(values - self.lower, self.upper - values)
        return float((nearest[moves] / span[moves]).min(initial=0.5))

    def is_free(self, q: Matrix) -> bool:
        return bool(self.scene.is_free(q))

    def is_above(self, q: Matrix, plane: float) -> bool:
        """True if the hand is over a horizontal plane at a height [m]."""
        return bool(self._pose(q)[2, 3] > plane + ABOVE * self.reach)

    def is_elbow_up(self, q: Matrix) -> bool:
        """True if the arm bends upwards from the straight line from its first to its last link."""
        at = np.array([self.robot.pose(link, q)[:3, 3] for link in self.elbows])
        if len(at) < 3:
            return True
        line = at[-1] - at[0]
        along = (at - at[0]) @ line / max(line @ line, 1e-12)
        heights = (at - at[0] - np.outer(along, line))[:, 2]
        return bool(heights[np.abs(heights).argmax()] > -LOW * self.reach)

    def pointing_down(self) -> Matrix | None:
        """Returns the roomiest configuration at the first place where the hand can point down.

        One with the elbow down, where a table would be, is the last resort.
        """
        ik = robots.Ik(self.robot, self.link, self.columns, restarts=4)
        fallback, left = None, HIGHER
        for place in self._places():
            found = self._free_at(ik, place)
            if found is not None and self.is_elbow_up(found):
                return found
            if fallback is None:
                fallback = found
            else:
                left -= 1
            if left == 0:
                break
        return fallback

    def _free_at(self, ik: robots.Ik, place: list[Matrix]) -> Matrix | None:
        """Returns the roomiest free configuration at a place, with the elbow up if possible."""
        X_HL = np.linalg.inv(self.X_LH)
        middle = self.q_open.copy()
        middle[self.columns] = (self.lower + self.upper) / 2
        found = [q for X_WH in place for q in np.asarray(ik.solve_all(X_WH @ X_HL, middle))]
        roomy = [q for q in found if self.room(q) > MARGIN / 2]
        roomy.sort(key=lambda q: (self.is_elbow_up(q), self.room(q)), reverse=True)
        return next((q for q in roomy if self.is_free(q)), None)

    def _places(self) -> Iterator[list[Matrix]]:
        """Yields places around the arm, those in front first: the hand straight down, two yaws."""
        turns = (0.0, np.pi / 2, -np.pi / 2, np.pi)
        for heights in HEIGHTS:
            for turn, distance, height in product(turns, DISTANCES, heights):
                away = [distance * np.cos(turn), distance * np.sin(turn), height]
                at = frames.translation(self.base + self.reach * np.array(away))
                yield [at @ frames.from_rpy([np.pi, 0.0, turn + yaw]) for yaw in (0.0, np.pi / 2)]

    def drawn(self) -> Matrix | None:
        """Returns the random configuration whose hand points down most."""
        best, lowest = None, 2.0
        for _ in range(SAMPLES):
            q = self.draw()
            z = float(self._pose(q)[2, 2])
            if z < lowest and self.is_above(q, self.base[2]) and self.is_free(q):
                best, lowest = q, z
        return best
