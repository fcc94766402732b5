# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The holes of a point cloud: the chair's seven loops, from all sides and as one camera sees it."""

import sys

from graspless import clasp, geometry, view

cloud = geometry.sample_surface(clasp.sample_object("chair"), 2000)
eye = [2.0, -1.5, 1.5]
seen = cloud[geometry.visible_points(cloud, eye)]
rays = geometry.rays_from_viewpoints(seen, [eye])  # no loop of one view is believed without them
for name, points, views in (("whole chair", cloud, []), ("one view", seen, rays)):
    found = geometry.shortest_loops(points, rays=views)
    print(f"{name}: {len(points)} points, {len(found.found)} loops at d = ", end="")
    print(f"{found.complex.max_edge_length:.3f} m")
    for loop in found.found:
        where = loop.points.mean(axis=0).round(2)
        thick = f"{100 * loop.thickness:.1f} cm thick" if loop.thickness else "of unknown thickness"
        print(f"  {loop.length:.3f} m around {where}, {thick}")

if len(sys.argv) > 1:  # a picture
    view.write_loops_png(cloud, geometry.shortest_loops(cloud), sys.argv[1])
