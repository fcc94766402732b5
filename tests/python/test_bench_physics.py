# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The bench of plans in a physics engine, without one: rows, tables, and the page they make."""

import contextlib
import importlib
import json
import re
import sys
import types
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import ConvexHull

import batch_common
from graspless import TaskError, kinds, simulation
from graspless.batches import manifest, pools
from graspless.cli import main
from graspless.simulation import Trial
from graspless.simulation.slide import conditions
from graspless.tasks import read_task
from graspless_bench.physics import claims, fingertip_shapes, locked, report, tables, work
from graspless_bench.physics import run as physics
from graspless_bench.statistics import wilson
from tasks_common import changed

FAILURES = {"fell": "off the table", "not_grasped": "left behind", "hit": "touched"}
MEASURES = {"position_error": "of the object [m]", "angle_error": "of the object [rad]"}
SEQUENCES = {"sequences": 10.0, "held_dragged": 9.0}  # of clasps


def run_trial(plan, variation, *, record=False):
    """Trial k is off by k mm and by a degree; a light object falls."""
    error = 0.001 + abs(variation.x)
    failures = ("fell",) if variation.mass < 0.85 else ()
    measures = SEQUENCES | {"position_error": error} | ({} if failures else {"angle_error": 0.02})
    return Trial(variation, failures, measures, seconds=0.25)


def follow(plan, variation, seed, *, record=False):
    """In closed loop a kick alone is a failure, and the errors are half as large."""
    failures = ("stopped",) if variation.kick_yaw else ()
    measures = {"position_error": 0.001, "angle_error": 0.01, "resumes": 2.0, "restarts": 1.0}
    measures |= {"resume_seconds": 0.002 if variation.kick_yaw else 0.02, "anew_seconds": 0.005}
    return Trial(variation, failures, measures, seconds=0.5)


def disturb(plan):
    return {"segment": 0, "row": 2, "smallest": float("inf"), "z": 4.0, "compliant": 2.0,
            "ratio": float("inf"), "compliant_ratio": 0.9, "withstands": 1.0,
            "withstands_ratio": float("inf")}  # fmt: skip


def measure_locked(plan, seed):
    """A closed hand that is caged and holds, and two that are not and lose the loop; one is held."""
    known = {"caged": [1.0, 0.0, 0.0], "upper": [-0.002, 0.01, 0.005], "lower": [-0.004, 0.0, 0.004],
             "margin": [0.7, 0.8, 0.6], "linking": [0.9, 0.8, 0.7],
             "certificate_seconds": [0.1, 0.2, 0.3], "moves_seconds": [0.2, 0.2, 0.2]}  # fmt: skip
    of = [locked.CLOSED, locked.OPENED, locked.OPENED]
    return {"of": of, "failures": [[], ["lost"], []], "seconds": [1.0] * 3, "measures": known}


def physics_tasks(count, seed, finger_model="flexure"):
    for k in range(count):
        text = changed("seed: 3", f"seed: {seed + k}")
        text += f"hand: {{finger_model: {finger_model}, wrist_stiffness: 600}}\n"
        yield read_task(text, f"bench: card {k}")


@pytest.fixture
def engine(monkeypatch):
    """A physics engine that is none, and problems for it; everything in this process."""
    measures = MEASURES | dict.fromkeys(SEQUENCES, "sequences")
    kind = types.SimpleNamespace(
        FAILURES=FAILURES, MEASURES=measures, run=run_trial, follow=follow, draw=conditions.draw,
        CONDITIONS=conditions.CONDITIONS, FOLLOWED_FAILURES={"stopped": "given up"},
        FOLLOWED_MEASURES=dict.fromkeys(
            ["resumes", "restarts", "resume_seconds", "anew_seconds"], "plans"
        ),
    )  # fmt: skip
    monkeypatch.setattr(simulation, "simulation_kind", lambda _: kind)
    monkeypatch.setattr(report, "simulation_kind", lambda _: kind)
    monkeypatch.setattr(report.importlib.metadata, "version", lambda _: "4")
    tasks = types.SimpleNamespace(physics_tasks=physics_tasks)
    for name in physics.RUNS:
        monkeypatch.setitem(sys.modules, f"graspless_bench.physics.{name}_tasks", tasks)
    monkeypatch.setattr(work, "part", lambda *_: types.SimpleNamespace(disturb=disturb))
    monkeypatch.setattr(locked, "measure", measure_locked)
    monkeypatch.setattr(
        pools, "opened", lambda jobs, dask: contextlib.nullcontext(batch_common.Here())
    )


