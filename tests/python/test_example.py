# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every example is planned, checked and drawn, and every script runs."""

import pathlib
import subprocess
import sys

import pytest

import graspless
from graspless import _data, cli, files
from graspless.cli import examples

FOLDER = _data.directory("examples")
TASKS = sorted(path.stem for path in FOLDER.glob("*.yaml"))
SCRIPTS = sorted(path.name for path in FOLDER.glob("[0-9]*.py"))


def test_there_are_five():
    assert len(TASKS) >= 5
    assert list(examples.names()) == TASKS
    assert all(len(about) > 20 for about in examples.names().values())


@pytest.mark.parametrize("name", TASKS)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_plan_holds(name, seed):
    plan = graspless.plan(FOLDER / f"{name}.yaml", seed=seed)
    assert plan, plan.reason
    assert graspless.check(plan) == []


@pytest.mark.parametrize("name", SCRIPTS)
def test_script_runs(name, tmp_path):
    done = subprocess.run(
        [sys.executable, str(FOLDER / name)], capture_output=True, text=True, cwd=tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert not list(tmp_path.iterdir())


def test_cloud_is_what_its_script_makes(tmp_path):
    made = tmp_path / "made.ply"
    subprocess.run([sys.executable, str(FOLDER / "05_point_cloud.py"), str(made)], check=True)
    assert made.read_bytes() == (FOLDER / "05_point_cloud.ply").read_bytes()
    assert made.stat().st_size < 100_000


@pytest.mark.parametrize(
    ("name", "found"),
    [
        (None, TASKS[0]),
        ("slide", "01_slide_card"),
        ("04", "04_clutter"),
        ("02_kr5", "02_kr5"),
        ("clasp", "13_clasp_purse"),
        ("fingertip", "06_push_block"),
        ("carry", "24_carry_bar"),
        ("chain", "19_slide_then_lift"),
    ],
)
def test_found_by_a_part_of_its_name(name, found):
    assert examples.find(name).stem == found


def test_example_leaves_all_its_files(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    pytest.importorskip("viser")
    monkeypatch.chdir(tmp_path)
    assert cli.main(["example", "point_cloud", "-o", "out/here"]) == 0
    left = {path.name for path in pathlib.Path("out/here").iterdir()}
    assert left == {
        "05_point_cloud.yaml", "05_point_cloud.ply", "plan.json", "slide.png", "slide.html"
    }  # fmt: skip
    out = capsys.readouterr().out
    assert "holds: 7 segments" in out
    assert len(out.splitlines()) < 16
    assert cli.main(["check", "out/here/plan.json"]) == 0
    assert cli.main(["plan", "out/here/05_point_cloud.yaml"]) == 0


def test_list_names_them_all(capsys):
    assert cli.main(["example", "--list"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == TASKS


def test_folder_that_cannot_be_made(tmp_path, capsys):
    files.write(tmp_path / "file", "x")
    assert cli.main(["example", "-o", str(tmp_path / "file" / "under")]) == 2
    assert "cannot be written" in capsys.readouterr().err
