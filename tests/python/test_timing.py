# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans in time keep every limit, go through their rows, and rest where contacts change."""

import copy
import json
import pickle
import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import graspless
from graspless import TaskError, fingertip, robot, slide
from graspless.errors import install_command
from graspless.robot import Robot
from graspless.timing import rates, settings
from graspless.timing import slide as slide_timing
from tasks_common import reread
from timing_common import planned, timed

ARMS = ["slide", "clasp", "carried"]
BARE = ["push", "tumble", "regrasp"]
SLOW = {"press", "slide", "lift", "grasp", "close", "touch", "release", "tumble"}


def of_segments(trajectory):
    """Each segment with its moments."""
    for i, segment in enumerate(trajectory.segments):
        mine = np.flatnonzero(trajectory.segment_index == i)
        assert len(mine)
        yield segment, slice(mine[0], mine[-1] + 1)


def arm_of(plan):
    return plan.task.arm.robot if plan.kind == "fingertip" else plan.task.problem.robot


@pytest.mark.parametrize("name", ARMS + BARE)
def test_time_runs_through_every_segment_in_order(name):
    trajectory = timed(name)
    assert trajectory.times[0] == 0
    assert (np.diff(trajectory.times) > 0).all()
    assert (np.diff(trajectory.segment_index) >= 0).all()
    for segment, mine in of_segments(trajectory):
        rows = trajectory.rows[mine]
        assert (np.diff(rows) >= 0).all()
        if name in ARMS:
            assert rows[-1] == len(segment) - 1
            assert rows[0] < 1 or len(rows) == 1  # one moment where nothing moves
            np.testing.assert_allclose(
                trajectory.positions[mine][-1], segment.positions[-1], atol=settings.TOLERANCE
            )


@pytest.mark.parametrize("name", ["slide", "clasp", "carried", "push"])
def test_trajectory_survives_a_pickle(name):
    trajectory = timed(name)
    again = pickle.loads(pickle.dumps(trajectory))
    assert again.plan == trajectory.plan
    assert [(type(s), s.name) for s in again.segments] == [
        (type(s), s.name) for s in trajectory.segments
    ]
    for what in ("times", "segment_index", "rows", "positions", "velocities", "object_poses"):
        np.testing.assert_array_equal(getattr(again, what), getattr(trajectory, what))
    assert again.joint_names == trajectory.joint_names
    assert copy.deepcopy(trajectory).names == trajectory.names


def test_trajectory_equals_itself_alone():
    trajectory = timed("push")
    assert trajectory in {trajectory}
    assert trajectory != trajectory.at(trajectory.times)


@pytest.mark.parametrize("times", [[], float("nan"), [[0.0, 1.0]], "now", [[1], [2, 3]], [{}]])
def test_trajectory_at_no_times(times):
    with pytest.raises(TaskError, match="times: .*should be one or more finite numbers"):
        timed("push").at(times)


def near_contact(plan, segment, positions):
    """Moments [N] of a slow segment in which something touches, or is about to."""
    if segment.name in ("press", "lift"):
        problem = plan.task.problem
        tips = np.array([problem.robot.pose(problem.hand.fingertip, q)[:3, 3] for q in positions])
        X_WS = problem.support.X_WS
        height = (tips - X_WS[:3, 3]) @ X_WS[:3, 2] - problem.object.thickness
        return height < settings.GUARD
    if segment.name == "close":
        arm = arm_of(plan)
        reach = np.array([arm.reach(frame) for frame in arm.frame_names])
        left = (np.abs(positions - positions[-1]) @ reach.T).max(axis=1)
        return left < settings.GUARD
    return np.ones(len(positions), dtype=bool)


