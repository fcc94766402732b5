# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a noisy depth image to a table with labelled edges, objects, and space that nobody saw."""

import sys

import numpy as np

import graspless
from graspless import frames, geometry, perception, view


def block(size: list[float], position: list[float], yaw: float = 0.0) -> perception.Body:
    """A box with its middle at `position`."""
    X_WB = frames.planar(position[0], position[1], yaw)
    X_WB[2, 3] = position[2]
    return perception.Body([geometry.PlacedShape(geometry.Box(size))], X_WB)


table = block([0.7, 0.9, 0.04], [0.65, 0, -0.02])
floor = block([6, 6, 0.02], [0.65, 0, -0.75])
wall = block([0.02, 2.0, 1.6], [1.01, 0, 0.05])  # nothing is slid over the edge before it
things = [
    block([0.12, 0.08, 0.005], [0.5, 0.1, 0.0025], 0.4),
    block([0.06, 0.06, 0.12], [0.68, -0.18, 0.06], 0.8),
    block([0.2, 0.14, 0.05], [0.8, 0.2, 0.025], -0.3),
]
X_WC = perception.look_at([-0.2, -0.15, 0.85], [0.6, 0.0, 0.0])
frame = perception.render([table, floor, wall, *things], X_WC)
scene = graspless.perceive(frame.depth, frame.K, frame.X_WC)
print(scene.reason)
for support in scene.supports:
    edges = [str(label) for label in support.edges]
    told = ", ".join(f"{edges.count(label)} {label}" for label in dict.fromkeys(edges))
    print(f"{support.name} at {support.X_WS[2, 3]:.3f} m: {told}")
for thing in scene.objects:
    x, y = thing.X_WO[:2, 3]
    area = 1e4 * geometry.Polygon(np.asarray(thing.outline)).area
    print(f"{thing.name} on {thing.support} at ({x:.2f}, {y:.2f}) m: {area:.0f} cm^2, ", end="")
    error = f" +- {1000 * thing.thickness_error:.1f}" if thing.is_flat else ""
    print(f"{1000 * thing.thickness:.1f}{error} mm thick")
print(f"unseen: {len(scene.unseen)} pieces of space")

if len(sys.argv) > 1:  # a picture
    view.write_scene_png(scene, sys.argv[1])
