# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots as they come: stock SRDFs, packages, descriptions by name, arm and gripper joined."""

import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import warnings

import numpy as np
import pytest

from graspless import TaskError, cli, robot
from graspless.cli.robot_inspect import require_used
from graspless.errors import install_command
from graspless.tasks import robots
from graspless.tasks.robot_files import resolve_robot
from graspless.tasks.robots import Robot, build_robot, require_text
from graspless.tasks.shapes import Pose
from graspless.tasks.source import Source

CUBE = """\
o cube
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
l 1 7
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""

ARM = """\
<robot name="arm">
  <link name="world"/>
  <link name="base">
    <collision><geometry><mesh filename="package://my_arm/meshes/cube.obj"/></geometry></collision>
  </link>
  <link name="tool"/>
  <joint name="fix" type="floating"><parent link="world"/><child link="base"/></joint>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="tool"/><origin xyz="0 0 2"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" velocity="1" effort="1"/>
  </joint>
</robot>
"""

GRIPPER = """\
<robot name="gripper">
  <link name="base">
    <collision><geometry><mesh filename="cube.obj" scale="0.1 0.1 0.1"/></geometry></collision>
  </link>
  <link name="finger"/>
  <joint name="slide" type="prismatic">
    <parent link="base"/><child link="finger"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.04" velocity="1" effort="1"/>
  </joint>