@pytest.mark.parametrize("name", ARMS)
def test_limits_are_kept_and_reached(name):
    trajectory = timed(name)
    top = np.asarray(arm_of(planned(name)).max_velocity)
    speeds, accelerations = np.abs(trajectory.velocities), np.abs(trajectory.accelerations)
    assert (speeds <= top * (1 + 1e-6)).all()
    assert accelerations.max() <= settings.ACCELERATION[0] * (1 + 1e-6)
    assert (speeds > 0.9 * top).any() or accelerations.max() > 0.9 * settings.ACCELERATION[0]
    for segment, mine in of_segments(trajectory):
        if segment.name in SLOW:
            near = near_contact(planned(name), segment, trajectory.positions[mine])
            most = settings.CONTACT_SHARE * settings.ACCELERATION[0]
            assert accelerations[mine][near].max() <= most * (1 + 1e-6), segment.name


@pytest.mark.parametrize("name", ARMS)
def test_given_limits_are_kept(name):
    joint = planned(name).joint_names[1]
    trajectory = timed_with(name, max_velocity={joint: 0.1}, max_acceleration=1.5)
    assert np.abs(trajectory.velocities[:, 1]).max() <= 0.1 * (1 + 1e-6)
    assert np.abs(trajectory.velocities).max() > 0.1
    assert np.abs(trajectory.accelerations).max() <= 1.5 * (1 + 1e-6)


def timed_with(name, **settings):
    return graspless.time(planned(name), **settings)


@pytest.mark.parametrize("name", ARMS)
def test_velocities_and_accelerations_are_those_of_the_positions(name):
    trajectory = timed(name, rate=1000.0)
    for _, mine in of_segments(trajectory):
        t, q = trajectory.times[mine], trajectory.positions[mine]
        v, a = trajectory.velocities[mine], trajectory.accelerations[mine]
        dt = np.diff(t)[:, None]
        if len(t) < 3:
            continue
        np.testing.assert_allclose(np.diff(q, axis=0) / dt, (v[1:] + v[:-1]) / 2, atol=3e-3)
        # Accelerations jump, so the two agree on the whole and not at every moment.
        off = np.abs(np.diff(v, axis=0) - dt * (a[1:] + a[:-1]) / 2).sum()
        assert off <= 0.03 * (np.abs(a[1:]) * dt).sum()


@pytest.mark.parametrize(
    ("name", "through"),
    [("slide", {"approach", "lift", "reach"}), ("clasp", {"reach"}), ("carried", set())],
)
def test_joints_rest_where_contacts_change_and_nowhere_else(name, through):
    trajectory = timed(name)
    np.testing.assert_allclose(trajectory.velocities[0], 0, atol=1e-6)
    for segment, mine in of_segments(trajectory):
        end = np.abs(trajectory.velocities[mine][-1]).max()
        assert (end > 1e-3) == (segment.name in through), segment.name
        if segment.name not in through:
            assert end <= 1e-6


@pytest.mark.parametrize("name", ARMS)
def test_jerks_are_bounded_during_contact_and_elsewhere(name):
    trajectory = timed(name, rate=1000.0)
    steps = np.abs(np.diff(trajectory.accelerations, axis=0)).max(axis=1)
    jerks = steps / np.diff(trajectory.times)
    most = settings.JERK * settings.ACCELERATION[0]
    assert jerks.max() <= most * (1 + 1e-6)
    assert jerks.max() > 0.4 * most
    slides = np.array([name == "slide" for name in trajectory.names])
    inside = slides[1:] & slides[:-1]
    if inside.any():
        assert jerks[inside].max() <= settings.CONTACT_SHARE * most * (1 + 1e-6)
    gentle = timed_with(name, max_jerk=10.0)
    assert gentle.duration > trajectory.duration
    steps = np.abs(np.diff(gentle.accelerations, axis=0)).max(axis=1)
    assert (steps <= 10.0 * np.diff(gentle.times) * (1 + 1e-6)).all()


@pytest.mark.parametrize("name", ARMS)
def test_joints_stay_near_the_rows(name):
    trajectory = timed(name, rate=400.0)
    for segment, mine in of_segments(trajectory):
        most = np.full(len(trajectory.rows[mine]), settings.TOLERANCE)
        if segment.name in SLOW:
            near = near_contact(planned(name), segment, trajectory.positions[mine])
            most[near] = settings.CONTACT_TOLERANCE
        row = np.arange(len(segment))
        for joint, values in enumerate(segment.positions.T):
            on_rows = np.interp(trajectory.rows[mine], row, values)
            off = np.abs(trajectory.positions[mine][:, joint] - on_rows)
            assert (off <= most + 1e-12).all(), segment.name


