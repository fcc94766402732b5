# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The fleet in small: robots that come with graspless, and those whose packages are installed."""

import importlib.metadata
import json

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
