# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is exported is read back by other programs' readers, and is the trajectory."""

import csv
import dataclasses
import importlib.util
import json
import pathlib
import re
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
import trimesh
import yaml
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore

import graspless
from fingertip_common import PUSH
from graspless import TaskError, cli, formats, frames
from graspless.errors import install_command
from graspless.formats import ENDINGS, FORMATS, NOT_TEXT
from graspless.formats.fingers import contacts
from graspless.formats.json_model import TrajectoryFile
from graspless.robot import Robot
from graspless.simulation.robots import robot_spec
from graspless.tasks import read_task
from graspless.tasks.robots import Robot as Fields
from graspless.timing.squeeze import beyond
from tasks_common import changed, edited
from timing_common import planned

ROOT = pathlib.Path(__file__).parents[2]
RATE = 20.0
HERE = [to for to in FORMATS if to != "rrd" or importlib.util.find_spec("rerun")]


def exported(name, path, to, **settings):
    return graspless.export(planned(name), path, to, rate=RATE, **settings)


def test_a_trajectory_is_written_as_it_is(tmp_path):
    planned_anew = exported("slide", tmp_path / "plan.csv", "csv")
    trajectory = graspless.time(planned("slide"), rate=RATE)
    for to in HERE:
        ending = ENDINGS[to][0] if ENDINGS[to] else ""
        assert graspless.export(trajectory, tmp_path / f"own{ending}", to) is trajectory
        if to in ("ros", "csv", "mujoco", "json"):
            exported("slide", tmp_path / f"plan{ending}", to)
            written = [(tmp_path / f"{name}{ending}").read_text() for name in ("own", "plan")]
            assert written[0] == written[1]
    slower = trajectory.at(np.linspace(0.0, trajectory.duration, 7))
    assert len(graspless.export(slower, tmp_path / "few.csv", "csv")) == 7
    assert len((tmp_path / "few.csv").read_text().splitlines()) == 8
    arm = graspless.export(trajectory, tmp_path / "arm.csv", "csv", group="arm")
    assert arm.joint_names == planned_anew.joint_names[:7]
    with pytest.raises(TaskError, match="plan: a Trajectory of a group; mujoco holds the whole"):
        graspless.export(arm, tmp_path / "arm.xml", "mujoco")
    for part in (trajectory.times[:9], trajectory.times[-1:]):  # before the hand closes, and after
        graspless.export(trajectory.at(part), tmp_path / "part.xml", "mujoco")
    model, _ = loaded(tmp_path / "part.xml")
    assert np.array_equal(model.key_ctrl[-1], loaded(tmp_path / "own.xml")[0].key_ctrl[-1])
    for times in ([1.0, 0.5], [0.0, 0.0], [-1.0, 0.0]):
        with pytest.raises(TaskError, match="plan: its times should begin at 0 or later"):
            graspless.export(trajectory.at(times), tmp_path / "own.yaml", "ros")
    with pytest.raises(TaskError, match="group: 'hand': the trajectory is of another group"):
        graspless.export(arm, tmp_path / "hand.csv", "csv", group="hand")
    with pytest.raises(TaskError, match="rate: must not be given with a Trajectory"):
        graspless.export(trajectory, tmp_path / "own.csv", "csv", rate=5)
    with pytest.raises(TaskError, match="max_jerk: must not be given with a Trajectory"):
        graspless.export(trajectory, tmp_path / "own.csv", "csv", max_jerk=5.0)


def test_csv_is_a_table_with_one_line_of_names(tmp_path):
    trajectory = exported("slide", tmp_path / "plan.csv", "csv")
    with (tmp_path / "plan.csv").open() as file:
        names, *rows = csv.reader(file)
    assert names[:3] == ["time", "segment", "wam_joint_1"]
    assert names[-7:] == [f"object_{x}" for x in ("x", "y", "z", "qw", "qx", "qy", "qz")]
    assert [row[1] for row in rows] == trajectory.names
    table = np.array([[float(v) for k, v in enumerate(row) if k != 1] for row in rows])
    dof = len(trajectory.joint_names)
    np.testing.assert_array_equal(table[:, 0], trajectory.times)
    np.testing.assert_array_equal(table[:, 1 : 1 + dof], trajectory.positions)
    np.testing.assert_array_equal(table[:, 1 + dof : 1 + 2 * dof], trajectory.velocities)
    poses = [frames.from_row(row) for row in table[:, 1 + 2 * dof :]]
    np.testing.assert_allclose(poses, trajectory.object_poses, atol=1e-12)


