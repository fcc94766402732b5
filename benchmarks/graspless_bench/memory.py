# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory of this process (Linux)."""

from __future__ import annotations

import re
import resource
from pathlib import Path

MEGA = 1e6
_SELF = Path("/proc/self")


def reset_peak() -> bool:
    """Resets peak_bytes(). Returns False if the kernel does not allow it."""
    try:
        (_SELF / "clear_refs").write_text("5", encoding="utf-8")
    except OSError:
        return False
    return True


def peak_bytes() -> int:
    """Returns the peak resident memory since reset_peak(), or else that of the process."""
    return _status("VmHWM") or resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def resident_bytes() -> int:
    return _status("VmRSS")


def _status(field: str) -> int:
    try:
        text = (_SELF / "status").read_text(encoding="utf-8")
    except OSError:
        return 0
    found = re.search(rf"^{field}:\s+(\d+) kB", text, re.MULTILINE)
    return int(found[1]) * 1024 if found else 0
