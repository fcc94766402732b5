# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Work of a worker process: read, plan, check and time one goal. It knows no ROS.

A worker can be killed at any time. Neither a goal that is cancelled nor a planner that dies takes
the node with it.
"""

from __future__ import annotations

import os
import re
import signal
import textwrap
import time
import warnings
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _api, perception, report, timing
from .._core.planning import OutOfTime
from ..errors import TaskError, explain
from ..kinds import part, stages_of
from ..perception.readers import view_of_grid
from ..picking import pick
from ..picking.result import FILE
from ..picking.wish import robot_of
from ..plan_files import read_plan
from ..tasks import task_from_dict
from ..tasks.reading import parse_yaml
from ..timing.squeeze import squeezed
from .jobs import CheckJob, Found, PickJob, TaskJob
from .measured import home_of, joints_of

if TYPE_CHECKING:
    from collections.abc import Callable
    from multiprocessing.connection import Connection

    from .._plan import Plan
    from ..frames import Matrix
    from ..timing import Trajectory

DESCRIPTION = "robot_description"  # robot of a task that is the robot of the node
_MARGINS = (
    "cost",
    "friction",
    "least_stability",
    "lower_bound",
    "margin",
    "min_linking",
    "opening",
    "overhang",
    "width",
    "withstands",
)  # names in the summaries of plans


def main(connection: Connection, job: TaskJob | PickJob | CheckJob) -> None:
    """Does one job: sends the phases as texts, and then what was Found."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the node decides when this ends
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    connection.send("reading")
    connection.send(done(job, connection.send))


