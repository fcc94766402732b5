# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python surface: one plan type per kind, from a task file or from a problem."""

import copy
import enum
import json
import multiprocessing
import pathlib
import pickle

import numpy as np
import pytest
import yaml

import graspless
from graspless import (
    TaskError,
    _core,
    carry,
    clasp,
    collision,
    fingertip,
    geometry,
    planning,
    robot,
    slide,
)
from graspless.tasks import Task
from graspless.tasks.kind import is_problem
from graspless.tasks.statement import difference
from tasks_common import pixels, read_png, without_clock

ROOT = pathlib.Path(__file__).parents[2]
MODULES = {"slide": slide, "fingertip": fingertip, "clasp": clasp, "carry": carry}


def obstacles():
    """One of each shape, and one of several, out of the way."""
    box = geometry.Box([0.1, 0.2, 0.3])
    corners = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]])
    triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    X = np.eye(4)
    X[:3, 3] = 0, 0, 0.4
    shapes = {
        "box": [geometry.PlacedShape(box)],
        "ball": [geometry.PlacedShape(geometry.Sphere(0.1))],
        "capsule": [geometry.PlacedShape(geometry.Capsule(0.1, 0.2))],
        "convex": [geometry.PlacedShape(geometry.Convex(corners))],
        "mesh": [geometry.PlacedShape(geometry.Mesh(corners, triangles))],
        "two": [geometry.PlacedShape(box), geometry.PlacedShape(box, X)],
    }
    found = []
    for k, (name, parts) in enumerate(shapes.items()):
        X_WB = np.eye(4)
        X_WB[:3, 3] = -2, 0, k
        found.append(collision.Obstacle(name, parts, X_WB))
    return found


def slide_problem(card_problem):
    given = {name: getattr(card_problem, name) for name in ("robot", "hand", "object", "support")}
    return slide.Problem(
        **given,
        X_WO_start=card_problem.X_WO_start,
        q_home=card_problem.q_home,
        obstacles=obstacles(),
    )


def fingertip_problem():
    block = fingertip.Object.box("block", [0.05, 0.10, 0.05], mass=0.2)
    X_WO = np.eye(4)
    X_WO[2, 3] = 0.025
    return fingertip.Problem(
        object=block,
        motion=fingertip.slide_path(X_WO, [0.05, 0.0, 0.0], segments=4),
        planes=[fingertip.Plane(), fingertip.Plane("behind", [1, 0, 0], -0.5)],
        friction=(0.4, 0.5),
    )


def clasp_problem():
    urdf = robot.builtin("kr5_sdh")
    arm = robot.Robot.from_urdf_file(str(urdf))
    hand = clasp.hand_from_yaml_file(str(urdf.with_name("kr5_sdh.clasp.yaml")))
    cloud = geometry.sample_surface(clasp.sample_object("purse"), 2000)
    X_WO = np.eye(4)
    X_WO[:3, 3] = 0.62, 0.05, 0.0
    return clasp.Problem(
        arm,
        hand,
        clasp.Object.from_cloud("purse", cloud),
        X_WO,
        arm.state("home"),
        pull_W=[0, 0, 1],
    )


def carry_problem():
    arm = robot.Robot.from_urdf_file(str(robot.builtin("wam_t42")))
    q = arm.state("open").copy()
    q[1], q[3], q[5] = 0.7, 1.6, 0.8
    X_WH = arm.pose("grasp", q)
    X_WO, X_WG = X_WH.copy(), X_WH.copy()
    X_WG[2, 3] += 0.03
    held = collision.Obstacle("bar", [geometry.PlacedShape(geometry.Box([0.02, 0.02, 0.1]))], X_WO)
    return carry.Problem(arm, "grasp", held, X_WG, q)


@pytest.fixture(scope="module", params=list(MODULES))
def problem(request, card_problem):
    make = {
        "slide": lambda: slide_problem(card_problem),
        "fingertip": fingertip_problem,
        "clasp": clasp_problem,
        "carry": carry_problem,
    }
    return make[request.param]()


@pytest.fixture(scope="module")
def plan(problem):
    made = graspless.plan(problem, seconds=20, iterations=5000, seed=2)
    assert made, made.reason
    return made


