# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the commands of the command line share: exit codes, signals, files that may be stdin."""

from __future__ import annotations

import contextlib
import signal
import sys
import threading
from typing import TYPE_CHECKING, Any

from .errors import TaskError

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Iterator

    from .plans import Plan

FOUND, NOT_FOUND, BAD_INPUT, INTERRUPTED, CLOSED_PIPE, TERMINATED = 0, 1, 2, 130, 141, 143

EXIT_CODES = """exit codes:
  0    found, and it holds
  1    not found, or it does not hold
  2    bad input, or output that cannot be written
  130  interrupted
  141  the reader of our output has gone
  143  terminated (SIGTERM)"""


@contextlib.contextmanager
def terminable() -> Iterator[Callable[[int], int]]:
    """SIGTERM ends the block as Ctrl-C does, so that worker processes and half files go too.

    Gives what makes the exit code of an interruption that of SIGTERM, if that it was.
    """
    came = False

    def end(*_: Any) -> None:
        nonlocal came
        came = True
        # `timeout` sends it twice; the second would stop the tidying up.
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        raise KeyboardInterrupt

    is_ours = (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGTERM) is signal.SIG_DFL  # nobody else answers it
    )
    if is_ours:
        signal.signal(signal.SIGTERM, end)
    try:
        yield lambda code: TERMINATED if came and code == INTERRUPTED else code
    finally:
        if is_ours:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)


def given_plan(path: str) -> Plan:
    """The plan in a file; - for stdin."""
    from . import plans

    return plans.load_plan(path) if path != "-" else plans.read_plan(read_stdin(), "stdin")


def add_unchecked(parser: argparse.ArgumentParser) -> None:
    """The flag of commands whose plan is to hold."""
    parser.add_argument(
        "--unchecked", action="store_true", help="go on with a plan that graspless check refuses"
    )


def checked_plan(options: argparse.Namespace) -> Plan:
    """The plan in a file, which may have been edited; raises TaskError unless it holds.

    With --unchecked it need not. One without a solution is left to who is given it.
    """
    from . import plans, progress

    plan = given_plan(options.plan)
    if not plan or options.unchecked:
        return plan
    with progress.waiting("checking"):
        faults = plans.check(plan)
    if faults:
        name = options.plan if options.plan != "-" else "stdin"
        more = f" and {len(faults) - 1} more" if len(faults) > 1 else ""
        raise TaskError(f"{name}: does not hold: {faults[0]}{more}; --unchecked goes on")
    return plan


def read_stdin() -> str:
    """All of stdin; raises TaskError unless it is text."""
    try:
        return sys.stdin.buffer.read().decode("utf-8")
    except (OSError, AttributeError):  # closed
        raise TaskError("stdin: cannot be read") from None
    except UnicodeDecodeError:
        raise TaskError("stdin: not a text file in UTF-8") from None
