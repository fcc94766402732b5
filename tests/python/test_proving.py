# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans that are simulated while they are searched for; most tests with an engine that is none."""

import contextlib
import copy
import json
import pickle
import sys
import time
from concurrent import futures
from itertools import pairwise

import pytest
import yaml

import batch_common
import graspless
from fingertip_common import PUSH, TUMBLE, changed
from graspless import TaskError, _data, limits, planning, proving, report
from graspless.batches import pools
from graspless.proving import Proof, trials
from graspless.simulation import Trial, variations
from graspless.simulation.settings import SLIDE_SPREAD
from tasks_common import GOOD, run, without_clock


@pytest.fixture(scope="module")
def task(tmp_path_factory):
    path = tmp_path_factory.mktemp("task") / "task.yaml"
    path.write_text(GOOD)
    return graspless.load_task(path)


@pytest.fixture
def engine(monkeypatch):
    """An engine whose failures are a function of a plan and a variation; what it was asked."""
    asked = []

    def fails(failures, kind="slide"):
        def execute(plan, variation, *, record=False):
            asked.append((plan.seed, variation))
            return Trial(variation, tuple(failures(plan, variation)), {}, 0.1)

        monkeypatch.setattr(f"graspless.simulation.{kind}.run", execute)
        return asked

    return fails


def test_a_plan_that_holds_at_once_is_the_plan_without_trials(task, engine, tmp_path):
    asked = engine(lambda plan, variation: ())
    plan = graspless.plan(task, iterations=5000, prove=3)
    alone = graspless.plan(task, iterations=5000)
    proof = plan.proof
    assert proof
    assert str(proof) == "proven in 4 of 4 trials"
    assert (proof.failures, proof.plans, proof.ended) == ([[], [], [], []], 1, "proven")
    assert (proof.plan_seed, proof.trial_seed) == (task.seed, task.seed)
    assert [v for _, v in asked] == variations(4, proof.trial_seed, SLIDE_SPREAD)
    assert proof.varied["table"] == SLIDE_SPREAD.table
    assert "proven in 4 of 4" in repr(plan)
    document = without_clock(plan)
    assert document.pop("proof")["held"] == 4
    assert document == without_clock(alone)
    assert alone.proof is None
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert again.proof == proof
    assert again.to_json() == plan.to_json()
    for same in (again, copy.copy(plan), copy.deepcopy(plan), pickle.loads(pickle.dumps(plan))):
        assert same == plan
        assert graspless.check(same) == []
    alone.statistics = plan.statistics
    assert alone != plan
    again.proof = None
    assert "proof" not in json.loads(again.to_json())


def test_simulate_repeats_the_trials(task, engine):
    asked = engine(lambda plan, variation: ["fell"] if variation.friction < 1 else [])
    plan = graspless.plan(task, iterations=5000, prove=3, seconds=0.3)
    before = [variation for seed, variation in asked if seed == plan.seed]
    del asked[:]
    again = graspless.simulate(plan, plan.proof.asked, plan.proof.trial_seed)
    assert [list(trial.failures) for trial in again.trials] == plan.proof.failures
    assert [variation for _, variation in asked] == before


def test_the_search_goes_on_with_other_seeds_until_a_plan_holds(task, engine):
    asked = engine(lambda plan, variation: ["tipped"] if plan.seed < 5 else [])
    plan = graspless.plan(task, iterations=5000, prove=2)
    assert plan.proof
    assert (plan.seed, plan.proof.plan_seed, plan.proof.trial_seed) == (5, 5, 3)
    assert plan.proof.plans == 3
    # The first is simulated whole. The next ends with as many failures.
    assert [seed for seed, _ in asked] == 3 * [3] + 3 * [4] + 3 * [5]
    assert (
        without_clock(plan)["segments"] == without_clock(graspless.plan(task, seed=5))["segments"]
    )


