# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many tasks: none is lost, none is done twice, and none stops the others."""

import contextlib
import importlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest.mock

import pytest

import batch_common
import graspless
from graspless import TaskError, batches, files, robot
from graspless.batches import manifest, names, pools, work
from graspless.batches.cli import bar
from graspless.batches.spread import spread
from graspless.batches.summary import Summary
from graspless.errors import install_command
from tasks_common import GOOD, changed, run, without_clock

FOLDER = pathlib.Path(__file__).parent


@pytest.fixture
def tasks(tmp_path):
    """Makes a folder of good tasks that differ in their seeds."""

    def make(*names, folder="tasks"):
        for seed, name in enumerate(names):
            path = tmp_path / folder / f"{name}.yaml"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(changed("seed: 3", f"seed: {seed}"))
        return tmp_path / folder

    return make


@pytest.fixture
def here(monkeypatch):
    """Batches without processes, for what has nothing to do with them."""
    monkeypatch.setattr(
        pools, "opened", lambda jobs, dask: contextlib.nullcontext(batch_common.Here())
    )


def rows_of(output):
    return manifest.read(output / "batch.jsonl")


def test_names_stay_apart(tasks, tmp_path, monkeypatch):
    folder = tasks("a/card", "b/card", "plate")
    (folder / "plate.yml").write_text(GOOD)
    (folder / "card_1.5mm.yaml").write_text(GOOD)
    for ending in ("hand.yaml", "clasp.yaml", "hand.yml", "clasp.yml"):
        (folder / f"own.{ending}").write_text("arm: arm")
    (folder / "notes.txt").write_text("")
    expected = ["a/card", "b/card", "card_1.5mm", "plate.yaml", "plate.yml"]
    assert [entry.name for entry in names.find(folder)] == expected
    assert [entry.name for entry in names.find([folder, folder / "plate.yml"])] == expected
    monkeypatch.chdir(tmp_path)
    assert [entry.name for entry in names.find("tasks/**/card.yaml")] == ["a/card", "b/card"]
    assert [entry.name for entry in names.find("tasks/a/*")] == ["card"]
    assert [entry.name for entry in names.find(folder / "b")] == ["card"]
    for name in ("x.yaml", "x.yml", "x.yaml.yaml"):
        (folder / "b" / name).write_text(GOOD)
    names_of_b = ["card", "x.yaml", "x.yaml.yaml", "x.yml"]
    assert [entry.name for entry in names.find(folder / "b")] == names_of_b
    odd = tmp_path / "odd[1].yaml"
    odd.write_text(GOOD)
    assert [entry.path for entry in names.find("odd[1].yaml")] == [odd]