@pytest.mark.parametrize("name", ["slide", "clasp"])
def test_greater_limits_are_never_slower(name):
    arm = arm_of(planned(name))
    half = dict(zip(arm.joint_names, 0.5 * np.asarray(arm.max_velocity), strict=True))
    slow = timed_with(name, max_velocity=half, max_acceleration=2.5, contact_speed=0.02)
    for faster in (
        {"max_velocity": half, "max_acceleration": 5.0, "contact_speed": 0.02},
        {"max_acceleration": 2.5, "contact_speed": 0.02},
        {"max_velocity": half, "max_acceleration": 2.5, "contact_speed": 0.04},
    ):
        assert timed_with(name, **faster).duration <= 1.01 * slow.duration  # bounds are sampled
    # Twice the speeds, four times the accelerations and eight times the jerks: half the time.
    fast = {"max_acceleration": 10.0, "max_jerk": 400.0, "contact_speed": 0.04}
    slow = {"max_acceleration": 2.5, "max_jerk": 50.0, "contact_speed": 0.02}
    twice = timed_with(name, **fast, pause=1e-6)
    once = timed_with(name, **slow, max_velocity=half, pause=1e-6)
    assert twice.duration == pytest.approx(once.duration / 2, rel=1e-3)


@pytest.mark.parametrize(
    ("name", "speed", "frames_of"),
    [
        ("slide", 0.05, {"press": ["left_fingertip"], "slide": ["left_fingertip"],
                         "lift": ["left_fingertip"], "grasp": ["grasp"],
                         "close": ["left_fingertip", "right_fingertip"]}),
        ("slide", 0.01, {"slide": ["left_fingertip"]}),
        ("carried", 0.02, dict.fromkeys(["touch", "release"],
                                        ["left_tip_center", "right_tip_center"])),
    ],
)  # fmt: skip
def test_what_touches_is_slow(name, speed, frames_of):
    plan = planned(name)
    trajectory = timed(name) if speed != 0.01 else timed(name, contact_speed=0.01)
    fastest = {}
    for segment, mine in of_segments(trajectory):
        for frame in frames_of.get(segment.name, []):
            moved = [
                np.linalg.norm(arm_of(plan).jacobian(frame, q)[:3] @ v)
                for q, v in zip(
                    trajectory.positions[mine], trajectory.velocities[mine], strict=True
                )
            ]
            near = near_contact(plan, segment, trajectory.positions[mine])
            fastest[segment.name] = max(np.array(moved)[near])
            assert fastest[segment.name] <= speed * (1 + 1e-6), segment.name
    assert set(fastest) == set(frames_of)
    assert max(fastest.values()) > 0.95 * speed


def test_a_closing_hand_is_slow():
    arm, trajectory = arm_of(planned("clasp")), timed("clasp")
    close = next(mine for segment, mine in of_segments(trajectory) if segment.name == "close")
    forward = [arm.forward(q)[:, :3, 3] for q in trajectory.positions[close]]
    speeds = np.linalg.norm(np.diff(forward, axis=0), axis=2).max(axis=1)
    speeds /= np.diff(trajectory.times[close])
    segment = next(segment for segment in planned("clasp").segments if segment.name == "close")
    near = near_contact(planned("clasp"), segment, trajectory.positions[close])
    assert speeds[near[1:] & near[:-1]].max() <= settings.CONTACT_SPEED * (1 + 1e-6)
    assert np.diff(near.astype(int)).min() >= 0  # near to the end


def object_motion(plan, trajectory, mine):
    """Speeds and accelerations of the centre of mass, and angular ones, by differences."""
    X, t = trajectory.object_poses[mine], trajectory.times[mine]
    dt = np.diff(t)[:, None]
    com = X[:, :3, :3] @ plan.task.problem.object.com + X[:, :3, 3]
    turns = Rotation.from_matrix(X[1:, :3, :3] @ X[:-1, :3, :3].transpose(0, 2, 1)).as_rotvec()
    v, w = np.diff(com, axis=0) / dt, turns / dt
    return v, w, np.diff(v, axis=0) / dt[1:], np.diff(w, axis=0) / dt[1:]