def test_the_best_plan_is_returned_and_says_what_fails(task, engine, monkeypatch):
    monkeypatch.setattr(proving, "MOST_REPEATED", 2)
    monkeypatch.setattr(proving._Candidates, "learn", same_seed_after(6))
    bad = {3: 3, 4: 1, 5: 2, 6: 1}  # failed trials by seed

    def failures(plan, variation):
        k = drawn.index(variation)
        return ["tipped", "off_target"][: 1 + (k == 0)] if k < bad[plan.seed] else []

    drawn = variations(4, task.seed, SLIDE_SPREAD)
    asked = engine(failures)
    plan = graspless.plan(task, iterations=5000, prove=3)
    assert plan
    assert not plan.proof
    assert plan.seed == 4
    assert plan.proof.failures == [["tipped", "off_target"], [], [], []]
    assert plan.proof.failed == {"tipped": 1, "off_target": 1}
    assert str(plan.proof) == (
        "held in 3 of 4 trials; fails: tipped in 1, off_target in 1; "
        "best of 4 plans; no other plan was found"
    )
    # A plan that cannot be better is left at once.
    assert [seed for seed, _ in asked] == 4 * [3] + 4 * [4] + [5] + [6]


def same_seed_after(last):
    """Candidates whose seeds end, as those of a search that does not depend on them."""

    def learn(self, plan):
        self.task = self._first.with_changes(seed=min(self.task.seed + 1, last))

    return learn


def test_same_seed_and_iterations_give_the_same_file(task, engine):
    engine(lambda plan, variation: ["fell"] if plan.seed < 5 and variation.mass < 1 else [])
    files = [without_clock(graspless.plan(task, iterations=5000, prove=2)) for _ in range(2)]
    assert files[0]["proof"]["plans"] > 1
    assert files[0] == files[1]


def test_a_time_limit_ends_trials_and_keeps_what_is_known(task, engine):
    def failures(plan, variation):
        if not variation.is_nominal:
            end = time.monotonic() + 20
            while time.monotonic() < end:
                limits.poll()
        return []

    engine(failures)
    began = time.process_time()
    plan = graspless.plan(task, prove=2, seconds=0.4)
    assert time.process_time() - began < 3
    assert plan
    assert not plan.proof
    assert (plan.proof.trials, plan.proof.asked, plan.proof.held) == (1, 3, 1)
    text = "held in 1 of 1 trial (3 were asked for); the time limit was reached"
    assert str(plan.proof) == text
    assert graspless.check(plan) == []
    limits.poll()  # the deadline is gone


def test_a_time_limit_ends_the_search(task, engine, monkeypatch):
    asked = engine(lambda plan, variation: ["fell"])
    plan = graspless.plan(task, prove=1, seconds=0.3)
    assert plan.proof.ended == "out_of_time"
    assert plan.seed == task.seed
    assert plan.proof.plans == len({seed for seed, _ in asked}) > 1
    monkeypatch.setattr(proving, "SECONDS", 0.2)  # without a limit of its own
    began = time.process_time()
    assert graspless.plan(task, prove=1).proof.ended == "out_of_time"
    assert time.process_time() - began < 3


def test_a_stopped_budget_ends_the_search(task, engine):
    budget = planning.Budget(seconds=60, seed=3)

    def failures(plan, variation):
        budget.stop()
        return ["fell"]

    engine(failures)
    plan = graspless.plan(task, prove=2, budget=budget)
    assert (plan.proof.ended, plan.proof.trials, plan.proof.plans) == ("interrupted", 3, 1)


def test_ctrl_c_in_a_trial_returns_the_best_plan(task, engine, tmp_path, capsys):
    def failures(plan, variation):
        if plan.seed == 4:
            raise KeyboardInterrupt
        return [] if variation.is_nominal else ["fell"]

    engine(failures)
    plan = graspless.plan(task, prove=2)
    assert (plan.seed, plan.proof.held, plan.proof.plans) == (3, 1, 2)
    assert plan.proof.ended == "interrupted"
    (tmp_path / "task.yaml").write_text(GOOD)
    files = str(tmp_path / "task.yaml"), "-o", str(tmp_path / "plan.json")
    code, out, _ = run(capsys, "plan", *files, "--prove", "2")
    assert code == 130
    assert "held in 1 of 3 trials; fails: fell in 2; best of 2 plans; interrupted" in out
    assert graspless.load_plan(tmp_path / "plan.json").proof == plan.proof


