# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A box between two walls, too wide for the hand: tumbled, pinched, lifted and put down.

python 29_box_between_walls.py [PICTURE.png]
"""

import sys

import numpy as np

import graspless
from graspless import frames, geometry, perception


def box(size: list[float], x: float, y: float, bottom: float = 0.0) -> perception.Body:
    """A box that stands on the table."""
    X_WB = frames.translation([x, y, bottom + size[2] / 2])
    return perception.Body([geometry.PlacedShape(geometry.Box(size))], X_WB)


bodies = [
    box([0.7, 0.7, 0.04], 0.65, 0.0, -0.04),  # table
    box([6, 6, 0.02], 0.65, 0.0, -0.76),  # floor
    box([0.118, 0.112, 0.04], 0.6, 0.0),
    box([0.14, 0.02, 0.12], 0.6, 0.11),
    box([0.14, 0.02, 0.12], 0.6, -0.11),
]
X_WC = perception.look_at([-0.05, 0.0, 0.75], [0.65, 0.0, 0.0])
frame = perception.render(bodies, X_WC)
scene = graspless.perceive(frame.depth, frame.K, frame.X_WC)
off = [np.linalg.norm(thing.X_WO[:2, 3] - [0.6, 0.0]) for thing in scene.objects]
name = scene.objects[int(np.argmin(off))].name

place = {"pose": {"x": 0.5, "y": 0.25}}
ways = ["pinch", "tumble"]
found = graspless.pick(
    scene, name, "wam_t42_tips", strategies=ways, mass=0.8, place=place, seconds=30
)
print(found.table())
plan = found.plan
assert plan is not None, found.reason
assert graspless.check(plan) == []
print(", ".join(plan.names))
if len(sys.argv) == 2:
    graspless.view.write_png(plan.stages[0], sys.argv[1])  # the tumble
