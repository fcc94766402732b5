# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Action servers that never block their executor: each goal waits for its end."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.action import ActionServer, CancelResponse
from rclpy.qos import QoSProfile

from ..errors import explain
from .goals import Ending, Goal
from .results import Kept

if TYPE_CHECKING:
    from collections.abc import Callable

_MANY = QoSProfile(depth=100)  # by default the eleventh request at once is lost
_KEPT = 10  # time of the node for which the result of a goal can be asked for [s]
WHOLE = 2_000_000  # results that are kept with their motions, as messages [bytes]


class Server:
    """An action server whose goals are served by a Desk.

    Parameters
    ----------
    node : rclpy.node.Node
    action : type
        Type of the action.
    name : str
        Its name.
    begin, cancel : callable
        Given each goal that is accepted, which somebody has to end; and each that is cancelled.
    result : callable
        Returns the result of an ending.
    """

    def __init__(
        self,
        node: Any,
        action: Any,
        name: str,
        begin: Callable[[Goal], None],
        cancel: Callable[[Goal], None],
        result: Callable[[Ending], Any],
    ) -> None:
        self._node, self._action = node, action
        self._begin, self._withdraw, self._result = begin, cancel, result
        self._goals: dict[bytes, Goal] = {}
        self._kept = Kept(WHOLE)
        self.server: Any = ActionServer(
            node,
            action,
            name,
            self._execute,
            cancel_callback=self._cancel,
            goal_service_qos_profile=_MANY,
            result_service_qos_profile=_MANY,
            cancel_service_qos_profile=_MANY,
            result_timeout=_KEPT,
        )

    def destroy(self) -> None:
        """Destroys the action server."""
        self.server.destroy()

    @property
    def is_idle(self) -> bool:
        """True if each goal has its result."""
        return not self._goals

    async def _execute(self, handle: Any) -> Any:
        key = bytes(handle.goal_id.uuid)
        goal = Goal(handle, self._node.seconds(), self._tell)
        goal.wakes = self._node.wake
        self._goals[key] = goal
        try:
            self._begin(goal)
            if handle.is_cancel_requested:
                self._withdraw(goal)
        except Exception as error:
            goal.end(Ending("refused", explain(error)))
        ending: Ending = await goal.future
        del self._goals[key]
        result = self._result(ending)
        self._kept.add(result.motion)  # rclpy keeps it
        if ending.is_success:
            handle.succeed()
        elif handle.is_cancel_requested:
            handle.canceled()
        else:
            handle.abort()
        return result

    def _cancel(self, handle: Any) -> Any:
        goal = self._goals.get(bytes(handle.goal_id.uuid))
        if goal is not None:
            self._withdraw(goal)
        return CancelResponse.ACCEPT

    def _tell(self, goal: Goal, phase: str) -> None:
        feedback = self._action.Feedback(phase=phase, seconds=goal.seconds)
        goal.handle.publish_feedback(feedback)
