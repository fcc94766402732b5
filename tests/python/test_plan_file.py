# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plan files: what is written is what was found, and what is read back replays the same."""

import importlib.util
import io
import json
import os
import pathlib
import re
import stat

import numpy as np
import pytest

import graspless
from graspless import TaskError, files, frames, slide
from graspless.kinds import KINDS, part
from graspless.plan_files import table
from graspless.plan_files.slide import SlidePlanFile
from graspless.plan_files.text import _to_text
from graspless.view import write_html
from tasks_common import GOOD, changed, reread

ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture(scope="module")
def task(tmp_path_factory):
    path = tmp_path_factory.mktemp("task") / "task.yaml"
    path.write_text(GOOD)
    return graspless.load_task(path)


@pytest.fixture(scope="module")
def plan(task):
    plan = graspless.plan(task, iterations=5000)
    assert plan, plan.reason
    return plan


@pytest.fixture(scope="module")
def document(plan):
    return json.loads(plan.to_json())


def test_plan_holds_after_its_file(plan, tmp_path):
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert graspless.check(again) == []
    assert again.to_json() == plan.to_json()
    for mine, theirs in zip(plan.segments, again.segments, strict=True):
        assert mine.name == theirs.name
        np.testing.assert_array_equal(mine.positions, theirs.positions)
        np.testing.assert_array_equal(mine.object_poses, theirs.object_poses)


def test_rows_are_exact_or_refused():
    bits = np.random.default_rng(5).integers(0, 2**64, (200, 40), np.uint64, endpoint=False)
    numbers = np.where(np.isfinite(bits.view(np.float64)), bits.view(np.float64), -0.0)
    for rows in (numbers.tolist(), [[1e-05, 1], [True, None], []], [[]], [["a], [b"], [{}]]):
        text = _to_text({"rows": rows})
        assert json.loads(text)["rows"] == rows
        assert len(text.splitlines()) >= len(rows) + 4
    with pytest.raises(ValueError, match="not JSON compliant"):
        _to_text([[0.0, float("nan")]])


def test_file_has_the_planner_s_own_numbers(task):
    other = task.with_changes(iterations=5000)
    found = slide._core.plan(other.problem, other.options, other.budget)
    plan = graspless.plan(other)
    assert found
    assert plan.joint_names == found.joint_names
    for mine, theirs in zip(plan.segments, found.segments, strict=True):
        np.testing.assert_array_equal(mine.positions, theirs.positions)  # bit by bit
        np.testing.assert_allclose(mine.object_poses, theirs.object_poses, atol=1e-12)
    np.testing.assert_allclose(plan.X_WO_goal, found.X_WO_goal, atol=1e-12)
    np.testing.assert_allclose(plan.X_WH_grasp, found.X_WH_grasp, atol=1e-12)
    assert plan.overhang == found.overhang
    assert plan.status is found.status
    assert plan.statistics.nodes == found.statistics.nodes


def test_poses_are_converted_at_once(task, monkeypatch):
    calls = []
    for name in ("to_quaternion", "from_quaternion"):
        convert = getattr(frames, name)
        monkeypatch.setattr(
            frames, name, lambda X, name=name, convert=convert: calls.append(name) or convert(X)
        )
    again = graspless.plan(task, iterations=5000)
    assert calls == ["to_quaternion", "from_quaternion"]
    assert again


def test_rows_are_dense_enough_to_replay(plan):
    for segment in plan.segments:
        assert np.abs(np.diff(segment.positions, axis=0)).max(initial=0) <= 0.05 + 1e-9
    ends = [segment.positions[-1] for segment in plan.segments[:-1]]
    starts = [segment.positions[0] for segment in plan.segments[1:]]
    np.testing.assert_allclose(ends, starts, atol=1e-12)


def test_file_says_every_value_in_force(document):
    options = document["task"]["options"]
    assert options["search"] == "fast"
    assert options["com_margin"] == slide.Options().com_margin
    assert document["task"]["hand"]["flexure_length"] == 0.11
    assert document["task"]["budget"]["iterations"] == 5000
    assert document["task"]["robot"]["urdf_text"].startswith("<?xml")


