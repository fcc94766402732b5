# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasps in the physics engine: what holds, what does not, and whether holes stay open."""

import copy
import dataclasses
import json
import re
from pathlib import Path
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
import trimesh
from scipy.spatial import Delaunay, cKDTree

import graspless
from clasp_common import PURSE, changed, purse_plan
from graspless import _data, clasp, geometry
from graspless.report import simulation as simulation_report
from graspless.simulation.clasp import FAILURES, MEASURES, _seeds, held_locked, run, surface
from graspless.simulation.clasp.closing import left_open
from graspless.simulation.clasp.execution import LOOK, Execution
from graspless.simulation.clasp.judge import Judge
from graspless.simulation.clasp.model import make_world
from graspless.simulation.results import Simulation, Trial, drained
from graspless.simulation.robots import set_positions
from graspless.simulation.settings import Clasp
from graspless.simulation.variation import Variation, variations
from graspless.tasks import read_task
from graspless_bench.physics.clasp_tasks import physics_tasks
from graspless_bench.physics.mutants import mutants
from graspless_bench.physics.mutants.clasp import close_partly, do_not_reach
from tasks_common import reread

SHORT = Clasp(sequences=2, seconds=0.6, pull_rate=80.0)


plan = pytest.fixture(scope="module")(purse_plan)


@pytest.fixture(scope="module")
def trial(plan):
    return run(plan, Variation(), record=True, settings=SHORT)


def test_a_plan_holds_and_its_open_hand_does_not(trial):
    assert trial.failures == ()
    assert trial.measures["held"] == trial.measures["sequences"] == SHORT.sequences
    assert trial.measures["open_held"] < SHORT.sequences
    assert trial.measures["pull"] > SHORT.pull_needed


def test_a_plan_of_one_finger_is_judged_by_that_finger(tmp_path):
    rng = np.random.default_rng(0)
    around, tube = rng.uniform(0, 2 * np.pi, (2, 2500))
    across = 0.0255 + 0.009 * np.cos(tube)
    eye = [across * np.cos(around), 1.5 * across * np.sin(around), 0.009 * np.sin(tube)]
    np.savetxt(tmp_path / "eye.xyz", np.transpose(eye))
    text = changed("sample: purse", "cloud: eye.xyz")
    text = changed("[0.62, 0.05, 0], rpy: [0,", "[0.62, 0.05, 0.25], rpy: [1.5708,", text)
    text = changed("seconds: 20, seed: 3", "iterations: 200, seed: 1", text)
    (tmp_path / "eye.yaml").write_text(text)
    plan = graspless.plan(tmp_path / "eye.yaml")
    assert plan, plan.reason
    assert len(plan.fingers) == 1
    trial = run(plan, Variation(), settings=SHORT)
    assert trial.failures == ()
    assert trial.measures["linking"] > 0.5


def test_the_hand_opens_to_the_pre_shape_of_the_plan(tmp_path):
    urdf = _data.directory("urdf")
    joints = "".join(
        f'<joint name="{finger}_{part}_joint" value="{value}"/>'
        for finger in ("finger_1", "finger_2", "thumb")
        for part, value in (("proximal", -0.05), ("distal", 1.42))
    )
    fist = f'<group_state name="fist" group="hand">{joints}</group_state></robot>'
    srdf = (urdf / "kr5_sdh.srdf").read_text().replace("</robot>", fist)
    (tmp_path / "mine.srdf").write_text(srdf)
    hand = (urdf / "kr5_sdh.clasp.yaml").read_text()
    (tmp_path / "mine.yaml").write_text(changed("open: open ", "open: [fist, open] ", hand))
    text = changed("{urdf: kr5_sdh}", "{urdf: kr5_sdh, srdf: mine.srdf}\nhand: mine.yaml")
    (tmp_path / "purse.yaml").write_text(text)
    plan = graspless.plan(tmp_path / "purse.yaml")
    assert plan, plan.reason
    assert plan.pre_shape == "open"
    trial = run(plan, Variation(), settings=SHORT)
    assert trial.failures == ()
    assert trial.measures["open_held"] < SHORT.sequences


