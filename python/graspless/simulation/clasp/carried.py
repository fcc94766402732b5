# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of a clasp and the carries after it: the hand lifts the object with its weight.

It stands as in the simulation of a clasp alone, and nothing else pulls at it. If the last carry
puts it down, the floor is at the height of that place before it is lowered; the hand opens,
withdraws, and the object must stand where it was put.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames, timing
from ...tasks.chain.start import off_place
from ..results import Running, Trial
from ..settings import Clasp, Slide
from . import FAILURES as CLASP_FAILURES
from . import MEASURES as CLASP_MEASURES
from . import close, has_closed
from .execution import LOOK, Execution, Recorder, executed, execution_of
from .model import make_world
from .object import OBJECT, STAND

if TYPE_CHECKING:
    from collections.abc import Generator, Sequence

    from ...frames import Matrix
    from ..variation import Variation
    from .model import World

HOLD, LOWER, OPEN, RETREAT, REST = "hold", "lower", "open", "retreat", "rest"
FAILURES = {
    **{name: CLASP_FAILURES[name] for name in ("hit", "not_closed")},
    "dropped": "the loop left the closed hand on the way, or the object was not lifted",
    "not_placed": "the object did not stand free of the hand, where it was to be put down",
}
_CLOSED = ("moved_before", "moved_by_closing", "moved_by_grip", "linking", "grip")
MEASURES = {
    **{name: CLASP_MEASURES[name] for name in _CLOSED},
    "raised": "least height of a point over the floor after the first carry [m]",
    "kept": "1 if the loop was in the closed hand until it opened, or to the end",
    "swayed": "largest distance of a point of the object from its planned place, while the hand "
    "held it [m]",
    "place_error": "distance of the object from its place, at the end [m]",
    "place_angle": "angle between the object and its pose at that place [rad]",
}
_OFF_THE_FLOOR = 0.02  # planned rise of an object that must leave the floor [m]


def run(stages: Sequence[Any], variation: Variation, *, record: bool) -> Trial:
    """Executes the stages of a solved chain: a clasp, and carries."""
    return executed(partial(start, stages, variation), record)


def start(stages: Sequence[Any], variation: Variation, recorder: Recorder | None = None) -> Running:
    """Returns the execution, to be run step by step."""
    grasp, *carries = stages
    world = make_world(grasp.task, variation, Clasp())
    execution = execution_of(grasp, world, recorder)

    def steps() -> Generator[str, None, Trial]:
        measures = yield from close(execution, timing.time(grasp))
        failures = has_closed(execution, grasp, measures)
        if execution.judge.linked():
            carried = _Carried(execution, grasp, carries)
            yield from carried.steps()
            measures |= carried.measures
            failures += carried.failures
        return execution.trial(variation, failures, measures)

    return Running(world.model, world.data, lambda: world.object_pose, steps())


