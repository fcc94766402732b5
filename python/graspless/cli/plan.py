# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless plan`."""

from __future__ import annotations

import argparse
import json
import sys
from typing import Any

from .._commands import (
    FOUND,
    INTERRUPTED,
    NOT_FOUND,
    add_seconds,
    add_trust,
    exit_codes,
    read_stdin,
    require_apart,
)
from .._pictures import add_pictures, check_pictures, draw
from ..errors import TaskError
from ..kinds import part, stages_of
from ..proving.cli import add_jobs, add_prove, searched


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `plan`."""
    parser.description = (
        "Plan a task, check the plan and write it. A plan file is written even if no plan\n"
        "was found: it says why, and an existing solved plan is kept as NAME~."
    )
    codes = exit_codes(
        "no plan was found, or a plan fails its check or, with --prove, a trial,\n"
        "       or is not certified with --certify"
    )
    parser.epilog = f"{codes}\n\nexample: graspless plan task.yaml -o plan.json --html plan.html"
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument(
        "task", metavar="TASK.yaml", help="task file (docs/task-files.md); - for stdin"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        default="plan.json",
        help="plan file to write (default: %(default)s); - for stdout, with the summary on stderr",
    )
    parser.add_argument(
        "--seed", type=int, metavar="N", help="seed of the random numbers, overrides the task"
    )
    add_seconds(
        parser,
        "time limit [s], overrides the task; with --prove, of all searches and trials together "
        "(default then: 600)",
    )
    parser.add_argument(
        "--iterations",
        type=int,
        metavar="N",
        help="maximum number of iterations of the search, overrides the task",
    )
    parser.add_argument(
        "--search",
        choices=["dijkstra", "paper", "fast"],
        help="search algorithm: the fast one (default), the one of the paper, or dijkstra "
        "(fingertip tasks only); kinds other than slide and fingertip have a single algorithm",
    )
    parser.add_argument(
        "--certify",
        action="store_true",
        help="also prove the plan between its rows, and search with other seeds until it is proven "
        "(docs/howto/certify.md); exit code 1 if it is not",
    )
    add_prove(parser)
    add_jobs(parser)
    add_trust(parser)
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    add_pictures(parser)
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .. import _api, files, limits, report
    from .._load import load_task
    from ..plan_files import keep_solved
    from ..tasks import read_task

    to_stdout = options.output == "-"
    if not to_stdout:
        files.check_writable(options.output)
    check_pictures(options)
    with limits.reading(options.seconds, alarm=True) as clock:
        if options.task != "-":
            given = load_task(options.task, trust=options.trust)
        else:
            given = read_task(read_stdin(), "stdin", trust=options.trust)
        require_apart(options)
        task = _change(given, options)
    plan = searched(task, clock.began, options)
    faults, edges = _api.checked(plan, options.certify) if plan else ([], None)
    # Files first: who reads our output may go at any time.
    kept = None if plan or to_stdout else keep_solved(options.output)
    if not to_stdout:
        plan.save(options.output)
    written = [] if to_stdout else [options.output]
    try:
        written += draw(plan, options)
    finally:
        if to_stdout:
            files.to_stdout(plan.to_json())
        summary = [report.as_text(plan, _told(plan)), report.verdict(plan, faults, edges)]
        if kept is not None:
            summary.append(f"kept: {kept}, the solved plan that was there before")
        summary += [f"written: {path}" for path in written]
        if options.json:
            others = {"faults": faults, "kept": [str(kept)] if kept else []}
            summary = [json.dumps(report.as_dict(plan) | others)]
        print("\n".join(summary), file=sys.stderr if to_stdout else sys.stdout)
    proof = plan.proof
    if plan.status == "interrupted" or (proof is not None and proof.ended == "interrupted"):
        return INTERRUPTED
    holds = plan and not faults and (proof is None or proof)
    return FOUND if holds else NOT_FOUND


def _told(plan: Any) -> list[str]:
    """Returns the notes of proposals, which were told as the task was read."""
    tasks = [stage.task for stage in stages_of(plan)]
    read = [task for task in tasks if "proposed" not in task.source.given()]
    return [getattr(task.fields, "proposed", None) or "" for task in read]


def _change(task: Any, options: argparse.Namespace) -> Any:
    """Returns the task with the values of the command line; errors name the flags."""
    names = ("search", "seed", "seconds", "iterations")
    flags: dict[str, Any] = {name: getattr(options, name) for name in names}
    choices = part("tasks", task.kind).SEARCHES
    if options.search not in (None, *choices):
        shown = ", ".join(choices) or "none, there is a single one"
        raise TaskError(
            f"--search: {options.search}: not a search algorithm of {task.kind} tasks "
            f"(choices: {shown})"
        )
    try:
        return task.with_changes(**flags)
    except TaskError as error:
        given = [f"--{name}" for name in flags if flags[name] is not None]
        raise TaskError(f"{', '.join(given)}: {str(error).partition(': ')[2]}") from None
