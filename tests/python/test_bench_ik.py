# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The comparison of inverse kinematics in small. The peers take part where they are installed."""

import json

import numpy as np
import pytest

from graspless.cli import main
from graspless.robot import Robot
from graspless_bench import ik


def test_our_solutions_are_right_and_complete(capsys):
    assert main(["bench", "ik", "--poses", "20", "--json"]) == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)}
    for arm in ("KR 5 sixx R850: graspless", "UR5e: graspless", "Panda: graspless, one value"):
        assert rows[arm]["wrong"] == rows[arm]["missed"] == 0
        assert 1 <= rows[arm]["solutions"] <= 8
    assert rows["Panda: graspless, 16 values"]["missed"] is None


def test_wrong_repeated_and_missing_solutions_are_counted():
    robot = Robot.from_urdf(ik.urdf_of(ik.ARMS["UR5e"]))
    (ours,) = ik.ours(robot)
    shifted = ik.Solver("shifted", ours.forward, lambda X, q: q[None] + [0.1, 0, 0, 0, 0, 0])
    row = ik.measure(shifted, 6, 5)
    assert (row["solutions"], row["wrong"], row["missed"]) == (0, 5, 5)
    twice = ik.Solver("twice", ours.forward, lambda X, q: np.stack([q, q]))
    row = ik.measure(twice, 6, 5)
    assert (row["solutions"], row["wrong"], row["missed"]) == (1, 5, 0)


def test_poses_must_be_positive(capsys):
    with pytest.raises(SystemExit) as caught:
        main(["bench", "ik", "--poses", "0"])
    assert caught.value.code == 2
    assert "--poses" in capsys.readouterr().err
