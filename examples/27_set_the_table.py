# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Set a table: each thing is seen by a camera, picked up, and put down at its place.

python 27_set_the_table.py [PICTURE.png]
"""

import math
import sys

import numpy as np

import graspless
from graspless import frames, geometry, perception

EYE, MIDDLE = [-0.05, 0.0, 0.75], [0.65, 0.0, 0.0]
Place = tuple[float, float, float | None]
TABLE = perception.Body(
    [geometry.PlacedShape(geometry.Box([0.7, 0.7, 0.04]))], frames.translation([0.65, 0.0, -0.02])
)
FLOOR = perception.Body(
    [geometry.PlacedShape(geometry.Box([6, 6, 0.02]))], frames.translation([0.65, 0.0, -0.75])
)


def box(x: float, y: float, z: float) -> geometry.PlacedShape:
    """A box of three sides [m] that stands on the origin."""
    return geometry.PlacedShape(geometry.Box([x, y, z]), frames.translation([0, 0, z / 2]))


def disc(radius: float, z: float) -> geometry.PlacedShape:
    """A round plate of a radius and a height [m] on the origin."""
    angles = np.linspace(0, 2 * math.pi, 40, endpoint=False)
    ring = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    corners = [np.column_stack([ring, np.full(len(ring), height)]) for height in (0, z)]
    return geometry.PlacedShape(geometry.Convex(np.concatenate(corners)))


# Shape, where it stands, and where it belongs: x, y and yaw in the world. The hand cannot open
# below a plate on the table: it is put down over the edge, and a finger slides it in.
THINGS: dict[str, tuple[geometry.PlacedShape, Place, Place]] = {
    "plate": (disc(0.075, 0.014), (0.42, 0.18, 0.0), (0.47, -0.03, None)),
    "salt": (box(0.05, 0.04, 0.09), (0.55, 0.22, 0.3), (0.65, -0.05, 0.0)),
    "cutlery": (box(0.16, 0.03, 0.03), (0.65, 0.10, 1.0), (0.50, -0.20, 0.0)),
    "napkins": (box(0.10, 0.045, 0.05), (0.75, 0.20, -0.6), (0.75, -0.20, math.pi / 2)),
}


def body(shape: geometry.PlacedShape, place: Place) -> perception.Body:
    """A thing on the table."""
    x, y, yaw = place
    return perception.Body([shape], frames.planar(x, y, yaw or 0.0))


now = {name: start for name, (_, start, _) in THINGS.items()}
for name, (_, start, (x, y, yaw)) in THINGS.items():
    bodies = [body(THINGS[other][0], pose) for other, pose in now.items()]
    frame = perception.render([TABLE, FLOOR, *bodies], perception.look_at(EYE, MIDDLE))
    scene = graspless.perceive(frame.depth, frame.K, frame.X_WC)
    off = [float(np.linalg.norm(thing.X_WO[:2, 3] - start[:2])) for thing in scene.objects]
    thing = scene.objects[int(np.argmin(off))]
    place = {"pose": {"x": x, "y": y} | ({} if yaw is None else {"yaw": yaw})}
    found = graspless.pick(scene, thing.name, "wam_t42", place=place)
    plan = found.plan
    assert plan is not None, found.reason
    assert graspless.check(plan) == []
    end = plan.stages[-1].segments[-1].object_poses[-1]
    print(f"{name}: {', '.join(plan.names)}; at {end[0, 3]:.2f} {end[1, 3]:.2f} m")
    now[name] = (x, y, yaw)
    if len(sys.argv) == 2:
        graspless.view.write_png(plan.stages[-1], sys.argv[1])