def test_failed_plan_is_written_too(task, tmp_path):
    plan = graspless.plan(task, iterations=0)
    assert not plan
    assert plan.status != "solved"
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert (again.status, again.reason) == (plan.status, plan.reason)
    assert again.statistics.as_dict() == plan.statistics.as_dict()
    assert again.segments == ()
    assert graspless.check(again) == [
        f"nothing to check: the plan's status is {plan.status}, not solved; reason: {plan.reason}"
    ]


def test_check_finds_a_plan_that_was_changed(plan, document, tmp_path):
    changes = {
        "through": lambda d: d["segments"][0]["positions"][5].__setitem__(3, -0.5),
        "home": lambda d: d["segments"].pop(0),
        "object": lambda d: d["segments"][2]["object_poses"][4].__setitem__(0, 9.0),
        "table": lambda d: d["task"]["support"]["rectangle"].update(size=[0.5, 0.5]),
    }
    for change in changes.values():
        assert graspless.check(reread(document, tmp_path / "plan.json", change))


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda d: d.pop("format"), "not a plan file"),
        (lambda d: d.update(format=2), "format: 2: this graspless reads format 1"),
        (lambda d: d.update(status="done"), "status: done: should be 'solved'"),
        (lambda d: d.pop("segments"), "segments: missing"),
        (lambda d: d.update(more=1), "more: unknown field"),
        (lambda d: d["segments"][0]["positions"][0].pop(), "row 0 of segment 'approach' has 7"),
        (lambda d: d["segments"][0]["positions"].pop(), "one per row is needed"),
        (lambda d: d["segments"][0]["object_poses"][0].pop(), r"object_poses\[0\]: .*at least 7"),
        (lambda d: d["X_WO_goal"].__setitem__(3, 2.0), "not of unit length"),
        (lambda d: d["overhang"].__class__ and d.update(overhang=float("nan")), "NaN"),
        (lambda d: d["task"].pop("object"), "object: missing"),
        (
            lambda d: d["stats"].update(iterations=2**64),
            "stats.iterations: 18446744073709551616: .*less",
        ),
        (lambda d: d["stats"].update(projections={}), r"stats.projections: \{\}: .*valid integer"),
        (lambda d: d["stats"].update(refusals=0), "stats.refusals: 0: .*(dictionary|mapping)"),
        (
            lambda d: d["stats"].update(refusals={"a": 2**63}),
            "stats.refusals.a: 9223372036854775808: ",
        ),
        (lambda d: d.update(seed=2**64), "seed: 18446744073709551616: should be less"),
        (lambda d: d["task"]["robot"].update(urdf_text="<robot>"), "robot.urdf_text: "),
    ],
)
def test_broken_plan_files(document, tmp_path, change, what):
    with pytest.raises(TaskError, match=what) as caught:
        reread(document, tmp_path / "plan.json", change)
    assert str(caught.value).startswith(str(tmp_path / "plan.json"))


RUNS = {"time": graspless.time, "simulate": graspless.simulate, "show": write_html}


@pytest.mark.parametrize("purpose", RUNS)
@pytest.mark.parametrize("is_bare", [False, True], ids=["no_rows", "no_segments"])
def test_a_plan_without_motion_is_not_run(document, tmp_path, purpose, is_bare):
    kept = (
        [] if is_bare else [s | {"positions": [], "object_poses": []} for s in document["segments"]]
    )
    (tmp_path / "plan.json").write_text(json.dumps(document | {"segments": kept}))
    given = graspless.load_plan(tmp_path / "plan.json")
    words = "the slide plan has no segments" if is_bare else "'approach' .* has no rows"
    with pytest.raises(TaskError, match=f"{words}: nothing to {purpose}"):
        RUNS[purpose](given, *([tmp_path / "x.html"] if purpose == "show" else []))


def test_numbers_of_a_plan_are_those_of_its_file(task):
    for seed in range(5):
        made = graspless.plan(task, seed=seed)
        read = type(made)._made(json.loads(made.to_json()), made.task)
        assert made.X_WO_goal.tobytes() == read.X_WO_goal.tobytes()
        for mine, other in zip(made.segments, read.segments, strict=True):
            assert mine.object_poses.tobytes() == other.object_poses.tobytes()
        before = json.loads(made.to_json())
        for plan in (made, read):
            plan.warnings = ["slippery"]
            assert json.loads(plan.to_json()) == before | {"warnings": ["slippery"]}
        assert made == read
        made.X_WO_goal = frames.translation([1.0, 2.0, 3.0])
        assert json.loads(made.to_json())["X_WO_goal"] == [1, 2, 3, 1, 0, 0, 0]