</robot>
"""


@pytest.fixture
def folder(tmp_path):
    """An arm in a ROS package, and a gripper with a mesh beside it."""
    (tmp_path / "my_arm/urdf").mkdir(parents=True)
    (tmp_path / "my_arm/meshes").mkdir()
    (tmp_path / "my_arm/meshes/cube.obj").write_text(CUBE)
    (tmp_path / "my_arm/urdf/arm.urdf").write_text(ARM)
    (tmp_path / "gripper.urdf").write_text(GRIPPER)
    (tmp_path / "cube.obj").write_text(CUBE)
    return tmp_path


def resolved(folder, given):
    source = Source("task.yaml", {"robot": given})
    found, _ = resolve_robot(Robot.model_validate(given), source, folder)
    return found, source


@pytest.fixture
def quick(monkeypatch):
    """Files count as old enough at once."""
    monkeypatch.setattr(robots, "SURE", -60_000_000_000)


@pytest.mark.usefixtures("quick")
def test_robots_are_built_once_until_a_mesh_changes(folder):
    fields, _ = resolved(folder, {"urdf": str(folder / "my_arm/urdf/arm.urdf")})
    source = Source("task.yaml", {"robot": {}})
    first = build_robot(fields, source)
    assert build_robot(fields, source) is first
    moved = fields.model_copy(update={"pose": Pose(position=[1.0, 0.0, 0.0])})
    assert build_robot(moved, source).X_WB[0, 3] == 1
    assert build_robot(fields, source) is first
    mesh = folder / "my_arm/meshes/cube.obj"
    before = mesh.stat()
    mesh.write_text(CUBE.replace("v 0 0 1", "v 0 0 3"))  # as long as before
    os.utime(mesh, ns=(before.st_atime_ns, before.st_mtime_ns))  # as an archive may do
    changed = build_robot(fields, source)
    heights = [built.shapes[0][1].shape.vertices[:, 2].max() for built in (first, changed)]
    assert heights == [1, 3]
    assert build_robot(fields, source) is changed
    mesh.unlink()
    with pytest.raises(TaskError, match=r"cube\.obj"):
        build_robot(fields, source)


def test_a_mesh_that_was_just_written_is_read_again(folder):
    fields, _ = resolved(folder, {"urdf": str(folder / "my_arm/urdf/arm.urdf")})
    source = Source("task.yaml", {"robot": {}})
    assert build_robot(fields, source) is not build_robot(fields, source)


@pytest.mark.usefixtures("quick")
def test_few_robots_are_kept(folder):
    fields, _ = resolved(folder, {"urdf": str(folder / "my_arm/urdf/arm.urdf")})
    source = Source("task.yaml", {"robot": {}})
    first = build_robot(fields, source)
    for x in range(robots.MOST_KNOWN):
        pose = Pose(position=[1.0 + x, 0.0, 0.0])
        build_robot(fields.model_copy(update={"pose": pose}), source)
    assert build_robot(fields, source) is not first


def built(folder, given):
    return build_robot(*resolved(folder, given))


def refused(folder, given):
    with pytest.raises(TaskError) as error:
        built(folder, given)
    assert "\n" not in str(error.value)
    return str(error.value)


def test_the_only_urdf_of_a_folder_is_suggested(folder):
    said = refused(folder, {"urdf": "my_arm/urdf"})
    assert said.endswith("is a folder, not a file; did you mean my_arm/urdf/arm.urdf?")
    assert refused(folder, {"urdf": "my_arm"}).endswith("is a folder, not a file")


def test_packages_are_found_beside_the_urdf(folder):
    with pytest.warns(UserWarning, match="joint 'fix' is of type 'floating'; treated as fixed"):
        arm = built(folder, {"urdf": "my_arm/urdf/arm.urdf"})
    assert arm.packages == {"my_arm": str(folder / "my_arm")}
    assert len(arm.shapes) == 1
    assert arm.joint_names == ["turn"]
    assert robot.Robot.from_urdf_file(str(folder / "my_arm/urdf/arm.urdf")).packages == arm.packages


def test_missing_package_says_where_it_was_looked_for(folder, monkeypatch):
    (folder / "my_arm").rename(folder / "other")
    shutil.rmtree(folder / "other/meshes")
    monkeypatch.setenv("ROS_PACKAGE_PATH", "/opt/none")
    said = refused(folder, {"urdf": "other/urdf/arm.urdf"})
    for part in (
        "task.yaml: robot.urdf",
        "link 'base'",
        "package 'my_arm' was not found",
        "ROS_PACKAGE_PATH (/opt/none)",
        "AMENT_PREFIX_PATH",
        str(folder / "other/urdf"),
    ):
        assert part in said


def test_stock_srdf_is_read_and_its_faults_are_told(folder):
    (folder / "gripper.srdf").write_text(
        "<robot name='gripper'><group name='hand'><joint name='slide'/></group>"
        "<group name='ghost'><joint name='none'/></group>"
        "<disable_collisions link1='base' link2='none'/>"
        "<group_state name='open' group='hand'><joint name='slide' value='0.04'/></group_state>"
        "<group_state name='wide' group='hand'><joint name='slide' value='9'/></group_state></robot>"
    )
    with pytest.warns(
        UserWarning, match="the URDF has no joint 'none'; skipped. Robot.warnings has 2 more$"
    ):
        gripper = built(folder, {"urdf": "gripper.urdf"})
    assert len(gripper.warnings) == 3
    assert gripper.group_names == ["hand"]
    assert gripper.state("open").tolist() == [0.04]
    with pytest.raises(ValueError, match="group 'ghost' cannot be used: .* no joint 'none'"):
        gripper.group("ghost")
    with pytest.raises(ValueError, match="state 'wide' cannot be used: .*9 is outside its limits"):
        gripper.state("wide")


def test_faults_of_an_srdf_name_its_file(folder):
    srdf = folder / "gripper.srdf"
    srdf.write_text(
        "<robot name='gripper'>\n"
        "<group_state name='home' group='hand'><joint name='none' value='9'/></group_state></robot>"
    )
    text = f"{re.escape(str(srdf))} line 2: the SRDF has no group 'hand'"
    with pytest.warns(UserWarning, match=f"robot.urdf: .*: {text}; skipped$"):
        built(folder, {"urdf": "gripper.urdf"})
    made, source = resolved(folder, {"urdf": "gripper.urdf"})
    home = robots.build_home
    with pytest.raises(TaskError, match=f"robot.home: state 'home' cannot be used: {text}$"):
        home(made, build_robot(made, source, warn=False), source)


def test_links_without_collision_shapes_are_told_first(folder):
    file = folder / "my_arm/urdf/arm.urdf"
    seen = '<link name="tool"><visual><geometry><sphere radius="1"/></geometry></visual></link>'
    text = ARM.replace('<link name="tool"/>', seen).replace('velocity="1"', 'velocity="0"')
    file.write_text(text)
    what = "links with a <visual> but no <collision>, .*: 'tool'; .*. Robot.warnings has 2 more$"
    with pytest.warns(UserWarning, match=what):
        arm = built(folder, {"urdf": str(file)})
    assert "treated as fixed" in arm.warnings[1]
    assert arm.warnings[2].endswith("in rad/s or m/s: joints 'turn'")


def with_limits(folder, limits, kind="revolute"):
    file = folder / "my_arm/urdf/arm.urdf"
    text = ARM.replace("floating", "fixed").replace("revolute", kind)
    assert 'lower="-2" upper="2"' in text
    file.write_text(text.replace('lower="-2" upper="2"', limits))
    return resolved(folder, {"urdf": str(file)})


def test_limits_in_degrees_are_told(folder):
    text = r"robot.urdf: .*arm.urdf: joint 'turn' turns from -170 to 170 rad; limits in a URDF are"
    with pytest.warns(UserWarning, match=text):
        build_robot(*with_limits(folder, 'lower="-170" upper="170"'))


@pytest.mark.parametrize("kind", ["continuous", "prismatic"])
def test_limits_of_other_joints_are_not_told(folder, kind):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        build_robot(*with_limits(folder, 'lower="-170" upper="170"', kind))


def test_limits_too_large_to_compute_with_are_refused(folder):
    text = r"robot.urdf: .*: joint 'turn' has a limit of -1e\+308: should lie in \[-1e\+30, 1e\+"
    with pytest.raises(TaskError, match=text):
        build_robot(*with_limits(folder, 'lower="-1e308" upper="1e308"'))


@pytest.mark.filterwarnings("ignore:.*treated as fixed")
def test_joins_arm_and_gripper(folder):
    pose = {"position": [0.1, 0, 0], "rpy": [0, 0, math.pi / 2]}
    given = {"arm": "my_arm/urdf/arm.urdf", "gripper": {"file": "gripper.urdf", "mount": "tool"}}
    given["gripper"]["pose"] = pose
    fields, _ = resolved(folder, given)
    assert fields.gripper is None  # a plan file names no file
    joined = built(folder, given)
    assert joined.joint_names == ["turn", "slide"]
    assert joined.frame_names == ["world", "base", "tool", "gripper_base", "finger"]
    assert len(joined.shapes) == 2
    np.testing.assert_allclose(joined.pose("finger", [0, 0.04])[:3, 3], [0.06, 0, 2], atol=1e-12)
    shutil.copy(folder / "gripper.urdf", folder / "left.urdf")
    given["gripper"] |= {"file": "left.urdf", "prefix": "left_"}
    assert built(folder, given).joint_names == ["turn", "left_slide"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"mount": "flange"},
            "robot.gripper: unknown mount 'flange'; choose from base, tool, world",
        ),
        ({"file": "none.urdf"}, "robot.gripper.file: none.urdf: no such file"),
        ({"srdf": "none.srdf"}, "robot.gripper.srdf: none.srdf: no such file"),
        ({"packages": {"a": "none"}}, "robot.gripper.packages.a: none: no such folder"),
        ({"file": "cube.obj"}, "robot.gripper: gripper: URDF"),
    ],
)
def test_refuses_grippers(folder, change, message):
    gripper = {"file": "gripper.urdf", "mount": "tool"} | change
    assert message in refused(folder, {"arm": "my_arm/urdf/arm.urdf", "gripper": gripper})


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"arm": "a.urdf"}, "arm needs a gripper"),
        ({"arm": "a.urdf", "urdf": "a.urdf"}, "exactly one of urdf, name, arm, urdf_text"),
        (
            {"urdf_text": "x", "gripper": {"file": "a", "mount": "b"}},
            "cannot be mounted on a urdf_text",
        ),
        ({"urdf": "a", "gripper": {"mount": "b"}}, "exactly one of file, name"),
    ],
)
def test_refuses_fields_of_robots(given, message):
    with pytest.raises(ValueError, match=message):
        Robot.model_validate(given)


def test_faults_of_a_gripper_are_told_of_its_file(folder):
    file = folder / "my_arm/urdf/arm.urdf"
    file.write_text(ARM.replace("floating", "fixed"))
    given = {"arm": str(file), "gripper": {"file": "gripper.urdf", "mount": "tool"}}
    place = r"robot.gripper.file: gripper.urdf: "
    limits = 'lower="0" upper="0.04" velocity="1" effort="1"'
    for change, fault in (
        ('lower="1" upper="0"', "joint 'slide': lower"),
        ('lower="-1e308" upper="1"', "joint 'slide' has a limit of -1e.308"),
    ):
        (folder / "gripper.urdf").write_text(GRIPPER.replace('lower="0" upper="0.04"', change))
        with pytest.raises(TaskError, match=place + fault):
            built(folder, given)
    (folder / "gripper.urdf").write_text(GRIPPER.replace(limits, limits.replace('t="1"', 't="-5"')))
    with pytest.warns(UserWarning, match=place + "the effort limit of joint 'slide' is -5"):
        built(folder, given)
    (folder / "gripper.urdf").write_text(GRIPPER)
    file.write_text(ARM.replace("floating", "fixed").replace('effort="1"', 'effort="-5"'))
    with pytest.warns(
        UserWarning, match=r"robot.arm: .*arm.urdf: the effort limit of joint 'turn'"
    ):
        built(folder, given)


def test_join_warns_of_millimetres_and_degrees(folder, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    command = ["robot", "join", "my_arm/urdf/arm.urdf", "gripper.urdf", "--mount", "tool"]
    assert cli.main([*command, "--xyz", "0", "0", "50", "--rpy", "0", "0", "90", "-o", "-"]) == 0
    said = capsys.readouterr().err
    assert "robot.gripper.pose.position: is 50 m away; lengths are in metres" in said
    assert "robot.gripper.pose.rpy[2]: 90.0: is more than a turn; angles are in radians" in said


def test_join_writes_urdf_and_srdf(folder, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    (folder / "gripper.srdf").write_text("<robot name='g'><group name='hand'/></robot>")
    command = ["robot", "join", "my_arm/urdf/arm.urdf", "gripper.urdf", "--mount", "tool"]
    (folder / "deep").mkdir()
    assert cli.main([*command, "--xyz", "0", "0", "-0.5", "-o", "deep/joined.urdf"]) == 0
    out = capsys.readouterr()
    assert "arm_gripper: 2 joints, 5 links" in out.out
    assert "warning: robot join: robot.arm" in out.err
    joined = robot.Robot.from_urdf_file(str(folder / "deep/joined.urdf"))
    assert joined.group_names == ["hand"]
    assert len(joined.shapes) == 2
    assert joined.pose("finger", [0, 0])[2, 3] == 1.5
    assert cli.main([*command, "-o", "-"]) == 0
    assert capsys.readouterr().out == (
        subprocess.run(
            [sys.executable, "-m", "graspless", *command, "-o", "-"], capture_output=True, text=True
        ).stdout
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--mount", "none"], "unknown mount 'none'; choose from base, tool, world"),
        (["--mount", "tool", "-o", "joined.txt"], "--output: joined.txt: should end in .urdf"),
        (["--mount", "tool", "--package", "x"], "--package: x: should be NAME=DIR"),
        (
            ["--mount", "tool", "--package", "my_amr=my_arm"],
            "--package: my_amr: has no effect: no package://my_amr/ in arm.urdf or gripper.urdf; "
            "did you mean 'my_arm'? (one of: my_arm)",
        ),
        (["--mount", "tool", "-o", "none/joined.urdf"], "there is no folder none"),
        (["--mount", "tool", "--xyz", "0", "nan", "0"], "gripper.pose.position[1]: nan: should be"),
    ],
)
def test_join_refuses(folder, capsys, monkeypatch, arguments, message):
    monkeypatch.chdir(folder)
    assert cli.main(["robot", "join", "my_arm/urdf/arm.urdf", "gripper.urdf", *arguments]) == 2
    assert message in capsys.readouterr().err.splitlines()[-1]
    assert not list(folder.glob("joined*"))


def test_packages_that_may_be_used_are_taken(folder, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    join = ["robot", "join", "my_arm/urdf/arm.urdf", "gripper.urdf", "--mount", "tool"]
    assert cli.main([*join, "--package", "my_arm=my_arm"]) == 0
    (folder / "plain.urdf").write_text("<robot name='plain'/>")
    options = argparse.Namespace(package=["other=."])
    with pytest.raises(TaskError, match=r"no package://other/ in plain.urdf$"):
        require_used(options, folder / "plain.urdf")
    (folder / "plain.srdf.xacro").write_text("")
    require_used(options, folder / "plain.urdf")  # the xacro file may use it


def test_join_leaves_no_srdf_of_other_robots(folder, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    for path in folder.rglob("*.srdf"):
        path.unlink()
    (folder / "joined.srdf").write_text("<robot name='other'/>")
    command = ["robot", "join", "my_arm/urdf/arm.urdf", "gripper.urdf", "--mount", "tool"]
    assert cli.main(command) == 2
    assert "--output: joined.srdf: neither robot has an SRDF" in capsys.readouterr().err
    assert not (folder / "joined.urdf").exists()
    (folder / "joined.srdf").unlink()
    assert cli.main(command) == 0


FAKE = """\
PACKAGE_PATH = {package!r}
REPOSITORY_PATH = {repository!r}
"""


@pytest.fixture
def descriptions(folder, monkeypatch):
    """A package robot_descriptions with three robots, as if downloaded."""
    package = folder / "site/robot_descriptions"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("")
    paths = FAKE.format(package=str(folder / "my_arm"), repository=str(folder))
    urdf = f"URDF_PATH = {str(folder / 'my_arm/urdf/arm.urdf')!r}\n"
    (package / "arm_description.py").write_text("print('Cloning')\n" + paths + urdf)
    (package / "arm_mj_description.py").write_text(paths)
    (package / "far_description.py").write_text("raise OSError(5, 'no network')\n")
    xacro = f"XACRO_PATH = {str(folder / 'my_arm/gripper.xacro')!r}\nXACRO_ARGS = {{'wide': 0.2}}\n"
    (package / "gripper_description.py").write_text(paths + xacro)
    (folder / "my_arm/gripper.xacro").write_text(
        '<robot name="g" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="wide" '
        'default="1"/><link name="palm"><collision><geometry><box size="$(arg wide) 1 1"/>'
        '</geometry></collision><visual><geometry><mesh filename="$(find arm_pkg)/a.stl"/>'
        "</geometry></visual></link></robot>"
    )
    (folder / "my_arm/package.xml").write_text("<package><name>arm_pkg</name></package>")
    monkeypatch.syspath_prepend(str(folder / "site"))
    for name in [name for name in sys.modules if name.startswith("robot_descriptions")]:
        monkeypatch.delitem(sys.modules, name)
    yield folder
    for name in [name for name in sys.modules if name.startswith("robot_descriptions")]:
        del sys.modules[name]


@pytest.mark.filterwarnings("ignore:.*treated as fixed")
def test_robots_by_name(descriptions, capsys):
    arm = built(descriptions, {"name": "arm_description"})
    assert len(arm.shapes) == 1
    assert capsys.readouterr().out == ""  # which may be a plan
    joined = built(
        descriptions,
        {"name": "arm_description", "gripper": {"name": "gripper_description", "mount": "tool"}},
    )
    assert joined.frame_names[-1] == "palm"
    assert joined.shapes[1][1].shape.size[0] == 0.2
    assert built(descriptions, {"name": "wam_t42"}).name == "wam_t42"
    found = robot.described("arm_description")
    assert found.urdf == descriptions / "my_arm/urdf/arm.urdf"
    assert found.packages["arm_pkg"] == str(descriptions / "my_arm")


@pytest.mark.parametrize(
    ("name", "message"),
    [
        (
            "arm",
            "robot.name: arm: no such robot in robot_descriptions; did you mean 'arm_description'",
        ),
        ("os.path", "robot.name: os.path: no such robot in robot_descriptions"),
        ("arm_mj_description", "robot.name: arm_mj_description: has no URDF"),
        ("far_description", "far_description: cannot be downloaded: no network; it needs git and"),
    ],
)
def test_refuses_names(descriptions, name, message):
    assert message in refused(descriptions, {"name": name})


def test_names_need_the_extra(folder, monkeypatch):
    monkeypatch.setitem(sys.modules, "robot_descriptions", None)
    said = refused(folder, {"name": "panda_description"})
    assert "needs robot_descriptions for robots by name: " in said
    assert install_command("robots") in said


@pytest.mark.parametrize(
    "given",
    [
        {"name": "panda_description"},
        {"arm": "a.urdf", "gripper": {"file": "b.urdf", "mount": "c"}},
    ],
)
def test_plan_files_name_no_robot(given):
    with pytest.raises(TaskError, match="must be part of the plan file"):
        require_text(Robot.model_validate(given), Source("plan.json", {"robot": given}))
