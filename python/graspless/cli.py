# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command line: the parser, and the commands plan, check, view and example."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import json
import os
import sys
import traceback
import warnings
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import __version__
from ._commands import (
    BAD_INPUT,
    CLOSED_PIPE,
    EXIT_CODES,
    FOUND,
    INTERRUPTED,
    NOT_FOUND,
    add_trust,
    read_stdin,
)
from ._given_plan import given_plan
from .errors import OutOfTimeError, TaskError, explain

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ._plan import Plan


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one command.

    Returns
    -------
    int
        0 found or holds, 1 not found or does not hold, 2 bad input or output that cannot be
        written, 130 interrupted, 141 the reader of our output has gone. After SIGTERM, __main__
        makes 143 of 130.
    """
    try:
        try:
            return _run(arguments)
        finally:  # here, not while Python ends, where it would be a traceback
            if sys.stdout is not None:
                sys.stdout.flush()
    except BrokenPipeError:  # as `head` does
        _drop_stdout()
        return CLOSED_PIPE
    except OSError as error:
        _drop_stdout()
        print(f"stdout: cannot be written: {error.strerror}", file=sys.stderr)
        return BAD_INPUT


def _run(arguments: Sequence[str] | None) -> int:
    given = list(sys.argv[1:] if arguments is None else arguments)
    command = next((word for word in given if not word.startswith("-")), "")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", UserWarning)
            warnings.showwarning = _show_warning
            options = make_parser(command).parse_args(given)
            run: Callable[[argparse.Namespace], int] = options.run
            return run(options)
    except TaskError as error:
        code = _refuse(str(error), error)
        return NOT_FOUND if isinstance(error, OutOfTimeError) else code
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        if error.filename is None:  # a stream's
            raise
        return _refuse(f"{command}: {explain(error)}", error)
    except Exception as error:  # whatever a library raises: exit code 1 would mean "not found"
        return _refuse(f"{command}: {explain(error)}", error)


def _refuse(message: str, error: Exception) -> int:
    """Prints a message, and where the error came from if the user wants to know."""
    print(message, file=sys.stderr)
    if os.environ.get("GRASPLESS_TRACEBACK"):
        traceback.print_exception(error)
    return BAD_INPUT


def _drop_stdout() -> None:
    """Discards buffered output, which Python would otherwise try to write again as it ends."""
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


def make_parser(command: str) -> argparse.ArgumentParser:
    """Returns the parser of the command line.

    Parameters
    ----------
    command : str
        The command that gets its arguments. The others have a name and a line of help only, so
        that their modules need not be imported.
    """
    parser = argparse.ArgumentParser(
        prog="graspless",
        description="Plan how a robot moves objects that it cannot simply grasp: slide them over "
        "an edge, push and tumble them with fingertips, or clasp them through a hole.",
        epilog="graspless COMMAND --help describes a command. Start with: graspless example",
    )
    parser.add_argument("--version", action="version", version=f"graspless {__version__}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for name, (about, add_arguments) in _COMMANDS.items():
        subparser = commands.add_parser(name, help=about)
        if name == command:
            add_arguments(subparser)
    return parser


def _of(module: str) -> Callable[[argparse.ArgumentParser], None]:
    """Returns a function that adds the arguments of a command with its own module."""
    return lambda parser: importlib.import_module(module, __package__).add_arguments(parser)


def _add_bench(parser: argparse.ArgumentParser) -> None:
    from importlib.util import find_spec

    if find_spec("graspless_bench") is None:
        raise TaskError(
            "bench: the experiments are not part of the installed package; "
            "`make bench-install` in a checkout of the sources adds them"
        )
    _of("graspless_bench.cli")(parser)


def _add_plan(parser: argparse.ArgumentParser) -> None:
    parser.description = (
        "Plan a task, check the plan and write it. A plan file is written in any case;\n"
        "if no plan was found, it says why."
    )
    parser.epilog = (
        f"{EXIT_CODES}\n\nexample: graspless plan task.yaml -o plan.json --html plan.html"
    )
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
    parser.add_argument(
        "--time",
        type=float,
        metavar="S",
        help="time limit [s], overrides the task; with --prove, of all searches and trials "
        "together (default then: 600)",
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
        "(fingertip tasks only); clasp tasks have a single algorithm",
    )
    from .proving.cli import add_jobs, add_prove

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
    _add_pictures(parser)
    parser.set_defaults(run=_plan)


def _add_check(parser: argparse.ArgumentParser) -> None:
    parser.description = (
        "Replay a plan against its own task, with none of the code of the search. The exit code "
        "is 1 if the plan fails its check."
    )
    parser.add_argument("plan", metavar="PLAN", help="plan file; - for stdin")
    parser.add_argument(
        "--certify",
        action="store_true",
        help="also prove that nothing touches and every band is kept between the rows; "
        "what is not proven is a fault",
    )
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.set_defaults(run=_check)


def _add_view(parser: argparse.ArgumentParser) -> None:
    parser.description = (
        "Draw a plan. Without --png and --html, a viewer with a time slider is served until Ctrl-C."
    )
    parser.add_argument("plan", metavar="PLAN", help="plan file; - for stdin")
    _add_pictures(parser)
    parser.add_argument(
        "--port", type=int, default=8080, help="port of the viewer (default: %(default)s)"
    )
    parser.set_defaults(run=_view)


def _add_example(parser: argparse.ArgumentParser) -> None:
    parser.description = "Plan, check and draw an example, into a folder of its own."
    parser.add_argument(
        "name", metavar="NAME", nargs="?", help="name, number or kind (default: the first)"
    )
    parser.add_argument("--list", action="store_true", help="list the examples")
    parser.add_argument(
        "-o", "--output", metavar="DIR", help="folder to write to (default: graspless_NAME)"
    )
    parser.set_defaults(run=_example)


def _add_pictures(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--png", metavar="FILE", help="write a picture to FILE")
    parser.add_argument(
        "--html", metavar="FILE", help="write a replay to FILE: a single page for any browser"
    )


_COMMANDS: dict[str, tuple[str, Callable[[argparse.ArgumentParser], None]]] = {
    "plan": ("plan a task and write the plan", _add_plan),
    "check": ("check a plan by replaying it", _add_check),
    "view": ("view a plan, or draw it to a file", _add_view),
    "simulate": ("execute a plan in the MuJoCo physics engine", _of(".simulation.cli")),
    "export": ("export a timed plan for ROS, MuJoCo and others", _of(".formats.cli")),
    "batch": ("plan many tasks in parallel", _of(".batches.cli")),
    "robot": ("propose, check and join descriptions of robots", _of("._robot_cli")),
    "loops": ("find the holes of a point cloud or a mesh", _of("._loops")),
    "pick": ("pick up an object of a scene by whichever way works", _of(".picking.cli")),
    "see": ("find tables and objects in depth images", _of(".perception.cli")),
    "demonstrate": ("record the planner in MuJoCo, for learners", _of("._demonstrate")),
    "ros": ("run graspless in ROS 2, or a demo of it", _of(".ros.cli")),
    "example": ("plan, check and draw an example", _add_example),
    "bench": ("repeat the papers' experiments (in a checkout)", _add_bench),
}


def _plan(options: argparse.Namespace) -> int:
    from . import _api, files, limits, report
    from ._load import load_task
    from .proving.cli import searched
    from .tasks import read_task

    to_stdout = options.output == "-"
    if not to_stdout:
        files.check_writable(options.output)
    check_pictures(options)
    with limits.reading(options.time, alarm=True) as clock:
        if options.task != "-":
            given = load_task(options.task, trust=options.trust)
        else:
            given = read_task(read_stdin(), "stdin", trust=options.trust)
        task = _change(given, options)
    plan = searched(task, clock.began, options)
    faults, edges = _api.checked(plan, options.certify) if plan else ([], None)
    # Files first: who reads our output may go at any time.
    if not to_stdout:
        plan.save(options.output)
    written = [] if to_stdout else [options.output]
    try:
        written += draw(plan, options)
    finally:
        if to_stdout:
            print(plan.to_json(), end="")
        summary = [report.as_text(plan), report.verdict(plan, faults, edges)]
        summary += [f"written: {path}" for path in written]
        if options.json:
            summary = [json.dumps(report.as_dict(plan) | {"faults": faults})]
        print("\n".join(summary), file=sys.stderr if to_stdout else sys.stdout)
    proof = plan.proof
    if plan.status == "interrupted" or (proof is not None and proof.ended == "interrupted"):
        return INTERRUPTED
    holds = plan and not faults and (proof is None or proof)
    return FOUND if holds else NOT_FOUND


def _change(task: Any, options: argparse.Namespace) -> Any:
    """Returns the task with the values of the command line; errors name the flags."""
    from .tasks.kind import searches

    flags = {"seed": options.seed, "seconds": options.time, "iterations": options.iterations}
    if options.search is not None and options.search not in (choices := searches(task.kind)):
        shown = ", ".join(choices) or "none, there is a single one"
        raise TaskError(
            f"--search: {options.search}: not a search algorithm of {task.kind} tasks "
            f"(choices: {shown})"
        )
    try:
        return task.with_changes(search=options.search, **flags)
    except TaskError as error:
        given = [
            f"--{name.replace('seconds', 'time')}" for name in flags if flags[name] is not None
        ]
        raise TaskError(f"{', '.join(given)}: {str(error).partition(': ')[2]}") from None


def _check(options: argparse.Namespace) -> int:
    from . import _api, report

    plan = given_plan(options.plan)
    faults, edges = _api.checked(plan, options.certify)
    if options.json:
        result: dict[str, Any] = {"holds": not faults, "faults": faults}
        if edges is not None:
            result |= {"certified_edges": edges[0], "edges": edges[1]}
        if plan.proof is not None:
            result["proof"] = asdict(plan.proof)
        print(json.dumps(result))
    else:
        print(report.verdict(plan, faults, edges))
    return NOT_FOUND if faults else FOUND


def _view(options: argparse.Namespace) -> int:
    check_pictures(options)
    plan = given_plan(options.plan)
    if options.png is None and options.html is None:
        from .view import serve

        serve(plan, port=options.port)
    for path in draw(plan, options):
        print(f"written: {path}")
    return FOUND


def check_pictures(options: argparse.Namespace) -> None:
    """Raises TaskError, before any planning, if a picture could not be written."""
    from . import files, view

    if options.png is not None:
        view.check_png(options.png)
        files.check_writable(options.png)
    if options.html is not None:
        view.check_html(options.html)


def draw(plan: Plan, options: argparse.Namespace) -> list[str]:
    """Writes the requested pictures; returns their paths."""
    from . import progress, view

    asked = ((options.png, view.write_png), (options.html, view.write_html))
    for path, write in asked:
        if path is not None:
            with progress.waiting(f"drawing {path}"):
                write(plan, path)
    return [path for path, _ in asked if path is not None]


def _example(options: argparse.Namespace) -> int:
    from . import _examples

    if options.list:
        print("\n".join(f"{name:24}{about}" for name, about in _examples.names().items()))
        return FOUND
    found = _examples.run(options.name, None if options.output is None else Path(options.output))
    return FOUND if found else NOT_FOUND


def _show_warning(message: Warning | str, *_: Any, **__: Any) -> None:
    print(f"warning: {message}", file=sys.stderr)
