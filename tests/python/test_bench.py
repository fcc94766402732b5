# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The experiments in small: the frozen grid, the statistics, and each grid through the command."""

import json
import math
import os
import signal
import threading

import numpy as np
import pytest

from graspless import slide
from graspless.cli import main
from graspless_bench import _peers, statistics, tables
from graspless_bench.slide import grid, report, run, shapes, sscbirrt, summary
from tasks_common import read_png

KEYS = {
    *("runs", "solved", "p50_ms", "p90_ms", "p99_ms"),
    *("solved_100ms", "solved_1s", "violations", "peak_mb"),
}


def bench(capsys, *arguments):
    code = main(["bench", "slide", "--json", *map(str, arguments)])
    return code, json.loads(capsys.readouterr().out)


def section(result, name):
    return next(r for r in result["rows"] if r["by"] == "section" and r["name"] == name)


# The frozen grid


def test_the_grid_is_frozen():
    start = grid.Start("round", "crescent", 0.5, 3, seed=1)
    assert start.draw_pose() == (0.7767124440692457, 0.0570102780721623, 5.212149902468891)
    assert start.draw_seed() == 3735388771


def test_equal_starts_have_equal_poses():
    first, second = (list(grid.starts(60, seed=2)) for _ in range(2))
    assert [s.draw_pose() for s in first] == [s.draw_pose() for s in second]
    assert len({s.draw_pose() for s in first}) == 60


def test_another_seed_gives_other_poses():
    one, two = (grid.Start("long", "square", 1, 0, seed).draw_pose() for seed in (1, 2))
    assert one != two


def test_poses_do_not_depend_on_the_number_of_runs():
    assert set(grid.starts(40, seed=1)) < set(grid.starts(100, seed=1))


def test_runs_are_dealt_evenly():
    starts = list(grid.starts(1000, seed=1))
    for table in shapes.TABLES:
        for name in shapes.OBJECTS:
            assert sum(s.table == table and s.object == name for s in starts) == 50


@pytest.mark.parametrize("scale", [1, 0.5])
@pytest.mark.parametrize("name", [*shapes.OBJECTS, *shapes.LETTERS])
@pytest.mark.parametrize("table", shapes.TABLES)
def test_starts_are_problems(table, name, scale):
    trial = grid.Trial(grid.Start(table, name, scale, 0, seed=1))
    slide.validate(trial.make_problem())
    slide.validate(trial.make_options())


def test_the_papers_terms():
    trial = grid.Trial(next(grid.starts(1, 1)))
    options, hand = trial.make_options(), trial.make_problem().hand
    assert hand.finger_model is slide.FingerModel.impedance
    assert (options.min_depth, options.max_depth) == (0.005, 0.025)
    assert (options.com_margin, options.tip_margin, options.rim_margin) == (0.001, 0, 0)
    assert (options.min_overhang, options.root_scale) == (0.02, 100)


def test_the_defaults_are_the_librarys():
    trial = grid.Trial(next(grid.starts(1, 1)), defaults=True)
    assert repr(trial.make_options()) == repr(slide.Options(min_depth=0.005, max_depth=0.025))
    assert repr(trial.make_problem().hand) == repr(slide.Hand())


# Statistics


@pytest.mark.parametrize(("k", "n"), [(0, 10), (1, 10), (5, 10), (10, 10), (990, 1000), (81, 263)])
def test_wilson_is_scipys(k, n):
    scipy_stats = pytest.importorskip("scipy.stats")
    expected = scipy_stats.binomtest(k, n).proportion_ci(0.95, method="wilson")
    assert statistics.wilson(k, n) == pytest.approx((expected.low, expected.high), abs=1e-12)


def test_wilson_of_the_textbook():
    # Newcombe 1998, table I: 81 of 263
    assert statistics.wilson(81, 263) == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert statistics.wilson(0, 0) == (0, 1)


def test_quantiles_with_unsolved_runs():
    times = [0.3, math.inf, 0.1, 0.2]
    assert statistics.quantile(times, 0.5) == 0.2
    assert statistics.quantile(times, 0.75) == 0.3
    assert statistics.quantile(times, 0.99) == math.inf
    assert statistics.quantile([], 0.5) == math.inf


# Runs


