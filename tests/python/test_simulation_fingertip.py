# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip plans in the physics engine, against laws and with what must make them fail."""

from __future__ import annotations

import copy
import re
from dataclasses import replace
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest

import graspless
from fingertip_common import ALONG_WALL
from graspless import _data, frames
from graspless.report import simulation as simulation_report
from graspless.simulation.fingertip import (
    FAILURES,
    MEASURES,
    SPREAD,
    breaking,
    carry_out,
    disturbed,
    judge,
    measure,
    run,
)
from graspless.simulation.fingertip.arm import ArmServo, arm_program, build_arm_world
from graspless.simulation.fingertip.breaking import disturb
from graspless.simulation.fingertip.disturbed import Disturbed
from graspless.simulation.fingertip.execute import contact_forces, hit_depth
from graspless.simulation.fingertip.passing import passing
from graspless.simulation.fingertip.program import way_round
from graspless.simulation.fingertip.world import build_world
from graspless.simulation.settings import Break, Fingertip
from graspless.simulation.variation import Variation
from graspless.tasks import read_task, task_from_dict
from graspless_bench.fingertip.grid import CASES
from graspless_bench.physics import fingertip_tasks

SLIDE = """\
kind: fingertip
object: {box: [0.05, 0.10, 0.05], mass: 1.0}
motion: {slide: {translation: [0.02, 0, 0], segments: 4}}
options: {locations_per_side: 5}
"""
LEANING = """\
kind: fingertip
object: {box: [0.05, 0.08, 0.03], mass: 0.5, com: [0.004, -0.006, 0.003]}
motion: {slide: {translation: [0.02, 0, 0]}}
"""


def _case(name):
    return graspless.plan(task_from_dict(fingertip_tasks.scaled(CASES[name]), name))


@pytest.fixture(scope="module")
def slide():
    return graspless.plan(read_task(SLIDE, "slide.yaml"))


@pytest.fixture(scope="module")
def tumble():
    """Case c of the paper, a unit of length a centimetre: a pinch on both sides."""
    return _case("c")


@pytest.fixture(scope="module")
def trial_of_tumble(tumble):
    return run(tumble, Variation(), record=True)


def _floating(X_WO):
    world = build_world(read_task(LEANING, "leaning.yaml").problem, Variation())
    world.model.opt.gravity[:] = 0
    world.place(X_WO, [[0, 0, 2], [0, 0, 3]])
    return world


@pytest.mark.parametrize("axis", range(3))
def test_a_force_accelerates_a_free_object_by_newton(axis):
    X_WO = frames.translation([0, 0, 1]) @ frames.from_rpy([0.3, -0.8, 1.9])
    world, thing = _floating(X_WO), read_task(LEANING, "leaning.yaml").problem.object
    force_O = 2.0 * np.eye(3)[axis]
    world.push(np.concatenate([force_O, np.zeros(3)]))
    mujoco.mj_step(world.model, world.data, 50)
    v = world.data.qvel[:3]  # of O, in the world; no torque about the centre of mass: no turning
    t = world.data.time
    np.testing.assert_allclose(v, X_WO[:3, :3] @ force_O * t / thing.mass, atol=1e-9)
    np.testing.assert_allclose(world.data.qvel[3:6], 0, atol=1e-9)


@pytest.mark.parametrize("axis", range(3))
def test_a_torque_turns_a_free_object_about_its_own_axes_by_euler(axis):
    X_WO = frames.translation([0, 0, 1]) @ frames.from_rpy([-1.1, 0.4, 0.7])
    world, thing = _floating(X_WO), read_task(LEANING, "leaning.yaml").problem.object
    torque_O = 1e-3 * np.eye(3)[axis]
    world.push(np.concatenate([np.zeros(3), torque_O]))
    steps = 20
    mujoco.mj_step(world.model, world.data, steps)
    omega_O = np.linalg.solve(thing.inertia, torque_O) * world.data.time
    np.testing.assert_allclose(world.data.qvel[3:6], omega_O, rtol=0.02, atol=1e-3)


