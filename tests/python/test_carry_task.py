# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of carrying: written and read again, and the faults of their files."""

import pickle

import pytest

from graspless import carry, collision, frames, geometry, robot
from graspless.tasks import Task, task_from_dict
from graspless.tasks.statement import difference

ARM = robot.Robot.from_urdf_file(str(robot.builtin("wam_t42")))
Q = ARM.state("home")
X_WO = ARM.pose("grasp", Q)
TURNED = frames.translation([0.1, 0, -0.05]) @ X_WO


def body(name, size, X_WB):
    return collision.Obstacle(name, [geometry.PlacedShape(geometry.Box(size))], X_WB)


def places(**more):
    return carry.Places(TURNED[None], "table", ARM.state("open"), **more)


@pytest.mark.parametrize(
    "given",
    [
        {"X_WO_goal": TURNED},
        {"X_WO_goal": TURNED, "X_WO_hanging": frames.translation([0, 0, -0.01]) @ X_WO},
        {"places": places()},
        {"places": places(normal_W=[0, -0.6, 0.8], way_out=[Q, Q + 0.1])},
        {"places": places(down_O=X_WO[:3, :3].T @ [0, 0.6, -0.8])},
    ],
    ids=["straight", "hanging", "places", "way_out", "down"],
)
def test_a_problem_reads_as_it_was_written(given):
    table = body("table", [0.5, 0.5, 0.1], frames.translation([0, 0, -1]))
    bar = body("bar", [0.02, 0.02, 0.1], X_WO)
    common = {"robot": ARM, "frame": "grasp", "object": bar, "q_start": Q, "obstacles": [table]}
    problem = carry.Problem(**{"X_WO_goal": None} | common | given)
    task = Task.of(problem)
    again = task_from_dict(task.to_dict(), "task")
    assert difference(problem, again.problem, "problem") is None
    assert pickle.loads(pickle.dumps(task)) == task
