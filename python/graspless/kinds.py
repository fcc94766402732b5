# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of tasks, and where each has what is its own.

A room (tasks, plans, report, view) holds what all kinds share, with a protocol of what it needs
of a kind, and one module or package a kind, of the kind's name, that has it. A new kind is a name
here and a module in each room.
"""

from __future__ import annotations

import importlib
from typing import Any

KINDS = ("slide", "fingertip", "clasp", "carry", "chain")


def part(room: str, kind: str) -> Any:
    """What a kind has in a room, imported when it is first asked for."""
    return importlib.import_module(f".{room}.{kind}", __package__)


def plan_type(kind: str) -> Any:
    """Returns the type of a kind's plans: slide.Plan, ..."""
    return importlib.import_module(f".{kind}", __package__).Plan
