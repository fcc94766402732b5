# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution of a clasp: reach, close, grip, pull."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from time import perf_counter
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames, limits
from ...tasks.clasp.hand import hand_of
from ..results import Recording, Trial, drained
from ..robots import lags
from .judge import Judge

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator, Sequence

    from ... import clasp
    from ...clasp import Plan
    from ...frames import Matrix
    from ...timing import Trajectory
    from ..results import Running
    from ..variation import Variation
    from .model import World

LOOK = 0.02  # between two observations, and two rows of a recording [s]


@dataclass
class Recorder:
    """Rows of a recording; time continues when the world is reset."""

    rows: list[tuple[float, Matrix, Matrix, str]] = field(default_factory=list)

    def add(self, world: World, name: str) -> None:
        """Adds a row, LOOK after the one before."""
        self.rows.append((len(self.rows) * LOOK, world.positions, world.object_pose, name))

    def recording(self) -> Recording:
        """Returns the recording of all rows."""
        return Recording.of_arm(self.rows)


def executed(prepare: Callable[[Recorder | None], Running], record: bool) -> Trial:
    """Runs what `prepare` makes of a recorder, if asked to `record`; returns the trial."""
    started = perf_counter()
    recorder = Recorder() if record else None
    trial = drained(prepare(recorder).steps)
    recording = None if recorder is None else recorder.recording()
    return replace(trial, seconds=perf_counter() - started, recording=recording)


