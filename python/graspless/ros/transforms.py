# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of the topics /tf and /tf_static.

tf2_ros would need a compiled library that ROS from PyPI does not have. This buffer keeps the same
promises: chains through common ancestors, interpolation in time, no extrapolation.
"""

from __future__ import annotations

import bisect
import threading
import time
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .messages import RefusedError, matrix_of, seconds_of

if TYPE_CHECKING:
    from ..frames import Matrix

_KEPT = 10.0  # history of a frame [s]
_DEEPEST = 100  # number of frames in a chain


class Transforms:
    """Frames and their parents, as they were heard. Safe for use by several threads."""

    def __init__(self) -> None:
        self._lock = threading.Condition()
        self._fixed: dict[str, tuple[str, Matrix]] = {}
        self._moving: dict[str, tuple[str, list[float], list[Matrix]]] = {}
        self.refused = 0

    def hear(self, message: Any, is_static: bool) -> None:
        """Takes a TFMessage. Transforms that are none are counted in `refused`, and ignored."""
        for transform in message.transforms:
            child, parent = (
                name.lstrip("/") for name in (transform.child_frame_id, transform.header.frame_id)
            )
            try:
                given = transform.transform
                X = matrix_of(given.translation, given.rotation, f"the transform to '{child}'")
            except RefusedError:
                self.refused += 1
                continue
            if not child or not parent or child == parent:
                self.refused += 1
                continue
            with self._lock:
                if is_static:
                    self._fixed[child] = (parent, X)
                else:
                    self._note(child, parent, seconds_of(transform.header.stamp), X)
                self._lock.notify_all()

    def _note(self, child: str, parent: str, stamp: float, X: Matrix) -> None:
        known, times, poses = self._moving.get(child, (parent, [], []))
        if known != parent:
            times, poses = [], []
        k = bisect.bisect_left(times, stamp)
        if k < len(times) and times[k] == stamp:
            poses[k] = X
        else:
            times.insert(k, stamp)
            poses.insert(k, X)
        old = bisect.bisect_left(times, times[-1] - _KEPT)
        del times[:old], poses[:old]
        self._moving[child] = (parent, times, poses)

    def forget(self) -> None:
        """Forgets all that moves: time has jumped back."""
        with self._lock:
            self._moving.clear()

    def lookup(
        self, target: str, source: str, stamp: float | None = None, patience: float = 0.0
    ) -> Matrix:
        """Returns X_TS [4, 4] at a time [s], or the newest.

        Waits up to `patience` [s] for transforms that have not come yet.

        Raises
        ------
        RefusedError
            A frame is unknown, the two are not connected, or the time is not covered.
        """
        target, source = target.lstrip("/"), source.lstrip("/")
        if not source:
            raise RefusedError("a message names no frame (header.frame_id is empty)")
        end = time.monotonic() + patience
        with self._lock:
            while True:
                try:
                    return self._found(target, source, stamp)
                except RefusedError:
                    left = end - time.monotonic()
                    if left <= 0:
                        raise
                    self._lock.wait(left)

    def _found(self, target: str, source: str, stamp: float | None) -> Matrix:
        (up, why), (down, why_not) = self._chain(source, stamp), self._chain(target, stamp)
        for frame, X_FS in up.items():
            if frame in down:
                found: Matrix = np.linalg.inv(down[frame]) @ X_FS
                return found
        parents = {parent for parent, *_ in (*self._fixed.values(), *self._moving.values())}
        known = parents.union(self._fixed, self._moving)
        if source in known and target in known and (error := why or why_not):
            raise error
        raise RefusedError(f"tf does not connect the frames '{source}' and '{target}'")

    def _chain(
        self, frame: str, stamp: float | None
    ) -> tuple[dict[str, Matrix], RefusedError | None]:
        """Returns the pose of a frame in itself and in each of its ancestors, in order.

        Also returns the reason for which they end below the root at that time, if they do.
        """
        X = np.eye(4)
        chain = {frame: X}
        for _ in range(_DEEPEST):
            try:
                step = self._step(frame, stamp)
            except RefusedError as error:
                return chain, error
            if step is None:
                return chain, None
            frame, X = step[0], step[1] @ X
            chain[frame] = X
        raise RefusedError(f"tf has a loop at the frame '{frame}'")

    def _step(self, frame: str, stamp: float | None) -> tuple[str, Matrix] | None:
        if frame in self._fixed:
            return self._fixed[frame]
        if frame not in self._moving:
            return None
        parent, times, poses = self._moving[frame]
        if stamp is None or stamp == times[-1]:
            return parent, poses[-1]
        k = bisect.bisect_left(times, stamp)
        if k == len(times) or (k == 0 and times[0] != stamp):
            side = "older" if k == 0 else "newer"
            raise RefusedError(f"the time of a message is {side} than what tf knows of '{frame}'")
        if times[k] == stamp:
            return parent, poses[k]
        t = (stamp - times[k - 1]) / (times[k] - times[k - 1])
        return parent, frames.between(poses[k - 1], poses[k], t)
