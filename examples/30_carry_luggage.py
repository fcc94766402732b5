# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Carry luggage: a bag is seen by two cameras, clasped by its handle, and put on a trolley.

python 30_carry_luggage.py [PICTURE.png [REPLAY.html]]
"""

import sys

import numpy as np

import graspless
from graspless import frames, geometry, perception, view

START, TROLLEY = (0.60, 0.15, 0.3), (0.60, -0.35)  # x, y, yaw of the bag; x, y [m, rad]
SIZE = [0.24, 0.10, 0.20]  # of the bag without its handle [m]
ROBOT = {"urdf": "kr5_sdh", "pose": {"position": [0.0, 0.0, 0.35]}}  # on a pedestal


def block(size: list[float], position: list[float]) -> perception.Body:
    """A box with its middle at `position`."""
    return perception.Body([geometry.PlacedShape(geometry.Box(size))], frames.translation(position))


def tube(line: np.ndarray, radius: float, around: int = 12) -> geometry.Mesh:
    """A closed tube along a line (N, 3) in the plane y = 0."""
    along = np.gradient(line, axis=0)
    across = np.cross(along / np.linalg.norm(along, axis=1)[:, None], [0.0, 1.0, 0.0])
    angle = 2 * np.pi * np.arange(around) / around
    round_ = np.cos(angle)[:, None] * across[:, None] + np.sin(angle)[:, None] * [0.0, 1.0, 0.0]
    vertices = np.concatenate([(line[:, None] + radius * round_).reshape(-1, 3), line[[0, -1]]])
    first, last, end = 0, around * (len(line) - 1), around * len(line)
    k, after = np.arange(around), (np.arange(around) + 1) % around
    rows = [around * i for i in range(len(line) - 1)]
    sides = [np.stack([i + k, i + k + around, i + after], axis=1) for i in rows]
    sides += [np.stack([i + after, i + k + around, i + after + around], axis=1) for i in rows]
    caps = [np.stack([np.full(around, end), first + k, first + after], axis=1)]
    caps += [np.stack([np.full(around, end + 1), last + after, last + k], axis=1)]
    return geometry.Mesh(vertices, np.concatenate([*sides, *caps]))


def bag() -> perception.Body:
    """A box with a handle, which is a tube 18 mm thick."""
    t = np.linspace(0, np.pi, 17)
    arch = np.stack([-0.065 * np.cos(t), 0 * t, SIZE[2] - 0.01 + 0.11 * np.sin(t) ** 0.7], axis=1)
    box = geometry.PlacedShape(geometry.Box(SIZE), frames.translation([0, 0, SIZE[2] / 2]))
    stand = frames.planar(*START) @ frames.translation([0, 0, 0.05])
    return perception.Body([box, geometry.PlacedShape(tube(arch, 0.009))], stand)


floor = block([6, 6, 0.02], [0.6, 0, -0.01])
step = block([0.5, 0.4, 0.05], [0.6, 0.2, 0.025])  # a low box, on which the bag stands
trolley = block([0.5, 0.4, 0.15], [*TROLLEY, 0.075])
eyes = ([0.05, -0.6, 0.9], [0.05, 0.85, 0.9])
shots = [
    perception.render([floor, step, trolley, bag()], perception.look_at(eye, [0.6, 0.05, 0.15]))
    for eye in eyes
]
scene = graspless.perceive(
    [shot.depth for shot in shots], [shot.K for shot in shots], [shot.X_WC for shot in shots]
)
assert scene, scene.reason
thing = min(scene.objects, key=lambda o: float(np.linalg.norm(o.X_WO[:2, 3] - START[:2])))
place = max(scene.supports, key=lambda s: float(s.X_WS[2, 3]))

found = graspless.pick(scene, thing.name, ROBOT, place={"on": place.name}, mass=1.0, seconds=60)
print(found.table())
plan = found.plan
assert plan is not None, found.reason
assert graspless.check(plan) == []
end = plan.stages[-1].segments[-1].object_poses[-1]
print(f"the bag stands at {end[0, 3]:.2f} {end[1, 3]:.2f} m, {end[2, 3]:.2f} m over the floor")

if len(sys.argv) > 1:
    view.write_png(plan.stages[-1], sys.argv[1])
if len(sys.argv) > 2:
    view.write_html(plan, sys.argv[2])
