# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Senses of the node: joint states, images, clouds, poses of the object, the robot's description.

Everything is checked when it is asked for. What cannot be trusted is a RefusedError.
"""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .messages import (
    RefusedError,
    camera_matrix_of,
    depth_of,
    is_rectified,
    matrix_of,
    points_of,
    seconds_of,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..frames import Matrix
    from .transforms import Transforms
    from .workers import Alarm

_LOOK = 0.01  # between looks whether a goal was cancelled [s]
_FUTURE = 0.5  # of a stamp that clocks of two computers may differ by [s]
_CATCH_UP = 0.1  # that a message of the clock may come after a state [s]


class _AheadError(RefusedError):
    """A joint state from the future."""


class Joints:
    """The newest state of each joint. Safe for use by several threads.

    Parameters
    ----------
    now : callable
        Returns the time of the node [s].
    """

    def __init__(self, now: Callable[[], float]) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._known: dict[str, tuple[float, float]] = {}  # stamp, position
        self.out_of_order = 0

    def hear(self, message: Any) -> None:
        """Takes a JointState. One that is older than the last is counted, and ignored.

        A state from the future hides none: it came late, from before a jump of time.
        """
        now = self._now()
        stamp = seconds_of(message.header.stamp) or now
        with self._lock:
            for name, position in zip(message.name, message.position, strict=False):
                last = self._known.get(name, (stamp, 0.0))[0]
                if stamp < last <= now + _FUTURE:
                    self.out_of_order += 1
                    continue
                self._known[name] = (stamp, float(position))

    def forget(self) -> None:
        """Forgets all: time has jumped back."""
        with self._lock:
            self._known.clear()

    def positions(self, names: Sequence[str], oldest: float, patience: float = 0.0) -> Matrix:
        """Returns the positions of joints [rad or m].

        Waits up to `patience` [s] for states that have not come yet, and a moment for a clock that
        is behind them.

        Raises
        ------
        RefusedError
            One was never heard, is older than `oldest` [s], from the future, or not finite.
        """
        began = time.monotonic()
        while True:
            try:
                return self._positions(names, oldest)
            except RefusedError as error:
                least = _CATCH_UP if isinstance(error, _AheadError) else 0.0
                if time.monotonic() - began >= max(patience, least):
                    raise
                time.sleep(_LOOK)

    def _positions(self, names: Sequence[str], oldest: float) -> Matrix:
        now = self._now()
        with self._lock:
            known = {name: self._known.get(name) for name in names}
        missing = [name for name, state in known.items() if state is None]
        if missing:
            raise RefusedError(f"no joint state was heard of {', '.join(missing)}")
        found = np.array([state[1] for state in known.values() if state is not None])
        for name, state in known.items():
            assert state is not None
            age = now - state[0]
            if age > oldest:
                raise RefusedError(f"the state of {name} is {age:.2f} s old (joint_state_seconds)")
            if age < -_FUTURE:
                raise _AheadError(f"the state of {name} is {-age:.2f} s ahead of the clock")
            if not np.isfinite(state[1]):
                raise RefusedError(f"the state of {name} is {state[1]}")
        return found

    def known(self) -> dict[str, float]:
        """Returns the newest positions of all joints, however old [rad or m]."""
        with self._lock:
            return {name: q for name, (_, q) in self._known.items() if np.isfinite(q)}

    def age(self) -> float | None:
        """Returns the age of the oldest joint state [s]; None without any."""
        with self._lock:
            if not self._known:
                return None
            return self._now() - min(stamp for stamp, _ in self._known.values())


@dataclass(frozen=True)
class Seen:
    """A depth image or a cloud, with the pose of its camera.

    Attributes
    ----------
    X_WC : array [4, 4]
    depth, K : array or None
        Depth image [H, W] [m] and camera matrix.
    points : array [H, W, 3] or None
        Cloud in the frame of the camera [m].
    """

    X_WC: Matrix
    depth: Matrix | None = None
    K: Matrix | None = None
    points: Matrix | None = None


class Camera:
    """The newest depth image, camera info and cloud. Safe for use by several threads.

    Parameters
    ----------
    transforms : Transforms
    world : str
        Frame of the poses of the camera.
    topic : str
        Name of the topic of images. It says whether they are rectified.
    """

    def __init__(self, transforms: Transforms, world: str, topic: str) -> None:
        self._transforms, self._world = transforms, world
        self._is_rectified = is_rectified(topic)
        self._lock = threading.Condition()
        self._newest: dict[str, Any] = {}

    def hear(self, what: str, message: Any) -> None:
        """Takes a message: what is image, info or cloud."""
        with self._lock:
            self._newest[what] = message
            self._lock.notify_all()

    def forget(self) -> None:
        """Forgets all: time has jumped back."""
        with self._lock:
            self._newest.clear()

    def age(self, now: float) -> float | None:
        """Returns the age of the newest image [s]; None without any."""
        with self._lock:
            message = self._newest.get("image")
        return None if message is None else now - seconds_of(message.header.stamp)

    def look(
        self, source: str, since: float, seconds: float, patience: float, cancel: Alarm
    ) -> Seen:
        """Waits for an image or a cloud that was taken since a time.

        Parameters
        ----------
        source : str
            image or cloud.
        since : float
            Time of the node [s].
        seconds : float
            Longest time to wait [s].
        patience : float
            Longest time to wait for its transform [s].
        cancel : Alarm
            Ends the waiting.
        """
        message, info = self._await(source, since, seconds, cancel)
        frame, stamp = message.header.frame_id, seconds_of(message.header.stamp)
        if source == "cloud":
            found: dict[str, Any] = {"points": points_of(message)}
        else:
            K = camera_matrix_of(info, message, self._is_rectified)
            found = {"depth": depth_of(message), "K": K}
        return Seen(self._transforms.lookup(self._world, frame, stamp, patience), **found)

    def _await(self, source: str, since: float, seconds: float, cancel: Alarm) -> tuple[Any, Any]:
        if source not in ("image", "cloud"):
            raise RefusedError(f"source: {source}: should be image or cloud")
        end = time.monotonic() + seconds
        with self._lock:
            while True:
                message, info = self._newest.get(source), self._newest.get("info")
                is_new = message is not None and seconds_of(message.header.stamp) >= since
                if is_new and (source == "cloud" or info is not None):
                    return message, info
                if time.monotonic() >= end or cancel.has_rung:
                    break
                self._lock.wait(_LOOK)
        what = "depth image" if source == "image" else "point cloud"
        if message is None:
            raise RefusedError(f"no {what} came within {seconds:g} s")
        if not is_new:
            age = since - seconds_of(message.header.stamp)
            raise RefusedError(f"no {what} came within {seconds:g} s; the last is {age:.1f} s old")
        raise RefusedError("the depth image came without its camera info")


class ObjectPose:
    """The newest measured pose of the object, each given once."""

    def __init__(self, transforms: Transforms, world: str, now: Callable[[], float]) -> None:
        self._transforms, self._world, self._now = transforms, world, now
        self._lock = threading.Lock()
        self._newest: Any = None
        self.refused = 0
        self.reason = ""

    def hear(self, message: Any) -> None:
        """Takes a PoseWithCovarianceStamped."""
        with self._lock:
            self._newest = message

    def take(self) -> tuple[Matrix, Matrix | None, float] | None:
        """Returns X_WO, its covariance [6, 6] or None, and its age [s]; None if none is new."""
        with self._lock:
            message, self._newest = self._newest, None
        if message is None:
            return None
        try:
            return self._read(message)
        except RefusedError as error:
            self.refused += 1
            self.reason = str(error)
            return None

    def _read(self, message: Any) -> tuple[Matrix, Matrix | None, float]:
        stamp = seconds_of(message.header.stamp)
        pose = message.pose.pose
        X_FO = matrix_of(pose.position, pose.orientation, "the pose of the object")
        X_WF = self._transforms.lookup(self._world, message.header.frame_id, stamp)
        covariance = np.array(message.pose.covariance, dtype=float).reshape(6, 6)
        turned: Matrix | None = None
        if not np.isfinite(covariance).all() or (np.diag(covariance) < 0).any():
            raise RefusedError("the pose of the object has a covariance that is none")
        if covariance.any():  # all zeros: unknown, by the conventions of ROS
            R = np.zeros((6, 6))
            R[:3, :3] = R[3:, 3:] = X_WF[:3, :3]
            turned = R @ covariance @ R.T
            turned = (turned + turned.T) / 2
        return X_WF @ X_FO, turned, self._now() - stamp


class Description:
    """Text of the robot's URDF and SRDF, from parameters or topics."""

    def __init__(self, urdf: str, srdf: str) -> None:
        self._lock = threading.Lock()
        self._urdf, self._srdf = urdf, srdf

    def hear(self, message: Any) -> None:
        """Takes the String with the URDF."""
        with self._lock:
            self._urdf = message.data

    def hear_semantic(self, message: Any) -> None:
        """Takes the String with the SRDF."""
        with self._lock:
            self._srdf = message.data

    def texts(self) -> tuple[str, str]:
        """Returns URDF and SRDF; empty without."""
        with self._lock:
            return self._urdf, self._srdf
