# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mechanics from Python: arrays in, margins out, and what is wrong is named."""

import dataclasses
import itertools

import numpy as np
import pytest

from graspless import mechanics
from graspless.mechanics import (
    BodyState,
    Compliance,
    Contact,
    ContactMode,
    ContactSet,
    Engine,
    Finger,
    FingerMode,
    FrictionInterval,
    Plane,
    Surfaces,
)

FORCE, POSITION = FingerMode.force, FingerMode.position
INERTIA = np.diag([125, 50, 125]) / 12  # of the paper's cuboid, 5 x 10 x 5 and of mass 1
BOTTOM = np.array([[x, y, -2.5] for x in (-2.5, 2.5) for y in (-5, 5)])
UP = np.array([0.0, 0, 1])
NAN = np.nan


def cuboid(**changes):
    """Slides along +x with a finger on its top and one behind it."""
    contacts = [Contact(p_OC=p, n_O=UP, mode=ContactMode.slide, t_O=[1, 0, 0]) for p in BOTTOM]
    fingers = [
        Finger(p_OC=[5 / 7, 0, 2.5], n_O=-UP, friction=0.7),
        Finger(p_OC=[-2.5, 0, 0], n_O=[1, 0, 0], friction=0.7),
    ]
    given = {
        "contacts": contacts,
        "fingers": fingers,
        "known_wrench_O": mechanics.gravity_wrench(1, [0, 0, -9.8]),
        "wrench_scale": mechanics.wrench_scale(1, INERTIA),
    }
    return ContactSet(**{**given, **changes})


@dataclasses.dataclass
class Arrays:
    """The same cuboid as arrays, N times."""

    N: int

    def keywords(self, **changes):
        given = {
            "points": np.tile(BOTTOM, (self.N, 1, 1)),
            "normals": np.tile(UP, (self.N, 4, 1)),
            "finger_points": np.tile([[5 / 7, 0, 2.5], [-2.5, 0, 0]], (self.N, 1, 1)),
            "finger_normals": np.tile([-UP, [1, 0, 0]], (self.N, 1, 1)),
            "mass": 1.0,
            "inertia": INERTIA,
            "finger_friction": 0.7,
            "sliding": np.tile([1.0, 0, 0], (self.N, 4, 1)),
            "gravity": (0, 0, -9.8),
        }
        return {**given, **changes}


def test_engines_give_the_same():
    for modes in itertools.product(FingerMode, repeat=2):
        fast = mechanics.max_stability(cuboid(), modes)
        reference = mechanics.max_stability(cuboid(), modes, engine=Engine.reference)
        assert fast.z == pytest.approx(reference.z, abs=1e-9)
        assert fast.z > 1
        bounded = [
            mechanics.internal_force_is_bounded(cuboid(), modes, engine=engine) for engine in Engine
        ]
        assert bounded[0] == bounded[1]


def test_ties_go_to_force_on_the_finger_that_presses():
    best = mechanics.best_control_modes(cuboid())
    assert best
    assert best.modes == (FORCE, POSITION)
    again = mechanics.best_control_modes([cuboid(), cuboid()])
    assert [found.stability.z for found in again] == pytest.approx(
        [best.stability.z] * 2, rel=1e-12
    )


@pytest.mark.parametrize(
    "equilibrium", [mechanics.interior_equilibrium, mechanics.compliant_equilibrium]
)
def test_nominal_forces_balance(equilibrium):
    best = mechanics.best_control_modes(cuboid())
    nominal = equilibrium(cuboid(), best.modes, best.stability.commanded_forces)
    forces = np.vstack([nominal.contact_forces_O, nominal.finger_forces_O])
    points = np.vstack([BOTTOM, [f.p_OC for f in cuboid().fingers]])
    np.testing.assert_allclose(forces.sum(axis=0), [0, 0, 9.8], atol=1e-9)
    np.testing.assert_allclose(np.cross(points, forces).sum(axis=0), 0, atol=1e-9)
    assert nominal.margin > 0
    springs = mechanics.compliant_stability(cuboid(), best.modes, nominal)
    assert 0 < springs < best.stability.z
    stiff = Compliance(environment_normal=5e6)
    assert mechanics.compliant_stability(cuboid(), best.modes, nominal, stiff) != springs
    assert equilibrium(cuboid(fingers=[]), [], []) is None