@pytest.mark.parametrize("name", ["lifted", "twice"])
def test_csv_of_a_chain_numbers_its_segments_as_mujoco_does(tmp_path, name):
    trajectory = exported(name, tmp_path / "plan.csv", "csv")
    exported(name, tmp_path / "plan.xml", "mujoco")
    model, _ = loaded(tmp_path / "plan.xml")
    keys = [model.key(k).name for k in range(1, model.nkey)]
    with (tmp_path / "plan.csv").open() as file:
        found = [row["segment"] for row in csv.DictReader(file)]
    assert found == [keys[i] for i in trajectory.segment_index]
    assert len(set(found)) == len(trajectory.segments)


def test_fingertips_are_on_the_object_unless_they_regrasp(tmp_path):
    trajectory = exported("regrasp", tmp_path / "plan.csv", "csv")
    with (tmp_path / "plan.csv").open() as file:
        rows = list(csv.DictReader(file))
    regrasp = next(s for s in trajectory.segments if s.name == "regrasp")
    size = np.array([0.05, 0.05, 0.10]) / 2  # of the block, centred at O
    for k, row in enumerate(rows):
        for finger in range(2):
            place = [row[f"finger_{finger}_{axis}"] for axis in "xyz"]
            if row["segment"] == "regrasp" and finger == regrasp.finger:
                assert place == ["", "", ""]
                continue
            X_OW = np.linalg.inv(trajectory.object_poses[k])
            p_O = X_OW[:3, :3] @ [float(x) for x in place] + X_OW[:3, 3]
            assert np.isclose(np.abs(p_O), size, atol=1e-9).any()
            assert (np.abs(p_O) <= size + 1e-9).all()


def test_ros_is_a_joint_trajectory(tmp_path):
    trajectory = exported("slide", tmp_path / "plan.yaml", "ros")
    message = yaml.safe_load((tmp_path / "plan.yaml").read_text())
    assert set(message) == {"header", "joint_names", "points"}
    assert message["joint_names"] == trajectory.joint_names
    for field in ("positions", "velocities", "accelerations"):
        values = [point[field] for point in message["points"]]
        np.testing.assert_array_equal(values, getattr(trajectory, field))
    stamps = [point["time_from_start"] for point in message["points"]]
    nanoseconds = np.array([s["sec"] * 10**9 + s["nanosec"] for s in stamps])
    assert all(0 <= s["nanosec"] < 10**9 for s in stamps)
    assert (np.diff(nanoseconds) > 0).all()  # controllers refuse anything else
    np.testing.assert_allclose(nanoseconds * 1e-9, trajectory.times, atol=1e-9)
    typed(message)


def typed(message):
    """Builds the ROS message: every field has its type's name, none is missing."""
    types = get_typestore(Stores.ROS2_HUMBLE).types
    point = types["trajectory_msgs/msg/JointTrajectoryPoint"]
    duration = types["builtin_interfaces/msg/Duration"]
    for fields in message["points"]:
        point(**fields | {"time_from_start": duration(**fields["time_from_start"])})


def messages_of(path):
    """Messages by topic, each with its time [ns]."""
    found = {}
    with AnyReader([path], default_typestore=get_typestore(Stores.ROS2_HUMBLE)) as reader:
        for connection, time, data in reader.messages():
            message = reader.deserialize(data, connection.msgtype)
            found.setdefault(connection.topic, []).append((time, message))
    return found