def test_folders_are_searched_behind_their_links(tasks, tmp_path):
    folder = tasks("own", ".hidden", ".checkpoints/own")
    (folder / "far").symlink_to(tasks("card", folder="elsewhere"))
    (folder / "far" / "circle").symlink_to(folder)
    (folder / "gone.yaml").symlink_to(tmp_path / "nowhere.yaml")
    assert [entry.name for entry in names.find(folder)] == ["far/card", "gone", "own"]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ([], "tasks: none given"),
        ("nothing.yaml", "nothing.yaml: no such file"),
        ("no*.yaml", "no\\*.yaml: no task files there"),
        (".", "no task files there"),
        (5, "5: should be the path of a file"),
        ([None], "None: should be the path of a file"),
    ],
)
def test_no_tasks_are_refused(given, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(TaskError, match=message):
        graspless.batch(given, "out")


def test_the_same_plans_as_one_by_one(tasks, tmp_path):
    folder = tasks("a/card", "b/card", "c")
    told = []
    output = tmp_path / "new" / "out"
    summary = graspless.batch(folder, output, jobs=2, progress=lambda *now: told.append(now))
    assert summary
    assert (summary.solved, summary.held, summary.kept) == (3, 3, 0)
    assert told == [(1, 3), (2, 3), (3, 3)]
    for name in ("a/card", "b/card", "c"):
        alone = graspless.plan(folder / f"{name}.yaml")
        path = output / f"{name}.plan.json"
        assert without_clock(graspless.load_plan(path)) == without_clock(alone)
        row = rows_of(output)[name]
        assert graspless.check(path) == row["faults"] == []
        assert row["seed"] == alone.seed
        assert row["task"] == str(folder / f"{name}.yaml")
    assert json.loads((output / "summary.json").read_text())["held"] == 3


def test_what_is_done_stands_until_the_task_changes(here, tasks, tmp_path):
    folder, output = tasks("a", "b", "c"), tmp_path / "out"
    graspless.batch(folder, output)
    times = {path: path.stat().st_mtime_ns for path in output.glob("*.plan.json")}
    assert len(times) == 3
    (folder / "a.yaml").write_text(changed("seed: 3", "seed: 9"))
    (folder / "b.yaml").write_text("# a remark\n" + changed("seed: 3", "seed: 1"))
    (output / "c.plan.json").unlink()
    summary = graspless.batch(folder, output)
    assert (summary.kept, summary.held) == (1, 3)
    assert rows_of(output)["a"]["seed"] == 9
    assert (output / "b.plan.json").stat().st_mtime_ns == times[output / "b.plan.json"]
    assert (output / "c.plan.json").exists()
    assert graspless.batch(folder, output).kept == 3
    solved = (output / "c.plan.json").read_bytes()
    assert graspless.batch(folder, output, iterations=0).solved == 0
    assert (output / "c.plan.json~").read_bytes() == solved
    assert graspless.batch(folder, output, iterations=10**6).kept == 0  # another task, too


def test_a_file_that_a_task_names_is_part_of_it(here, tmp_path):
    (tmp_path / "own.hand.yaml").write_text("{tip_radius: 0.005}")
    text = changed("object:", "hand: own.hand.yaml\nobject:")
    (tmp_path / "task.yaml").write_text(text)
    graspless.batch(tmp_path / "task.yaml", tmp_path / "out")
    (tmp_path / "own.hand.yaml").write_text(
        "{finger_model: flexure, flexure_length: 0.11, flexure_stiffness: 4.6, tip_radius: 0.004}"
    )
    assert graspless.batch(tmp_path / "task.yaml", tmp_path / "out").kept == 0


def test_copied_tasks_with_their_robot_are_not_planned_anew(here, tasks, tmp_path):
    folder, output = tasks("a"), tmp_path / "out"
    for end in (".urdf", ".srdf", ".hand.yaml"):
        shutil.copy(robot.builtin("wam_t42").with_name(f"wam_t42{end}"), folder)
    (folder / "a.yaml").write_text(changed("urdf: wam_t42", "urdf: wam_t42.urdf"))
    graspless.batch(folder, output)
    shutil.copytree(folder, tmp_path / "copy")
    assert graspless.batch(tmp_path / "copy", output).kept == 1
    urdf = tmp_path / "copy" / "wam_t42.urdf"
    urdf.write_text(urdf.read_text().replace("</robot>", '<link name="more"/></robot>'))
    assert graspless.batch(tmp_path / "copy", output).kept == 0


def test_names_of_files_may_be_any_bytes(here, tasks, tmp_path):
    folder = tasks("card")
    odd = os.fsdecode(b"t\xe4sk")
    shutil.copy(folder / "card.yaml", folder / f"{odd}.yaml")
    assert graspless.batch(folder, tmp_path / "plans").held == 2
    assert rows_of(tmp_path / "plans").keys() == {"card", odd}
    assert graspless.batch(folder, tmp_path / "plans").kept == 2


def test_bad_tasks_among_good_ones(here, tasks, tmp_path, capsys):
    folder, output = tasks("a", "b"), tmp_path / "out"
    (folder / "bad.yaml").write_text(changed("thickness: 0.004", "thickness: -1"))
    (folder / "broken.yaml").write_text("kind: [")
    (folder / "short.yaml").write_text(changed("seed: 3", "iterations: 0"))
    code, out, err = run(capsys, "batch", str(folder), "-o", str(output))
    assert (code, err) == (1, "")
    assert "5 of 5 tasks done" in out
    rows = rows_of(output)
    assert {name: row["status"] for name, row in rows.items()} == {
        **{"a": "solved", "b": "solved", "bad": "bad_task", "broken": "bad_task"},
        "short": graspless.plan(folder / "short.yaml").status.name,
    }
    assert "bad.yaml:8: object.thickness: -1: should be greater than 0" in rows["bad"]["reason"]
    assert rows["bad"]["reason"] in out
    assert sorted(path.name for path in output.glob("*.plan.json")) == [
        "a.plan.json",
        "b.plan.json",
        "short.plan.json",
    ]


def test_a_worker_that_dies_names_the_culprit(tasks, tmp_path):
    folder, output = tasks("a", "b", "exits", "hangs", "killer", "z"), tmp_path / "out"
    runner = batches._Run(names.find(folder), output, {}, patience=1.5)
    with pools.opened(2, None) as pool:
        summary = runner.carry_out(pool, batch_common.dangerous)
    found = {row["name"]: row["status"] for row in summary.rows}
    assert found == {
        **{"a": "solved", "b": "solved", "z": "solved"},
        **{"exits": "crashed", "hangs": "timed_out", "killer": "crashed"},
    }
    rows = rows_of(output)
    assert "SIGSEGV" in rows["killer"]["reason"]
    assert "EXIT(3)" in rows["exits"]["reason"]
    assert rows["hangs"]["total_seconds"] > 1.5
    again = graspless.batch(folder, output)  # with the work that is not dangerous
    assert (again.kept, again.held) == (3, 6)


def test_who_is_innocent_gets_an_answer_too(tmp_path):
    def lost(item, told, seconds):
        return f"{item} lost"

    with pools.opened(2, None) as pool:
        found = set(spread(batch_common.square, range(8), pool, lost))
        assert found == {"3 lost", *(n * n for n in range(8) if n != 3)}
        once = [str(tmp_path / "mark")]
        assert list(spread(batch_common.unlucky, once, pool, lost)) == once


def test_a_fault_of_ours_is_not_hidden():
    with pytest.raises(ArithmeticError, match="0 is wrong"), pools.opened(1, None) as pool:
        list(spread(batch_common.fails, range(3), pool, lambda *_: None))


def test_an_exception_is_a_row(tasks, monkeypatch):
    def broken(task):
        raise RuntimeError("no such thing")

    monkeypatch.setattr("graspless._api.plan", broken)
    job = work.Job("a", str(tasks("a") / "a.yaml"))
    row = work.carry_out(job).row
    assert (row["status"], row["reason"]) == ("failed", "RuntimeError: no such thing")


def test_a_plan_that_does_not_hold_is_not_held(tasks, monkeypatch):
    monkeypatch.setattr("graspless._api.check", lambda _: ["slide row 3: collision a - b"])
    outcome = work.carry_out(work.Job("a", str(tasks("a") / "a.yaml")))
    assert outcome.row["status"] == "solved"
    assert not outcome.row["holds"]
    summary = Summary([outcome.row], tasks=1, kept=0, jobs=1, seconds=1.0)
    assert not summary
    assert summary.reasons == {"does not hold": {"slide row 3: collision a - b": 1}}


def test_only_unfinished_files_of_ours_are_swept(tmp_path):
    folder = tmp_path / "a"
    folder.mkdir()
    theirs = {folder / f".card.plan.json.{end}" for end in ("swp", "bak", "01234567x")}
    left = [files._make_temporary(folder / "card.plan.json")]
    left += [files._make_temporary(tmp_path / name) for name in ("batch.jsonl", "summary.json")]
    for path in theirs:
        path.write_text("mine")
    work.sweep(tmp_path)
    for handle, path in left:
        os.close(handle)
        assert not path.exists()
    assert set(folder.iterdir()) == theirs


def _start(folder, output, *flags):
    command = [sys.executable, "-m", "graspless", "batch", str(folder), "-o", str(output), *flags]
    return subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )


