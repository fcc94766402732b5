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
    _contact_sets,
    best_control_modes,
    compliant_stability,
    contact_patches,
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
    "compliant_stability",
    "contact_patches",
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
    p, n = _vectors(points, "points"), _vectors(normals, "normals")
    finger_p = _vectors(finger_points, "finger_points")
    finger_n = _vectors(finger_normals, "finger_normals")
    contacts, fingers = p.shape[:2], finger_p.shape[:2]
    if fingers[0] != contacts[0]:
        raise ValueError(f"finger_points are of {fingers[0]} contact sets, points of {contacts[0]}")
    _same(n, p, "normals", "points")
    _same(finger_n, finger_p, "finger_normals", "finger_points")
    t = np.zeros_like(p) if sliding is None else _vectors(sliding, "sliding")
    _same(t, p, "sliding", "points")
    common = ContactSet(
        contacts=[],
        fingers=[],
        com_O=np.asarray(com, float),
        known_wrench_O=gravity_wrench(mass, np.asarray(gravity, float)),
        wrench_scale=wrench_scale(mass, np.asarray(inertia, float)),
        cone_edges=cone_edges,
    )
    sets = _contact_sets(
        common,
        p,
        n,
        _values(friction, contacts, "friction"),
        t,
        finger_p,
        finger_n,
        _values(finger_friction, fingers, "finger_friction"),
        _values(max_normal_force, fingers, "max_normal_force"),
    )
    given = None if directions is None else np.asarray(directions, float)
    best = best_control_modes(sets, directions=given, engine=engine)
    z = np.zeros(contacts[0])
    modes = np.full(fingers, "", dtype="<U8")
    commanded_forces = np.zeros(fingers)
    for i, found in enumerate(best):
        if found:
            z[i] = found.stability.z
            modes[i] = [mode.name for mode in found.modes]
            commanded_forces[i] = found.stability.commanded_forces
    return Stabilities(z, modes, commanded_forces)


def _vectors(values: ArrayLike, name: str) -> NDArray[np.float64]:
    array = np.ascontiguousarray(values, dtype=float)
    if array.ndim != 3 or array.shape[2] != 3:
        raise ValueError(f"{name} has shape {array.shape}; it must have shape (N, ..., 3)")
    return array


def _values(values: ArrayLike, shape: tuple[int, ...], name: str) -> NDArray[np.float64]:
    array = np.asarray(values, dtype=float)
    if array.ndim and array.shape != shape:
        raise ValueError(f"{name} has shape {array.shape}; it must be one value or of {shape}")
    return np.ascontiguousarray(np.broadcast_to(array, shape))


def _same(a: NDArray[np.float64], b: NDArray[np.float64], name: str, other: str) -> None:
    if a.shape != b.shape:
        raise ValueError(f"{name} has shape {a.shape}, {other} has {b.shape}: they must be equal")
