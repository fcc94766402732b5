# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes of what a robot returns, names or indices for frames, and what is refused."""

import copy

import numpy as np
import pytest

from graspless.collision import World
from graspless.geometry import Box, PlacedShape, Sphere
from graspless.robot import Ik, Robot, builtin
from graspless.scene import Scene

CUBE = [PlacedShape(Box([0.1, 0.1, 0.1]))]


def at(x, y, z):
    X = np.eye(4)
    X[:3, 3] = x, y, z
    return X


def test_kinematics_have_their_shapes(wam, q_home):
    poses = wam.forward(q_home)
    assert poses.shape == (len(wam.frame_names), 4, 4)
    tip = wam.frame("left_fingertip")
    np.testing.assert_array_equal(wam.pose("left_fingertip", q_home), poses[tip])
    np.testing.assert_array_equal(wam.pose(tip, q_home), poses[tip])
    jacobian = wam.jacobian("left_fingertip", q_home)
    assert jacobian.shape == (6, wam.dof)
    step = 1e-6
    for joint in range(wam.dof):
        moved = q_home.copy()
        moved[joint] += step
        column = (wam.forward(moved)[tip, :3, 3] - poses[tip, :3, 3]) / step
        np.testing.assert_allclose(jacobian[:3, joint], column, atol=1e-5)


def test_jacobians_of_many_configurations_are_those_of_each(wam, q_home):
    rows = wam.clamp(q_home) + np.linspace(0, 0.1, 5)[:, None]
    each = [wam.jacobian("left_fingertip", q) for q in rows]
    np.testing.assert_array_equal(wam.jacobian("left_fingertip", rows), each)
    assert wam.jacobian("left_fingertip", rows[:0]).shape == (0, 6, wam.dof)
    fixed = Robot.from_urdf("<robot name='fixed'><link name='base'/></robot>")
    assert fixed.jacobian("base", np.zeros((3, 0))).shape == (3, 6, 0)
    with pytest.raises(ValueError, match=f"q should have {wam.dof} columns.*not {wam.dof - 1}"):
        wam.jacobian("left_fingertip", rows[:, 1:])
    with pytest.raises(ValueError, match=r"q has shape \(1, 5, "):
        wam.jacobian("left_fingertip", rows[None])
    with pytest.raises(ValueError, match="finite"):
        wam.jacobian("left_fingertip", rows * np.nan)


def test_tables(wam):
    assert len(wam.joint_names) == wam.dof == len(wam.lower) == len(wam.reach("grasp"))
    assert wam.is_within(wam.clamp(wam.upper + 1))
    assert not wam.is_within(wam.upper + 1)
    assert all(0 <= link < len(wam.frame_names) for link, _ in wam.shapes)
    assert all(a < b for a, b in wam.ignored_pairs)
    assert wam.group("arm") == [wam.joint(name) for name in wam.joint_names[:7]]
    assert wam.parent(0) == -1
    np.testing.assert_array_equal(wam.X_WB, np.eye(4))


def test_limits_cannot_be_changed(wam):
    with pytest.raises(ValueError, match="read-only"):
        wam.lower[0] = 100


def test_mounted_elsewhere(wam, q_home):
    with open("urdf/wam_t42.urdf") as file:
        moved = Robot.from_urdf(file.read(), X_WB=at(0, 0, 1))
    np.testing.assert_allclose(moved.pose("grasp", q_home), at(0, 0, 1) @ wam.pose("grasp", q_home))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda robot: robot.frame("hand"), "hand.*hand_base"),
        (lambda robot: robot.joint("j"), "wam_joint_1"),
        (lambda robot: robot.group("arms"), "arms.*arm"),
        (lambda robot: robot.state("shut"), "shut.*open"),
        (lambda robot: robot.forward([0, 0]), r"q has shape \(2,\).*\(8,\).*wam_t42"),
        (lambda robot: robot.forward([np.nan] * 8), "q has a value that is not finite"),
        (lambda robot: robot.pose(99, np.zeros(8)), "frame is 99.*0 to 14"),
        (lambda robot: robot.pose("nothing", np.zeros(8)), "nothing"),
        (lambda robot: Ik(robot, "grasp", [0, 99]), "group must.*not 99"),
        (lambda robot: Ik(robot, "grasp", "legs"), "legs"),
        (lambda robot: Ik(robot, "grasp", "arm", lean=0.2), "lean must lie in .0, 0.1., not 0.2"),
        (lambda robot: Robot.from_urdf("<robot"), "XML|URDF|parse"),
        (lambda robot: Robot.from_urdf_file("nowhere.urdf"), "nowhere.urdf"),
        (lambda robot: Robot.from_urdf("<robot/>", X_WB=np.zeros((4, 4))), "X_WB is not a rigid"),
    ],
)
def test_bad_input_is_a_value_error_that_names_it(wam, call, message):
    with pytest.raises(ValueError, match=message):
        call(wam)


