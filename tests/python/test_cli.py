# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line, as a shell sees it: exit codes, what goes where, and never a traceback."""

import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import time
import types

import numpy as np
import pytest

import graspless
from graspless import report
from graspless.plan_files import keep_solved
from tasks_common import GOOD, changed, run


@pytest.fixture
def task(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "task.yaml"
    path.write_text(GOOD)
    return path


def test_plan_and_check(task, capsys):
    code, out, err = run(capsys, "plan", "task.yaml", "--seed", "1")
    assert (code, err) == (0, "")
    assert out.startswith("solved in ")
    assert "written: plan.json" in out
    assert "slide" in out
    assert len(out.splitlines()) < 15
    rows = sum(int(line.split()[1]) for line in out.splitlines() if " rows, at least" in line)
    code, checked, _ = run(capsys, "check", "plan.json")
    assert code == 0
    assert checked.startswith(f"holds: 7 segments, {rows} rows")
    assert checked in out


def test_plan_that_does_not_hold_is_never_called_found(task, capsys, monkeypatch):
    fault = "slide row 3: collision a - b"
    monkeypatch.setattr("graspless._api.checked", lambda *_: ([fault], None))
    code, out, _ = run(capsys, "plan", "task.yaml")
    assert code == 1
    assert "does not hold:\nslide row 3: collision a - b\n" in out


def test_json_is_all_that_is_printed(task, capsys):
    code, out, _ = run(capsys, "plan", "task.yaml", "--json", "-o", "p.json")
    assert code == 0
    printed = json.loads(out)
    assert printed["status"] == "solved"
    assert printed["stats"]["iterations"] == graspless.load_plan("p.json").statistics.iterations > 0
    assert printed["segments"][0]["name"] == "approach"
    code, out, _ = run(capsys, "check", "p.json", "--json")
    assert (code, json.loads(out)) == (0, {"holds": True, "faults": []})


def test_flags_change_the_search(task, capsys):
    flags = ["--seed", "7", "--seconds", "3", "--iterations", "4000", "--search", "paper"]
    run(capsys, "plan", "task.yaml", *flags)
    plan = graspless.load_plan("plan.json")
    assert plan.seed == 7
    assert plan.task.options.search.name == "paper"
    assert (plan.task.budget.seconds, plan.task.budget.iterations) == (3.0, 4000)


def test_not_found_exits_1_and_says_why(task, capsys):
    code, out, err = run(capsys, "plan", "task.yaml", "--iterations", "0")
    assert (code, err) == (1, "")
    plan = graspless.load_plan("plan.json")
    assert not plan
    assert out.startswith(str(plan.status))
    assert plan.reason in out
    code, out, _ = run(capsys, "check", "plan.json")
    assert code == 1
    assert str(plan.status) in out


def test_a_plan_that_was_not_found_destroys_no_solved_one(task, capsys):
    old, kept = pathlib.Path("plan.json"), pathlib.Path("plan.json~")
    run(capsys, "plan", "task.yaml")
    solved = old.read_bytes()
    code, out, _ = run(capsys, "plan", "task.yaml", "--iterations", "0")
    assert code == 1
    assert out.endswith(
        "kept: plan.json~, the solved plan that was there before\nwritten: plan.json\n"
    )
    assert not graspless.load_plan("plan.json")
    assert kept.read_bytes() == solved
    _, out, _ = run(capsys, "plan", "task.yaml", "--iterations", "0", "--json")
    assert json.loads(out)["kept"] == []  # what is there now is not solved
    assert kept.read_bytes() == solved
    old.write_bytes(solved)
    _, out, _ = run(capsys, "plan", "task.yaml", "--iterations", "0", "--json")
    assert json.loads(out)["kept"] == ["plan.json~"]
    kept.unlink()
    for other in (b"notes", b"[1]", b'{"status": "solved"}'):  # no plans
        old.write_bytes(other)
        run(capsys, "plan", "task.yaml", "--iterations", "0")
        assert not kept.exists()


def test_output_that_is_a_pipe_is_not_read():
    read, write = os.pipe()
    with os.fdopen(read) as pipe:
        with os.fdopen(write, "w") as end:
            end.write("what waits in it")
        assert keep_solved(f"/dev/fd/{read}") is None
        assert pipe.read() == "what waits in it"


def test_out_of_reach_names_what_was_refused(task, capsys):
    far = changed("center: [0.65, 0.0]", "center: [1.1, 0.0]")
    task.write_text(changed("x: 0.60", "x: 1.1", far))
    code, out, _ = run(capsys, "plan", "task.yaml", "--time", "1")
    assert code == 1
    assert out.startswith("no_start_root")
    assert "rejected candidates, by reason:\n" in out
    assert "start: reach" in out


def test_far_out_of_reach_is_refused_without_a_search(task, capsys):
    far = changed("center: [0.65, 0.0]", "center: [3.0, 0.0]")
    task.write_text(changed("x: 0.60", "x: 3.0", far))
    code, out, _ = run(capsys, "plan", "task.yaml")
    assert code == 1
    assert out.startswith("no_start_root in ")
    assert "out of the arm's reach: the fingertip gets at most 1.17 m from 'wam_link_1'" in out


def test_start_in_collision(task, capsys):
    obstacle = "obstacles: [{name: wall, box: [9, 9, 9]}]\nbudget:"
    task.write_text(changed("budget:", obstacle))
    code, out, _ = run(capsys, "plan", "task.yaml")
    assert code == 1
    assert out.startswith("start_in_collision")
    assert "wall" in out


def test_check_says_what_does_not_hold(task, capsys):
    run(capsys, "plan", "task.yaml")
    document = json.loads(pathlib.Path("plan.json").read_text())
    document["segments"][0]["positions"][5][3] = -0.5
    pathlib.Path("plan.json").write_text(json.dumps(document))
    code, out, err = run(capsys, "check", "plan.json")
    assert (code, err) == (1, "")
    assert "approach" in out


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["plan", "none.yaml"], "none.yaml: cannot be read: No such file or directory"),
        (["plan", "."], "cannot be read"),
        (["plan", "task.yaml", "-o", "none/plan.json"], "none/plan.json: cannot be written"),
        (["plan", "task.yaml", "-o", "."], ".: cannot be written: is a folder"),
        (["plan", "task.yaml", "--png", "none/a.png"], "none/a.png: cannot be written"),
        (["plan", "task.yaml", "--time", "-1"], "--seconds: budget.seconds: -1.0: should be"),
        (["plan", "task.yaml", "--seed", "-1"], "--seed: budget.seed: -1: should be greater"),
        (["plan", "task.yaml", "--seed", "x"], "invalid int value: 'x'"),
        (["plan", "task.yaml", "--search", "best"], "invalid choice: 'best'"),
        (
            ["plan", "task.yaml", "--html", "a.png"],
            "a.png: unknown kind of replay (choices: .html)",
        ),
        (["plan", "task.yaml", "--png", "a.gif"], "a.gif: unknown kind of picture (choices: .png)"),
        (["plan", "task.yaml", "-o", "task.yaml"], "task.yaml: would replace an input"),
        (["plan", "task.yaml", "-o", "./task.yaml"], "task.yaml: would replace an input"),
        (["plan", "task.yaml", "-o", "a.html", "--html", "a.html"], "replace the file of --output"),
        (["robot", "join", "a.urdf", "b.urdf", "--mount", "m", "-o", "a.urdf"], "replace an input"),
        (["view", "plan.json", "--html", "plan.json"], "plan.json: would replace an input"),
        (["see", "a.png", "--camera", "task.yaml", "-o", "task.yaml"], "would replace an input"),
        (["see", "scene.npz"], "scene.yaml: scene.npz beside it would replace an input"),
        (["pick", ".", "a", "--robot", "wam_t42"], ".: is a folder, not a file"),
        (["robot", "inspect", "."], "robot.urdf: .: is a folder, not a file"),
        (["robot", "inspect", ""], "inspect: give either FILE or --name"),
        (["check", "none.json"], "none.json: cannot be read"),
        (["check", "task.yaml"], "task.yaml: this is a task, not a plan; graspless plan reads it"),
        (["check", "task.json"], "task.json: this is a task, not a plan; graspless plan reads it"),
        (["view", "pick.yaml"], "pick.yaml: this is a task, not a plan; graspless pick reads it"),
        (["view", "seen.yaml"], "seen.yaml: this is a scene, not a plan; graspless pick reads it"),
        (["plan", "seen.yaml"], "kind: scene: is read by `graspless pick`, with the name of an"),
        (["plan", "plan.json"], "plan.json: this is a plan, not a task; graspless check reads it"),
        (["check", "words.txt"], "words.txt:1: not valid JSON"),
        (["view", "none.json"], "none.json: cannot be read"),
        (["example", "none"], "there is no such example (one of: 01_slide_card"),
        (["example", "slide_crad"], "such example; did you mean '01_slide_card'? (one of: 01_"),
        (["dance"], "invalid choice: 'dance'"),
        (["chekk", "plan.json"], "; did you mean 'check'?\n"),
        (["robot", "inspct"], "; did you mean 'inspect'?\n"),
        (["plan", "task.yaml", "--search", "papr"], "; did you mean 'paper'?\n"),
        (
            ["plan", "task.yaml", "--sed", "3"],
            "unrecognized arguments: --sed 3; did you mean '--see",
        ),
        ([], "required: COMMAND"),
    ],
)
def test_bad_input_exits_2_with_one_message(task, capsys, arguments, what):
    pathlib.Path("words.txt").write_text("nothing of ours")
    pathlib.Path("task.json").write_text('{"kind": "slide", "robot": {}}')
    pathlib.Path("pick.yaml").write_text("kind: pick\nscene: seen.yaml")
    pathlib.Path("seen.yaml").write_text("kind: scene\nsupports: []")
    pathlib.Path("a.urdf").write_text("<robot/>")
    pathlib.Path("scene.npz").write_bytes(b"")
    pathlib.Path("plan.json").write_text('{"format": 1, "segments": []}')
    code, out, err = run(capsys, *arguments)
    assert (code, out) == (2, "")
    assert what in err
    assert "Traceback" not in err


