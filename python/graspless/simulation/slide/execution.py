# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution of a slide or a pinch: the model step by step, its phases, and what is measured."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames, limits, timing
from ..results import Recording, Trial
from ..robots import joint_addresses, lags, set_positions
from .fingers import PAD, SLIDING, WRIST, wrist_stiffness
from .judge import Judge
from .kick import Kick
from .program import HOLD, RAISE, REST, SQUEEZE, make_program
from .scene import FINGER_GRASPS, FINGER_SLIDES, Scene, build_scene

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from ...frames import Matrix
    from ...slide import Plan
    from ..settings import Slide
    from ..variation import Variation
    from .fingers import Bits
    from .program import Command, Controller
    from .truth import Truth

_STILL = 0.01  # of an object at rest: by so much it may move [m] or turn [rad] during the hold
_STOPPED = 1e-6  # speed of joints [rad/s or m/s]
_LOOK = 0.01  # between observations of the judge [s]
_RECORD = 50.0  # moments a second
_NEVER = -1.0  # a contact margin that disables contact [m]
_ALWAYS = 0.0  # MuJoCo's default margin [m]


class Execution:
    """A running model and its observations.

    `control` makes the controller of a time step; by default the fixed program of the plan. `truth`
    is simulated in place of the object and the obstacles of the plan; `standing` is the obstacle on
    which the object is put, and `later` a slide after that.
    """

    def __init__(
        self,
        plan: Plan,
        variation: Variation,
        settings: Slide,
        obstacles: Sequence[Any] | None = None,
        control: Callable[[float], Controller] | None = None,
        truth: Truth | None = None,
        standing: str | None = None,
        later: Plan | None = None,
    ) -> None:
        self.plan, self.variation, self.settings = plan, variation, settings
        self.scene: Scene = build_scene(
            plan, variation, settings, obstacles, truth, standing, later
        )
        model = self.scene.model
        self.data = mujoco.MjData(model)
        self.timestep = float(model.opt.timestep)
        self.controller: Controller
        if control is None:
            self.controller = make_program(plan, timing.time(plan), self.timestep, settings)
        else:
            self.controller = control(self.timestep)
        self.every = max(1, round(_LOOK / self.timestep))
        self.judge = Judge(self.scene, self.every * self.timestep, settings)
        self.measures: dict[str, float] = {} if truth is None else {"lifted": 0.0}
        # A wrist that yields trails behind, and catches up while the finger lifts.
        yields = wrist_stiffness(plan.task.problem.hand, settings) is not None
        following = "reach" if plan.task.problem.X_WO_end is None else REST
        self._slid_after = ("lift", following) if yields else ("slide", "lift")
        self._slid: Any = None  # the pose of the object after the slide
        self._kick = Kick(variation)
        self._comes = self._presses = False
        self._lags = lags(plan.task.problem.robot)
        self._addresses = joint_addresses(model, plan.task.problem.robot)
        self._rows: list[tuple[float, Matrix, Matrix, str]] | None = None
        set_positions(model, self.data, plan.task.problem.robot, self.controller.start)
        if not any(segment.name == "slide" for segment in plan.segments):
            self._let_finger_grasp()

    def record(self) -> None:
        """Starts the recording."""
        self._rows = []

    def trial(self, seconds: float = 0.0) -> Trial:
        """Returns the trial, of so many seconds of computation, with its recording if any."""
        film = None if self._rows is None else Recording.of_arm(self._rows)
        failures, touched = tuple(self.judge.failures), self.judge.touched
        return Trial(self.variation, failures, self.measures, seconds, film, touched)

    def positions(self) -> Matrix:
        """Returns the actual joint positions [dof]."""
        q: Matrix = self.data.qpos[self._addresses].copy()
        return q

    def object_pose(self) -> Matrix:
        """Returns the actual pose X_WO [4, 4]."""
        return self.judge.pose(self.data)

    def run(self, until: str = HOLD) -> None:
        """Runs to the end of a phase, or until the object has fallen."""
        for _ in self.steps(until):
            pass

    def steps(self, until: str = HOLD) -> Iterator[str]:
        """Does the same; yields the phase before each step, when the commands are in data.ctrl."""
        skip = max(1, round(1 / (_RECORD * self.timestep)))
        phase = ""
        for step in itertools.count():
            command = self.controller.command(step, self)
            following = "" if command is None else command.phase
            if phase not in ("", following):
                self._end_of(phase, following)
                if phase == until:
                    return
            if command is None:
                return
            phase = following
            self._command(command)
            yield phase
            limits.poll()
            mujoco.mj_step(self.scene.model, self.data)
            if step % self.every == 0:
                self.judge.look(self.data, phase)
                if self.judge.is_over:
                    return
                if phase == "slide":
                    self._kick.watch(self.scene, self.data, self.controller.X_WO_goal)
            if self._rows is not None and step % skip == 0:
                self._rows.append((self.data.time, self.positions(), self.object_pose(), phase))

    def _command(self, command: Command) -> None:
        self.data.ctrl[:] = command.position + self._lags * command.velocity
        self._press(command)

    def _press(self, command: Command) -> None:
        """Presses a finger that holds a force onto the object, from their contact to the lift.

        Where it has not touched when the arm stops, it moves down until it does. The spring of the
        wrist holds it across the force, not along it.
        """
        problem = self.plan.task.problem
        if problem.hand.finger_model == "rigid_guarded":
            data, up = self.data, np.array(problem.support.normal_W)
            force = 0.0
            if command.phase == "press":
                is_moving = bool(np.any(np.abs(command.velocity) > _STOPPED))
                has_come = self._comes and not is_moving
                self._comes = self._comes or is_moving
                self._presses = self._presses or has_come or self.judge.tip_force(data) > 0
            else:
                self._comes, self._presses = False, command.phase == "slide"
            if self._presses:
                joints = [data.joint(f"{WRIST}{axis}") for axis in "xyz"]
                given_way = sum(float(joint.qpos[0]) * joint.xaxis for joint in joints) @ up
                force = problem.hand.press_force - self.settings.guarded_stiffness * given_way
            data.xfrc_applied[self.scene.model.body(SLIDING).id][:3] = -force * up

    def _end_of(self, phase: str, following: str) -> None:
        if (phase, following) == self._slid_after:
            self._measure_slide()
        if phase == "lift":
            self._let_finger_grasp()
        elif phase == "close":
            if self._slid is None:  # the plan has no slide
                self._measure_slide()
            X_WO = self.judge.pose(self.data)
            self.measures["shift_by_lift"] = float(np.linalg.norm((X_WO - self._slid)[:3, 3]))
        elif phase == SQUEEZE:
            self._held = self._in_hand()
            self._low = float(self.data.xpos[self.scene.model.body("object").id][2])
            if not self.judge.holds(self.data):
                self.judge.note("not_grasped")
        elif phase == REST:
            self._measure_rested()
        elif phase in (RAISE, HOLD):
            self._measure_lift(phase)
            if "lifted" in self.measures:
                self._measure_rest(phase)

    def _measure_rested(self) -> None:
        """Looks where the object lies at the end, after the finger has left it."""
        self._note_off_target(*self._off_goal(self.judge.pose(self.data)))

    def _off_goal(self, X_WO: Matrix) -> tuple[float, float]:
        """Returns the distance [m] and the angle [rad] of a pose from the goal."""
        goal = self._goal()
        return float(np.linalg.norm((X_WO - goal)[:3, 3])), frames.angle(goal, X_WO)

    def _measure_slide(self) -> None:
        X_WO = self._slid = self.judge.pose(self.data)
        position, angle = self._off_goal(X_WO)
        forces = self.judge.forces or [0.0]
        self.measures |= {
            "position_error": position,
            "angle_error": angle,
            "overhang": overhang(self.plan, X_WO),
            "mean_force": float(np.mean(forces)),
            "max_force": float(np.max(forces)),
        }
        self.judge.withdraw("off_target")  # of a slide that was repeated
        self._note_off_target(position, angle)

    def _note_off_target(self, position: float, angle: float) -> None:
        nominal, varied = self.settings.off_target, self.settings.off_target_varied
        allowed = nominal if self.variation.is_nominal else varied
        if not (position <= allowed[0] and angle <= allowed[1]):  # nor where it is not a number
            self.judge.note("off_target")

    def _goal(self) -> Matrix:
        """Returns the pose that the object should have, on the support where it is."""
        up: Matrix = self.plan.task.problem.support.normal_W
        X_WO: Matrix = frames.translation(self.variation.table * up) @ self.controller.X_WO_goal
        return X_WO

    def _let_finger_grasp(self) -> None:
        """Lets the sliding finger touch with its own shapes from now on, as in the plan."""
        self._set_finger(FINGER_GRASPS, _NEVER)

    def _let_finger_slide(self) -> None:
        """Lets the sliding finger touch the object with its pad alone again."""
        self._set_finger(FINGER_SLIDES, _ALWAYS)

    def _set_finger(self, bits: Bits, pad_margin: float) -> None:
        model, groups = self.scene.model, self.scene.groups
        model.geom_contype[groups[SLIDING]] = bits.contype
        model.geom_conaffinity[groups[SLIDING]] = bits.conaffinity
        body = model.body(SLIDING).id
        model.body_contype[body] |= bits.contype
        model.body_conaffinity[body] |= bits.conaffinity
        of_pad = np.isin(model.pair_geom1, groups[PAD]) | np.isin(model.pair_geom2, groups[PAD])
        model.pair_margin[of_pad] = pad_margin

    def _in_hand(self) -> Matrix:
        body = self.data.body(self.plan.task.problem.hand.grasp_frame)
        R_WH = body.xmat.reshape(3, 3)
        p_HO: Matrix = R_WH.T @ (self.judge.pose(self.data)[:3, 3] - body.xpos)
        return p_HO

    def _measure_rest(self, phase: str) -> None:
        X_WO = self.judge.pose(self.data)
        if phase == RAISE:
            self._raised = X_WO
        elif self.judge.holds_clear(self.data):
            self.measures["lifted"] = float(np.abs(X_WO - self._raised)[:3].max() <= _STILL)

    def _measure_lift(self, phase: str) -> None:
        lifted = float(self.data.xpos[self.scene.model.body("object").id][2]) - self._low
        creep = float(np.linalg.norm(self._in_hand() - self._held))
        reach = self.controller.raised
        self.measures |= {"lift_height": lifted, "lift_reach": reach, "creep": creep}
        if "not_grasped" in self.judge.failures:
            return
        if not (self.judge.holds(self.data) and creep <= self.settings.kept):
            self.judge.note("not_grasped" if lifted < self.settings.kept else "dropped")
        elif not lifted + self._sag() >= self.settings.kept_height:
            can = self.controller.raised >= self.settings.kept_height
            self.judge.note("dropped" if can else "out_of_reach")

    def _sag(self) -> float:
        """Returns how far a lifted object stretches the spring of the wrist [m]."""
        stiffness = wrist_stiffness(self.plan.task.problem.hand, self.settings)
        if stiffness is None or not self.judge.holds_clear(self.data):
            return 0.0
        model = self.scene.model
        return float(model.body("object").mass[0] * np.linalg.norm(model.opt.gravity) / stiffness)


def overhang(plan: Plan, X_WO: Matrix) -> float:
    """Returns the distance by which the outline of an object is outside the support, or 0 [m]."""
    support, thing = plan.task.problem.support, plan.task.problem.object
    X_SO = np.linalg.inv(support.X_WS) @ X_WO
    corners = np.array(thing.outline.vertices) @ X_SO[:2, :2].T + X_SO[:2, 3]
    return max(0.0, max(-float(support.polygon.depth(corner)) for corner in corners))