def test_ctrl_c_between_two_searches_returns_the_best_plan(task, engine, monkeypatch):
    def interrupted(self, plan):
        raise KeyboardInterrupt

    engine(lambda plan, variation: ["fell"])
    monkeypatch.setattr(proving._Candidates, "learn", interrupted)
    plan = graspless.plan(task, prove=1)
    assert (plan.proof.plans, plan.proof.ended) == (1, "interrupted")


def test_ctrl_c_in_the_first_search_is_ctrl_c(task, engine, monkeypatch):
    engine(lambda plan, variation: ["fell"])
    searches = []

    def search(cls, given, budget):
        searches.append(given.seed)
        if len(searches) == 1 or given.seed == 4:
            raise KeyboardInterrupt
        return found(given, budget)

    found = graspless.slide.Plan._search
    monkeypatch.setattr(graspless.slide.Plan, "_search", classmethod(search))
    with pytest.raises(KeyboardInterrupt):
        graspless.plan(task, prove=1)
    assert graspless.plan(task, prove=1).proof.ended == "interrupted"


def test_a_task_without_a_plan_has_no_proof(task, engine):
    asked = engine(lambda plan, variation: [])
    plan = graspless.plan(task, prove=1, iterations=0)
    assert not plan
    assert (plan.proof, asked) == (None, [])


def test_a_plan_that_was_changed_is_not_proven(task, engine, tmp_path, capsys):
    engine(lambda plan, variation: [])
    plan = graspless.plan(task, prove=1)
    document = json.loads(plan.to_json())
    path = tmp_path / "plan.json"

    def answer(change):
        edited = copy.deepcopy(document)
        change(edited)
        path.write_text(json.dumps(edited))
        return run(capsys, "check", str(path))

    def heavier(edited):
        edited["task"]["object"]["mass"] = 0.1

    def moved(edited):
        edited["segments"][0]["positions"][1][0] += 1e-9

    code, out, _ = answer(lambda edited: None)
    assert code == 0
    assert out.endswith("no fault\nproven in 2 of 2 trials\n")
    assert answer(lambda edited: edited["task"]["budget"].update(seconds=5))[0] == 0
    for change in (heavier, moved):
        code, out, _ = answer(change)
        assert code == 1
        assert "proof: the plan or its task was changed after the trials" in out
        assert "proven in" not in out
        edited = graspless.load_plan(path)
        assert "not proven: changed after its trials" in report.as_text(edited)
        edited.proof = None
        assert not any(fault.startswith("proof") for fault in graspless.check(edited))
    plan.segments = plan.segments[:-1]
    assert any(fault.startswith("proof") for fault in graspless.check(plan))


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("trials", 4, "proof.trials is 4, but 3 were asked for"),
        ("trials", 2, "3 failures for 2 trials"),
        ("failures", [[], []], "2 failures for 3 trials"),
        ("held", 3, "proof.held is 3, but 2 trials are without failures"),
        ("ended", "proven", "proof.ended is proven, but 2 of 3 trials held"),
        ("ended", "soon", "proof.ended: soon"),
        ("asked", 1, "proof.asked: 1"),
        ("plans", 0, "proof.plans: 0"),
        ("plan_seed", -1, "proof.plan_seed: -1"),
        ("varied", {"mass": -0.1}, "proof.varied.mass: -0.1"),
        ("failures", [["<b>"], [], []], "proof.failures[0][0]"),
        ("digest", "abc", "proof.digest: abc"),
        ("engine", None, "proof.engine"),
        ("more", 1, "proof.more"),
    ],
)
def test_a_proof_that_is_none_is_refused(task, engine, tmp_path, field, value, message):
    engine(lambda plan, variation: ["fell"] if variation.is_nominal else [])
    document = json.loads(graspless.plan(task, prove=2, seconds=0.05).to_json())
    assert document["proof"]["held"] == 2
    document["proof"][field] = value
    (tmp_path / "plan.json").write_text(json.dumps(document))
    with pytest.raises(TaskError) as caught:
        graspless.load_plan(tmp_path / "plan.json")
    assert message in str(caught.value)