@pytest.mark.parametrize("file", ["plan.mcap", "PLAN.MCAP", "bag"])
def test_mcap_is_read_back_by_rosbags(tmp_path, file):
    trajectory = exported("slide", tmp_path / file, "mcap")
    assert [p.name for p in tmp_path.iterdir()] == [file]
    assert (tmp_path / file).is_file() == (file != "bag")
    found = messages_of((tmp_path / file).rename(tmp_path / file.lower()))  # the reader's endings
    assert set(found) == {"/joint_trajectory", "/joint_states", "/object_pose"}
    ((time, whole),) = found["/joint_trajectory"]
    assert time == 0
    assert whole.joint_names == trajectory.joint_names
    positions = np.array([point.positions for point in whole.points])
    np.testing.assert_array_equal(positions, trajectory.positions)
    states = found["/joint_states"]
    np.testing.assert_allclose([t * 1e-9 for t, _ in states], trajectory.times, atol=1e-9)
    np.testing.assert_array_equal([m.position for _, m in states], trajectory.positions)
    np.testing.assert_array_equal([m.velocity for _, m in states], trajectory.velocities)
    poses = [m.pose for _, m in found["/object_pose"]]
    rows = [
        [p.position.x, p.position.y, p.position.z]
        + [p.orientation.w, p.orientation.x, p.orientation.y, p.orientation.z]
        for p in poses
    ]
    read = [frames.from_row(row) for row in rows]
    np.testing.assert_allclose(read, trajectory.object_poses, atol=1e-12)
    assert found["/object_pose"][0][1].header.frame_id == "world"


def test_mcap_of_a_group_has_its_joints_alone(tmp_path):
    trajectory = exported("slide", tmp_path / "plan.mcap", "mcap", group="arm")
    assert 0 < len(trajectory.joint_names) < len(planned("slide").joint_names)
    found = messages_of(tmp_path / "plan.mcap")
    ((_, whole),) = found["/joint_trajectory"]
    for field in ("positions", "velocities", "accelerations"):
        values = [getattr(point, field) for point in whole.points]
        np.testing.assert_array_equal(values, getattr(trajectory, field))
    states = [message.position for _, message in found["/joint_states"]]
    np.testing.assert_array_equal(states, trajectory.positions)


def test_mcap_of_bare_fingertips(tmp_path):
    trajectory = exported("regrasp", tmp_path / "plan.mcap", "mcap")
    found = messages_of(tmp_path / "plan.mcap")
    assert set(found) == {"/object_pose", "/fingertip_0", "/fingertip_1"}
    points = contacts(trajectory)
    for i in range(2):
        on = np.isfinite(points[:, i]).all(axis=1)
        read = [[m.point.x, m.point.y, m.point.z] for _, m in found[f"/fingertip_{i}"]]
        np.testing.assert_array_equal(read, points[on, i])


def test_mcap_of_the_longest_pauses_that_there_are(tmp_path):
    """Seconds of a message are 32 bits, with a sign."""
    rests = len({"press", "slide", "grasp"})
    trajectory = exported("slide", tmp_path / "a.mcap", "mcap", pause=2.147e9 / rests)
    ((_, whole),) = messages_of(tmp_path / "a.mcap")["/joint_trajectory"]
    assert whole.points[-1].time_from_start.sec == int(trajectory.duration) > 2.14e9
    with pytest.raises(TaskError, match=r"pause: 1e\+09: makes .*: should be less"):
        exported("slide", tmp_path / "b.mcap", "mcap", pause=1e9)


@pytest.mark.parametrize("name", ["slide", "regrasp", "carried", "lifted"])
def test_json_is_what_its_schema_says(tmp_path, name):
    trajectory = exported(name, tmp_path / "plan.json", "json")
    document = json.loads((tmp_path / "plan.json").read_text())
    file = TrajectoryFile.model_validate(document)
    published = json.loads((ROOT / "python/graspless/trajectory.schema.json").read_text())
    assert set(document) == set(published["properties"]) == set(published["required"])
    assert len(file.times) == len(trajectory)
    for field in ("times", "segment_index", "rows"):
        np.testing.assert_array_equal(getattr(file, field), getattr(trajectory, field))
    for field in ("positions", "velocities", "accelerations"):
        values = np.array(getattr(file, field)).reshape(len(trajectory), -1)
        np.testing.assert_array_equal(values, getattr(trajectory, field))
    assert [file.segments[i] for i in file.segment_index] == trajectory.names
    assert {len(row) for row in file.fingers} == {2 if name == "regrasp" else 0}


def test_published_schema_is_that_of_the_model():
    spec = importlib.util.spec_from_file_location("schema", ROOT / "tools" / "schema.py")
    schema = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(schema)
    assert schema.TRAJECTORY.read_text() == schema.trajectory_text(), "run tools/schema.py"


