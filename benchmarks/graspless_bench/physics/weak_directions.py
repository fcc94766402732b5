# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Directions in which a row of a fingertip plan withstands least."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial.transform import Rotation

from graspless import mechanics

if TYPE_CHECKING:
    from graspless.fingertip import Plan
    from graspless.frames import Matrix


def weak_directions(plan: Plan, row: tuple[int, int], count: int) -> list[int]:
    """Returns the indices of up to three directions that limit z, then of those that withstand
    least by the plan's own law.
    """
    contacts, modes, _ = row_contacts(plan, *row)
    found = list(mechanics.max_stability(contacts, modes).binding_directions[:3])
    limits = direction_limits(plan, *row)
    found += [int(i) for i in np.argsort(limits, kind="stable") if i not in found]
    return found[:count]


def direction_limits(plan: Plan, s: int, r: int) -> Matrix:
    """Returns what a row withstands in each direction of the task [N], without drift."""
    contacts, modes, forces = row_contacts(plan, s, r)
    task = plan.task
    nominal = mechanics.compliant_equilibrium(contacts, modes, forces, task.options.compliance)
    assert nominal is not None  # a solved plan has nominal forces
    hull, most = np.asarray(task.problem.object.hull), task.options.max_yield
    directions = np.asarray(task.options.disturbance_directions)
    return np.array(
        [
            mechanics.withstands(
                contacts, modes, nominal, task.options.compliance,
                points_O=hull, max_yield=most, directions=direction[None],
            )
            for direction in directions
        ]
    )  # fmt: skip


def row_contacts(
    plan: Plan, s: int, r: int
) -> tuple[mechanics.ContactSet, list[mechanics.FingerMode], Matrix]:
    """Returns contacts, control modes and commanded forces of a row, at the least friction."""
    problem, segment = plan.task.problem, plan.segments[s]
    state = row_state(plan, s, r)
    planes = [
        mechanics.Plane(
            name=p.name, n_W=p.n_W, offset=p.offset, friction=min(p.friction or problem.friction)
        )
        for p in problem.planes
    ]
    thing, friction = problem.object, min(problem.fingers.friction)
    patches = mechanics.contact_patches(
        thing.hull, thing.com, planes, state, tolerance=1e-6 * thing.size
    )
    on = np.flatnonzero(segment.touches[r])
    fingers = [
        mechanics.Finger(
            p_OC=segment.fingers[r][i], n_O=segment.normals[r][i], friction=friction,
            max_normal_force=problem.fingers.max_normal_force,
        )
        for i in on
    ]  # fmt: skip
    contacts = mechanics.ContactSet(
        contacts=patches.contacts,
        fingers=fingers,
        com_O=thing.com,
        known_wrench_O=mechanics.gravity_wrench(
            thing.mass, state.X_WO[:3, :3].T @ problem.gravity_W
        ),
        wrench_scale=mechanics.wrench_scale(thing.mass, thing.inertia),
        cone_edges=plan.task.options.cone_edges,
    )
    modes = [getattr(mechanics.FingerMode, segment.modes[r][i]) for i in on]
    return contacts, modes, segment.commanded_forces[r][on]


def row_state(plan: Plan, s: int, r: int) -> mechanics.BodyState:
    """Returns pose and velocity of the object; at rest, the velocity of the motion that follows."""
    segment, following = plan.segments[s], s
    while plan.segments[following].name == "regrasp":
        following += 1
    rests = following != s
    arc = 0 if rests else r // plan.task.options.samples_per_arc
    before, after = plan.segments[following].X_WO[arc : arc + 2]
    X_WO = segment.object_poses[r]
    turn = after[:3, :3] @ before[:3, :3].T
    omega = Rotation.from_matrix(turn).as_rotvec()
    # The screw takes p to after before^-1 p; its velocity at the row's origin.
    fixed = after[:3, 3] - turn @ before[:3, 3]
    if (angle := np.linalg.norm(omega)) > 1e-9:
        about = np.cross(omega, np.eye(3)).T
        mean = (
            np.eye(3)
            + (1 - np.cos(angle)) / angle**2 * about
            + (angle - np.sin(angle)) / angle**3 * about @ about
        )
        fixed = np.linalg.solve(mean, fixed)
    velocity = fixed + np.cross(omega, X_WO[:3, 3])
    return mechanics.BodyState(X_WO=X_WO, twist_W=np.concatenate([velocity, omega]), at_rest=rests)
