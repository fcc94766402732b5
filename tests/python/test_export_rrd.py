# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""An exported recording is read back by rerun's own reader, and is the trajectory."""

import sys

import numpy as np
import pytest

import graspless
from graspless import TaskError, cli, frames
from graspless.formats.fingers import contacts
from graspless.timing.trajectory import robot_of
from timing_common import planned

RATE = 20.0


def read(path):
    """Columns by entity: moving ones with `time` [s], and those that never change."""
    chunks = pytest.importorskip("rerun.chunk", reason="rerun is not installed (extra rerun)")
    moving, fixed = {}, {}
    for chunk in chunks.RrdReader(path).stream():
        batch = chunk.to_record_batch()
        names = [name for name in batch.schema.names if "RowId" not in name]
        columns = {name.partition(":")[2] or name: batch.column(name) for name in names}
        into = fixed if chunk.is_static else moving
        if "time" in columns:
            columns["time"] = np.array(columns["time"].cast("int64")) * 1e-9
        into[chunk.entity_path] = into.get(chunk.entity_path, {}) | columns
    return moving, fixed


def poses(columns):
    """[N, 4, 4] of an entity's Transform3D."""
    at = np.array(columns["translation"].to_pylist(), dtype=float).reshape(-1, 3)
    turns = np.array(columns["quaternion"].to_pylist(), dtype=float).reshape(-1, 4)
    rows = zip(at, turns, strict=True)
    return np.array([frames.from_row([*p, w, x, y, z]) for p, (x, y, z, w) in rows])


def exported(name, tmp_path):
    pytest.importorskip("rerun", reason="rerun is not installed (extra rerun)")
    trajectory = graspless.export(planned(name), tmp_path / "plan.rrd", "rrd", rate=RATE)
    return trajectory, *read(tmp_path / "plan.rrd")


@pytest.mark.parametrize("name", ["slide", "clasp", "carried"])
def test_rerun_has_robot_and_object_over_time(tmp_path, name):
    trajectory, moving, fixed = exported(name, tmp_path)
    robot = robot_of(trajectory.plan)
    X_WF = np.array([robot.forward(q) for q in trajectory.positions])
    drawn = [path for path in moving if path.startswith("/world/robot/")]
    assert len(drawn) > 5
    for path in drawn:
        assert "vertex_positions" in fixed[f"{path}/0"]
        link = list(robot.frame_names).index(path.rpartition("/")[2])
        np.testing.assert_allclose(poses(moving[path]), X_WF[:, link], atol=1e-6)
    assert "vertex_positions" in fixed["/world/object/0"]
    thing = moving["/world/object"]
    np.testing.assert_allclose(thing["time"], trajectory.times, atol=1e-9)
    np.testing.assert_allclose(poses(thing), trajectory.object_poses, atol=1e-6)


def test_rerun_has_the_curves_of_the_joints(tmp_path):
    trajectory, moving, _ = exported("slide", tmp_path)
    for what in ("positions", "velocities"):
        for i, joint in enumerate(trajectory.joint_names):
            column = moving[f"/joints/{what}/{joint}"]["scalars"].to_pylist()
            np.testing.assert_array_equal(np.ravel(column), getattr(trajectory, what)[:, i])
    names = [segment.name for segment in trajectory.segments]
    assert np.ravel(moving["/segments"]["text"].to_pylist()).tolist() == names
    begins = [trajectory.times[trajectory.segment_index == k][0] for k in range(len(names))]
    np.testing.assert_allclose(moving["/segments"]["time"], begins, atol=1e-9)


def test_rerun_has_contacts_while_fingertips_touch(tmp_path):
    trajectory, moving, fixed = exported("regrasp", tmp_path)
    points = contacts(trajectory)
    radius = planned("regrasp").task.problem.fingers.radius
    for i in range(2):
        column = moving[f"/world/contacts/{i}"]["positions"].to_pylist()
        on = np.isfinite(points[:, i]).all(axis=1)
        assert [len(row) for row in column] == on.astype(int).tolist()
        seen = np.array([row[0] for row in column if row])
        np.testing.assert_allclose(seen, points[on, i], atol=1e-6)
        middles = poses(moving[f"/world/robot/finger{i}"])[on, :3, 3]
        apart = np.linalg.norm(middles - points[on, i], axis=1)
        np.testing.assert_allclose(apart, radius, atol=1e-6)
    for plane in planned("regrasp").task.problem.planes:
        path = f"/world/surroundings/{plane.name}"
        X_WP = poses(fixed[path])[0]
        corners = np.array(fixed[f"{path}/0"]["vertex_positions"].to_pylist()[0])
        heights = frames.transform(X_WP, corners) @ plane.n_W - plane.offset
        np.testing.assert_allclose(heights, 0, atol=1e-6)


def test_without_rerun_its_extra_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "rerun", None)
    monkeypatch.delitem(sys.modules, "graspless.formats.rrd", raising=False)
    planned("clasp").save(tmp_path / "plan.json")
    out = tmp_path / "plan.rrd"
    assert cli.main(["export", str(tmp_path / "plan.json"), "--to", "rrd", "-o", str(out)]) == 2
    assert "needs rerun: " in capsys.readouterr().err
    assert not out.exists()


def test_a_group_is_refused(tmp_path):
    pytest.importorskip("rerun", reason="rerun is not installed (extra rerun)")
    with pytest.raises(TaskError, match="group: arm: rrd holds the whole robot"):
        graspless.export(planned("clasp"), tmp_path / "plan.rrd", "rrd", group="arm")