def test_limits_reach_the_file(tmp_path):
    slow = exported("clasp", tmp_path / "plan.csv", "csv", max_velocity=0.2, contact_speed=0.01)
    assert np.abs(slow.velocities).max() <= 0.2 * (1 + 1e-6)
    assert slow.duration > graspless.time(planned("clasp")).duration


@pytest.mark.parametrize(
    ("name", "to", "words"),
    [
        ("slide", {}, "to: {}: should be one of ros, mcap"),
        ("slide", "fbx", "to: fbx: should be one of ros, mcap"),
        (
            "slide",
            "mujco",
            r"to: mujco: should be one of ros, mcap, .*; did you mean 'mujoco'\?",
        ),
        ("push", "ros", "no joints, .* fingertips: mcap, csv, mujoco, json, drake, rrd"),
    ],
)
def test_what_cannot_be_exported_is_told(tmp_path, name, to, words):
    with pytest.raises(TaskError, match=words):
        exported(name, tmp_path / "plan", to)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("to", HERE)
def test_an_ending_of_another_format_is_refused(tmp_path, to):
    for other in set(FORMATS) - {to}:
        for ending in ENDINGS[other]:
            own = re.escape(" or ".join(ENDINGS[to]))
            with pytest.raises(TaskError, match=f"is the ending of {other}: should be {own}"):
                exported("slide", tmp_path / f"plan{ending.upper()}", to)
    assert not list(tmp_path.iterdir())
    for ending in (*ENDINGS[to], "", ".of_2026"):
        formats._check_ending(f"plan{ending}", to)


@pytest.mark.parametrize("to", HERE)
def test_a_plan_without_solution_is_refused(tmp_path, to):
    unsolved = graspless.plan(planned("slide").task, iterations=0)
    with pytest.raises(TaskError, match="not solved"):
        graspless.export(unsolved, tmp_path / "plan", to)
    assert not list(tmp_path.iterdir())


def test_files_are_written_whole_or_not_at_all(tmp_path, monkeypatch):
    for to in HERE:
        with pytest.raises(TaskError, match="there is no folder"):
            exported("slide", tmp_path / "missing" / "plan.mcap", to)
    (tmp_path / "bag").mkdir()
    for to in ("mcap", "drake"):
        with pytest.raises(TaskError, match="bag: cannot be written"):
            exported("slide", tmp_path / "bag", to)
    assert [p.name for p in tmp_path.iterdir()] == ["bag"]


def test_from_the_command_line(tmp_path, capsys):
    for to in FORMATS:
        assert (
            cli.make_parser("export").parse_args(["export", "PLAN", "--to", to, "-o", "FILE"]).to
            == to
        )
    planned("clasp").save(tmp_path / "plan.json")
    out = tmp_path / "plan.csv"
    flags = ["--rate", "20", "--velocity", "0.5", "--acceleration", "2", "--contact-speed", "0.03"]
    assert (
        cli.main(["export", str(tmp_path / "plan.json"), "--to", "csv", "-o", str(out), *flags])
        == 0
    )
    assert f"written: {out}" in capsys.readouterr().out
    given = {"max_velocity": 0.5, "max_acceleration": 2.0, "contact_speed": 0.03}
    exported("clasp", tmp_path / "again.csv", "csv", **given)
    assert out.read_text() == (tmp_path / "again.csv").read_text()
    bad = ["export", str(tmp_path / "plan.json"), "--to", "csv", "-o", str(out), "--rate", "-1"]
    assert cli.main(bad) == 2
    assert capsys.readouterr().err.startswith("--rate: -1.0: should be")


