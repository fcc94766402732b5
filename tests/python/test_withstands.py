# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Laws of mechanics.withstands, on a cuboid that slides, tumbles, turns or rests."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from graspless import mechanics
from graspless.mechanics import ContactMode, FingerMode

POSITION, FORCE = FingerMode.position, FingerMode.force
HALF = np.array([2.5, 5.0, 2.5])
CORNERS = HALF * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
DIRECTIONS = mechanics.disturbance_directions()
INERTIA = np.diag([125 / 12, 50 / 12, 125 / 12])


def contact_set(
    kind, rng, *, factor=1.0, R=None, shift=None, finger=1.0, stick=1.0, limit=1.0, edges=6
):
    """A set of a kind; `factor` scales lengths, R and shift move O, the others scale what they say."""
    R, shift = np.eye(3) if R is None else R, np.zeros(3) if shift is None else shift
    lean = 0.4 * rng.uniform(-1, 1)
    n = np.array([np.sin(lean), 0, np.cos(lean)]) if kind == "tumble" else np.array([0.0, 0, 1])
    bottom = CORNERS[CORNERS[:, 2] < 0]
    points = bottom[bottom[:, 0] < 0] if kind == "tumble" else bottom
    mode = ContactMode.slide if kind in ("slide", "turn") else ContactMode.stick
    side = rng.uniform(-1, 1, (2, 2)) * [1.0, 1.5]
    at = [([u, -5 * s, v], [0, s, 0]) for (u, v), s in zip(side, (1, -1), strict=True)]
    if kind == "slide":
        at = [([2 * side[0, 0], 0, 2.5], [0, 0, -1]), ([-2.5, 0, 0], [1, 0, 0])]
    contacts = [
        mechanics.Contact(
            p_OC=R @ (factor * p) + shift, n_O=R @ n, mode=mode,
            friction=0.5 * (stick if mode == ContactMode.stick else 1),
            t_O=R @ (np.cross([0, 0, 1.0], p) if kind == "turn" else [1.0, 0, 0]),
        )
        for p in points
    ]  # fmt: skip
    fingers = [
        mechanics.Finger(
            p_OC=R @ (factor * np.array(p, dtype=float)) + shift, n_O=R @ np.array(m, dtype=float),
            friction=0.7 * finger, max_normal_force=10 * limit,
        )
        for p, m in at
    ]  # fmt: skip
    weight = np.concatenate([R @ (-9.8 * n), np.zeros(3)])
    unturned = mechanics.wrench_scale(1.0, factor**2 * INERTIA)
    turn = np.kron(np.eye(2), R.T)
    return mechanics.ContactSet(
        contacts=contacts, fingers=fingers, com_O=shift, known_wrench_O=weight,
        wrench_scale=unturned @ turn, cone_edges=edges,
    )  # fmt: skip


def sets():
    """Yields kinds, seeds, modes and commanded forces of sets that have nominal forces."""
    for kind in ("slide", "turn", "tumble", "rest"):
        for seed in range(6):
            for modes in ([FORCE, POSITION], [POSITION, POSITION]):
                forces = [6.0 if mode == FORCE else 0.0 for mode in modes]
                yield kind, seed, modes, forces


def made(kind, seed, **changes):
    return contact_set(kind, np.random.default_rng(seed), **changes)


HELD = [
    case
    for case in sets()
    if mechanics.compliant_equilibrium(made(*case[:2]), case[2], case[3]) is not None
]


def nominal(case, **changes):
    return mechanics.compliant_equilibrium(made(*case[:2], **changes), case[2], case[3])


def withstands(case, forces=None, points=None, distance=1e-3, directions=None, **changes):
    forces = forces or nominal(case)
    return mechanics.withstands(
        made(*case[:2], **changes), case[2], forces, points_O=points, max_yield=distance,
        directions=directions,
    )  # fmt: skip


def test_sets_of_every_kind_withstand_something():
    positive = {case[0] for case in HELD if withstands(case) > 0.01}
    assert positive == {"slide", "turn", "tumble", "rest"}


@pytest.mark.parametrize("case", HELD[::2], ids=str)
def test_no_direction_between_the_given_ones_is_weaker(case):
    least, rng = withstands(case), np.random.default_rng(3)
    of_each = [withstands(case, directions=direction[None]) for direction in DIRECTIONS]
    assert min(of_each) >= least * (1 - 1e-6)
    for _ in range(10):
        share = rng.exponential(size=len(DIRECTIONS)) ** 6
        between = share @ DIRECTIONS / share.sum()
        if np.linalg.norm(between) > 0.01:
            assert withstands(case, directions=between[None]) >= least * (1 - 1e-6)


@pytest.mark.parametrize("case", HELD, ids=str)
def test_grows_with_friction_that_sticks_and_with_the_limits(case):
    forces = nominal(case)
    least = withstands(case, forces)
    rougher = withstands(case, forces, finger=1.1)
    assert rougher >= least * (1 - 1e-9)
    assert withstands(case, forces, finger=1.1, stick=1.1) >= rougher * (1 - 1e-9)
    assert withstands(case, forces, limit=1.1) >= least * (1 - 1e-9)


@pytest.mark.parametrize("case", HELD, ids=str)
def test_is_less_where_corners_may_yield_less(case):
    free = withstands(case)
    near = [withstands(case, points=CORNERS, distance=d) for d in (1e-3, 1e-4, 1e-5, 5e-6)]
    assert [free, *near] == sorted([free, *near], reverse=True)
    if near[-1] > 0:
        assert near[-2] == pytest.approx(2 * near[-1], rel=1e-6)


