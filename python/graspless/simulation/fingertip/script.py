# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of fingertips: positions, control modes and forces at every moment."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING

import numpy as np

from ... import frames

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from ...fingertip import Segment
    from ...frames import Matrix


@dataclass(frozen=True)
class Script:
    """Commands of n fingers at T moments.

    Attributes
    ----------
    times : array [T]
        [s].
    places : array [T, 7]
        Of the object: x y z [m], qw qx qy qz, X_WO.
    centers : array [T, n, 3]
        Of the fingertips, in W [m].
    normals : array [T, n, 3]
        Into the object, in W.
    forces : array [T, n, 3]
        On the object, to be fed forward, in W [N].
    holds : array [T, n]
        1 where the finger is in position control along its normal, 0 in force control.
    drift : array [T]
        Share of the error of the fingers' places: it grows from 0 to 1 along each motion.
    slides : array [T]
        1 where the object slides without turning over.
    stage : array [T]
        Which of `names`.
    joints : array [T, dof]
        Of the arm; no columns for bare fingertips [rad or m].
    names : list of str
        touch, load, the segments' names, rest.
    """

    times: Matrix
    places: Matrix
    centers: Matrix
    normals: Matrix
    forces: Matrix
    holds: Matrix
    drift: Matrix
    slides: Matrix
    stage: NDArray[np.int64]
    joints: Matrix
    names: list[str]

    def __len__(self) -> int:
        return len(self.times)

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return float(self.times[-1])

    def at(self, times: Matrix) -> Script:
        """Returns the script at other `times` [s], interpolated linearly; modes and stages jump."""
        after = np.searchsorted(self.times, times, side="left").clip(1, len(self) - 1)
        gap = self.times[after] - self.times[after - 1]
        t = ((times - self.times[after - 1]) / np.where(gap > 0, gap, 1)).clip(0, 1)

        def mix(values: Matrix) -> Matrix:
            weight = t.reshape(-1, *([1] * (values.ndim - 1)))
            mixed: Matrix = (1 - weight) * values[after - 1] + weight * values[after]
            return mixed

        places = mix(self.places)
        places[:, 3:] /= np.linalg.norm(places[:, 3:], axis=1, keepdims=True)
        return Script(
            times, places, mix(self.centers), mix(self.normals), mix(self.forces),
            self.holds[after], mix(self.drift), self.slides[after], self.stage[after],
            mix(self.joints), self.names,
        )  # fmt: skip

    def velocities(self) -> Matrix:
        """Velocities of the centres of the fingertips [T, n, 3] [m/s]."""
        if len(self) < 2:
            return np.zeros_like(self.centers)
        steps = np.diff(self.centers, axis=0) / np.diff(self.times).reshape(-1, 1, 1)
        return np.concatenate([steps, steps[-1:]])


def joined(parts: Sequence[Script]) -> Script:
    """Joins scripts; times continue, and quaternions do not jump."""
    start, names, shifted = 0.0, 0, []
    for part in parts:
        shifted.append(replace(part, times=part.times + start, stage=part.stage + names))
        start, names = start + part.duration, names + len(part.names)
    whole = {
        field.name: np.concatenate([getattr(part, field.name) for part in shifted])
        for field in fields(Script)
        if field.name != "names"
    }
    turn = whole["places"][:, 3:]
    flips = np.cumprod(np.where((turn[1:] * turn[:-1]).sum(axis=1) < 0, -1.0, 1.0))
    turn[1:] *= flips[:, None]
    return Script(**whole, names=[name for part in parts for name in part.names])


def moving(
    segment: Segment, times: Matrix, rows: Matrix, object_poses: Matrix, radius: float
) -> Script:
    """Returns the script of a segment.

    Parameters
    ----------
    segment : Segment
        Of N rows.
    times : array [T]
        [s], from 0.
    rows : array [T]
        Where in the segment.
    object_poses : array [T, 4, 4]
        X_WO.
    radius : float
        Of the fingertips [m].
    """
    count = len(segment)
    near = np.rint(rows).astype(int).clip(0, count - 1)
    before = np.floor(rows).astype(int).clip(0, max(count - 2, 0))
    after = (before + 1).clip(0, count - 1)
    t = (rows - before).clip(0, 1).reshape(-1, 1, 1)
    forces_O = (1 - t) * segment.nominal_forces[before] + t * segment.nominal_forces[after]
    R_WO, p_WO = object_poses[:, None, :3, :3], object_poses[:, None, :3, 3]
    points, normals = _standing(segment)

    def turned(vectors: Matrix) -> Matrix:
        rotated: Matrix = np.einsum("...ij,...j->...i", R_WO, vectors)
        return rotated

    return Script(
        times=np.asarray(times, dtype=float),
        places=frames.to_rows(object_poses),
        centers=p_WO + turned((points - radius * normals)[None]),
        normals=turned(normals[None]),
        forces=turned(forces_O),
        holds=np.array([[m == "position" for m in segment.modes[i]] for i in near], dtype=float),
        drift=np.asarray(rows / max(count - 1, 1), dtype=float),
        slides=np.full(len(times), float(segment.name in ("slide", "turn"))),
        stage=np.zeros(len(times), dtype=np.int64),
        joints=np.zeros((len(times), 0)),
        names=[segment.name],
    )


def still(script: Script, i: int, seconds: float, name: str) -> Script:
    """Returns a script that holds moment i for a while."""
    held = {
        field.name: np.repeat(getattr(script, field.name)[[i, i]][:1], 2, axis=0)
        for field in fields(Script)
        if field.name not in ("times", "stage", "names")
    }
    stage = np.zeros(2, dtype=np.int64)
    return Script(**held, times=np.array([0.0, seconds]), stage=stage, names=[name])


def blended(before: Script, after: Script, seconds: float) -> Script:
    """Returns a script at rest from the last forces of one script to the first of the next.

    All fingers are in force control; those that hold their places afterwards hold those that they
    then have.
    """
    start = still(after, 0, seconds, "load")
    forces = np.stack([before.forces[-1], after.forces[0]])
    drift = np.repeat(before.drift[-1:], 2)
    return replace(start, forces=forces, drift=drift, holds=np.zeros_like(start.holds))


def _standing(segment: Segment) -> tuple[Matrix, Matrix]:
    """Returns points and normals [n, 3]; zero for a finger that is off the object."""
    on = segment.touches[0][:, None]
    return np.where(on, segment.fingers[0], 0.0), np.where(on, segment.normals[0], 0.0)