@pytest.mark.parametrize("name", [*BARE, "carried"])
def test_inertia_is_small_against_stability(name):
    plan, trajectory = planned(name), timed(name, rate=1000.0)
    body, seen = plan.task.problem.object, 0
    k = np.sqrt(np.linalg.eigvalsh(body.inertia).max() / body.mass)
    for i, (segment, mine) in enumerate(of_segments(trajectory)):
        number = getattr(segment, "plan_segment", i)
        if number < 0 or segment.name not in ("slide", "turn", "tumble"):
            continue
        v, w, a, alpha = object_motion(plan, trajectory, mine)
        force = body.mass * (np.linalg.norm(a, axis=1) + k * np.linalg.norm(alpha, axis=1))
        allowed = settings.STABILITY_SHARE * plan.segments[number].stability.min()
        assert force.max() <= allowed * (1 + 1e-3)
        assert force.max() >= allowed / 4  # and no slower than it must be
        speed = np.linalg.norm(v, axis=1)
        assert speed.max() <= settings.FINGERTIP_SPEED * (1 + 1e-3)
        assert np.linalg.norm(w, axis=1).max() <= settings.TUMBLE_SPEED * (1 + 1e-3)
        seen += 1
    assert seen


@pytest.mark.parametrize("name", BARE)
def test_bare_fingertips_move_no_joints_and_the_object_all_the_way(name):
    trajectory = timed(name)
    assert trajectory.joint_names == []
    assert trajectory.positions.shape == (len(trajectory), 0)
    for segment, mine in of_segments(trajectory):
        rows, poses = trajectory.rows[mine], trajectory.object_poses[mine]
        np.testing.assert_allclose(poses[[0, -1]], segment.X_WO[[0, -1]], atol=1e-9)
        ends = (0, 1) if segment.name == "regrasp" else (-0.5, len(segment) - 0.5)
        np.testing.assert_allclose(rows[[0, -1]], ends)
        nearest = np.rint(rows).astype(int).clip(0, len(segment) - 1)
        off = np.linalg.norm(poses[:, :3, 3] - segment.object_poses[nearest][:, :3, 3], axis=1)
        steps = np.linalg.norm(np.diff(segment.object_poses[:, :3, 3], axis=0), axis=1)
        assert off.max() <= 0.55 * steps.max(initial=0) + 2e-4


def test_bare_fingertips_of_a_plan_with_an_arm():
    with_arm, bare = timed("carried"), timed("carried", fingers=True)
    plan = planned("carried")
    assert with_arm.joint_names == list(plan.joint_names)
    assert [s.name for s in with_arm.segments] == [s.name for s in plan.joint_segments]
    assert bare.joint_names == []
    assert [s.name for s in bare.segments] == [s.name for s in plan.segments]
    np.testing.assert_allclose(bare.object_poses[-1], with_arm.object_poses[-1], atol=1e-6)


def test_an_arm_without_joint_paths_is_not_timed(tmp_path):
    document = json.loads(planned("carried").to_json())
    document["realization"]["segments"][1] |= {"positions": [], "object_poses": []}
    with pytest.raises(TaskError, match="'touch' of the fingertip plan has no rows: nothing to"):
        graspless.time(reread(document, tmp_path / "rows.json"))
    document["realization"]["segments"] = []
    with pytest.raises(TaskError, match="the fingertip plan has no joint paths: nothing to time"):
        graspless.time(reread(document, tmp_path / "none.json"))


def test_bare_fingertips_of_a_plan_that_its_arm_cannot_carry_out():
    plan = planned("carried")
    refused = copy.copy(plan)
    refused.status = fingertip.Status.not_realized
    with pytest.raises(TaskError, match="not_realized, not solved"):
        graspless.time(refused)
    bare = graspless.time(refused, fingers=True)
    np.testing.assert_array_equal(bare.times, timed("carried", fingers=True).times)


