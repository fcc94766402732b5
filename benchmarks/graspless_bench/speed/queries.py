# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Queries whose times matter. Older builds must answer them too: they use little of the library."""

from __future__ import annotations

import dataclasses
import itertools
import math
import tempfile
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import graspless
from graspless import _data, clasp, geometry, slide
from graspless._core import clasp as core_clasp  # plans without their files' documents
from graspless._core import fingertip as core_fingertip
from graspless._core import slide as core_slide
from graspless.errors import TaskError

from ..clasp import grid as clasps
from ..fingertip import grid as fingertips
from ..slide.shapes import TABLES

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

SEED = 7  # of the starts of slides
PAPER_SECONDS = 1.0  # limit of Algorithm 1 as written
CHECKED = 20  # plans
NEW_CLOUD = 1e-9  # shift of a cloud in each run [m]


class Done(NamedTuple):
    """End of a run.

    Attributes
    ----------
    is_good : bool
        There is a result.
    value : float
        A number of the result: a cost, a length. Builds with the same results have the same.
    seconds : float or None
        The time that counts, if not that of the whole call [s].
    """

    is_good: bool
    value: float
    seconds: float | None = None


@dataclasses.dataclass(frozen=True)
class Query:
    """A query, for one or many problems.

    Attributes
    ----------
    name : str
        Name in results.
    make : function
        Returns a run for each problem. Only the runs are timed.
    is_wall : bool
        Measure wall clock: for several threads.
    room : str
        Namespace inside whose `plan` a profile counts; empty: it is not profiled.
    profiled : function or None
        Makes the runs of a profile, if they are not those of `make`.
    """

    name: str
    make: Callable[[], Iterable[Callable[[], Done]]]
    is_wall: bool = False
    room: str = ""
    profiled: Callable[[], Iterable[Callable[[], Done]]] | None = None


def _slides(
    runs: int, plan: Any, seconds: float = 10, **terms: Any
) -> Iterator[Callable[[], Done]]:
    from ..slide import grid as slides  # older builds lack some of its names

    tables = ("square",) if "arm" in terms else tuple(TABLES)
    for start in slides.starts(runs, SEED, tables=tables):
        trial = slides.Trial(start, **terms)
        problem, options = trial.make_problem(), trial.make_options()
        budget = trial.make_budget(seconds)
        yield partial(_path, plan, problem, options, budget)


def _path(plan: Any, *arguments: Any) -> Done:
    return _planned(plan(*arguments))


def _planned(plan: Any) -> Done:
    """A plan with joint paths; the sum of all their numbers stands for it."""
    return Done(bool(plan), sum(float(part.positions.sum()) for part in plan.segments))


def _fingertips(*documents: dict[str, Any], **options: Any) -> Callable[[], list[Any]]:
    """Plans them all in one run."""

    def make() -> list[Any]:
        changed = [d | {"options": d.get("options", {}) | options} for d in documents]
        tasks: list[Any] = [fingertips.Trial("speed", d).make_task() for d in changed]

        def run() -> Done:
            plans = [core_fingertip.plan(t.problem, t.options, t.budget) for t in tasks]
            return Done(all(plans), sum(plan.cost for plan in plans if plan))

        return [run]

    return make


def _carried() -> Iterator[Callable[[], Done]]:
    for trial in fingertips.arm(("fast",)):
        task: Any = trial.make_task()
        yield partial(_realized, task)


def _realized(task: Any) -> Done:
    arm = task.arm
    plan, paths = core_fingertip.plan_carried(
        task.problem, task.options, arm.robot, arm.carrier, arm.q_home, arm.options, task.budget
    )
    is_good = bool(plan) and paths is not None
    return Done(is_good, plan.cost if is_good else 0.0)


def _clasps(trials: Iterable[clasps.Trial], *, is_stability: bool = False) -> Iterator[Any]:
    """From a cloud to a secure plan; or the time of its stability tests alone."""
    for trial in trials:
        trial.make_problem()  # reads the robot, and makes the cloud
        yield partial(_clasped, trial, itertools.count(), is_stability)


def _clasped(trial: clasps.Trial, counter: Iterator[int], is_stability: bool) -> Done:
    problem = trial.make_problem()
    shift = NEW_CLOUD * next(counter)  # nothing is known of it, as of a camera's next cloud
    thing = clasp.Object.from_cloud(trial.object, problem.object.points + shift)
    anew = clasp.Problem(
        problem.robot, problem.hand, thing, problem.X_WO, problem.q_start, loops=problem.loops
    )
    plan = core_clasp.plan(anew, trial.make_options(), trial.make_budget(math.inf))
    seconds = plan.statistics.stability_seconds if is_stability else None
    return _planned(plan)._replace(seconds=seconds)


def _loops(name: str, points: int, **options: Any) -> Callable[[], list[Any]]:
    def make() -> list[Any]:
        cloud = geometry.sample_surface(clasp.sample_object(name), points)
        terms = geometry.LoopOptions(**options)

        def run() -> Done:
            found = geometry.shortest_loops(cloud, terms).found
            return Done(bool(found), sum(loop.length for loop in found))

        return [run]

    return make


