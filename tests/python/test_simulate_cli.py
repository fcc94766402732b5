# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `graspless simulate`: flags, exit codes and what is printed, the engine stubbed."""

import contextlib
import json
import re
import sys
import types
from pathlib import Path

import numpy as np
import pytest

import graspless
from graspless import _data, view
from graspless.errors import install_command
from graspless.simulation import Trial, simulation_kind
from tasks_common import edited, run

EXAMPLE = _data.directory("examples") / "01_slide_card.yaml"


@pytest.fixture(scope="module")
def plan_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("plan") / "plan.json"
    graspless.plan(EXAMPLE).save(path)
    return str(path)


@pytest.fixture
def engine(monkeypatch):
    """Trials that hold as planned and drop the object when friction is low; what was asked."""
    asked = []

    def execute(plan, variation, *, record=False):
        asked.append((variation, record))
        failed = ("dropped",) if variation.friction < 1 else ()
        measures = {"position_error": 0.001 * len(asked), "overhang": 0.04}
        return Trial(variation, failed, measures, 0.5)

    monkeypatch.setattr("graspless.simulation.slide.run", execute)
    return asked


def test_one_trial_is_as_planned(plan_file, engine, capsys):
    code, out, err = run(capsys, "simulate", plan_file)
    assert (code, err) == (0, "")
    assert out.startswith("1 of 1 trial succeeded, seed 0\n")
    assert [(v.is_nominal, record) for v, record in engine] == [(True, False)]
    assert "position_error" in out
    assert "median" not in out


def test_closed_loop_and_conditions_are_asked_for(plan_file, monkeypatch, capsys):
    asked = []

    def follow(plan, variation, seed, *, record=False):
        asked.append((variation, list(seed), record))
        failed = ("stopped",) if len(asked) == 2 else ()
        return Trial(variation, failed, {"position_error": 0.001, "resumes": 2.0}, 0.5)

    monkeypatch.setattr("graspless.simulation.slide.follow", follow)
    flags = ("--closed-loop", "--condition", "table", "--trials", "3", "--seed", "4")
    code, out, _ = run(capsys, "simulate", plan_file, *flags)
    assert code == 1
    assert "stopped in 1 trial: the follower of the plan gave up" in out
    assert "number of new plans during the slide without lifting off" in out
    assert "nominal" not in out
    assert [seed for _, seed, _ in asked] == [[4, 0], [4, 1], [4, 2]]
    assert {abs(variation.table) for variation, *_ in asked} == {0.003}


def test_a_condition_that_is_none_is_refused(plan_file, capsys):
    code, _, err = run(capsys, "simulate", plan_file, "--condition", "wind")
    assert code == 2
    assert "condition: wind: should be one of none, friction, start" in err
    _, _, err = run(capsys, "simulate", plan_file, "--condition", "frictio")
    assert err.endswith("; did you mean 'friction'?\n")


def test_trials_that_fail_are_named_and_counted(plan_file, engine, capsys):
    code, out, _ = run(capsys, "simulate", plan_file, "--trials", "9", "--seed", "3")
    failed = sum(variation.friction < 1 for variation, _ in engine)
    assert 0 < failed < 9
    assert code == 1
    assert out.startswith(f"{9 - failed} of 9 trials succeeded, seed 3\n")
    assert f"dropped in {failed} trial" in out
    assert "median" in out


def test_what_was_held_but_not_lifted_is_told_from_what_fell(plan_file, monkeypatch, capsys):
    creeps = iter([0.0002, 0.0004, 0.5])

    def execute(plan, variation, *, record=False):
        creep = next(creeps)
        return Trial(
            variation, ("dropped",), {"lift_height": 0.07 + 10 * creep, "creep": creep}, 0.5
        )

    monkeypatch.setattr("graspless.simulation.slide.run", execute)
    _, out, _ = run(capsys, "simulate", plan_file, "--trials", "3")
    assert "(in 2 of them it kept its place in the hand and rose by 72 to 74 mm)" in out
    assert "was held but did not rise by 9 cm" in out
    creeps = iter([0.5, 0.5])
    _, out, _ = run(capsys, "simulate", plan_file)
    assert "kept its place" not in out


