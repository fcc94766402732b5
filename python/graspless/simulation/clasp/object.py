# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Object of a clasp in MuJoCo, with open holes and feet."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ..robots import placed_body, unused
from ..shapes import add_placed, add_skin, give_inertia
from . import surface

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ... import geometry
    from ...frames import Matrix
    from ..settings import Clasp
    from ..variation import Variation

OBJECT, STAND = "graspless_object", "graspless_stand"
OBJECT_BIT = 2  # collision bit of the object


def add_object(
    spec: Any,
    cloud: geometry.Complex,
    solids: Sequence[geometry.PlacedShape] | None,
    X_WO: Matrix,
    mass: float,
    variation: Variation,
    settings: Clasp,
) -> None:
    """Adds a free body with the surface of a cloud or of solids. It stands on feet, or is held.

    `mass` is the mass before variation [kg].
    """
    points = np.asarray(cloud.points)
    body = placed_body(spec, OBJECT, X_WO)
    body.add_freejoint(name=OBJECT)
    mass *= variation.mass
    give_inertia(body, mass, points.mean(axis=0), mass * surface.inertia(points))
    spin, roll = settings.spin_friction, settings.roll_friction
    touch = {
        "contype": OBJECT_BIT,
        "conaffinity": OBJECT_BIT,
        "condim": 3,
        "friction": [variation.friction * settings.friction, spin, roll],
        "solref": [settings.stiffness_time, 1.0],
        "priority": 1,  # its friction is that of the pair
    }
    if solids is None:
        add_skin(spec, OBJECT, OBJECT, points, surface.skin(cloud), settings.skin, **touch)
    for placed in solids or ():
        add_placed(spec, body, placed, **touch)
    standing = surface.feet(frames.transform(X_WO, points), settings.foot_depth)
    _add_hold(spec, is_active=standing is None)
    sliding = variation.support_friction * settings.stand_friction
    friction = [sliding, sliding, spin, roll, roll]
    _add_stand(spec, body, X_WO, standing, settings.foot_radius, friction)


def _add_hold(spec: Any, *, is_active: bool) -> None:
    """Adds a weld that keeps the object in place."""
    held = spec.add_equality(name=OBJECT, type=mujoco.mjtEq.mjEQ_WELD, active=is_active)
    held.name1, held.name2 = OBJECT, "world"
    held.objtype = mujoco.mjtObj.mjOBJ_BODY


def _add_stand(
    spec: Any,
    body: Any,
    X_WO: Matrix,
    standing: Matrix | None,
    radius: float,
    friction: list[float],
) -> None:
    """Adds a level plane under small feet. Nothing else touches it, as the planner has no floor."""
    height = 0.0 if standing is None else standing[:, 2].min()
    # A body that can be moved: MuJoCo works out the places of what is fixed to the world once.
    stand = spec.worldbody.add_body(name=unused(spec, STAND), mocap=True, pos=[0, 0, height])
    plane = {"type": mujoco.mjtGeom.mjGEOM_PLANE, "size": [1, 1, 1]}
    stand.add_geom(name=STAND, contype=0, conaffinity=0, **plane)
    for i, p_W in enumerate(() if standing is None else standing):
        p_O = X_WO[:3, :3].T @ (np.array([*p_W[:2], height + radius]) - X_WO[:3, 3])
        name = f"{OBJECT}_{i}"
        body.add_geom(name=name, size=[radius, 0, 0], pos=p_O, contype=0, conaffinity=0, mass=0)
        spec.add_pair(
            geomname1=name,
            geomname2=STAND,
            condim=3,
            friction=friction,
        )