def _at_work(folder, output):
    """A batch of two jobs that has done some tasks."""
    process = _start(folder, output, "--jobs", "2")
    deadline = time.monotonic() + 60
    while len(rows_of(output)) < 5:
        assert time.monotonic() < deadline
        assert process.poll() is None
        time.sleep(0.02)
    return process


def test_progress_only_at_a_terminal(here, capsys, monkeypatch):
    with bar("planning") as progress:
        assert progress is None
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    with bar("planning") as progress:
        progress(1, 2)
        progress(2, 2)
    out, err = capsys.readouterr()
    assert out == ""
    assert "planning" in err
    assert "2/2" in err


def test_a_terminal_without_rich_has_no_bar(tasks, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    for name in [name for name in sys.modules if name.partition(".")[0] == "rich"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "rich", None)
    with bar("planning") as progress:
        assert progress is None
    monkeypatch.setitem(sys.modules, "joblib.externals.loky", None)  # [batch] brings both
    code, out, err = run(capsys, "batch", str(tasks("a")), "-o", str(tmp_path / "out"))
    assert (code, out, err) == (2, "", f"needs joblib: {install_command('batch')}\n")


def test_interrupted_and_resumed(tasks, tmp_path):
    folder, output = tasks(*(f"card_{i:03}" for i in range(80))), tmp_path / "out"
    process = _at_work(folder, output)
    start = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the workers, too
    out, err = process.communicate(timeout=30)
    assert process.returncode == 130, err
    assert time.monotonic() - start < 10
    # a worker that was just being started may have said something before
    assert err.splitlines()[-1].startswith(
        "interrupted; this command resumes the batch: graspless batch "
    )
    before = rows_of(output)
    assert 5 <= len(before) < 80
    assert f"{len(before)} of 80 tasks done" in out
    assert list(output.rglob(".*")) == []  # nothing half written
    undone = [f"card_{i:03}" for i in range(80) if f"card_{i:03}" not in before]
    for name in [*list(before)[5:], *undone[5:]]:  # all of them would take long
        (folder / f"{name}.yaml").unlink()
    # A plan that was written when its row was not yet is planned again.
    plans = [output / f"{name}.plan.json" for name in before]
    kept = {path: path.stat().st_mtime_ns for path in plans}
    left = {path.stem for path in folder.glob("*.yaml")}
    (output / ".card_000.plan.json.0123abcd").write_text(
        "half a plan, of a process that was killed"
    )
    again = _start(folder, output, "--jobs", "2", "--json")
    out, err = again.communicate(timeout=60)
    assert again.returncode == 0, err
    summary = json.loads(out)
    assert summary["held"] == summary["tasks"] == len(left)
    assert summary["kept"] == len(left & set(before))
    for path, then in kept.items():
        assert path.stat().st_mtime_ns == then
    assert left <= set(rows_of(output))
    assert list(output.rglob(".*")) == []


def test_sigterm_leaves_no_worker_behind(tasks, tmp_path):
    folder, output = tasks(*(f"card_{i:03}" for i in range(80))), tmp_path / "out"
    process = _at_work(folder, output)
    assert len(_session(process.pid)) >= 3  # it, and its workers
    for _ in range(2):  # as `timeout` does
        process.send_signal(signal.SIGTERM)
    _, err = process.communicate(timeout=30)
    assert process.returncode == 143, err
    # a worker that was just being started may have said something before
    assert err.splitlines()[-1].startswith(
        "interrupted; this command resumes the batch: graspless batch "
    )
    deadline = time.monotonic() + 5
    while left := _session(process.pid):
        assert time.monotonic() < deadline, left
        time.sleep(0.02)
    assert list(output.rglob(".*")) == []


def _session(leader):
    """Processes of the session that `leader` began, but for those that only wait to be forgotten."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            state, _, _, session = path.read_text().rpartition(")")[2].split()[:4]
            if int(session) == leader and state != "Z":
                found.append(path.parent.name)
    return found


def test_a_row_that_was_cut_short_is_none(here, tasks, tmp_path):
    folder, output = tasks("a", "b"), tmp_path / "out"
    graspless.batch(folder, output)
    path = output / "batch.jsonl"
    path.write_text(path.read_text()[:-20])
    assert list(rows_of(output)) == ["a"]
    assert graspless.batch(folder, output).kept == 1
    assert list(rows_of(output)) == ["a", "b"]
    assert len(path.read_text().splitlines()) == 2


def test_a_damaged_plan_is_planned_again(here, tasks, tmp_path):
    folder, output = tasks("a", "b"), tmp_path / "out"
    graspless.batch(folder, output)
    path = output / "a.plan.json"
    whole = path.read_text()
    path.write_text(whole[: len(whole) // 2])
    assert graspless.batch(folder, output).kept == 1
    assert graspless.check(path) == []


@pytest.mark.parametrize(
    "foreign", [{"status": None}, {"plan": 5}, {"name": ["a"]}, {"faults": "none"}, {"holds": 1}]
)
def test_a_row_of_another_make_is_none(here, tasks, tmp_path, foreign):
    folder, output = tasks("a", "b"), tmp_path / "out"
    graspless.batch(folder, output)
    path = output / "batch.jsonl"
    first, second = map(json.loads, path.read_text().splitlines())
    first |= foreign
    path.write_text("".join(json.dumps(row) + "\n" for row in (first, second)))
    assert graspless.batch(folder, output).kept == 1
    del second["holds"]
    path.write_text(json.dumps(second) + "\n")
    assert graspless.batch(folder, output).kept == 0
    assert list(rows_of(output)) == ["a", "b"]


def test_two_batches_in_one_folder(here, tasks, tmp_path):
    folder, output = tasks("a"), tmp_path / "out"
    output.mkdir()
    with manifest.opened(output / "batch.jsonl"), pytest.raises(TaskError, match="another run"):
        graspless.batch(folder, output)
    first = graspless.batch(folder, output)
    tasks("b", folder="others")
    graspless.batch(tmp_path / "others", output)
    assert list(rows_of(output)) == ["a", "b"]
    assert graspless.batch(folder, output).rows == first.rows


def test_batches_that_overlap_lose_no_rows(here, tasks, tmp_path, monkeypatch):
    folder, output = tasks("a"), tmp_path / "out"
    late = batches._Run(names.find(folder), output, {})
    graspless.batch(tasks("b", folder="others"), output)  # after the late one has begun
    rewrite, refused = manifest.rewrite, pytest.raises(TaskError, match="another run")

    def tried(path, rows):
        with refused:
            manifest.Log(path)
        rewrite(path, rows)

    monkeypatch.setattr(manifest, "rewrite", tried)
    late.carry_out(batch_common.Here(), work.carry_out)
    assert list(rows_of(output)) == ["b", "a"]
    lock = manifest.fcntl.flock

    def locked(*given):
        rewrite(output / "batch.jsonl", [])  # another run ends between opening and locking
        lock(*given)

    monkeypatch.setattr(manifest.fcntl, "flock", locked)
    with refused:
        manifest.Log(output / "batch.jsonl")


@pytest.mark.parametrize(
    ("flags", "message"),
    [
        (["--jobs", "0"], "jobs: 0: should be at least 1"),
        (["--patience", "0"], "patience: 0.0: should be above 0"),
        (["--seed", "-1"], "seed: -1: should be greater than or equal to 0"),
        (["--time", "nan"], "seconds: nan: should be a finite number"),
        (["--dask", "tcp://127.0.0.1:9"], "dask: tcp://127.0.0.1:9: no scheduler there"),
        (["--dask", "nowhere"], "dask: nowhere: should be an address like"),
        (["--dask", "tcp://[::1"], "dask: tcp://[::1: should be an address like"),
    ],
)
def test_bad_input_exits_2(flags, message, tasks, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(pools.Cluster.__init__, "__defaults__", (0.5,))
    folder = str(tasks("a"))
    code, out, err = run(capsys, "batch", folder, "-o", str(tmp_path / "out"), *flags)
    assert (code, out) == (2, "")
    assert message in err
    assert len(err.splitlines()) == 1


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"jobs": 1.5}, "jobs: 1.5: should be a whole number"),
        ({"jobs": "2"}, "jobs: '2': should be a whole number"),
        ({"jobs": True}, "jobs: True: should be a whole number"),
        ({"jobs": None}, "jobs: None: should be a whole number"),
        ({"patience": "long"}, "patience: 'long': should be a number"),
        ({"dask": 8786}, "dask: 8786: should be an address like tcp://host:8786"),
    ],
)
def test_bad_arguments_are_told(given, message, tasks, tmp_path):
    with pytest.raises(TaskError, match=re.escape(message)):
        graspless.batch(tasks("a"), tmp_path / "out", **given)


def test_output_that_cannot_be_written_exits_2(tasks, tmp_path, capsys):
    folder = str(tasks("a"))
    for output in (f"{folder}/a.yaml", f"{folder}/a.yaml/below", "/proc/nothing"):
        code, _, err = run(capsys, "batch", folder, "-o", output)
        assert code == 2
        assert "cannot be written" in err
    with pytest.raises(TaskError, match="None: should be the path of a file"):
        graspless.batch(folder, None)


def test_a_plan_that_cannot_be_written_ends_the_batch(tasks, tmp_path, capsys):
    folder, output = tasks("a/card", "b"), tmp_path / "out"
    output.mkdir()
    (output / "a").write_text("a file where a folder is wanted")
    code, _, err = run(capsys, "batch", str(folder), "-o", str(output))
    assert (code, err) == (2, f"{output / 'a'}: cannot be written: is a file, not a folder\n")


def test_json_is_all_that_is_printed(here, tasks, tmp_path, capsys):
    code, out, err = run(capsys, "batch", str(tasks("a")), "-o", str(tmp_path / "out"), "--json")
    assert (code, err) == (0, "")
    assert json.loads(out) == json.loads((tmp_path / "out" / "summary.json").read_text())
    assert json.loads(out)["statuses"] == {"solved": 1}


def test_quantiles_are_tasks_times():
    row = {"holds": True, "status": "solved", "faults": [], "reason": "", "name": ""}
    rows = [row | {"seconds": float(i)} for i in range(1, 101)] + [row | {"seconds": None}]
    summary = Summary(rows, tasks=101, kept=1, jobs=1, seconds=10.0)
    assert summary.planning_seconds == {"p50": 50, "p90": 90, "p99": 99, "max": 100}
    assert summary.as_dict()["tasks_per_second"] == 10
    assert Summary([], tasks=1, kept=0, jobs=1, seconds=0.0).planning_seconds == {}


@pytest.fixture(scope="module")
def cluster():
    distributed = pytest.importorskip("distributed")
    dask = pytest.importorskip("dask")
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 0}),  # one death says enough
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
        ) as started,
    ):
        yield started


def test_two_dask_workers(cluster, tasks, tmp_path):
    folder, output = tasks("a", "b", "c", "d"), tmp_path / "out"
    (folder / "bad.yaml").write_text("kind: nothing")
    summary = graspless.batch(folder, output, dask=cluster.scheduler_address)
    assert (summary.held, summary.tasks, summary.jobs) == (4, 5, 2)
    assert "bad.yaml:1: kind: nothing" in rows_of(output)["bad"]["reason"]
    for name in "ad":
        plan = graspless.load_plan(output / f"{name}.plan.json")
        assert without_clock(plan) == without_clock(graspless.plan(folder / f"{name}.yaml"))
    assert graspless.batch(folder, output).kept == 4  # the same tasks, wherever they are planned
    assert graspless.batch(folder, output, dask=cluster.scheduler_address).kept == 4


def test_dask_workers_see_no_files_of_ours(tasks, tmp_path):
    folder = tasks("a")
    (folder / "own.hand.yaml").write_text(
        "{finger_model: flexure, flexure_length: 0.11, flexure_stiffness: 4.6, tip_radius: 0.004}"
    )
    text = changed("object:", "hand: own.hand.yaml\nobject:")
    (folder / "a.yaml").write_text(text)
    direct = work.carry_out(work.Job("a", str(folder / "a.yaml"), {"seed": 5}))
    job = work.inline(work.Job("a", str(folder / "a.yaml"), {"seed": 5}))
    (folder / "a.yaml").unlink()
    (folder / "own.hand.yaml").unlink()
    away = work.carry_out(job)
    assert away.row["status"] == "solved"
    assert away.row["hash"] == direct.row["hash"]


def test_a_dask_worker_that_dies(cluster, tasks, tmp_path):
    folder, output = tasks("a", "b", "killer"), tmp_path / "out"
    runner = batches._Run(names.find(folder), output, {})
    with pools.opened(1, cluster.scheduler_address) as pool:
        summary = runner.carry_out(pool, batch_common.dangerous)
    statuses = {row["name"]: row["status"] for row in summary.rows}
    assert statuses == {"a": "solved", "b": "solved", "killer": "crashed"}


def test_a_dask_scheduler_without_workers():
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(n_workers=0, processes=True, dashboard_address=":0") as alone,
        pytest.raises(TaskError, match=r"dask: tcp://.*: no worker within 1 s"),
    ):
        pools.Cluster(alone.scheduler_address, seconds=1.0)


def test_a_clock_of_asyncio_is_told_too(monkeypatch):
    """Until Python 3.11 its TimeoutError is another one, and no OSError."""
    distributed = pytest.importorskip("distributed")
    fault = type("TimeoutError", (Exception,), {})
    monkeypatch.setattr(pools.asyncio, "TimeoutError", fault)

    def late(*_, **__):
        raise fault

    monkeypatch.setattr(distributed, "Client", late)
    with pytest.raises(TaskError, match="no scheduler there: TimeoutError"):
        pools.Cluster("tcp://there:1")
    client = unittest.mock.Mock(nthreads=lambda: {"worker": 1}, run=lambda *_, **__: {})
    monkeypatch.setattr(distributed, "Client", lambda *_, **__: client)
    cluster = pools.Cluster("tcp://there:1")
    client.nthreads = late
    with pytest.raises(TaskError, match="the scheduler has gone"):
        cluster.look()
    client.nthreads = lambda: {"tcp://a:1": 1, "tcp://b:1": 4}
    with pytest.raises(TaskError, match=r"tcp://b:1: should have 1 thread \(--nthreads 1\), has 4"):
        pools.Cluster("tcp://there:1")
    client.wait_for_workers = late
    with pytest.raises(TaskError, match="no worker within 10 s"):
        pools.Cluster("tcp://there:1")


@pytest.mark.slow
def test_a_dask_cluster_without_workers(cluster, monkeypatch):
    spreading = importlib.import_module("graspless.batches.spread")
    monkeypatch.setattr(spreading, "LOOK_SECONDS", 0.1)
    monkeypatch.setattr(pools.Cluster, "lonely_seconds", 0.5)
    with (
        pytest.raises(TaskError, match=r"dask: no workers for \d s; what is done is kept"),
        pools.opened(1, cluster.scheduler_address) as pool,
    ):
        cluster.scale(0)
        while pool._client.nthreads():
            time.sleep(0.05)
        list(spread(batch_common.sleeps, [60.0], pool, lambda *_: None))
