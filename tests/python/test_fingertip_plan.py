# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip plans: what is written is what was found, and what is read back checks the same."""

import itertools
import json
import threading
import time

import numpy as np
import pytest

import graspless
from fingertip_common import ALONG_WALL, PUSH, TUMBLE, changed
from graspless import TaskError, fingertip, frames, planning, report
from graspless.plan_files import read_plan
from graspless.tasks import read_task
from tasks_common import reread, without_clock


@pytest.fixture(scope="module")
def push():
    plan = graspless.plan(read_task(PUSH, "push.yaml"))
    assert plan, plan.reason
    return plan


@pytest.fixture(scope="module")
def tumble():
    plan = graspless.plan(read_task(TUMBLE, "tumble.yaml"))
    assert plan, plan.reason
    return plan


@pytest.fixture(scope="module")
def document(tumble):
    return json.loads(tumble.to_json())


# Where the fingers press at first, and the block never comes.
OBSTACLE = {"name": "lamp", "box": [0.1, 0.1, 0.02], "pose": {"position": [0.0, 0.0, 0.126]}}


def test_pushing_and_tumbling_hold(push, tumble):
    assert graspless.check(push) == []
    assert graspless.check(tumble) == []
    assert (push.kind, push.regrasps) == ("fingertip", 0)
    assert [segment.name for segment in push.segments] == ["slide"]
    assert tumble.regrasps == 1
    assert [segment.name for segment in tumble.segments] == ["tumble", "regrasp", "tumble"]
    assert tumble.cost == pytest.approx(tumble.lower_bound)
    assert tumble.cost > tumble.task.options.regrasp_cost


@pytest.mark.parametrize("search", ["dijkstra", "paper", "fast"])
def test_all_searches_find_the_same_cost(push, search):
    plan = graspless.plan(push.task, search=search)
    assert plan.cost == pytest.approx(push.cost, abs=1e-9)
    assert graspless.check(plan) == []


def test_rows_are_what_the_planner_found(push):
    found = fingertip._core.plan(push.task.problem, push.task.options, push.task.budget)
    segment, theirs = push.segments[0], found.segments[0]
    assert segment.fingers.shape == (len(theirs), 2, 3)
    assert len(segment.X_WO) == 7
    for i, row in enumerate(theirs.rows):
        np.testing.assert_allclose(segment.object_poses[i], row.X_WO, atol=1e-12)
        assert segment.stability[i] == row.stability
        for k, finger in enumerate(row.fingers):
            np.testing.assert_array_equal(segment.fingers[i, k], finger.p_OC)
            np.testing.assert_array_equal(segment.normals[i, k], finger.n_O)
            np.testing.assert_array_equal(segment.nominal_forces[i, k], finger.nominal_force_O)
            assert segment.commanded_forces[i, k] == finger.commanded_force
            assert segment.modes[i][k] == finger.mode.name


def test_finger_that_regrasps_is_off_the_object(tumble, document):
    regrasp = tumble.segments[1]
    assert regrasp.touches.sum() == 1
    assert not regrasp.touches[0, regrasp.finger]
    fields = document["segments"][1]
    assert fields["fingers"][0][regrasp.finger] is None
    assert fields["normals"][0][regrasp.finger] is None
    moved = [
        k
        for k in range(2)
        if not np.allclose(tumble.segments[0].fingers[-1, k], tumble.segments[2].fingers[0, k])
    ]
    assert moved == [regrasp.finger]


def test_plan_holds_after_its_file(tumble, tmp_path):
    tumble.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert graspless.check(again) == []
    assert again.to_json() == tumble.to_json()
    assert again == tumble


