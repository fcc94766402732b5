# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""sscbirrt from PyPI as a peer: a CBiRRT between the start and the goal of a pair.

Its path constraint is a task space region of the fingertip: height, pitch and roll as at the start,
as for OMPL's planners.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import numpy as np

from ..ik import peer
from . import ur5e

if TYPE_CHECKING:
    from graspless import slide
    from graspless._core import slide as core
    from graspless.frames import Matrix
    from graspless.planning import Budget

    from .._peers import PairProblem

STEP = 0.05  # longest step of the tree, and spacing of its collision tests [rad]
TOLERANCE = 1e-4  # of the region [m, rad]; ours and OMPL's are tighter
INSET = 0.001  # of the region from the table's edges [m]


def is_installed() -> bool:
    """True if sscbirrt and ssik, which solves its inverse kinematics, are installed."""
    return peer("sscbirrt") is not None and peer("ssik") is not None


class Peer:
    """sscbirrt for one pair.

    Parameters
    ----------
    pair : PairProblem
    problem : slide.Problem
        Of the UR5e.
    is_native : bool
        Search in its C++ core. This has a validator of its own for MuJoCo only, so nothing is
        tested for collision. Otherwise the search runs in Python and calls our validator.
    """

    def __init__(self, pair: PairProblem, problem: slide.Problem, is_native: bool) -> None:
        import sscbirrt
        from sscbirrt.backends.ssik import SSIKSolver
        from sscbirrt.testing import NoCollision

        self.pair, self.problem, self.package = pair, problem, sscbirrt
        self.ik = SSIKSolver(_manipulator(problem))
        self.validator: Any = NoCollision() if is_native else _Validator(pair)
        self.backend = "native" if is_native else "python"

    def run(self, budget: Budget) -> tuple[core.Plan | None, float]:
        """Returns the plan of its path, or None, and the seconds that it took."""
        config = self.package.CBiRRTConfig(
            timeout=budget.seconds,
            max_iterations=10**9,
            step_size=STEP,
            edge_resolution=STEP,
            membership_tolerance=TOLERANCE,
            smooth_path=False,
            shorten_endpoints=False,
        )
        begin = time.perf_counter()
        planner = self.package.CBiRRT(_Arm(self), self.ik, self.validator, config, self.backend)
        found = planner.plan(
            start=self.pair.start,
            goal=self.pair.goal,
            constraint_tsrs=[self._region()],
            seed=int(budget.seed) % 2**31,
            return_details=True,
        )
        seconds = time.perf_counter() - begin
        if not found.success:
            return None, seconds
        return self.pair.completed([np.asarray(q) for q in found.path]), seconds

    def _region(self) -> Any:
        """Task space region of the fingertip: any position over the table, and any yaw.

        Bounds hold for a table that is a rectangle along X and Y of W, as the square one is.
        """
        from tsr import TSR

        X_WF = self.ik.fk(self.pair.start)
        level = np.eye(4)
        level[2, 3] = X_WF[2, 3]
        turned = np.eye(4)
        turned[:3, :3] = X_WF[:3, :3]
        corners = np.asarray(self.problem.support.polygon.vertices)
        low, high = corners.min(axis=0), corners.max(axis=0)
        ends = np.array([self.ik.fk(q)[:2, 3] for q in (self.pair.start, self.pair.goal)])
        room = min(float((ends - low).min()), float((high - ends).min()))
        inset = min(INSET, room / 2)  # a path on the very edge fails its check
        x, y = np.column_stack([low + inset, high - inset])
        none, turn = [0, 0], [-np.pi, np.pi]
        return TSR(T0_w=level, Tw_e=turned, Bw=np.array([x, y, none, none, none, turn]))


class _Arm:
    """Kinematics and limits as sscbirrt asks for them."""

    def __init__(self, given: Peer) -> None:
        robot = given.problem.robot
        joints = robot.group(given.problem.hand.arm)
        self.dof = len(joints)
        self.joint_limits = (np.asarray(robot.lower)[joints], np.asarray(robot.upper)[joints])
        self.forward_kinematics = given.ik.fk


class _Validator:
    """Our validator: the contact of the slide is kept, and nothing collides."""

    def __init__(self, pair: PairProblem) -> None:
        self.is_valid = pair.is_valid


def _manipulator(problem: slide.Problem) -> Any:
    """ssik's solver of the UR5e with the fingertip as its end."""
    import ssik

    robot, q = problem.robot, np.zeros(problem.robot.dof)
    q[robot.dof - 1 :] = np.asarray(robot.state(problem.hand.open))[robot.dof - 1 :]
    frames = [f"l{i}" for i in range(1, len(ur5e.ROWS) + 1)] + [problem.hand.fingertip]
    poses: list[Matrix] = [np.eye(4)] + [np.asarray(robot.pose(frame, q)) for frame in frames]
    steps = [np.linalg.inv(a) @ b for a, b in zip(poses, poses[1:], strict=False)]
    joints = robot.group(problem.hand.arm)
    limits = np.column_stack([np.asarray(robot.lower)[joints], np.asarray(robot.upper)[joints]])
    return ssik.Manipulator.from_transforms(steps, limits=limits)