def test_fault_in_a_task_names_file_and_line(task, capsys):
    task.write_text(changed("0.004", "-1"))
    code, out, err = run(capsys, "plan", "task.yaml")
    assert (code, out) == (2, "")
    assert err == "task.yaml:8: object.thickness: -1: should be greater than 0\n"


def test_unwritable_output_is_told_before_planning(task, capsys, monkeypatch):
    monkeypatch.setattr("graspless._api.plan", lambda *_: pytest.fail("planned in vain"))
    assert run(capsys, "plan", "task.yaml", "-o", "none/plan.json")[0] == 2


def test_warning_is_one_line_on_stderr(task, capsys, tmp_path):
    x, y = np.meshgrid(np.arange(30) * 100.0, np.arange(30) * 100.0)
    np.savetxt(tmp_path / "a.xyz", np.column_stack([x.ravel(), y.ravel(), np.full(900, 4.0)]))
    outline = "rectangle: {size: [0.10, 0.08]}\n  thickness: 0.004"
    task.write_text(changed(outline, "cloud: a.xyz"))
    _, _, err = run(capsys, "plan", "task.yaml", "--iterations", "0")
    assert err.startswith("warning: task.yaml:7: object.cloud: a.xyz: is 2900 x 2900 x 0 m")
    assert "Warning" not in err