def test_rows_hold_every_trial(engine):
    run = physics.run(physics.Grid("slide", runs=3, trials=4, seed=7))
    assert run.is_complete
    assert run.complaints == []
    assert [row["name"] for row in run.rows] == ["000 card 0", "001 card 1", "002 card 2"]
    assert [row["seed"] for row in run.rows] == [7, 8, 9]
    for row in run.rows:
        drawn = simulation.variations(4, row["seed"])
        assert row["measures"]["position_error"] == pytest.approx(
            [0.001 + abs(v.x) for v in drawn], rel=1e-4
        )
        assert [bool(f) for f in row["failures"]] == [v.mass < 0.85 for v in drawn]
        assert [a is None for a in row["measures"]["angle_error"]] == [
            bool(f) for f in row["failures"]
        ]


def rows_of(*trials, **more):
    """A row of a plan from its trials: (failures, position error, angle error)."""
    return {
        "name": "a", "key": "k", "status": "solved", "reason": "", "seed": 1, "faults": [],
        "warnings": [], "plan_seconds": 0.1, "disturbed": None, "seconds": [1.0 + k for k in range(len(trials))],
        "failures": [list(trial[0]) for trial in trials],
        "measures": {"position_error": [t[1] for t in trials], "angle_error": [t[2] for t in trials]},
    } | more  # fmt: skip


def test_tables_count_what_they_say():
    rows = [
        rows_of(((), 0.004, 0.01), ((), 0.009, 0.1), (("fell",), None, None)),
        rows_of((("hit",), 0.006, 0.01), (("fell", "hit"), 0.02, 0.3)),
        rows_of(status="no_goal_root"),
    ]
    result = {"part": "slide", "rows": rows, "failures": FAILURES, "measures": MEASURES}
    totals = tables.totals(rows)
    assert (totals["tasks"], totals["planned"]) == (3, 2)
    assert totals["not_planned"] == {"no_goal_root": 1}
    assert (totals["nominal"], totals["nominal_held"]) == (2, 1)
    assert (totals["varied"], totals["varied_held"]) == (3, 1)
    assert totals["max_seconds"] == 3.0
    claims = {(c["name"], c["of"]): (c["held"], c["asked"]) for c in tables.claims(result)[0]}
    assert claims[
        "within 5 mm and 5 deg of the planned pose after the slide, not fallen", "nominal"
    ] == (1, 2)
    assert claims[
        "within 10 mm and 10 deg of the planned pose after the slide, not fallen", "varied"
    ] == (1, 3)
    assert claims["lifted", "nominal"] == (2, 2)
    assert claims["lifted", "varied"] == (1, 3)
    failures = {r["name"]: (r["nominal"], r["varied"]) for r in tables.failures(result)[0]}
    assert failures == {"fell": (0, 2), "not grasped": (0, 0), "hit": (1, 1)}
    error = tables.measures(result)[0][0]
    assert (error["name"], error["means"]) == ("position error [mm]", "of the object")
    assert error["nominal"] == pytest.approx({"median": 4, "95 %": 6, "max": 6})
    assert error["varied"] == pytest.approx({"median": 9, "95 %": 20, "max": 20})


def test_tubes_are_held_against_the_trials():
    tube = {"position": 0.008, "angle": 0.1}
    rows = [
        rows_of(((), 0.004, 0.01), ((), 0.004, 0.02), (("fell",), None, None), tube=tube),
        rows_of(((), 0.009, 0.01), ((), 0.002, 0.08), tube=tube),
        rows_of(((), 0.5, 0.5), ((), 0.5, 0.5)),  # of a file without tubes
    ]
    claims = tables.claims({"part": "slide", "rows": rows})[0]
    found = {c["of"]: (c["held"], c["asked"]) for c in claims if "tube" in c["name"]}
    assert found == {"nominal": (1, 2), "varied": (2, 3)}
    totals = tables.totals(rows)
    assert totals["tube_width"] == pytest.approx({"position": 2.0, "angle": 1.25})
    assert "tubes are 2.00 (position) and 1.25 (angle) times" in report._counts(totals)
    assert tables.totals(rows[2:])["tube_width"] is None
    assert "tubes" not in report._counts(tables.totals(rows[2:]))