def test_file_says_every_value_in_force(document):
    options = document["task"]["options"]
    assert options["search"] == "fast"
    assert options["min_stability"] == fingertip.Options().min_stability
    assert options["compliance"]["finger_normal"] == fingertip.Compliance().finger_normal
    assert document["task"]["fingers"]["friction"] == 0.7


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d["segments"][0]["fingers"][5][0].__setitem__(0, 0.02),
        lambda d: d["segments"][0]["normals"][5].__setitem__(0, [1.0, 0.0, 0.0]),
        lambda d: d["segments"][0]["modes"][5].__setitem__(0, "position"),
        lambda d: d["segments"][0]["stability"].__setitem__(5, 99.0),
        lambda d: d["segments"][0]["nominal_forces"][5].__setitem__(0, [0.0, 0.0, 0.0]),
        lambda d: d["segments"][0]["object_poses"][5].__setitem__(0, 0.5),
        lambda d: d["segments"].pop(1) and d.pop("weakest"),
        lambda d: d.update(cost=1.0),
        lambda d: d["task"]["obstacles"].append(OBSTACLE),
        lambda d: d["task"]["fingers"].update(max_normal_force=3.0),
    ],
    ids=["point", "normal", "mode", "z", "force", "pose", "regrasp", "cost", "obstacle", "limit"],
)  # fmt: skip
def test_check_finds_a_plan_that_was_changed(document, tmp_path, change):
    assert graspless.check(reread(document, tmp_path / "plan.json", change))


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda d: d.update(kind="clap"), "kind: clap: should be 'slide' or 'pinch' or 'fingertip'"),
        (lambda d: d.update(status="no_goal_root"), "status: no_goal_root: should be 'solved'"),
        (lambda d: d.pop("regrasps"), "regrasps: missing"),
        (lambda d: d["segments"][0]["stability"].pop(), "one per row is needed"),
        (lambda d: d["segments"][0]["fingers"][3].pop(), "row 3 of segment 0 'tumble' has 1 fingers for 2"),
        (lambda d: d["segments"][0]["fingers"][3].__setitem__(0, None), "a point and a normal, or neither"),
        (lambda d: d["segments"][0]["modes"][3].__setitem__(0, "soft"), "should be 'position' or"),
        (lambda d: d["segments"][1].update(finger=7), "moves finger 7 of 2"),
        (lambda d: d["segments"][0]["X_WO"][0].__setitem__(3, 4.0), "not of unit length"),
        (lambda d: d["weakest"].update(row=900), "weakest: there is no row 900"),
        (lambda d: d["task"].pop("motion"), "motion: missing"),
    ],
)  # fmt: skip
def test_broken_plan_files(document, tmp_path, change, what):
    with pytest.raises(TaskError, match=what) as caught:
        reread(document, tmp_path / "plan.json", change)
    assert str(caught.value).startswith(str(tmp_path / "plan.json"))


@pytest.fixture(scope="module")
def along_wall():
    plan = graspless.plan(read_task(ALONG_WALL, "rail.yaml"))
    assert plan, plan.reason
    return plan


def test_a_wall_with_friction_of_its_own(along_wall, tmp_path):
    assert graspless.check(along_wall) == []
    document = json.loads(along_wall.to_json())
    assert document["task"]["walls"][0]["friction"] == 0.2
    again = reread(document, tmp_path / "plan.json")
    assert again.to_json() == along_wall.to_json()
    assert graspless.check(again) == []
    for friction in (0.1, 0.3, [0.2, 40]):
        document["task"]["walls"][0]["friction"] = friction
        assert graspless.check(reread(document, tmp_path / "plan.json"))
    del document["task"]["walls"][0]["friction"]
    assert graspless.check(reread(document, tmp_path / "plan.json"))


def test_friction_of_its_own_that_is_the_tasks_changes_nothing():
    def document(text):
        found = without_clock(graspless.plan(read_task(text, "rail.yaml")))
        del found["task"]
        return found

    own = changed("friction: 0.2}", "friction: 0.5}", ALONG_WALL)
    common = changed(", friction: 0.2}", "}", ALONG_WALL)
    assert document(own) == document(common)
    floor = changed("walls:", "floor: {friction: 0.5}\nwalls:", own)
    assert document(floor) == document(common)
    assert document(ALONG_WALL) != document(common)


def test_a_wall_of_a_problem_made_in_python_keeps_its_friction(along_wall, tmp_path):
    task = along_wall.task
    made = fingertip.plan(task.problem, task.options)
    assert made.cost == along_wall.cost
    made.save(tmp_path / "plan.json")
    document = json.loads((tmp_path / "plan.json").read_text())
    assert document["task"]["walls"][0]["friction"] == [0.2, 0.2]
    assert "friction" not in document["task"]["floor"]
    assert graspless.check(graspless.load_plan(tmp_path / "plan.json")) == []