@pytest.mark.parametrize(
    ("flags", "message"),
    [
        (["--velocity", "-1"], "--velocity: -1.0: should be positive and finite"),
        (["--acceleration", "nan"], "--acceleration: nan: should be positive and finite"),
        (["--contact-speed", "0"], "--contact-speed: 0.0: should be positive and finite"),
        (["--rate", "0"], "--rate: 0.0: should be positive and finite"),
        (
            ["--rate", "1e9"],
            "should be less, or --velocity, --acceleration or --contact-speed more",
        ),
        (["--fingers"], "--fingers: True: a clasp plan has no bare fingertips"),
    ],
)
@pytest.mark.parametrize("output", ["-", "a.csv"])
def test_bad_flags_are_named(tmp_path, monkeypatch, capsys, flags, message, output):
    monkeypatch.chdir(tmp_path)
    planned("clasp").save("plan.json")
    assert cli.main(["export", "plan.json", "--to", "csv", "-o", output, *flags]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert message in err
    assert not (tmp_path / "a.csv").exists()


def test_a_plan_that_does_not_hold_is_refused(tmp_path, capsys):
    plan, out = edited(planned("clasp"), tmp_path / "edited.json"), tmp_path / "plan.csv"
    command = ["export", plan, "--to", "csv", "--rate", "20", "-o", str(out)]
    assert cli.main(command) == 2
    err = capsys.readouterr().err
    assert err.startswith(f"{plan}: does not hold: ")
    assert graspless.check(plan)[0] in err
    assert err.endswith("; add --unchecked to continue anyway\n")
    assert not out.exists()
    assert cli.main([*command, "--unchecked"]) == 0
    assert out.exists()


def test_limits_of_single_joints(tmp_path, capsys):
    planned("slide").save(tmp_path / "plan.json")
    command = ["export", str(tmp_path / "plan.json"), "--to", "csv", "-o", str(tmp_path / "a.csv")]
    of_two = ["--velocity", "wam_joint_1=0.1", "--velocity", "wam_joint_2=0.2"]
    assert cli.main([*command, "--rate", "20", *of_two, "--acceleration", "wam_joint_1=2"]) == 0
    limits = {"wam_joint_1": 0.1, "wam_joint_2": 0.2}
    given = {"max_velocity": limits, "max_acceleration": {"wam_joint_1": 2.0}}
    exported("slide", tmp_path / "b.csv", "csv", **given)
    assert (tmp_path / "a.csv").read_text() == (tmp_path / "b.csv").read_text()
    for bad, words in (
        (["--velocity", "0.5", *of_two], "--velocity: should be one number, or one JOINT=V"),
        ([*of_two, *of_two], "--velocity: should be one number, or one JOINT=V"),
        (["--velocity", "elbow=1"], "--velocity: unknown joint 'elbow'; choose from wam_joint_1"),
        (["--acceleration", "wam_joint_1=0"], "--acceleration: wam_joint_1: 0.0: should be"),
    ):
        assert cli.main([*command, *bad]) == 2
        assert words in capsys.readouterr().err
    with pytest.raises(SystemExit, match="2"):
        cli.main([*command, "--velocity", "wam_joint_1=fast"])
    assert "--velocity: invalid limit value: 'wam_joint_1=fast'" in capsys.readouterr().err


@pytest.mark.parametrize("to", sorted(set(FORMATS) - set(NOT_TEXT)))
def test_text_goes_to_stdout(tmp_path, monkeypatch, capsys, to):
    monkeypatch.chdir(tmp_path)
    planned("clasp").save("plan.json")
    command = ["export", "plan.json", "--to", to, "--rate", "20", "-o"]
    assert cli.main([*command, "-"]) == 0
    out, err = capsys.readouterr()
    assert cli.main([*command, "file"]) == 0
    assert out == (tmp_path / "file").read_text()
    assert err.splitlines()[1] == capsys.readouterr().out.splitlines()[1]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "plan.json"]


