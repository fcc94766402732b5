# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""`graspless ros` without ROS, and the packages that colcon builds. tests/ros has the rest."""

import importlib.util
import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
import yaml

from graspless import robot
from graspless.ros.jobs import Found
from graspless.ros.measured import home_of, joints_of

ROS = pathlib.Path(__file__).parents[2] / "ros"


def run(*arguments):
    command = [sys.executable, "-m", "graspless", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.mark.skipif(importlib.util.find_spec("rclpy") is not None, reason="has ROS")
@pytest.mark.parametrize("what", ["node", "fake-robot", "demo"])
def test_says_how_to_get_ros(what):
    done = run("ros", what)
    assert done.returncode == 2
    assert "rclpy" in done.stderr
    assert "tools/install-ros" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("what", ["node", "fake-robot", "demo"])
def test_help_needs_no_ros(what):
    done = run("ros", what, "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"usage: graspless ros {what} ")


def test_is_listed():
    assert re.search(r"^ +ros +run graspless in ROS 2", run("--help").stdout, re.MULTILINE)
    assert run("ros", "juggle").returncode == 2
    done = run("ros")
    assert done.returncode == 2
    assert done.stderr == "ros: needs the name of what to run (one of: node, fake-robot, demo)\n"


@pytest.mark.parametrize("package", ["graspless_msgs", "wheels/control_msgs", "wheels/tf2_msgs"])
def test_interfaces_are_listed_and_their_packages_declared(package):
    folder = ROS / package
    listed = (folder / "CMakeLists.txt").read_text()
    files = [*folder.glob("*/*.action"), *folder.glob("*/*.msg"), *folder.glob("*/*.srv")]
    assert files
    for file in files:
        assert str(file.relative_to(folder)) in listed
    declared = {each.text for each in ET.parse(folder / "package.xml").iterfind("depend")}
    text = "\n".join(file.read_text() for file in files)
    used = set(re.findall(r"^(\w+)/\w+", text, re.MULTILINE)) - {folder.name}
    assert used <= declared
    for name in used:
        assert f"find_package({name} REQUIRED)" in listed


def test_plans_start_from_measured_joints_as_plans_may_have_them():
    urdf = """<robot name="cart"><link name="a"/><link name="b"/><link name="c"/>
      <joint name="wheel" type="continuous"><parent link="a"/><child link="b"/></joint>
      <joint name="finger" type="prismatic"><parent link="b"/><child link="c"/>
        <limit lower="0" upper="0.04" effort="1" velocity="1"/></joint></robot>"""
    cart = robot.Robot.from_urdf(urdf)
    assert [joints_of(cart)[name].weight for name in cart.joint_names] == [*cart.step_weights]
    measured = {"wheel": 4.71 - 40 * math.pi, "finger": 0.0401, "of another robot": 1.0}
    home = home_of(cart, measured, 0.05)
    assert home == {"wheel": pytest.approx(4.71 - 2 * math.pi), "finger": 0.04}
    assert home_of(cart, {"finger": 0.046}, 0.05) == {"finger": 0.046}  # 6 mm count as 0.06 rad


def test_mimics_of_mimics_follow_the_independent_joint():
    joints = [("a", ""), ("b", '<mimic joint="a" multiplier="-2" offset="0.1"/>')]
    joints += [("c", '<mimic joint="b" multiplier="3" offset="0.5"/>')]
    urdf = '<robot name="hand"><link name="0"/>' + "".join(
        f'<link name="{k}"/><joint name="{name}" type="continuous"><parent link="{k - 1}"/>'
        f'<child link="{k}"/>{mimic}</joint>'
        for k, (name, mimic) in enumerate(joints, start=1)
    )
    hand = robot.Robot.from_urdf(urdf + "</robot>")
    assert home_of(hand, {"a": 1.0, "b": 2.0}, 0.0) == {"a": 1.0}
    rows = np.array([[0.0], [1.0]])
    found = Found(joint_names=["a"], joints=joints_of(hand), positions=rows)
    found.velocities = found.accelerations = rows
    found = found.with_mimics(["c", "a", "unknown"])
    assert found.joint_names == ["a", "c"]
    np.testing.assert_allclose(found.positions, [[0, 0.8], [1, -5.2]])
    np.testing.assert_allclose(found.velocities, [[0, 0], [1, -6]])


def test_controllers_of_a_ur5e_have_their_own_joints():
    config = ROS / "graspless_ros" / "config"
    given = yaml.safe_load((config / "ur5e_robotiq.yaml").read_text())["/**"]["ros__parameters"]
    joints = [joint for name in given["controllers"] for joint in given[name]["joints"]]
    assert len(joints) == len(set(joints)) == 7
    gripper = yaml.safe_load((config / "gripper_controller.yaml").read_text())
    own = gripper["gripper_trajectory_controller"]["ros__parameters"]
    assert own["joints"] == given["gripper"]["joints"]
    assert given["gripper"]["action"].startswith("/gripper_trajectory_controller/")


def test_launch_file_passes_files_that_are_there():
    package = ROS / "graspless_ros"
    tree = ET.parse(package / "launch" / "graspless.launch.xml")
    default = tree.find("arg[@name='parameters']").get("default")
    assert (package / default.rpartition(")/")[2]).is_file()
    command = tree.find("executable").get("cmd")
    names = {arg.get("name") for arg in tree.iterfind("arg")}
    assert set(re.findall(r"\$\(var (\w+)\)", command)) == names
