# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""YAML with the line number of each field."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from ..errors import TaskError, is_of_library
from ..files import as_path
from ..limits import uncounted, without_collector
from .source import DEEPEST, MOST_DIGITS, Location, Source, dotted, shorten

MOST_NODES = 10**6  # of YAML, after its aliases are replaced by what they stand for


def read_text(path: str | Path) -> str:
    """Returns the text of a file. Raises TaskError if it cannot be read."""
    file = as_path(path)
    try:
        return file.read_text(encoding="utf-8-sig")  # Windows editors write a byte order mark
    except OSError as error:
        if error.errno is None:  # a TimeoutError of the program
            raise
        raise TaskError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise TaskError(f"{path}: not a text file in UTF-8") from None
    except ValueError as error:  # a NUL in the name
        raise TaskError(f"{str(path)!r}: cannot be read: {error}") from None


def read_yaml(path: str | Path) -> Source:
    """Reads a YAML file with the line of each field.

    Raises
    ------
    TaskError
        The file is missing, is not YAML, is empty, or names a field twice.
    """
    return parse_yaml(read_text(path), str(path))


def parse_yaml(text: str, file: str) -> Source:
    """Parses text, like `read_yaml`."""
    with uncounted():
        import yaml

    lines: dict[Location, int] = {}
    try:
        with without_collector():
            data = _load(text, file, lines)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        if mark is None:
            raise TaskError(f"{file}:1: not valid YAML: {problem}") from None
        if text[mark.index : mark.index + 1] == "\t":
            problem = "a tab where YAML takes spaces alone"
        told = f"not valid YAML: {problem} (column {mark.column + 1})"
        raise TaskError(f"{file}:{mark.line + 1}: {told}") from None
    except TaskError:
        raise
    except Exception as error:  # text that libyaml cannot encode
        if not is_of_library(error):
            raise
        raise TaskError(f"{file}:1: not valid YAML: {error}") from error
    if not isinstance(data, dict):
        raise TaskError(f"{file}:1: should be a mapping of fields, see docs/task-files.md")
    return Source(file, data, lines)


def _load(text: str, file: str, lines: dict[Location, int]) -> Any:
    import yaml

    # libyaml's parser where PyYAML has it: ten times as fast, with the same nodes and marks.
    make = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    check_yaml(text, file, make)
    loader = make(text)
    loader.yaml_implicit_resolvers = {
        key: [rule for rule in rules if rule[0] != "tag:yaml.org,2002:timestamp"]
        for key, rules in yaml.SafeLoader.yaml_implicit_resolvers.items()
    }
    for first in "-+.0123456789":  # YAML 1.1 takes 1e-3 and -.2 for text; who writes them does not
        rules = loader.yaml_implicit_resolvers.setdefault(first, [])
        rules.insert(0, ("tag:yaml.org,2002:float", _FLOAT))
    try:
        root = loader.get_single_node()
        _note_lines(root, (), lines, file, (), loader)
        return None if root is None else loader.construct_document(root)
    finally:
        loader.dispose()


_FLOAT = re.compile(r"^[-+]?(?:[0-9]+\.?[0-9]*(?=[eE])|\.[0-9]+)(?:[eE][-+]?[0-9]+)?$")


def _note_lines(
    node: Any,
    place: Location,
    lines: dict[Location, int],
    file: str,
    above: tuple[int, ...],
    loader: Any,
) -> None:
    import yaml

    if node is None:
        return
    if id(node) in above:
        raise TaskError(f"{file}:{node.start_mark.line + 1}: an alias that contains itself")
    above = (*above, id(node))
    lines.setdefault(place, node.start_mark.line + 1)
    if isinstance(node, yaml.MappingNode):
        seen = set()
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                raise TaskError(f"{file}:{key.start_mark.line + 1}: a field's name must be a word")
            if key.value == "on":  # YAML 1.1 takes it for true, nobody who names a support does
                key.tag = "tag:yaml.org,2002:str"
            if key.tag not in ("tag:yaml.org,2002:str", "tag:yaml.org,2002:merge"):
                kind = {"bool": "true or false", "null": "nothing"}.get(
                    key.tag.rpartition(":")[2], "a number"
                )
                name, what = _with_comma(node, key) or (
                    key.value,
                    f"YAML takes this name for {kind}; put it in quotes",
                )
                where = f"{file}:{key.start_mark.line + 1}: {dotted((*place, name))}"
                raise TaskError(f"{where}{what}")
            if key.value in seen:
                raise TaskError(
                    f"{file}:{key.start_mark.line + 1}: {dotted((*place, key.value))}given twice"
                )
            seen.add(key.value)
            inner = (*place, key.value)
            lines[inner] = key.start_mark.line + 1
            _note_lines(value, inner, lines, file, above, loader)
    elif isinstance(node, yaml.SequenceNode):
        for i, value in enumerate(node.value):
            _note_lines(value, (*place, i), lines, file, above, loader)
    else:
        _require_value(node, place, file, loader)


def _with_comma(node: Any, key: Any) -> tuple[str, str] | None:
    """Returns the field and what is wrong if a name is the end of a decimal, as in {mass: 0,12}."""
    for name, value in node.value:
        number = f"{value.value},{key.value}"
        is_before = value.end_mark.index + 1 == key.start_mark.index
        if is_before and re.fullmatch(r"[-+]?\d+,\d+", number):
            return name.value, f"{number}: decimals have a point"
    return None


def _require_value(node: Any, place: Location, file: str, loader: Any) -> None:
    """Raises TaskError if text is not what its tag says, such as !!timestamp x."""
    import yaml

    kind = node.tag.rpartition(":")[2]
    try:
        value = loader.construct_object(node)
    except yaml.YAMLError:
        raise
    except Exception as error:  # PyYAML's constructors raise whatever they stumble over
        if not is_of_library(error):
            raise
        where = f"{file}:{node.start_mark.line + 1}: {dotted(place)}{shorten(node.value)}"
        long = f" of at most {MOST_DIGITS} digits" if kind == "int" else ""
        raise TaskError(f"{where}: should be a value of type {kind}{long}") from error
    if kind in ("int", "float") and (hint := _in_decimals(node.value)):
        where = f"{file}:{node.start_mark.line + 1}: {dotted(place)}{node.value}"
        raise TaskError(f"{where}: YAML reads this as {value}; {hint}, or put text in quotes")


def _in_decimals(number: str) -> str:
    """Returns what to write in place of 010 or 1:30, which YAML 1.1 reads in base 8 and 60."""
    if len(number) > MOST_DIGITS:  # is refused as too large
        return ""
    if ":" in number:
        return "write minutes and seconds as one number"
    octal = re.fullmatch("([-+]?)0+([0-7_]+)", number)
    return f"write {octal[1]}{int(octal[2].replace('_', '') or 0)}" if octal else ""


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
