# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Base of enums whose members equal their names, as files and command lines write them."""

from __future__ import annotations

import enum


class Named(enum.Enum):
    """An enum whose members equal their names: `plan.status == "solved"`, and print as these."""

    def __eq__(self, other: object) -> bool:
        return self is other or self._name_ == other

    def __hash__(self) -> int:
        return hash(self._name_)

    def __str__(self) -> str:
        return self._name_