def test_a_fingertip_search_goes_on_with_more_stability(engine, monkeypatch):
    monkeypatch.setattr(proving, "MOST_REPEATED", 2)
    least = []

    def failures(plan, variation):
        if variation.is_nominal:
            least.append(min(float(min(segment.stability)) for segment in plan.segments))
        return ["off"]

    engine(failures, "fingertip")
    given = yaml.safe_load(changed("segments: 30", "segments: 12", TUMBLE))
    plan = graspless.plan(given, prove=1)
    assert plan.proof.ended == "no_other_plan"
    assert plan.proof.plans == len(least) > 1
    assert all(b >= proving.MORE_STABLE[-1] * a for a, b in pairwise(least))
    assert without_clock(plan)["segments"] == without_clock(graspless.plan(given))["segments"]
    assert plan.task.options.min_stability == 0.5  # the first plan: none was better


def test_trials_in_processes_are_the_same_trials():
    given = yaml.safe_load(changed("0.05, 0, 0]", "0.01, 0, 0]"))
    here, there = (graspless.plan(given, prove=1, jobs=jobs) for jobs in (1, 2))
    assert here.proof
    assert here.proof == there.proof
    assert without_clock(here) == without_clock(there)


def test_a_time_limit_ends_processes(capfd):
    plan = graspless.plan(yaml.safe_load(PUSH), prove=20, jobs=2, seconds=2.0)
    assert plan
    assert plan.proof.ended == "out_of_time"
    assert plan.proof.trials < 21
    assert capfd.readouterr().err == ""


def test_an_error_of_the_engine_loses_no_plan(task, engine, tmp_path, capsys):
    def breaks_at(seed):
        def failures(plan, variation):
            if not variation.is_nominal and plan.seed == seed:
                raise RuntimeError("mj_step: stack overflow")
            return ["tipped"]

        return failures

    for seed, trials_done, plans in ((4, 3, 2), (3, 1, 1)):
        engine(breaks_at(seed))
        plan = graspless.plan(task, iterations=5000, prove=2)
        assert (plan.seed, plan.proof.trials, plan.proof.plans) == (3, trials_done, plans)
        assert (bool(plan), bool(plan.proof), plan.proof.ended) == (True, False, "error")
        why = "the physics engine failed: RuntimeError: mj_step: stack overflow"
        assert str(plan.proof).endswith(why)
        plan.save(tmp_path / "plan.json")
        assert graspless.load_plan(tmp_path / "plan.json").proof == plan.proof
    (tmp_path / "task.yaml").write_text(GOOD)
    files = str(tmp_path / "task.yaml"), "-o", str(tmp_path / "new.json")
    code, out, err = run(capsys, "plan", *files, "--prove", "1")
    assert (code, err) == (1, "")
    assert f"held in 0 of 1 trial (2 were asked for); fails: tipped in 1; {why}" in out
    assert graspless.load_plan(tmp_path / "new.json")


def test_a_process_that_dies_is_an_error(task, monkeypatch):
    class Pool:
        crashes = (RuntimeError,)
        workers = 2

        def submit(self, work, given):
            future = futures.Future()
            future.set_exception(RuntimeError("SIGKILL(-9)"))
            return future

    plan = graspless.plan(task)
    work = trials.Trials([None], 1)
    with pytest.raises(TaskError, match="the process of a trial died: SIGKILL"):
        trials._spread(Pool(), plan, work, time.monotonic() + 10)


def test_trials_count_in_order():
    done = trials.Trials([None] * 4, 5, {0: [], 1: ["fell"], 3: []})
    assert (done.failed, done.in_order) == (1, [[], ["fell"]])
    proof = Proof(4, 2, 1, done.in_order, {}, 1, 1, 1, "out_of_time", "", "", "")
    assert not proof
    assert str(proof).startswith("held in 1 of 2 trials (4 were asked for); fails: fell in 1; the")


EXAMPLES = _data.directory("examples")


