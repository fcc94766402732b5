# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""graspless.plan and graspless.check: any task by the planner of its kind."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any, overload

from . import limits, planning, proving
from ._arguments import require_finite, require_number, require_type
from ._load import as_task
from .errors import TaskError, shown
from .kinds import plan_type
from .plan_files import as_plan
from .proving import proof

MOST_SEEDS = 20  # of a search for a plan that is certified
SEEDS = 2**64  # number of seeds
NO_JOINTS = (
    "not certified: bare fingertips have no joint paths, so nothing between the rows is proven; "
    "give the task a robot"
)

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from typing_extensions import TypedDict, Unpack

    from . import carry, clasp, fingertip, pinch, slide
    from ._plan import Plan
    from .scene import EdgeCertificate
    from .tasks import PlanT, Task

    class Given(TypedDict, total=False):
        """Parameters of `plan` beside the task."""

        search: str | None
        seconds: float | None
        iterations: int | None
        seed: int | None
        budget: planning.Budget | None
        certify: bool
        prove: int | None
        jobs: int


@overload
def plan(task: Task[Any, Any, PlanT], **given: Unpack[Given]) -> PlanT: ...
@overload
def plan(  # type: ignore[overload-overlap]  # a pinch.Problem is a slide.Problem, too
    task: pinch.Problem, **given: Unpack[Given]
) -> pinch.Plan: ...
@overload
def plan(task: slide.Problem, **given: Unpack[Given]) -> slide.Plan: ...
@overload
def plan(task: fingertip.Problem, **given: Unpack[Given]) -> fingertip.Plan: ...
@overload
def plan(task: clasp.Problem, **given: Unpack[Given]) -> clasp.Plan: ...
@overload
def plan(task: carry.Problem, **given: Unpack[Given]) -> carry.Plan: ...
@overload
def plan(task: str | Path | Mapping[str, Any], **given: Unpack[Given]) -> Plan: ...
def plan(
    task: Any,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
    certify: bool = False,
    prove: int | None = None,
    jobs: int = 1,
) -> Any:
    """Plans a task. Not finding a plan is a status, never an exception.

    Parameters
    ----------
    task : Task, Problem of any planner, dict, str or Path
        A task; a problem made in Python; the fields of a task file, also of numpy; or its name.
    search : str, optional
        Search algorithm instead of the task's: "paper" or "fast" of a slide, and also "dijkstra" of
        a fingertip task. The other kinds have one algorithm and refuse a name.
    seconds : float, optional
        Limit of time instead of the task's, finite and above 0 [s].
    iterations : int, optional
        Largest number of iterations instead of the task's.
    seed : int, optional
        Seed instead of the task's, from 0 to 2^64 - 1.
    budget : planning.Budget, optional
        Instead of all three; another thread may stop() it.
    certify : bool
        Prove the plan between its rows, too, as `check` does. While an edge is not proven, the
        search goes on with other seeds within `seconds`. It returns the plan with the fewest
        doubts, which `check(plan, certify=True)` lists.
    prove : int, optional
        Simulate the plan, once as planned and in this number of varied trials. While a trial fails,
        the search goes on with other seeds, and returns the plan that held in the most trials.
        `seconds` limits all of it then, 600 s by default; a search has the task's own limit at
        most. Ctrl-C returns the best plan so far.
    jobs : int
        Number of processes that simulate.

    Returns
    -------
    slide.Plan, pinch.Plan, fingertip.Plan, clasp.Plan, carry.Plan or chain.Plan
        Plan of the task's kind; false unless solved. Its `proof` has the trials of `prove`.

    Raises
    ------
    TaskError
        A ValueError: the task is not valid; or its plans cannot be simulated, but prove is given.
    OutOfTimeError
        A TaskError: the time limit was reached before the task was read.
    """
    if seconds is not None:
        require_number("seconds", seconds)
    if budget is not None:
        require_type("budget", budget, planning.Budget)
        require_finite(budget)
    with limits.reading(seconds if budget is None else budget.seconds) as clock:
        task = as_task(task)
    if budget is not None:
        if (seconds, iterations, seed) != (None, None, None):
            raise TaskError("budget: seconds, iterations and seed must not be given beside it")
        seconds, iterations, seed = budget.seconds, budget.iterations, budget.seed
    task = task.with_changes(search=search, seconds=seconds, iterations=iterations, seed=seed)
    if prove is None:
        if jobs != 1:
            raise TaskError(f"jobs: {shown(jobs)}: should be 1 without prove, whose trials they do")
        return (plan_certified if certify else plan_since)(task, clock.began, budget)
    if certify:
        raise TaskError("certify: cannot be combined with prove: each searches by its own rule")
    return proving.prove(task, prove, jobs=jobs, seconds=seconds, began=clock.began, budget=budget)


