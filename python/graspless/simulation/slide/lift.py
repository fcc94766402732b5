# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The straight lift, which no plan contains: as high as the arm can without touching itself.

Nor does it touch the support or an obstacle. They are those that the plan knows, whatever stands in
the world of a trial; and the engine tells what touches, not the planner's collision test.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from ... import frames, robot
from ..robots import set_positions
from ..variation import Variation
from .scene import OBJECT, build_scene

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...slide import Plan

_WAYPOINTS = 21
_JUMP = 0.3  # a joint that moves by more between them has left its branch [rad or m]
_TURNS = (0.0, 0.05, -0.05, 0.1, -0.1)  # of the hand between them, tried in turn [rad]
_RESOLUTION = 0.01  # of the tests between them [rad or m]
_FAR = 1000.0  # where nothing touches the object [m]


def straight_lift(plan: Plan, q: Matrix, height: float) -> tuple[Matrix, float]:
    """Returns the path [N, dof] that lifts the hand straight up from q, and the height reached [m].

    The hand turns about the vertical only if it cannot rise otherwise.
    """
    problem = plan.task.problem
    hand = problem.hand
    ik = robot.Ik(problem.robot, hand.grasp_frame, hand.arm)
    known = _Known(plan, q)
    X_WH = np.array(problem.robot.pose(hand.grasp_frame, q))
    steps = np.linspace(0, height, _WAYPOINTS)
    path, yaw = [q], 0.0
    for up in steps[1:]:
        for turn in _TURNS:
            found = ik.solve_near(_raised(X_WH, up, yaw + turn), path[-1])
            if found is None or not np.abs(found - path[-1]).max() < _JUMP:
                continue
            if known.is_free(path[-1], found):
                path.append(np.array(found))
                yaw += turn
                break
        else:
            break
    raised = float(steps[len(path) - 1])
    return np.array(path if len(path) > 1 else [q, q]), raised


class _Known:
    """The world of a plan without the object, whose robot may touch what it touches at q [dof]."""

    def __init__(self, plan: Plan, q: Matrix) -> None:
        self._robot = plan.task.problem.robot
        self._model = build_scene(plan, Variation()).model
        self._data = mujoco.MjData(self._model)
        self._data.joint(OBJECT).qpos[2] = _FAR
        self._allowed = self._touching(q)

    def is_free(self, q1: Matrix, q2: Matrix) -> bool:
        """Returns True if the robot touches nothing more on the straight way from q1 to q2."""
        way = np.linspace(q1, q2, 2 + int(np.abs(q2 - q1).max() / _RESOLUTION))[1:]
        return all(self._touching(q) <= self._allowed for q in way)

    def _touching(self, q: Matrix) -> set[tuple[int, int]]:
        """Returns the pairs of bodies that touch."""
        set_positions(self._model, self._data, self._robot, q)
        contact = self._data.contact
        return {
            (int(a), int(b)) for a, b in self._model.geom_bodyid[contact.geom[contact.dist < 0]]
        }


def _raised(X_WH: Matrix, up: float, yaw: float) -> Matrix:
    """Returns a pose of the hand, lifted [m] and turned about its vertical axis [rad]."""
    X_WR = frames.planar(0.0, 0.0, yaw) @ X_WH
    X_WR[:3, 3] = X_WH[:3, 3] + [0.0, 0.0, up]
    return X_WR