def test_springs_withstand_more_with_room_where_they_ask_for_it():
    best = mechanics.best_control_modes(cuboid())
    forces = best.stability.commanded_forces
    even = mechanics.interior_equilibrium(cuboid(), best.modes, forces)
    asked = mechanics.compliant_equilibrium(cuboid(), best.modes, forces)
    withstands = [
        mechanics.compliant_stability(cuboid(), best.modes, nominal) for nominal in (even, asked)
    ]
    assert withstands[1] > 1.2 * withstands[0]


def test_what_is_withstood():
    best = mechanics.best_control_modes(cuboid())
    nominal = mechanics.compliant_equilibrium(cuboid(), best.modes, best.stability.commanded_forces)
    corners = np.array(BOTTOM)
    least = mechanics.withstands(cuboid(), best.modes, nominal)
    assert 0.1 < least < 1.2 * best.stability.z
    directions = mechanics.disturbance_directions()
    of_each = [
        mechanics.withstands(cuboid(), best.modes, nominal, directions=direction[None])
        for direction in directions
    ]
    assert min(of_each) == pytest.approx(least, rel=1e-6)
    tight = mechanics.withstands(cuboid(), best.modes, nominal, points_O=corners, max_yield=1e-6)
    assert tight < least
    assert tight == pytest.approx(
        2 * mechanics.withstands(cuboid(), best.modes, nominal, points_O=corners, max_yield=5e-7)
    )
    with pytest.raises(ValueError, match=r"yield\.distance must be positive"):
        mechanics.withstands(cuboid(), best.modes, nominal, points_O=corners, max_yield=0)


def test_friction_intervals():
    def verdict(upper, needed=0.5):
        return mechanics.holds_over_friction(
            cuboid(),
            [FORCE, POSITION],
            [10, 0],
            environment=FrictionInterval(0.45, upper),
            fingers=FrictionInterval(0.65, 0.75),
            needed=needed,
        )

    good = verdict(0.5)
    assert good
    assert good.least_stability >= 0.5
    bad = verdict(1.5)
    assert not bad
    assert 0.45 <= bad.environment[0] <= 1.5
    assert "friction" in bad.reason


def test_surfaces_have_friction_of_their_own():
    def verdict(*intervals, of_contact=(0, 1, 0, 1)):
        friction = [FrictionInterval(*interval) for interval in intervals]
        return mechanics.holds_over_friction(
            cuboid(),
            [FORCE, POSITION],
            [10, 0],
            environment=Surfaces(friction=friction, of_contact=of_contact),
            fingers=FrictionInterval(0.7, 0.7),
            needed=0.5,
        )

    good = verdict((0.45, 0.5), (0.3, 0.4))
    assert good
    assert good.least_stability >= 0.5
    bad = verdict((0.5, 0.5), (0.3, 9.0))
    assert not bad
    assert bad.environment[0] == 0.5
    assert 0.3 < bad.environment[1] <= 9
    with pytest.raises(ValueError, match="each of the 4 contacts, not of 1"):
        verdict((0.5, 0.5), of_contact=[0])


def test_contact_patches_of_a_sliding_cuboid():
    corners = np.vstack([BOTTOM, BOTTOM * [1, 1, -1]])
    X_WO = np.eye(4)
    X_WO[2, 3] = 2.5
    state = BodyState(X_WO=X_WO, twist_W=[1, 0, 0, 0, 0, 0])
    patches = mechanics.contact_patches(corners, [0, 0, 0], [Plane()], state)
    assert patches.fault == ""
    assert {contact.mode for contact in patches.contacts} == {ContactMode.slide}
    moved = cuboid(contacts=patches.contacts)
    z = mechanics.max_stability(moved, [FORCE, POSITION]).z
    assert z == pytest.approx(mechanics.max_stability(cuboid(), [FORCE, POSITION]).z, abs=1e-9)
    state.twist_W = [0, 0, 0, 1, 0, 0]
    assert "cannot turn" in mechanics.contact_patches(corners, [0, 0, 0], [Plane()], state).fault


