# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the cloud of 05_point_cloud.yaml: a crescent's top, scanned with 0.5 mm of noise.

Run it with the name of a file to write: 05_point_cloud.ply.
"""

import sys

import numpy as np
import trimesh

rng = np.random.default_rng(5)
axis = np.arange(-0.075, 0.075, 0.003)
x, y = (part.ravel() for part in np.meshgrid(axis, axis))
inside = (np.hypot(x, y) < 0.07) & (np.hypot(x - 0.045, y) > 0.055)
points = np.column_stack([x, y, np.full_like(x, 0.006)])[inside]
points += rng.normal(0, 0.0005, points.shape) * [0.5, 0.5, 1.0]
turn = np.array([[np.cos(0.8), -np.sin(0.8), 0], [np.sin(0.8), np.cos(0.8), 0], [0, 0, 1]])
points = points @ turn.T + [0.62, -0.06, 0.0]
if len(sys.argv) > 1:
    trimesh.PointCloud(points.astype(np.float32)).export(sys.argv[1])
print(f"{len(points)} points")
