# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of boxes on a table, as a camera sees them."""

import numpy as np

import graspless
from graspless import geometry, perception

TABLE = ([0.7, 0.7, 0.04], 0.65, 0.0, -0.02)
FLOOR = ([6, 6, 0.02], 0.65, 0.0, -0.75)
CARD = ([0.12, 0.08, 0.006], 0.55, 0.2, 0.003, 0.3)
BAR = ([0.10, 0.035, 0.06], 0.62, -0.02, 0.03, 0.5)
BLOCK = ([0.14, 0.12, 0.2], 0.75, -0.22, 0.1)  # too large for all strategies


def body(size, x, y, z, yaw=0.0):
    X_WB = np.eye(4)
    c, s = np.cos(yaw), np.sin(yaw)
    X_WB[:2, :2], X_WB[:3, 3] = [[c, -s], [s, c]], (x, y, z)
    return perception.Body([geometry.PlacedShape(geometry.Box(size))], X_WB)


def seen(*boxes):
    """The perceived scene of a table, a floor and boxes; by default a card, a bar and a block."""
    bodies = [body(*box) for box in (TABLE, FLOOR, *(boxes or (CARD, BAR, BLOCK)))]
    frame = perception.render(bodies, perception.look_at([-0.05, 0.0, 0.75], [0.65, 0.0, 0.0]))
    found = graspless.perceive(frame.depth, frame.K, frame.X_WC)
    assert found, found.reason
    return found
