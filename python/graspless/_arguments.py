# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Validation of arguments."""

from __future__ import annotations

import math
import numbers
import operator
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import TaskError, should_be, shown

if TYPE_CHECKING:
    from collections.abc import Collection


def require_integer(name: str, value: Any, least: int, most: float = math.inf) -> int:
    """Returns the value; raises TaskError unless it is a whole number from `least` to `most`."""
    try:
        number = operator.index(value)  # also numpy's
    except TypeError:
        number = None
    if number is None or isinstance(value, bool):
        raise TaskError(f"{name}: {shown(value)}: should be a whole number")
    if number < least:
        what = f"should be at least {least}" if least else "should not be negative"
        raise TaskError(f"{name}: {shown(number)}: {what}")
    if number > most:
        raise TaskError(f"{name}: {shown(number)}: should be at most {most}")
    return number


def require_number(name: str, value: Any, other: str = "") -> None:
    """Raises TaskError unless the value is a number, possibly infinite or NaN.

    The message names what `other` than a number it may be.
    """
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TaskError(f"{name}: {shown(value)}: should be a number{other}")
    try:
        float(value)
    except OverflowError:
        raise TaskError(f"{name}: {shown(value)}: should have at most 308 digits") from None


def require_above_zero(name: str, value: Any) -> None:
    """Raises TaskError unless the value is a number above 0, possibly infinite."""
    require_number(name, value)
    if not float(value) > 0:
        raise TaskError(f"{name}: {shown(value)}: should be above 0")


def require_finite(budget: Any) -> None:
    """Raises TaskError if a budget has no limit of time: a plan file has no word for that."""
    if not math.isfinite(budget.seconds):
        raise TaskError(f"budget: seconds is {budget.seconds}; should be finite")


def require_within(name: str, value: Any, least: float, most: float) -> None:
    """Raises TaskError unless the value is a number from `least` to `most`."""
    require_number(name, value)
    if not least <= value <= most:
        raise TaskError(f"{name}: {shown(value)}: should lie in [{least:g}, {most:g}]")


def require_choice(name: str, value: Any, known: Collection[str]) -> None:
    """Raises TaskError unless the value is one of the `known` names."""
    if not isinstance(value, str) or value not in known:
        given = value if isinstance(value, str) else shown(value)
        raise TaskError(f"{name}: {given}: {should_be(given, known)}")


def require_type(name: str, value: Any, *types: type) -> None:
    """Raises TaskError unless the value has one of the types, which the message names."""
    if not isinstance(value, types):
        named = " or ".join(map(_named, types))
        raise TaskError(f"{name}: {shown(value)}: should be a {named}")


def _named(kind: type) -> str:
    return f"{kind.__module__}.{kind.__name__}".replace("._core", "")


def require_path(name: str, value: Any, other: str) -> str | Path:
    """Returns the value; raises TaskError unless it is a path.

    `other` describes what else the argument could be, for the error message.
    """
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return Path(value)
    raise TaskError(f"{name}: {shown(value)}: should be {other}, or the path of its file")