def test_budget_of_a_script_is_the_one_that_is_used(task, monkeypatch):
    budget = graspless.planning.Budget(seconds=5, seed=4)
    used = []
    search = slide._core.plan
    monkeypatch.setattr(slide._core, "plan", lambda *given: used.append(given[2]) or search(*given))
    made = graspless.plan(task, budget=budget)
    assert 0 < used[0].seconds <= 5  # less what reading took
    budget.stop()  # as another thread may
    assert used[0].is_stopped
    assert (made.seed, made.task.budget.seconds) == (4, 5)
    with pytest.raises(TaskError, match="must not be given beside"):
        graspless.plan(task, budget=budget, seed=1)


def test_budget_without_a_limit_of_time_is_refused(task):
    budget = graspless.planning.Budget(seconds=float("inf"))
    for plan in (
        lambda: slide.plan(task.problem, None, budget),
        lambda: graspless.plan(task, budget=budget),
    ):
        with pytest.raises(TaskError, match="budget: seconds is inf; should be finite"):
            plan()


def test_builtin_robots_are_found_by_name():
    assert graspless.robot.builtin("kr5_t42").is_file()
    with pytest.raises(
        ValueError,
        match=r"wam: no such robot .*; did you mean 'wam_t42'\? .*one of: kr5_armar, .*kr5_t42, wam_t42",
    ):
        graspless.robot.builtin("wam")


def test_no_plan_at_all(tmp_path):
    path = tmp_path / "plan.json"
    with pytest.raises(TaskError, match=r"plan.json: cannot be read: No such file"):
        graspless.load_plan(path)
    path.write_text('{"format": 1,\n "kind" "slide"}')
    with pytest.raises(TaskError, match=r"plan.json:2: not valid JSON: .* \(column 9\)"):
        graspless.load_plan(path)
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(TaskError, match=r"plan.json: not a text file in UTF-8"):
        graspless.load_plan(path)


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ('"format": 1', '"format": 1, "s\\u0065ed": 2', "seed"),
        ('"thickness"', '"name": "card", "name": "card", "thickness"', "task.object.name"),
        ('"name": "press"', '"name": "press", "name": "press"', r"segments\[1\].name"),
        (
            '"X_WO_goal"',
            '"segments": [{"name": "a"}, {"name": "b", "name": "b"}], "X_WO_goal"',
            "segments",
        ),
    ],
)
def test_field_that_a_plan_names_twice(plan, tmp_path, old, new, place):
    (tmp_path / "plan.json").write_text(changed(old, new, plan.to_json()))
    with pytest.raises(TaskError, match=f"plan.json: {place}: given twice$"):
        graspless.load_plan(tmp_path / "plan.json")


def test_plan_with_a_mesh_stands_alone_beside_it(tmp_path):
    import trimesh

    trimesh.creation.box([0.1, 0.1, 0.1]).export(tmp_path / "box.stl")
    obstacle = "obstacles: [{name: e, mesh: {file: box.stl}, pose: {position: [2, 0, 0]}}]\nbudget:"
    (tmp_path / "task.yaml").write_text(changed("budget:", obstacle))
    plan = graspless.plan(tmp_path / "task.yaml", iterations=5000)
    plan.save(tmp_path / "plan.json")
    (tmp_path / "task.yaml").unlink()
    assert graspless.check(tmp_path / "plan.json") == []


def test_schema_is_that_of_the_model(document):
    spec = importlib.util.spec_from_file_location("schema", ROOT / "tools" / "schema.py")
    schema = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(schema)
    assert schema.TARGET.read_text() == schema.text(), "run tools/schema.py"
    published = json.loads(schema.text())
    kind = published["discriminator"]["mapping"]["slide"].rpartition("/")[2]
    fields = published["$defs"][kind]
    assert set(fields["required"]) <= set(document)
    assert set(document) <= set(fields["properties"])
    # In brackets there are units: [N] is newtons. Shapes are (N, 3).
    texts = json.dumps(published, indent=1) + schema.trajectory_text()
    for text in re.findall(r'"description": "(.*)"', texts):
        assert not re.search(r"^\[(?!m\])|\]\[", text), text


