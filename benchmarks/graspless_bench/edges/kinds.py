# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of every kind of plan that moves an arm among bodies it must not touch."""

from __future__ import annotations

import dataclasses
import itertools
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from graspless import carry, clasp, fingertip, frames, geometry, pinch, scene, slide
from graspless._core import fingertip as core_fingertip
from graspless.tasks import task_from_dict

from ..clasp import grid as clasps
from ..slide import grid as slides
from ..slide.shapes import OBJECTS, TABLES

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from numpy.typing import NDArray

    from graspless.collision import Obstacle
    from graspless.planning import Budget

    Array = NDArray[np.float64]

SECONDS = 10.0  # limit of a search
# Segments in which nothing may touch.
FREE = ("approach", "reach", "grasp", "carry", "joint segment 0 (approach)")
THICK = 1.0  # of the box that stands for a floor [m]
FLOOR = geometry.Box([20.0, 20.0, THICK])


class Carried(NamedTuple):
    """A fingertip plan, and the joint paths that carry it out."""

    plan: Any
    paths: Any

    @property
    def segments(self) -> list[Any]:
        """The segments of the joint paths, with the names that their certificate gives them."""
        return [
            slide.Segment(f"joint segment {i} ({s.name})", s.positions, s.X_WO)
            for i, s in enumerate(self.paths.segments)
        ]

    def __bool__(self) -> bool:
        return bool(self.plan) and bool(self.paths)


class Carrier:
    """The planner of fingertips that an arm carries.

    Parameters
    ----------
    arm : tasks.fingertip.Arm
        As in the task.
    """

    def __init__(self, arm: Any) -> None:
        self.robot = arm.robot
        self._arm = arm

    def plan(self, problem: Any, options: Any, budget: Budget) -> Carried:
        """Plans the fingertips and the joint paths."""
        a = self._arm
        return Carried(
            *core_fingertip.plan_carried(
                problem, options, a.robot, a.carrier, a.q_home, a.options, budget
            )
        )

    def check(self, problem: Any, found: Carried, options: Any) -> list[str]:
        """Returns the faults of both."""
        of_paths = core_fingertip.check_realization(*self._carried(problem, found))
        return core_fingertip.check(problem, found.plan, options) + of_paths

    def certify(self, problem: Any, found: Carried, _: Any) -> Any:
        """Returns the certificate of the joint paths."""
        return core_fingertip.certify_realization(*self._carried(problem, found))

    def _carried(self, problem: Any, found: Carried) -> tuple[Any, ...]:
        a = self._arm
        return problem, found.plan, a.robot, a.carrier, found.paths, a.options


@dataclasses.dataclass(frozen=True)
class Case:
    """A problem of a planner.

    Attributes
    ----------
    planner : module or Carrier
        With `plan`, `check` and `certify`.
    frame : str
        Frame of the hand.
    """

    planner: Any
    problem: Any
    options: Any
    budget: Budget
    frame: str

    @property
    def robot(self) -> Any:
        """The robot of the problem, or of the planner."""
        return (self.planner if isinstance(self.planner, Carrier) else self.problem).robot

    def among(self, obstacles: list[Obstacle]) -> Any:
        """Returns the problem with further obstacles."""
        p: Any = self.problem
        every = [*p.obstacles, *obstacles]
        if isinstance(p, clasp.Problem):
            return clasp.Problem(p.robot, p.hand, p.object, p.X_WO, p.q_start, every)
        if isinstance(p, carry.Problem):
            return carry.Problem(p.robot, p.frame, p.object, p.X_WO_goal, p.q_start, every)
        if isinstance(p, fingertip.Problem):
            return fingertip.Problem(
                object=p.object,
                motion=p.motion,
                fingers=p.fingers,
                planes=p.planes,
                friction=p.friction,
                obstacles=every,
                gravity_W=p.gravity_W,
            )
        return slides.among(p, every)

    def bodies(self, obstacles: list[Obstacle], segment: Any) -> scene.Scene:
        """Returns the robot among all bodies of a segment, the object where it is then."""
        p: Any = self.problem
        bodies = scene.Scene(self.robot)
        fixed = [
            bodies.add_obstacle(obstacle.name, obstacle.shapes, obstacle.X_WB)
            for obstacle in [*p.obstacles, *obstacles]
        ]
        if isinstance(p, carry.Problem):
            held = _hold(bodies, p)
            for body in fixed:
                bodies.world.add_pair(held, body)
            return bodies
        if isinstance(p, clasp.Problem):
            shapes = [geometry.PlacedShape(p.object.surface)]
        elif isinstance(p, fingertip.Problem):
            (floor,) = p.planes
            below = frames.translation([0, 0, floor.offset - THICK / 2])
            bodies.add_obstacle(floor.name, [geometry.PlacedShape(FLOOR)], below)
            shapes = [geometry.PlacedShape(p.object.mesh)]
        else:
            bodies.add_obstacle("support", p.support.shapes, p.support.X_WS)
            shapes = p.object.shapes
        bodies.add_obstacle("object", shapes, segment.object_poses[0], touches_base=False)
        return bodies


