# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of the clasp planner: four hands, five objects, three poses, and additional ones.

The robot stands on a pedestal of 0.4 m: W is in its mounting face, the floor at z = -0.4. Purse and
travel bag stand on a table as high as the pedestal, the other objects on the floor. There are no
obstacles, as in the paper.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import clasp, geometry
from graspless.planning import Budget
from graspless.robot import Robot, builtin

from .shapes import with_holes

if TYPE_CHECKING:
    from collections.abc import Iterator

HANDS = ("kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar")
POINTS = 2000  # of a cloud
SECONDS = 10.0  # limit of a query
CYCLES = 1200  # limit of a query for a small hole: the same on any machine, however busy
FLOOR, TABLE = -0.4, 0.0  # heights in W [m]

# Where an object's middle stands [m], and how it is turned about the vertical [degrees].
POSES: dict[str, tuple[tuple[float, float, float, float], ...]] = {
    "purse": ((0.60, 0.00, TABLE, 90), (0.55, 0.25, TABLE, 30), (0.55, -0.25, TABLE, -45)),
    "bag": ((0.60, 0.00, FLOOR, 90), (0.55, 0.30, FLOOR, 30), (0.55, -0.30, FLOOR, -60)),
    "travel_bag": ((0.60, 0.00, TABLE, 90), (0.55, 0.30, TABLE, 30), (0.55, -0.30, TABLE, -45)),
    "lawn_mower": ((1.10, 0.00, FLOOR, 0), (0.95, 0.45, FLOOR, 25), (0.60, -0.75, FLOOR, -60)),
    "chair": ((0.80, 0.00, FLOOR, 0), (0.70, 0.30, FLOOR, 90), (0.80, -0.25, FLOOR, 20)),
}
# The arm's joints at the start: the hand points down, the flange is 0.69 m above the mounting face.
START = np.radians([0.0, -109.0, 109.0, 0.0, 80.0, 0.0])

# Section V-B: the hand hangs over the seat; the loop is the one under the seat's front edge.
OBSTRUCTED_POSE = (0.70, 0.0, FLOOR, 180.0)
OVER_THE_SEAT = np.radians([0.0, -66.0, 103.0, 0.0, 53.0, 0.0])
# Objects of households at their true size, whose holes are small for a hand.
SMALL = (
    "mug",
    "mug x1.6",
    "pitcher",
    "teapot",
    "kettle",
    "bucket",
    "pan with an eye",
    "scissors",
    "eyeglasses",
    "bag of two handles",
    "handlebar",
    "thick ring",
    "roll of tape",
    "spade",
    "crate",
    "basket of 2 with handle",
)
# Section V-C.
TOLERANCES = (0.5, 0.65, 0.70, 0.75)


@dataclasses.dataclass(frozen=True)
class Trial:
    """One query.

    Attributes
    ----------
    hand : str
        A robot of HANDS.
    object : str
        A sample object.
    place : tuple
        x, y, z [m] and yaw [degrees] of the object.
    pose : int
        Number of the object's pose, from 1.
    start : tuple of float
        The arm's joints [rad].
    is_obstructed : bool
        Clasp only the loop under the seat's front edge.
    options : tuple of (str, value)
        Fields of clasp.Options.
    cycles : int, optional
        Limit of the search, in place of SECONDS.
    """

    hand: str
    object: str
    place: tuple[float, float, float, float]
    pose: int = 1
    seed: int = 1
    start: tuple[float, ...] = tuple(START)
    is_obstructed: bool = False
    options: tuple[tuple[str, Any], ...] = ()
    cycles: int | None = None

    @property
    def name(self) -> str:
        return f"{self.hand}, {self.object}, pose {self.pose}, seed {self.seed}"

    def make_problem(self) -> clasp.Problem:
        robot, hand = robot_with_hand(self.hand)
        q_start = np.array(robot.state(hand.open))
        q_start[robot.group(hand.arm)] = self.start
        object_ = sample(self.object)
        loops = [front_loop(object_)] if self.is_obstructed else []
        return clasp.Problem(robot, hand, object_, placed(self.place), q_start, loops=loops)

    def make_options(self) -> clasp.Options:
        return clasp.Options(**dict(self.options))

    def make_budget(self, seconds: float | None) -> Budget:
        if seconds is None:
            seconds = math.inf if self.cycles else SECONDS
        return Budget(seconds=seconds, iterations=self.cycles, seed=self.seed)


