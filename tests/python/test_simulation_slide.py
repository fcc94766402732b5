# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slides in MuJoCo: laws that the engine's model must keep, and controls that must fail."""

from __future__ import annotations

import copy
import dataclasses
import itertools
import re

import mujoco
import numpy as np
import pytest
import yaml

import graspless
from graspless import _data, frames, geometry, slide
from graspless.errors import TaskError
from graspless.simulation import chain, pinch
from graspless.simulation.robots import apply
from graspless.simulation.settings import Slide, Solver
from graspless.simulation.slide import FAILURES, MEASURES
from graspless.simulation.slide.conditions import CONDITIONS, draw
from graspless.simulation.slide.execution import Execution, overhang
from graspless.simulation.slide.fingers import PAD, WRIST, rub
from graspless.simulation.slide.kick import Kick
from graspless.simulation.slide.lift import straight_lift
from graspless.simulation.slide.program import make_program
from graspless.simulation.slide.scene import HAND, OBJECT, build_scene
from graspless.simulation.slide.shapes import even_points, plate_inertia, points_along
from graspless.simulation.slide.truth import Body, Truth
from graspless.simulation.variation import Variation
from graspless.tasks import Task

CARD = _data.directory("examples") / "01_slide_card.yaml"


@pytest.fixture(scope="module")
def plan():
    found = graspless.plan(CARD)
    assert found
    return found


@pytest.fixture(scope="module")
def nominal(plan):
    return graspless.simulate(plan, record=True).trials[0]


def changed(plan, **fields):
    """The same motion for a problem with other fields: what the planner did not know."""
    problem = plan.task.problem
    given = {
        name: getattr(problem, name)
        for name in ("robot", "hand", "object", "support", "X_WO_start", "q_home", "obstacles")
    }
    task, other = plan.task, copy.copy(plan)
    problem = type(problem)(**given | fields)
    other._task = Task(problem, task.options, task.budget, fields=task.fields)
    return other


def test_a_card_is_slid_and_lifted(nominal):
    assert nominal
    assert nominal.measures["position_error"] < 0.005
    assert nominal.measures["angle_error"] < np.radians(5)
    assert nominal.measures["lift_height"] > 0.09
    assert set(nominal.measures) == set(MEASURES)


def test_an_object_that_slides_down_a_slope_has_not_fallen():
    plan = graspless.plan(_data.directory("examples") / "03_tilted_l_table.yaml")
    execution = Execution(plan, Variation(), Slide())
    judge, data, X_WO = execution.judge, execution.data, execution.scene.X_WO
    normal = plan.task.problem.support.normal_W
    down = np.array([0, 0, -1]) + normal[2] * normal
    for way, height, failures in ((0.3, -0.01, []), (0, -0.03, ["fell"])):
        at = X_WO[:3, 3] + way * down / np.linalg.norm(down) + height * normal
        data.xpos[execution.scene.model.body(OBJECT).id] = at
        data.xmat[execution.scene.model.body(OBJECT).id] = X_WO[:3, :3].ravel()
        judge.look(data, "approach")
        assert judge.failures == failures


@pytest.mark.parametrize("model", ["impedance", "rigid_guarded"])
def test_a_rigid_finger_slides_and_lifts_too(model):
    document = yaml.safe_load(CARD.read_text())
    document["hand"] = {"finger_model": model, "wrist_stiffness": 600}
    plan = graspless.plan(document)
    assert graspless.check(plan) == []
    measures = graspless.simulate(plan).trials[0].measures
    assert measures["position_error"] < 0.003
    assert measures["angle_error"] < np.radians(2)
    assert measures["lift_height"] > 0.09
    force = plan.task.problem.hand.press_force
    assert 0.8 * force < measures["mean_force"] < 1.5 * force


def test_a_finger_that_holds_a_force_does_not_pull_the_arm_to_the_object():
    document = yaml.safe_load(CARD.read_text())
    document["hand"] = {"finger_model": "rigid_guarded"}
    execution = Execution(graspless.plan(document), Variation(), Slide())
    judge, data, given_way = execution.judge, execution.data, []
    for phase in execution.steps("press"):
        if phase == "press" and judge.tip_force(data) == 0:
            given_way.append(
                max(abs(float(data.joint(f"{WRIST}{axis}").qpos[0])) for axis in "xyz")
            )
    assert len(given_way) > 100  # steps in the air
    assert max(given_way) < 0.005
    assert judge.tip_force(data) > 0