def test_a_regrasp_takes_its_time():
    plan, trajectory = planned("regrasp"), timed("regrasp")
    mine = next(m for segment, m in of_segments(trajectory) if segment.name == "regrasp")
    t, rows = trajectory.times[mine], trajectory.rows[mine]
    leave, move = np.interp([1 / 3, 2 / 3], rows, t) - t[0]
    clearance = 2 * plan.task.problem.fingers.radius
    assert leave >= clearance / settings.FINGERTIP_SPEED
    assert t[-1] - t[0] - move == pytest.approx(leave, rel=1e-6)
    assert move - leave >= plan.task.problem.object.size / settings.FREE_FINGER_SPEED


@pytest.mark.parametrize("name", ARMS + BARE)
def test_sampling_keeps_the_limits_and_the_ends(name):
    trajectory = timed(name)
    coarse = trajectory.sampled(17.0)
    assert np.ptp(np.diff(coarse.times)) < 1e-12
    assert 1 / 18 < coarse.times[1] <= 1 / 17 + 1e-12
    assert coarse.duration == pytest.approx(trajectory.duration)
    np.testing.assert_array_equal(coarse.positions[-1], trajectory.positions[-1])
    np.testing.assert_allclose(coarse.object_poses[-1], trajectory.object_poses[-1], atol=1e-12)
    again = trajectory.at(trajectory.times)
    np.testing.assert_array_equal(again.segment_index, trajectory.segment_index)
    np.testing.assert_allclose(again.rows, trajectory.rows, atol=1e-12)
    for what in ("positions", "velocities", "accelerations"):
        np.testing.assert_array_equal(getattr(again, what), getattr(trajectory, what))
    np.testing.assert_allclose(again.object_poses, trajectory.object_poses, atol=1e-12)
    held = trajectory.at([-1.0, trajectory.duration + 1])
    assert held.names == [trajectory.names[0], trajectory.names[-1]]
    np.testing.assert_allclose(held.positions, trajectory.positions[[0, -1]], atol=1e-12)


@pytest.mark.parametrize("rate", [100.0, 250.0, 500.0, 1000.0])
@pytest.mark.parametrize("name", ARMS)
def test_differences_of_dense_samples_keep_the_limits(name, rate):
    """A controller that gets positions alone differentiates them."""
    dense, step = timed(name).sampled(rate), timed(name).sampled(rate).times[1]
    velocities = np.diff(dense.positions, axis=0) / step
    accelerations = np.diff(velocities, axis=0) / step
    jerks = np.diff(accelerations, axis=0) / step
    top = settings.ACCELERATION[0]
    assert (np.abs(velocities) <= np.asarray(arm_of(planned(name)).max_velocity) * 1.001).all()
    assert np.abs(accelerations).max() <= 1.01 * top
    assert np.abs(dense.accelerations).max() <= 1.01 * top
    assert np.abs(jerks).max() <= 1.15 * settings.JERK * top
    truth = timed(name, rate=4000.0).at(dense.times)
    np.testing.assert_allclose(dense.positions, truth.positions, atol=1e-6)
    np.testing.assert_allclose(dense.velocities, truth.velocities, atol=2e-3)


@pytest.mark.parametrize("name", ["slide", "carried"])
def test_between_the_samples_of_a_pause_nothing_moves(name):
    trajectory = timed(name)
    rests = np.flatnonzero(np.diff(trajectory.times) > 0.999 * settings.PAUSE)
    assert len(rests)
    for k in rests:
        paused = trajectory.at(trajectory.times[k] + settings.PAUSE * np.linspace(0.1, 0.9, 9))
        here = np.broadcast_to(trajectory.positions[k], paused.positions.shape)
        np.testing.assert_allclose(paused.positions, here, rtol=0, atol=1e-14)
        assert np.abs(paused.velocities).max() < 1e-12
        assert np.abs(paused.accelerations).max() < 1e-10


