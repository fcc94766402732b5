# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Inspects the robots of a fleet, then plans slides and clasps with each."""

from __future__ import annotations

import math
import os
import re
import tempfile
import time
import warnings
from collections import Counter
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from typing import TYPE_CHECKING, Any

import graspless
from graspless import slide
from graspless.errors import TaskError
from graspless.planning import Budget
from graspless.tasks import task_from_dict
from graspless.tasks.robot_files import resolve_robot
from graspless.tasks.robots import Robot, build_robot
from graspless.tasks.source import Source

from ..bar import told
from ..statistics import quantile
from .scene import Scene

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from graspless.frames import Matrix
    from graspless.inspection import Proposal

    from ..machine import Row
    from .fleet import Member

NAME = "robot"


def run(
    fleet: Iterable[Member],
    slides: int,
    clasps: int,
    limits: tuple[float, float],
    tell: Callable[[int, str], None] = lambda done, name: None,
) -> list[Row]:
    """Returns a row for each robot.

    Parameters
    ----------
    fleet : iterable of Member
    slides, clasps : int
        Queries for each robot.
    limits : (float, float)
        Of a slide and of a clasp [s].
    tell : function
        Called with the number of robots that are done, and the next one's name.
    """
    rows = []
    for member in told(fleet, tell):
        with warnings.catch_warnings():  # of entries of stock files that are skipped
            warnings.simplefilter("ignore")
            rows.append(_measure(member, slides, clasps, limits))
    return rows


def _measure(member: Member, slides: int, clasps: int, limits: tuple[float, float]) -> Row:
    row: Row = {
        "name": member.name,
        "packages": list(member.packages),
        "by_hand": member.by_hand,
        "found": None,
        "inspect_s": None,
        "slides": None,
        "clasps": None,
        "refused": None,
    }
    begin = _processor_seconds()
    try:
        found = inspect(member)
    except PackageNotFoundError as error:
        return row | {"refused": f"{error.name} is not installed"}
    except ValueError as error:
        return row | {"refused": _first_line(error)}
    row |= {"inspect_s": _processor_seconds() - begin, "found": summary(found)}
    with tempfile.TemporaryDirectory() as folder:
        found.write(folder)
        return row | _plans(member.name, found, Path(folder), (slides, clasps), limits)


def inspect(member: Member) -> Proposal:
    """Reads the files of a robot, as `graspless robot inspect` does, and returns the proposal."""
    fields = member.resolved()
    source = Source(member.name, {"robot": fields}, is_trusted=True)
    resolved, _ = resolve_robot(Robot.model_validate(fields), source, Path())
    built = build_robot(resolved.model_copy(update={"srdf_text": None}), source, warn=False)
    return graspless.robot.inspect(built, palm=member.palm, name=NAME)


def summary(found: Proposal) -> Row:
    """Returns what was found: numbers of joints and fingers, gaps, and what is unsure."""
    robot = found.robot
    fingers = 2 if found.hand else len(found.clasp.get("fingers", ())) + 1
    return {
        "arm": len(robot.group("arm")) if "arm" in robot.group_names else 0,
        "hand": len(robot.group("hand")),
        "fingers": fingers,
        "opening_mm": [round(1000 * gap, 1) for gap in (found.largest_gap, found.smallest_gap)],
        "unsure": [finding.field for finding in found.unsure],
    }


def _plans(
    name: str, found: Proposal, folder: Path, runs: tuple[int, int], limits: tuple[float, float]
) -> Row:
    if not {"home", "open"} <= set(found.robot.state_names) or "arm" not in found.robot.group_names:
        return {"refused": found.refusal("slide") if not found.hand else "home: none was found"}
    scene = Scene(found, str(folder / f"{NAME}.urdf"))
    row: Row = {"slides": None, "clasps": None}
    if found.hand:
        row["slides"] = _plan_slides(scene, name, runs[0], limits[0])
    if found.clasp:
        row["clasps"] = _plan_clasps(scene, runs[1], limits[1])
    parts = (part for part in row.values() if part is not None)
    return row | {"refused": next((part["refused"] for part in parts if part["refused"]), None)}


def _plan_slides(scene: Scene, name: str, runs: int, limit: float) -> Row:
    """Returns counts and times of slides; `refused` has the most frequent reason."""
    times, reasons, faults = [], Counter[str](), 0
    if scene.gap > scene.thickness:
        return _refused(runs, scene.too_thin())
    try:
        task = _place_table(scene, name, limit)
    except ValueError as error:
        return _refused(runs, _first_line(error))
    options = task.options
    for number, X_SO in enumerate(scene.poses(name, runs)):
        problem = _moved(task.problem, X_SO)
        begin = time.process_time()
        plan = slide.plan(problem, options, Budget(seconds=limit, seed=number + 1))
        times.append(time.process_time() - begin if plan else math.inf)
        if plan:
            faults += bool(slide.check(problem, plan, options))
        else:
            reasons[plan.reason] += 1
    return _counted(times, faults, reasons, scene)


def _place_table(scene: Scene, name: str, limit: float) -> Any:
    """Returns the task with the table at the first place where a query is solved, or the first."""
    tasks = []
    for place in scene.places():
        scene.place = place
        task = task_from_dict(scene.slide(limit), "slide", resolve=True)
        (X_SO,) = scene.poses(f"{name}, trial", 1)
        if slide.plan(_moved(task.problem, X_SO), task.options, Budget(seconds=limit, seed=1)):
            return task
        tasks.append((place, task))
    scene.place, task = tasks[0]
    return task


def _moved(given: slide.Problem, X_SO: Matrix) -> slide.Problem:
    """Returns a problem with another pose of the object on the table."""
    X_WO = given.support.X_WS @ X_SO
    return slide.Problem(given.robot, given.hand, given.object, given.support, X_WO, given.q_home)


def _counted(times: list[float], faults: int, reasons: Counter[str], scene: Scene) -> Row:
    def ms(fraction: float) -> float | None:
        seconds = quantile(times, fraction)
        return round(1000 * seconds, 1) if math.isfinite(seconds) else None

    solved = sum(map(math.isfinite, times))
    return {
        "runs": len(times),
        "solved": solved,
        "p50_ms": ms(0.5),
        "p99_ms": ms(0.99),
        "faults": faults,
        "thickness_mm": round(1000 * scene.thickness, 1),
        "refused": reasons.most_common(1)[0][0] if reasons else None,
    }


def _plan_clasps(scene: Scene, runs: int, limit: float) -> Row:
    solved, faults, reasons = 0, 0, Counter[str]()
    for number in range(runs):
        try:
            plan: Any = graspless.plan(scene.clasp(limit, number))
        except (TaskError, ValueError) as error:
            return _refused(runs, _first_line(error))
        if plan:
            solved += 1
            faults += bool(graspless.check(plan))
        else:
            reasons[plan.reason] += 1
    reason = reasons.most_common(1)[0][0] if reasons else None
    return {"runs": runs, "solved": solved, "faults": faults, "refused": reason}


def _processor_seconds() -> float:
    """Returns the processor time of this process and its children [s], to about 0.01 s."""
    return sum(os.times()[:4])


def _refused(runs: int, reason: str) -> Row:
    return {
        "runs": runs,
        "solved": 0,
        "p50_ms": None,
        "p99_ms": None,
        "faults": 0,
        "thickness_mm": None,
        "refused": reason,
    }


def _first_line(error: Exception) -> str:
    """First line of a message, with the names of files instead of their paths."""
    return re.sub(r"(/[^\s/:]+)+/", "", str(error).splitlines()[0])
