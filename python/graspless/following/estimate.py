# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kalman filter for the place of an object on its support, from late, noisy and biased poses.

The process model is the plan's own prediction: in contact the object moves with the fingertip by
the motion M(t) of the plane, else it stands still. The state is where the object would have been
before all motion, K = M(t)^-1 X_SC(t), where C is its centre of mass, the height of the support's
surface, and the bias of the camera. K changes only where the object does not follow the finger, so
a late pose is compared with the M of its own time: delays need no further treatment. The
measurement is linear in the state:

    p = p_M(t) + R_M(t) K_xy + b_xy + noise,  yaw = yaw_M(t) + K_yaw + noise,
    height = h + b_z + noise

The bias is constant, so that no number of poses makes the filter surer than the bias allows.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from .._arguments import require_within
from . import plane

if TYPE_CHECKING:
    from ..frames import Matrix

GATE = 23.5  # squared Mahalanobis distance that 1 of 10,000 poses exceeds (chi^2, 4 of freedom)
AGREEING = 3  # successive poses that agree with each other, but not with the estimate: a jump
MEMORY = 1.0  # largest age of a measurement [s]
_YAW, _HEIGHT = 2, 3
_SIZE = 7


@dataclass(frozen=True)
class Noise:
    """Assumptions of the filter about camera, task and contact, as standard deviations.

    Attributes
    ----------
    position, angle : float
        Noise of a pose that comes without a covariance [m, rad].
    bias : float
        Constant error of the camera, per axis [m].
    start, start_angle, height : float
        Error of the object's pose and of the support's height in the task [m, rad, m].
    slip, slip_angle : float
        Motion of the object relative to the fingertip after it has slid 0.1 m [m, rad].
    slip_turn : float
        Turn relative to the fingertip after this has turned by 0.1 rad: large objects do not follow
        a small pad [rad].
    """

    position: float = 0.002
    angle: float = 0.0175
    bias: float = 0.00087
    start: float = 0.005
    start_angle: float = 0.0873
    height: float = 0.003
    slip: float = 0.003
    slip_angle: float = 0.0524
    slip_turn: float = 0.05

    def __post_init__(self) -> None:
        for field in fields(self):
            least = 1e-6 if field.name in ("position", "angle") else 0  # the filter inverts these
            require_within(field.name, getattr(self, field.name), least, 1.6)


