# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Judge of a clasp: decides from simulated poses if the hand still holds the loop.

Links are counted by the planner's own `geometry`; where hand and object are is the engine's.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ... import frames, geometry

if TYPE_CHECKING:
    from typing import Any

    from ... import clasp
    from ...frames import Matrix
    from .model import World


class Judge:
    """Evaluates the curves of a hand and the loop that it clasps."""

    def __init__(self, hand: clasp.Hand, world: World, loop_O: Matrix) -> None:
        self._fingers = [_bodies(finger, world.model) for finger in hand.fingers]
        self._thumb = _bodies(hand.thumb, world.model)
        self._inner = [_inside(finger, world.model) for finger in (*self._fingers, self._thumb)]
        self._palm = world.model.body(hand.frame).id
        self._forward_H = np.asarray(hand.forward_H)
        self._world = world
        self._loop_O = np.asarray(loop_O)

    def curves(self) -> list[Matrix]:
        """Curves [K, 3] of the fingers, from tip over palm to the tip of the thumb, in W [m]."""
        thumb = self._points(self._thumb)
        return [np.concatenate([self._points(finger)[::-1], thumb]) for finger in self._fingers]

    def loop(self) -> Matrix:
        """Returns the loop [K, 3] in W [m]."""
        return frames.transform(self._world.object_pose, self._loop_O)

    def linked(self) -> int:
        """Number of finger curves, closed from tip to tip, that are linked with the loop.

        A side of a curve may leave its link. These curves run inside, so that a loop which is
        pressed against the link does not cross them.
        """
        loop = geometry.PreparedLoop(self.loop())
        *fingers, thumb = (self._points(nodes) for nodes in self._inner)
        curves = [np.concatenate([finger[::-1], thumb]) for finger in fingers]
        return sum(number != 0 for number in loop.linking_numbers(curves))

    def linking(self) -> float:
        """Least |VLk| of the loop and the finger curves."""
        loop = self.loop()
        return min(abs(geometry.virtual_linking(loop, curve)) for curve in self.curves())

    def distance(self) -> float:
        """Distance of the loop from the middle of the finger curves [m]."""
        corners = np.concatenate(self.curves())
        middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
        return _distance(self.loop(), middle)

    def reach(self) -> float:
        """Half the length of the longest curve [m]: the reach of the hand from its middle."""
        return max(float(_lengths(curve).sum()) for curve in self.curves()) / 2

    def forward(self) -> Matrix:
        """Unit vector out of the palm, in W."""
        forward: Matrix = self._world.data.xmat[self._palm].reshape(3, 3) @ self._forward_H
        return forward

    def _points(self, nodes: list[tuple[int, Matrix]]) -> Matrix:
        data = self._world.data
        return np.array([data.xmat[i].reshape(3, 3) @ p_L + data.xpos[i] for i, p_L in nodes])


def _bodies(finger: clasp.Finger, model: Any) -> list[tuple[int, Matrix]]:
    return [(model.body(node.link).id, np.asarray(node.p_L)) for node in finger.nodes]


def _inside(nodes: list[tuple[int, Matrix]], model: Any) -> list[tuple[int, Matrix]]:
    """Returns the nodes with the centres of a link's shapes beside the sides that lie in it."""
    found = nodes[:1]
    for (before, a), (body, b) in pairwise(nodes):
        if before == body:
            centers = model.geom_pos[model.geom_bodyid == body]
            along = (centers - a) @ (b - a) / max((b - a) @ (b - a), 1e-18)
            between = [i for i in np.argsort(along) if 0 < along[i] < 1]
            found += [(body, centers[i]) for i in between]
        found.append((body, b))
    return found


def _lengths(curve: Matrix) -> Matrix:
    lengths: Matrix = np.linalg.norm(np.diff(curve, axis=0), axis=1)
    return lengths


def _distance(loop: Matrix, p: Matrix) -> float:
    """Returns the distance of a point from a closed polyline."""
    sides = np.roll(loop, -1, axis=0) - loop
    squares = np.maximum((sides**2).sum(axis=1), 1e-18)
    along = np.clip(((p - loop) * sides).sum(axis=1) / squares, 0, 1)
    return float(np.linalg.norm(p - loop - along[:, None] * sides, axis=1).min())