def test_where_nothing_varied_there_is_no_count_of_it():
    result = {"part": "slide", "rows": [rows_of(((), 0.0, 0.0))], "failures": FAILURES}
    rows, shown = tables.failures(result)
    columns = dict(shown)
    assert [columns["nominal"](row) for row in rows] == ["0", "0", "0"]
    assert [columns["varied"](row) for row in rows] == ["–", "–", "–"]


def test_warnings_of_plans_are_kept(engine, monkeypatch):
    told = ["the object may stay behind"]
    warned = property(lambda plan: told, lambda plan, value: None)
    monkeypatch.setattr("graspless.slide.Plan.warnings", warned, raising=False)
    run = physics.run(physics.Grid("slide", runs=2))
    assert [row["warnings"] for row in run.rows] == [told, told]
    totals = tables.totals(run.rows)
    assert "; 2 with a warning" in report._counts(totals)
    for row in run.rows:  # as in a file of before
        del row["warnings"]
    assert "warning" not in report._counts(tables.totals(run.rows))
    del totals["warned"]
    assert "warning" not in report._counts(totals)


@pytest.mark.parametrize(
    ("part", "cases", "held"),
    [
        # (failures, measures) of nominal trials, and how many are so by the first nominal claim
        ("slide", [([], 0.005, 0.087), ([], 0.0051, 0), ([], 0, 0.088), (["fell"], 0, 0)], 1),
        ("clasp", [([], 0, 0), (["open_hand_holds"], 0, 0), (["escaped"], 0, 0)], 2),
    ],
)
def test_limits(part, cases, held):
    rows = [rows_of(case) for case in cases]
    result = {"part": part, "rows": rows}
    first = tables.claims(result)[0][0]
    assert (first["held"], first["asked"]) == (held, len(cases))


def test_an_open_hand_is_asked_only_where_something_was_pulled_at():
    def pulled(failures, force):
        row = rows_of((failures, 0, 0))
        return row | {"measures": {"open_pull": [force]}}

    rows = [pulled([], 8.0), pulled(["open_hand_holds"], 60.0), pulled(["not_closed"], None)]
    found, _ = tables.claims({"part": "clasp", "rows": rows})
    assert [(c["held"], c["asked"]) for c in found if "open hand" in c["name"]] == [(1, 2)]


def test_disturbances_against_the_index():
    def broken(z, ratio, compliant):
        smallest = None if ratio is None else ratio * z
        found = {"z": z, "ratio": ratio, "compliant_ratio": compliant, "smallest": smallest}
        return rows_of(disturbed=found)

    rows = [broken(4, 0.8, 1.0), broken(6, 0.7, 1.2), broken(4, None, 0.9), broken(9, 0.69, None)]
    found, _ = tables.claims({"part": "fingertip_disturb", "rows": rows})
    assert [(c["held"], c["asked"]) for c in found] == [(4, 4), (3, 4), (1, 2), (3, 4)]
    rows[3] = broken(9, 0, 0)
    found, _ = tables.claims({"part": "fingertip_disturb", "rows": rows})
    assert [(c["held"], c["asked"]) for c in found] == [(3, 4), (3, 4), (1, 2), (2, 4)]
    rows[3] = broken(9, 0.69, None)
    shown, _ = tables.disturbances({"rows": rows})
    assert shown[0]["count"] == 3
    assert shown[0]["min"] == 0.69
    rows[0]["disturbed"]["lost_ratio"], rows[1]["disturbed"]["lost_ratio"] = 1.5, 0.75
    shown, _ = tables.disturbances({"rows": rows})
    lost = next(row for row in shown if "5 mm" in row["name"])
    assert (lost["count"], lost["min"], lost["median"]) == (2, 0.75, 0.75)


