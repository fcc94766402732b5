# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text of a plan file."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from pydantic_core import to_json

if TYPE_CHECKING:
    from .._plan import Plan


def document_of(plan: Plan) -> dict[str, Any]:
    """Returns all that a plan file holds, in plain types."""
    from .. import __version__

    fields = plan._fields()
    head = {"format": 1, "kind": plan.kind, "version": __version__}
    head |= {name: fields[name] for name in ("status", "reason")} | {"seed": plan.seed}
    head["stats"] = fields["stats"]
    if plan.proof is not None:
        head["proof"] = asdict(plan.proof)
    return head | fields | {"task": plan.task.to_dict()}


def text_of(plan: Plan) -> str:
    """Returns the text of a plan's file."""
    return _to_text(document_of(plan)) + "\n"


def _to_text(value: Any, indent: str = "") -> str:
    """JSON with one row of numbers a line: readable, and a quarter of the length of indent=1."""
    deeper = indent + " "
    if isinstance(value, dict) and value:
        items = (f"{deeper}{_encode(key)}: {_to_text(v, deeper)}" for key, v in value.items())
        return "{\n" + ",\n".join(items) + f"\n{indent}}}"
    if isinstance(value, list) and not {list, dict}.isdisjoint(map(type, value)):
        rows = _rows(value, deeper) or (deeper + _to_text(item, deeper) for item in value)
        return "[\n" + ",\n".join(rows) + f"\n{indent}]"
    return repr(value) if type(value) is float and math.isfinite(value) else _encode(value)


def _rows(table: list[Any], indent: str) -> list[str] | None:
    """Returns the lines of a list of lists of finite numbers, by a single fast call; or None."""
    if set(map(type, table)) != {list}:
        return None
    text = to_json(table).decode()
    if any(sign in text for sign in _NOT_IN_ROWS) or text.count("[") != len(table) + 1:
        return None
    return [f"{indent}[{row}]" for row in text[2:-2].replace(",", ", ").split("], [")]


_NOT_IN_ROWS = ('"', "{", "NaN", "Infinity")
_encode = json.JSONEncoder(allow_nan=False).encode
