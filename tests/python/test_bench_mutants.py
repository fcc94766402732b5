# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans broken on purpose: `check` finds every mutant, and the bench counts."""

import json

import pytest

import graspless
from graspless.simulation import Trial
from graspless_bench.physics import claims, fingertip_tasks, mutants, run, tables, work
from graspless_bench.physics.clasp_tasks import physics_tasks as clasp_tasks
from graspless_bench.physics.slide_tasks import physics_tasks as slide_tasks

TASKS = {"slide": slide_tasks, "fingertip": fingertip_tasks.forceful_tasks, "clasp": clasp_tasks}


@pytest.fixture(scope="module", params=TASKS)
def document(request):
    which = 1 if request.param == "slide" else 0  # a weak flexure is benign in the first task
    plan = graspless.plan(list(TASKS[request.param](which + 1))[which], seed=1)
    assert graspless.check(plan) == []
    return json.loads(plan.to_json())


def test_check_finds_every_mutant(document):
    before = json.dumps(document)
    for mutant in mutants.mutants(document["kind"]):
        broken = mutant.of(document)
        assert broken != document, mutant.name
        assert mutants._checked(broken), mutant.name
    assert json.dumps(document) == before


@pytest.mark.parametrize(("kind", "least"), [("slide", 15), ("fingertip", 10), ("clasp", 8)])
def test_there_are_enough_that_matter(kind, least):
    found = mutants.mutants(kind)
    assert len({mutant.name for mutant in found}) == len(found)
    assert sum(not mutant.benign for mutant in found) >= least


def test_forces_matter_in_tasks_that_tumble():
    tasks = list(fingertip_tasks.forceful_tasks(2))
    assert [task.source.file[-1] for task in tasks] == ["c", "d"]


def test_what_finds_a_mutant_is_counted(monkeypatch):
    def execute(plan, variation, *, record=False):
        names = [segment.name for segment in plan.segments]
        if "lift" not in names:
            raise RuntimeError("cannot")
        failed = () if "slide" in names and plan.X_WO_goal[1, 3] < 5 else ("off_target", "fell")
        return Trial(variation, failed, {}, 0.1)

    few = [m for m in mutants.mutants("slide") if m.name in ("no slide", "not lifted", "overhang")]
    monkeypatch.setattr("graspless.simulation.slide.run", execute)
    for module in (mutants, claims, tables):
        monkeypatch.setattr(module, "mutants", lambda kind: few)
    grid = run.Grid("slide", runs=2, experiment="mutants")
    rows = [work.measure(query) for query in grid.queries()]
    assert grid.part == "slide_mutants"
    found = rows[0]["mutants"]
    assert found["no slide"]["simulate"] == "off_target, fell"
    assert found["not lifted"]["simulate"] == "RuntimeError: cannot"
    assert found["overhang"]["check"].startswith("goal: the overhang")
    result = {"part": grid.part, "kind": "slide", "rows": rows}
    counts = {row["name"]: row for row in tables.broken(result)[0]}
    assert [counts["no slide"][name] for name in ("plans", "check", "simulate")] == [2, 2, 2]
    assert [counts["overhang"][name] for name in ("plans", "check", "simulate")] == [2, 2, 0]
    assert counts["no slide"]["failures"] == "off target, fell"
    assert counts["not lifted"]["failures"] == "refused"
    assert counts["overhang"]["failures"] == ""
    by_check, by_simulate, either = claims._broken("slide")
    answers = [by_simulate.holds(case) for case in claims.cases(rows, claims.BROKEN)]
    assert answers.count(None) == 2  # the benign one
    assert answers.count(True) == 4
    # A plan that fails as it is says nothing about its mutants.
    monkeypatch.setattr(
        "graspless.simulation.slide.run", lambda plan, v, **_: Trial(v, ("fell",), {}, 0.1)
    )
    row = work.measure(next(iter(grid.queries())))
    assert row["mutants"] is None
    assert list(claims.cases([row], claims.BROKEN)) == []
