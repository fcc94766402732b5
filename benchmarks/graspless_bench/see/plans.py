# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times from depth images to plans that are checked: slides of cards, and clasps of handles."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import clasp, frames, geometry, perception, slide
from graspless._core import clasp as clasp_core  # the file's numbers are not wanted
from graspless._core import slide as slide_core
from graspless.planning import Budget

from ..clasp.grid import POSES, START, placed, robot_with_hand
from ..slide.grid import HOME, robot
from . import own
from .holes import standing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from graspless.frames import Matrix

    from ..machine import Row

CARDS = 30
NAMES = ("kettle", "bucket", "pitcher", "basket of 2 with handle", "bag of two handles", "crate")
SECONDS = 10.0  # limit of a query
STAGES = ("perceive", "problem", "plan", "check")  # problem: with the loops of a clasp


def count() -> int:
    """Returns the number of trials."""
    return 2 * (CARDS + len(NAMES) * len(POSES["purse"]))


def run(tell: Callable[[int], object] = lambda done: None) -> list[Row]:
    """Returns one row per trial, with one view and two."""
    rows: list[Row] = []
    for trials in (_slides(), _clasps()):
        for row in trials:
            rows.append(row)
            tell(len(rows))
    return rows


def _slides() -> Iterator[Row]:
    """Boxes of random sizes on a table before a WAM, slid over any edge that is real."""
    rng = np.random.default_rng(1)
    for trial in range(CARDS):
        x, y, yaw = rng.uniform([0.55, -0.15, 0], [0.75, 0.15, math.pi])
        size = rng.uniform([0.09, 0.05, 0.005], [0.15, 0.1, 0.012])
        X_WO = frames.planar(x, y, yaw)
        X_WO[2, 3] = size[2] / 2
        bodies = [_block(size, X_WO), *_table(0.7)]
        cameras = [[-0.05, 0, 0.75], [1.3, 0.2, 0.7]]
        images = _images(bodies, cameras, [0.62, 0, 0], trial)
        for views in (1, 2):
            yield _timed("slide", images[:views], _slide)


def _clasps() -> Iterator[Row]:
    """Objects with handles that stand on a table before a KR 5 with an SDH."""
    for name in NAMES:
        mesh = standing(own.mesh_of(own.by_name()[name]))
        for pose, place in enumerate(POSES["purse"], 1):
            body = perception.Body([geometry.PlacedShape(mesh)], placed(place))
            middle = np.array([place[0], place[1], 0.1])
            cameras = [
                middle + [0.6 * math.cos(angle), 0.6 * math.sin(angle), 0.45]
                for angle in (0.7 * pose, 0.7 * pose + 2 * math.pi / 3)
            ]
            images = _images([body, *_table(0.9)], cameras, middle, pose)
            for views in (1, 2):
                yield _timed("clasp", images[:views], _clasp)


def _timed(kind: str, images: list[perception.Frame], ask: Callable[..., Any]) -> Row:
    """Times all stages from the images on."""
    times = [time.perf_counter()]
    scene = perception.perceive_views(
        [perception.View(image.depth, image.K, image.X_WC) for image in images]
    )
    times.append(time.perf_counter())
    row: Row = {"kind": kind, "views": len(images), "is_checked": False}
    things = [thing for thing in scene.objects if thing.support]
    if not things:
        return row
    core, problem = ask(scene, max(things, key=lambda thing: len(thing.points)))
    times.append(time.perf_counter())
    plan = core.plan(problem, core.Options(), Budget(seconds=SECONDS, seed=1))
    times.append(time.perf_counter())
    if not plan:
        return row
    row["is_checked"] = core.check(problem, plan) == []
    times.append(time.perf_counter())
    row |= dict(zip(STAGES, np.diff(times), strict=True))
    return row | {"seconds": times[-1] - times[0]}


def _slide(scene: perception.Scene, thing: perception.Object) -> tuple[Any, slide.Problem]:
    table = next(support for support in scene.supports if support.name == thing.support)
    real = [i for i, label in enumerate(table.edges) if str(label) == "real"]
    support = slide.Support(np.asarray(table.polygon), table.X_WS, usable_edges=real)
    card = slide.Object.from_polygon(thing.name, np.asarray(thing.outline), thing.thickness)
    return slide_core, slide.Problem(robot(), slide.Hand(), card, support, thing.X_WO, HOME)


def _clasp(_scene: perception.Scene, thing: perception.Object) -> tuple[Any, clasp.Problem]:
    arm, hand = robot_with_hand("kr5_sdh")
    q_start = np.array(arm.state(hand.open))
    q_start[arm.group(hand.arm)] = START
    table = _table(0.9)[0]
    below = clasp.Obstacle("table", table.shapes, frames.translation([0.65, 0, -0.017]))
    seen = clasp.Object.from_cloud(thing.name, thing.points, rays=list(thing.rays))
    return clasp_core, clasp.Problem(arm, hand, seen, thing.X_WO, q_start, [below])


def _table(depth: float) -> list[perception.Body]:
    """Returns a table whose top is at z = 0, and the floor."""
    return [
        _block([0.7, depth, 0.03], frames.translation([0.65, 0, -0.015])),
        _block([6, 6, 0.02], frames.translation([0.65, 0, -0.41])),
    ]


def _block(size: Any, X_WB: Matrix) -> perception.Body:
    return perception.Body([geometry.PlacedShape(geometry.Box(np.asarray(size)))], X_WB)


def _images(
    bodies: list[perception.Body], cameras: Any, towards: Any, seed: int
) -> list[perception.Frame]:
    poses = [perception.look_at(camera, towards) for camera in cameras]
    return [perception.render(bodies, pose, seed=10 * seed + k) for k, pose in enumerate(poses)]


def tables(rows: list[Row]) -> dict[str, list[Row]]:
    """Returns medians by kind and number of views."""
    found = []
    for kind in ("slide", "clasp"):
        for views in (1, 2):
            some = [row for row in rows if row["kind"] == kind and row["views"] == views]
            done = [row for row in some if row["is_checked"]]
            sums: Row = {"name": kind, "views": views, "trials": len(some), "checked": len(done)}
            for stage in (*STAGES, "seconds"):
                sums[stage] = float(np.median([row[stage] for row in done])) if done else None
            sums["p90"] = float(np.percentile([r["seconds"] for r in done], 90)) if done else None
            found.append(sums)
    return {"plans": found}
