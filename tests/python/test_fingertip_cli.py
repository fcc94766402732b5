# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line with fingertip tasks: the same commands, the same exit codes."""

import json
import pathlib
import signal
import subprocess
import sys
import time

import pytest

from fingertip_common import PUSH, changed
from tasks_common import GOOD, run


@pytest.fixture
def task(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "task.yaml"
    path.write_text(PUSH)
    return path


def test_plan_check_and_view(task, capsys):
    pytest.importorskip("matplotlib")
    code, out, err = run(capsys, "plan", "task.yaml", "--png", "a.png")
    assert (code, err) == (0, "")
    assert out.startswith("solved in ")
    assert "cost 0.05" in out
    assert "weakest at row 0 of the slide" in out
    assert "holds: 1 segment, 18 rows" in out
    assert "written: plan.json\nwritten: a.png" in out
    assert pathlib.Path("a.png").read_bytes().startswith(b"\x89PNG")
    assert run(capsys, "check", "plan.json")[0] == 0
    assert run(capsys, "view", "plan.json", "--png", "b.png")[0] == 0
    assert pathlib.Path("b.png").read_bytes() == pathlib.Path("a.png").read_bytes()


def test_json_is_all_that_is_printed(task, capsys):
    code, out, _ = run(capsys, "plan", "task.yaml", "--json", "--search", "dijkstra")
    assert code == 0
    printed = json.loads(out)
    assert printed["cost"] == printed["lower_bound"]
    assert printed["stats"]["z_evaluations"] > 0
    assert printed["faults"] == []
    document = json.loads(pathlib.Path("plan.json").read_text())
    assert document["task"]["options"]["search"] == "dijkstra"


def test_each_kind_has_its_searches(task, capsys):
    task.write_text(GOOD)
    code, _, err = run(capsys, "plan", "task.yaml", "--search", "dijkstra")
    assert code == 2
    assert (
        err == "--search: dijkstra: not a search algorithm of slide tasks (choices: paper, fast)\n"
    )


def test_not_found_exits_1_and_says_what_blocks(task, capsys):
    task.write_text(changed("max_normal_force: 10", "max_normal_force: 0.3"))
    code, out, err = run(capsys, "plan", "task.yaml")
    assert (code, err) == (1, "")
    assert out.startswith("unstable in ")
    assert "limiting condition: " in out
    assert "one change that would suffice: " in out
    assert "nothing to check: not solved" in out
    assert run(capsys, "check", "plan.json")[0] == 1


def test_bad_input_exits_2(task, capsys):
    task.write_text(changed("radius: 0.01", "radius: -1"))
    code, out, err = run(capsys, "plan", "task.yaml")
    assert (code, out) == (2, "")
    assert err == "task.yaml:6: fingers.radius: -1: should be greater than 0\n"


def test_check_says_what_does_not_hold(task, capsys):
    run(capsys, "plan", "task.yaml")
    document = json.loads(pathlib.Path("plan.json").read_text())
    document["segments"][0]["stability"][4] = 50.0
    pathlib.Path("plan.json").write_text(json.dumps(document))
    code, out, _ = run(capsys, "check", "plan.json")
    assert code == 1
    assert "segment 0 (slide), row 4: stability: " in out


def test_ctrl_c_ends_a_search(task):
    long = changed("segments: 6", "segments: 200")
    task.write_text(
        changed("locations_per_side: 5", "locations_per_side: 13, search: dijkstra", long)
    )
    running = subprocess.Popen(
        [sys.executable, "-m", "graspless", "plan", "task.yaml", "--time", "100"],
        stderr=subprocess.PIPE,
        text=True,
    )
    time.sleep(3)
    assert running.poll() is None
    running.send_signal(signal.SIGINT)
    _, err = running.communicate(timeout=60)
    assert (running.returncode, err) == (130, "interrupted\n")
