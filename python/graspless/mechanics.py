# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Forces at frictional contacts: whether they balance, and how much more they can (Maeda, Arai).

Whoever has contacts as arrays gets margins in one call, `stability()`; the rest works on a
`ContactSet`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ._core.mechanics import (
    BodyState,
    Compliance,
    Contact,
    ContactMode,
    ContactPatches,
    ContactSet,
    ControlModes,
    Engine,
    Equilibrium,
    Finger,
    FingerMode,
    FrictionInterval,
    FrictionVerdict,
    Plane,
    Stability,
    best_control_modes,
    compliant_equilibrium,
    compliant_stability,
    contact_patches,
    contact_sets,
    disturbance_directions,
    friction_cone,
    gravity_wrench,
    holds_over_friction,
    interior_equilibrium,
    internal_force_is_bounded,
    max_stability,
    normalized,
    tangent,
    validate,
    wrench_scale,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "BodyState",
    "Compliance",
    "Contact",
    "ContactMode",
    "ContactPatches",
    "ContactSet",
    "ControlModes",
    "Engine",
    "Equilibrium",
    "Finger",
    "FingerMode",
    "FrictionInterval",
    "FrictionVerdict",
    "Plane",
    "Stabilities",
    "Stability",
    "best_control_modes",
    "compliant_equilibrium",
    "compliant_stability",
    "contact_patches",
    "contact_sets",
    "disturbance_directions",
    "friction_cone",
    "gravity_wrench",
    "holds_over_friction",
    "interior_equilibrium",
    "internal_force_is_bounded",
    "max_stability",
    "normalized",
    "stability",
    "tangent",
    "validate",
    "wrench_scale",
]


class Stabilities(NamedTuple):
    """Of N contact sets with n fingers each, every one under its best control modes."""

    z: NDArray[np.float64]
    """(N,) stability [N]; 0 where no control modes hold the object without jamming."""
    modes: NDArray[np.str_]
    """(N, n) "position" or "force"; "" where there are none."""
    commanded_forces: NDArray[np.float64]
    """(N, n) normal forces of fingers in force control, 0 for the others [N]."""


def stability(
    points: ArrayLike,
    normals: ArrayLike,
    *,
    finger_points: ArrayLike,
    finger_normals: ArrayLike,
    mass: float,
    inertia: ArrayLike,
    friction: ArrayLike = 0.5,
    finger_friction: ArrayLike = 0.5,
    max_normal_force: ArrayLike = 10.0,
    sliding: ArrayLike | None = None,
    com: ArrayLike = (0.0, 0.0, 0.0),
    gravity: ArrayLike = (0.0, 0.0, -9.81),
    cone_edges: int = 6,
    directions: ArrayLike | None = None,
    engine: Engine = Engine.fast,
) -> Stabilities:
    """How much disturbance objects withstand, held by fingers against their environment.

    N objects at once, each with m contacts and n <= 4 fingers; all in the object's frame.

    points, normals: (N, m, 3) contacts with the environment [m], normals into the object.
    finger_points, finger_normals: (N, n, 3) fingertips [m], normals into the object.
    mass, inertia: [kg] and (3, 3) about the centre of mass [kg m^2].
    friction: coefficient, one for all or (N, m). finger_friction: one for all or (N, n).
    max_normal_force: of the fingers [N], one for all or (N, n).
    sliding: (N, m, 3) where the object slides at the contacts; zero, or None, where it sticks.
    com: (3,) centre of mass [m]. gravity: (3,) [m/s^2].
    directions: (D, 6) of disturbances; disturbance_directions() unless given.

    Raises ValueError on bad values; normals that are not of length 1 are normalised with a warning.
    """
    shape, held = np.shape(points)[:2], np.shape(finger_points)[:2]
    sets = contact_sets(
        ContactSet(
            contacts=[],
            fingers=[],
            com_O=com,
            known_wrench_O=gravity_wrench(mass, gravity),
            wrench_scale=wrench_scale(mass, inertia),
            cone_edges=cone_edges,
        ),
        points=points,
        normals=normals,
        friction=_for_each(friction, shape),
        sliding=np.zeros(np.shape(points)) if sliding is None else sliding,
        finger_points=finger_points,
        finger_normals=finger_normals,
        finger_friction=_for_each(finger_friction, held),
        max_normal_force=_for_each(max_normal_force, held),
    )
    best = best_control_modes(sets, directions=directions, engine=engine)
    z = np.zeros(len(sets))
    modes = np.full(held, "", dtype="<U8")
    commanded_forces = np.zeros(held)
    for i, found in enumerate(best):
        if found:
            z[i] = found.stability.z
            modes[i] = [mode.name for mode in found.modes]
            commanded_forces[i] = found.stability.commanded_forces
    return Stabilities(z, modes, commanded_forces)


def _for_each(value: ArrayLike, shape: tuple[int, ...]) -> ArrayLike:
    return np.full(shape, value) if np.ndim(value) == 0 else value


def __dir__() -> list[str]:
    return __all__