def test_version_and_help(capsys):
    assert run(capsys, "--version")[:2] == (0, f"graspless {graspless.__version__}\n")
    code, out, _ = run(capsys, "--help")
    assert code == 0
    for command in ("plan", "check", "view", "example"):
        assert command in out
        assert run(capsys, command, "--help")[0] == 0


def test_module_runs_and_a_closed_pipe_is_no_fault(task):
    command = f"'{sys.executable}' -m graspless plan task.yaml --json | true"
    done = subprocess.run(command, shell=True, capture_output=True, text=True)
    assert done.stderr == ""


def test_faults_are_told_by_segment_and_counted():
    faults = [f"slide row {i}: collision a - b" for i in range(80)]
    plan = types.SimpleNamespace(segments=[])
    told = report.verdict(plan, [*faults, "close: no finger touches"]).splitlines()
    assert told[0] == "does not hold:"
    assert told[5:] == [faults[4], "slide: 75 more", "close: no finger touches", "81 faults"]
    assert report.verdict(plan, faults[:1]).splitlines() == ["does not hold:", faults[0]]


def test_one_is_not_plural():
    assert report.count(1, "pairs") == "1 pair"
    assert report.count(0, "pairs") == "0 pairs"


@pytest.fixture
def shell(task):
    """Exit code, stdout and stderr of a line of bash in the task's folder."""

    def shell(line):
        ours = f"unset PYTHONUNBUFFERED; graspless() {{ '{sys.executable}' -m graspless \"$@\"; }}; set -o pipefail; "
        done = subprocess.run(
            ["bash", "-c", ours + line], capture_output=True, text=True, timeout=100
        )
        return done.returncode, done.stdout, done.stderr

    return shell


