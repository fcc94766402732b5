# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields and arrays as plain types. Long arrays are converted in parts, with signals in between."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pydantic import BaseModel

from .source import are_numbers

if TYPE_CHECKING:
    from ..frames import Matrix

PART = 5000  # rows


def in_plain_types(value: Any) -> Any:
    """Returns what a caller gave in the types of a file: lists for arrays, text for paths."""
    if are_numbers(value):
        return value
    if isinstance(value, Mapping):
        return {key: in_plain_types(item) for key, item in value.items()}
    if hasattr(value, "tolist"):  # of numpy and others; also of scalars
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [in_plain_types(item) for item in value]
    return os.fspath(value) if isinstance(value, os.PathLike) else value


def rows_of(array: Matrix) -> list[list[float]]:
    """Returns the rows of an array, like array.tolist()."""
    parts = (array[i : i + PART].tolist() for i in range(0, len(array), PART))
    return [row for part in parts for row in part]


def document_of(fields: BaseModel) -> dict[str, Any]:
    """Returns fields in plain types, like model_dump(mode="json", exclude_none=True)."""
    parts: dict[str, Any] = {}
    for name, value in fields:
        if isinstance(value, BaseModel):
            parts[name] = document_of(value)
        elif _are_rows(value):
            parts[name] = [list(row) for row in value]
    rest = fields.model_dump(mode="json", exclude_none=True, exclude=set(parts))
    if not parts:
        return rest
    return {name: (parts if name in parts else rest)[name] for name in _order(fields, parts, rest)}


def _are_rows(value: Any) -> bool:
    return isinstance(value, list) and len(value) > PART and isinstance(value[0], list)


def _order(fields: BaseModel, *found: dict[str, Any]) -> list[str]:
    hidden = {name for name, info in type(fields).model_fields.items() if info.exclude}
    return [name for name, _ in fields if name not in hidden and any(name in f for f in found)]