def test_what_is_binary_needs_a_file(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    planned("clasp").save("plan.json")
    for to in NOT_TEXT:
        what = "folder" if to == "drake" else "file"
        assert cli.main(["export", "plan.json", "--to", to, "-o", "-"]) == 2
        assert f"to: {to}: is not text: should have a {what}" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["plan.json"]


@pytest.mark.parametrize("to", ["csv", "json", "ros"])
def test_nothing_is_minus_nothing(to):
    trajectory = graspless.time(planned("slide"), rate=RATE)
    zeros = dataclasses.replace(trajectory, velocities=np.full_like(trajectory.velocities, -0.0))
    assert np.signbit(zeros.velocities).all()
    module = importlib.import_module(f"graspless.formats.{to}")
    assert not re.search(r"-0\.0(?![\de])", module.text(zeros))


def test_an_import_error_without_a_name(tmp_path, monkeypatch):
    def broken(*given):
        raise ImportError("libzstd.so.1: cannot open shared object file")

    plan, export = planned("push"), graspless.export
    monkeypatch.setattr("graspless.formats.importlib.import_module", broken)
    with pytest.raises(TaskError, match=f"needs libzstd.so.1: cannot .*{install_command('ros')}"):
        export(plan, tmp_path / "a.mcap", "mcap")


@pytest.mark.parametrize("name", ["push", "clasp", "twice"])
def test_a_plan_that_closes_no_fingers_has_no_squeeze(name):
    plan = planned(name)
    if name == "twice":  # its last stage closes them
        plan = SimpleNamespace(kind="chain", stages=plan.stages[:1])
    with pytest.raises(TaskError, match=f"plan: {plan.kind}: no slide or pinch of it ends with"):
        beyond(plan, 0.2)


@pytest.mark.parametrize("name", ["slide", "clasp", "carried", "lifted"])
def test_mujoco_has_the_plan_s_kinematics_at_its_keyframes(tmp_path, name):
    trajectory = exported(name, tmp_path / "plan.xml", "mujoco")
    model, data = loaded(tmp_path / "plan.xml")
    plan = planned(name)
    task = (plan.stages[0] if plan.kind == "chain" else plan).task
    robot = task.problem.robot if task.arm is None else task.arm.robot
    names = [f"{i}_{segment.name}" for i, segment in enumerate(trajectory.segments)]
    assert [model.key(k).name for k in range(model.nkey)] == ["start", *names]
    assert [model.actuator(i).name for i in range(model.nu)] == list(robot.joint_names)
    assert model.joint("object").id == model.njnt - 1
    held = [model.equality(i).name for i in range(model.neq)]
    assert ("object_held" in held) == (name == "clasp")
    for k in range(model.nkey):
        mujoco.mj_resetDataKeyframe(model, data, k)
        mujoco.mj_forward(model, data)
        own = np.flatnonzero(trajectory.segment_index == max(k - 1, 0))
        at = own[0 if k == 0 else -1]
        q, X_WO = trajectory.positions[at], trajectory.object_poses[at]
        squeezed = data.ctrl - q
        if name in ("slide", "lifted") and any(each.endswith("_close") for each in names[:k]):
            closing = beyond(plan, 0.2)
            squeezed -= np.clip(q + closing, robot.lower, robot.upper) - q
            assert np.abs(squeezed - data.ctrl + q).max() > 0.05
        np.testing.assert_allclose(squeezed, 0, atol=1e-5)  # MuJoCo writes six digits
        for frame, X_WF in zip(robot.frame_names, robot.forward(q), strict=True):
            np.testing.assert_allclose(body_pose(data, frame), X_WF, atol=1e-5)
        np.testing.assert_allclose(body_pose(data, "object"), X_WO, atol=1e-5)


def test_mujoco_holds_the_object_of_a_clasp(tmp_path):
    exported("clasp", tmp_path / "plan.xml", "mujoco")
    model, data = loaded(tmp_path / "plan.xml")
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    before = body_pose(data, "object")
    for _ in range(1000):
        mujoco.mj_step(model, data)
        np.testing.assert_allclose(body_pose(data, "object"), before, atol=1e-3)


@pytest.mark.parametrize("name", ["push", "tumble", "regrasp", "twice"])
def test_mujoco_of_bare_fingertips(tmp_path, name):
    trajectory = exported(name, tmp_path / "plan.xml", "mujoco")
    model, data = loaded(tmp_path / "plan.xml")
    plan = planned(name)
    problem = (plan.stages[0] if plan.kind == "chain" else plan).task.problem
    np.testing.assert_allclose(model.body("object").mass, problem.object.mass)
    for k in range(model.nkey):
        mujoco.mj_resetDataKeyframe(model, data, k)
        mujoco.mj_forward(model, data)
        segment = trajectory.segments[max(k - 1, 0)]
        X_WO = segment.X_WO[0 if k == 0 else -1]
        np.testing.assert_allclose(body_pose(data, "object"), X_WO, atol=1e-5)
        corners = problem.object.hull @ X_WO[:3, :3].T + X_WO[:3, 3]
        assert abs(corners[:, 2].min()) < 1e-6  # on the floor
        for i in range(problem.fingers.count):
            # A sphere that touches the block is its radius from it, and so in MuJoCo.
            gap = mujoco.mj_geomDistance(
                model, data, model.geom("object").id, geom_of(model, f"finger{i}"), 0.1, None
            )
            assert gap == pytest.approx(0, abs=1e-6)


def test_mujoco_of_bare_fingertips_has_the_task_s_gravity_and_friction(tmp_path):
    text = PUSH.replace("friction: 0.7", "friction: 0.3").replace(
        "motion:", "gravity: [0.2, 0, -1.6]\nmotion:"
    )
    model, data = chain(tmp_path, text)
    np.testing.assert_allclose(model.opt.gravity, [0.2, 0, -1.6])
    model.geom_margin[:] = 1e-3
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    finger = geom_of(model, "finger0")
    touches = [contact.friction[0] for contact in data.contact if finger in contact.geom]
    assert touches == [0.3]  # not that of the object, 0.5


def test_mujoco_object_and_obstacles_have_the_task_s_shape(tmp_path):
    exported("slide", tmp_path / "plan.xml", "mujoco")
    model, data = loaded(tmp_path / "plan.xml")
    mujoco.mj_forward(model, data)
    thing = planned("slide").task.problem.object
    assert model.body("object").mass[0] == pytest.approx(thing.mass)
    X_WO = body_pose(data, "object")
    com = X_WO[:3, :3] @ thing.com + X_WO[:3, 3]
    np.testing.assert_allclose(data.body("object").xipos, com, atol=1e-6)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    table = model.geom("table_0").id
    down = np.array([0.0, 0.0, -1.0])
    geoms = np.zeros(1, dtype=np.int32)
    above = np.array([0.65, -0.3, 0.5])  # beside the card
    assert mujoco.mj_ray(model, data, above, down, None, 1, -1, geoms) == pytest.approx(0.5)
    assert geoms[0] == table


def chain(tmp_path, text, name="chain"):
    plan = graspless.plan(read_task(text, name))
    assert plan, plan.reason
    graspless.export(plan, tmp_path / "plan.xml", "mujoco", rate=RATE)
    model, data = loaded(tmp_path / "plan.xml")
    mujoco.mj_forward(model, data)
    return model, data


def test_mujoco_of_a_chain_has_the_obstacles_of_all_stages(tmp_path):
    post = "{name: post, box: [0.05, 0.05, 0.05], pose: {position: [0.9, 0.9, 0.5]}}"
    other = "{name: post, box: [0.05, 0.07, 0.05], pose: {position: [0.8, 0.9, 0.5]}}"
    shelf = other.replace("post", "shelf")
    text = (ROOT / "examples" / "19_slide_then_lift.yaml").read_text()
    text = text.replace("\nstages:", f"\nobstacles: [{post}]\nstages:")
    text = text.replace("distance: 0.10}", f"distance: 0.10}}\n    obstacles: [{shelf}, {other}]")
    model, data = chain(tmp_path, text)
    found = {body: body_pose(data, body)[:3, 3] for body in ("post", "shelf", "post_2", "table")}
    np.testing.assert_allclose(found["post"], [0.9, 0.9, 0.5], atol=1e-6)
    np.testing.assert_allclose(found["shelf"], [0.8, 0.9, 0.5], atol=1e-6)
    np.testing.assert_allclose(found["post_2"], [0.8, 0.9, 0.5], atol=1e-6)
    np.testing.assert_allclose(model.geom("post_2_0").size, [0.025, 0.035, 0.025])
    fixed = [model.body(i).name for i in range(1, model.nbody) if model.body_weldid[i] == 0]
    assert set(fixed) - set(planned("lifted").stages[0].task.problem.robot.frame_names) == set(
        found
    )


def test_mujoco_of_a_chain_has_the_table_of_a_later_stage(tmp_path):
    """Its top was the floor of the fingertips: one of both, or no hand could reach below."""
    text = (ROOT / "examples" / "23_tumble_slide_lift.yaml").read_text()
    wall = "    walls: [{name: wall, normal: [-1, 0, 0], offset: -0.9, friction: 0.3}]\n"
    text = text.replace("    friction: 0.8\n", "    friction: 0.8\n" + wall)
    model, data = chain(tmp_path, text)
    down, geoms = np.array([0.0, 0.0, -1.0]), np.zeros(1, dtype=np.int32)
    at = {}
    for where, y in {"on the table": -0.3, "beside it": -0.4}.items():
        above = np.array([0.65, y, 0.5])
        at[where] = mujoco.mj_ray(model, data, above, down, None, 1, -1, geoms)
    assert at == {"on the table": pytest.approx(0.5), "beside it": -1}
    planes = np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE)
    assert [model.geom(i).name for i in planes] == ["wall"]
    wall = model.geom("wall")  # with priority, or the larger friction of the object would count
    assert (wall.friction[0], wall.priority[0]) == (0.3, 1)


