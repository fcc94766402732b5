# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The fleet in small: robots that come with graspless, and those whose packages are installed."""

import importlib.metadata
import json
import re

import pytest

import graspless
import inspect_common as small
from graspless import robot
from graspless.cli import main
from graspless_bench.robots import fleet, report
from graspless_bench.robots.places import IN_FRONT
from graspless_bench.robots.run import run
from graspless_bench.robots.scene import Scene

OWN = (
    fleet.Member("WAM", {"urdf": "wam_t42"}),
    fleet.Member("away", {"urdf": "rtb-data-of-nobody.urdf"}),
)


@pytest.fixture(scope="module")
def rows():
    return run(OWN, slides=3, clasps=1, limits=(5.0, 0.2))


def test_slides_with_a_proposal_hold(rows):
    row = rows[0]
    assert row["found"]["arm"] == 7
    assert row["found"]["fingers"] == 2
    assert row["inspect_s"] > 0
    assert row["by_hand"] == "nothing"
    assert row["slides"]["solved"] == row["slides"]["runs"] == 3
    assert row["slides"]["faults"] == 0
    assert row["slides"]["p50_ms"] <= row["slides"]["p99_ms"]


def test_a_robot_that_cannot_be_read_has_a_reason(rows):
    row = rows[1]
    assert row["found"] is None
    assert row["slides"] is None
    assert "rtb-data-of-nobody.urdf" in row["refused"]


def test_page_has_every_robot(rows, tmp_path):
    result = report.as_result(rows, (0.0, 0.0, 0.0))
    assert result["inspected"] == 1
    report.write(result, tmp_path)
    page = (tmp_path / "robots.md").read_text()
    assert "$" not in page
    for member in OWN:
        assert f"| {member.name} |" in page
    for package in fleet.PACKAGES:
        assert package in page
    stored = json.loads((tmp_path / "robots.json").read_text())
    assert stored["rows"] == json.loads(json.dumps(rows))
    assert "WAM" in report.as_text(result)


def test_fleet_is_large_and_has_distinct_names():
    names = [member.name for member in fleet.FLEET]
    assert len(set(names)) == len(names) >= 12
    assert {package for member in fleet.FLEET for package in member.packages} == set(fleet.PACKAGES)


def test_a_package_that_is_not_installed_is_named(monkeypatch, capsys):
    def missing(name):
        raise importlib.metadata.PackageNotFoundError(name)

    monkeypatch.setattr(importlib.metadata, "distribution", missing)
    assert main(["bench", "robots", "--robot", "Panda", "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)["rows"]
    assert row["refused"] == "example-robot-data is not installed"


def test_unknown_robots_are_refused(capsys):
    assert main(["bench", "robots", "--robot", "Pandora"]) == 2
    assert "--robot: Pandora: no such robot (one of: Panda, " in capsys.readouterr().err


@pytest.mark.parametrize(
    "name", ["Panda", "UR5 and Panda Hand", "UR5e and Robotiq 2F-85", "ViperX 300 S"]
)
def test_robots_of_installed_packages(name):
    (member,) = (member for member in fleet.FLEET if member.name == name)
    try:
        member.resolved()
    except importlib.metadata.PackageNotFoundError as error:
        pytest.skip(f"{error.name} is not installed")
    (row,) = run([member], slides=3, clasps=1, limits=(10.0, 0.2))
    assert row["slides"]["solved"] == 3
    assert row["slides"]["faults"] == 0


def test_the_home_of_an_arm_on_a_table_is_above_it():
    """Farther in front, the hand of this arm points down at the height of its base."""
    (member,) = (member for member in fleet.FLEET if member.name == "Z1")
    try:
        files = member.resolved()
    except importlib.metadata.PackageNotFoundError as error:
        pytest.skip(f"{error.name} is not installed")
    found = robot.inspect(files["urdf"])
    X_WH = found.robot.pose("grasp", found.robot.state("home", found.robot.state("open")))
    assert X_WH[2, 3] > 0.08
    assert X_WH[2, 2] == pytest.approx(-1, abs=1e-6)


ELBOW_DOWN = {"shoulder_lift": -0.479, "elbow": -0.960, "wrist_1": -0.132}


def test_two_files_are_joined_inspected_and_plan_from_any_home(tmp_path):
    (member,) = (member for member in fleet.FLEET if member.name == "UR5e and Robotiq 2F-85")
    try:
        files = member.resolved()
    except importlib.metadata.PackageNotFoundError as error:
        pytest.skip(f"{error.name} is not installed")
    joined, mine = str(tmp_path / "mine.urdf"), tmp_path / "mine"
    gripper = files["gripper"]["file"]
    assert main(["robot", "join", files["arm"], gripper, "--mount", "tool0", "-o", joined]) == 0
    assert main(["robot", "inspect", joined, "-o", str(mine)]) == 0
    task = {
        "kind": "slide",
        "robot": {"urdf": str(mine / "mine.urdf")},
        "object": {
            "rectangle": {"size": [0.086, 0.054]},
            "thickness": 0.002,
            "pose": {"x": 0.5, "y": 0.1, "yaw": 0.4},
        },
        "support": {"rectangle": {"center": [0.5, 0.0], "size": [0.5, 0.7]}, "height": 0.1},
        "budget": {"seconds": 60},
    }
    assert graspless.check(graspless.plan(task)) == []
    text = (mine / "mine.srdf").read_text()
    for name, value in ELBOW_DOWN.items():
        text, count = re.subn(rf'(name="{name}_joint" value=)"[^"]*"', rf'\1"{value}"', text)
        assert count == 1
    (mine / "mine.srdf").write_text(text)
    plan = graspless.plan(task)  # the presses nearest to this home are in the table
    assert graspless.check(plan) == []
    assert plan.statistics.refusals["start: collision of upper_arm_link with support"] > 10


def test_tables_are_placed_where_the_arm_presses_and_grasps(tmp_path):
    found = robot.inspect(robot.Robot.from_urdf(small.gripper()), name="mine")
    found.write(tmp_path)
    scene = Scene(found, str(tmp_path / "mine.urdf"))
    tried = list(scene.places())
    assert tuple(tried[: len(IN_FRONT)]) == IN_FRONT
    solved = 0
    for place in tried[len(IN_FRONT) :][:3]:
        scene.place = place
        solved += bool(graspless.plan(scene.slide(2.0)))
    assert solved >= 2