def test_measures_and_failures_are_those_that_are_explained(trial):
    assert set(trial.measures) == set(MEASURES)
    assert set(trial.failures) <= set(FAILURES)


def test_what_is_asked_of_a_pull_is_said():
    page = (Path(__file__).parents[2] / "docs" / "simulate.md").read_text()
    told = next(line for line in page.splitlines() if line.startswith("| `pulled_out`"))
    needed, most = (f"{force:g}" for force in (Clasp().pull_needed, Clasp().pull_most))
    assert f"below {needed} N" in told
    assert f"to {most} N" in told
    assert FAILURES["pulled_out"].endswith(f"below {needed} N")
    assert f"at most {most} N" in MEASURES["pull"]


def test_the_limit_of_a_hand_of_two_fingers_is_told(plan, monkeypatch):
    found = Simulation(plan, 0, [Trial(Variation(), ("pulled_out",), {}, 0.0)])
    assert "under a straight pull below 15 N" in simulation_report.as_text(found)
    limit = dataclasses.replace(Clasp(), pull_needed=0.4905)
    monkeypatch.setattr("graspless.simulation.clasp._settings", lambda plan: limit)
    assert "under a straight pull below 0.49 N" in simulation_report.as_text(found)


def pulled_free(plan, mass, needed, is_lost=True):
    """The pull under which an object that nothing touches leaves the hand, if it is lost then."""
    world = make_world(plan.task, Variation(), Clasp(pull_needed=needed))
    world.let_go()
    world.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    world.model.body_inertia[world.body] *= mass / world.model.body_mass[world.body]
    world.model.body_mass[world.body] = mass
    begin = world.object_pose[:3, 3]
    judge = SimpleNamespace(
        reach=lambda: 0.13,
        linked=lambda: 1,
        distance=lambda: is_lost * np.linalg.norm(world.object_pose[:3, 3] - begin),
    )
    execution = Execution(world, judge, plan.task.problem.hand, plan.task.problem.robot, None)
    return execution.pull(np.array([1.0, 0.0, 0.0]))


@pytest.mark.parametrize("mass", [0.02, 0.2, 1.0])
def test_an_object_that_nothing_holds_is_pulled_out_below_its_weight(plan, mass):
    needed = 9.81 * mass
    assert 0.5 * needed < pulled_free(plan, mass, needed) < needed


def test_a_pull_goes_on_until_what_is_needed(plan):
    assert pulled_free(plan, 1.0, 80.0, is_lost=False) == 80


def test_the_hand_goes_through_the_hole_as_planned(trial):
    # The parts of the purse leave its hole open, or the fingers would have pushed it away.
    assert trial.measures["moved_before"] < 1e-4
    assert trial.measures["linking"] > 0.5


def test_the_solid_purse_is_held_as_its_skin_is(plan, trial):
    solid = run(plan, Variation(), settings=SHORT, solids=clasp.sample_object("purse"))
    assert solid.failures == ()
    # Cloud and solid are a fraction of the cloud's spacing apart, and so is where it ends.
    names = ("moved_before", "linking", "held")
    for name in names:
        assert solid.measures[name] == pytest.approx(trial.measures[name], abs=0.02), name


def test_contacts_have_the_friction_that_is_asked_for(plan):
    world = make_world(plan.task, Variation(friction=1.2, support_friction=0.8), Clasp())
    stand = world.model.pair_friction[:, 0]
    assert stand == pytest.approx(0.8 * Clasp().stand_friction)
    robot = plan.task.problem.robot
    set_positions(world.model, world.data, robot, plan.segments[-1].positions[-1])
    world.data.qpos[-7:-4] += [0.0, 0.0, -0.03]  # onto a finger
    mujoco.mj_forward(world.model, world.data)
    contacts = [c for c in world.data.contact if min(c.geom) < 0]
    assert contacts
    for contact in contacts:
        assert contact.friction[0] == pytest.approx(1.2 * Clasp().friction)