PAD_LINK = """<link name="left_pad">
  <collision><origin xyz="0 0 0.085"/><geometry><box size="0.02 0.006 0.03"/></geometry></collision>
</link>
<joint name="left_pad_mount" type="fixed"><parent link="left_finger"/><child link="left_pad"/></joint>
"""


def test_a_pad_without_mass_belongs_to_the_finger_that_carries_it(tmp_path):
    """As in the URDF of a Robotiq 2F-85."""
    for part in (".urdf", ".srdf", ".hand.yaml"):
        text = (_data.directory("urdf") / f"wam_t42{part}").read_text()
        text = text.replace(
            '<link name="left_fingertip">', f'{PAD_LINK}<link name="left_fingertip">'
        )
        text = text.replace(
            '<parent link="left_finger"/><child link="left_fingertip"/>',
            '<parent link="left_pad"/><child link="left_fingertip"/>',
        )
        (tmp_path / f"mine{part}").write_text(
            text.replace("[left_finger", "[left_finger, left_pad")
        )
    document = yaml.safe_load(CARD.read_text())
    document["robot"] = {"urdf": str(tmp_path / "mine.urdf")}
    document["hand"] = {"finger_model": "rigid_guarded"}
    plan = graspless.plan(document)
    trial = graspless.simulate(plan).trials[0]
    assert trial.measures["position_error"] < 0.003
    assert trial.measures["lift_height"] > 0.09


def test_a_wrist_that_sags_under_the_object_has_lifted_it():
    document = yaml.safe_load((_data.directory("examples") / "25_pinch_box.yaml").read_text())
    document["hand"], document["object"]["mass"] = {"finger_model": "rigid_guarded"}, 0.5
    trial = pinch.run(graspless.plan(document), Variation(), settings=Slide(guarded_stiffness=300))
    assert trial.failures == ()
    assert trial.measures["lift_height"] < Slide().kept_height


@pytest.fixture(scope="module")
def pinched():
    """A chain of a pinch, by an arm that holds a force, and of a lift by 10 cm."""
    document = yaml.safe_load((_data.directory("examples") / "25_pinch_box.yaml").read_text())
    lift = {"name": "lift", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.1}}
    grasp = {"name": "pinch", "kind": "pinch", "hand": {"finger_model": "rigid_guarded"}}
    document |= {"kind": "chain", "stages": [grasp, lift]}
    document["object"]["mass"] = 0.5
    return graspless.plan(document)


def test_what_a_wrist_leaves_standing_is_not_lifted(pinched):
    """The spring gives way by 12 cm under its weight, and the hand rises by 10 cm."""
    settings = Slide(guarded_stiffness=40)
    for trial in (
        pinch.run(pinched.stages[0], Variation(), settings=settings),
        chain.run(pinched, Variation(), settings=settings),
    ):
        assert trial.failures == ("dropped",)
    assert trial.measures["carried"] < 0.001
    assert trial.measures["lifted"] == 0


def test_a_wrist_that_sags_under_the_object_has_carried_it(pinched):
    trial = chain.run(pinched, Variation(), settings=Slide(guarded_stiffness=100))
    assert trial.failures == ()
    assert (trial.measures["kept"], trial.measures["lifted"]) == (1, 1)
    assert trial.measures["carry_error"] == pytest.approx(0.5 * 9.81 / 100, abs=0.002)


def test_a_link_without_inertia_is_named(tmp_path):
    for part in (".urdf", ".srdf", ".hand.yaml"):
        text = (_data.directory("urdf") / f"wam_t42{part}").read_text()
        (tmp_path / f"mine{part}").write_text(re.sub(r"<inertia [^>]*/>", "", text, count=1))
    document = yaml.safe_load(CARD.read_text())
    document["robot"] = {"urdf": str(tmp_path / "mine.urdf")}
    with pytest.warns(UserWarning, match="without mass or inertia, which planning ignores"):
        plan = graspless.plan(document)
    with pytest.raises(TaskError, match="its <inertial> has no inertia; the simulation needs it"):
        graspless.simulate(plan)