class Estimate:
    """Place of the object: estimated now, with its covariance.

    Parameters
    ----------
    place : array [3]
        Planned place X_SC: x, y [m] and yaw [rad] in the plane of the support.
    noise : Noise
    """

    def __init__(self, place: Matrix, noise: Noise) -> None:
        self.noise = noise
        self.mean = np.zeros(_SIZE)
        self.mean[:3] = place
        n = noise
        spread = [n.start, n.start, n.start_angle, n.height, n.bias, n.bias, n.bias]
        self.covariance = np.diag(np.square(spread))
        self._moved = np.zeros(3)  # M
        self._times: deque[float] = deque([-np.inf])
        self._motions: deque[Matrix] = deque([self._moved])
        self._strangers: list[tuple[Matrix, Matrix]] = []

    @property
    def place(self) -> Matrix:
        """Returns X_SC now [3]."""
        return plane.compose(self._moved, self.mean[:3])

    @property
    def height(self) -> float:
        """Returns the height of the object's underside above the plane [m]."""
        return float(self.mean[_HEIGHT])

    @property
    def spread(self) -> tuple[float, float, float]:
        """Returns standard deviations of position, yaw and height, with the bias [m, rad, m]."""
        variances = np.diag(self.covariance)
        position = float(np.sqrt(max(variances[0], variances[1])))
        return position, float(np.sqrt(variances[_YAW])), float(np.sqrt(variances[_HEIGHT]))

    def carry(self, t: float, before: Matrix, after: Matrix) -> None:
        """Moves the object with the fingertip by `after before^-1`, places [3], at time t [s]."""
        step = plane.difference(before, after)
        turn = abs(float(step[2]))
        way = float(np.hypot(*step[:2])) + 0.05 * turn  # of a point 5 cm away, too
        if way > 0:
            motion = plane.compose(after, plane.inverse(before))
            self._moved = plane.compose(motion, self._moved)
            slipped = np.square([self.noise.slip, self.noise.slip, self.noise.slip_angle])
            self.covariance[range(3), range(3)] += slipped * way / 0.1
            self.covariance[_YAW, _YAW] += self.noise.slip_turn**2 * turn / 0.1
        self._times.append(t)
        self._motions.append(self._moved)
        while len(self._times) > 2 and self._times[1] < t - MEMORY:
            self._times.popleft()
            self._motions.popleft()

    def loosen(self) -> None:
        """Forgets how sure the place is: the finger leaves the object, and may drag it."""
        n = self.noise
        self.covariance[range(3), range(3)] += np.square([n.start, n.start, n.start_angle])

    def measure(self, t: float, seen: Matrix, covariance: Matrix | None = None) -> str:
        """Takes a measurement that was made at time t [s].

        Parameters
        ----------
        t : float
            Time of the exposure [s].
        seen : array [4]
            x, y, yaw and height of the object in S [m, m, rad, m].
        covariance : array [4, 4], optional
            Its covariance, without the bias.

        Returns
        -------
        str
            used; jumped: not near the estimate, and not used; moved: the object is elsewhere, as
            several poses agree, and the filter begins anew there.
        """
        n = self.noise
        if covariance is None:
            covariance = np.diag(np.square([n.position, n.position, n.angle, n.position]))
        H, offset = self._model(self._motion_at(t))
        error = seen - offset - H @ self.mean
        error[_YAW] = plane.wrapped(error[_YAW])
        S = H @ self.covariance @ H.T + covariance
        if float(error @ np.linalg.solve(S, error)) > GATE:
            return self._stranger(H, error, covariance)
        self._strangers.clear()
        self._update(H, error, S, covariance)
        return "used"

    def _update(self, H: Matrix, error: Matrix, S: Matrix, R: Matrix) -> None:
        gain = np.linalg.solve(S, H @ self.covariance).T
        self.mean = self.mean + gain @ error
        rest = np.eye(_SIZE) - gain @ H
        self.covariance = rest @ self.covariance @ rest.T + gain @ R @ gain.T  # Joseph's form
        self.mean[_YAW] = plane.wrapped(self.mean[_YAW])

    def _model(self, motion: Matrix) -> tuple[Matrix, Matrix]:
        c, s = np.cos(motion[2]), np.sin(motion[2])
        H = np.zeros((4, _SIZE))
        H[:2, :2] = [[c, -s], [s, c]]
        H[_YAW, _YAW] = H[_HEIGHT, _HEIGHT] = 1
        H[0, 4] = H[1, 5] = H[_HEIGHT, 6] = 1
        return H, np.array([*motion, 0.0])

    def _motion_at(self, t: float) -> Matrix:
        times = np.array(self._times)
        k = max(int(np.searchsorted(times, t, side="right")) - 1, 0)
        if k + 1 == len(times) or not np.isfinite(times[k]):
            return self._motions[k]
        part = (t - times[k]) / (times[k + 1] - times[k])
        step: Matrix = part * plane.difference(self._motions[k], self._motions[k + 1])
        return self._motions[k] + step

    def _stranger(self, H: Matrix, error: Matrix, R: Matrix) -> str:
        """Keeps a pose that is far away; believes it when others say the same."""
        # The change of K and height, as if the pose were exact, and its covariance.
        change: Matrix = np.linalg.solve(H[:, :4], error).astype(float)
        noise: Matrix = np.linalg.solve(H[:, :4], np.linalg.solve(H[:, :4], R).T).astype(float)
        self._strangers = [
            (other, of)
            for other, of in self._strangers[-AGREEING:]
            if _distance(change, other, 2 * noise) <= GATE
        ]
        self._strangers.append((change, R))
        if len(self._strangers) < AGREEING:
            return "jumped"
        changes = np.array([other for other, _ in self._strangers])
        mean = changes[0] + np.mean([_minus(other, changes[0]) for other in changes], axis=0)
        self.mean[:4] += mean
        self.mean[_YAW] = plane.wrapped(self.mean[_YAW])
        # As sure as the poses are, which share the bias.
        bias = self.covariance[4:, 4:].copy()
        self.covariance[:] = 0
        self.covariance[4:, 4:] = bias
        shared = np.diag(np.square([self.noise.bias] * 2 + [0.0] * 2))
        self.covariance[:4, :4] = noise / len(changes) + shared
        self.covariance[_HEIGHT, _HEIGHT] += self.noise.bias**2
        self._strangers.clear()
        return "moved"


def _minus(a: Matrix, b: Matrix) -> Matrix:
    change = a - b
    change[_YAW] = plane.wrapped(change[_YAW])
    return np.asarray(change)


def _distance(a: Matrix, b: Matrix, covariance: Matrix) -> float:
    change = _minus(a, b)
    return float(change @ np.linalg.solve(covariance, change))