@pytest.mark.parametrize(
    ("example", "message"),
    [
        ("24_carry_bar", "a carry is not simulated alone: plan a chain"),
        ("20_tumble_then_slide", "a chain of fingertip, fingertip is not simulated"),
        ("21_clasp_then_drag", "stage 'drag' drags the object over floor, but a clasped object is"),
    ],
)
def test_what_is_not_simulated_is_refused_before_the_search(example, message, monkeypatch):
    task = graspless.load_task(EXAMPLES / f"{example}.yaml")
    monkeypatch.setattr(graspless.carry.Plan, "_search", None)
    monkeypatch.setattr(graspless.chain.Plan, "_search", None)
    with pytest.raises(TaskError, match=message):
        graspless.plan(task, prove=1)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"prove": 0}, "prove: 0: should be at least 1"),
        ({"prove": 1.5}, "prove: 1.5: should be a whole number"),
        ({"prove": True}, "prove: True: should be a whole number"),
        ({"prove": 2, "jobs": 0}, "jobs: 0: should be at least 1"),
        ({"jobs": 2}, "jobs: 2: should be 1 without prove"),
    ],
)
def test_bad_arguments(task, options, message):
    with pytest.raises(TaskError, match=message):
        graspless.plan(task, **options)


def test_the_command(task, engine, tmp_path, capsys):
    (tmp_path / "task.yaml").write_text(GOOD)
    files = str(tmp_path / "task.yaml"), "-o", str(tmp_path / "plan.json")
    engine(lambda plan, variation: [])
    code, out, _ = run(capsys, "plan", *files, "--prove", "4")
    assert (code, out.count("proven in 5 of 5 trials")) == (0, 1)
    code, out, _ = run(capsys, "plan", *files, "--prove", "4", "--json")
    assert code == 0
    assert json.loads(out)["proof"]["held"] == 5
    code, out, _ = run(capsys, "check", str(tmp_path / "plan.json"), "--json")
    assert json.loads(out)["proof"]["trials"] == 5
    engine(lambda plan, variation: ["fell"])
    code, out, _ = run(capsys, "plan", *files, "--prove", "1", "--time", "0.5")
    assert code == 1
    assert "holds: 7 segments" in out
    assert "held in 0 of 2 trials; fails: fell in 2; best of " in out
    code, _, err = run(capsys, "plan", *files, "--jobs", "2")
    assert (code, err) == (2, "--jobs: 2: needs --prove, whose trials it distributes\n")
    code, _, err = run(capsys, "plan", *files, "--prove", "0")
    assert (code, err) == (2, "prove: 0: should be at least 1\n")


def test_without_mujoco(monkeypatch, tmp_path, capsys):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    (tmp_path / "task.yaml").write_text(GOOD)
    with pytest.raises(TaskError, match="needs mujoco: "):
        graspless.batch(tmp_path / "task.yaml", tmp_path / "plans", prove=1)
    code, _, err = run(capsys, "plan", str(tmp_path / "task.yaml"), "--prove", "1")
    assert code == 2
    assert err.startswith("needs mujoco: ")


def test_a_batch_of_proven_plans(engine, tmp_path, monkeypatch):
    for k in (3, 4):
        text = GOOD.replace("seed: 3", f"seed: {k}, iterations: 5000")
        (tmp_path / f"card_{k}.yaml").write_text(text)
    engine(lambda plan, variation: ["fell"] if plan.seed < 4 else [])
    monkeypatch.setattr(pools, "opened", lambda *_: contextlib.nullcontext(batch_common.Here()))
    tasks, out = str(tmp_path / "card_*.yaml"), tmp_path / "plans"
    summary = graspless.batch(tasks, out, prove=1)
    assert summary
    assert [row["seed"] for row in summary.rows] == [4, 4]
    plans = [graspless.load_plan(out / row["plan"]) for row in summary.rows]
    assert [plan.proof.plans for plan in plans] == [2, 1]
    assert graspless.batch(tasks, out, prove=1).kept == 2
    engine(lambda plan, variation: ["fell"])
    summary = graspless.batch(tasks, out, prove=2, seconds=0.2)
    assert (summary.kept, summary.solved, summary.held) == (0, 2, 0)
    assert all("held in 0 of 3 trials" in row["reason"] for row in summary.rows)
    assert "not proven" in summary.as_text()
    assert graspless.batch(tasks, out).held == 2  # others: without trials
    with pytest.raises(TaskError, match="prove: 0: should be at least 1"):
        graspless.batch(tasks, out, prove=0)
