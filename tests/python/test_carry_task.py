# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of carrying: written and read again, and the faults of their files."""

import contextlib
import pickle
import re
import warnings

import pytest

from graspless import TaskError, carry, collision, frames, geometry, robot
from graspless.tasks import Task, read_task, task_from_dict
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


GOOD = """\
kind: carry
robot:
  urdf: wam_t42
frame: grasp
object: {name: bar, box: [0.02, 0.02, 0.1]}
pose: {}
offset: [0, 0, 0.1]
obstacles:
  - {name: block, box: [0.1, 0.1, 0.1]}
  - {name: post, box: [0.1, 0.1, 0.1], pose: {position: [0, 0, 1]}}
"""


@pytest.mark.parametrize(
    ("old", "new", "line", "what"),
    [
        ("post", "bar", 10, r"obstacles\[1\].name: bar: is taken by a link, another"),
        ("[0, 0, 1]", "[1.0e5, 0, 0]", 10, r"obstacles\[1\].pose: must be a rigid pose"),
        ("pose: {}", "pose: {position: [1.0e5, 0, 0]}", 6, r"pose: must be a rigid pose"),
        ("[0, 0, 0.1]", "[0, 0, 1.0e5]", 7, r"offset: must be a rigid pose"),
        ("[0, 0, 0.1]", "[0, 0, 1.0e-8]", 7, r"offset: must differ from the object's pose"),
        ("offset: [0, 0, 0.1]", "goal: {}", 7, r"goal: must differ from the object's pose"),
        (
            "obstacles:",
            "rests_on: [block, b]\nobstacles:",
            8,
            r"rests_on: .* 'b' \(one of: block, post\)",
        ),
        (
            "offset: [0, 0, 0.1]",
            "line: {direction: [0, 0, 1.0e-200], distance: 1}",
            7,
            r"line.direction: \[0.0, 0.0, 1e-200\]: must not be zero",
        ),
        (
            "offset: [0, 0, 0.1]",
            "open: [0]\nplace: {normal: [0, 0, 1.0e-200], poses: [{}]}",
            8,
            r"place.normal: \[0.0, 0.0, 1e-200\]: must not be zero",
        ),
        ("frame: grasp", "frame: base_link", 4, r"frame: base_link: "),
    ],
)
def test_a_fault_names_its_field(old, new, line, what):
    assert GOOD.count(old) == 1
    with pytest.raises(TaskError, match=rf"^task.yaml:{line}: {what}"):
        read_task(GOOD.replace(old, new), "task.yaml")


@pytest.mark.parametrize(
    ("new", "what"),
    [
        ("goal: {rpy: [0, 0, 90]}", r"goal.rpy\[2\]: 90: is more than a turn; angles are in rad"),
        ("hanging: {rpy: [90, 0, 0]}\noffset: [0, 0, 0.1]", r"hanging.rpy\[0\]: 90: is more than"),
        ("line: {direction: [0, 0, 1], distance: 200}", r"line.distance: 200: is more than 100 m;"),
        (
            "place: {poses: [{}, {rpy: [0, 0, 90]}, {rpy: [0, 0, 90]}]}",
            r"place.poses\[1\].rpy\[2\]: 90: is more than",
        ),
    ],
)
def test_degrees_and_millimetres_are_warned_of_once(new, what):
    with warnings.catch_warnings(record=True) as caught, contextlib.suppress(TaskError):
        warnings.simplefilter("always")
        read_task(GOOD.replace("offset: [0, 0, 0.1]", new), "task.yaml")
    texts = [str(one.message) for one in caught if "are in" in str(one.message)]
    assert len(texts) == 1
    assert re.search(what, texts[0])


def held_at(*position):
    """A task of a bar at a place relative to the frame of the hand, in which it would be held."""
    X_WB = X_WO @ frames.translation(position)
    p, quaternion = X_WB[:3, 3].tolist(), frames.to_quaternion(X_WB).tolist()
    return GOOD.replace("pose: {}", f"pose: {{position: {p}, quaternion: {quaternion}}}")


def test_an_object_that_the_hand_does_not_hold_is_warned_of():
    text = (
        r"^task.yaml:6: pose: the object is at least 0.75 m away from 'grasp' and the links that move "
        r"with it: nothing there holds it; check pose and robot.home$"
    )
    with pytest.warns(UserWarning, match=text):
        read_task(held_at(0, 0, 0.8), "task.yaml")
    with pytest.warns(UserWarning, match=r"the object is at least 0.035 m away"):
        read_task(held_at(0, 0, 0.085), "task.yaml")


@pytest.mark.parametrize(
    "position",
    [(0, 0, 0), (0, 0, 0.075), (0.06, 0, -0.1), (0, 0, -0.25)],
    ids=["held", "before", "beside", "at the palm"],
)
def test_an_object_near_a_link_of_the_hand_is_not_warned_of(position):
    read_task(held_at(*position), "task.yaml")


def test_obstacles_in_millimetres_are_warned_of():
    wall = "obstacles:\n  - {name: wall, box: [20, 800, 600]}\n"
    text = held_at(0, 0, 0).replace("obstacles:\n", wall)
    with pytest.warns(UserWarning, match=r"obstacles\[0\].box\[1\]: 800: is more than 100 m;"):
        read_task(text, "task.yaml")