def test_an_interval_of_friction_that_no_plane_uses_is_none():
    def refused(friction):
        far = (fingertip.Plane(f"wall {i}", [1, 0, 0], -1.0 - i, (0.45, 0.55)) for i in range(5))
        block = fingertip.Object.box("block", [0.05, 0.10, 0.05], mass=1.0)
        problem = fingertip.Problem(
            object=block,
            motion=fingertip.slide_path(STANDING, [0.05, 0, 0], 6),
            fingers=fingertip.Fingers(count=2, radius=0.01, max_normal_force=10, friction=0.7),
            planes=[fingertip.Plane(friction=(0.45, 0.55)), *far],
            friction=friction,
        )
        options = fingertip.Options(locations_per_side=5)
        plan = fingertip.plan(problem, options)
        assert fingertip.check(problem, plan, options) == []
        return plan.status, plan.cost

    assert refused((0.4, 0.6)) == refused(0.5)


STANDING = np.eye(4)
STANDING[2, 3] = 0.025


def lattice(lower, upper, yaws, turn=0.0):
    """A block that goes straight ahead, and turns, on a lattice with these yaws."""
    goal = frames.planar(0.04, 0, turn)
    goal[2, 3] = STANDING[2, 3]
    return fingertip.Problem(
        object=fingertip.Object.box("block", [0.05, 0.10, 0.05], mass=1.0),
        motion=fingertip.Lattice(
            X_WO_start=STANDING,
            X_WO_goal=goal,
            lower=[0, 0, lower],
            upper=[0.04, 0, upper],
            counts=(5, 1, yaws),
        ),
        fingers=fingertip.Fingers(count=2, radius=0.01, max_normal_force=10, friction=0.7),
        planes=[fingertip.Plane()],
        friction=0.5,
    )


def test_the_motion_of_a_problem_is_a_copy():
    problem = lattice(-0.5, 0.5, 5)
    motion = problem.motion
    motion.counts = (1, 1, 1)
    assert list(problem.motion.counts) == [5, 1, 5]


def test_yaws_of_a_lattice_may_go_round_more_than_once():
    options = fingertip.Options(locations_per_side=3, max_regrasps=0)
    problem = lattice(-0.5, 7.0, 16)  # 6.5 rad is near a whole turn, but not on it
    plan = fingertip.plan(problem, options)
    assert plan.status == "solved"
    assert fingertip.check(problem, plan, options) == []
    problem = lattice(-7.0, 1.0, 17, turn=0.5)  # more than a whole turn above its lowest yaw
    plan = fingertip.plan(problem, options)
    assert plan.status == "solved"
    assert fingertip.check(problem, plan, options) == []


def test_only_plans_that_turn_the_object_warn_of_it():
    options = fingertip.Options(locations_per_side=5)
    straight = fingertip.plan(lattice(-0.1, 0.1, 3), options)
    assert [segment.name for segment in straight.segments] == ["slide"]
    assert not straight.warnings
    turned = fingertip.plan(lattice(0.0, 0.1, 3, turn=0.1), options)
    assert "a face turns about its normal" in turned.warnings[0]


def test_check_finds_too_many_regrasps(tumble):
    options = fingertip.Options(max_regrasps=0)
    faults = fingertip.check(tumble.task.problem, tumble, options)
    assert faults == ["plan: has 1 regrasps, options.max_regrasps allows 0"]


def test_a_wall_that_is_too_rough_is_named():
    rough = changed("friction: 0.2}", "friction: 1}", ALONG_WALL)
    rough = changed("_side: 5", "_side: 5, min_stability: 8.3", rough)
    plan = graspless.plan(read_task(rough, "rail.yaml"))
    assert plan.status == "unstable"
    helpful = {found.field: found.value for found in plan.relaxations}
    assert 0.2 < helpful["planes[1] 'rail'.friction"] < 1
    assert "planes[1] 'rail'.friction" in report.as_text(plan)