def test_the_timed_motion_passes_the_plan_s_own_check():
    """Collisions, bands, limits and the grasp hold along it as they do along the rows."""
    plan, trajectory = planned("slide"), timed("slide")
    moved = copy.copy(plan)
    segments = []
    for segment, mine in of_segments(trajectory):
        # A segment begins where the one before ended.
        rows = slice(max(mine.start - 1, 0), mine.stop)
        rows = rows if trajectory.rows[mine.start] > 0 else mine
        segments.append(
            slide.Segment(segment.name, trajectory.positions[rows], trajectory.object_poses[rows])
        )
    moved.segments = segments
    moved.tube = slide.Tube()  # its rows are others
    options = plan.task.options
    options.lift_height -= settings.TOLERANCE  # its corners are rounded
    faults = slide.check(plan.task.problem, moved, options)
    # Poses between rows are interpolated, and follow the contact less exactly than rows do.
    assert [fault for fault in faults if "does not follow the contact" not in fault] == []


def test_object_follows_its_rows():
    plan, trajectory = planned("slide"), timed("slide")
    np.testing.assert_allclose(trajectory.object_poses[0], plan.task.problem.X_WO_start, atol=1e-9)
    np.testing.assert_allclose(trajectory.object_poses[-1], plan.X_WO_goal, atol=1e-9)
    still = [s.name != "slide" for s in trajectory.segments]
    for segment, mine in of_segments(trajectory):
        if segment.name != "slide":
            assert np.ptp(trajectory.object_poses[mine], axis=0).max() < 1e-12
    assert sum(still) == len(still) - 1


@pytest.mark.parametrize("name", ["slide", "regrasp", "carried", "lifted", "twice"])
def test_an_execution_without_pauses_is_the_trajectory(name):
    trajectory = timed(name)
    poses = trajectory.followed(trajectory.names, trajectory.times)
    np.testing.assert_allclose(poses, trajectory.object_poses, atol=1e-9)


@pytest.mark.parametrize("name", ["lifted", "twice"])
def test_a_chain_is_its_stages_one_after_the_other(name):
    plan, whole = planned(name), timed(name)
    stages = [graspless.time(stage) for stage in plan.stages]
    assert whole.joint_names == stages[0].joint_names == list(plan.joint_names)
    assert [s.name for s in whole.segments] == [s.name for t in stages for s in t.segments]
    assert (np.diff(whole.times) > 0).all()
    total = sum(t.duration for t in stages) + settings.PAUSE * (len(stages) - 1)
    assert whole.duration == pytest.approx(total)
    np.testing.assert_array_equal(
        whole.positions, np.concatenate([stage.positions for stage in stages])
    )
    for segment, mine in of_segments(whole):
        if segment.name == "carry":
            problem = plan.stages[-1].task.problem
            moved = [
                np.linalg.norm(problem.robot.jacobian(problem.frame, q)[:3] @ v)
                for q, v in zip(whole.positions[mine], whole.velocities[mine], strict=True)
            ]
            assert max(moved) > 0.9 * settings.CONTACT_SPEED
            assert max(moved) <= settings.CONTACT_SPEED * (1 + 1e-6)


def test_same_plan_same_times():
    again = graspless.time(planned("slide"))
    np.testing.assert_array_equal(again.times, timed("slide").times)
    np.testing.assert_array_equal(again.positions, timed("slide").positions)


SLIDER = """<robot name="slider"><link name="a"/><link name="b"/><link name="c"/><link name="wheel"/>
<joint name="rolls" type="continuous"><parent link="b"/><child link="wheel"/><axis xyz="0 1 0"/>
<mimic joint="rail" multiplier="20"/></joint>
<joint name="rail" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="1 0 0"/>
<limit lower="0" upper="1" effort="1" velocity="0"/></joint>
<joint name="turn" type="revolute"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="3"/></joint></robot>"""