@pytest.mark.parametrize("case", HELD, ids=str)
def test_does_not_depend_on_unit_of_length_or_frame(case):
    R, shift = Rotation.from_rotvec([0.3, -0.5, 0.8]).as_matrix(), np.array([3.0, -2, 1])
    least = withstands(case, points=CORNERS)
    small = {"factor": 0.01}
    assert withstands(case, nominal(case, **small), 0.01 * CORNERS, **small) == pytest.approx(
        least, rel=1e-4, abs=1e-6
    )
    moved = {"R": R, "shift": shift}
    forces = nominal(case, **moved)
    assert withstands(case, forces, CORNERS @ R.T + shift, **moved) == pytest.approx(
        least,
        rel=0.1,
        abs=1e-3,  # edges of cones turn with O's axes where t_O is not given
    )


@pytest.mark.parametrize("case", HELD[::2], ids=str)
def test_never_more_than_fingers_that_choose_their_forces(case):
    """z over cones that contain the round ones, for the same control modes and any command."""
    wide = 1 / np.cos(np.pi / 24)
    free = made(*case[:2], edges=24, finger=wide, stick=wide)
    z = mechanics.max_stability(free, case[2]).z
    assert withstands(case) <= z * (1 + 1e-6) + 1e-6


def stiffness_matrices(case, environment):
    """Stiffness and Jacobian of every contact and then of every finger, written down anew."""
    contacts, default = made(*case[:2]), mechanics.Compliance()
    found = []
    for at in contacts.contacts:
        n, (normal, along) = np.asarray(at.n_O), environment
        if at.mode == ContactMode.slide:
            t = mechanics.tangent(at.n_O, at.t_O)
            stiffness = normal * np.outer(n - at.friction * t, n)
        else:
            stiffness = along * np.eye(3) + (normal - along) * np.outer(n, n)
        found.append((np.asarray(at.p_OC), stiffness))
    for at, mode in zip(contacts.fingers, case[2], strict=True):
        n = np.asarray(at.n_O)
        normal = default.finger_normal if mode == POSITION else 0
        along = default.finger_tangential
        stiffness = along * np.eye(3) + (normal - along) * np.outer(n, n)
        found.append((np.asarray(at.p_OC), stiffness))
    levers = [p - np.asarray(contacts.com_O) for p, _ in found]
    jacobians = [np.hstack([np.eye(3), -np.cross(np.eye(3), lever)]) for lever in levers]
    return [stiffness for _, stiffness in found], jacobians


def misplaced(case, errors, environment):
    """Nominal forces when every finger's place is off by a row of `errors` [n, 3]."""
    matrices, jacobians = stiffness_matrices(case, environment)
    forces, contacts = nominal(case), len(made(*case[:2]).contacts)
    before = np.vstack([forces.contact_forces_O, forces.finger_forces_O])
    places = np.vstack([np.zeros((contacts, 3)), errors])
    pushes = [K @ e for K, e in zip(matrices, places, strict=True)]
    whole = sum(J.T @ K @ J for K, J in zip(matrices, jacobians, strict=True))
    moved = np.linalg.solve(whole, sum(J.T @ f for J, f in zip(jacobians, pushes, strict=True)))
    after = before + [
        f - K @ J @ moved for f, K, J in zip(pushes, matrices, jacobians, strict=True)
    ]
    return mechanics.Equilibrium(np.array(after[:contacts]), np.array(after[contacts:]))


@pytest.mark.parametrize("case", HELD[::2], ids=str)
def test_fingers_beside_their_places_leave_the_promised_rest(case):
    """Errors are changes of the nominal forces: with those, the law itself says what is left."""
    least, rng = withstands(case), np.random.default_rng(7)
    tolerance = mechanics.place_tolerance(made(*case[:2]), case[2], nominal(case))
    if least == 0:
        assert tolerance == 0
        return
    soft, hard, shared, given = (5e4, 4e4), (5e9, 5e9), (5e9, 1e4), (5e9, 1e3)
    sticks = case[0] in ("tumble", "rest")
    for share in (0.25, 0.5, 1.0):
        for _ in range(20):
            errors = rng.normal(size=(len(case[2]), 3))
            errors *= share * tolerance / np.linalg.norm(errors, axis=1, keepdims=True)
            left = {e: withstands(case, misplaced(case, errors, e)) for e in (soft, hard)}
            worst = min(left.values())
            if sticks:  # or friction gives way
                others = (withstands(case, misplaced(case, errors, e)) for e in (shared, given))
                worst = max(worst, *others)
            assert worst >= least * (1 - share) - 1e-6 * least


@pytest.mark.parametrize("case", [c for c in HELD if c[0] in ("slide", "turn")][::2], ids=str)
def test_the_place_tolerance_is_not_far_too_small(case):
    """Some errors of a few times the tolerance leave nothing."""
    tolerance = mechanics.place_tolerance(made(*case[:2]), case[2], nominal(case))
    rng, left = np.random.default_rng(8), np.inf
    for _ in range(200):
        errors = rng.normal(size=(len(case[2]), 3))
        errors *= 4 * tolerance / np.linalg.norm(errors, axis=1, keepdims=True)
        left = min(left, withstands(case, misplaced(case, errors, (5e4, 4e4))))
        if left <= 0:
            return
    assert left <= 0


def test_without_fingers_no_place_matters():
    contacts = made("rest", 0)
    alone = mechanics.ContactSet(
        contacts=contacts.contacts, fingers=[], com_O=contacts.com_O,
        known_wrench_O=contacts.known_wrench_O, wrench_scale=contacts.wrench_scale,
    )  # fmt: skip
    forces = mechanics.compliant_equilibrium(alone, [], [])
    assert mechanics.withstands(alone, [], forces) > 0
    assert mechanics.place_tolerance(alone, [], forces) == 1
