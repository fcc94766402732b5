# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""YAML with the line number of each field."""

from __future__ import annotations

import contextlib
import difflib
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import TaskError, explain
from ..limits import uncounted, without_collector
from .bounds import MOST_DIGITS, check_yaml, faults

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    import pydantic

Location = tuple["str | int", ...]
MOST_FAULTS = 20  # lines of one message


@dataclass
class Source:
    """A file that people write, as data, and the line of every field in it.

    `is_trusted` is True if the user trusts the files that it names: see docs/security.md.
    """

    file: str
    data: Any
    lines: dict[Location, int] = field(default_factory=dict)
    is_trusted: bool = False

    def line(self, location: Iterable[str | int]) -> int:
        """Returns the line of a field, or of the nearest field around it."""
        place = tuple(location)
        while place and place not in self.lines:
            place = place[:-1]
        return self.lines.get(place, 1)

    def message(self, location: Iterable[str | int], what: str) -> str:
        """Returns a message in one line: file:line: field: value: allowed values."""
        place = tuple(location)
        value, known = self._look_up(place)
        shown = f"{_shorten(value)}: " if known and not isinstance(value, (dict, list)) else ""
        return f"{self.where(place)}{shown}{what}"

    def where(self, place: Location) -> str:
        """Returns the beginning of a message: file:line: field."""
        file = f"{self.file}:{self.line(place)}" if self.lines else self.file
        return f"{file}: {_dotted(place)}"

    def depth(self, place: Location) -> int:
        """Returns the number of steps of the path to a field that exist in the data."""
        known = (n for n in range(len(place), 0, -1) if self._look_up(place[:n])[1])
        return next(known, 0)

    def error(self, location: Iterable[str | int], what: str) -> TaskError:
        return TaskError(self.message(location, what))

    def given(self, *location: str) -> set[str]:
        """Returns the names of the fields in a section of the file."""
        data = self.data
        for key in location:
            data = data.get(key, {}) if isinstance(data, dict) else {}
        return set(data) if isinstance(data, dict) else set()

    def validate(self, model: type[pydantic.BaseModel]) -> Any:
        """Returns the data as a `model`. Raises TaskError with one line per fault."""
        from pydantic import ValidationError

        self.require_bounds()
        try:
            return model.model_validate(self.data)
        except ValidationError as error:
            faults = [self._explain(model, dict(fault)) for fault in error.errors()]
            raise TaskError("\n".join(faults)) from None

    def require_bounds(self) -> None:
        """Raises TaskError if a value is one that no field can have."""
        if found := [self.message(*fault) for fault in faults(self.data)]:
            raise TaskError("\n".join(found[:MOST_FAULTS]))

    def _look_up(self, place: Location) -> tuple[Any, bool]:
        value = self.data
        for key in place:
            try:
                value = value[key]
            except (KeyError, IndexError, TypeError):
                return None, False
        return value, bool(place)

    def _in_data(self, location: Location, is_missing: bool) -> Location:
        """A pydantic location without the tags of unions, which are not in the file."""
        place: Location = ()
        for i, key in enumerate(location):
            if self._look_up((*place, key))[1] or (is_missing and i == len(location) - 1):
                place = (*place, key)
        return place

    def _explain(self, model: type[pydantic.BaseModel], fault: dict[str, Any]) -> str:
        kind = fault["type"]
        place = self._in_data(fault["loc"], kind == "missing")
        if kind == "extra_forbidden":
            fields = sorted(_fields_at(model, fault["loc"][:-1]))
            close = difflib.get_close_matches(str(place[-1]), fields, 1)
            hint = f"; did you mean '{close[0]}'?" if close else ""
            return f"{self.where(place)}unknown field{hint} (one of: {', '.join(fields)})"
        if kind == "missing":
            return self.message(place, "missing")
        if kind == "model_type" or kind == "dict_type":
            fields = sorted(_fields_at(model, fault["loc"])) if kind == "model_type" else []
            names = f" with some of: {', '.join(fields)}" if fields else ""
            value = self._look_up(place)[0]
            shown = f"{_shorten(value)}: " if isinstance(value, list) else ""
            return self.message(place, f"{shown}should be a mapping{names}")
        text = re.sub(r"^(Value error, |Input )", "", fault["msg"])
        value = self._look_up(place)[0]
        shown = f"{_shorten(value)}: " if isinstance(value, list) and kind != "value_error" else ""
        return self.message(place, shown + text[:1].lower() + text[1:])


