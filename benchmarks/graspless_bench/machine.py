# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Circumstances of a result: machine, date, command, versions."""

from __future__ import annotations

import datetime
import os
import platform
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import __version__

from . import memory
from ._peers import libraries

if TYPE_CHECKING:
    from collections.abc import Sequence

Row = dict[str, Any]  # of a result: values that JSON can hold, by name


def versions() -> Row:
    """Returns the versions of the software behind a result, by name."""
    return {
        "graspless": __version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        **libraries(),
    }


def machine(load: Sequence[float], baseline_bytes: int) -> Row:
    """Returns machine, date and command of a result.

    Parameters
    ----------
    load : list of float
        System load averages before the run. The current ones are added.
    baseline_bytes : int
        Resident memory before the first query.
    """
    model = platform.processor()
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        found = re.search(
            r"^model name\s*:\s*(.+)$", cpuinfo.read_text(encoding="utf-8"), re.MULTILINE
        )
        model = found[1] if found else model
    return {
        "cpu": model,
        "cores": os.cpu_count(),
        "system": f"{platform.system()} {platform.machine()}",
        "load_before": [round(x, 2) for x in load],
        "load_after": [round(x, 2) for x in os.getloadavg()],
        "baseline_mb": round(baseline_bytes / memory.MEGA, 1),
        "peak_is_per_query": memory.reset_peak(),
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "command": _command(),
    }


def _command() -> str:
    """The command without folders of this machine."""
    words, given = ["graspless"], iter(sys.argv[1:])
    for word in given:
        option, is_joined, value = word.partition("=")
        if option not in ("--out", "--against"):
            words.append(word)
            continue
        value = value if is_joined else next(given, "")
        if option == "--against":
            words += [option, Path(value).name]
    return " ".join(words)