def test_a_plan_that_does_not_hold_is_counted_and_not_solved(monkeypatch):
    monkeypatch.setattr(slide, "check", lambda *_: ["slide row 3: roll"])
    result = run.run([grid.Trial(next(grid.starts(1, 1)))], 10)
    row = summary.summarize(result.outcomes, result, 10)
    assert (row["runs"], row["solved"], row["violations"]) == (1, 0, 1)
    assert row["p50_ms"] is None
    assert row["mean_ms"] == 10_000


def test_ctrl_c_keeps_what_was_checked(monkeypatch):
    def tell(done, _):
        if done == run.BATCH + 3:
            raise KeyboardInterrupt

    trials = [grid.Trial(start) for start in grid.starts(2 * run.BATCH, 1)]
    result = run.run(trials, 10, tell)
    assert not result.is_complete
    assert len(result.outcomes) == run.BATCH


def test_ctrl_c_says_that_results_are_partial(tmp_path, capsys):
    timer = threading.Timer(2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    code = main(["bench", "slide", "--runs", "5000", "--json", "--out", str(tmp_path)])
    timer.join()
    out, err = capsys.readouterr()
    assert code == 130
    assert not json.loads(out)["complete"]
    assert "partial" in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("draw", _peers.PairDraw)
def test_a_pair_repeats(draw):
    trial = grid.Trial(next(grid.starts(1, 1)), range=0.0)
    args = trial.make_problem(), trial.make_options(), draw
    first, second, other = (_peers.PairProblem(*args, seed) for seed in (5, 5, 6))
    assert first.has_pair
    assert first.start.tolist() == second.start.tolist() != other.start.tolist()
    assert first.goal.tolist() == second.goal.tolist()


@pytest.mark.parametrize("peer", _peers.Peer)
def test_peers_find_paths_and_these_hold(peer):
    held = 0
    for start in grid.starts(6, 1, tables=("square",)):
        trial = grid.Trial(start, range=0.0)
        problem, options = trial.make_problem(), trial.make_options()
        pair = _peers.PairProblem(problem, options, _peers.PairDraw.fitting, start.draw_seed())
        plan, seconds = pair.run(peer, trial.make_budget(1))
        assert 0 < seconds < 1.2
        if plan:
            assert [s.name for s in plan.segments][2] == "slide"
            held += not slide.check(problem, plan, options)
    assert held >= 3  # BiEST's paths fail their check now and then


# The command


def test_paper_grid(capsys, tmp_path):
    code, result = bench(capsys, "--runs", 4, "--out", tmp_path)
    assert code == 0
    assert result.keys() >= KEYS
    assert (result["runs"], result["violations"], result["complete"]) == (4, 0, True)
    assert all(row.keys() >= KEYS for row in result["rows"])
    assert {row["by"] for row in result["rows"]} >= {"section", "table", "object", "scale", "cell"}
    assert {row["name"] for row in result["rows"] if row["by"] == "table"} == set(shapes.TABLES)
    assert {row["name"] for row in result["rows"] if row["by"] == "scale"} == {"1", "0.5"}
    assert result["machine"]["cpu"]
    drawn = read_png(tmp_path / "slide_paper.png")
    assert np.count_nonzero(np.ptp(drawn[..., :3], axis=2) > 0.2) > 300  # coloured
    assert "frozen grid" in (tmp_path / "slide.md").read_text()


def test_reconfiguration_grid(capsys, tmp_path):
    code, result = bench(
        capsys, "--grid", "reconfiguration", "--runs", 4, "--time", 0.3, "--out", tmp_path
    )
    assert code == 0
    assert len([r for r in result["rows"] if r["by"] == "section"]) == 6
    assert section(result, "range 0 cm, fast")["solved"] == 4
    assert "53 s" in (tmp_path / "slide.md").read_text()


def test_baselines_grid(capsys, tmp_path):
    code, result = bench(
        capsys, "--grid", "baselines", "--runs", 4, "--time", 0.1, "--out", tmp_path
    )
    assert code == 0
    assert {f["method"] for f in result["failed_checks"]} <= set(grid.OMPL_PEERS)
    assert section(result, "range 2 cm, fast")["violations"] == 0
    assert section(result, "fitting pairs, forest")["runs"] == 4
    assert "TangentBundle" in (tmp_path / "slide.md").read_text()


def test_ur5e_grid(capsys, tmp_path):
    arguments = ("--grid", "ur5e", "--runs", 3, "--time", 1, "--out", tmp_path)
    _, result = bench(capsys, *arguments)
    assert section(result, "UR5e, fast")["solved"] == 3
    assert section(result, "UR5e, fitting, forest")["violations"] == 0
    page = (tmp_path / "slide.md").read_text()
    assert "## A UR5e, and sscbirrt" in page
    shown = "sscbirrt, Python, our collision tests" in page
    assert shown == sscbirrt.is_installed()


def test_any_path_of_the_pair_gets_its_motions():
    """A straight path is checked like a peer's: it holds, or check() says where it does not."""
    trial = next(iter(grid.arms(1, 1)))
    problem, options = trial.make_problem(), trial.make_options()
    pair = _peers.PairProblem(problem, options, _peers.PairDraw.fitting, 1)
    assert pair.is_valid(pair.start)
    assert not pair.is_valid(pair.start + 0.3)  # off the table's top
    plan = pair.completed([pair.start, pair.goal])
    assert plan
    group = problem.robot.group(problem.hand.arm)
    slid = next(segment for segment in plan.segments if segment.name == "slide")
    np.testing.assert_allclose(np.asarray(slid.positions[0])[group], pair.start)
    np.testing.assert_allclose(np.asarray(slid.positions[-1])[group], pair.goal)
    bad = pair.completed([pair.start, pair.start + 0.3, pair.goal])
    assert any("slide" in fault for fault in slide.check(problem, bad, options))


def test_roots_grid(capsys, tmp_path):
    code, result = bench(
        capsys,
        "--grid",
        "roots",
        "--runs",
        2,
        "--time",
        0.1,
        "--search",
        "paper",
        "--out",
        tmp_path,
    )
    assert code == 0
    sections = [r["name"] for r in result["rows"] if r["by"] == "section"]
    assert sections == [f"N* {scale}, paper" for scale in grid.ROOT_SCALES]
    assert (tmp_path / "slide_roots.png").exists()


def test_text_without_json(capsys):
    assert main(["bench", "slide", "--runs", "1"]) == 0
    out = capsys.readouterr()
    assert "failed checks" in out.out
    assert out.err == ""  # no progress bar where nobody watches


def test_the_slowest_of_many_runs_are_named(capsys, monkeypatch):
    monkeypatch.setattr(report, "MANY", 3)
    assert main(["bench", "slide", "--grid", "frozen", "--runs", "3"]) == 0
    assert "frozen, fast: " in capsys.readouterr().out
    curve = {"name": "c", "runs": 20_000, "times_ms": [1.0] * 19_990 + [33.0] * 6 + [50.0]}
    line = "c: 19,996 of 20,000 solved within 33 ms; 99.99 % inf, slowest 50"
    assert report._slowest(curve) == line


@pytest.mark.parametrize("wrong", [["--runs", "0"], ["--time", "-1"], ["--grid", "other"]])
def test_bad_arguments(wrong, capsys):
    with pytest.raises(SystemExit) as error:
        main(["bench", "slide", *wrong])
    assert error.value.code == 2
    assert wrong[0] in capsys.readouterr().err


def test_an_unwritable_directory_is_told_before_work(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert main(["bench", "slide", "--runs", "1000000", "--out", str(tmp_path / "file")]) == 2
    assert "cannot be written" in capsys.readouterr().err


def test_a_dash_stands_for_never():
    assert tables.milliseconds(None) == "–"
    assert [tables.milliseconds(x) for x in (0.4123, 12.34, 1234.5)] == ["0.412", "12.3", "1234"]


@pytest.mark.parametrize(
    ("table", "thing", "index"),
    [
        ("round", "irregular", 1752),  # its grasp, drawn for a pose, is of another tie
        ("square", "irregular", 3112),
        ("round", "irregular", 3690),  # the centre of what sticks out is on the outline
        ("square", "triangle", 3841),  # the arm bends sideways just above the object
    ],
)
def test_rare_plans_pass_their_check(table, thing, index):
    """The four of 100,000 plans of the frozen grid that did not."""
    trial = grid.Trial(grid.Start(table, thing, 1.0, index, 7))
    problem, options = trial.make_problem(), trial.make_options()
    plan = slide.plan(problem, options, trial.make_budget(10))
    assert plan
    assert slide.check(problem, plan, options) == []
