# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The clasp planner's experiments through the command, and the page they make."""

import itertools
import json
import math
from pathlib import Path

import pytest

from graspless import clasp
from graspless.cli import main
from graspless_bench.clasp import grid as grids
from graspless_bench.clasp import loops, measure, peers, report, run, small

KEYS = {
    *("hand", "object", "pose", "found", "cycles", "nodes", "seconds"),
    *("virtual_linking_min", "virtual_linking_max", "secure"),
}


@pytest.fixture(scope="module")
def one():
    """The first task of the paper's, as a whole run."""
    trial = next(grids.paper(1))
    return run.Run("paper", [measure.measure(trial, 10)], is_complete=True)


def test_a_row_says_all_that_is_asked(one):
    (row,) = one.rows
    assert row.keys() >= KEYS
    assert row["found"], row["reason"]
    assert row["secure"]
    assert row["faults"] == []
    assert 0 < row["virtual_linking_min"] <= row["virtual_linking_max"] <= 1
    assert 0 < row["gauss_min"] <= row["gauss_max"]
    assert row["linking_reached"] >= row["min_linking"]
    assert row["open_hand_escapes"]


def test_totals_count_like_the_paper(one):
    row = one.rows[0]
    rows = [row | {"cycles": c} for c in (1, 9, 10, 52, 53)] + [row | {"found": False}]
    totals = measure.totals(rows)
    assert totals["tasks"] == 6
    assert totals["found"] == 5
    assert totals["within_52_cycles"] == 4
    assert totals["under_10_cycles"] == 2
    assert totals["max_cycles"] is None
    assert measure.totals(rows[:5])["median_cycles"] == 10


def test_the_paper_grid_is_whole():
    tasks = {(t.hand, t.object, t.pose) for t in grids.paper(1)}
    assert len(tasks) == 60
    assert {name for _, name, _ in tasks} == set(clasp.sample_object_names())
    assert run.count("paper", 2) == 120


def test_searches_for_small_holes_are_limited_by_cycles():
    trial = next(iter(grids.small(1)))
    budget = trial.make_budget(None)
    assert (budget.seconds, budget.iterations) == (math.inf, grids.CYCLES)
    assert trial.make_budget(2.0).seconds == 2.0
    assert next(iter(grids.paper(1))).make_budget(None).iterations is None


def test_results_of_small_holes_were_made_by_this_code():
    """All rows have the trials' names; those of the first pose that take few cycles say the same."""
    path = Path(__file__).parents[2] / "docs" / "results" / "clasp_small.json"
    result = json.loads(path.read_text())
    trials = list(grids.small(1))
    assert [(row["object"], row["pose"]) for row in result["rows"]] == [
        (trial.object, trial.pose) for trial in trials
    ]
    quick = [(t, r) for t, r in zip(trials, result["rows"], strict=True) if r["cycles"] < 50]
    quick = [(trial, row) for trial, row in quick if trial.pose == 1]
    assert any(row["found"] and row["cycles"] > 20 for _, row in quick)  # others than the first
    for trial, row in quick:
        found = measure.measure(trial, None)
        assert found.keys() == row.keys(), f"{path.name} is old: run its command again"
        for name in ("found", "status", "cycles", "reason"):
            assert found[name] == row[name], f"{path.name} is old: {trial.name}: {name}"
    assert result["totals"] == small.totals(result["rows"])
    assert result["totals"]["refused_without"] == 0
    solved = f"Of {len(trials)} queries {result['totals']['solved']} are"
    assert solved in path.with_name("clasp.md").read_text()


def test_every_start_is_free():
    budget_of_none = 1e-3
    for trial in itertools.chain(grids.paper(1), grids.chair(1)):
        plan = clasp.plan(
            trial.make_problem(), trial.make_options(), trial.make_budget(budget_of_none)
        )
        assert plan.status is not clasp.Status.start_in_collision, f"{trial.name}: {plan.reason}"


def test_the_obstructed_loop_is_in_front_under_the_seat():
    chair = grids.sample("chair")
    middle = chair.loops.found[grids.front_loop(chair)].points.mean(axis=0)
    assert middle[0] > 0.1
    assert abs(middle[1]) < 0.05
    assert middle[2] < 0.42


def test_a_fault_is_a_complaint(one):
    row = one.rows[0] | {"faults": ["close row 3: touches"]}
    assert measure.complaints([row]) == [
        "kr5_sdh, purse, pose 1, seed 1: close row 3: touches",
    ]


def test_a_grasp_of_the_peer():
    trial = next(grids.purses(1))
    found = peers.grasp(trial, 20)
    assert found["planner"] == "grasp_rrt"
    if found["found"]:
        assert found["quality"] > 0
        assert found["contacts"] >= 2
    totals = peers.totals([found, found | {"envelops": True, "on_handle": True}])
    assert totals["grasp_rrt"]["runs"] == 2
    assert totals["grasp_rrt"]["envelops"] >= 1


def test_clouds_of_all_kinds(monkeypatch):
    monkeypatch.setattr(loops, "HOLES", {"purse": 1})
    monkeypatch.setattr(loops, "CLOUDS", loops.CLOUDS[:5])
    rows = list(loops.rows())
    assert [row["loops"] for row in rows][:4] == [1] * 4  # two views have a seam
    sizes = {row["cloud"]: row["points"] for row in rows}
    assert sizes["one view"] < sizes["two views"] < sizes["clean"]
    assert sizes["missing patches"] < sizes["clean"]
    assert loops.totals(rows)["clean"]["right"] == 1


def test_the_page(one, tmp_path):
    result = report.as_result(one, (0.0, 0.0, 0.0))
    report.write(result, tmp_path)
    assert json.loads((tmp_path / "clasp_paper.json").read_text())["totals"]["found"] == 1
    assert (tmp_path / "clasp_linking.png").stat().st_size > 10_000
    page = (tmp_path / "clasp.md").read_text()
    assert "| found | 1 | 60 |" in page
    assert "$" not in page
    assert "found: 1" in report.as_text(result)


def test_the_command(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(loops, "HOLES", {"bag": 1})
    monkeypatch.setattr(loops, "CLOUDS", loops.CLOUDS[:1])
    arguments = ["bench", "clasp", "--grid", "loops", "--json", "--out", str(tmp_path)]
    assert main(arguments) == 0
    result = json.loads(capsys.readouterr().out)
    assert result["rows"][0]["loops"] == 1
    assert "0.96" in (tmp_path / "clasp.md").read_text()