def _without_closing(document):
    """The hand as far open as its state says, all the way."""
    joints = document["joint_names"]
    for segment in document["segments"]:
        for row in segment["positions"]:
            for i, name in enumerate(joints):
                if "proximal" in name:
                    row[i] = -1.0
                if "distal" in name:
                    row[i] = 1.0


@pytest.mark.parametrize(
    ("change", "settings", "failures"),
    [
        (_without_closing, dataclasses.replace(SHORT, grip_seconds=0.0), {"escaped"}),
    ],
)
def test_a_plan_that_was_spoilt_fails(plan, tmp_path, change, settings, failures):
    document = json.loads(plan.to_json())
    change(document)
    spoilt = reread(document, tmp_path / "plan.json")
    assert failures <= set(run(spoilt, Variation(), settings=settings).failures)


@pytest.mark.parametrize("share", [0.0, 0.5, 0.75])
def test_a_plan_that_leaves_closing_to_the_executor_fails(plan, tmp_path, share):
    document = json.loads(plan.to_json())
    close_partly(share)(document)
    short = dataclasses.replace(SHORT, sequences=1, seconds=0.1)
    trial = run(reread(document, tmp_path / "plan.json"), Variation(), settings=short)
    assert trial.failures[0] == "not_closed"
    assert trial.measures["linking"] > 0  # the trial closes the hand all the same


def test_a_plan_that_closes_until_contact_leaves_nothing(plan):
    assert left_open(plan, Clasp()) == 0
    solid = clasp.sample_object("purse")  # its surface is a fraction of the cloud's spacing away
    assert left_open(plan, Clasp(), solid) < Clasp().left


def test_what_is_left_open_is_the_joint_that_was_opened(plan, tmp_path):
    """A joint that opens by some steps can close by as many, or by one more until it touches."""
    document = json.loads(plan.to_json())
    joint = document["joint_names"].index("finger_1_proximal_joint")
    end = document["segments"][-1]["positions"][-1]
    for opened in (0.05, 0.1, 0.15):
        end[joint] = plan.segments[-1].positions[-1][joint] - opened
        left = left_open(reread(document, tmp_path / "plan.json"), Clasp())
        assert opened - 0.011 < left < opened + 0.011
    end[joint] -= 0.5
    assert left_open(reread(document, tmp_path / "plan.json"), Clasp()) == Clasp().left_most


def test_a_plan_whose_handle_was_cut_is_refused(plan, tmp_path):
    document = json.loads(plan.to_json())
    (cut,) = (mutant for mutant in mutants("clasp") if mutant.name == "cut handle")
    spoilt = reread(cut.of(document), tmp_path / "plan.json")
    assert spoilt.task.problem.object.loops.found == []
    assert graspless.check(spoilt) == ["plan: loop 0 is not one of the object's 0"]
    with pytest.raises(ValueError, match="^loop 0 of the plan is not one of the object's 0$"):
        run(spoilt, Variation(), settings=SHORT)


def test_a_hand_that_never_had_the_loop_did_not_lose_it(plan, tmp_path):
    document = json.loads(plan.to_json())
    do_not_reach(document)
    trial = run(reread(document, tmp_path / "plan.json"), Variation(), record=True, settings=SHORT)
    assert trial.failures == ("not_closed",)
    assert not {"held", "pull", "open_held"} & set(trial.measures)
    assert set(trial.recording.names) == {"settle", "reach", "close", "grip"}