def test_failed_plan_says_what_blocks_and_what_would_help(tmp_path):
    weak = changed("max_normal_force: 10", "max_normal_force: 0.3")
    plan = graspless.plan(read_task(weak, "weak.yaml"))
    assert not plan
    assert (plan.status, plan.cost, plan.weakest) == ("unstable", None, None)
    assert plan.withstands is None
    assert plan.limit
    text = report.as_text(plan)
    assert f"limiting condition: {plan.limit}" in text
    for relaxation in plan.relaxations:
        assert relaxation.field in text
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert again == plan
    assert graspless.check(again)[0].startswith("nothing to check: the plan's status is unstable")


def test_report_names_cost_segments_and_the_weakest_step(tumble):
    text = report.as_text(tumble)
    assert "of motion + 1 regrasp x 100 m): the least possible on this lattice\n" in text
    assert "finger" in text
    k, row = tumble.weakest
    least = tumble.segments[k].stability[row]
    assert least == min(s.stability.min() for s in tumble.segments if s.name != "regrasp")
    assert f"stability z {least:.3g} N" in text
    assert f"every row withstands {tumble.withstands:.3g} N" in text
    assert f"up to {1e6 * tumble.place_tolerance:.3g} um out of place" in text
    assert tumble.withstands == min(s.withstands.min() for s in tumble.segments)
    assert tumble.place_tolerance == min(s.place_tolerance.min() for s in tumble.segments)
    assert len(text.splitlines()) < 10
    printed = report.as_dict(tumble)
    assert printed["cost"] == tumble.cost
    assert printed["segments"][1]["finger"] == tumble.segments[1].finger
    json.dumps(printed)


def test_plan_stands_alone_beside_its_mesh(tmp_path):
    import trimesh

    mesh = tmp_path / "a.stl"
    trimesh.creation.box([0.05, 0.10, 0.05]).export(mesh)
    (tmp_path / "task.yaml").write_text(changed("box: [0.05, 0.10, 0.05]", "mesh: {file: a.stl}"))
    plan = graspless.plan(tmp_path / "task.yaml")
    plan.save(tmp_path / "plan.json")
    (tmp_path / "task.yaml").unlink()
    assert graspless.check(tmp_path / "plan.json") == []
    trimesh.creation.box([0.05, 0.10, 0.06]).export(mesh)
    with pytest.raises(TaskError, match=r"a.stl: has changed since the plan was made"):
        graspless.load_plan(tmp_path / "plan.json")


LONG = changed("locations_per_side: 5", "locations_per_side: 13, search: dijkstra")


def test_another_thread_stops_a_search():
    task = read_task(changed("segments: 6", "segments: 200", LONG), "long.yaml")
    budget = planning.Budget(seconds=60)
    threading.Timer(0.3, budget.stop).start()
    start = time.monotonic()
    plan = graspless.plan(task, budget=budget)
    assert plan.status == "interrupted"
    assert time.monotonic() - start < 10
    assert plan.reason


def test_out_of_time_is_a_status():
    plan = graspless.plan(read_task(LONG, "long.yaml"), seconds=0.05)
    assert plan.status == "out_of_time"
    assert graspless.check(plan)


def _withstands_more(document):
    document["segments"][0]["withstands"][1] *= 1.001


def _withstands_more_in_all(document):
    document["withstands"] *= 1.001


def _other_forces(document):
    document["segments"][0]["nominal_forces"][1][0][0] *= 1.05


def _smoother_fingers(document):
    document["task"]["fingers"]["friction"] = 0.6


def _heavier(document):
    document["task"]["object"]["mass"] *= 1.5


def _softer(document):
    document["task"]["options"]["compliance"]["finger_tangential"] = 1e3


def _tighter(document):
    document["task"]["options"]["max_yield"] = 1e-6


@pytest.mark.parametrize(
    "change",
    [
        _withstands_more, _withstands_more_in_all, _other_forces, _smoother_fingers, _heavier,
        _softer, _tighter,
    ],
)  # fmt: skip
def test_check_sees_a_plan_that_withstands_less_than_it_says(tumble, change):
    assert graspless.check(tumble) == []
    document = json.loads(tumble.to_json())
    change(document)
    faults = graspless.check(read_plan(json.dumps(document), "changed"))
    assert any("withstands: " in fault and "promised" in fault for fault in faults), faults


