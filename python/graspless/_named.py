# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Enums whose members equal their names, as files and command lines write them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import enum


def equal_to_names(kind: type[enum.Enum]) -> None:
    """Lets members of an enum equal their names: `plan.status == "solved"`, and print as these."""
    changed: Any = kind
    changed.__eq__ = lambda self, other: self is other or self._name_ == other
    changed.__hash__ = lambda self: hash(self._name_)
    changed.__str__ = lambda self: self._name_