def test_a_pinch_has_no_slide_in_its_texts():
    kind = simulation_kind("pinch")
    texts = [*kind.FAILURES.values(), *kind.MEASURES.values()]
    assert [text for text in texts if "slide" in text] == []


def test_a_plan_that_does_not_hold_is_refused(plan_file, engine, capsys, tmp_path):
    plan = edited(graspless.load_plan(plan_file), tmp_path / "edited.json")
    code, out, err = run(capsys, "simulate", plan)
    assert (code, out, engine) == (2, "", [])
    assert err.startswith(f"{plan}: does not hold: ")
    assert graspless.check(plan)[0] in err
    code, out, err = run(capsys, "simulate", plan, "--unchecked")
    assert (code, err, len(engine)) == (0, "", 1)


def test_json_is_all_that_is_printed(plan_file, engine, capsys):
    code, out, _ = run(capsys, "simulate", plan_file, "--trials", "9", "--json")
    printed = json.loads(out)
    assert code == (0 if printed["held"] == 9 else 1)
    assert printed["trials"] == len(printed["rows"]) == 9
    assert printed["failures"]["dropped"] == 9 - printed["held"]
    assert printed["rows"][0]["variation"]["friction"] == 1
    assert printed["rows"][0]["measures"]["overhang"] == 0.04


def test_what_is_no_number_is_null_in_json(plan_file, monkeypatch, capsys):
    def execute(plan, variation, *, record=False):
        return Trial(variation, ("fell",), {"creep": float("nan"), "overhang": 0.04}, 0.5)

    monkeypatch.setattr("graspless.simulation.slide.run", execute)
    _, out, _ = run(capsys, "simulate", plan_file, "--json")
    printed = json.loads(out, parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    assert printed["rows"][0]["measures"] == {"creep": None, "overhang": 0.04}


def test_python_takes_the_file_too(plan_file, engine):
    held = graspless.simulate(plan_file, trials=2)
    assert repr(held).startswith("<Simulation: ")
    assert len(repr(held)) < 100
    trajectory = graspless.time(plan_file)
    assert repr(trajectory).startswith(f"<Trajectory of {len(trajectory)} samples, ")
    for rate in (0, -1, float("nan"), "a"):
        with pytest.raises(graspless.TaskError, match="rate"):
            trajectory.sampled(rate)
    with pytest.raises(graspless.TaskError, match="robot: 'wam_t42': should be a"):
        graspless.time(plan_file, "wam_t42")


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"trials": 2.5}, "trials: 2.5: should be a whole number"),
        ({"trials": "2"}, "trials: '2': should be a whole number"),
        ({"trials": True}, "trials: True: should be a whole number"),
        ({"trials": 0}, "trials: 0: should be at least 1"),
        ({"seed": 1.5}, "seed: 1.5: should be a whole number"),
        ({"seed": None}, "seed: None: should be a whole number"),
        ({"seed": -1}, "seed: -1: should not be negative"),
    ],
)
def test_bad_arguments_are_told(plan_file, engine, given, message):
    with pytest.raises(graspless.TaskError, match=re.escape(message)):
        graspless.simulate(plan_file, **given)
    assert not engine


def test_numbers_of_numpy_are_whole_too(plan_file, engine):
    assert len(graspless.simulate(plan_file, np.int64(2), np.uint8(3)).trials) == 2


@pytest.mark.parametrize("what", ["time", "check", "simulate", "plan"])
@pytest.mark.parametrize("given", [None, 5, {}])
def test_what_is_no_plan_is_told(what, given):
    name = "task" if what == "plan" else "plan"
    words = f"{name}: {given!r}: should be a graspless.{name.title()}, or the path of its file"
    if name == "task":
        words = words.replace(", or", ", a Problem, a dict, or")
        words = "task: kind: missing; should be" if given == {} else words
    with pytest.raises(graspless.TaskError, match=re.escape(words)):
        getattr(graspless, what)(given)


