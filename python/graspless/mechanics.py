# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stability of objects with frictional contacts, Sections 2 and 3 of Maeda and Arai (2005).

`stability()` takes contacts as arrays, for many objects at once. All other functions take a
`ContactSet`, which holds the contacts of one object.
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
    Surfaces,
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
    place_tolerance,
    tangent,
    validate,
    withstands,
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
    "Surfaces",
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
    "place_tolerance",
    "stability",
    "tangent",
    "validate",
    "withstands",
    "wrench_scale",
]


class Stabilities(NamedTuple):
    """Stability of N contact sets with n fingers each, under their best control modes."""

    z: NDArray[np.float64]
    """(N,) stability z [N]; 0 where no control modes hold the object without jamming."""
    modes: NDArray[np.str_]
    """(N, n) control modes, "position" or "force"; "" where z is 0."""
    commanded_forces: NDArray[np.float64]
    """(N, n) normal forces f_com of fingers in force control, 0 for the others [N]."""


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
    """Computes the stability of objects held by fingers against their environment.

    Searches the control modes of the fingers by Section 3.4 and evaluates Problems (5) and (6) for
    N objects, each with m contacts and n fingers. Coordinates are those of each object's frame O.

    Parameters
    ----------
    points : array (N, m, 3)
        Contacts with the environment [m].
    normals : array (N, m, 3)
        Their unit normals, pointing into the object.
    finger_points : array (N, n, 3)
        Fingertips [m], four at most.
    finger_normals : array (N, n, 3)
        Their unit normals, pointing into the object.
    mass : float
        Mass of every object [kg].
    inertia : array (3, 3)
        Inertia about the centre of mass [kg m^2].
    friction : float or array (N, m)
        Coefficient of friction of the contacts.
    finger_friction : float or array (N, n)
        Coefficient of friction of the fingers.
    max_normal_force : float or array (N, n)
        Upper limit f_max of the fingers' normal forces [N].
    sliding : array (N, m, 3), optional
        Direction in which the object slides at each contact; zero where it sticks. By default all
        contacts stick.
    com : array (3,)
        Centre of mass [m].
    gravity : array (3,)
        Acceleration of gravity [m/s^2].
    cone_edges : int
        Number of edges of each polyhedral friction cone, 3 to 1000.
    directions : array (D, 6), optional
        Directions of disturbances in scaled wrench space. By default `disturbance_directions()`.
    engine : Engine
        Solver of the linear programs.

    Returns
    -------
    Stabilities
        Stability, control modes and commanded forces of every object.

    Raises
    ------
    ValueError
        An array has the wrong shape, or a value is invalid. Normals that are not unit vectors are
        normalised with a GrasplessWarning.
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