L_SHAPE = """\
  polygon: [[-0.05, -0.05], [0.05, -0.05], [0.05, -0.02], [-0.02, -0.02], [-0.02, 0.05], [-0.05, 0.05]]
  com: [-0.01, -0.02]
  mass: 0.2
"""
BAR = """\
kind: carry
robot: {urdf: wam_t42}
frame: grasp
object: {slide: {rectangle: {size: [0.1, 0.02]}, thickness: 0.008, com: [0.03, 0], mass: 0.2}}
pose: {position: [0.55, 0, 0.25]}
offset: [0, 0.05, 0]
"""


@pytest.mark.parametrize(
    ("text", "com"),
    [
        (changed("  rectangle: {size: [0.10, 0.08]}\n", L_SHAPE), [-0.01, -0.02, 0.002]),
        (BAR, [0.03, 0, 0.004]),
    ],
    ids=["an L", "a carry"],
)
def test_mujoco_object_weighs_what_the_task_says(tmp_path, text, com):
    """An L's parts are not as heavy as each other, and its centre of mass may be elsewhere."""
    task = read_task(text, "task.yaml")
    plan = graspless.plan(task)
    assert plan, plan.reason
    graspless.export(plan, tmp_path / "plan.xml", "mujoco", rate=RATE)
    model, _ = loaded(tmp_path / "plan.xml")
    body = model.body("object")
    np.testing.assert_allclose(body.ipos, com, atol=1e-7)
    assert body.mass[0] == pytest.approx(0.2)
    mesh = trimesh.creation.box((0.1, 0.02, 0.008))
    if task.kind == "slide":
        mesh = prism(task.problem.object.outline, task.problem.object.thickness)
    mesh.density = 0.2 / mesh.volume
    moments = np.linalg.eigvalsh(mesh.moment_inertia)  # as trimesh has them
    np.testing.assert_allclose(np.sort(body.inertia), moments, rtol=1e-4)


