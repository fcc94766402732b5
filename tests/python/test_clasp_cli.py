# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line with clasp tasks, and graspless loops."""

import json
import pathlib

import numpy as np
import pytest

from clasp_common import PURSE, changed, purse
from tasks_common import run


@pytest.fixture
def task(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "task.yaml"
    path.write_text(PURSE)
    return path


@pytest.fixture
def cloud(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    np.savetxt(tmp_path / "purse.xyz", purse().points)
    return "purse.xyz"


def test_plan_check_and_view(task, capsys):
    pytest.importorskip("matplotlib")
    code, out, err = run(capsys, "plan", "task.yaml")
    assert (code, err) == (0, "")
    assert out.startswith("solved in ")
    assert "clasps the loop, " in out
    assert "holds: 2 segments" in out
    assert run(capsys, "check", "plan.json")[0] == 0
    assert run(capsys, "view", "plan.json", "--png", "b.png")[0] == 0
    assert pathlib.Path("b.png").read_bytes().startswith(b"\x89PNG")


def test_json_is_all_that_is_printed(task, capsys):
    code, out, _ = run(capsys, "plan", "task.yaml", "--json")
    assert code == 0
    printed = json.loads(out)
    assert printed["stability"]["secure"] is True
    assert printed["stats"]["cycles"] >= 1
    assert printed["faults"] == []


def test_start_in_collision_is_told(task, capsys):
    task.write_text(changed("budget:", "obstacles: [{name: wall, box: [9, 9, 9]}]\nbudget:"))
    code, out, _ = run(capsys, "plan", "task.yaml")
    assert code == 1
    assert out.startswith("start_in_collision")
    assert "wall" in out


def test_out_of_reach_is_told(task, capsys):
    task.write_text(changed("position: [0.62, 0.05, 0]", "position: [5, 0, 0]"))
    code, out, _ = run(capsys, "plan", "task.yaml")
    assert code == 1
    assert out.startswith("no_target_in_reach")


def test_there_is_no_other_search(task, capsys):
    code, _, err = run(capsys, "plan", "task.yaml", "--search", "dijkstra")
    assert code == 2
    told = "not a search algorithm of clasp tasks (choices: none, there is a single one)"
    assert err == f"--search: dijkstra: {told}\n"


def test_loops_of_a_cloud(cloud, capsys):
    code, out, err = run(capsys, "loops", cloud)
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0].startswith("1 loop found, longest edge of the complex ")
    assert lines[1].startswith(f"  0: {purse().loops.found[0].length:.3g} m long, ")


def test_loops_as_json(cloud, capsys):
    code, out, _ = run(capsys, "loops", cloud, "--json")
    assert code == 0
    printed = json.loads(out)
    loop = purse().loops.found[0]
    assert printed["status"] == "found"
    assert printed["found"][0]["length"] == pytest.approx(loop.length, abs=1e-9)
    assert len(printed["found"][0]["points"]) == len(loop.points)
    assert len(printed["betti"]["max_edge_length"]) == len(printed["betti"]["loops"])


def test_loops_of_a_mesh_in_millimetres_with_a_picture(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    import trimesh

    monkeypatch.chdir(tmp_path)
    trimesh.creation.torus(100, 12).export("ring.stl")
    arguments = ("loops", "ring.stl", "--unit", "mm", "--points", "800", "--png", "a.png")
    code, out, _ = run(capsys, *arguments)
    assert code == 0
    assert out.startswith("1 loop ")
    assert out.endswith("written: a.png\n")
    length = float(out.splitlines()[1].split()[1])
    assert 2 * np.pi * 0.08 < length < 2 * np.pi * 0.105
    assert pathlib.Path("a.png").read_bytes().startswith(b"\x89PNG")


def test_cloud_without_a_hole_exits_1(tmp_path, monkeypatch, capsys):
    import trimesh

    monkeypatch.chdir(tmp_path)
    np.savetxt("ball.xyz", trimesh.creation.icosphere(subdivisions=3, radius=0.1).vertices)
    code, out, _ = run(capsys, "loops", "ball.xyz")
    assert code == 1
    assert out.startswith("no reliable hole: ")
    assert out.count("no reliable hole") == 1


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["none.xyz"], "none.xyz: no such file"),
        (["none.stl"], "none.stl: "),
        (
            ["a.txt"],
            "a.txt: unknown kind of file (one of: .ply, .pcd, .xyz, .npy, .stl, .obj, .off, .yaml, .yml)",
        ),
        (["few.xyz"], "few.xyz: "),
        (["nan.xyz"], "nan.xyz: 30 of 30 points are not finite"),
        (["purse.xyz", "--edge", "-1"], "purse.xyz: "),
        (["purse.xyz", "--png", "a.gif"], "a.gif: unknown kind of picture"),
        (["purse.xyz", "--unit", "inch"], "invalid choice: 'inch'"),
        (["purse.xyz", "--points", "-1"], "--points: -1: should be at least 1"),
        (["purse.xyz", "--points", "100"], "--points: 100: only for meshes (.stl, .obj, .off)"),
        (["purse.xyz", "--points", "99999999999"], "--points: 99999999999: should be at most"),
        (["purse.xyz", "--seed", "-1"], "--seed: -1: should not be negative"),
        (["purse.xyz", "--threads", "9999999999"], "--threads: 9999999999: should be at most 256"),
        (["s.yaml", "--object", "a", "--unit", "mm"], "--unit: mm: not for scene files"),
    ],
)
def test_bad_input_exits_2_with_one_message(cloud, capsys, arguments, what):
    np.savetxt("few.xyz", np.eye(3))
    np.savetxt("nan.xyz", np.full((30, 3), np.nan))
    code, out, err = run(capsys, "loops", *arguments)
    assert (code, out) == (2, "")
    assert what in err
    assert "Traceback" not in err