def plan_since(
    task: Task[Any, Any, Any], began: float, budget: planning.Budget | None = None
) -> Any:
    """Plans a task within the seconds that are left of its budget since `began`."""
    before = time.monotonic()
    kind = plan_type(task.kind)
    began += time.monotonic() - before  # imports do not count
    given = task.budget if budget is None else budget
    return kind._search(task, limits.rest(given, began))


def plan_certified(
    task: Task[Any, Any, Any], began: float, budget: planning.Budget | None = None
) -> Any:
    """Plans with one seed after another until every edge between rows is proven, or time ends."""
    given = task.budget if budget is None else budget
    best: Any = None
    fewest = math.inf  # doubts about the best plan
    for k in range(MOST_SEEDS):
        if best is not None and limits.is_over(given, began):
            break
        seed = (task.seed + k) % SEEDS
        part = given.part(seconds=given.seconds, seed=seed)
        plan = plan_since(task.with_changes(seed=seed), began, part)
        if best is None and not plan:
            return plan
        if not plan:
            continue
        doubts, edges = checked(plan, with_certificate=True)
        number = math.inf if edges is None else len(doubts)  # faults are worse than doubts
        if best is None or number < fewest:
            best, fewest = plan, number
        if all(doubt.endswith(NO_JOINTS) for doubt in doubts):  # no other seed is proven better
            break
    return best


def check(plan: Plan | str | Path, *, certify: bool = False) -> list[str]:
    """Replays a plan against its own task, with none of the search's code.

    Parameters
    ----------
    plan : Plan, str or Path
        A plan, or the path of its file.
    certify : bool, optional
        If the replay finds no fault, also proves what it samples: see `certify`.

    Returns
    -------
    list of str
        Faults by segment and row; empty if the plan holds and, with `certify`, every edge is
        certified, which a plan of bare fingertips never is. A plan that was changed after the
        trials of its `proof` has a fault.
    """
    return checked(plan, certify)[0]


def checked(
    plan: Plan | str | Path, with_certificate: bool
) -> tuple[list[str], tuple[int, int] | None]:
    """Returns the result of check(), and the numbers of certified edges and of all."""
    given: Any = as_plan(plan)
    if not given:
        status = f"the plan's status is {given.status}, not solved"
        return [f"nothing to check: {status}; reason: {given.reason}"], None
    faults: list[str] = given._faults()
    changed = proof.fault_of(given)
    if changed is not None:
        faults.append(changed)
    if faults or not with_certificate:
        return faults, None
    found = given._certificates()
    doubts = [f"{words}{NO_JOINTS}" for words, part in found if part is None]
    found = [(words, part) for words, part in found if part is not None]
    doubts += [f"{words}{doubt}" for words, part in found for doubt in part.doubts]
    proven = sum(part.num_certified for _, part in found)
    return doubts, (proven, sum(part.num_edges for _, part in found))


def certify(plan: Plan | str | Path) -> list[EdgeCertificate]:
    """Proves that a plan holds between its rows, too, where `check` only samples.

    An edge is the straight motion in joint space from one row to the next. It is proven if bounds
    on the motion of every pair of bodies, and on every quantity that must stay in a band, leave no
    room for a fault at any time. Edges are divided down to motions of 1e-6 m. An edge that is not
    proven is either refuted, with a configuration that is at fault, or undecided.

    Parameters
    ----------
    plan : Plan, str or Path
        A plan that `check` finds no fault in, or the path of its file.

    Returns
    -------
    list of scene.EdgeCertificate
        One for a slide, pinch, clasp or carry plan, and for a fingertip plan with a robot; none for
        a fingertip plan without; those of all stages for a chain.

    Raises
    ------
    ValueError
        The plan is not solved or malformed.
    """
    given: Any = as_plan(plan)
    if not given:
        raise ValueError(f"plan: its status is {given.status}; only solved plans are certified")
    return [part for _, part in given._certificates() if part is not None]