def test_the_floor_bears_the_weight():
    world = _floating(frames.translation([0, 0, 0.015]))
    world.model.opt.gravity[2] = -9.8
    for _ in range(300):  # fingertips are weightless, and nothing tells them to move
        mujoco.mj_step(world.model, world.data)
    planes, fingers = contact_forces(world)
    assert planes == pytest.approx(0.5 * 9.8, rel=1e-3)
    assert not fingers.any()


def test_a_slide_and_a_tumble_go_as_planned(slide, trial_of_tumble):
    for trial in (run(slide, Variation()), trial_of_tumble):
        assert trial, trial.failures
        assert trial.measures.keys() == MEASURES.keys()
        assert trial.measures["vertex_error"] < 6e-4
        assert trial.measures["floor_lost"] == 0


def test_nominal_forces_are_what_the_fingers_press_with(slide):
    _, script, log = carry_out(slide, Variation())
    moves = np.array([script.names[k] == "slide" for k in script.stage[log.moments]])
    nominal = np.einsum(
        "ni,ni->n", slide.segments[0].nominal_forces[0], slide.segments[0].normals[0]
    )
    np.testing.assert_allclose(np.array(log.pressed)[moves].mean(axis=0), nominal, rtol=0.05)


def test_without_nominal_forces_the_pinch_slips(tumble, trial_of_tumble):
    seen = measure(*carry_out(tumble, Variation(), feeds=False))
    assert seen["vertex_error"] > 10 * trial_of_tumble.measures["vertex_error"]
    assert seen["vertex_error"] > 0.003


def test_planes_have_the_supports_friction_and_fingers_the_robots(tumble):
    problem, varied = tumble.task.problem, Variation(friction=0.9, support_friction=1.1)
    model = build_world(problem, varied).model
    planes = len(problem.planes)
    friction = 1.1 * np.mean(problem.friction)
    assert model.pair_friction[:planes, 0] == pytest.approx(friction)
    friction = 0.9 * np.mean(problem.fingers.friction)
    assert model.pair_friction[planes:, 0] == pytest.approx(friction)


def test_a_plane_has_its_own_friction():
    task = read_task(ALONG_WALL, "rail.yaml")
    model = build_world(task.problem, Variation(support_friction=1.1)).model
    assert model.pair_friction[:2, 0] == pytest.approx([1.1 * 0.5, 1.1 * 0.2])


def test_without_friction_the_pinch_fails(tumble):
    trial = run(tumble, Variation(friction=0.05))
    assert "off" in trial.failures
    assert set(trial.failures) <= FAILURES.keys()


def test_what_is_not_a_number_fails():
    measures = dict.fromkeys(MEASURES, 0.0)
    assert judge(measures) == ()
    assert judge(dict.fromkeys(MEASURES, np.nan)) == (
        "lost",
        "off",
        "hit",
        "slipped",
        "chatter",
    )


@pytest.mark.parametrize(
    ("measure", "limit", "failure"),
    [
        ("vertex_error", "tolerance", "off"),
        ("vertex_error", "lost", "lost"),
        ("slip", "slipped", "slipped"),
        ("floor_lost", "chatter", "chatter"),
    ],
)
def test_limits_are_those_of_the_settings(measure, limit, failure):
    for settings in (Fingertip(), replace(Fingertip(), **{limit: 0.0123})):
        most = getattr(settings, limit)
        nothing = dict.fromkeys(MEASURES, 0.0)
        assert failure not in judge(nothing | {measure: most}, settings)
        assert failure in judge(nothing | {measure: most * (1 + 1e-9)}, settings)
    between = dict.fromkeys(MEASURES, 0.0) | {"vertex_error": 0.00125}
    assert (judge(between), judge(between, varied=True)) == (("off",), ())


def test_a_post_in_the_way_is_hit(slide):
    """A plan that knows nothing of the post, in a world that has it."""
    tip, n = slide.segments[0].fingers[0, 0], slide.segments[0].normals[0, 0]
    at = slide.segments[0].X_WO[0][:3, 3] + tip - 2 * slide.task.problem.fingers.radius * n
    post = (
        f"obstacles: [{{name: post, box: [0.01, 0.01, 0.01], pose: {{position: {at.tolist()}}}}}]\n"
    )
    hitting = copy.copy(slide)
    hitting._task = read_task(SLIDE + post, "post.yaml")
    seen = measure(*carry_out(hitting, Variation()))
    assert seen["hit"] > 0
    assert "hit" in judge(seen)


