# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Jobs of worker processes, and their results, in types that can be pickled."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .measured import TURN

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..frames import Matrix
    from .measured import Joint


@dataclass(frozen=True)
class TaskJob:
    """A task to plan: fields of the action PlanTask, and what the node knows.

    Attributes
    ----------
    text : str
        Task file in YAML.
    seed, seconds : int, float or None
        Instead of those of the task.
    certify : bool
        Prove the plan between its rows, too.
    robot : dict or None
        Field `robot` of the robot that the node knows.
    measured : dict or None
        Measured joints [rad or m], where the task says nothing of them in robot.home.
    tolerance : float
        Distance of measured joints from their limits [rad; of sliding joints 1/10 m].
    limits : dict
        Arguments of `graspless.time`.
    squeeze : float
        How far the hand closes beyond contact: see timing.squeeze.
    directory : str or None
        Folder to which its paths are relative.
    """

    text: str
    seed: int | None = None
    seconds: float | None = None
    certify: bool = False
    robot: dict[str, Any] | None = None
    measured: dict[str, float] | None = None
    tolerance: float = 0.0
    limits: dict[str, Any] = field(default_factory=dict)
    squeeze: float = 0.0
    directory: str | None = None


@dataclass(frozen=True)
class PickJob:
    """An object to pick up, from an image or a cloud.

    Attributes
    ----------
    depth, K, X_WC : array or None
        Depth image [m], camera matrix and pose of the camera.
    points : array [H, W, 3] or None
        A cloud in the frame of the camera, instead of an image.
    name : str
        Name of the object; empty: the object at `at`.
    at : array [3] or None
        Point of the object in the world [m].
    robot : dict
        Field `robot` of a task.
    strategies, respect, padding, lift, mass, grip_force, seed, seconds
        As in `graspless.pick`.
    obstacles, place : str
        As in `graspless.pick`, in YAML; empty: none.
    measured, tolerance, limits, squeeze, directory
        As in TaskJob.
    """

    name: str
    robot: dict[str, Any]
    X_WC: Matrix
    depth: Matrix | None = None
    K: Matrix | None = None
    points: Matrix | None = None
    at: Matrix | None = None
    strategies: tuple[str, ...] = ("pinch", "rim", "slide", "clasp")
    respect: str = "objects"
    padding: float = 0.0
    obstacles: str = ""
    lift: float = 0.1
    place: str = ""
    mass: float | None = None
    grip_force: float | None = None
    seed: int = 1
    seconds: float = 10.0
    measured: dict[str, float] | None = None
    tolerance: float = 0.0
    limits: dict[str, Any] = field(default_factory=dict)
    squeeze: float = 0.0
    directory: str | None = None


@dataclass(frozen=True)
class CheckJob:
    """A plan to check."""

    plan: str
    certify: bool = False


@dataclass
class Found:
    """Result of a job, in types that can be pickled.

    Attributes
    ----------
    status, reason : str
        As in the message Motion.
    warnings : list of str
    plan : str
        Text of the plan file; empty without a plan.
    kind : str
        Kind of the plan.
    joint_names : list of str
        Columns of the arrays.
    joints : dict
        Joint of each name, also of mimic joints, which have no column.
    times, positions, velocities, accelerations, object_poses : array
        As in `graspless.Trajectory`, with the squeeze.
    phases : list of tuple
        Beginning [s] and name of each segment.
    margins : list of tuple
        Name and value.
    faults : list of str
        Result of a check.
    name, strategy : str
        Of a pick.
    attempts : list of tuple
        Strategy, status, reason and seconds.
    objects : list of tuple
        Name and pose [4, 4] of all objects that were seen.
    """

    status: str = "refused"
    reason: str = ""
    warnings: list[str] = field(default_factory=list)
    plan: str = ""
    kind: str = ""
    joint_names: list[str] = field(default_factory=list)
    joints: dict[str, Joint] = field(default_factory=dict)
    times: Any = None
    positions: Any = None
    velocities: Any = None
    accelerations: Any = None
    object_poses: Any = None
    phases: list[tuple[float, str]] = field(default_factory=list)
    margins: list[tuple[str, float]] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)
    name: str = ""
    strategy: str = ""
    attempts: list[tuple[str, str, str, float]] = field(default_factory=list)
    objects: list[tuple[str, Any]] = field(default_factory=list)

    @property
    def is_solved(self) -> bool:
        """True if there is a plan that was checked."""
        return self.status == "solved"

    def with_mimics(self, names: Iterable[str]) -> Found:
        """Returns a trajectory that has the mimic joints among some joints, too."""
        added = [name for name in names if name in self.joints and name not in self.joint_names]
        joints = [self.joints[name] for name in added]
        columns = [self.joint_names.index(joint.driver) for joint in joints]
        factors, offsets = (
            np.array([getattr(j, what) for j in joints]) for what in ("multiplier", "offset")
        )

        def extended(values: Matrix, shift: Any = 0.0) -> Matrix:
            return np.hstack([values, values[:, columns] * factors + shift])

        return replace(
            self,
            joint_names=[*self.joint_names, *added],
            positions=extended(self.positions, offsets),
            velocities=extended(self.velocities),
            accelerations=extended(self.accelerations),
        )

    def turns_to(self, q: Matrix) -> Matrix:
        """Returns the whole turns from its start to measured joints [dof] [rad]."""
        is_continuous = np.array([self.joints[name].is_continuous for name in self.joint_names])
        return np.where(is_continuous, TURN * np.round((q - self.positions[0]) / TURN), 0.0)