def test_the_recording_has_a_row_of_everything_a_moment(plan, nominal):
    recording = nominal.recording
    n = len(recording.times)
    assert np.all(np.diff(recording.times) > 0)
    assert recording.positions.shape == (n, len(plan.joint_names))
    assert recording.object_poses.shape == (n, 4, 4)
    assert recording.fingers.shape == (n, 0, 3)
    assert len(recording.names) == n
    assert list(dict.fromkeys(recording.names)) == [
        *(segment.name for segment in plan.segments), "squeeze", "raise", "hold"
    ]  # fmt: skip
    rise = recording.object_poses[-1, 2, 3] - recording.object_poses[0, 2, 3]
    assert rise == pytest.approx(nominal.measures["lift_height"], abs=0.005)


def test_the_same_trial_gives_the_same_bits(plan, nominal):
    again = Execution(plan, Variation(), Slide())
    again.run("slide")
    for name in ("position_error", "angle_error", "mean_force"):
        assert again.measures[name] == nominal.measures[name]


def test_an_object_at_rest_stays_and_weighs_what_it_weighs(plan):
    execution = Execution(plan, Variation(mass=1.2), Slide())
    execution.run("approach")
    model, data = execution.scene.model, execution.data
    moved = execution.judge.pose(data)[:3, 3] - plan.task.problem.X_WO_start[:3, 3]
    assert np.abs(moved).max() < 2e-4
    assert np.abs(data.joint("object").qvel).max() < 1e-4
    force, lifting = np.zeros(6), 0.0
    for i in range(data.ncon):
        mujoco.mj_contactForce(model, data, i, force)
        lifting += force[0]
    weight = 1.2 * plan.task.problem.object.mass * 9.81
    assert lifting == pytest.approx(weight, rel=1e-3)


def test_a_pressed_finger_bends_by_the_depth_of_its_tip(plan):
    execution = Execution(plan, Variation(), Slide())
    execution.run("press")
    data, problem = execution.data, plan.task.problem
    tip = data.body(problem.hand.fingertip)
    pitch = np.arcsin(-tip.xmat.reshape(3, 3)[2, 2])
    # The pad's centre is lowered no further than its radius above the object's top.
    top = problem.object.thickness + problem.support.X_WS[2, 3]
    L, r = problem.hand.flexure_length, problem.hand.tip_radius
    hinge = tip.xpos[2] + L * np.sin(pitch)
    bent = np.arcsin((hinge - top - r) / (L - r))
    angle = abs(float(data.joint("sliding finger").qpos[0]))
    assert angle == pytest.approx(pitch - bent, abs=0.02)
    force = execution.judge.tip_force(data)
    assert force * (L - r) * np.cos(bent) == pytest.approx(4.6 * angle, rel=0.35)  # and friction


def test_variations_reach_the_model(plan):
    plain = build_scene(plan, Variation()).model
    varied = Variation(
        friction=0.7, support_friction=1.3, mass=1.2, x=0.003, yaw=0.02, timestep=1.25
    )
    scene = build_scene(plan, varied)
    model = scene.model
    assert model.opt.timestep == pytest.approx(1.25 * plain.opt.timestep)
    assert model.body("object").mass == pytest.approx(1.2 * plain.body("object").mass)
    assert model.body("object").inertia == pytest.approx(1.2 * plain.body("object").inertia)
    for pair in range(model.npair):
        geoms = model.pair_geom1[pair], model.pair_geom2[pair]
        factor = 0.7 if any(model.geom(g).name.startswith(PAD) for g in geoms) else 1.3
        assert model.pair_friction[pair, :2] == pytest.approx(
            factor * plain.pair_friction[pair, :2]
        )
    X_OO = np.linalg.inv(plan.task.problem.X_WO_start) @ scene.X_WO
    assert np.linalg.norm(X_OO[:3, 3]) == pytest.approx(0.003)
    assert np.arctan2(X_OO[1, 0], X_OO[0, 0]) == pytest.approx(0.02)


