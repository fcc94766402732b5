# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bounds on what a file may hold, checked before anything is built from it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .source import Location

DEEPEST = 100  # levels of lists and mappings in each other
MOST_NODES = 10**6  # of YAML, after its aliases are replaced by what they stand for
MOST_DIGITS = 40  # of a whole number
LARGEST = 1e30  # magnitude of a number: its square and cube are finite too


def check_yaml(text: str, file: str, loader: Any) -> None:
    """Raises TaskError if YAML is nested too deeply, or too large once aliases are replaced.

    Reads events one by one: PyYAML and libyaml build nodes by recursion and end with the stack.
    """
    import yaml

    sizes: dict[str | None, int] = {}  # nodes below each anchor
    open_nodes: list[tuple[str | None, int]] = []  # anchor, and nodes before it
    nodes = 0
    events = loader(text)
    try:
        while events.check_event():
            event = events.get_event()
            where = f"{file}:{event.start_mark.line + 1}: not valid YAML: "
            if isinstance(event, yaml.AliasEvent):
                nodes += sizes.get(event.anchor, 1)
            elif isinstance(event, yaml.NodeEvent):
                nodes += 1
                if isinstance(event, yaml.CollectionStartEvent):
                    open_nodes.append((event.anchor, nodes - 1))
                elif event.anchor:
                    sizes[event.anchor] = 1
            elif isinstance(event, yaml.CollectionEndEvent):
                anchor, before = open_nodes.pop()
                if anchor:
                    sizes[anchor] = nodes - before
            if len(open_nodes) > DEEPEST:
                raise TaskError(f"{where}nested deeper than {DEEPEST} levels")
            if nodes > MOST_NODES:
                what = f"more than {MOST_NODES} values, counting each use of an alias"
                raise TaskError(f"{where}{what}; clouds and meshes belong in files of their own")
    except yaml.MarkedYAMLError as error:  # newer versions of libyaml have a limit of their own
        if "nesting depth" not in str(error.problem) or error.problem_mark is None:
            raise
        where = f"{file}:{error.problem_mark.line + 1}: not valid YAML: "
        raise TaskError(f"{where}nested deeper than {DEEPEST} levels") from None
    finally:
        events.dispose()


def faults(data: Any) -> Iterator[tuple[Location, str]]:
    """Yields place and fault of values that no field can have: too deep, too large, no text."""
    pending: list[tuple[Location, Any]] = [((), data)]
    while pending:
        place, value = pending.pop()
        if isinstance(value, (dict, list, tuple)):
            if len(place) > DEEPEST:
                yield place[:3], f"nested deeper than {DEEPEST} levels"
                return
            items = value.items() if isinstance(value, dict) else enumerate(value)
            for key, item in items:
                if isinstance(key, str) and (what := _fault(key)):
                    yield place, f"the name {key!r} {what}"
                elif type(item) in _CHECKED and not (
                    type(item) is float and -LARGEST <= item <= LARGEST
                ):
                    pending.append(((*place, key), item))
        elif what := _fault(value):
            yield place, what


_CHECKED = {dict, list, tuple, int, float, str}


def _fault(value: Any) -> str | None:
    """Returns why no field can have this value, or None."""
    if isinstance(value, str):
        if "\0" in value:
            return "should not contain the character NUL"
        try:
            value.encode()
        except UnicodeEncodeError:
            return "should be text, without halves of surrogate pairs"
    elif isinstance(value, int) and abs(value) >= 10**MOST_DIGITS:
        return f"should have at most {MOST_DIGITS} digits"
    elif isinstance(value, float) and math.isfinite(value) and abs(value) > LARGEST:
        return f"should lie in [-{LARGEST:g}, {LARGEST:g}]"
    return None