def _checks_of_slides() -> Iterator[Callable[[], Done]]:
    from ..slide import grid as slides

    for start in slides.starts(CHECKED, SEED):
        trial = slides.Trial(start)
        problem, options = trial.make_problem(), trial.make_options()
        plan = core_slide.plan(problem, options, trial.make_budget(10))
        yield partial(_checked, core_slide.check, problem, plan, options)


def _check_of_a_tumble() -> Iterator[Callable[[], Done]]:
    task: Any = fingertips.Trial("speed", fingertips.CASES["c"]).make_task()
    plan = core_fingertip.plan(task.problem, task.options, task.budget)
    yield partial(_checked, core_fingertip.check, task.problem, plan, task.options)


def _checks_of_clasps() -> Iterator[Callable[[], Done]]:
    for trial in itertools.islice(clasps.paper(1), 0, None, 4):
        problem, options = trial.make_problem(), trial.make_options()
        plan = core_clasp.plan(problem, options, trial.make_budget(None))
        yield partial(_checked, core_clasp.check, problem, plan, options) if plan else _nothing


def _checked(check: Any, *arguments: Any) -> Done:
    faults = check(*arguments)
    return Done(not faults, len(faults))


def _nothing() -> Done:
    """The answer where there is no plan to check."""
    return Done(False, 0.0)


def _plan_file() -> list[Callable[[], Done]]:
    """Saves and loads the plan of an example."""
    task = graspless.load_task(_data.directory("examples") / "01_slide_card.yaml", "slide")
    plan: Any = graspless.plan(task)

    def run() -> Done:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "plan.json"
            plan.save(path)
            return _planned(graspless.load_plan(path))

    return [run]


CASES = fingertips.CASES
FOUR = CASES["a"] | {"fingers": CASES["a"]["fingers"] | {"count": 4}}
TWICE = {trial.case: trial.document for trial in fingertips.faces(("fast",))}["two tumbles"]
LATTICE = fingertips.slide_and_turn(30)

QUERIES = (
    Query("slide", lambda: _slides(200, slide.plan)),
    Query("slide, in C++", lambda: _slides(200, core_slide.plan), room="slide"),
    Query("slide, UR5e", lambda: _slides(50, core_slide.plan, range=0.0, arm="ur5e")),
    Query(
        "slide, search: paper", lambda: _slides(40, core_slide.plan, PAPER_SECONDS, method="paper")
    ),
    Query("slide: check", _checks_of_slides),
    Query("slide: plan file saved and loaded", _plan_file),
    Query("fingertip: a, b, c, d", _fingertips(*(CASES[c] for c in "abcd")), room="fingertip"),
    Query("fingertip: c, d", _fingertips(CASES["c"], CASES["d"]), is_wall=True),
    Query(
        "fingertip: c, d, two threads",
        _fingertips(CASES["c"], CASES["d"], threads=2),
        is_wall=True,
    ),
    Query("fingertip: two tumbles", _fingertips(TWICE)),
    Query("fingertip: d, 23 locations a side", _fingertips(CASES["d"], locations_per_side=23)),
    Query("fingertip: d, 31 locations a side", _fingertips(CASES["d"], locations_per_side=31)),
    Query("fingertip: a, four fingers", _fingertips(FOUR)),
    Query("fingertip: slide and turn, 30^3", _fingertips(LATTICE)),
    Query("fingertip: 20 blocks by an arm", _carried),
    Query("fingertip: check of c", _check_of_a_tumble),
    Query(
        "clasp: cloud to secure plan",
        lambda: _clasps(clasps.paper(1)),
        room="clasp",
        # Valgrind only rounds to the nearest number, and CGAL's hulls fail with most other objects.
        profiled=lambda: _clasps([next(clasps.paper(1))]),
    ),
    Query(
        "clasp: stability tests of a plan",
        lambda: _clasps(clasps.paper(1), is_stability=True),
        is_wall=True,
    ),
    Query("clasp: chair detour", lambda: _clasps(clasps.chair(3))),
    Query("clasp: check", _checks_of_clasps),
    Query("loops: purse, 10,000 points, exact", _loops("purse", 10_000, max_points=20_000)),
    Query("loops: chair, 10,000 points, exact", _loops("chair", 10_000, max_points=20_000)),
    Query("loops: purse, 100,000 points", _loops("purse", 100_000)),
    Query("loops: chair, 100,000 points, polished", _loops("chair", 100_000, polish=True)),
)
OF_NAME = {query.name: query for query in QUERIES}


def chosen(name: str | None) -> Sequence[Query]:
    """Returns the queries whose names begin so, or all."""
    queries = [query for query in QUERIES if query.name.startswith(name or "")]
    if not queries:
        names = ", ".join(repr(query.name) for query in QUERIES)
        raise TaskError(f"--query: {name!r}: should be the beginning of one of {names}")
    return queries