def test_an_arm_pushes_with_no_more_than_its_motors_give():
    plan = graspless.plan(_data.directory("examples") / "12_t42_tumble.yaml")
    world = build_arm_world(plan, Variation())
    script = arm_program(plan, world.settings)
    script = script.at(np.arange(0, script.duration, 0.01))
    i = int(np.argmax(np.abs(script.forces).sum(axis=(1, 2))))
    world.stand(script.places[i], script.joints[i])
    given = {}
    for factor in (1, 1e4):
        ArmServo(world, replace(script, forces=factor * script.forces)).command(i)
        mujoco.mj_forward(world.model, world.data)
        given[factor] = (
            world.data.qfrc_actuator[world.joints] + world.data.qfrc_applied[world.joints]
        )
    assert np.abs(given[1]).max() > 0.1
    effort = plan.task.arm.robot.max_effort
    np.testing.assert_array_less(np.abs(given[1e4]), effort * (1 + 1e-9))
    assert np.isclose(np.abs(given[1e4]), effort).any()


def test_an_arm_in_a_plane_or_in_the_object_hits():
    task = graspless.load_task(_data.directory("examples") / "12_t42_tumble.yaml")
    plan = graspless.plan(task)
    world = build_arm_world(plan, Variation())
    place, q = np.array(frames.to_row(plan.segments[0].X_WO[0])), plan.task.arm.q_home
    world.stand(place, q)
    assert hit_depth(world) == 0
    elbow = world.data.xpos[world.model.body("wam_link_4").id]
    world.stand(np.array([*elbow, 1, 0, 0, 0]), q)
    assert hit_depth(world) > 0


def test_an_arm_stands_with_its_mimic_joints_where_they_follow_to(tmp_path):
    """MuJoCo has a joint for every finger, where the planner's robot has none for a follower."""
    names = "wam_t42_tips.urdf", "wam_t42_tips.srdf"
    urdf, srdf = ((_data.directory("urdf") / name).read_text() for name in names)
    before, after = urdf.split('<joint name="right_finger_joint" type="revolute">')
    follows = '<mimic joint="left_finger_joint" multiplier="0.5" offset="0.1"/></joint>'
    joint = '<joint name="right_finger_joint" type="revolute">'
    (tmp_path / names[0]).write_text(before + joint + after.replace("</joint>", follows, 1))
    (tmp_path / names[1]).write_text(re.sub('<joint name="right_finger_joint".*?/>', "", srdf))
    text = (_data.directory("examples") / "12_t42_tumble.yaml").read_text()
    task = read_task(text.replace("wam_t42_tips", str(tmp_path / names[0]), 1), "mimic.yaml")
    realization = SimpleNamespace(finger_of_fingertip=[0, 1])
    plan = SimpleNamespace(task=task, realization=realization)
    world = build_arm_world(plan, Variation())
    q = task.arm.q_home.copy()
    q[-1] = 0.2
    assert len(q) == 8
    world.stand(np.array([0.6, 0.0, 0.04, 1, 0, 0, 0]), q)
    robot = task.arm.robot
    for name, X_WF in zip(robot.frame_names, robot.forward(q), strict=True):
        np.testing.assert_allclose(world.data.body(name).xpos, X_WF[:3, 3], atol=1e-9, err_msg=name)
    np.testing.assert_array_equal(world.data.qvel, 0)


def test_trials_repeat_and_vary_what_they_say(slide):
    first, again = (graspless.simulate(slide, trials=2, seed=4) for _ in range(2))
    assert [t.measures for t in first.trials] == [t.measures for t in again.trials]
    nominal, varied = first.trials
    assert nominal.measures["vertex_error"] != varied.measures["vertex_error"]
    assert varied.variation.mass == 1
    assert np.hypot(varied.variation.x, varied.variation.y) <= SPREAD.position


