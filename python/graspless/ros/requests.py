# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Jobs for the goals of the actions, from their fields and from what the node knows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..picking import STRATEGIES
from .jobs import PickJob, TaskJob
from .messages import RefusedError, seconds_of
from .robot import robot_fields
from .work import DESCRIPTION

if TYPE_CHECKING:
    from .goals import Goal
    from .senses import Camera, Description, Joints
    from .settings import Settings
    from .transforms import Transforms


class Requests:
    """Makes jobs of goals. Whatever a goal lacks is a RefusedError."""

    def __init__(
        self,
        settings: Settings,
        transforms: Transforms,
        joints: Joints,
        camera: Camera,
        description: Description,
    ) -> None:
        self._settings, self._transforms, self._joints = settings, transforms, joints
        self._camera, self._description = camera, description

    def task_job(self, goal: Goal) -> TaskJob:
        """Returns the job of a goal of PlanTask."""
        asked, s = goal.request, self._settings
        if not np.isfinite(asked.seconds) or asked.seconds < 0:
            raise RefusedError(f"seconds: {asked.seconds}: should be at least 0")
        robot = None
        if DESCRIPTION in asked.task:
            robot = robot_fields(self._description, self._transforms, s)
        return TaskJob(
            asked.task,
            seed=asked.seed or None,
            seconds=asked.seconds or None,
            certify=asked.certify,
            robot=robot,
            measured=self._measured(asked.execute),
            tolerance=s.start_tolerance,
            limits=s.limits | {"rate": s.trajectory_rate},
            squeeze=s.squeeze,
            directory=s.task_directory or None,
        )

    def _measured(self, is_needed: bool) -> dict[str, float] | None:
        """Returns the positions of all joints, those of controllers newly measured; None if they
        are not needed.
        """
        if not is_needed:
            return None
        names = self._settings.joints
        if not names:
            raise RefusedError("execute: the node knows no controllers (parameter controllers)")
        s = self._settings
        q = self._joints.positions(names, s.joint_state_seconds, patience=s.tf_seconds)
        return self._joints.known() | dict(zip(names, q.tolist(), strict=True))

    def pick_job(self, goal: Goal) -> PickJob:
        """Returns the job of a goal of PickObject, with an image that is newer than the goal."""
        asked, s = goal.request, self._settings
        for name in ("lift", "mass", "grip_force", "seconds"):
            if not np.isfinite(getattr(asked, name)) or getattr(asked, name) < 0:
                raise RefusedError(f"{name}: {getattr(asked, name)}: should be at least 0")
        robot = self._robot(asked.robot or s.robot)
        measured = self._measured(asked.execute)
        at = None if asked.name else self._point(asked.at)
        goal.tell("seeing")
        seen = self._camera.look(
            asked.source or "image", goal.began, s.image_seconds, s.tf_seconds, goal.cancel
        )
        return PickJob(
            asked.name,
            robot,
            seen.X_WC,
            seen.depth,
            seen.K,
            seen.points,
            at,
            strategies=tuple(asked.strategies) or STRATEGIES,
            respect=asked.respect or "objects",
            padding=asked.padding,
            obstacles=asked.obstacles,
            lift=asked.lift or 0.1,
            place=asked.place,
            mass=asked.mass or None,
            grip_force=asked.grip_force or None,
            seed=asked.seed or 1,
            seconds=asked.seconds or 10.0,
            measured=measured,
            tolerance=s.start_tolerance,
            limits=s.limits | {"rate": s.trajectory_rate},
            squeeze=s.squeeze,
            directory=s.task_directory or None,
        )

    def _robot(self, name: str) -> dict[str, Any]:
        if name and name != DESCRIPTION:
            return {"urdf": name}
        robot = robot_fields(self._description, self._transforms, self._settings)
        if robot is None:
            raise RefusedError("robot: none was named, and no robot_description was received")
        return robot

    def _point(self, message: Any) -> Any:
        """Returns a point in the world [3]; None if the goal has none."""
        frame = message.header.frame_id
        if not frame:
            return None
        p_F = np.array([message.point.x, message.point.y, message.point.z, 1.0])
        if not np.isfinite(p_F).all():
            raise RefusedError("at: has values that are not finite")
        stamp = seconds_of(message.header.stamp) or None
        s = self._settings
        X_WF = self._transforms.lookup(s.world_frame, frame, stamp, s.tf_seconds)
        return (X_WF @ p_F)[:3]
