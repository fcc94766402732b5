# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to break a fingertip plan whose forces matter."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import Mutant, block, keep_rows

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...machine import Row


def _each(name: str, change: Callable[[Any, Row, int], Any]) -> Callable[[Row], None]:
    """Returns a change of a field of every row and finger; it is given value, segment and row."""

    def apply(document: Row) -> None:
        for segment in document["segments"]:
            segment[name] = [
                [change(value, segment, k) for value in row] for k, row in enumerate(segment[name])
            ]

    return apply


def _of_one_finger(name: str, change: Callable[[Any, Any], Any]) -> Callable[[Row], None]:
    """Returns a change of a field of the first finger in every row, given value and normal."""

    def apply(document: Row) -> None:
        for segment in document["segments"]:
            for row, normals in zip(segment[name], segment["normals"], strict=True):
                row[0] = change(row[0], normals[0])

    return apply


def _shifted(point: list[float], normal: list[float]) -> list[float]:
    """Returns a point 12 mm nearer to the middle of a block's face, along one of its axes."""
    axis = max(range(3), key=lambda i: abs(point[i]) * (abs(normal[i]) < 0.5))
    way = -0.012 if point[axis] > 0 else 0.012
    return [x + (way if i == axis else 0.0) for i, x in enumerate(point)]


def _lifted_off(point: list[float], normal: list[float]) -> list[float]:
    return [x - 0.004 * n for x, n in zip(point, normal, strict=True)]


def _other_mode(mode: str, *_: Any) -> str:
    return "force" if mode == "position" else "position"


def _half_way(document: Row) -> None:
    """The object jumps over the middle third of the longest segment."""
    segment = max(document["segments"], key=lambda s: len(s["object_poses"]))
    count = len(segment["object_poses"])
    kept = [*range(count // 3), *range(2 * count // 3, count)]
    poses = segment["X_WO"]
    keep_rows(segment, kept)
    third = len(poses) // 3
    segment["X_WO"] = poses[: third + 1] + poses[2 * third + 1 :]
    rows = [
        (z, i, k) for i, s in enumerate(document["segments"]) for k, z in enumerate(s["stability"])
    ]
    document["weakest"] = dict(zip(("segment", "row"), min(rows)[1:], strict=True))


def _scaled(factor: float) -> Callable[[Any, Row, int], Any]:
    def change(value: Any, _: Row, __: int) -> Any:
        return [factor * x for x in value] if isinstance(value, list) else factor * value

    return change


def _no_forces(document: Row) -> None:
    for name in ("commanded_forces", "nominal_forces"):
        _each(name, _scaled(0.0))(document)


def _task(factor: float, *path: str) -> Callable[[Row], None]:
    """Returns a change of a number of the task, or of both ends of an interval, by a factor."""

    def change(document: Row) -> None:
        inner = document["task"]
        for name in path[:-1]:
            inner = inner[name]
        value = inner[path[-1]]
        inner[path[-1]] = [factor * v for v in value] if isinstance(value, list) else factor * value

    return change


def _obstacle(document: Row) -> None:
    segment = max(document["segments"], key=lambda s: len(s["object_poses"]))
    block(document, segment["object_poses"][len(segment["object_poses"]) // 2][:3], 0.02)


def _claimed(document: Row) -> None:
    for segment in document["segments"]:
        segment["stability"] = [2 * z for z in segment["stability"]]


def _cheaper(document: Row) -> None:
    document["cost"] /= 2
    document["lower_bound"] /= 2


WORLD = "the motion and the forces are as before"
FED = "the executor feeds the nominal forces forward in both modes"
LESS = "the object is stable with the finger there, too, only less than the plan says"
COMES = "the executor brings the fingers on until they press with their forces"
MUTANTS = [
    Mutant(
        "no forces",
        "commanded and nominal forces are 0",
        _no_forces,
    ),
    Mutant("no feed-forward", "nominal forces are 0", _each("nominal_forces", _scaled(0.0))),
    Mutant(
        "weak feed-forward",
        "nominal forces are 0.3 times as large",
        _each("nominal_forces", _scaled(0.3)),
    ),
    Mutant(
        "strong feed-forward",
        "nominal forces are 3 times as large",
        _each("nominal_forces", _scaled(3.0)),
    ),
    Mutant("modes", "position and force control are exchanged", _each("modes", _other_mode), FED),
    Mutant(
        "shifted finger",
        "the first finger touches 12 mm nearer to the middle of the face",
        _of_one_finger("fingers", _shifted),
        LESS,
    ),
    Mutant(
        "finger off",
        "the first finger stays 4 mm off the surface",
        _of_one_finger("fingers", _lifted_off),
        COMES,
    ),
    Mutant(
        "turned normal",
        "the normals of the first finger point outwards",
        _of_one_finger("normals", lambda n, _: [-x for x in n]),
    ),
    Mutant(
        "slippery fingers",
        "friction of the fingers is 0.3 times as large",
        _task(0.3, "fingers", "friction"),
    ),
    Mutant("heavy", "the object has 3 times its mass", _task(3.0, "object", "mass")),
    Mutant(
        "weak fingers",
        "the force limit is 0.3 times as large",
        _task(0.3, "fingers", "max_normal_force"),
    ),
    Mutant("jump", "the middle third of the longest segment is missing", _half_way),
    Mutant("obstacle", "a cube of 20 mm stands in the way", _obstacle),
    Mutant("stability", "the plan claims twice its stability", _claimed, WORLD),
    Mutant("cost", "the plan claims half its cost", _cheaper, WORLD),
]