def test_limits_beside_those_of_the_urdf():
    slider = Robot.from_urdf(SLIDER)
    order = [slider.joint("rail"), slider.joint("turn")]
    velocity, acceleration, _ = settings.joint_limits(slider, {"rail": 0.25}, None, None)
    np.testing.assert_array_equal(velocity[order], [settings.VELOCITY[1], 3.0])
    np.testing.assert_array_equal(acceleration[order], settings.ACCELERATION[::-1])
    velocity, acceleration, jerk = settings.joint_limits(
        slider, {"turn": 5, "rail": 0.25}, {"rail": 0.3}, {"turn": 7}
    )
    np.testing.assert_array_equal(velocity[order], [settings.VELOCITY[1], 3.0])  # the URDF's
    np.testing.assert_array_equal(acceleration[order], [0.3, settings.ACCELERATION[0]])
    np.testing.assert_array_equal(jerk[order], [0.3 * settings.JERK, 7])
    velocity, *_ = settings.joint_limits(slider, 0.2, None, None)
    np.testing.assert_array_equal(velocity, [0.2, 0.2])


@pytest.mark.parametrize(
    ("name", "settings", "words"),
    [
        ("slide", {"max_velocity": 0}, ["max_velocity", "0", "positive"]),
        ("slide", {"max_velocity": float("nan")}, ["max_velocity", "nan"]),
        ("slide", {"max_velocity": "fast"}, ["max_velocity", "'fast'", "a number"]),
        ("slide", {"max_velocity": [1]}, ["max_velocity", "[1]", "by name of joint"]),
        ("slide", {"max_acceleration": 1e10}, ["max_acceleration", "at most 1e+09"]),
        ("slide", {"max_acceleration": -1.0}, ["max_acceleration", "-1"]),
        ("slide", {"max_jerk": {"elbow": 5}}, ["max_jerk", "elbow", "wam_joint_1"]),
        ("slide", {"max_jerk": 0}, ["max_jerk", "0"]),
        ("push", {"max_jerk": 5.0}, ["max_jerk", "moves no joints"]),
        ("slide", {"max_acceleration": {"wam_joint_1": float("inf")}}, ["wam_joint_1", "inf"]),
        ("slide", {"max_velocity": {"elbow": 1}}, ["max_velocity", "elbow", "wam_joint_7"]),
        ("slide", {"max_velocity": {0: 1.0}}, ["max_velocity", "0", "name of a joint"]),
        ("slide", {"contact_speed": -0.1}, ["contact_speed", "-0.1"]),
        ("slide", {"rate": 0}, ["rate", "0"]),
        ("slide", {"rate": 10**400}, ["rate", "at most 308 digits"]),
        ("slide", {"rate": np.complex64(1)}, ["rate", "1+0j", "a number"]),
        ("slide", {"robot": "wam"}, ["robot", "'wam'", "graspless.robot.Robot"]),
        ("slide", {"max_velocity": [1] * 999}, ["max_velocity", "[1, 1, 1", "1,...: should be"]),
        ("slide", {"pause": 0}, ["pause", "0"]),
        ("slide", {"fingers": True}, ["fingers", "slide"]),
        ("clasp", {"fingers": True}, ["fingers", "clasp"]),
        ("push", {"max_velocity": 1.0}, ["max_velocity", "no joints"]),
    ],
)
def test_bad_settings_are_told(name, settings, words):
    with pytest.raises(TaskError) as caught:
        timed_with(name, **settings)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize("name", ["slide", "push"])
@pytest.mark.parametrize("value", [1e-9, 1e-300])
@pytest.mark.parametrize("limit", ["max_velocity", "max_acceleration", "contact_speed"])
def test_limits_that_would_fill_the_memory(name, limit, value):
    with pytest.raises(TaskError, match=limit):
        graspless.time(planned(name), **{limit: value})


def test_a_rate_that_would_fill_the_memory():
    words = r"rate: 1e\+09: the first .* s of motion alone have .* samples, more than 1000000: should be less"
    with pytest.raises(TaskError, match=words):
        graspless.time(planned("push"), rate=1e9)
    with pytest.raises(TaskError, match=words):
        timed("push").sampled(1e9)