def test_ik_solves_for_rows(wam, q_home):
    ik = Ik(wam, "left_fingertip", "arm", free_samples=8)
    assert ik.group == wam.group("arm")
    X_WF = wam.pose("left_fingertip", q_home)
    solutions = ik.solve_all(X_WF, q_home)
    assert solutions.shape[1] == wam.dof
    assert len(solutions) > 0
    for q in solutions:
        np.testing.assert_allclose(wam.pose("left_fingertip", q), X_WF, atol=1e-6)
    near = ik.solve_near(X_WF, q_home)
    np.testing.assert_allclose(wam.pose("left_fingertip", near), X_WF, atol=1e-6)
    assert ik.solve_near(at(9, 9, 9), q_home) is None
    assert ik.solve_all(at(9, 9, 9), q_home).shape == (0, wam.dof)
    assert ik.is_closed_form
    assert ik.free_joint == 2
    assert ik.solve_free(X_WF, q_home[2], q_home).shape[1] == wam.dof


def test_ik_of_six_joints_has_no_free_joint():
    kr5 = Robot.from_urdf_file(str(builtin("kr5_t42")))
    ik = Ik(kr5, "left_fingertip", "arm")
    assert ik.is_closed_form
    assert ik.free_joint is None
    q = kr5.state("home")
    X_WF = kr5.pose("left_fingertip", q)
    np.testing.assert_array_equal(ik.solve_free(X_WF, 0, q), ik.solve_free(X_WF, 1, q))
    np.testing.assert_allclose(ik.solve_all(X_WF, q)[0], q, atol=1e-9)
    short = Ik(kr5, "left_fingertip", kr5.group("arm")[:5])
    assert not short.is_closed_form
    with pytest.raises(ValueError, match="no closed form"):
        short.solve_free(X_WF, 0, q)


def test_a_link_off_the_path_that_mimics_a_joint_loses_no_solution():
    path = builtin("kr5_t42").with_suffix(".urdf")
    rod = (
        '<link name="rod"/><joint name="rod" type="revolute"><parent link="base_link"/>'
        '<child link="rod"/><axis xyz="0 0 1"/><mimic joint="{}"/>'
        '<limit lower="-9" upper="9" velocity="1" effort="1"/></joint></robot>'
    )
    plain = Robot.from_urdf_file(str(path))
    base = plain.frame_names[0]
    rng = np.random.default_rng(4)
    for joint in range(6):
        text = rod.format(plain.joint_names[joint]).replace("base_link", base)
        mimicked = Robot.from_urdf(path.read_text().replace("</robot>", text))
        own, other = (Ik(each, "left_fingertip", plain.group("arm")) for each in (plain, mimicked))
        for _ in range(10):
            q = rng.uniform(plain.lower, plain.upper)
            X_WF = plain.pose("left_fingertip", q)
            np.testing.assert_allclose(other.solve_all(X_WF, q), own.solve_all(X_WF, q), atol=1e-9)


def test_world_by_name_or_index():
    world = World()
    a, b = world.add_body("a", CUBE), world.add_body("b", [PlacedShape(Sphere(0.1))])
    world.add_pair("a", "b")
    assert world.collides()
    world.set_pose("b", at(1, 0, 0))
    np.testing.assert_array_equal(world.pose(b), at(1, 0, 0))
    assert not world.collides()
    assert world.pairs == [(a, b)]
    assert 0 <= world.distance_bounds()[0] <= 0.85
    twin = copy.copy(world)
    twin.set_pose("b", np.eye(4))
    assert twin.all_collisions() == [(a, b)]
    assert not world.collides()


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda world: world.body("c"), "c.*a"),
        (lambda world: world.pose(2), "must be the index of one of the world.s 2 bodies, not 2"),
        (lambda world: world.add_body("a", CUBE), "a"),
        (lambda world: world.allow_contact("a", "b", [0, 0, 1], -1), "depth"),
        (lambda world: world.allow_contact("a", "b", [0, 0, 0], 1), "normal"),
        (lambda world: world.set_pose("a", np.eye(4) * np.nan), "X_WB has a value"),
    ],
)
def test_world_refuses(call, message):
    world = World()
    world.add_body("a", CUBE)
    world.add_body("b", CUBE)
    world.add_pair(0, 1)
    with pytest.raises(ValueError, match=message):
        call(world)


def test_scene(wam, q_home):
    scene = Scene(wam)
    assert scene.is_free(q_home)
    hand = wam.pose("grasp", q_home)
    scene.add_obstacle("cube", CUBE, hand)
    assert not scene.is_free(q_home)
    assert "cube" in scene.collision(q_home)
    assert scene.collision(np.zeros(wam.dof)) is None
    assert not scene.is_free(np.zeros(wam.dof), q_home)
    assert scene.world.body("cube") == scene.world.num_bodies - 1
    card = scene.add_object("card", [PlacedShape(Box([0.1, 0.1, 0.01]))])
    scene.attach(card, "hand_base", at(0, 0, 0.3), touching=["left_finger", "right_finger"])
    scene.detach("card")
    with pytest.raises(ValueError, match="bodies"):
        scene.detach(99)
    with pytest.raises(ValueError, match="link"):
        scene.attach(card, 99, np.eye(4), [])
