# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution by the controllers of the robot: FollowJointTrajectory, one goal for each."""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from control_msgs.action import FollowJointTrajectory
from rclpy.action import ActionClient

from ..errors import explain
from .halting import HaltedError, Timer, positions
from .messages import RefusedError, time_of, trajectory_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..frames import Matrix
    from .halting import Clock
    from .jobs import Found
    from .senses import Joints
    from .settings import Controller, Settings
    from .workers import Alarm

_LOOK, _MOVES = 0.01, 1e-6  # between looks [s]; least motion of a joint that moves [rad or m]
_ERRORS = {
    -1: "invalid goal",
    -2: "invalid joints",
    -3: "its time is over",
    -4: "left the path's tolerance",
    -5: "missed the goal's tolerance",
}
SUCCEEDED = 4  # action_msgs/GoalStatus


@dataclass(frozen=True)
class Part:
    """The joints of one controller in a trajectory.

    Attributes
    ----------
    controller : Controller
    columns : list of int or None
        For each of its joints the column of the trajectory; None where it has none.
    """

    controller: Controller
    columns: list[int | None]


def parts_of(found: Found, controllers: Sequence[Controller]) -> list[Part]:
    """Returns the parts of a trajectory; without controllers one with all joints."""
    column = {name: k for k, name in enumerate(found.joint_names)}
    parts = [Part(each, [column.get(joint) for joint in each.joints]) for each in controllers]
    return [part for part in parts if any(k is not None for k in part.columns)]


def require_moved(found: Found, parts: Sequence[Part]) -> None:
    """Raises RefusedError unless each joint that moves has a controller."""
    moved = {k for part in parts for k in part.columns if k is not None}
    ranges = np.ptp(found.positions, axis=0)
    lost = [
        name for k, name in enumerate(found.joint_names) if k not in moved and ranges[k] > _MOVES
    ]
    if lost:
        raise RefusedError(f"no controller moves {', '.join(lost)} (parameter controllers)")


def turns_at_start(found: Found, joints: Joints, settings: Settings) -> Matrix:
    """Returns the whole turns from the start of a trajectory to the robot [dof] [rad].

    Raises RefusedError unless the robot is known to be where the trajectory starts.
    """
    q = joints.positions(found.joint_names, settings.joint_state_seconds)
    turns = found.turns_to(q)
    start = found.positions[0] + turns
    off = np.abs(q - start) * [found.joints[name].weight for name in found.joint_names]
    k = int(np.argmax(off))
    if off[k] > settings.start_tolerance:
        raise RefusedError(
            f"the robot is not at the start: {found.joint_names[k]} is {q[k]:.3f} and should be "
            f"{start[k]:.3f} (start_tolerance {settings.start_tolerance:g})"
        )
    return turns


def message_of(part: Part, found: Found, joints: Joints, settings: Settings) -> Any:
    """Returns the JointTrajectory of a part; joints that have no motion are held where they are."""
    names = part.controller.joints
    held = [name for name, k in zip(names, part.columns, strict=True) if k is None]
    places = dict(
        zip(held, joints.positions(held, settings.joint_state_seconds), strict=True) if held else ()
    )

    def taken(values: Matrix, is_position: bool) -> Matrix:
        rows = np.zeros((len(values), len(names)))
        for i, (name, k) in enumerate(zip(names, part.columns, strict=True)):
            rows[:, i] = values[:, k] if k is not None else places[name] if is_position else 0.0
        return rows

    return trajectory_of(
        names,
        found.times,
        taken(found.positions, True),
        taken(found.velocities, False),
        taken(found.accelerations, False),
    )


class _Order:
    """A trajectory that was sent to one controller."""

    def __init__(self, client: Any, name: str, message: Any) -> None:
        self.name = name
        self.handle: Any = None
        self.answer: Any = None  # its result
        self.fault = ""
        self._lock = threading.Lock()
        self._is_unwanted = False
        goal = FollowJointTrajectory.Goal(trajectory=message)
        client.send_goal_async(goal).add_done_callback(self._accepted)

    def _accepted(self, future: Any) -> None:
        try:
            handle = future.result()
        except Exception as error:
            self.fault = f"{self.name}: {error}"
            return
        if not handle.accepted:
            self.fault = f"{self.name} rejected its trajectory"
            return
        with self._lock:
            self.handle = handle
            if self._is_unwanted:
                handle.cancel_goal_async()
        handle.get_result_async().add_done_callback(self._ended)

    def _ended(self, future: Any) -> None:
        try:
            answer = future.result()
        except Exception as error:
            self.fault = f"{self.name}: {error}"
            return
        code = int(answer.result.error_code)
        if answer.status != SUCCEEDED or code != 0:
            what = answer.result.error_string or _ERRORS.get(code, f"status {answer.status}")
            self.fault = f"{self.name} did not finish: {what}"
        self.answer = answer

    def cancel(self) -> None:
        """Cancels it now, or as soon as it is accepted."""
        with self._lock:
            self._is_unwanted = True
            if self.handle is not None and self.answer is None:
                self.handle.cancel_goal_async()

    @property
    def is_over(self) -> bool:
        """True if it was rejected or has ended."""
        return self.answer is not None or (bool(self.fault) and self.handle is None)


