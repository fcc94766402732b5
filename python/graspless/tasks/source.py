# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data that people write, with the line of each field, and messages about their faults."""

from __future__ import annotations

import contextlib
import math
import re
from dataclasses import dataclass, field
from itertools import chain
from typing import TYPE_CHECKING, Any

from ..errors import TaskError, explain, one_of, suggestion, warn

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    import pydantic

Location = tuple["str | int", ...]
MOST_FAULTS = 20  # lines of one message
DEEPEST = 100  # levels of lists and mappings in each other
MOST_DIGITS = 40  # of a whole number
LONGEST, LONGEST_PATH = 60, 4096  # characters of a value, and of a path, in a message
_ABSENT = ("no such", "is a folder", "is not a file", "cannot be read: ")
LARGEST = 1e30  # magnitude of a number: its square and cube are finite too


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
        value, known = self.look_up(place)
        longest = LONGEST_PATH if what.startswith(_ABSENT) else LONGEST
        is_shown = known and not isinstance(value, (dict, list))
        shown = f"{shorten(value, longest)}: " if is_shown else ""
        return f"{self.where(place)}{shown}{what}"

    def where(self, place: Location) -> str:
        """Returns the beginning of a message: file:line: field."""
        file = f"{self.file}:{self.line(place)}" if self.lines else self.file
        return f"{file}: {dotted(place)}"

    def depth(self, place: Location) -> int:
        """Returns the number of steps of the path to a field that exist in the data."""
        known = (n for n in range(len(place), 0, -1) if self.look_up(place[:n])[1])
        return next(known, 0)

    def error(self, location: Iterable[str | int], what: str) -> TaskError:
        return TaskError(self.message(location, what))

    def warn(self, location: Iterable[str | int], what: str) -> None:
        warn(self.message(location, what))

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
            raise TaskError("\n".join(dict.fromkeys(faults))) from None

    def require_bounds(self) -> None:
        """Raises TaskError if a value is one that no field can have."""
        if found := [self.message(*fault) for fault in faults(self.data)]:
            raise TaskError("\n".join(found[:MOST_FAULTS]))

    def look_up(self, place: Location) -> tuple[Any, bool]:
        """Returns the value of a field, and True if the file has it."""
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
            if self.look_up((*place, key))[1] or (is_missing and i == len(location) - 1):
                place = (*place, key)
        return place

    def _explain(self, model: type[pydantic.BaseModel], fault: dict[str, Any]) -> str:
        kind = fault["type"]
        place = self._in_data(fault["loc"], kind == "missing")
        if kind == "extra_forbidden":
            fields = sorted(_fields_at(model, fault["loc"][:-1]))
            return f"{self.where(place)}unknown field{one_of(place[-1], fields)}"
        if kind == "missing":
            return self.message(place, "missing")
        if kind == "model_type" or kind == "dict_type":
            fields = sorted(_fields_at(model, fault["loc"])) if kind == "model_type" else []
            names = f" with some of: {', '.join(fields)}" if fields else ""
            value = self.look_up(place)[0]
            shown = f"{shorten(value)}: " if isinstance(value, list) else ""
            return self.message(place, f"{shown}should be a mapping{names}{_advice(kind, value)}")
        value = self.look_up(place)[0]
        text = re.sub(r"^(Value error, |Input )| after validation", "", fault["msg"])
        text += _advice(kind, value)
        if kind == "literal_error":
            text += suggestion(value, re.findall("'(.*?)'", fault["msg"]))
        is_shown = isinstance(value, list) and kind != "value_error"  # message() shows the others
        is_shown = is_shown or (isinstance(value, dict) and kind.endswith("_type"))
        shown = f"{shorten(value)}: " if is_shown else ""
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


def _advice(kind: str, value: Any) -> str:
    """Returns what to write instead of a value of another type."""
    if kind == "string_type" and isinstance(value, bool):
        return "; YAML reads yes, no, on and off as true or false: put text in quotes"
    if kind == "string_type" and isinstance(value, (int, float)):
        return "; put text that looks like a number, such as 1e3, in quotes"
    if kind in ("list_type", "model_type", "dict_type") and _is_quoted(value):
        return ", without quotes"
    if kind in ("float_parsing", "float_type", "int_parsing", "int_type"):
        if isinstance(value, str) and re.fullmatch(r"[-+]?\d*,\d+", value):
            return f"; decimals have a point: {value.replace(',', '.')}"
        if isinstance(value, str) and _is_number(value):
            return ", without quotes"
    return ""


def _is_quoted(value: Any) -> bool:
    """True of text that would be a list or a mapping without its quotes."""
    return isinstance(value, str) and value.strip()[:1] + value.strip()[-1:] in ("[]", "{}")


def _is_number(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


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


def dotted(place: Location) -> str:
    """Returns the name of a field in a message."""
    text = ""
    for key in place:
        name = key or "''" if isinstance(key, str) else f"[{key}]"
        text += f".{name}" if text and isinstance(key, str) else name
    return f"{text}: " if text else ""


def shorten(value: Any, longest: int = LONGEST) -> str:
    """Returns a value in a message; of a long path, the end."""
    is_word = False
    try:
        is_word = isinstance(value, str) and value.isprintable()
        is_word = is_word and not _is_number(value) and not _is_quoted(value)
        text = value if is_word else repr(value)
    except ValueError:  # more digits than Python writes
        return "a whole number" if isinstance(value, int) else "a list"
    if value is None or isinstance(value, bool):
        text = "null" if value is None else str(value).lower()
    if len(text) <= longest:
        return text
    is_path = is_word and "/" in text and " " not in text
    return f"...{text[3 - longest :]}" if is_path else f"{text[: longest - 3]}..."


def faults(data: Any) -> Iterator[tuple[Location, str]]:
    """Yields place and fault of values that no field can have: too deep, too large, no text."""
    pending: list[tuple[Location, Any]] = [((), data)]
    while pending:
        place, value = pending.pop()
        if isinstance(value, (dict, list, tuple)):
            if len(place) > DEEPEST:
                yield place[:3], f"nested deeper than {DEEPEST} levels"
                return
            if are_numbers(value):
                continue
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


def are_numbers(value: Any) -> bool:
    """True of most lists of numbers, or of rows of numbers, that all lie within bounds; quick."""
    if type(value) is not list:
        return False
    types = set(map(type, value))
    numbers: list[float] = list(chain.from_iterable(value)) if types == {list} else value
    if set(map(type, numbers)) != {float}:
        return False
    return min(numbers) >= -LARGEST and max(numbers) <= LARGEST


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