def test_a_problem_is_planned_by_its_kind(problem, plan):
    module = MODULES[plan.kind]
    assert is_problem(problem)
    assert isinstance(plan, module.Plan)
    assert isinstance(plan, graspless.Plan)
    assert plan.task.problem is problem
    assert plan.seed == 2
    assert graspless.check(plan) == []
    assert module.check(problem, plan) == []
    assert all(isinstance(segment, module.Segment) for segment in plan.segments)


def test_a_plan_of_a_problem_is_saved_and_loaded(plan, tmp_path):
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert again == plan
    assert again.to_json() == (tmp_path / "plan.json").read_text()
    assert difference(plan.task.problem, again.task.problem, "problem") is None
    assert graspless.check(again) == []


def test_the_planner_s_own_function_gives_the_same_plan(problem, plan):
    module = MODULES[plan.kind]
    budget = planning.Budget(seconds=20, iterations=5000, seed=2)
    again = module.plan(problem, module.Options(), budget)
    assert type(again) is type(plan)
    for mine, theirs in zip(again.segments, plan.segments, strict=True):
        np.testing.assert_array_equal(mine.object_poses, theirs.object_poses)


def test_plans_and_tasks_are_pickled_copied_and_compared(plan):
    for made in (pickle.loads(pickle.dumps(plan)), copy.copy(plan), copy.deepcopy(plan)):
        assert made is not plan
        assert made == plan
    task = pickle.loads(pickle.dumps(plan.task))
    assert task == plan.task
    assert task.with_changes(seed=9) != task
    other = copy.copy(plan)
    other.reason = "another"
    assert other != plan
    assert json.loads(other.to_json())["reason"] == "another"


def test_options_and_counters_are_pickled_and_copied():
    stability = clasp.StabilityOptions(force=3.0)
    for given in (
        slide.Options(search=slide.Search.paper, min_depth=0.001),
        clasp.Options(must_be_secure=False, stability=stability),
        fingertip.Options(threads=2),
        slide.Statistics(seconds=0.5, refusals={"goal: reach": 3}),
        slide.Hand(fingers=["a", "b"], finger_model=slide.FingerModel.none),
    ):
        for made in (pickle.loads(pickle.dumps(given)), copy.deepcopy(given)):
            assert type(made) is type(given)
            assert made is not given
            assert repr(made) == repr(given)


def test_plans_without_a_task_are_compared():
    assert slide.Plan() == slide.Plan()
    assert slide.Plan() != clasp.Plan()


def test_plans_cross_processes(plan):
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(graspless.check, [plan]) == []


def test_text_is_one_short_line(plan):
    for text in (repr(plan), repr(plan.task)):
        assert len(text.splitlines()) == 1
        assert len(text) < 200
    assert repr(plan).startswith(f"<{plan.kind} plan, solved: ")
    assert repr(plan.task).startswith(f"<{plan.kind} task, '")


def test_a_dict_is_planned():
    document = yaml.safe_load((ROOT / "examples" / "01_slide_card.yaml").read_text())
    plan = graspless.plan(document, iterations=5000)
    assert isinstance(plan, slide.Plan)
    same = graspless.plan(ROOT / "examples" / "01_slide_card.yaml", iterations=5000)
    assert without_clock(plan) == without_clock(same)
    assert graspless.plan(plan.task.to_dict(), iterations=5000).segments[0].name == "approach"
    with pytest.raises(TaskError, match="should be a graspless.Task, a Problem, a dict"):
        graspless.plan(3)


def test_the_kind_of_a_task_file_can_be_demanded():
    path = ROOT / "examples" / "01_slide_card.yaml"
    assert graspless.load_task(path, "slide").kind == "slide"
    with pytest.raises(TaskError, match=r"01_slide_card.yaml:\d+: kind: slide: should be 'clasp'"):
        graspless.load_task(path, "clasp")
    with pytest.raises(TaskError, match="^kind: clap: .*; did you mean 'clasp'"):
        graspless.load_task(path, "clap")


def test_fields_are_not_loaded_but_planned():
    with pytest.raises(TaskError, match="path: {'kind': 'slide'}: .*; graspless.plan takes the fi"):
        graspless.load_task({"kind": "slide"})