def test_promises_against_what_broke():
    def broken(*ratios):
        found = [
            {"z": 2.0, "ratio": ratio, "compliant_ratio": ratio, "withstands": 1.0,
             "withstands_ratio": ratio, "smallest": ratio}
            | ({"promised": 0.0} if ratio == 1.3
               else {"promised": 0.5, "promised_ratio": ratio and 2 * ratio})
            for ratio in ratios
        ]  # fmt: skip
        return rows_of(disturbed=found)

    rows = [broken(0.95, 1.3, 1.6), broken(2.0, None)]
    result = {"part": "fingertip_withstands", "rows": rows}
    found, _ = tables.claims(result)
    assert [(c["held"], c["asked"]) for c in found] == [(5, 5), (4, 4), (4, 5), (4, 5), (4, 5)]
    shown, _ = tables.promises(result)
    assert sum(row["withstands"] for row in shown) == 5
    counts = {row["name"]: row["withstands"] for row in shown}
    assert counts["0.9 to 1"] == counts["3 or more, or not broken"] == 1
    text = tables.below(result)
    assert text.startswith("Of 5 tests, 1 broke below what the row withstands")
    assert "Of 4 tests with a promise, 0 broke below it" in text
    assert "is 0.62 of what breaks it" in text  # of 1/0.95, 1/1.3, 1/1.6, 1/2 and 0
    assert wilson(0, 1000, tables.ONE_SIDED)[1] == pytest.approx(0.0027, abs=1e-4)
    assert wilson(500, 1000, tables.ONE_SIDED)[1] == pytest.approx(0.526, abs=1e-3)


def test_only_rows_of_fingertip_plans_have_a_promise():
    for kind in ("slide", "clasp"):
        with pytest.raises(TaskError, match=f"{kind}: only rows of fingertip plans"):
            physics.Grid(kind, runs=1, experiment="withstands").check()
    assert physics.Grid("fingertip", 1, experiment="withstands").part == "fingertip_withstands"


def test_new_shapes_have_the_corners_that_they_should():
    for k, shape in enumerate(fingertip_shapes.SHAPES):
        for seed in range(5):
            vertices = fingertip_shapes.corners(np.random.default_rng([seed, k]), shape)
            hull = ConvexHull(vertices)
            assert len(hull.vertices) == len(vertices)
            assert (vertices[:, 2] >= 0).all()
            assert np.count_nonzero(vertices[:, 2] == 0) >= 3
            triangles = np.array(fingertip_shapes.outward(hull))
            a, b, c = (vertices[triangles[:, i]] for i in range(3))
            volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
            assert volume == pytest.approx(hull.volume)


def test_a_share_never_looks_better_than_it_is():
    assert tables._share(1999, 2000) == "99.9 %"
    assert tables._share(199, 200) == "99.5 %"
    assert tables._share(2000, 2000) == "100 %"
    assert tables._share(948, 999) == "94.8 %"


def test_interrupted_and_resumed(engine, tmp_path, monkeypatch):
    spreading = importlib.import_module("graspless.batches.spread")
    monkeypatch.setattr(spreading, "LARGEST_CHUNK", 1)  # what is in hand when it ends is lost
    log = tmp_path / "physics_slide.rows"
    grid = physics.Grid("slide", runs=4, trials=2)
    measured = []

    def measure(query):
        if len(measured) == 2:
            raise KeyboardInterrupt
        measured.append(query.name)
        return work.measure(query)

    first = physics.run(grid, log=log, measure=measure)
    assert not first.is_complete
    assert len(first.rows) == len(manifest.read(log, "key")) == 2
    told = []
    measured.append("no interruption any more")
    second = physics.run(grid, log=log, measure=measure, tell=told.append)
    assert second.is_complete
    assert told == [1, 2, 3, 4]
    assert measured[:2] + measured[3:] == [f"{k:03} card {k}" for k in range(4)]
    assert _without_clock(second) == _without_clock(physics.run(grid))
    other = physics.run(physics.Grid("slide", runs=4, trials=3), log=log)  # another question
    assert len(other.rows) == 4
    assert all(len(row["seconds"]) == 3 for row in other.rows)


def _without_clock(run):
    return [{k: v for k, v in row.items() if k != "plan_seconds"} for row in run.rows]


