# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Environment that executes a task in MuJoCo with the commands of an agent."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import gymnasium
import numpy as np

from .. import frames, timing
from .._api import plan as plan_task
from .._arguments import require_choice
from ..errors import TaskError, shown
from ..simulation import simulation_kind
from ..simulation.variation import Variation
from ..simulation.variation import draw as draw_variation
from ..timing.trajectory import robot_of
from .draws import DRAWS, PHASES
from .video import Painter

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from .._plan import Plan
    from ..simulation import Trial
    from ..simulation.results import Running

RATE = 50  # actions a second
_BEYOND = 0.1  # of the commands over the limits of a joint, by which servos press [rad or m]
_TURN = 2 * np.pi  # limit of a joint that has none [rad]
_POSE = ("x", "y", "z", "qw", "qx", "qy", "qz")
_LARGEST = 1000.0  # entry of an observation; larger ones are cut off
_ATTEMPTS = 20  # of a reset, until a task has a plan


class PlanEnv(gymnasium.Env[Any, Any]):
    """One random task an episode, in the simulation and with the judge of `graspless.simulate`.

    The episode keeps to the schedule of the planner's plan: its phases, such as press and slide,
    begin when they do in the plan, and the judge asks in each for what the plan promises.

    Parameters
    ----------
    name : str
        Which tasks: SlideToEdge, Tumble, Clasp or Pick.
    varied : bool
        Vary friction, mass and poses in the simulation, as the further trials of `simulate` do. The
        planner does not know of it.
    render_mode : str, optional
        rgb_array: `render` returns pictures. Without a screen, set MUJOCO_GL to egl or osmesa.

    Attributes
    ----------
    plan : Plan
        Plan of this episode; its task is `plan.task`. Before the first reset, that of another task.
    action_low, action_high : array [dof]
        Commands of the servos for the actions -1 and 1 [rad or m].
    names : list of str
        Names of the entries of an observation.
    joint_names : list of str
        Names of the entries of an action.

    Notes
    -----
    An action [dof], each entry from -1 to 1, holds the commands of the joints' servos for 0.02 s.
    An observation has the positions of the joints and their mean velocities since the observation
    before [rad or m, rad/s or m/s], the poses of the object now and at the end of the plan
    (x y z qw qx qy qz, in the world [m]), which phase it is, and the time since the start of the
    phase and of the episode [s]. The reward is 1 for the last action of an episode in which the
    judge found no failure, else 0. The last `info` has `is_success`, `failures` and `measures`, as
    a Trial has them.

    Raises
    ------
    TaskError
        There are no such tasks, or MuJoCo is missing. In `reset`: 20 tasks in a row had no plan.
    """

    metadata = {
        "render_modes": ["rgb_array"],
        "render_fps": RATE,
    }

    def __init__(self, name: str, *, varied: bool = False, render_mode: str | None = None) -> None:
        require_choice("name", name, DRAWS)
        if render_mode not in (None, "rgb_array"):
            raise TaskError(f"render_mode: {render_mode}: should be None or rgb_array")
        self.render_mode = render_mode
        self._painter: Painter | None = None
        self._episode: Running | None = None
        self._trial: Trial | None = None
        self._draw, self._phases, self._varied = DRAWS[name], PHASES[name], varied
        self._prepare(np.random.default_rng(0))
        dof = len(self.joint_names)
        poses = [f"{what}_{x}" for what in ("object", "goal") for x in _POSE]
        rates = [f"{joint}_velocity" for joint in self.joint_names]
        phases = [f"phase_{phase}" for phase in self._phases]
        self.names = [*self.joint_names, *rates, *poses, *phases, "phase_time", "time"]
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (dof,), np.float32)
        shape = (len(self.names),)
        self.observation_space = gymnasium.spaces.Box(-_LARGEST, _LARGEST, shape, np.float32)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Draws a task, plans it and puts the robot at its start; returns observation and info.

        Parameters
        ----------
        seed : int, optional
            Seed of the tasks and variations from here on; otherwise they go on as they are.
        options : dict, optional
            Ignored; Gymnasium asks for it.
        """
        super().reset(seed=seed)
        self._episode = None
        self._prepare(self.np_random)
        variation = Variation()
        kind: Any = simulation_kind(self.plan.kind)
        if self._varied:
            variation = draw_variation(self.np_random, getattr(kind, "SPREAD", None))
        self.close()
        self._episode = kind.start(self.plan, variation)
        self._every = max(1, round(1 / RATE / self._running.model.opt.timestep))
        joints = [self._running.model.joint(name) for name in self.joint_names]
        self._qpos = np.array([joint.qposadr[0] for joint in joints])
        self._rates = np.zeros(len(joints))
        self._goal = frames.to_row(timing.time(self.plan).object_poses[-1])
        self._phase, self._began = next(self._running.steps), 0.0
        self._trial = None
        return self._observation(), {"phase": self._phase}

    def step(
        self, action: ArrayLike
    ) -> tuple[NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Holds an action for 0.02 s; returns observation, reward, if it has ended, and info."""
        if self._trial is not None:
            raise TaskError("step: the episode has ended: should be reset first")
        running = self._running
        began, before = float(running.data.time), running.data.qpos[self._qpos]
        share = (self._checked(action) + 1) / 2
        command = self.action_low + share * (self.action_high - self.action_low)
        for _ in range(self._every):
            running.data.ctrl[:] = command
            try:
                phase = next(running.steps)
            except StopIteration as end:
                self._trial = end.value
                break
            except BaseException:  # after which there are no more steps, as after Ctrl-C
                self._episode = None
                raise
            if phase != self._phase:
                self._phase, self._began = phase, float(running.data.time)
        took = float(running.data.time) - began
        if took > 0:  # the mean: within the step, the joints follow a jump of the command
            self._rates = (running.data.qpos[self._qpos] - before) / took
        has_ended = self._trial is not None
        reward = float(has_ended and bool(self._trial))
        return self._observation(), reward, has_ended, False, self._info()

    def expert(self) -> NDArray[np.float32]:
        """Returns the action of the planner: what its plan commands now."""
        span = self.action_high - self.action_low
        action = 2 * (self._running.data.ctrl - self.action_low) / span - 1
        found: NDArray[np.float32] = np.clip(action, -1.0, 1.0).astype(np.float32)
        return found

    def render(self) -> NDArray[np.uint8]:
        """Returns a picture [192, 256, 3] of the present state."""
        if self.render_mode is None:
            raise TaskError("render: render_mode is None: should be rgb_array")
        if self._painter is None:
            self._painter = Painter(self._running.model)
        return self._painter.paint(self._running.data)

    def close(self) -> None:
        """Frees what rendering needs."""
        if self._painter is not None:
            self._painter.close()
        self._painter = None

    @property
    def _running(self) -> Running:
        if self._episode is None:
            raise TaskError("no episode is running: should be reset first")
        return self._episode

    def _checked(self, action: ArrayLike) -> NDArray[np.float64]:
        """Returns the action [dof], cut off at -1 and 1."""
        shape = self.action_space.shape
        try:
            given = np.asarray(action, dtype=float)
        except (TypeError, ValueError, OverflowError):
            given = np.array(np.nan)
        if given.shape != shape or not np.isfinite(given).all():
            raise TaskError(
                f"action: {shown(action)}: should be an array of shape {shape} "
                "of finite numbers in [-1, 1]"
            )
        cut: NDArray[np.float64] = np.clip(given, -1.0, 1.0)
        return cut

    def _prepare(self, random: np.random.Generator) -> None:
        """Draws tasks until one has a plan."""
        for _ in range(_ATTEMPTS):
            document = self._draw(random)
            plan: Plan = plan_task(document, seed=int(random.integers(2**31)))
            if plan:
                break
        else:
            raise TaskError(f"{_ATTEMPTS} tasks in a row have no plan; the last one: {plan.reason}")
        robot = robot_of(plan)
        assert robot is not None
        self.plan = plan
        self.joint_names = list(robot.joint_names)
        self.action_low = np.maximum(robot.lower, -_TURN) - _BEYOND
        self.action_high = np.minimum(robot.upper, _TURN) + _BEYOND

    def _observation(self) -> NDArray[np.float32]:
        data = self._running.data
        pose = frames.to_row(self._running.object_pose())
        now = float(data.time)
        phase = [float(name == self._phase) for name in self._phases]
        rest = [*pose, *self._goal, *phase, now - self._began, now]
        joints = np.concatenate([data.qpos[self._qpos], self._rates])
        whole = np.concatenate([joints, rest])
        seen: NDArray[np.float32] = np.clip(whole, -_LARGEST, _LARGEST).astype(np.float32)
        return seen

    def _info(self) -> dict[str, Any]:
        if self._trial is None:
            return {"phase": self._phase}
        return {
            "phase": self._phase,
            "is_success": bool(self._trial),
            "failures": self._trial.failures,
            "measures": self._trial.measures,
        }
