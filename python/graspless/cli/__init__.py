# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command line: the parser, and the commands check, view and example."""

from __future__ import annotations

import argparse
import contextlib
import errno
import importlib
import json
import os
import re
import sys
import traceback
import warnings
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from .. import __version__
from .._commands import BAD_INPUT, CLOSED_PIPE, FOUND, INTERRUPTED, NOT_FOUND, require_apart
from .._given_plan import given_plan
from .._pictures import add_pictures, check_pictures, draw
from ..errors import OutOfTimeError, TaskError, explain, suggestion

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

# Errors of a stream that cannot be written. Others without a file are those of a library.
OF_STREAMS = (errno.EBADF, errno.EFBIG, errno.EINVAL, errno.EIO, errno.ENOSPC, errno.EPIPE)


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
            warnings.showwarning = _warnings_shown_once()
            options = make_parser(command).parse_args(given)
            if command != "plan":  # which first reads a plan that was given instead of a task
                require_apart(options)
            run: Callable[[argparse.Namespace], int] = options.run
            return run(options)
    except TaskError as error:
        code = _refuse(str(error), error)
        return NOT_FOUND if isinstance(error, OutOfTimeError) else code
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        if error.filename is None and error.errno in OF_STREAMS:
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


class _Parser(argparse.ArgumentParser):
    """Suggests the name that a misspelt command, flag or choice resembles."""

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        options, rest = super().parse_known_args(args, namespace)  # also a command's, by its parser
        if rest:
            hint = suggestion(rest[0], self._option_string_actions)
            self.error(f"unrecognized arguments: {' '.join(rest)}{hint}")
        return options, rest

    def error(self, message: str) -> NoReturn:
        if bad := re.search(r"invalid choice: '(.*)' \(choose from (.*)\)", message):
            message += suggestion(bad[1], re.findall(r"[\w.-]+", bad[2]))
        super().error(message)


def make_parser(command: str) -> argparse.ArgumentParser:
    """Returns the parser of the command line.

    Parameters
    ----------
    command : str
        The command that gets its arguments. The others have a name and a line of help only, so
        that their modules need not be imported.
    """
    parser = _Parser(
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
    add_pictures(parser)
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


_COMMANDS: dict[str, tuple[str, Callable[[argparse.ArgumentParser], None]]] = {
    "plan": ("plan a task and write the plan", _of(".plan")),
    "check": ("check a plan by replaying it", _add_check),
    "view": ("view a plan, or draw it to a file", _add_view),
    "simulate": ("execute a plan in the MuJoCo physics engine", _of("..simulation.cli")),
    "export": ("export a timed plan for ROS, MuJoCo and others", _of("..formats.cli")),
    "batch": ("plan many tasks in parallel", _of("..batches.cli")),
    "robot": ("propose, check and join descriptions of robots", _of(".robot")),
    "loops": ("find the holes of a point cloud or a mesh", _of(".loops")),
    "pick": ("pick up an object of a scene in whichever way works", _of("..picking.cli")),
    "see": ("find tables and objects in depth images", _of("..perception.cli")),
    "demonstrate": ("record the planner in MuJoCo, for learners", _of(".demonstrate")),
    "ros": ("run graspless in ROS 2, or a demo of it", _of("..ros.cli")),
    "example": ("plan, check and draw an example", _add_example),
    "bench": ("repeat the papers' experiments (in a checkout)", _add_bench),
}


def _check(options: argparse.Namespace) -> int:
    from .. import _api, report

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
        if plan.proof is not None and not faults:
            print(plan.proof)
    return NOT_FOUND if faults else FOUND


def _view(options: argparse.Namespace) -> int:
    check_pictures(options)
    plan = given_plan(options.plan)
    if options.png is None and options.html is None:
        from ..view import serve

        serve(plan, port=options.port)
    for path in draw(plan, options):
        print(f"written: {path}")
    return FOUND


def _example(options: argparse.Namespace) -> int:
    from . import examples

    if options.list:
        print("\n".join(f"{name:24}{about}" for name, about in examples.names().items()))
        return FOUND
    found = examples.run(options.name, None if options.output is None else Path(options.output))
    return FOUND if found else NOT_FOUND


def _warnings_shown_once() -> Callable[..., None]:
    """Returns a function that prints each text once: several searches read the same files."""
    shown: set[str] = set()

    def show(message: Warning | str, *_: Any, **__: Any) -> None:
        if str(message) not in shown:
            shown.add(str(message))
            print(f"warning: {message}", file=sys.stderr)

    return show