class Controllers:
    """The controllers of the robot, of which one goal at a time may ask for motion.

    Parameters
    ----------
    node : rclpy.node.Node
    settings : Settings
    joints : Joints
    clock : Clock
    """

    def __init__(self, node: Any, settings: Settings, joints: Joints, clock: Clock) -> None:
        self._settings, self._joints, self._clock = settings, joints, clock
        self._clients = {
            each.name: ActionClient(node, FollowJointTrajectory, each.action)
            for each in settings.controllers
            if each.action
        }
        self._parts: list[Part] = []

    def destroy(self) -> None:
        """Destroys the action clients."""
        for client in self._clients.values():
            client.destroy()

    def absent(self) -> list[str]:
        """Returns the names of controllers whose action nobody serves."""
        return [name for name, client in self._clients.items() if not client.server_is_ready()]

    def execute(self, found: Found, cancel: Alarm, tell: Callable[[str], object]) -> None:
        """Has a trajectory followed by all controllers at the same time.

        Raises
        ------
        RefusedError
            The state of the robot is not known, or it is elsewhere; nothing was moved.
        HaltedError
            A controller failed, the goal was cancelled, or the state of the robot was lost.
        """
        found = found.with_mimics(self._settings.joints)
        parts = parts_of(found, self._settings.controllers)
        self._require_ready(found, parts)
        turns = turns_at_start(found, self._joints, self._settings)
        found = replace(found, positions=found.positions + turns)
        timer = Timer(self._clock)
        messages = [message_of(part, found, self._joints, self._settings) for part in parts]
        orders: list[_Order] = []
        try:
            for part, message in zip(parts, messages, strict=True):
                message.header.stamp = time_of(timer.start + self._settings.start_seconds)
                name = part.controller.name
                orders.append(_Order(self._clients[name], name, message))
            self._await_acceptance(orders, cancel)
            self._watch(orders, found, timer, cancel, tell)
        except Exception as error:
            left = self._withdraw(orders)
            status = error.status if isinstance(error, HaltedError) else "stopped"
            is_ours = isinstance(error, (HaltedError, RefusedError))
            reason = str(error) if is_ours else explain(error)
            raise HaltedError(status, f"{reason}{left}") from error
        except BaseException:
            self._withdraw(orders)
            raise

    def _require_ready(self, found: Found, parts: list[Part]) -> None:
        if not parts:
            raise RefusedError("no controller moves any joint of the plan (parameter controllers)")
        require_moved(found, parts)
        for part in parts:
            client = self._clients.get(part.controller.name)
            if client is None:
                raise RefusedError(f"parameter {part.controller.name}.action is empty")
            if not client.wait_for_server(self._settings.controller_seconds):
                raise RefusedError(f"nobody serves {part.controller.action}")

    def _await_acceptance(self, orders: list[_Order], cancel: Alarm) -> None:
        end = time.monotonic() + self._settings.controller_seconds
        while any(order.handle is None for order in orders):
            self._raise_faults(orders, cancel)
            if time.monotonic() > end:
                silent = [order.name for order in orders if order.handle is None]
                raise HaltedError("controller_failed", f"{', '.join(silent)} did not answer")
            cancel.wait(_LOOK)

    def _watch(
        self,
        orders: list[_Order],
        found: Found,
        timer: Timer,
        cancel: Alarm,
        tell: Callable[[str], object],
    ) -> None:
        phase = ""
        deadline = float(found.times[-1]) + self._settings.overtime_seconds
        while not all(order.is_over for order in orders):
            self._raise_faults(orders, cancel)
            elapsed = timer.elapsed() - self._settings.start_seconds
            if elapsed > deadline:
                raise HaltedError(
                    "stopped", f"the trajectory is not done {elapsed:.1f} s after start"
                )
            positions(self._joints, found.joint_names, self._settings.joint_state_seconds, timer)
            gone = [order.name for order in orders if order.name in self.absent()]
            if gone:
                raise HaltedError("controller_failed", f"{', '.join(gone)} is gone")
            names = [name for begin, name in found.phases if begin <= max(elapsed, 0.0)]
            if names and names[-1] != phase:
                phase = names[-1]
                tell(phase)
            cancel.wait(_LOOK)
        self._raise_faults(orders, cancel)

    def _raise_faults(self, orders: list[_Order], cancel: Alarm) -> None:
        faults = [order.fault for order in orders if order.fault]
        if faults:
            raise HaltedError("controller_failed", "; ".join(faults))
        if cancel.has_rung:
            raise HaltedError("canceled", "canceled during the execution")

    def _withdraw(self, orders: list[_Order]) -> str:
        """Cancels what is under way; returns a remark if that was not confirmed."""
        for order in orders:
            order.cancel()
        end = time.monotonic() + self._settings.controller_seconds
        while time.monotonic() < end and not all(order.is_over for order in orders):
            time.sleep(_LOOK)
        left = [order.name for order in orders if not order.is_over]
        return f"; {', '.join(left)} did not confirm that it stopped" if left else ""