def test_shape_place_and_flexures_vary_too(plan):
    plain = build_scene(plan, Variation())
    varied = Variation(
        thickness=1.2, table=0.003, com_x=0.004, com_y=-0.002, flexure_length=0.9,
        flexure_stiffness=1.2,
    )  # fmt: skip
    scene = build_scene(plan, varied)
    model, first = scene.model, plain.model
    lifted = scene.X_WO[:3, 3] - plain.X_WO[:3, 3]
    assert lifted == pytest.approx([0, 0, 0.003], abs=1e-12)
    assert model.body("table").pos - first.body("table").pos == pytest.approx([0, 0, 0.003])
    assert model.geom("object0").size[2] == pytest.approx(1.2 * first.geom("object0").size[2])
    com = model.body("object").ipos - first.body("object").ipos
    assert com == pytest.approx([0.004, -0.002, 0.1 * plan.task.problem.object.thickness])
    for finger in ("sliding finger", "other finger"):
        stiffness = [m.jnt_stiffness[m.joint(finger).id] for m in (model, first)]
        assert stiffness[0] == pytest.approx(1.2 * stiffness[1])
    # The flexure is nearer to the tip, which is where it was.
    L = plan.task.problem.hand.flexure_length
    moved = model.body("sliding finger").pos - first.body("sliding finger").pos
    assert np.linalg.norm(moved) == pytest.approx(0.1 * L)
    pads = [m.geom("pad2").pos[2] for m in (model, first)]
    assert pads[0] - pads[1] == pytest.approx(-0.1 * L)


class Listed:
    """Commands of a program, with everything that was asked."""

    def __init__(self, program):
        self.program, self.asked = program, []
        self.raised, self.start, self.X_WO_goal = program.raised, program.start, program.X_WO_goal

    def command(self, step, senses):
        self.asked.append((step, senses.positions(), senses.object_pose()))
        return self.program.command(step)


def test_any_controller_is_asked_step_by_step(plan, nominal):
    """With the commands of the fixed program, the trial is that of the fixed program."""
    made = []

    def control(timestep):
        program = make_program(plan, graspless.time(plan), timestep, Slide())
        made.append(Listed(program))
        return made[0]

    execution = Execution(plan, Variation(), Slide(), control=control)
    execution.run("slide")
    assert execution.measures["position_error"] == nominal.measures["position_error"]
    steps, joints, poses = zip(*made[0].asked, strict=True)
    assert steps == tuple(range(len(steps)))
    assert joints[0] == pytest.approx(plan.segments[0].positions[0])
    assert poses[0] == pytest.approx(np.array(plan.task.problem.X_WO_start))
    assert made[0].program.command(len(made[0].program.phase)) is None


def test_a_kick_moves_the_object_once_half_way(plan):
    kicked = Variation(kick_x=0.006, kick_y=-0.008, kick_yaw=0.15)
    execution = Execution(plan, kicked, Slide())
    execution.run("slide")
    assert execution.measures["position_error"] == pytest.approx(0.010, abs=0.004)
    assert execution.measures["angle_error"] == pytest.approx(0.15, abs=0.05)
    scene, data, kick = execution.scene, execution.data, Kick(kicked)
    qpos = data.joint("object").qpos
    start, goal = scene.X_WO[:3, 3], plan.X_WO_goal[:3, 3]
    for share, jumps in ((0.0, False), (0.49, False), (0.51, True), (0.6, False)):
        qpos[:3] = before = start + share * (goal - start)
        kick.watch(scene, data, plan.X_WO_goal)
        assert np.linalg.norm(qpos[:3] - before) == pytest.approx(0.01 * jumps)


def test_the_pose_is_judged_on_the_support_where_it_is(plan):
    execution = Execution(plan, Variation(table=0.003), Slide())
    execution.run("press")
    execution.data.joint("object").qpos[:3] = plan.X_WO_goal[:3, 3] + [0, 0, 0.003]
    execution.data.joint("object").qpos[3:] = frames.to_quaternion(plan.X_WO_goal)
    mujoco.mj_kinematics(execution.scene.model, execution.data)
    execution._measure_slide()
    assert execution.measures["position_error"] < 1e-9


@pytest.mark.parametrize("condition", CONDITIONS)
def test_a_condition_is_one_difference_of_full_size(plan, condition):
    drawn = [draw(condition, plan, np.random.default_rng([4, k])) for k in range(200)]
    of = {
        "none": (),
        "friction": ("friction", "support_friction"),
        "start": ("x", "y", "yaw"),
        "kick": ("kick_x", "kick_y", "kick_yaw"),
    }.get(condition, (condition,))
    nominal = Variation().as_dict()
    for variation in drawn:
        differs = {name for name, value in variation.as_dict().items() if value != nominal[name]}
        assert differs == set(of)
    values = {name: np.array([getattr(v, name) for v in drawn]) for name in of}
    if condition == "friction":
        assert all(0.4 <= v.min() < 0.45 and 1.55 < v.max() <= 1.6 for v in values.values())
    elif len(of) == 3:
        assert np.hypot(values[of[0]], values[of[1]]) == pytest.approx(np.full(200, 0.01))
        assert set(np.degrees(values[of[2]]).round(9)) == {-10, 10}
    elif of:
        thickness = plan.task.problem.object.thickness
        full = {"mass": {0.5, 2}, "table": {-0.003, 0.003}}
        full["thickness"] = {round(1 + s * 0.001 / thickness, 9) for s in (-1, 1)}
        assert set(values[condition].round(9)) == full[condition]