@contextlib.contextmanager
def at(source: Source, *location: str | int) -> Iterator[None]:
    """Gives a ValueError of the core the file, line and field that caused it."""
    try:
        yield
    except TaskError:
        raise
    except (ArithmeticError, MemoryError, RuntimeError, TypeError) as error:
        raise source.error(location, explain(error)) from error
    except ValueError as error:
        text = str(error).removeprefix(f"{location[0]}: ")
        named = re.match(r"(\w+)\.(\w+) (.*)", text, re.DOTALL)
        if named and named[1] == location[0]:  # the core names the field too
            raise source.error((named[1], named[2]), named[3]) from None
        raise source.error(location, text) from None


def read_text(path: str | Path) -> str:
    """Returns the text of a file. Raises TaskError if it cannot be read."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise TaskError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise TaskError(f"{path}: not a text file in UTF-8") from None


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
        line = mark.line + 1 if mark else 1
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        raise TaskError(f"{file}:{line}: not valid YAML: {problem}") from None
    except TaskError:
        raise
    except Exception as error:  # text that libyaml cannot encode
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
    for first in "-+.0123456789":  # YAML 1.1 takes 1e-3 for text; nobody who writes it does
        rules = loader.yaml_implicit_resolvers.setdefault(first, [])
        rules.insert(0, ("tag:yaml.org,2002:float", _FLOAT))
    try:
        root = loader.get_single_node()
        _note_lines(root, (), lines, file, (), loader)
        return None if root is None else loader.construct_document(root)
    finally:
        loader.dispose()


_FLOAT = re.compile(r"^[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+$")


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
                where = f"{file}:{key.start_mark.line + 1}: {_dotted((*place, key.value))}"
                raise TaskError(f"{where}YAML takes this name for {kind}; put it in quotes")
            if key.value in seen:
                raise TaskError(
                    f"{file}:{key.start_mark.line + 1}: {_dotted((*place, key.value))}given twice"
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


def _require_value(node: Any, place: Location, file: str, loader: Any) -> None:
    """Raises TaskError if text is not what its tag says, such as !!timestamp x."""
    import yaml

    try:
        loader.construct_object(node)
    except yaml.YAMLError:
        raise
    except Exception as error:  # PyYAML's constructors raise whatever they stumble over
        where = f"{file}:{node.start_mark.line + 1}: {_dotted(place)}{_shorten(node.value)}"
        kind = node.tag.rpartition(":")[2]
        long = f" of at most {MOST_DIGITS} digits" if kind == "int" else ""
        raise TaskError(f"{where}: should be a value of type {kind}{long}") from error


def _fields_at(model: Any, location: Location) -> set[str]:
    """Returns the names of the fields of the model at a pydantic location."""
    from pydantic import BaseModel

    found: list[Any] = [model]
    for key in location:
        below: list[Any] = []
        for kind in found:
            if isinstance(kind, type) and issubclass(kind, BaseModel):
                info = kind.model_fields.get(str(key))
                below += _models_in(info.annotation) if info else []
            else:
                below.append(kind)
        found = below or found
    fields = [kind.model_fields for kind in found if hasattr(kind, "model_fields")]
    return {name for part in fields for name, info in part.items() if not info.exclude}


def _models_in(annotation: Any) -> list[Any]:
    from typing import get_args

    from pydantic import BaseModel

    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in _models_in(part)]


def _dotted(place: Location) -> str:
    text = ""
    for key in place:
        text += f"[{key}]" if isinstance(key, int) else f".{key}" if text else str(key)
    return f"{text}: " if text else ""


def _shorten(value: Any) -> str:
    try:
        text = value if isinstance(value, str) and value.isprintable() else repr(value)
    except ValueError:  # more digits than Python writes
        return "a whole number" if isinstance(value, int) else "a list"
    if isinstance(value, bool):
        text = str(value).lower()
    return text if len(text) <= 60 else text[:57] + "..."
