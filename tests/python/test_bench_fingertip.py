# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The fingertip planner's experiments through the command, and the page they make."""

import json

import pytest

from graspless.cli import main
from graspless_bench.fingertip import grid as grids
from graspless_bench.fingertip import report
from graspless_bench.fingertip.run import Run, complaints, run

KEYS = {"case", "engine", "cost", "regrasps", "z_evaluations", "seconds", "peak_mb"}


def bench(capsys, *arguments):
    code = main(["bench", "fingertip", "--json", *map(str, arguments)])
    return code, json.loads(capsys.readouterr().out)


@pytest.fixture(scope="module")
def slides():
    """Two cheap trials of the weak grid."""
    return run(list(grids.weak(["fast"]))[1:3], runs=1, seconds=20)


def test_the_papers_cases(capsys):
    code, result = bench(capsys, "--engine", "fast", "--runs", 1)
    rows = {row["case"]: row for row in result["rows"]}
    assert code == 0, result["complaints"]
    assert rows.keys() >= grids.REFERENCE_COSTS.keys()
    for case, cost in grids.REFERENCE_COSTS.items():
        row = rows[case]
        assert row.keys() >= KEYS
        assert row["cost"] == pytest.approx(cost, abs=1e-6)
        assert row["lower_bound"] == pytest.approx(row["cost"], rel=1e-9)
        assert row["faults"] == []
        assert row["z_evaluations"] > 0
    assert [rows[case]["regrasps"] for case in "abcd"] == [0, 0, 0, 1]


def test_every_grid_makes_tasks():
    for make, engines in grids.GRIDS.values():
        trials = list(make(engines))
        assert trials
        for trial in trials:
            task = trial.make_task(5)
            assert task.options.search.name == trial.engine
            assert task.budget.seconds == 5
            assert not task.options.explain


def test_the_paper_grid_compares_all_engines():
    make, engines = grids.GRIDS["paper"]
    pairs = {(trial.case, trial.engine) for trial in make(engines)}
    assert pairs >= {(case, engine) for case in "abcd" for engine in grids.ENGINES}


def test_a_known_cost_that_is_missed(slides):
    row = slides.found[0].row
    assert complaints([row]) == []
    assert "known" in complaints([row | {"case": "b"}])[0]


def test_a_plan_that_fails_its_check(slides):
    assert complaints([slides.found[0].row | {"faults": ["row 3: stability"]}]) == [
        "slide, 10 N, fast: row 3: stability"
    ]


def test_engines_that_differ(slides):
    row = slides.found[0].row
    dearer = {"engine": "dijkstra", "cost": row["cost"] * (1 + 1e-7)}
    other = row | dearer | {"lower_bound": dearer["cost"]}
    assert "another engine's" in complaints([row, other])[0]
    assert complaints([row, other | {"lower_bound": 0.0}]) == []  # stopped before it was optimal


def test_the_page(slides, tmp_path):
    result = report.as_result("weak", slides, (0.1, 0.2, 0.3))
    report.write(result, tmp_path)
    text = (tmp_path / "fingertip.md").read_text()
    assert "| slide, 10 N, fast | 10.016453262 |" in text
    assert "- slide, 10 N: slide (" in text
    assert "$" not in text
    assert json.loads((tmp_path / "fingertip_weak.json").read_text()) == result


def test_an_interrupted_run_says_so(slides):
    partial = Run(slides.found, is_complete=False)
    assert "INTERRUPTED" in report.as_text(report.as_result("weak", partial, (0, 0, 0)))


def test_unknown_grid():
    with pytest.raises(SystemExit) as end:
        main(["bench", "fingertip", "--grid", "fish"])
    assert end.value.code == 2