def test_cones_and_directions():
    cone = mechanics.friction_cone(UP, 0.5, t_O=[2, 0, 0])
    assert cone.shape == (6, 3)
    np.testing.assert_allclose(cone[0], np.array([0.5, 0, 1]) / np.hypot(1, 0.5))
    np.testing.assert_allclose(mechanics.tangent(UP), [1, 0, 0])
    directions = mechanics.disturbance_directions()
    assert directions.shape == (76, 6)
    np.testing.assert_allclose(
        np.linalg.norm(directions, axis=1), 2 * np.sqrt(3 - np.sqrt(6)), rtol=1e-12
    )


class TestArrays:
    def test_one_call_gives_what_contact_sets_give(self):
        rng = np.random.default_rng(1)
        points = Arrays(5).keywords()["finger_points"].copy()
        points[:, 0, :2] += rng.uniform(-1, 1, (5, 2))
        found = mechanics.stability(**Arrays(5).keywords(finger_points=points))
        assert found.z.shape == (5,)
        assert found.modes.shape == found.commanded_forces.shape == (5, 2)
        for i, p in enumerate(points):
            fingers = [Finger(p_OC=q, n_O=f.n_O, friction=0.7) for q, f in zip(p, cuboid().fingers, strict=True)]  # fmt: skip
            one = mechanics.best_control_modes(cuboid(fingers=fingers))
            assert found.z[i] == pytest.approx(one.stability.z, abs=1e-12)
            assert list(found.modes[i]) == [mode.name for mode in one.modes]
            np.testing.assert_allclose(found.commanded_forces[i], one.stability.commanded_forces)

    def test_what_does_not_hold_has_none(self):
        gone = {"finger_points": np.zeros((2, 0, 3)), "finger_normals": np.zeros((2, 0, 3))}
        found = mechanics.stability(**Arrays(2).keywords(**gone))
        np.testing.assert_array_equal(found.z, 0)
        assert found.modes.shape == (2, 0)
        up = np.tile([[0, 0, 1.0], [1, 0, 0]], (1, 1, 1))  # the top finger pulls
        found = mechanics.stability(**Arrays(1).keywords(finger_normals=up, gravity=(0, 0, 9.8)))
        assert found.z == 0
        assert list(found.modes[0]) == ["", ""]

    def test_values_for_each(self):
        same = mechanics.stability(**Arrays(3).keywords())
        each = {
            "friction": np.full((3, 4), 0.5),
            "finger_friction": np.full((3, 2), 0.7),
            "max_normal_force": np.full((3, 2), 10.0),
        }
        np.testing.assert_array_equal(mechanics.stability(**Arrays(3).keywords(**each)).z, same.z)

    @pytest.mark.parametrize(
        ("name", "value", "words"),
        [
            ("points", np.zeros((4, 3)), "points must have shape"),
            ("normals", np.zeros((2, 3, 3)), "normals must have shape"),
            ("finger_points", np.zeros((3, 2, 3)), "finger_points must have shape"),
            ("finger_friction", np.ones(2), "finger_friction must have shape"),
            ("friction", np.nan, "friction must lie in"),
            ("friction", -1.0, "friction must lie in"),
            ("max_normal_force", 0.0, "max_normal_force must lie in"),
            ("max_normal_force", 1e12, "max_normal_force must lie in"),
            ("mass", 0.0, "mass must lie in"),
            ("mass", 1e300, "mass must lie in"),
            ("mass", NAN, "mass must lie in"),
            ("inertia", np.eye(2), "inertia_O must have shape"),
            ("inertia", -np.eye(3), "inertia"),
            ("gravity", (0, 0, NAN), "gravity_O"),
            ("cone_edges", 2, r"cone_edges must lie in \[3, 1000\]"),
            ("directions", np.eye(6), "directions"),
            ("directions", np.full((12, 6), NAN), "directions"),
        ],
    )
    def test_bad_values_are_named(self, name, value, words):
        with pytest.raises(ValueError, match=words):
            mechanics.stability(**Arrays(2).keywords(**{name: value}))

    def test_nan_is_named_by_its_contact(self):
        points = Arrays(2).keywords()["points"].copy()
        points[1, 2, 0] = NAN
        with pytest.raises(ValueError, match=r"contacts\[2\].p_OC must be finite"):
            mechanics.stability(**Arrays(2).keywords(points=points))


