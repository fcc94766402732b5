# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all simulations share: variations, and the robot as MuJoCo reads it."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path

import mujoco
import numpy as np
import pytest

import graspless
from graspless import TaskError, _data
from graspless.errors import install_command
from graspless.robot import Robot
from graspless.simulation import settings
from graspless.simulation.robots import apply, joint_addresses, robot_spec, untested_pairs
from graspless.simulation.settings import SLIDE_SPREAD, Solver, Spread
from graspless.simulation.variation import Variation, variations

WITH_ROBOT = ["01_slide_card", "02_kr5", "12_t42_tumble", "13_clasp_purse", "17_wam_clasp"]


def test_first_trial_is_nominal_and_the_others_do_not_depend_on_how_many_there_are():
    few, many = variations(3, 7), variations(9, 7)
    assert few[0].is_nominal
    assert few == many[:3]
    assert variations(3, 8)[1] != few[1]


def test_variations_stay_within_the_spread_and_use_it():
    spread = Spread()
    drawn = variations(400, 1)[1:]
    for name in ("friction", "support_friction"):
        factors = [getattr(v, name) for v in drawn]
        assert max(abs(factor - 1) for factor in factors) <= spread.friction
        assert max(abs(factor - 1) for factor in factors) > 0.9 * spread.friction
    assert all(np.hypot(v.x, v.y) <= spread.position for v in drawn)
    assert max(np.hypot(v.x, v.y) for v in drawn) > 0.9 * spread.position
    assert all(abs(v.yaw) <= spread.angle and abs(v.mass - 1) <= spread.mass for v in drawn)
    assert Variation().is_nominal
    assert not any(v.is_nominal for v in drawn)


def test_slides_also_vary_shape_place_and_flexures():
    spread, drawn = SLIDE_SPREAD, variations(400, 1, SLIDE_SPREAD)[1:]
    for name, most in (
        ("thickness", spread.thickness),
        ("flexure_length", spread.flexure),
        ("flexure_stiffness", spread.flexure),
    ):
        factors = np.array([getattr(v, name) for v in drawn])
        assert 0.9 * most < np.abs(factors - 1).max() <= most
    tables = np.array([v.table for v in drawn])
    assert 0.9 * spread.table < np.abs(tables).max() <= spread.table
    coms = [np.hypot(v.com_x, v.com_y) for v in drawn]
    assert 0.9 * spread.com < max(coms) <= spread.com
    lengths = [(v.flexure_length, v.flexure_stiffness) for v in drawn]
    assert abs(np.corrcoef(np.array(lengths).T)[0, 1]) < 0.15
    # What all kinds vary is drawn as without these.
    assert all((v.thickness, v.table) == (1, 0) for v in variations(20, 1))
    assert [v.friction for v in variations(20, 1)[1:]] == [v.friction for v in drawn[:19]]


def test_robot_and_support_have_frictions_of_their_own():
    drawn = variations(400, 1)[1:]
    both = np.array([(v.friction, v.support_friction) for v in drawn])
    assert abs(np.corrcoef(both.T)[0, 1]) < 0.15


def _robot(task):
    return task.arm.robot if task.arm is not None else task.problem.robot


@pytest.mark.parametrize("name", WITH_ROBOT)
def test_mujoco_and_our_own_reader_agree_on_where_every_link_is(name):
    task = graspless.load_task(_data.directory("examples") / f"{name}.yaml")
    robot = _robot(task)
    model = robot_spec(robot, task.fields.robot).compile()
    data = mujoco.MjData(model)
    random = np.random.default_rng(3)
    for _ in range(5):
        q = random.uniform(np.maximum(robot.lower, -3), np.minimum(robot.upper, 3))
        data.qpos[joint_addresses(model, robot)] = q
        for equality in range(model.neq):  # a mimic joint follows: offset and factor
            follower, leader = model.eq_obj1id[equality], model.eq_obj2id[equality]
            offset, factor = model.eq_data[equality][:2]
            followed = data.qpos[model.jnt_qposadr[leader]]
            data.qpos[model.jnt_qposadr[follower]] = offset + factor * followed
        mujoco.mj_kinematics(model, data)
        for X_WL, link in zip(robot.forward(q), robot.frame_names, strict=True):
            body = data.body(link)
            np.testing.assert_allclose(body.xpos, X_WL[:3, 3], atol=1e-9)
            np.testing.assert_allclose(body.xmat.reshape(3, 3), X_WL[:3, :3], atol=1e-9)