def done(job: TaskJob | PickJob | CheckJob, tell: Callable[[str], object]) -> Found:
    """Does a job; whatever goes wrong is a status with a reason. `tell` is given the phases."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        found = _done(job, tell)
    texts = [str(each.message) for each in caught if issubclass(each.category, UserWarning)]
    found.warnings = list(dict.fromkeys([*texts, *found.warnings]))
    return found


def _done(job: TaskJob | PickJob | CheckJob, tell: Callable[[str], object]) -> Found:
    try:
        if isinstance(job, CheckJob):
            return _checked(job)
        return _planned(job, tell) if isinstance(job, TaskJob) else _picked(job, tell)
    except TaskError as error:
        return Found(reason=str(error))
    except (Exception, OutOfTime) as error:
        return Found(reason=explain(error))


def _checked(job: CheckJob) -> Found:
    faults = _api.check(read_plan(job.plan, "plan"), certify=job.certify)
    return Found("solved" if not faults else "faulty", faults=faults)


def _planned(job: TaskJob, tell: Callable[[str], object]) -> Found:
    document = parse_yaml(job.text, "task").data
    _enter(job.directory)
    if isinstance(document, dict) and isinstance(document.get("robot"), dict):
        document = document | {"robot": _robot(document["robot"], job)}
    began = time.monotonic()
    task = task_from_dict(document, "task", resolve=True)
    task = task.with_changes(seconds=job.seconds, seed=job.seed)
    tell("planning")
    search = _api.plan_certified if job.certify else _api.plan_since
    return _finished(search(task, began), Found(), job, tell)


def _enter(directory: str | None) -> None:
    """Enters the folder of the files that tasks name."""
    if directory is not None:
        os.chdir(directory)


def _robot(given: dict[str, Any], job: TaskJob) -> dict[str, Any]:
    """Returns the robot of a task, with what the node knows."""
    if given.get("urdf") == DESCRIPTION:
        if job.robot is None:
            raise TaskError(f"task: robot.urdf: {DESCRIPTION}: none was received yet")
        given = {**job.robot, **{key: value for key, value in given.items() if key != "urdf"}}
    return _at_home(given, job, "task")


def _at_home(given: dict[str, Any], job: TaskJob | PickJob, file: str) -> dict[str, Any]:
    """Returns a robot that starts where it was measured, but for the joints that it gives."""
    known = given.get("home", {})
    if job.measured is None or not isinstance(known, dict):
        return given
    home = home_of(robot_of(given, file), job.measured, job.tolerance)
    return given | {"home": home | known}


def _picked(job: PickJob, tell: Callable[[str], object]) -> Found:
    texts = {"obstacles": job.obstacles, "place": job.place}
    given = {name: _field(name, text) for name, text in texts.items() if text}
    tell("seeing")
    scene = perception.perceive_views([_view(job)])
    if not scene:
        return Found("nothing_seen", reason=f"nothing was found in the image: {scene.reason}")
    found = Found(objects=[(thing.name, np.array(thing.X_WO)) for thing in scene.objects])
    found.warnings = list(scene.warnings)
    _enter(job.directory)
    try:
        found.name = job.name or _name_at(scene, job.at)
        tell("planning")
        result = pick(
            scene,
            found.name,
            _at_home(job.robot, job, FILE),
            strategies=job.strategies,
            lift=job.lift,
            mass=job.mass,
            grip_force=job.grip_force,
            respect=job.respect,  # type: ignore[arg-type]  # it is validated there
            padding=job.padding,
            seconds=job.seconds,
            seed=job.seed,
            **given,
        )
    except TaskError as error:
        found.reason = str(error)
        return found
    found.attempts = [(a.strategy, a.status, a.reason, a.seconds) for a in result.attempts]
    found.strategy = result.strategy or ""
    if result.plan is None:
        found.status, found.reason = "not_found", result.reason
        return found
    return _finished(result.plan, found, job, tell)


def _field(name: str, text: str) -> Any:
    """Returns a field of a task in YAML."""
    try:
        value = parse_yaml(f"{name}:\n{textwrap.indent(text, '  ')}", "goal").data[name]
    except TaskError as error:
        what = re.sub(r"^goal:\d+: | \(column \d+\)$", "", str(error))
        raise TaskError(f"{name}: {what}") from None
    if value is None:
        raise TaskError(f"{name}: is empty")
    return value


def _view(job: PickJob) -> perception.View:
    if job.points is None:
        assert job.depth is not None
        assert job.K is not None
        return perception.View(job.depth, job.K, job.X_WC)
    return view_of_grid(job.points, job.X_WC)


def _name_at(scene: perception.Scene, at: Matrix | None) -> str:
    """Returns the name of the object at a point, or of the only one."""
    things = list(scene.objects)
    if not things:
        raise TaskError(f"no object was seen: {scene.reason}")
    if at is None:
        if len(things) > 1:
            names = ", ".join(thing.name for thing in things)
            raise TaskError(f"name: should be one of {names}, or a point of it should be given")
        return str(things[0].name)
    near = min(things, key=lambda thing: _distance(thing, at))
    away = _distance(near, at)
    if away > 0.05:
        raise TaskError(f"at: the nearest object, {near.name}, is {100 * away:.0f} cm away")
    return str(near.name)


def _distance(thing: perception.Object, p_W: Matrix) -> float:
    """Returns the distance of a point from the points of an object that were seen [m]."""
    X_WO = np.asarray(thing.X_WO)
    p_O = (p_W - X_WO[:3, 3]) @ X_WO[:3, :3]
    low, high = np.min(thing.points, axis=0), np.max(thing.points, axis=0)
    return float(np.linalg.norm(np.maximum(np.maximum(low - p_O, p_O - high), 0.0)))


def _finished(
    plan: Plan, found: Found, job: TaskJob | PickJob, tell: Callable[[str], object]
) -> Found:
    """Checks and times a plan."""
    found.status, found.reason, found.kind = str(plan.status), plan.reason, plan.kind
    found.plan = plan.to_json()
    found.margins = margins_of(plan)
    for stage in stages_of(plan):
        found.warnings += [str(text) for text in getattr(stage, "warnings", [])]
    if not plan:
        return found
    tell("checking")
    certify = isinstance(job, TaskJob) and job.certify
    found.faults = _api.check(plan, certify=certify)
    if found.faults:
        return replace(found, status="faulty", reason=found.faults[0])
    tell("timing")
    found.status, found.reason = "solved", ""
    if not plan.joint_names:
        found.warnings.append("the plan moves no joints: its fingertips have no arm")
        return found
    found.joints = joints_of(part("timing", plan.kind).robot(plan, False))
    _take(squeezed(timing.time(plan, **job.limits), job.squeeze), found)
    return found


def _take(trajectory: Trajectory, found: Found) -> None:
    found.joint_names = list(trajectory.joint_names)
    found.times, found.positions = trajectory.times, trajectory.positions
    found.velocities, found.accelerations = trajectory.velocities, trajectory.accelerations
    found.object_poses = trajectory.object_poses
    begins = np.flatnonzero(np.diff(trajectory.segment_index, prepend=-1))
    found.phases = [(float(trajectory.times[k]), trajectory.names[k]) for k in begins]


def margins_of(plan: Plan) -> list[tuple[str, float]]:
    """Returns the figures of quality in the summary of a plan, by their place in it."""
    found: list[tuple[str, float]] = []

    def visit(place: str, value: Any) -> None:
        if isinstance(value, dict):
            for key, inner in value.items():
                visit(f"{place}.{key}" if place else key, inner)
        elif isinstance(value, list):
            for k, inner in enumerate(value):
                visit(f"{place}[{k}]", inner)
        elif place.rpartition(".")[2] in _MARGINS and isinstance(value, (int, float)):
            found.append((place, float(value)))

    summary = report.as_dict(plan)
    visit("", {key: value for key, value in summary.items() if key not in ("stats", "proof")})
    return found