@pytest.mark.parametrize("name", ["slide", "regrasp", "twice"])
def test_moments_are_counted_over_the_whole(monkeypatch, name):
    """Also where each stretch alone has few enough."""
    trajectory = timed(name)
    moments, most = len(trajectory), np.bincount(trajectory.segment_index).max()
    assert most + 2 < 0.9 * moments
    monkeypatch.setattr(rates, "MOST_MOMENTS", int(most + 2))
    with pytest.raises(TaskError, match=f"samples, more than {most + 2}: should be less"):
        graspless.time(planned(name))
    monkeypatch.setattr(rates, "MOST_MOMENTS", 2 * moments)
    assert len(graspless.time(planned(name))) == moments


def test_how_many_are_too_many_is_said_exactly():
    assert len(rates.Rate(10**6 - 1).times(1.0)) == 10**6
    with pytest.raises(TaskError, match="have 1000001 samples, more than 1000000"):
        rates.Rate(10**6).times(1.0)
    for duration in (np.inf, np.nan, 1e308):
        with pytest.raises(TaskError, match="more than 1000000"):
            rates.Rate(1e300).times(duration)


@pytest.mark.parametrize(
    ("name", "settings", "words"),
    [
        ("slide", {"pause": 1e9}, r"pause: 1e\+09: makes \de\+09 s in all, more than 2147483647"),
        ("regrasp", {"pause": 2e9}, r"pause: 2e\+09: makes"),
        ("slide", {"pause": 1e308}, r"pause: 1e\+308: should be at most 2147483647"),
        ("slide", {"max_velocity": 1e-10, "rate": 1e-8}, "max_velocity, max_.* should be more"),
    ],
)
def test_what_takes_too_long_for_a_message(name, settings, words):
    with pytest.raises(TaskError, match=words):
        graspless.time(planned(name), **settings)


def test_a_path_that_toppra_cannot_pass_is_no_fault_of_ours(monkeypatch):
    """Nor of a viewer, which shows the rows without a clock."""
    from graspless.timing import fastest
    from graspless.view.clock import clock_of

    monkeypatch.setattr(
        fastest.TOPPRA, "compute_parameterization", lambda *given: (None, None, None)
    )
    with pytest.raises(TaskError, match="found no motion along a path, because of rounding"):
        graspless.time(planned("push"))
    words = "within contact_speed: should be closer to the default"
    with pytest.raises(TaskError, match=words) as caught:
        graspless.time(planned("push"), contact_speed=0.01)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    assert clock_of(planned("push")) is None


def test_another_robot():
    same = Robot.from_urdf_file(str(robot.builtin("wam_t42")))
    again = graspless.time(planned("slide"), same)
    np.testing.assert_array_equal(again.times, timed("slide").times)
    other = Robot.from_urdf_file(str(robot.builtin("kr5_sdh")))
    for name, needed in (("slide", "wam_joint_1"), ("push", "none")):
        with pytest.raises(TaskError, match="robot: .*kr5_joint_1") as caught:
            graspless.time(planned(name), other)
        assert needed in str(caught.value)


def test_a_plan_that_is_not_solved():
    unsolved = graspless.plan(planned("slide").task, iterations=0)
    with pytest.raises(TaskError, match=f"{unsolved.status}, not solved"):
        graspless.time(unsolved)


def test_without_toppra(monkeypatch):
    def part(room, kind):
        raise ImportError("no", name="toppra")

    monkeypatch.setattr("graspless.timing.part", part)
    with pytest.raises(TaskError, match=re.escape(f"needs toppra: {install_command('timing')}")):
        timed_with("push")


def test_a_press_on_the_bottom_of_a_bowl_is_slow_near_the_bottom_alone(bowl_problem):
    problem, top = bowl_problem, bowl_problem.object.top
    assert top == pytest.approx(0.004)
    plan = slide.plan(problem)
    assert plan, plan.reason
    press = next(segment for segment in plan.segments if segment.name == "press")
    tips = [problem.robot.pose(problem.hand.fingertip, q)[2, 3] for q in press.positions]
    ones = np.ones(problem.robot.dof)
    slow = slide_timing.touch(
        problem,
        press,
        settings.Settings(problem.robot, ones, ones, ones, None, rates.Rate(100), 0.0),
    ).rows
    assert slow.stop == len(press)
    assert np.max(tips[slow.start + 1 :]) <= top + settings.GUARD < tips[slow.start]