class Execution:
    """A running world, observed every LOOK seconds.

    Attributes
    ----------
    touched : tuple of str or None
        The first obstacle that the robot touched, and what touched it.
    """

    def __init__(
        self, world: World, judge: Judge, hand: clasp.Hand, robot: Any, recorder: Recorder | None
    ) -> None:
        self.world, self.judge, self.recorder = world, judge, recorder
        self.touched: tuple[str, str] | None = None
        self._steps = max(1, round(LOOK / world.model.opt.timestep))
        self._fingers = np.array(robot.group(hand.hand))
        self._lags = lags(robot)
        self._weights = np.asarray(robot.step_weights)[self._fingers]
        self._closed = robot.clamp(robot.state(hand.closed))
        self._open = robot.clamp(robot.state(hand.open))

    def run(self, name: str) -> None:
        """Runs to the next observation, with unchanged commands."""
        limits.poll()
        world = self.world
        mujoco.mj_step(world.model, world.data, nstep=self._steps)
        self._observe(name)

    def steps(self, name: str, commands: Matrix) -> Iterator[str]:
        """Runs to the next observation with commands [steps, dof]; yields before each step."""
        limits.poll()
        world = self.world
        for command in commands:
            world.data.ctrl[:] = command
            yield name
            mujoco.mj_step(world.model, world.data)
        self._observe(name)

    def _observe(self, name: str) -> None:
        world = self.world
        mujoco.mj_kinematics(world.model, world.data)
        self.touched = self.touched or world.touched()
        if self.recorder is not None:
            self.recorder.add(world, name)

    def settle(self, seconds: float) -> Iterator[str]:
        """Lets the object settle while the robot holds still."""
        command = self.world.data.ctrl.copy()
        for _ in range(_looks(seconds)):
            yield from self.steps("settle", np.repeat(command[None], self._steps, axis=0))

    def follow(self, trajectory: Trajectory) -> Generator[str, None, dict[str, float]]:
        """Moves arm and hand as planned; returns the largest displacement of the object by segment
        [m].
        """
        step = self.world.model.opt.timestep
        moments = trajectory.at(np.arange(0.0, trajectory.duration + step, step))
        commands = self.commands(moments)
        names = moments.names
        moved: dict[str, float] = {}
        resting = self.surface()
        for i in range(0, len(moments), self._steps):
            yield from self.steps(names[i], commands[i : i + self._steps])
            moved[names[i]] = max(self.moved(resting), moved.get(names[i], 0.0))
        return moved

    def commands(self, moments: Trajectory) -> Matrix:
        """Returns commands [steps, dof] that motors with damping follow without lag."""
        commands: Matrix = moments.positions + self._lags * moments.velocities
        return commands

    def surface(self) -> Matrix:
        """Points of the object in W [m]."""
        return frames.transform(self.world.object_pose, self.world.points_O)

    def moved(self, resting: Matrix) -> float:
        """Returns the largest distance of a point of the object from its earlier position [m]."""
        return float(np.linalg.norm(self.surface() - resting, axis=1).max())

    def grip(self) -> Generator[str, None, Matrix]:
        """Closes every joint of the hand until its motor reaches the torque of the grip. Returns
        the final torque of each joint, as a fraction of its limit.
        """
        data, settings = self.world.data, self.world.settings
        step = settings.grip_rate * self.world.model.opt.timestep / self._weights
        command = data.ctrl.copy()
        # A joint that is open and closed at one value does not close, and none ever opens.
        way = np.sign(self._closed - self._open)[self._fingers]
        still = 0
        for _ in range(_looks(settings.grip_seconds)):
            left = way * (self._closed - command)[self._fingers]
            stride = way * np.clip(left, 0.0, step)
            goes = np.where(self.effort() < settings.grip_effort, stride, 0.0)
            commands = np.repeat(command[None], self._steps, axis=0)
            commands[:, self._fingers] += np.arange(1, self._steps + 1)[:, None] * goes
            command = commands[-1]
            yield from self.steps("grip", commands)
            still = 0 if goes.any() else still + 1
            if still > settings.grip_still:
                break
        return self.effort()

    def effort(self) -> Matrix:
        """Torques of the joints of the hand [n], relative to their maxima."""
        model, data = self.world.model, self.world.data
        limits = model.actuator_forcerange[self._fingers, 1]
        effort: Matrix = np.abs(data.actuator_force[self._fingers]) / limits
        return effort

    def open(self) -> None:
        """Opens the hand to its pre-shape; the arm stays."""
        start, data = self.world.data.ctrl.copy(), self.world.data
        looks = _looks(self.world.settings.open_seconds)
        for look in range(1, looks + 1):
            goal = start[self._fingers] + look / looks * (self._open - start)[self._fingers]
            data.ctrl[self._fingers] = goal
            self.run("open")

    def shake(self, random: np.random.Generator) -> bool:
        """Runs one sequence of random wrenches; returns True if the loop is still in the hand."""
        settings, body = self.world.settings, self.world.body
        most, reach = _looks(settings.seconds), self.judge.reach()
        for look in range(most):
            if look % _looks(settings.hold) == 0:
                force = settings.force * _any_direction(random)
                torque = settings.torque * _any_direction(random)
                self.world.data.xfrc_applied[body] = np.concatenate([force, torque])
            self.run("shake")
            if not self.judge.distance() <= reach:
                break
        self.world.data.xfrc_applied[body] = 0.0
        return look + 1 == most and self.judge.linked() > 0

    @contextmanager
    def dragged(self) -> Iterator[None]:
        """Adds viscous drag to the object: a wrench moves it, but it gathers no momentum."""
        model, settings = self.world.model, self.world.settings
        first = model.body_dofadr[self.world.body]
        model.dof_damping[first : first + 3] = settings.force / settings.drag_speed
        model.dof_damping[first + 3 : first + 6] = settings.torque / settings.drag_turning
        try:
            yield
        finally:
            model.dof_damping[first : first + 6] = 0.0

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Locks the hand: its joints are too heavy to be moved, and come to rest at once."""
        model, data = self.world.model, self.world.data
        data.ctrl[self._fingers] = self.world.positions[self._fingers]
        gears = model.eq_obj1id[model.eq_type == mujoco.mjtEq.mjEQ_JOINT]
        joints = [*model.actuator_trnid[self._fingers, 0], *gears]
        dofs, armature = model.jnt_dofadr[joints], self.world.settings.locked_armature
        kept = model.dof_armature.copy(), model.dof_damping.copy()
        model.dof_armature[dofs] = armature
        model.dof_damping[dofs] = armature / model.opt.timestep
        try:
            yield
        finally:
            model.dof_armature[:], model.dof_damping[:] = kept

    def pull(self, direction_W: Matrix) -> float:
        """A force at the object's centre of mass grows until the loop is out of the hand; how much
        was held [N].

        Up to what is needed it grows so slowly that an object which nothing holds is out of the
        hand before: at a rate r, one of mass m moves by f^3 / (6 m r^2) until the force is f.
        """
        settings, body = self.world.settings, self.world.body
        reach, step = self.judge.reach(), self._steps * self.world.model.opt.timestep
        needed, mass = settings.pull_needed, float(self.world.model.body_mass[body])
        slow = min(settings.pull_rate, float(np.sqrt(needed**3 / (6 * mass * reach))))
        force, most = 0.0, max(settings.pull_most, needed)
        while force < most:
            self.world.data.xfrc_applied[body, :3] = force * direction_W
            self.run("pull")
            if not (self.judge.distance() <= reach and self.judge.linked()):
                break
            force += (slow if force < needed else settings.pull_rate) * step
        self.world.data.xfrc_applied[body] = 0.0
        return min(force, most)

    def trial(
        self, variation: Variation, failures: Sequence[str], measures: dict[str, float]
    ) -> Trial:
        """Returns the trial. What the robot touched after the hand had closed is no failure."""
        touched = self.touched if "hit" in failures else None
        return Trial(variation, tuple(failures), measures, 0.0, touched=touched)

    def save(self) -> Any:
        """Returns the state for `set_back`."""
        model, data = self.world.model, self.world.data
        kind = mujoco.mjtState.mjSTATE_INTEGRATION
        state = np.empty(mujoco.mj_stateSize(model, kind))
        mujoco.mj_getState(model, data, state, kind)
        return state

    def set_back(self, state: Any) -> None:
        """Resets the world to a state."""
        model, data = self.world.model, self.world.data
        mujoco.mj_setState(model, data, state, mujoco.mjtState.mjSTATE_INTEGRATION)
        mujoco.mj_forward(model, data)


def execution_of(plan: Plan, world: World, recorder: Recorder | None) -> Execution:
    """Returns the execution of a solved plan, judged by the fingers that clasp.

    Raises
    ------
    ValueError
        The plan's loop is none of the object's, as in a file whose cloud was changed.
    """
    problem, hand = plan.task.problem, hand_of(plan)
    assert plan.loop is not None
    loops = problem.object.loops.found
    if plan.loop >= len(loops):
        raise ValueError(f"loop {plan.loop} of the plan is not one of the object's {len(loops)}")
    judge = Judge(hand, world, loops[plan.loop].points)
    return Execution(world, judge, hand, problem.robot, recorder)


def _looks(seconds: float) -> int:
    return max(1, round(seconds / LOOK))


def _any_direction(random: np.random.Generator) -> Matrix:
    vector = random.normal(size=3)
    unit: Matrix = vector / np.linalg.norm(vector)
    return unit