def prism(outline, thickness):
    corners = [np.asarray(part.vertices) for part in outline.convex_parts()]
    points = [np.vstack([np.c_[p, np.full(len(p), z)] for z in (0, thickness)]) for p in corners]
    return trimesh.util.concatenate([trimesh.convex.convex_hull(p) for p in points])


MESHES = ["box.stl", "text.stl", "box.obj", "box.off", "box.ply", "box.glb"]


@pytest.mark.parametrize("name", MESHES)
def test_mujoco_gets_all_meshes_and_its_file_needs_no_other(tmp_path, name):
    """Of the files that a URDF may name, MuJoCo itself reads .obj and binary .stl."""
    from graspless.formats import mujoco_scene

    kind = "stl_ascii" if name == "text.stl" else None
    trimesh.creation.box((0.1, 0.2, 0.3)).export(tmp_path / name, file_type=kind)
    geometry = f'<geometry><mesh filename="{name}"/></geometry>'
    urdf = f'<robot name="r"><link name="base"><collision>{geometry}</collision></link></robot>'
    robot = Robot.from_urdf(urdf, directory=str(tmp_path))
    spec = robot_spec(robot, Fields(urdf_text=urdf, directory=str(tmp_path)))
    assert spec.compile().nmesh == 1
    mujoco_scene._inline_meshes(spec)
    (tmp_path / name).unlink()
    spec.compile()
    model = mujoco.MjModel.from_xml_string(spec.to_xml())
    np.testing.assert_allclose(np.ptp(model.mesh_vert, axis=0).round(6), [0.1, 0.2, 0.3])


def loaded(path):
    model = mujoco.MjModel.from_xml_path(str(path))
    return model, mujoco.MjData(model)


def body_pose(data, name):
    body = data.body(name)
    return frames.translation(body.xpos) @ frames.from_quaternion(body.xquat)


def geom_of(model, body):
    (geom,) = np.flatnonzero(model.geom_bodyid == model.body(body).id)
    return int(geom)
