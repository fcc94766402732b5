# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether two tasks say the same: what their robots hold counts, not where they stand."""

import pytest

from graspless.tasks.digest import digest
from graspless.tasks.meshes import checksums
from graspless.tasks.robot_files import resolve_robot
from graspless.tasks.robots import Robot, robot_meshes
from graspless.tasks.source import Source
from graspless_bench.physics.work import Query

ARM = """<robot name="arm" xmlns:xacro="http://ros.org/wiki/xacro">
<!-- made in {folder} --><link name="base"/><link name="hand">{shape}</link></robot>"""
MESHES = """<collision><geometry><mesh filename="package://own/a.obj"/></geometry></collision>
<visual><geometry><mesh filename="b.obj"/></geometry></visual>"""


def document(folder, shape="", urdf="arm.urdf", meshes="ab"):
    """Of a task whose robot stands in a folder with its meshes."""
    (folder / "own").mkdir(parents=True, exist_ok=True)
    for path in (folder / urdf, folder / "arm.srdf"):
        path.write_text(ARM.format(folder=folder, shape=shape))
    for name, what in zip(("own/a.obj", "b.obj"), meshes, strict=True):
        (folder / name).write_text(what)
    robot = Robot(urdf=urdf, srdf="arm.srdf", packages={"own": "own"})
    robot = resolve_robot(robot, Source("task.yaml", {}), folder)[0]
    said = robot.model_dump(mode="json", exclude_none=True)
    return {"stages": [{"robot": said}], "files": checksums(robot_meshes(robot))}


@pytest.mark.parametrize("urdf", ["arm.urdf", "arm.xacro"])
def test_another_place_changes_nothing(tmp_path, urdf):
    if urdf == "arm.xacro":
        pytest.importorskip("xacro")
    here, there = document(tmp_path / "a", urdf=urdf), document(tmp_path / "b", urdf=urdf)
    assert here != there
    assert digest(here) == digest(there)
    assert Query("a", here, 1, 1).key == Query("a", there, 1, 1).key
    other = document(tmp_path / "a", "<visual/>", urdf)
    assert digest(other) != digest(here)
    assert Query("a", other, 1, 1).key != Query("a", here, 1, 1).key
    here["stages"][0]["robot"]["srdf_text"] = "<robot/>"
    assert digest(here) != digest(there)


def test_a_robot_is_what_its_meshes_hold(tmp_path):
    first = digest(document(tmp_path / "a", MESHES))
    assert digest(document(tmp_path / "a", MESHES)) == first
    for meshes in ("cb", "ac", "ba"):
        assert digest(document(tmp_path / "a", MESHES, meshes=meshes)) != first
    # A plan names its meshes where they are, and cannot be read elsewhere.
    assert digest(document(tmp_path / "b", MESHES)) != first


def test_meshes_that_change_places_are_another_robot(tmp_path):
    """The same files, and the same text: only the folder of a package says which is meant."""
    said = document(tmp_path, MESHES)
    swapped = document(tmp_path, MESHES)
    swapped["stages"][0]["robot"] |= {
        "directory": str(tmp_path / "own"),
        "packages": {"own": str(tmp_path)},
    }
    files = {str(tmp_path / "own" / "b.obj"): "c", str(tmp_path / "a.obj"): "d"}
    said["files"] |= files
    swapped["files"] |= files
    assert digest(said) != digest(swapped)


def test_text_that_is_no_xml_is_itself():
    broken = [{"robot": {"urdf_text": text}} for text in ("<robot", "<robo")]
    assert digest(broken[0]) != digest(broken[1])