def test_an_error_or_a_dead_worker_is_a_complaint(engine, monkeypatch):
    def broken(task):
        raise RuntimeError("no such thing")

    monkeypatch.setattr("graspless._api.plan", broken)
    run = physics.run(physics.Grid("slide", runs=1))
    assert run.complaints == ["000 card 0: RuntimeError: no such thing"]
    totals = tables.totals(run.rows)
    assert (totals["lost"], totals["not_planned"]) == (1, {})
    assert "1 lost to an error" in report._counts(totals)
    query = work.Query("a", {}, 1, 1)
    lost = work.unknown(query, "crashed", "")
    assert physics._lost(query, "SIGSEGV\nmore", 2.0) == lost | {
        "reason": "its process died after 2 s: SIGSEGV"
    }


@pytest.mark.parametrize(
    ("flags", "part"),
    [
        (["--kind", "slide"], "slide"),
        (["--kind", "slide", "--ablation"], "slide_ablation"),
        (["--kind", "slide", "--closed-loop"], "slide_closed_loop"),
        (["--kind", "fingertip"], "fingertip"),
        (["--kind", "fingertip", "--disturb"], "fingertip_disturb"),
        (["--kind", "clasp"], "clasp"),
        (["--kind", "clasp", "--prove", "2"], "clasp_prove"),
        (["--kind", "clasp", "--locked"], "clasp_locked"),
    ],
)
def test_the_command_and_its_page(flags, part, engine, tmp_path, capsys):
    arguments = ["bench", "physics", "--runs", "2", "--trials", "3", "--out", str(tmp_path)]
    assert main([*arguments, *flags]) == 0
    out = capsys.readouterr().out
    assert "2 tasks, 2 planned" in out
    assert [path.name for path in tmp_path.glob("physics_*")] == [f"physics_{part}.json"]
    result = json.loads((tmp_path / f"physics_{part}.json").read_text())
    assert result["part"] == part
    assert len(result["rows"]) == 2
    assert result["versions"]["mujoco"] == "4"
    page = (tmp_path / "physics.md").read_text()
    assert "$" not in page
    assert "2 tasks, 2 planned" in page
    for claim in claims.CLAIMS[part]:
        asked = claim.of in ("disturbed", "proven") or part != "fingertip_disturb"
        assert (f"| {claim.what} |" in page) == asked
    if part == "slide_closed_loop":
        assert "| kick, closed | 2 | 0 | 1 | 1 | 1 |" in page
        assert "stopped 2" in page
        assert "| rest of the slide planned | 14 | 20 | 20 | 20 |" in page
        assert (
            "| rest of the slide planned within 10 ms | closed | 14.2 % | 2/14 | 99 % | – | missed |"
            in page
        )
        assert "| whole plan made anew | 14 | 5 | 5 | 5 |" in page
    elif part == "clasp_locked":
        assert "| certificate, upper bound | 1 |" in page
        assert "| random moves, margin | 0 |" in page
        assert "| virtual linking, least finger | 0.5 |" in page
        assert "| caged | 2 | 2 | 2 | 2 |" in page
        assert "| not proven | 4 | 2 | 2 | 5.5 |" in page
        assert "| held if caged | closed | 100 % | 2/2 | 100 % | – | must |" in page
    elif part == "clasp_prove":
        assert [row["proof"]["asked"] for row in result["rows"]] == [3, 3]
        assert "| proven | 2 | 1 | 1 | 1 |" in page
    elif part == "fingertip_disturb":
        assert result["rows"][0]["disturbed"]["ratio"] is None
        assert "| z [N] | 2 | 4 | 4 | 4 |" in page
    else:
        assert "| fell | 0 |" in page
        assert "position error" in page


def test_area_under_the_curve_is_the_share_of_pairs_in_order():
    scores, held = [3.0, 1.0, 2.0, 2.0], [True, True, False, False]
    assert locked.area(scores, held) == 0.5
    assert locked.area([2.0, *scores], [True, *held]) == 0.5
    assert locked.area([3.0, 2.0, 1.0], [True, True, False]) == 1.0
    assert locked.area([1.0, 2.0], [True, True]) is None


