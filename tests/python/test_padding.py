# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances that motions keep from obstacles."""

import json
from pathlib import Path

import numpy as np
import pytest
import yaml

import graspless
from graspless import collision, geometry
from graspless.errors import TaskError

EXAMPLES = Path(__file__).parents[2] / "examples"
CLUTTER = (EXAMPLES / "04_clutter.yaml").read_text()
PADDING = 0.03


def padded(text: str, padding: float) -> str:
    return text.replace("- {name:", f"- {{padding: {padding}, name:")


def solved(tmp_path, text):
    (tmp_path / "task.yaml").write_text(text)
    plan = graspless.plan(tmp_path / "task.yaml", seed=1)
    assert plan, plan.reason
    assert graspless.check(plan) == []
    return plan


def from_box(points, size):
    """Distances of points [N, 3] from a box about the origin."""
    return np.linalg.norm(np.maximum(np.abs(points) - np.asarray(size) / 2, 0.0), axis=1)


def from_rod(points, radius, length):
    """Distances of points [N, 3] from a capsule along z, about the origin."""
    height = np.clip(points[:, 2], -length / 2, length / 2)
    axis = np.column_stack([np.zeros((len(points), 2)), height])
    return np.linalg.norm(points - axis, axis=1) - radius


def corners(shape):
    """Points on a shape that is in its own frame [N, 3]."""
    if isinstance(shape, geometry.Box):
        signs = np.stack(np.meshgrid(*[[-0.5, 0.5]] * 3), axis=-1).reshape(-1, 3)
        return signs * np.asarray(shape.size)
    return np.asarray(shape.vertices) if hasattr(shape, "vertices") else np.zeros((0, 3))


def least_distance(plan) -> float:
    """Least distance of corners of links and object from the box, the ball and the rod."""
    problem = plan.task.problem
    robot = problem.robot
    bodies = {body.name: body for body in problem.obstacles}
    least = np.inf
    base = {0}
    for segment in plan.segments:
        for q, X_WO in zip(segment.positions, segment.object_poses, strict=True):
            X_WL = robot.forward(q)
            points = [
                X_WL[link][:3, :3] @ (placed.X_BG[:3, :3] @ p + placed.X_BG[:3, 3])
                + X_WL[link][:3, 3]
                for link, placed in robot.shapes
                if link not in base
                for p in corners(placed.shape)
            ]
            outline = np.asarray(problem.object.outline.vertices)
            points += [
                X_WO[:3, :3] @ np.array([x, y, z]) + X_WO[:3, 3]
                for x, y in outline
                for z in (0.0, problem.object.thickness)
            ]
            p_W = np.array(points)
            for name, distance in (
                ("box", lambda p: from_box(p, [0.10, 0.16, 0.12])),
                ("ball", lambda p: np.linalg.norm(p, axis=1) - 0.04),
                ("rod", lambda p: from_rod(p, 0.02, 0.20)),
            ):
                X_WB = bodies[name].X_WB
                least = min(least, distance((p_W - X_WB[:3, 3]) @ X_WB[:3, :3]).min())
    return least


def test_motions_keep_the_padding(tmp_path):
    assert least_distance(solved(tmp_path, CLUTTER)) < PADDING
    plan = solved(tmp_path, padded(CLUTTER, PADDING))
    assert least_distance(plan) >= PADDING


def test_check_looks_for_the_padding(tmp_path):
    document = json.loads(solved(tmp_path, CLUTTER).to_json())
    for obstacle in document["task"]["obstacles"]:
        obstacle["padding"] = PADDING
    (tmp_path / "plan.json").write_text(json.dumps(document))
    faults = graspless.check(tmp_path / "plan.json")
    assert any("(padding 30 mm)" in fault for fault in faults)


def test_a_start_within_the_padding_is_refused(tmp_path):
    (tmp_path / "task.yaml").write_text(padded(CLUTTER, 0.12))
    plan = graspless.plan(tmp_path / "task.yaml", seed=1)
    assert plan.status == "start_in_collision"
    assert "(padding 120 mm)" in plan.reason


def test_certified_plans_keep_the_padding(tmp_path):
    plan = solved(tmp_path, padded(CLUTTER, 0.01))
    assert graspless.check(plan, certify=True) == []


def test_plan_files_keep_the_padding(tmp_path):
    plan = solved(tmp_path, padded(CLUTTER, 0.01))
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert [body.padding for body in again.task.problem.obstacles] == [0.01] * 4
    problem = plan.task.problem
    bare = json.loads(graspless.plan(problem, seed=1).to_json())  # of a problem, without a task
    assert [body["padding"] for body in bare["task"]["obstacles"]] == [0.01] * 4