def test_conditions_that_are_none(plan):
    with pytest.raises(TaskError, match="condition: wind: should be one of none, friction"):
        graspless.simulate(plan, condition="wind")
    thin = slide.Object.from_polygon("card", plan.task.problem.object.outline, 0.001)
    with pytest.raises(TaskError, match="the object has 1 mm: should be more than 1 mm"):
        draw("thickness", changed(plan, object=thin), np.random.default_rng(1))


def test_a_slippery_pad_leaves_the_object_behind(plan):
    hand = plan.task.problem.hand
    hand.pad_friction = 0.5 * plan.task.problem.support.friction
    execution = Execution(changed(plan, hand=hand), Variation(), Slide())
    execution.run("slide")
    assert "off_target" in execution.judge.failures
    goal, start = plan.X_WO_goal[:3, 3], plan.task.problem.X_WO_start[:3, 3]
    # The finger runs over the object for its own length at least.
    assert execution.measures["position_error"] > 0.3 * np.linalg.norm(goal - start)


def test_another_goal_than_the_plans_is_missed(plan):
    other, X_WO = copy.copy(plan), plan.X_WO_goal.copy()
    X_WO[0, 3] += 0.02
    other.X_WO_goal = X_WO
    execution = Execution(other, Variation(), Slide())
    execution.run("slide")
    assert execution.judge.failures == ["off_target"]
    assert execution.measures["position_error"] == pytest.approx(0.02, abs=0.005)


def test_a_plan_without_its_slide_is_off_target(plan):
    other = copy.copy(plan)
    touching = ("press", "slide", "lift")
    other.segments = [segment for segment in plan.segments if segment.name not in touching]
    execution = Execution(other, Variation(), Slide())
    execution.run("close")
    assert "off_target" in execution.judge.failures
    assert execution.measures["position_error"] > 0.3


def test_an_object_over_the_edge_falls(plan):
    execution = Execution(plan, Variation(x=-0.32), Slide())
    execution.run("press")
    assert "fell" in execution.judge.failures
    assert "position_error" not in execution.measures


def test_a_box_stands_on_the_obstacle_where_it_is_put_down():
    plan = graspless.plan(_data.directory("examples") / "26_pinch_then_place.yaml")
    trial = graspless.simulate(plan).trials[0]
    assert (trial.failures, trial.touched) == ((), None)
    assert trial.measures["place_error"] < 0.01