def test_html_is_checked_before_the_work(plan_file, engine, capsys, tmp_path):
    code, _, err = run(capsys, "simulate", plan_file, "--html", str(tmp_path / "no" / "x.html"))
    assert code == 2
    assert "there is no folder" in err
    assert not engine


def test_what_takes_long_is_told(plan_file, engine, capsys, monkeypatch, tmp_path):
    from graspless.view import replay, server

    told = []

    def waiting(what):
        told.append(what)
        return contextlib.nullcontext()

    def interrupt(seconds):
        raise KeyboardInterrupt

    monkeypatch.setattr("graspless.progress.waiting", waiting)
    monkeypatch.setattr("graspless.view.write_html", lambda *_, recording: None)
    page = str(tmp_path / "page.html")
    assert run(capsys, "simulate", plan_file, "--html", page)[0] == 0
    assert told == ["checking", "simulating, 1 trial", f"drawing {page}"]
    told.clear()
    out = str(tmp_path / "plan.csv")
    assert run(capsys, "export", plan_file, "--to", "csv", "-o", out)[0] == 0
    assert told == ["checking", "timing and writing"]
    told.clear()
    monkeypatch.setattr(replay, "time", types.SimpleNamespace(sleep=interrupt))
    code, out, _ = run(capsys, "view", plan_file, "--port", str(server.free_port()))
    assert code == 130
    assert out.startswith("http://")
    assert told == ["drawing"]


def test_without_viser_a_replay_is_refused_before_the_work(
    plan_file, engine, capsys, tmp_path, monkeypatch
):
    monkeypatch.setitem(sys.modules, "viser", None)
    page = str(tmp_path / "x.html")
    for command in (
        ["simulate", plan_file, "--html", page],
        ["plan", str(EXAMPLE), "-o", str(tmp_path / "plan.json"), "--html", page],
        ["view", plan_file, "--html", page],
        ["view", plan_file],
    ):
        code, out, err = run(capsys, *command)
        assert (code, out) == (2, "")
        assert err == f"needs viser to draw: {install_command('view')}\n"
    with pytest.raises(graspless.TaskError, match="needs viser"):
        view.write_html(graspless.load_plan(plan_file), page)
    assert not engine
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (["--trials", "0"], "trials: 0: should be at least 1"),
        (["--seed", "-1"], "seed: -1: should not be negative"),
        (["--disturb"], "--disturb: slide plans have no stability margin"),
    ],
)
def test_bad_flags_are_named(plan_file, engine, capsys, flags, said):
    code, _, err = run(capsys, "simulate", plan_file, *flags)
    assert code == 2
    assert said in err
    assert not engine


def test_a_plan_that_was_not_found_is_refused(capsys, tmp_path):
    path = tmp_path / "none.json"
    graspless.plan(EXAMPLE, iterations=0).save(path)
    code, _, err = run(capsys, "simulate", str(path))
    assert code == 2
    assert "not solved: nothing to simulate" in err


@pytest.mark.slow
def test_the_engine_itself_writes_a_replay(plan_file, capsys, tmp_path):
    page = tmp_path / "page.html"
    code, out, _ = run(capsys, "simulate", plan_file, "--html", str(page))
    assert code == 0
    assert f"written: {page}" in out
    assert 0.5e6 < page.stat().st_size < 2e6


@pytest.mark.parametrize("kind", ["slide", "fingertip", "clasp", "chain"])
def test_the_documentation_names_every_failure_and_measure(kind):
    page = (Path(__file__).parents[2] / "docs" / "simulate.md").read_text()
    module = simulation_kind(kind)
    names = {**module.FAILURES, **module.MEASURES}
    names |= getattr(module, "FOLLOWED_FAILURES", {}) | getattr(module, "FOLLOWED_MEASURES", {})
    assert [name for name in names if f"`{name}`" not in page] == []