@pytest.mark.parametrize(
    ("obstacle", "words"),
    [
        ("{name: a, box: [1, 1, 1], padding: -0.01}", "padding: -0.01: should be greater than"),
        ("{name: a, box: [1, 1, 1], padding: 5}", "padding: 5: should be less than"),
        ("{name: a, box: [1, 1, 1], padding: wide}", "padding: wide: should be a valid number"),
    ],
)
def test_bad_paddings_are_refused(tmp_path, obstacle, words):
    (tmp_path / "task.yaml").write_text(CLUTTER.split("obstacles:")[0] + f"obstacles: [{obstacle}]")
    with pytest.raises(TaskError) as error:
        graspless.load_task(tmp_path / "task.yaml")
    assert words in str(error.value)


def test_what_a_carried_object_lies_on_has_no_padding(tmp_path):
    text = (EXAMPLES / "24_carry_bar.yaml").read_text()
    solved(tmp_path, text.replace("{name: post,", "{name: post, padding: 0.01,"))
    (tmp_path / "task.yaml").write_text(
        text.replace("{name: block,", "{name: block, padding: 0.01,")
    )
    with pytest.raises(TaskError, match="'block', which must have no padding, not 0.01"):
        graspless.load_task(tmp_path / "task.yaml")


def test_a_clasp_keeps_the_padding(tmp_path):
    text = (EXAMPLES / "16_clasp_in_clutter.yaml").read_text()
    document = json.loads(solved(tmp_path, text).to_json())
    solved(tmp_path, padded(text, 0.005))
    for obstacle in document["task"]["obstacles"]:
        obstacle["padding"] = 0.2
    (tmp_path / "plan.json").write_text(json.dumps(document))
    assert any("(padding 200 mm)" in fault for fault in graspless.check(tmp_path / "plan.json"))


def test_a_block_keeps_the_padding(tmp_path):
    # The post is 8 mm beside the way of a block that is 0.10 m wide.
    post = (
        "{name: post, box: [0.02, 0.02, 0.1], pose: {position: [0.08, 0.068, 0.025]}, padding: %g}"
    )
    text = (EXAMPLES / "06_push_block.yaml").read_text() + f"obstacles: [{post}]\n"
    solved(tmp_path, text % 0.007)
    (tmp_path / "task.yaml").write_text(text % 0.009)
    with pytest.raises(TaskError, match=r"the object touches obstacle post \(padding 9 mm\)"):
        graspless.load_task(tmp_path / "task.yaml")


def test_a_pinch_keeps_the_padding(tmp_path):
    text = (EXAMPLES / "25_pinch_box.yaml").read_text()
    solved(tmp_path, padded(text, 0.005))
    document = json.loads(solved(tmp_path, text).to_json())
    for obstacle in document["task"]["obstacles"]:
        obstacle["padding"] = 0.1
    (tmp_path / "plan.json").write_text(json.dumps(document))
    assert any("(padding 100 mm)" in fault for fault in graspless.check(tmp_path / "plan.json"))


@pytest.mark.parametrize(
    ("name", "body"), [("26_pinch_then_place", "shelf"), ("21_clasp_then_drag", "floor")]
)
def test_a_chain_names_the_stage_whose_ground_has_a_padding(tmp_path, name, body):
    text = (EXAMPLES / f"{name}.yaml").read_text()
    assert f"{{name: {body}," in text
    (tmp_path / "task.yaml").write_text(
        text.replace(f"{{name: {body},", f"{{padding: 0.01, name: {body},")
    )
    with pytest.raises(TaskError, match=rf"{body}: the object stands on it, but it has a padding"):
        graspless.load_task(tmp_path / "task.yaml")


def test_reasons_name_the_padding():
    """Walls beside a box, between which the hand has room, but not twice the padding."""
    task = yaml.safe_load((EXAMPLES / "25_pinch_box.yaml").read_text())
    x, y, yaw = (task["object"]["pose"].get(key, 0.0) for key in ("x", "y", "yaw"))

    def plan(padding):
        task["obstacles"] = [
            {
                "name": f"wall {side}",
                "box": [0.3, 0.004, 0.14],
                "pose": {
                    "position": [
                        x - side * 0.11 * np.sin(yaw),
                        y + side * 0.11 * np.cos(yaw),
                        0.07,
                    ],
                    "rpy": [0, 0, yaw],
                },
                "padding": padding,
            }
            for side in (-1, 1)
        ]
        return graspless.plan(task, seed=1, seconds=20)

    assert plan(0.0)
    for padding in (0.02, 0.03, 0.04, 0.05, 0.06):
        refused = plan(padding)
        if not refused:
            break
    assert str(refused.status) == "not_reached", refused.reason
    assert refused.reason.count("a smaller padding may help") == 1


@pytest.mark.parametrize("padding", [-0.01, 0.6, np.nan])
def test_obstacles_of_python_refuse_bad_paddings(padding):
    box = [geometry.PlacedShape(geometry.Box([1, 1, 1]))]
    with pytest.raises(ValueError, match="padding of obstacle 'a' must be in"):
        collision.Obstacle("a", box, padding=padding)