def unbounded(schema, place=()):
    """Yields the places of whole numbers without a largest or a least value."""
    if isinstance(schema, dict) and schema.get("type") == "integer":
        upper, lower = {"maximum", "exclusiveMaximum"}, {"minimum", "exclusiveMinimum"}
        if "const" not in schema and not (upper & set(schema) and lower & set(schema)):
            yield place
    inner = schema.items() if isinstance(schema, dict) else enumerate(schema)
    for key, value in inner:
        if isinstance(value, (dict, list)):
            yield from unbounded(value, (*place, key))


@pytest.mark.parametrize("kind", [*KINDS, "plan"])
def test_every_whole_number_has_bounds(kind):
    """The core would answer those beyond its own with a TypeError that names no field."""
    schema = table.schema() if kind == "plan" else part("tasks", kind).Fields.model_json_schema()
    # Arguments of xacro are text to us.
    assert [place for place in unbounded(schema) if "xacro_args" not in place] == []


def test_former_counters_and_those_without_a_value_are_ignored(document, tmp_path):
    stats = document["stats"] | {"former": [1], "pairs": None}
    found = reread(document | {"stats": stats}, tmp_path / "plan.json").statistics.as_dict()
    assert found == {name: document["stats"][name] for name in found} | {"pairs": 0}


def test_writes_whole_or_not_at_all(tmp_path, monkeypatch):
    path = tmp_path / "plan.json"
    path.write_text("before")
    path.chmod(0o640)
    files.write(path, "after")
    assert path.read_text() == "after"
    assert stat.S_IMODE(path.stat().st_mode) == 0o640

    def fail(self, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(pathlib.Path, "replace", fail)
    with pytest.raises(TaskError, match="No space left"):
        files.write(path, "never")
    assert path.read_text() == "after"
    assert list(tmp_path.iterdir()) == [path]


def test_new_files_keep_to_the_umask_of_the_process(tmp_path, monkeypatch):
    before = os.umask(0o027)
    try:
        monkeypatch.setattr(os, "umask", None)  # to set it would open files of other threads
        files.write(tmp_path / "plan.json", "new")
    finally:
        monkeypatch.undo()
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "plan.json").stat().st_mode) == 0o640


def test_writes_through_links_and_into_devices(tmp_path):
    (tmp_path / "there").write_text("before")
    link = tmp_path / "link"
    link.symlink_to(tmp_path / "there")
    files.write(link, "after")
    assert link.is_symlink()
    assert (tmp_path / "there").read_text() == "after"
    files.write("/dev/null", "nothing")
    assert not pathlib.Path("/dev/null").is_file()


def test_table_reads_what_it_writes(plan, document):
    fields = SlidePlanFile.model_validate(document)
    assert json.loads(plan.to_json()) == document
    assert fields.model_dump(mode="json", exclude_none=True) == document


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: frames.translation([1, 2]), r"p_AB: shape \(2,\): should be three numbers"),
        (lambda: frames.translation(3), r"p_AB: shape \(\): should be three numbers"),
        (lambda: frames.from_rpy([0, 0]), "rpy: shape"),
        (lambda: frames.from_quaternion([1, 0, 0]), r"wxyz: shape \(3,\): should be \(..., 4\)"),
        (lambda: frames.from_quaternion(np.zeros((2, 4))), "wxyz: a quaternion of length 0"),
    ],
)
def test_what_is_no_pose_is_not_converted(call, words):
    with pytest.raises(TaskError, match=words):
        call()


def test_text_of_a_plan_is_the_plan(plan):
    assert graspless.load_plan(io.StringIO(plan.to_json())) == plan
    with pytest.raises(TaskError, match=r"^plan:1: "):
        graspless.load_plan(io.StringIO("{"))
    with pytest.raises(TaskError, match="should be the path of a file"):
        graspless.load_plan(plan.to_json())