@pytest.mark.parametrize("shape", ["box: [0.06, 0.06, 0.06]", "mesh: {file: cube.stl}"])
def test_an_obstacle_that_the_plan_does_not_know_is_hit(plan, shape, tmp_path):
    """Across the way of the wrist; the same away from it changes nothing."""
    trimesh.creation.box((0.06, 0.06, 0.06)).export(tmp_path / "cube.stl")
    shape = shape.replace("cube.stl", str(tmp_path / "cube.stl"))
    reach = plan.segments[0].positions
    robot, hand = plan.task.problem.robot, plan.task.problem.hand
    place = np.asarray(robot.pose(hand.frame, reach[len(reach) // 2]))[:3, 3]
    found = {}
    for name, at in {"in the way": place, "aside": place + [0, 3.0, 0]}.items():
        post = f"{{name: post, {shape}, pose: {{position: {at.tolist()}}}}}"
        there = copy.copy(plan)
        there._task = read_task(f"{PURSE}obstacles: [{post}]\n", "post.yaml")
        settings = dataclasses.replace(SHORT, sequences=1, seconds=0.2)
        found[name] = run(there, Variation(), settings=settings)
    assert found["aside"].failures == ()
    assert found["aside"].touched is None
    hit = found["in the way"]
    assert "hit" in hit.failures
    assert not {"escaped", "forced_open", "pulled_out"} & set(hit.failures)
    assert hit.touched[0] == "post"
    assert hit.touched[1] in robot.frame_names
    text = simulation_report.as_text(Simulation(plan, 0, [hit]))
    assert f"touched an obstacle (post and {hit.touched[1]})" in text


def test_an_object_in_the_way_is_hit(plan):
    aside = Variation(x=-0.02, y=0.04, yaw=0.5)
    trial = run(plan, aside, settings=dataclasses.replace(SHORT, sequences=1))
    assert "hit" in trial.failures
    assert trial.measures["moved_before"] > SHORT.hit
    text = simulation_report.as_text(Simulation(plan, 0, [trial]))
    assert re.search(r"touched an obstacle \(the object moved by up to \d+ mm\)", text)


def test_a_locked_hand_holds_where_it_is_closed(plan):
    robot, hand = plan.task.problem.robot, plan.task.problem.hand
    closed = np.array(plan.segments[-1].positions[-1])
    opened = closed.copy()
    joints = robot.group(hand.hand)
    opened[joints] += 0.6 * (np.asarray(robot.state(hand.open)) - closed)[joints]
    held, linking = held_locked(plan, closed, [[1, 2]])
    assert held
    assert linking == pytest.approx(plan.segments[-1].virtual_linking[-1].min(), abs=1e-6)
    lost, less = held_locked(plan, opened, [[1, 2]])
    assert not lost
    assert less < linking


def test_nothing_yields_in_a_locked_hand(plan, monkeypatch):
    closed = np.array(plan.segments[-1].positions[-1])
    joints = plan.task.problem.robot.group(plan.task.problem.hand.hand)
    moved, yielded = [], []

    def run(execution, _):
        world = execution.world
        for _ in range(execution._steps):
            mujoco.mj_step(world.model, world.data)
            yielded.append(-world.data.contact.dist.min(initial=0.0))
        moved.append(np.abs(world.positions - closed)[joints].max())

    monkeypatch.setattr(Execution, "run", run)
    assert held_locked(plan, closed, [[1, 2], [1, 7]])[0]
    assert max(moved) < 1e-5
    assert 1e-5 < max(yielded) < 2e-3
    assert np.quantile(yielded, 0.995) < 1e-3  # 1.4 mm with steps twice as long


def test_the_same_again(plan, trial):
    again = run(plan, Variation(), settings=SHORT)
    assert again.measures == trial.measures
    assert again.recording is None


def test_no_two_trials_share_their_wrenches(plan, tmp_path):
    document = json.loads(plan.to_json())
    same = reread(document, tmp_path / "plan.json")
    document["segments"][-1]["positions"][-1][0] += 1e-6
    other = reread(document, tmp_path / "plan.json")
    drawn = variations(3, 1)
    seeds = [tuple(seed) for p in (plan, other) for v in drawn for seed in _seeds(p, v, 10)]
    assert len(set(seeds)) == len(seeds) == 60
    assert _seeds(same, drawn[1], 10) == _seeds(plan, drawn[1], 10)


def test_recording_has_a_row_a_moment(plan, trial):
    recording = trial.recording
    rows = len(recording.times)
    assert recording.positions.shape == (rows, len(plan.joint_names))
    assert recording.object_poses.shape == (rows, 4, 4)
    assert recording.fingers.shape == (rows, 0, 3)
    assert len(recording.names) == rows
    np.testing.assert_allclose(np.diff(recording.times), recording.times[1])
    order = list(dict.fromkeys(recording.names))
    assert order == ["settle", "reach", "close", "grip", "shake", "pull"]
    np.testing.assert_allclose(recording.positions[0], plan.segments[0].positions[0], atol=1e-6)


def test_the_object_stands_where_the_variation_says(plan):
    variation = Variation(x=0.002, y=-0.001, yaw=0.03, mass=1.2)
    world = make_world(plan.task, variation, Clasp())
    X_WO = np.asarray(plan.task.problem.X_WO)
    np.testing.assert_allclose(world.object_pose[:3, 3] - X_WO[:3, 3], [0.002, -0.001, 0])
    turned = world.object_pose[:3, :3] @ X_WO[:3, :3].T
    assert np.arctan2(turned[1, 0], turned[0, 0]) == pytest.approx(0.03)
    assert world.model.body_mass[world.body] == pytest.approx(1.2 * Clasp().mass)


def test_the_object_rests_and_then_is_free(plan):
    world = make_world(plan.task, Variation(), Clasp())
    start = world.object_pose
    mujoco.mj_step(world.model, world.data, nstep=100)
    assert np.abs(world.object_pose - start).max() < 5e-4
    world.let_go()
    start, moment = world.object_pose, world.data.time
    world.data.xfrc_applied[world.body, :3] = [0, 0, -2.0]  # into the floor that was there
    mujoco.mj_step(world.model, world.data, nstep=100)
    fallen = 0.5 * 2.0 / Clasp().mass * (world.data.time - moment) ** 2
    np.testing.assert_allclose((world.object_pose - start)[:3, 3], [0, 0, -fallen], atol=1e-3)


def test_a_task_may_say_the_mass():
    task = read_task(changed("sample: purse", "sample: purse\n  mass: 2.5"), "purse.yaml")
    world = make_world(task, Variation(), Clasp())
    assert world.model.body_mass[world.body] == pytest.approx(2.5)


@pytest.mark.parametrize("name", clasp.sample_object_names())
def test_skin_is_the_boundary_of_the_complex(name):
    points = geometry.sample_surface(clasp.sample_object(name), 800)
    # Four points in a plane are a tetrahedron to one triangulation and none to the other.
    points = points + np.random.default_rng(1).normal(scale=5e-4, size=points.shape)
    found = geometry.shortest_loops(points).complex
    # By another triangulation: a face of two tetrahedra of K_d is inside.
    d = found.max_edge_length
    faces = {}
    for corners in Delaunay(points).simplices:
        if np.linalg.norm(points[corners][:, None] - points[corners], axis=2).max() < d:
            for left_out in range(4):
                face = tuple(sorted(int(c) for c in np.delete(corners, left_out)))
                faces[face] = faces.get(face, 0) + 1
    all_ = {tuple(int(i) for i in triangle) for triangle in found.triangles}
    inside = {face for face, count in faces.items() if count == 2}
    skin = {tuple(int(i) for i in triangle) for triangle in surface.skin(found)}
    assert skin == all_ - inside
    assert inside  # the test can fail


@pytest.mark.parametrize("name", clasp.sample_object_names())
def test_skin_is_near_the_solid_that_the_cloud_was_taken_from(name):
    shapes = clasp.sample_object(name)
    found = geometry.shortest_loops(geometry.sample_surface(shapes, 2000)).complex
    corners = np.asarray(found.points)[surface.skin(found)]
    random = np.random.default_rng(2)
    weights = random.dirichlet(np.ones(3), size=60)
    on_skin = np.einsum("wk,tkx->twx", weights, corners).reshape(-1, 3)
    elsewhere = geometry.sample_surface(shapes, 1500, 7)
    far = cKDTree(on_skin).query(elsewhere)[0]
    assert np.quantile(far, 0.99) < 0.45 * geometry.spacing(found.points)
    assert far.max() < geometry.spacing(found.points)


def test_feet_are_where_a_box_stands():
    side = np.linspace(-1, 1, 9)
    cube = np.stack(np.meshgrid(side, side, side), axis=-1).reshape(-1, 3)
    cube = cube[np.abs(cube).max(axis=1) == 1]
    corners = surface.feet(cube + [0.3, 0.1, 5], 0.01)
    np.testing.assert_allclose(corners[:, 2], 4)
    assert geometry.Polygon(corners[:, :2]).area == pytest.approx(4)
    heavy = np.concatenate([cube, np.full((4000, 3), [5.0, 0, 0])])
    assert surface.feet(heavy, 0.01) is None  # it would topple
    needle = np.concatenate([cube, [[0, 0, -3.0]]])
    assert surface.feet(needle, 0.01) is None


def test_inertia_is_that_of_a_hollow_sphere():
    random = np.random.default_rng(0).normal(size=(20000, 3))
    shell = 0.2 * random / np.linalg.norm(random, axis=1)[:, None]
    np.testing.assert_allclose(
        surface.inertia(shell + [1, 2, 3]), 2 / 3 * 0.2**2 * np.eye(3), atol=5e-4
    )


def test_tasks_of_the_bench_are_its_own():
    tasks = list(physics_tasks(2))
    assert len(tasks) == 2
    from graspless_bench.clasp.grid import paper

    for task, trial in zip(tasks, paper(1), strict=False):
        theirs = trial.make_problem()
        np.testing.assert_allclose(task.problem.X_WO, theirs.X_WO)
        np.testing.assert_allclose(task.problem.q_start, theirs.q_start)
        np.testing.assert_array_equal(
            task.problem.object.loops.complex.points, theirs.object.loops.complex.points
        )


def _execution(plan):
    problem, settings = plan.task.problem, Clasp()
    world = make_world(plan.task, Variation(), settings)
    judge = Judge(problem.hand, world, problem.object.loops.found[plan.loop].points)
    return Execution(world, judge, problem.hand, problem.robot, None)


def _energies(execution, seconds):
    """[J] of the free object, pulled at from rest, at each look."""
    model, data = execution.world.model, execution.world.data
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data.xfrc_applied[execution.world.body] = [Clasp().force, 0, 0, 0, 0, 0]
    for _ in range(round(seconds / LOOK)):
        execution.run("shake")
        yield float(data.energy[1])


def test_drag_takes_the_momentum_that_a_free_object_gathers(plan):
    settings = Clasp()
    execution = _execution(plan)
    execution.world.let_go()
    execution.world.data.qpos[-7:-4] += [0, 0, 10]  # nothing is there
    mujoco.mj_forward(execution.world.model, execution.world.data)
    start = execution.save()
    with execution.dragged():
        slow = list(_energies(execution, 0.4))
    # That of the speed at which drag alone bears the force, and of turning into its direction.
    assert 0.05 < max(slow) < 4 * 0.5 * settings.mass * settings.drag_speed**2
    execution.set_back(start)
    free = list(_energies(execution, 0.4))
    assert free[-1] == pytest.approx(0.5 * (settings.force * 0.4) ** 2 / settings.mass, rel=0.05)


def test_the_open_hand_loses_a_dragged_object_and_the_closed_one_does_not(plan):
    execution = _execution(plan)
    drained(execution.settle(Clasp().lead))
    drained(execution.follow(graspless.time(plan)))
    drained(execution.grip())
    execution.world.let_go()
    closed = execution.save()
    with execution.dragged():
        assert execution.shake(np.random.default_rng(1))
        execution.set_back(closed)
        execution.open()
        assert not execution.shake(np.random.default_rng(1))