BAR = """kind: fingertip
object: {{box: [0.10, 0.06, 0.02], mass: 0.2}}
fingers: {{radius: 0.005, start: {start}}}
friction: 0.2
obstacles: [{{name: bar, box: [0.002, 1.0, 0.004], pose: {{position: [{x}, 0, 0.023]}}}}]
motion: {motion}
"""
LATTICE = (
    "{lattice: {goal: {position: [0.2, 0, 0.01]}, lower: [0, -0.1, 0], upper: [0.25, 0.1, 0], "
    "counts: [6, 5, 1]}}"
)
SLIDE = "{slide: {translation: [0.2, 0, 0], segments: 4}}"


GIVEN = "[[0.0, 0.015, 0.01], [0.0, -0.015, 0.01]]"


@pytest.mark.parametrize("motion", [LATTICE, SLIDE])
@pytest.mark.parametrize(("start", "search"), [(GIVEN, "fast"), (GIVEN, "paper"), ("[]", "fast")])
def test_fingertips_do_not_pass_through_an_obstacle_between_poses(motion, start, search):
    solved = 0
    for x in (0.0333, 0.03, 0.07):
        task = read_task(BAR.format(x=x, motion=motion, start=start), "bar.yaml")
        plan = graspless.plan(task.with_options(search=search))
        if not plan:
            assert plan.status == fingertip.Status.unstable
            continue
        solved += 1
        assert graspless.check(plan) == []
        expect_clear_of_bar(plan, x)
    assert solved > 0


def expect_clear_of_bar(plan, x):
    """Looks at the fingertips of a plan that does not turn, far more often than it has rows."""
    radius, half = 0.005, np.array([0.001, 0.5, 0.002])
    for segment in plan.segments:
        centers = segment.fingers[0] - radius * segment.normals[0]  # in O
        for before, after in itertools.pairwise(segment.X_WO):
            for t in np.linspace(0, 1, 101):
                shift = before[:3, 3] + t * (after - before)[:3, 3]
                for center in centers:
                    away = np.abs(before[:3, :3] @ center + shift - [x, 0, 0.023]) - half
                    assert np.linalg.norm(np.maximum(away, 0)) > radius - 1e-4


def test_a_bar_in_the_way_of_given_fingers_leaves_no_plan():
    task = read_task(BAR.format(x=0.0333, motion=SLIDE, start=GIVEN), "bar.yaml")
    assert not graspless.plan(task.with_options(max_regrasps=0))


def test_an_obstacle_between_two_poses_of_a_path_is_named():
    text = BAR.format(x=0.05, motion="{slide: {translation: [1.0, 0, 0], segments: 1}}", start="[]")
    text = text.replace("[0.002, 1.0, 0.004]", "[0.005, 1, 1]")
    text = text.replace("position: [0.05,", "position: [0.33,")
    with pytest.raises(TaskError, match=r"touches .*bar.* on the way"):
        graspless.plan(read_task(text, "bar.yaml"))


def test_check_sees_an_obstacle_between_rows():
    free = read_task(BAR.format(x=0.9, motion=SLIDE, start=GIVEN), "free.yaml")
    plan = graspless.plan(free)
    assert plan
    assert graspless.check(plan) == []
    text = plan.to_json().replace("0.9,", "0.0333,", 1)
    faults = graspless.check(read_plan(text, "blocked.json"))
    assert any("obstacle 'bar'" in fault for fault in faults)


def test_a_goal_is_not_reached_through_an_obstacle():
    text = """kind: fingertip
object: {box: [0.10, 0.06, 0.02], mass: 0.2}
fingers: {radius: 0.005}
friction: 0.2
obstacles: [{name: slab, box: [0.005, 3, 1], pose: {position: [0.30, 0, 0]}}]
motion: {goal: {pose: {position: [0.9, 0, 0.01]}, slide_step: 0.9}}
"""
    plan = graspless.plan(read_task(text, "slab.yaml"))
    assert not plan
    assert "slab" in plan.reason