def test_searches_until_a_plan_holds(engine, monkeypatch):
    monkeypatch.setattr("graspless.proving.SECONDS", 0.2)
    run = physics.run(physics.Grid("slide", runs=4, trials=8, seed=4, experiment="prove"))
    drawn = [simulation.variations(8, k) for k in range(4, 8)]
    light = [sum(v.mass < 0.85 for v in trials) for trials in drawn]
    assert 0 < sum(map(bool, light)) < 4
    assert [row["proof"]["asked"] - row["proof"]["held"] for row in run.rows] == light
    assert all(row["proof"]["plans"] > 1 for row, failed in zip(run.rows, light) if failed)  # noqa: B905
    proven = light.count(0)
    first, whole = tables.claims({"part": "slide_prove", "rows": run.rows})[0]
    assert (first["held"], whole["held"], whole["asked"]) == (proven, proven, 4)
    of_proven, others = tables.proofs({"rows": run.rows})[0]
    assert (of_proven["count"], of_proven["plans"]["max"], of_proven["failures"]) == (proven, 1, "")
    assert (others["count"], others["failures"]) == (4 - proven, f"fell {sum(light)}")
    assert "a search with its simulations took" in report._counts(tables.totals(run.rows))


def test_each_condition_is_tried_in_both_loops_with_the_same_difference(engine):
    row = physics.run(physics.Grid("slide", runs=1, experiment="closed_loop")).rows[0]
    names = [f"{name}, {loop}" for name in conditions.CONDITIONS for loop in ("open", "closed")]
    assert row["of"] == names
    assert all(len(values) == len(names) for values in row["measures"].values())
    failed = dict(zip(names, row["failures"], strict=True))
    assert failed["kick, closed"] == ["stopped"]
    assert failed["start, closed"] == []
    opened = dict(zip(names, row["measures"]["position_error"], strict=True))
    assert opened["none, open"] == 0.001
    assert opened["start, open"] > 0.001
    found = {
        (c["name"], c["of"]): c
        for c in tables.claims({"part": "slide_closed_loop", "rows": [row]})[0]
    }
    kick = found["held and lifted", "kick, closed"]
    assert (kick["held"], kick["asked"], kick["must"]) == (0, 1, 0.98)
    assert found["held and lifted", "mass, closed"]["held"] == 1
    assert ("held and lifted", "none, open") in found
    near = found["within 3 mm and 2 deg", "table, closed"]
    assert (near["held"], near["must"], near["goal"]) == (1, None, 0.95)
    rows, _ = tables.conditions({"rows": [row]})
    closed = next(row for row in rows if row["name"] == "friction, closed")
    assert (closed["plans"], closed["position_error"]["median"]) == (3, 1)


def test_the_ablation_is_the_papers_finger(engine, monkeypatch):
    (query,) = physics.Grid("slide", runs=1, experiment="ablation").queries()
    assert query.document["hand"]["finger_model"] == "impedance"
    executed = []

    def execute(plan, variation, **how):
        executed.append(plan.task.problem.hand.finger_model.name)
        return run_trial(plan, variation, **how)

    monkeypatch.setattr(simulation.simulation_kind("slide"), "run", execute)
    assert work.measure(query)["status"] == "solved"
    assert executed == ["flexure"]


def test_files_of_before_still_make_a_page(tmp_path):
    results = Path(__file__).parents[2] / "docs" / "results"
    files = sorted(results.glob("physics_*.json"))
    for path in files:
        result = json.loads(path.read_text())
        result["totals"].pop("warned", None)
        for row in result["rows"]:
            row.pop("warnings", None)
        (tmp_path / path.name).write_text(json.dumps(result))
    report.write(result, tmp_path)
    page = (tmp_path / "physics.md").read_text()
    assert page.count("| `graspless bench physics --") == len(files) == len(report.PARTS)
    _, ablation = page.split("commanded tip\n", 1)
    assert re.search(r"\| off target \| \d+ \| – \|", ablation.split("\n## ")[0])
    assert re.search(r"\| smallest disturbance that moves a corner by 5 mm / z \| \d+ \|", page)


def test_page_of_all_parts(engine, tmp_path, capsys):
    for flags in (["--kind", "slide"], ["--kind", "fingertip", "--disturb"], ["--kind", "clasp"]):
        main(["bench", "physics", "--runs", "1", "--out", str(tmp_path), *flags, "--json"])
        assert json.loads(capsys.readouterr().out)["complete"]
    page = (tmp_path / "physics.md").read_text()
    heads = [line for line in page.splitlines() if line.startswith("#")]
    assert [head.lstrip("# ") for head in heads] == [
        "Plans in a physics engine",
        "Slides",
        "How much disturbance breaks a motion",
        "Clasps",
        "Circumstances",
    ]


