# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Viewer of a proposal: sliders, named states, collisions."""

import types

import numpy as np
import pytest

import inspect_common as small
from graspless import cli, frames, robot

pytest.importorskip("viser")

from graspless.view import joints  # noqa: E402
from graspless.view import server as servers  # noqa: E402


@pytest.fixture
def shown():
    found = robot.inspect(robot.Robot.from_urdf(small.gripper("grip", small.revolute())))
    with servers.open_server(servers.free_port()) as server:
        yield joints.Joints(server, found)


def assert_links_are_at(shown, q):
    for i, handle in zip(shown.drawn, shown.links, strict=True):
        X = np.asarray(shown.robot.pose(i, q))
        assert np.asarray(handle.position) == pytest.approx(X[:3, 3], abs=1e-5)
        turned = np.dot(handle.wxyz, frames.to_quaternion(X))
        assert abs(turned) == pytest.approx(1, abs=1e-5)


def test_each_joint_has_a_slider(shown):
    assert [slider.label for slider in shown.sliders] == list(shown.robot.joint_names)
    for k, slider in enumerate(shown.sliders):
        assert slider.min == pytest.approx(shown.robot.lower[k])
        assert slider.max == pytest.approx(shown.robot.upper[k])
        assert slider.value == pytest.approx(shown.q[k])
    assert_links_are_at(shown, shown.robot.state("home"))


def test_slider_moves_the_robot(shown):
    q = np.array(shown.q)
    q[1] = shown.robot.upper[1]
    shown.sliders[1].value = shown.robot.upper[1]  # as a user's drag, it calls those who follow
    assert shown.q == pytest.approx(q)
    assert_links_are_at(shown, q)
    assert {"robot", "frames", "curves"} <= set(shown.layers.handles)


@pytest.mark.parametrize("state", ["closed", "open"])
def test_state_moves_the_hand_alone(shown, state):
    arm = shown.robot.group("arm")
    before = shown.q[arm].copy()
    shown.set_state(state)
    assert shown.q[arm] == pytest.approx(before)
    assert shown.q == pytest.approx(shown.robot.state(state, shown.q))
    assert [slider.value for slider in shown.sliders] == pytest.approx(list(shown.q))
    assert_links_are_at(shown, shown.q)


def test_collisions_are_named(shown):
    assert shown.touching.value == "none"
    shown.q[:] = shown.robot.lower
    shown.show()
    touching = shown.checked.collision(shown.q)
    assert touching is not None
    assert shown.touching.value == f"{touching[0]} and {touching[1]}"


def test_curves_follow_the_fingers(shown):
    shown.set_state("closed")
    for handle, nodes in shown.curves:
        X = np.asarray(shown.robot.pose(nodes[-1][0], shown.q))
        tip = X[:3, :3] @ nodes[-1][1] + X[:3, 3]
        assert np.asarray(handle.points)[-1, 1] == pytest.approx(tip, abs=1e-5)


def test_command_serves_until_ctrl_c(tmp_path, capsys, monkeypatch):
    def interrupt(_):
        raise KeyboardInterrupt

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(joints, "time", types.SimpleNamespace(sleep=interrupt))
    (tmp_path / "mine.urdf").write_text(small.gripper())
    port = str(servers.free_port())
    assert cli.main(["robot", "inspect", "mine.urdf", "--serve", port]) == 130
    out = capsys.readouterr().out
    assert "written: mine/mine.srdf" in out
    assert f"http://localhost:{port}" in out
    assert cli.main(["robot", "inspect", "mine.urdf", "-o", "other", "--serve", "70000"]) == 2
    assert not (tmp_path / "other").exists()
    assert "should be from 1 to 65535" in capsys.readouterr().err