def _hold(bodies: scene.Scene, problem: carry.Problem) -> int:
    """Adds the carried object to the bodies. The links that touch it at the start hold it."""
    held = bodies.add_object(problem.object.name, problem.object.shapes)
    X_FW = np.linalg.inv(problem.robot.pose(problem.frame, problem.q_start))
    holders: list[str] = []
    while True:
        bodies.attach(held, problem.frame, X_FW @ problem.object.X_WB, holders)
        pair = bodies.collision(problem.q_start) or ()
        links = set(pair) & set(problem.robot.frame_names) if problem.object.name in pair else set()
        if not links:
            return held
        holders += links
        bodies.detach(held)


def _slides() -> Iterator[Case]:
    """Slides of the WAM with the library's own margins, over all tables and objects."""
    for index in itertools.count():
        for table, thing in itertools.product(TABLES, OBJECTS):
            trial = slides.Trial(slides.Start(table, thing, 1.0, index, 14), defaults=True)
            problem, options = trial.make_problem(), trial.make_options()
            hand = problem.hand.grasp_frame
            yield Case(slide, problem, options, trial.make_budget(SECONDS), hand)


def _clasps() -> Iterator[Case]:
    """Clasps of four hands, the objects up to 5 cm aside from their places."""
    for seed in itertools.count(1):
        for trial in clasps.paper(1, seed):
            dx, dy = np.random.default_rng(seed).uniform(-0.05, 0.05, 2)
            x, y, z, yaw = trial.place
            moved = dataclasses.replace(trial, place=(x + dx, y + dy, z, yaw))
            problem, options = moved.make_problem(), moved.make_options()
            yield Case(clasp, problem, options, moved.make_budget(SECONDS), problem.hand.frame)


def _pinches() -> Iterator[Case]:
    """Boxes on a table that the WAM pinches."""
    for seed in itertools.count(1):
        uniform = np.random.default_rng(seed).uniform
        size = [float(uniform(0.06, 0.12)), float(uniform(0.02, 0.05))]
        x, y, yaw = (float(uniform(*side)) for side in ((0.5, 0.75), (-0.25, 0.25), (-3, 3)))
        yield _of_document(
            pinch,
            {
                "kind": "pinch",
                "robot": {"urdf": "wam_t42"},
                "object": {
                    "name": "box",
                    "rectangle": {"size": size},
                    "thickness": float(uniform(0.06, 0.14)),
                    "mass": 0.2,
                    "pose": {"x": x, "y": y, "yaw": yaw},
                },
                "support": {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}},
            },
            seed,
        )


def _carries() -> Iterator[Case]:
    """A bar that the WAM carries past a post."""
    home = {"wam_joint_2": 0.7, "wam_joint_4": 1.6, "wam_joint_6": 0.84}
    for seed in itertools.count(1):
        uniform = np.random.default_rng(seed).uniform
        side = float(uniform(0.15, 0.35)) * (-1) ** seed
        offset = [float(uniform(-0.10, 0.10)), side, float(uniform(-0.05, 0.10))]
        post = [0.65 + float(uniform(0.0, 0.2)), side * float(uniform(0.3, 0.7)), 0.12]
        yield _of_document(
            carry,
            {
                "kind": "carry",
                "robot": {"urdf": "wam_t42", "home": home},
                "frame": "grasp",
                "object": {"name": "bar", "box": [0.02, 0.02, 0.10]},
                "pose": {"position": [0.65, 0.0, 0.29]},
                "offset": offset,
                "obstacles": [
                    {
                        "name": "post",
                        "capsule": {"radius": 0.02, "length": float(uniform(0.1, 0.3))},
                        "pose": {"position": post},
                    }
                ],
            },
            seed,
        )


def _tumbles() -> Iterator[Case]:
    """Blocks that the fingertips of a WAM tumble over an edge."""
    for seed in itertools.count(1):
        uniform = np.random.default_rng(seed).uniform
        size = [float(uniform(*side)) for side in ((0.03, 0.08), (0.03, 0.08), (0.05, 0.12))]
        place = [float(uniform(0.4, 0.75)), float(uniform(-0.3, 0.3)), size[2] / 2]
        pose = {"position": place, "rpy": [0.0, 0.0, float(uniform(-3, 3))]}
        yield _of_document(
            fingertip,
            {
                "kind": "fingertip",
                "object": {"name": "object", "box": size, "mass": float(uniform(0.1, 0.4))},
                "fingers": {"radius": 0.013, "friction": 0.8},
                "friction": 0.8,
                "motion": {"tumble": {"over": "+x", "pose": pose, "segments": 18}},
                "options": {"min_stability": 1.0},
                "robot": {"urdf": "wam_t42_tips"},
            },
            seed,
        )


def _of_document(planner: Any, document: dict[str, Any], seed: int) -> Case:
    budget = {"seconds": SECONDS, "seed": seed}
    task: Any = task_from_dict(document | {"budget": budget}, "bench: edges", resolve=True)
    problem = task.problem
    if planner is fingertip:
        tip = task.arm.carrier.fingertips[0]
        return Case(Carrier(task.arm), problem, task.options, task.budget, tip)
    frame = problem.frame if isinstance(problem, carry.Problem) else problem.hand.grasp_frame
    return Case(planner, problem, task.options, task.budget, frame)


MAKERS: dict[str, Callable[[], Iterator[Case]]] = {
    "slide": _slides,
    "clasp": _clasps,
    "pinch": _pinches,
    "carry": _carries,
    "fingertip": _tumbles,
}