@pytest.mark.parametrize("part", report.PARTS)
def test_results_were_made_by_this_code(part):
    """By the names of what is counted and measured; else the file is older than the code."""
    path = Path(__file__).parents[2] / "docs" / "results" / f"physics_{part}.json"
    result = json.loads(path.read_text())
    kind = simulation.simulation_kind(result["kind"])
    failures, measures = kind.FAILURES, kind.MEASURES
    if part.endswith("_closed_loop"):
        failures, measures = failures | kind.FOLLOWED_FAILURES, measures | kind.FOLLOWED_MEASURES
    elif part.endswith("_locked"):
        failures, measures = locked.FAILURES, locked.MEASURES
    for field, names in {"failures": failures, "measures": measures}.items():
        assert set(result[field]) == set(names), f"{path.name} is old: run its command again"
    for row in result["rows"]:
        assert set(row["measures"]) in (set(), set(measures)), f"{path.name} is old"


@pytest.mark.parametrize(
    ("grid", "message"),
    [
        (physics.Grid("clasp", 1, experiment="ablation"), "--ablation: clasp has none"),
        (physics.Grid("slide", 1, experiment="disturb"), "--disturb: slide plans have no stab"),
        (physics.Grid("clasp", 1, experiment="closed_loop"), "--closed-loop: clasp: only slide"),
        (physics.Grid("slide", 1, experiment="locked"), "--locked: slide plans have no cert"),
        (physics.Grid("slide", 0), "--runs: 0: should be at least 1"),
        (physics.Grid("slide", 1, seed=-1), "--seed: -1: should not be negative"),
    ],
)
def test_grids_that_are_none(grid, message):
    with pytest.raises(TaskError, match=message):
        grid.check()


@pytest.mark.parametrize("one", ["--ablation", "--disturb", "--withstands", "--mutants"])
@pytest.mark.parametrize("other", [["--closed-loop"], ["--prove", "5"], ["--locked"]])
def test_there_is_one_experiment_at_a_time(one, other, capsys):
    with pytest.raises(SystemExit) as error:
        main(["bench", "physics", "--kind", "slide", one, *other])
    assert error.value.code == 2
    assert f"argument {other[0]}: not allowed with argument {one}" in capsys.readouterr().err


def test_every_kind_is_asked_something():
    assert set(physics.RUNS) == set(report.PARTS) & set(kinds.KINDS)
    assert set(claims.CLAIMS) == set(report.PARTS)


def test_a_clasp_that_only_blows_free_is_told_from_one_that_a_wrench_does():
    def row(failures, **measures):
        measures = {name: [value] for name, value in measures.items()}
        return {"failures": [failures], "measures": measures, "seconds": [1.0]}

    lost = ["forced_open"]
    rows = [
        row(lost, sequences=10.0, held=8.0, held_dragged=10.0),
        row(lost, sequences=10.0, held=8.0, held_dragged=9.0),
        row(["escaped"], sequences=10.0, held=8.0, held_dragged=10.0),
        row([], sequences=10.0, held=10.0, held_dragged=10.0),
        row([], sequences=10.0, held=10.0),  # measured before there was such a thing
    ]
    found, _ = tables.claims({"part": "clasp", "rows": rows})
    named = {claim["name"]: (claim["held"], claim["asked"]) for claim in found}
    assert named["holds, with drag on the object"] == (2, 4)
    assert named["holds"] == (2, 5)


@pytest.mark.parametrize(
    ("held", "met"), [(94, "missed"), (95, "must"), (98, "must"), (99, "goal"), (100, "goal")]
)
def test_tables_say_what_is_met(held, met):
    row = {"held": held, "asked": 100, "must": 0.95, "goal": 0.99}
    assert dict(tables.CLAIM_COLUMNS)["met"](row) == met
    unasked = row | {"must": None, "goal": None}
    assert dict(tables.CLAIM_COLUMNS)["met"](unasked) == "–"
