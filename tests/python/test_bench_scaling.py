# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curves of growth in small, the fit of their exponents, and what the command writes."""

import dataclasses
import json
from pathlib import Path

import pytest

from graspless.cli import main
from graspless_bench.scaling import measure, report
from graspless_bench.scaling.curves import CURVES, Curve, Done

RESULTS = Path(__file__).parents[2] / "docs" / "results"


@pytest.mark.parametrize("power", [0, 0.5, 1, 3])
def test_the_exponent_of_a_power_law_is_its_power(power):
    sizes = [1, 3, 10, 40]
    assert measure.exponent(sizes, [2e-3 * n**power for n in sizes]) == pytest.approx(power)


@pytest.mark.parametrize("curve", [c for c in CURVES if not c.is_wall], ids=lambda c: c.name)
def test_the_smallest_problem_of_each_curve_has_a_result(curve):
    rows, is_complete = measure.run([dataclasses.replace(curve, sizes=curve.sizes[:1])])
    assert is_complete
    assert [row["status"] in measure.GOOD for row in rows] == [True]


def test_the_seconds_that_a_run_reports_count():
    curve = Curve("own", "", (1, 2), lambda n: lambda: Done("solved", float(n)))
    rows, _ = measure.run([curve])
    assert [row["seconds_of_runs"] for row in rows] == [[1.0, 1.0], [2.0]]


def test_a_query_without_a_result_is_a_complaint():
    curve = Curve(CURVES[0].name, "", (1, 2), lambda n: lambda: Done("no_plan", 1.0))
    rows, is_complete = measure.run([curve])
    result = report.as_result(rows, is_complete, [0, 0, 0])
    assert result["complaints"] == [f"{curve.name}, {n}: no_plan" for n in (1, 2)]
    assert result["curves"][0]["exponent"] == pytest.approx(0, abs=1e-9)


def test_the_command_writes_its_page(tmp_path, capsys):
    arguments = ["--curve", "fingertip: faces", "--json", "--out", str(tmp_path)]
    assert main(["bench", "scaling", *arguments]) == 0
    result = json.loads(capsys.readouterr().out)
    assert [row["size"] for row in result["rows"]] == [4, 8, 16, 32]
    assert {path.name for path in tmp_path.iterdir()} == {
        f"scaling.{e}" for e in ("json", "md", "png")
    }
    assert "| fingertip: faces, 32 |" in (tmp_path / "scaling.md").read_text()


def test_unknown_curves_are_refused_with_the_choices(capsys):
    assert main(["bench", "scaling", "--curve", "boxes"]) == 2
    assert "--curve: 'boxes': should be one of 'fingertip: locations', " in capsys.readouterr().err


def test_results_were_made_by_this_code():
    result = json.loads((RESULTS / "scaling.json").read_text())
    assert result["complete"]
    sizes = [(row["curve"], row["size"]) for row in result["rows"]]
    assert sizes == [(curve.name, size) for curve in CURVES for size in curve.sizes]