@pytest.mark.parametrize("name", ["post", "neighbour", "pad", "table top"])
def test_what_stands_in_the_way_is_hit(plan, name):
    """Whatever its name is."""
    X_WO = np.array(plan.segments[2].object_poses[len(plan.segments[2]) // 2])
    box = geometry.PlacedShape(geometry.Box(np.array([0.02, 0.02, 0.04])))
    obstacle = graspless.slide.Obstacle(name, [box], frames.translation(X_WO[:3, 3]))
    execution = Execution(changed(plan, obstacles=[obstacle]), Variation(), Slide())
    execution.run("slide")
    assert "hit" in execution.judge.failures
    assert execution.judge.touched[0] == name
    assert execution.judge.touched[1] in ["object", *plan.task.problem.robot.frame_names]
    assert set(FAILURES) >= set(execution.judge.failures)


def block(size, mass, p):
    """A box, as a body with its middle at p."""
    corners = np.array(size) / 2 * np.array(list(itertools.product((-1, 1), repeat=3)))
    squares = np.square(size)
    return Body([corners + p], mass, np.array(p), np.diag(mass / 12 * (squares.sum() - squares)))


def true_world(plan, *others):
    """The card of a plan as a body, and others on its table."""
    thing = plan.task.problem.object
    low, high = (f(np.array(thing.outline.vertices), axis=0) for f in (np.min, np.max))
    size = [*(high - low), thing.thickness]
    return Truth(block(size, thing.mass, [*(low + high) / 2, thing.thickness / 2]), others)


def test_a_body_beside_the_object_can_be_knocked_over(plan):
    """What stands on the table replaces the obstacles, and stays where nothing touches it."""
    poses = np.array(plan.segments[2].object_poses)
    middle, first, last = poses[len(poses) // 2, :3, 3], poses[0, :3, 3], poses[-1, :3, 3]
    along = (last - first) / np.linalg.norm(last - first)
    aside = np.cross(along, [0, 0, 1])
    for off, failures in ((0.0, ["knocked"]), (0.15, [])):
        post = block([0.02, 0.02, 0.1], 0.05, middle + off * aside + [0, 0, 0.05])
        execution = Execution(plan, Variation(), Slide(), truth=true_world(plan, post))
        execution.run("slide")
        assert [name for name in execution.judge.failures if name != "off_target"] == failures


def test_a_palm_that_touches_the_object_before_the_grasp_is_told(plan):
    """A part of the true object is where the palm comes when the finger presses."""
    problem, slid = plan.task.problem, plan.segments[2]
    X_WP = np.array(problem.robot.pose(problem.robot.frame("hand_base"), slid.positions[0]))
    X_OP = np.linalg.inv(slid.object_poses[0]) @ X_WP
    truth = true_world(plan)
    part = block([0.01, 0.01, 0.01], 0.1, X_OP[:3, 3]).parts
    body = dataclasses.replace(truth.object, parts=[*truth.object.parts, *part])
    execution = Execution(plan, Variation(), Slide(), truth=Truth(body))
    execution.run("press")
    assert "touched" in execution.judge.failures
    assert "hand_base" in execution.judge.touched


@pytest.mark.parametrize(
    ("phase", "failures"),
    [("slide", ["touched"]), ("retreat", ["touched"]), ("grasp", []), ("close", []), ("hold", [])],
)
def test_the_palm_may_touch_the_object_only_where_the_hand_grasps(plan, phase, failures):
    execution = Execution(plan, Variation(), Slide(), truth=true_world(plan))
    judge, groups = execution.judge, execution.scene.groups
    kinds = judge._kind[[groups[HAND][:1], groups[OBJECT][:1]]]
    judge._kinds = lambda _: kinds
    judge._note_contact = lambda data, index, failure: judge.note(failure)
    mujoco.mj_forward(execution.scene.model, execution.data)
    judge.look(execution.data, phase)
    assert judge.failures == failures


def test_a_true_card_is_slid_and_lifted(plan):
    execution = Execution(plan, Variation(), Slide(), truth=true_world(plan))
    execution.run()
    assert set(execution.judge.failures) <= {"off_target"}
    assert execution.measures["lifted"] == 1


def test_the_lift_is_straight_and_as_high_as_asked(plan):
    problem = plan.task.problem
    q = plan.segments[-1].positions[-1]
    path, raised = straight_lift(plan, q, 0.1)
    assert raised == pytest.approx(0.1)
    poses = np.array([problem.robot.pose(problem.hand.grasp_frame, row) for row in path])
    assert poses[-1, 2, 3] - poses[0, 2, 3] == pytest.approx(0.1, abs=1e-6)
    poses[:, 2, 3] = poses[0, 2, 3]
    assert poses == pytest.approx(np.broadcast_to(poses[0], poses.shape), abs=1e-6)


def test_an_arm_that_cannot_rise_does_not_drop_the_object(plan, monkeypatch):
    short = "graspless.simulation.slide.program.straight_lift"
    monkeypatch.setattr(short, lambda plan, q, height: straight_lift(plan, q, height / 2))
    trial = graspless.simulate(plan).trials[0]
    assert trial.failures == ("out_of_reach",)
    assert trial.measures["lift_reach"] == pytest.approx(0.05)


def test_the_lift_ends_below_an_obstacle_that_the_plan_knows(plan):
    q, problem = plan.segments[-1].positions[-1], plan.task.problem
    above = problem.robot.pose("hand_base", q)[:3, 3]
    box = geometry.PlacedShape(geometry.Box(np.array([0.1, 0.1, 0.02])))

    def lifted(height):
        roof = slide.Obstacle("roof", [box], frames.translation(above + [0.0, 0.0, height]))
        return straight_lift(changed(plan, obstacles=[roof]), q, 0.1)

    assert lifted(1.0)[1] == pytest.approx(0.1)
    path, raised = lifted(0.12)
    assert 0.02 < raised < 0.09
    assert problem.robot.pose("hand_base", path[-1])[2, 3] - above[2] == pytest.approx(raised)
    assert lifted(0.01)[1] == pytest.approx(0.1)  # it touches there from the beginning


def test_overhang_is_how_far_the_outline_is_outside(plan):
    problem = plan.task.problem
    assert overhang(plan, np.array(problem.X_WO_start)) == 0
    assert overhang(plan, plan.X_WO_goal) == pytest.approx(plan.overhang, abs=0.008)


def test_the_inertia_of_a_plate():
    a, b, t, m = 0.12, 0.08, 0.003, 0.05
    outline = geometry.Polygon(np.array([[0, 0], [a, 0], [a, b], [0, b]]) + [0.3, -0.2])
    expected = m / 12 * np.diag([b**2 + t**2, a**2 + t**2, a**2 + b**2])
    assert plate_inertia(outline, t, m) == pytest.approx(expected)
    angles = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    disc = geometry.Polygon(0.05 * np.column_stack([np.cos(angles), np.sin(angles)]))
    assert plate_inertia(disc, t, m)[2, 2] == pytest.approx(m * 0.05**2 / 2, rel=1e-3)


@pytest.mark.parametrize("name", ["square", "circle", "triangle", "crescent", "irregular"])
def test_feet_resist_turning_as_an_even_pressure_does(name):
    from graspless_bench.slide.shapes import outline_of

    outline = geometry.Polygon(outline_of(name))
    feet, dense = even_points(outline, 60), even_points(outline, 4000)
    assert 45 <= len(feet) <= 75
    radius = [np.linalg.norm(p - dense.mean(axis=0), axis=1).mean() for p in (feet, dense)]
    assert radius[0] == pytest.approx(radius[1], rel=0.05)
    rim = points_along(outline, 0.01)
    assert np.linalg.norm(np.diff(rim, axis=0), axis=1).max() < 0.01 + 1e-9


@pytest.mark.parametrize("factor", [1.0, 1.2])
def test_an_object_with_heights_is_as_high_as_these(plan, factor):
    card = plan.task.problem.object
    low, high = card.outline.vertices.min(axis=0), card.outline.vertices.max(axis=0)
    cell = (high - low).max() / 12
    heights = np.random.default_rng(1).uniform(0.3, 1, (12, 12)) * card.thickness
    heights[3:5, 4:6] = 0
    thing = card.with_heights(geometry.HeightMap(low, cell, heights))
    model = build_scene(changed(plan, object=thing), Variation(thickness=factor)).model
    boxes = [
        (model.geom_pos[i], model.geom_size[i])
        for i in range(model.ngeom)
        if re.fullmatch(r"object\d+", model.geom(i).name)
    ]
    for (i, j), height in np.ndenumerate(heights):
        at = low + cell * (np.array([i, j]) + 0.5)
        tops = [p[2] + s[2] for p, s in boxes if (np.abs(at - p[:2]) < s[:2]).all()]
        assert len(tops) == (height > 0)
        if tops:
            assert -1e-9 <= tops[0] / factor - height <= 5e-4 + 1e-9


@pytest.mark.parametrize(("force", "most"), [(8.0, 0.0006), (250.0, 0.002)])
def test_fingers_do_not_sink_into_a_light_object_that_they_press(plan, force, most):
    """Where they do, contacts turn to other faces, and a strong hand loses what it pinches."""
    settings = Slide()
    spec = mujoco.MjSpec()
    apply(spec, dataclasses.replace(Solver(), impratio=settings.impratio))
    spec.option.gravity = [0, 0, 0]
    for side in (-1, 1):
        inertia = {"mass": 0.2, "inertia": [1e-4] * 3, "explicitinertial": True}
        body = spec.worldbody.add_body(pos=[0.02 * side, 0, 0], **inertia)
        slides = mujoco.mjtJoint.mjJNT_SLIDE
        body.add_joint(type=slides, axis=[-side, 0, 0], damping=[20, 0, 0], armature=1.0)
        geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[0.01, 0.01, 0.01])
        geom.condim, geom.priority = 6, 1
        rub(geom, plan.task.problem.hand, settings)
    spoon = spec.worldbody.add_body(mass=0.04, inertia=[1e-5] * 3, explicitinertial=True)
    spoon.add_freejoint()
    spoon.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[0.01, 0.05, 0.007])
    model = spec.compile()
    data = mujoco.MjData(model)
    data.qfrc_applied[:2] = force
    mujoco.mj_step(model, data, nstep=500)
    assert 0 < -data.contact.dist.min() < most