@pytest.mark.parametrize(
    "given", [{"kind": list(range(9999))}, [0.5] * 9999, "x" * 9999, b"x" * 9999, np.eye(99)]
)
@pytest.mark.parametrize(
    "call",
    [
        graspless.load_task,
        graspless.load_plan,
        graspless.check,
        graspless.time,
        lambda given: graspless.load_task("task.yaml", {"kind": given}),
        lambda given: graspless.plan("task.yaml", seconds=given),
        lambda given: graspless.plan("task.yaml", budget=given),
    ],
)
def test_long_values_are_cut_in_messages(call, given):
    with pytest.raises(TaskError, match="should be") as caught:
        call(given)
    assert len(str(caught.value)) < 200
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("digits", [400, 5000])
def test_numbers_beyond_a_float_are_refused(digits):
    with pytest.raises(TaskError, match="seconds: .*: should have at most 308 digits"):
        graspless.plan("task.yaml", seconds=10**digits)


def test_options_and_budget_of_another_type_are_refused():
    problem = fingertip_problem()
    with pytest.raises(TaskError, match="options: .*: should be a graspless.fingertip.Options"):
        fingertip.plan(problem, slide.Options())
    with pytest.raises(TaskError, match="budget: 5: should be a graspless.planning.Budget"):
        fingertip.plan(problem, None, 5)


def test_what_no_task_file_can_state_is_told(tmp_path):
    tilted = np.eye(4)
    tilted[:3, :3] = [[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]]
    held = carry_problem()
    problem = carry.Problem(
        held.robot,
        "grasp",
        held.object,
        held.X_WO_goal,
        held.q_start,
        [collision.Obstacle("shelf", [geometry.PlacedShape(geometry.Box([1, 1, 0.01]))], tilted)],
        {"shelf": [0, -0.6, 0.8]},
    )
    plan = carry.plan(problem, budget=planning.Budget(seconds=5))
    assert plan.status
    with pytest.raises(
        TaskError, match=r"problem.rests_on\['shelf'\]: no task file can express it"
    ):
        plan.save(tmp_path / "plan.json")
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(TaskError, match="cannot be saved or pickled"):
        pickle.dumps(plan.task)


def test_a_problem_without_a_floor_is_told():
    given = fingertip_problem()
    problem = fingertip.Problem(object=given.object, motion=given.motion, planes=[])
    with pytest.raises(TaskError, match=r"problem.planes: must hold the floor"):
        Task.of(problem).to_dict()


def test_a_plan_of_a_problem_is_timed_simulated_exported_and_drawn(card_problem, tmp_path):
    plan = slide.plan(card_problem, budget=planning.Budget(seconds=20, iterations=5000, seed=2))
    from graspless.view.bodies import OBJECT

    arm = graspless.export(plan, tmp_path / "arm.csv", "csv", group="arm")
    whole = graspless.time(plan)
    assert arm.joint_names == whole.joint_names[:7]
    np.testing.assert_array_equal(arm.positions, whole.positions[:, :7])
    assert whole.start == dict(zip(whole.joint_names, plan.segments[0].positions[0], strict=True))
    with pytest.raises(TaskError, match=r"group: .*'legs'.*arm"):
        graspless.export(plan, tmp_path / "legs.csv", "csv", group="legs")
    with pytest.raises(TaskError, match="mujoco holds the whole robot"):
        graspless.export(plan, tmp_path / "a.xml", "mujoco", group="arm")
    graspless.view.write_png(plan, tmp_path / "plan.png")
    assert len(pixels(read_png(tmp_path / "plan.png"), OBJECT)) > 300
    assert plan.plot().get_size_inches()[0] > 5
    html = plan._repr_html_()
    assert html.startswith("<pre>solved in")
    assert "data:image/png;base64," in html
    assert graspless.simulate(plan, trials=1).trials


def test_replays_open_in_the_browser(monkeypatch):
    import webbrowser

    plan = graspless.plan(ROOT / "examples" / "01_slide_card.yaml", iterations=5000)
    opened = []
    monkeypatch.setattr(webbrowser, "open", lambda url: opened.append(url) or True)
    plan.show()
    page = pathlib.Path(opened[0].removeprefix("file://"))
    assert "__VISER_EMBED_DATA__" in page.read_text()
    page.unlink()


def test_only_public_names_are_listed():
    for module in (*MODULES.values(), graspless.view, graspless.chain, robot):
        assert sorted(module.__all__) == dir(module)


def test_members_of_every_enum_of_the_core_equal_their_names():
    rooms = [getattr(_core, room) for room in dir(_core) if not room.startswith("_")]
    enums = {v for room in rooms for v in vars(room).values() if isinstance(v, enum.EnumMeta)}
    assert len(enums) > 10
    for kind in enums:
        for name, member in kind.__members__.items():
            assert member == name
            assert str(member) == name
