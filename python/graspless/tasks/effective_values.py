# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values in force: a plan file says them all, so that a later default cannot change it."""

from __future__ import annotations

from typing import Any


def in_force(fields: Any, built: Any) -> Any:
    """Returns the fields with the values of the struct that was built from them."""
    names = [name for name, info in type(fields).model_fields.items() if not info.exclude]
    return type(fields)(**{name: plain(getattr(built, name)) for name in names})


def plain(value: Any) -> Any:
    """Returns a value of the core in plain types."""
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if hasattr(value, "tolist"):
        return value.tolist()
    return getattr(value, "name", value)