def test_plan_from_stdin_to_stdout(shell):
    code, out, err = shell("graspless plan - -o - <task.yaml | tee seen.json | graspless check -")
    assert code == 0
    assert out.startswith("holds: 7 segments")
    assert err.startswith("solved in ")
    assert "written" not in err
    assert graspless.check("seen.json") == []
    assert not pathlib.Path("plan.json").exists()
    assert not pathlib.Path("-").exists()


def test_faults_of_stdin_are_named(shell):
    assert shell("graspless plan - </dev/null") == (
        2, "", "stdin:1: should be a mapping of fields, see docs/task-files.md\n"
    )  # fmt: skip
    assert (
        shell("graspless check - </dev/null")[2]
        == "stdin:1: not valid JSON: Expecting value (column 1)\n"
    )
    assert shell("graspless check - <&-") == (2, "", "stdin: cannot be read\n")
    assert shell("graspless plan - < <(printf '\\xff')")[2] == "stdin: not a text file in UTF-8\n"


@pytest.mark.parametrize(
    "command", ["plan task.yaml", "plan task.yaml -o -", "example --list", "--help"]
)
def test_full_stdout_is_told_in_one_line(shell, command):
    code, _, err = shell(f"graspless {command} >/dev/full")
    assert code == 2
    assert err.splitlines()[-1] == "stdout: cannot be written: No space left on device"
    assert "Traceback" not in err


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1"])
def test_names_that_stdout_cannot_write_become_escapes(shell, encoding):
    line = f"PYTHONIOENCODING={encoding}:strict graspless plan task.yaml -o $'\u03a9\\xe9.json'"
    code, out, err = shell(line)
    assert (code, err) == (0, "")
    assert out.endswith("\\udce9.json\n")


def test_what_would_be_a_file_is_utf8_on_stdout(shell):
    named = "sed -i s/wam_joint_1/wam_j\u03a9/g plan.json"
    export = "PYTHONIOENCODING=ascii graspless export plan.json --to csv -o -"
    code, out, _ = shell(f"graspless plan task.yaml > /dev/null && {named} && {export}")
    assert code == 0
    assert "wam_j\u03a9" in out.splitlines()[0]


def test_files_are_written_though_the_reader_has_gone(shell):
    pytest.importorskip("matplotlib")
    code, _, err = shell("graspless plan task.yaml --png a.png | true")
    assert (code, err) == (141, "")
    assert graspless.check("plan.json") == []
    assert pathlib.Path("a.png").read_bytes().startswith(b"\x89PNG")
    code, out, err = shell("graspless plan task.yaml -o - | head -1")
    assert code in (0, 141)  # 0 where the whole plan fits into the pipe
    assert out == "{\n"
    assert "Traceback" not in err


def test_summary_is_told_though_the_picture_fails(task, capsys, monkeypatch):
    def fail(*_):
        raise graspless.TaskError("needs matplotlib to draw")

    monkeypatch.setattr("graspless.view.write_png", fail)
    code, out, err = run(capsys, "plan", "task.yaml", "--png", "a.png")
    assert (code, err) == (2, "needs matplotlib to draw\n")
    assert out.startswith("solved")
    assert out.endswith("written: plan.json\n")


def test_ctrl_c_ends_at_once_with_130(task):
    # The support is out of reach at its edges: the search goes on until it is stopped.
    text = changed("center: [0.65, 0.0], size: [0.7, 0.7]", "center: [0.65, 0.0], size: [4, 4]")
    task.write_text(changed("seconds: 20", "seconds: 60", text))
    process = subprocess.Popen(
        [sys.executable, "-m", "graspless", "plan", "task.yaml"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    time.sleep(1.5)
    assert process.poll() is None
    process.send_signal(signal.SIGINT)
    start = time.monotonic()
    _, err = process.communicate(timeout=10)
    assert time.monotonic() - start < 0.5
    assert process.returncode == 130
    assert err == "interrupted\n"


def test_progress_is_told_at_a_terminal_only(task):
    text = changed("center: [0.65, 0.0], size: [0.7, 0.7]", "center: [0.65, 0.0], size: [4, 4]")
    task.write_text(text)
    command = [sys.executable, "-m", "graspless", "plan", "task.yaml", "--time", "1.5"]
    piped = subprocess.run(command, capture_output=True, text=True)
    assert piped.stderr == ""
    ours, theirs = pty.openpty()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=theirs)
    os.close(theirs)
    seen = os.read(ours, 10000).decode()
    os.close(ours)
    assert "planning, at most 1.5 s: 1 s" in seen
