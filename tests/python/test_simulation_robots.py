# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots of other people in MuJoCo: their root links, names and masses."""

import warnings

import mujoco
import numpy as np
import pytest

import graspless
import inspect_common as small
from graspless import TaskError, frames
from graspless.formats import mujoco_scene
from graspless.robot import Robot
from graspless.ros.fake_world import World
from graspless.simulation.robots import joint_addresses, robot_spec
from graspless.simulation.slide.scene import build_scene
from graspless.simulation.variation import Variation
from graspless.tasks.robots import Robot as Fields
from graspless.view.bodies import robot_bodies

INERTIAL = (
    '<inertial><mass value="0.5"/>'
    '<inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>'
)
CARD = """
kind: slide
robot:   {urdf: mine.urdf}
object:  {rectangle: {size: [0.1, 0.06]}, thickness: 0.003, pose: {x: 0.42, y: 0.05, yaw: 0.3}}
support: {rectangle: {center: [0.45, 0.0], size: [0.4, 0.5]}}
"""


def heavy(urdf):
    """A URDF whose links all have a mass."""
    return urdf.replace("</link>", f"{INERTIAL}</link>")


@pytest.fixture(scope="module")
def plan_of(tmp_path_factory):
    def made(urdf):
        folder = tmp_path_factory.mktemp("robot")
        (folder / "mine.urdf").write_text(urdf)
        (folder / "card.yaml").write_text(CARD)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = graspless.plan(folder / "card.yaml")
        assert found, found.reason
        return found

    return made


def test_a_root_link_called_world_is_moved_too():
    mount = small.joint("mount_of_base", "fixed", "world", "base", "0.1 0 0.02")
    world = small.box("world", "0 0 -0.1", "0.1 0.1 0.02")
    urdf = heavy(small.robot("r", world, mount, small.base(), small.arm(), small.prismatic()))
    X_WB = frames.translation([0.3, 0.2, 0.5]) @ frames.from_rpy([0.0, 0.0, 0.7])
    robot = Robot.from_urdf(urdf, X_WB=X_WB)
    model = robot_spec(robot, Fields(urdf_text=urdf)).compile()
    data = mujoco.MjData(model)
    q = np.linspace(-0.4, 0.6, robot.dof).clip(robot.lower, robot.upper)
    data.qpos[joint_addresses(model, robot)] = q
    mujoco.mj_kinematics(model, data)
    np.testing.assert_allclose(data.body("wrist").xpos, robot.pose("wrist", q)[:3, 3], atol=1e-9)
    shape = X_WB @ [0.0, 0.0, -0.1, 1.0]
    assert np.linalg.norm(data.geom_xpos - shape[:3], axis=1).min() < 1e-9


def test_names_of_shapes_may_be_ours(plan_of):
    urdf = heavy(small.gripper())
    for link, name in (
        ("link_0", "table_top"),
        ("left", "pad"),
        ("right", "pad"),
        ("palm", "foot"),
    ):
        urdf = urdf.replace(
            f'<link name="{link}"><collision>', f'<link name="{link}"><collision name="{name}">'
        )
    groups = build_scene(plan_of(urdf), Variation()).groups
    expected = build_scene(plan_of(heavy(small.gripper())), Variation()).groups
    assert {role: len(geoms) for role, geoms in groups.items()} == {
        role: len(geoms) for role, geoms in expected.items()
    }


def test_a_link_with_the_name_of_another_body_is_named(plan_of, tmp_path, monkeypatch):
    said = "link '{}' has the name of another body of the simulation: rename it in the URDF"
    plan = plan_of(heavy(small.gripper()).replace('"link_0"', '"table"'))
    with pytest.raises(TaskError, match=said.format("table")):
        graspless.simulate(plan)
    monkeypatch.setattr(mujoco_scene, "OBJECT", "palm")
    with pytest.raises(TaskError, match=said.format("palm")):
        graspless.export(plan, tmp_path / "folder", "mujoco")


def test_a_finger_without_a_mass_is_refused(plan_of):
    link = small.box("left", "0 0.005 0.04", "0.02 0.01 0.08").strip()
    urdf = heavy(small.gripper())
    light = urdf.replace(heavy(link), link)
    assert light != urdf
    with pytest.raises(TaskError, match="link 'left' has no mass; the simulation needs its <inert"):
        build_scene(plan_of(light), Variation())


def write_with_srdf(folder, urdf):
    """Writes a robot with a state `home`; returns the path of its URDF."""
    (folder / "mine.urdf").write_text(urdf)
    (folder / "mine.srdf").write_text(
        '<robot name="mine"><group name="arm"><joint name="joint_0"/></group>'
        '<group_state name="home" group="arm"><joint name="joint_0" value="0"/></group_state>'
        "</robot>"
    )
    return str(folder / "mine.urdf")


def test_a_link_with_the_name_of_a_block_is_named_in_the_world_of_ros(tmp_path):
    path = write_with_srdf(tmp_path, heavy(small.gripper()).replace('"link_0"', '"table"'))
    with pytest.raises(TaskError, match="link 'table' has the name of another body of the sim"):
        World(path)


def test_a_link_that_moves_without_a_mass_is_named_in_the_world_of_ros(tmp_path):
    write_with_srdf(tmp_path, small.gripper())  # its link_3 has no shape either
    with pytest.raises(TaskError, match="link 'link_3' moves and has no mass or inertia"):
        World(str(tmp_path / "mine.urdf"), ())
    (tmp_path / "mine.urdf").write_text(heavy(small.gripper()))
    assert World(str(tmp_path / "mine.urdf"), ()).joint_names[0] == "joint_0"


def test_all_links_of_a_finger_may_touch_the_object(plan_of):
    nail = small.box("nail", "0 -0.012 0.07", "0.02 0.004 0.02")
    nail += small.joint("glue", "fixed", "right", "nail")
    plan = plan_of(heavy(small.gripper(hand=small.prismatic() + nail)))
    assert list(plan.task.problem.hand.fingers) == ["left", "right", "nail"]
    scene = build_scene(plan, Variation())
    model, geoms = scene.model, scene.groups["other finger"]
    bodies = {model.body(model.geom_bodyid[geom]).name for geom in geoms}
    assert bodies == {"other finger", "right"}
    assert (model.geom_contype[geoms] > 0).all()


def test_elements_with_prefixes_are_read():
    urdf = heavy(small.gripper()).replace(
        "</robot>", '<gazebo><controller:force name="x"/></gazebo></robot>'
    )
    fields = Fields(urdf_text=urdf)
    robot = Robot.from_urdf(urdf)
    assert robot_spec(robot, fields).compile().nbody == len(robot.frame_names) + 1
    assert len(robot_bodies(robot, fields)) == len(robot.frame_names)