class _Carried:
    """Execution of carries with an object in the closed hand."""

    def __init__(self, execution: Execution, grasp: Any, carries: Sequence[Any]) -> None:
        self.execution, self.world, self.judge = execution, execution.world, execution.judge
        self.failures: list[str] = []
        self.measures: dict[str, float] = {"kept": 0.0, "swayed": 0.0}
        self._begin: Matrix = np.asarray(grasp.segments[-1].object_poses[-1])
        self._squeeze = self.world.data.ctrl - grasp.segments[-1].positions[-1]
        self._carries = carries
        self._reach = self.judge.reach()

    def steps(self) -> Generator[str, None, None]:
        """Follows the carries until the object is lost or has been put down."""
        for k, stage in enumerate(self._carries):
            yield from self._follow(stage)
            if self.failures:
                return
            if k == 0:
                self._measure_lift(stage)
        self.measures["kept"] = 1.0
        if self._carries[-1].task.problem.places is not None:
            yield from self._rest()

    def _follow(self, stage: Any) -> Generator[str, None, None]:
        """Moves as planned; the squeeze of the closed hand goes while it opens."""
        execution, step = self.execution, self.world.model.opt.timestep
        trajectory = timing.time(stage)
        moments = trajectory.at(np.arange(0.0, trajectory.duration + step, step))
        names = np.asarray(moments.names)
        left = np.ones(len(names))
        opens = np.flatnonzero(names == OPEN)
        if opens.size:
            left[opens[0] :] = 0.0
            left[opens] = np.linspace(1, 0, len(opens))
        commands = execution.commands(moments) + left[:, None] * self._squeeze
        count = round(LOOK / step)
        for i in range(0, len(names), count):
            if names[i] == LOWER and (i == 0 or names[i - count] != LOWER):
                yield from self._wait()
                self._raise_floor(stage)
            yield from execution.steps(names[i], commands[i : i + count])
            if names[i] in (OPEN, RETREAT):
                continue
            row = min(i + count, len(names)) - 1
            self._measure_sway(np.asarray(moments.object_poses[row]))
            if not (self.judge.linked() and self.judge.distance() <= self._reach):
                self.failures.append("dropped")
                return

    def _wait(self, name: str = HOLD) -> Generator[str, None, None]:
        """Holds still: until what hangs has come to rest, for instance."""
        command = self.world.data.ctrl.copy()
        count = round(LOOK / self.world.model.opt.timestep)
        for _ in range(round(Slide().hold_seconds / LOOK)):
            yield from self.execution.steps(name, np.repeat(command[None], count, axis=0))

    def _raise_floor(self, stage: Any) -> None:
        """Moves the floor to the height of the place."""
        rise = stage.segments[-1].object_poses[-1][2, 3] - self._begin[2, 3]
        self.world.data.mocap_pos[self._stand, 2] += rise

    @property
    def _stand(self) -> int:
        return int(self.world.model.body(STAND).mocapid[0])

    def _measure_sway(self, X_WO: Matrix) -> None:
        planned = frames.transform(X_WO, self.world.points_O)
        sway = float(np.linalg.norm(self.execution.surface() - planned, axis=1).max())
        self.measures["swayed"] = max(self.measures["swayed"], sway)

    def _measure_lift(self, stage: Any) -> None:
        floor = self.world.data.mocap_pos[self._stand, 2]
        self.measures["raised"] = float(self.execution.surface()[:, 2].min() - floor)
        planned = stage.segments[-1].object_poses[-1][2, 3] - self._begin[2, 3]
        if planned > _OFF_THE_FLOOR and self.measures["raised"] <= 0:
            self.failures.append("dropped")

    def _rest(self) -> Generator[str, None, None]:
        """Waits for the object to come to rest, and measures where it stands."""
        allowed = Slide().placed
        off, askew = self._loose()
        yield from self._wait(REST)
        place = np.asarray(self._carries[-1].segments[-1].object_poses[-1])
        X_WO = self.world.object_pose
        error = float(np.linalg.norm((X_WO - place)[:3, 3]))
        angle = frames.angle(place, X_WO)
        self.measures |= {"place_error": error, "place_angle": angle}
        stands = error <= allowed[0] + off and angle <= allowed[1] + askew
        if not stands or is_touched(self.world):
            self.failures.append("not_placed")

    def _loose(self) -> tuple[float, float]:
        """How far from its place the object may stand because it hangs loose [m, rad]."""
        problem = self._carries[-1].task.problem
        if problem.X_WO_hanging is None:
            return 0.0, 0.0
        held, hanging = np.asarray(problem.object.X_WB), np.asarray(problem.X_WO_hanging)
        yaw = abs(float(np.arctan2(*(hanging @ np.linalg.inv(held))[[1, 0], 0])))
        return off_place(self.world.points_O, held, hanging), yaw


def is_touched(world: World) -> bool:
    """True if the robot touches the object."""
    model, contact = world.model, world.data.contact
    own = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_FLEX, OBJECT)
    bodies = np.where(contact.geom >= 0, model.geom_bodyid[contact.geom], -1)
    is_object = (bodies == world.body) | (own >= 0) & (contact.flex == own)
    is_robot = (bodies > 0) & (bodies != world.body) & (bodies != model.body(STAND).id)
    touches = is_object.any(axis=1) & is_robot.any(axis=1) & (contact.dist < 0)
    return bool(touches.any())
