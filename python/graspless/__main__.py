# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Entry point of the commands `graspless` and `python -m graspless`."""

import atexit
import gc
import os
import sys
import threading

from . import cli

# A command keeps one core busy, so threads for linear algebra only cost time. Looking for plugins
# of pydantic in every installed package takes longer than a plan.
DEFAULTS = {"OPENBLAS_NUM_THREADS": "1", "PYDANTIC_DISABLE_PLUGINS": "__all__"}


def main() -> int:
    """Runs one command; returns its exit code."""
    for name, value in DEFAULTS.items():
        os.environ.setdefault(name, value)
    gc.set_threshold(100_000)  # imports make many objects and hardly any garbage
    code = cli.main()
    if threading.active_count() == 1:
        _leave(code)
    return code


def _leave(code: int) -> None:
    """Ends the process at once: taking a thousand modules apart takes as long as a plan."""
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.flush()
    os._exit(code)


if __name__ == "__main__":
    sys.exit(main())