def test_a_follower_of_a_mimic_joint_is_limited_by_its_driver_alone():
    task = graspless.load_task(_data.directory("examples") / "01_slide_card.yaml")
    model = robot_spec(_robot(task), task.fields.robot).compile()
    assert model.neq == 1
    assert not model.jnt_limited[model.eq_obj1id].any()


# The first link is a mesh that is not a convex solid, the third a sphere near its hull.
def test_a_hull_does_not_collide_where_its_mesh_does_not(tmp_path):
    corners = ["0 0 0", ".1 0 0", "0 .1 0", "0 0 .02", ".05 .02 0", ".02 .05 0"]
    faces = ["1 2 4", "1 4 3", "2 5 4", "5 6 4", "6 3 4", "1 5 2", "1 6 5", "1 3 6"]
    text = "".join(f"v {v}\n" for v in corners) + "".join(f"f {f}\n" for f in faces)
    (tmp_path / "l.obj").write_text(text)
    inertial = (
        '<inertial><mass value="1"/>'
        '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    )
    shapes = ['<mesh filename="l.obj"/>', '<sphere radius="0.005"/>', '<sphere radius="0.005"/>']
    links = "".join(
        f'<link name="{name}">{inertial}<collision><geometry>{shape}</geometry></collision></link>'
        for name, shape in zip("abc", shapes, strict=True)
    )
    joints = "".join(
        f'<joint name="{child}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
        '<origin xyz="0.05 0.05 0.005"/><axis xyz="0 0 1"/>'
        '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>'
        for parent, child in ("ab", "bc")
    )
    robot = Robot.from_urdf(f'<robot name="r">{links}{joints}</robot>', directory=str(tmp_path))
    assert (0, 2) not in robot.ignored_pairs
    assert untested_pairs(robot) == [(0, 1), (0, 2), (1, 2)]


@pytest.mark.parametrize("name", WITH_ROBOT)
def test_a_robot_that_is_told_to_stand_stands(name):
    task = graspless.load_task(_data.directory("examples") / f"{name}.yaml")
    robot = _robot(task)
    model = robot_spec(robot, task.fields.robot).compile()
    data = mujoco.MjData(model)
    addresses = joint_addresses(model, robot)
    data.qpos[addresses] = data.ctrl[:] = np.clip(0, robot.lower, robot.upper)
    start = data.qpos.copy()
    for _ in range(200):
        mujoco.mj_step(model, data)
    assert np.abs(data.qpos - start)[addresses].max() < 1e-6


def test_the_solver_is_told_all_of_its_settings():
    spec = mujoco.MjSpec()
    apply(spec, Solver(cone="pyramidal", integrator="euler", impratio=7.0, iterations=13))
    option = spec.compile().opt
    assert (option.cone, option.integrator) == (
        mujoco.mjtCone.mjCONE_PYRAMIDAL,
        mujoco.mjtIntegrator.mjINT_EULER,
    )
    assert (option.impratio, option.iterations) == (7, 13)


def test_every_setting_is_read():
    """One that nothing reads says what is not so."""
    room = Path(graspless.simulation.__file__).parent
    sources = [path for path in room.rglob("*.py") if path.name != "settings.py"]
    text = "\n".join(path.read_text() for path in [*sources, room / "settings.py"])
    found = vars(settings).values()
    groups = [t for t in found if isinstance(t, type) and dataclasses.is_dataclass(t)]
    assert len(groups) >= 7
    names = [
        (group.__name__, field.name) for group in groups for field in dataclasses.fields(group)
    ]
    assert [name for name in names if not re.search(rf"\.{name[1]}\b", text)] == []


def test_what_cannot_be_simulated_is_refused():
    task = graspless.load_task(_data.directory("examples") / "01_slide_card.yaml")
    none = graspless.plan(task, iterations=0)
    with pytest.raises(graspless.TaskError, match="not solved: nothing to simulate"):
        graspless.simulate(none)
    plan = graspless.plan(task)
    with pytest.raises(graspless.TaskError, match="trials: 0: should be at least 1"):
        graspless.simulate(plan, trials=0)
    with pytest.raises(graspless.TaskError, match="seed: -1: should not be negative"):
        graspless.simulate(plan, seed=-1)


def test_an_older_mujoco_is_told(monkeypatch, tmp_path):
    plan = graspless.plan(graspless.load_task(_data.directory("examples") / "06_push_block.yaml"))
    monkeypatch.setattr(mujoco, "__version__", "3.3.0")
    words = f"needs mujoco>=4.0, 3.3.0 is installed: {re.escape(install_command('sim'))}"
    with pytest.raises(TaskError, match=words):
        graspless.simulate(plan)
    with pytest.raises(TaskError, match=words):
        graspless.export(plan, tmp_path / "plan.xml", "mujoco")