def test_a_recording_has_the_object_and_the_fingers(tumble, trial_of_tumble):
    recording = trial_of_tumble.recording
    count = len(recording.times)
    assert recording.positions.shape == (count, 0)
    assert recording.object_poses.shape == (count, 4, 4)
    assert recording.fingers.shape == (count, 2, 3)
    assert {"touch", "load", "tumble", "rest"} == set(recording.names)
    turned = recording.object_poses[0][:3, :3].T @ recording.object_poses[-1][:3, :3]
    np.testing.assert_allclose(turned, frames.from_rpy([0, np.pi / 2, 0])[:3, :3], atol=5e-3)
    assert len(graspless.simulate(tumble).trials) == 1


def test_a_finger_that_regrasps_leaves_the_object_and_comes_to_its_new_place():
    plan = _case("d")
    finger = plan.segments[1].finger
    _, script, log = carry_out(plan, Variation())
    names = np.array([script.names[k] for k in script.stage[log.moments]])
    away = np.flatnonzero(names == "regrasp")
    pressed = np.array(log.pressed)
    assert not pressed[away[len(away) // 4 : -len(away) // 4], finger].any()
    assert pressed[away, 1 - finger].min() > 1.0
    assert pressed[names == "tumble"].min() > 0
    assert max(log.errors) < 1e-3


def test_a_way_round_stays_out_of_the_ball_between_its_ends():
    n, m = np.array([0.0, 0, -1]), np.array([1.0, 0, 0])
    way = way_round(np.array([0, 0, 0.06]), n, np.array([-0.04, 0, 0.01]), m, np.zeros(3), 0.1)
    np.testing.assert_allclose(np.linalg.norm(way[1:-1], axis=1), 0.1)
    np.testing.assert_allclose(way[1] - way[0], -n * np.linalg.norm(way[1] - way[0]), atol=1e-12)
    np.testing.assert_allclose(
        way[-2] - way[-1], -m * np.linalg.norm(way[-2] - way[-1]), atol=1e-12
    )


def test_small_disturbances_are_withstood_and_large_ones_break(tumble):
    row = 42
    z = tumble.segments[0].stability[row]
    found = disturb(tumble, (0, row))
    assert 0.3 * z < found["smallest"] < 3 * z
    assert found["ratio"] == found["smallest"] / z
    trial = Disturbed(tumble, tumble.segments[0], row, Break())
    wrench_O = trial.wrenches_O[found["direction"]]
    assert trial.breaks(1.05 * found["smallest"] * wrench_O, 1e-3)
    assert not trial.breaks(0.9 * found["smallest"] * wrench_O, 1e-3)
    assert not trial.breaks(np.zeros(6), 1e-3)
    assert found["lost"] >= found["smallest"]


def test_what_nothing_breaks_is_not_said_to_break(slide, monkeypatch):
    monkeypatch.setattr(Disturbed, "breaks", lambda *_: False)
    found = disturb(slide)
    assert found["direction"] == -1
    assert found["smallest"] is found["ratio"] is found["compliant_ratio"] is None
    assert found["tried"] == 3 * found["z"]
    text = simulation_report.as_text(graspless.simulate(slide), found)
    assert f"no disturbance up to {found['tried']:.3g} N moves the object" in text


@pytest.mark.parametrize(
    ("bent", "lost", "told"), [(1.00, 0.985, 1.00), (0.9, 1.5, 1.5), (0.0, 0.4, 0.4)]
)
def test_what_loses_the_object_is_no_less_than_what_bends_it(slide, monkeypatch, bent, lost, told):
    """Each is found to a fiftieth, from other factors: their order is a law all the same."""
    found = {Break().distance: (bent, 3), Break().lost_distance: (lost, 5)}

    class Fake:
        undisturbed = misplaced = 0.0

        def __init__(self, *_):
            pass

        def smallest(self, z, distance):
            return found[distance]

    monkeypatch.setattr(breaking, "Disturbed", Fake)
    broken = breaking.break_test(slide, (0, 0))
    assert (broken.smallest, broken.lost, broken.direction) == (bent, told, 3)


def test_a_motion_that_does_not_hold_breaks_at_nothing(tumble, monkeypatch):
    def slippery(problem, variation, settings, friction_at):
        return build_world(problem, Variation(friction=0.05), settings, friction_at=friction_at)

    monkeypatch.setattr(disturbed, "build_world", slippery)
    found = disturb(tumble)
    assert (found["smallest"], found["ratio"], found["direction"]) == (0, 0, -1)
    assert found["undisturbed"] > 1e-3
    assert "without any disturbance at the weakest" in simulation_report._disturbance(found)


def test_a_disturbance_of_a_plan_with_an_arm_says_that_fingertips_held(slide):
    found = graspless.simulate(slide)
    disturbed = {"segment": 0, "row": 1, "smallest": 1, "ratio": 0.5, "z": 2, "compliant": 2,
                 "withstands": 1}  # fmt: skip
    assert "bare fingertips" not in simulation_report.as_text(found, disturbed)
    plan = SimpleNamespace(kind="fingertip", joint_segments=[object()])
    of_arm = replace(found, plan=plan)
    assert "(with bare fingertips instead of the arm)" in simulation_report.as_text(
        of_arm, disturbed
    )


def test_a_finger_that_regrasps_is_off_the_object_while_it_is_disturbed():
    plan = _case("d")
    regrasp = plan.segments[1]
    script = passing(plan, regrasp, 0, Break())
    far = np.linalg.norm(script.centers - script.places[:, None, :3], axis=2)
    assert far[:, regrasp.finger].min() > 1
    assert far[:, 1 - regrasp.finger].max() < 1
    assert Disturbed(plan, regrasp, 0, Break()).undisturbed < 1e-3


def test_friction_known_as_an_interval_breaks_at_its_lower_end(monkeypatch):
    intervals = "friction: [0.4, 0.6]\nfingers: {friction: [0.5, 0.7]}\n"
    plan = graspless.plan(read_task(SLIDE + intervals, "slide.yaml"))
    worlds = []
    monkeypatch.setattr(
        disturbed, "build_world", lambda *a, **k: worlds.append(build_world(*a, **k)) or worlds[-1]
    )
    Disturbed(plan, plan.segments[0], 0, Break())
    np.testing.assert_allclose(worlds[0].model.pair_friction[:, 0], [0.4, 0.5, 0.5])
    middle = build_world(plan.task.problem, Variation())
    np.testing.assert_allclose(middle.model.pair_friction[:, 0], [0.5, 0.6, 0.6])


def test_a_row_that_is_not_there_is_refused(slide):
    with pytest.raises(graspless.TaskError, match=r"row: \(0, 99\): the plan has no such"):
        disturb(slide, (0, 99))


def test_bench_tasks_repeat_and_case_a_is_the_papers():
    few, many = (list(fingertip_tasks.physics_tasks(count)) for count in (5, 6))
    assert [task.to_dict() for task in few] == [task.to_dict() for task in many[:5]]
    assert graspless.plan(few[0]).cost == pytest.approx(10.016453262 * fingertip_tasks.UNIT)


def test_an_arm_carries_a_plan_out():
    plan = graspless.plan(_data.directory("examples") / "12_t42_tumble.yaml")
    trial = run(plan, Variation(), record=True)
    assert trial, trial.failures
    assert trial.measures["vertex_error"] < 6e-4
    recording = trial.recording
    assert recording.positions.shape == (len(recording.times), len(plan.joint_names))
    np.testing.assert_allclose(recording.positions[0], plan.task.arm.q_home, atol=1e-3)
    X_WO, X_WO_end = recording.object_poses[-1], plan.segments[-1].X_WO[-1]
    np.testing.assert_allclose(X_WO, X_WO_end, atol=2e-3)


def test_a_finger_reaches_into_a_notch():
    """In the corner of the bracket, inside of its hull: both walls are felt, by their normals."""
    world = build_world(
        graspless.load_task(_data.directory("examples") / "09_l_shape.yaml").problem, Variation()
    )
    at = 0.03 + world.radius - 1e-5  # the notch is x, y > 0.03
    X_WO = frames.translation([0, 0, 1])
    world.place(X_WO, [[at, at, 1.02], [5, 5, 5]])
    normals = {tuple(np.round(np.abs(contact.frame[:3]), 6)) for contact in world.data.contact}
    assert normals == {(1, 0, 0), (0, 1, 0)}
    world.place(X_WO, [[at + 1e-3, at + 1e-3, 1.02], [5, 5, 5]])
    assert world.data.ncon == 0