class TestBadInput:
    def test_normals_are_normalised_with_a_warning(self):
        z = mechanics.max_stability(cuboid(), [FORCE, POSITION]).z
        contacts = [Contact(p_OC=c.p_OC, n_O=3 * c.n_O, mode=c.mode, t_O=c.t_O) for c in cuboid().contacts]  # fmt: skip
        long = cuboid(contacts=contacts)
        with pytest.warns(UserWarning, match="normals"):
            assert mechanics.max_stability(long, [FORCE, POSITION]).z == pytest.approx(z, abs=1e-9)
        with pytest.raises(ValueError, match=r"contacts\[0\].n_O must be a unit vector"):
            mechanics.validate(long)
        mechanics.validate(mechanics.normalized(long))

    def test_zero_normals_are_refused(self):
        zero = cuboid(fingers=[Finger(p_OC=[0, 0, 0], n_O=[0, 0, 0])])
        for ask in (
            lambda: mechanics.max_stability(zero, [FORCE]),
            lambda: mechanics.best_control_modes(zero),
            lambda: mechanics.internal_force_is_bounded(zero, [FORCE]),
            lambda: mechanics.interior_equilibrium(zero, [FORCE], [1]),
        ):
            with pytest.raises(ValueError, match=r"fingers\[0\].n_O must have a direction"):
                ask()

    @pytest.mark.parametrize("engine", Engine)
    @pytest.mark.parametrize(
        ("changes", "words"),
        [
            ({"contacts": [Contact(p_OC=[0, 0, 0], n_O=UP, friction=-0.1)]}, r"contacts\[0\].friction"),
            ({"contacts": [Contact(p_OC=[0, 0, 0], n_O=UP, friction=NAN)]}, r"contacts\[0\].friction"),
            ({"contacts": [Contact(p_OC=[0, 0, 0], n_O=UP, mode=ContactMode.slide)]}, r"contacts\[0\].t_O"),
            ({"contacts": [Contact(p_OC=[0, 0, 0], n_O=UP, mode=ContactMode.slide, t_O=UP)]}, r"contacts\[0\].t_O"),
            ({"cone_edges": 2}, r"cone_edges must lie in \[3, 1000\]"),
            ({"wrench_scale": np.zeros((6, 6))}, "wrench_scale must be regular"),
        ],
    )  # fmt: skip
    def test_contact_sets(self, changes, words, engine):
        with pytest.raises(ValueError, match=words):
            mechanics.max_stability(cuboid(**changes), [FORCE, POSITION], engine=engine)
        with pytest.raises(ValueError, match=words):
            mechanics.internal_force_is_bounded(cuboid(**changes), [FORCE, POSITION], engine=engine)

    @pytest.mark.parametrize("limit", [0, -1, NAN, np.inf])
    def test_force_limits(self, limit):
        bad = cuboid(fingers=[Finger(p_OC=[0, 0, 0], n_O=UP, max_normal_force=limit)])
        with pytest.raises(ValueError, match=r"fingers\[0\].max_normal_force"):
            mechanics.max_stability(bad, [FORCE])

    def test_five_fingers(self):
        with pytest.raises(ValueError, match="fingers must be at most 4"):
            mechanics.max_stability(cuboid(fingers=[cuboid().fingers[0]] * 5), [FORCE] * 5)

    @pytest.mark.parametrize(
        ("call", "words"),
        [
            (lambda: mechanics.max_stability(cuboid(), [FORCE]), "modes"),
            (lambda: mechanics.max_stability(cuboid(), [FORCE] * 2, directions=np.eye(6)[:, :5]), "directions"),
            (lambda: mechanics.interior_equilibrium(cuboid(), [FORCE] * 2, [1, 11]), r"commanded_forces\[1\]"),
            (lambda: mechanics.interior_equilibrium(cuboid(), [FORCE] * 2, [1]), "commanded_forces"),
            (lambda: Contact(p_OC=[0, 0], n_O=UP), "p_OC has shape"),
            (lambda: Contact(p_OC=[0, 0, NAN], n_O=UP), "p_OC has a value that is not finite"),
            (lambda: ContactSet(contacts=[], fingers=[], wrench_scale=np.eye(3)), "wrench_scale must have shape"),
            (lambda: mechanics.friction_cone(UP, 0.5, 2), "edges"),
            (lambda: mechanics.contact_patches(BOTTOM, [0, 0, 0], [Plane(n_W=[0, 0, 2])], BodyState()), r"planes\[0\].n_W"),
        ],
    )  # fmt: skip
    def test_arguments(self, call, words):
        with pytest.raises(ValueError, match=words):
            call()