@functools.cache
def robot_with_hand(name: str) -> tuple[Robot, clasp.Hand]:
    path = builtin(name)
    hand = clasp.hand_from_yaml_file(str(path.with_suffix(".clasp.yaml")))
    return Robot.from_urdf_file(str(path)), hand


@functools.cache
def sample(name: str) -> clasp.Object:
    """Returns a sample object, or one of shapes.py, given by its cloud."""
    options = geometry.LoopOptions(all_sides=True)
    if name not in SMALL:
        cloud = geometry.sample_surface(clasp.sample_object(name), POINTS)
        return clasp.Object.from_cloud(name, cloud, options)
    shape = next(shape for shape in with_holes() if shape.name == name)
    cloud = geometry.sample_surface(shape.parts, POINTS)
    middle = (cloud.min(axis=0) + cloud.max(axis=0)) / 2
    return clasp.Object.from_cloud(name, cloud - [*middle[:2], cloud[:, 2].min()], options)


def placed(place: tuple[float, float, float, float]) -> np.ndarray[Any, np.dtype[np.float64]]:
    x, y, z, degrees = place
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, z], [0, 0, 0, 1.0]])


def front_loop(chair: clasp.Object) -> int:
    """Returns the chair's loop down to the rungs that is farthest in front (+x of O)."""
    loops = chair.loops.found
    low = [i for i, loop in enumerate(loops) if min(p[2] for p in loop.points) < 0.25]
    return max(low, key=lambda i: float(np.mean(loops[i].points, axis=0)[0]))


def paper(seeds: int, start: int = 1) -> Iterator[Trial]:
    """Returns the trials of Section V-A: every hand, object and pose."""
    for seed in range(start, start + seeds):
        for hand in HANDS:
            for name, places in POSES.items():
                for pose, place in enumerate(places, 1):
                    yield Trial(hand, name, place, pose, seed)


def chair(seeds: int, start: int = 1) -> Iterator[Trial]:
    """Returns the trials of Section V-B: a loop without a straight approach."""
    for seed in range(start, start + seeds):
        for hand in HANDS:
            yield Trial(
                hand,
                "chair",
                OBSTRUCTED_POSE,
                seed=seed,
                start=tuple(OVER_THE_SEAT),
                is_obstructed=True,
            )


def tolerance(seeds: int, start: int = 1) -> Iterator[Trial]:
    """Returns the trials of Section V-C: thresholds of virtual linking, no stability test."""
    for linking in TOLERANCES:
        yield from purses(seeds, start, (("min_linking", linking), ("must_be_secure", False)))


def purses(
    seeds: int, start: int = 1, options: tuple[tuple[str, Any], ...] = ()
) -> Iterator[Trial]:
    """Returns trials of every hand with the purse in its poses."""
    for seed in range(start, start + seeds):
        for hand in HANDS:
            for pose, place in enumerate(POSES["purse"], 1):
                yield Trial(hand, "purse", place, pose, seed, options=options)


def small(seeds: int, start: int = 1) -> Iterator[Trial]:
    """Returns trials of one hand with objects of households on a table."""
    for seed in range(start, start + seeds):
        for name in SMALL:
            for pose, place in enumerate(POSES["purse"], 1):
                yield Trial("kr5_sdh", name, place, pose, seed, cycles=CYCLES)


GRIDS = {"paper": paper, "chair": chair, "tolerance": tolerance, "small": small}
"""What makes the trials of a grid that asks clasp.plan()."""
