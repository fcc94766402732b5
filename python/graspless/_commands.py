# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the commands of the command line share: exit codes, and files that may be stdin."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from .errors import TaskError

if TYPE_CHECKING:
    from .plans import Plan

FOUND, NOT_FOUND, BAD_INPUT, INTERRUPTED, CLOSED_PIPE = 0, 1, 2, 130, 141

EXIT_CODES = """exit codes:
  0    found, and it holds
  1    not found, or it does not hold
  2    bad input, or output that cannot be written
  130  interrupted
  141  the reader of our output has gone"""


def given_plan(path: str) -> Plan:
    """The plan in a file; - for stdin."""
    from . import plans

    return plans.load_plan(path) if path != "-" else plans.read_plan(read_stdin(), "stdin")


def read_stdin() -> str:
    """All of stdin; raises TaskError unless it is text."""
    try:
        return sys.stdin.buffer.read().decode("utf-8")
    except (OSError, AttributeError):  # closed
        raise TaskError("stdin: cannot be read") from None
    except UnicodeDecodeError:
        raise TaskError("stdin: not a text file in UTF-8") from None
