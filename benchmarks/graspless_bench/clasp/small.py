# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small holes: how many queries are solved, and whether refusals name the size in the way."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..machine import Row

SIZES = re.compile(r"its hole is (.*?)(?:;|$)")


def _sums(rows: list[Row]) -> Row:
    failed = [row["reason"] for row in rows if not row["found"]]
    named = [found[1] for reason in failed if (found := SIZES.search(reason))]
    return {
        "queries": len(rows),
        "solved": len(rows) - len(failed),
        "refused_with_sizes": len(named),
        "refused_without": len(failed) - len(named),
        "sizes": named[0] if named else None,
    }


def by_object(rows: list[Row]) -> list[Row]:
    """Returns the sums of every object, with the sizes that the first refusal names."""
    names = dict.fromkeys(row["object"] for row in rows)
    return [{"name": n, **_sums([row for row in rows if row["object"] == n])} for n in names]


def totals(rows: list[Row]) -> Row:
    """Returns the sums of all rows."""
    sums = _sums(rows)
    del sums["sizes"]
    return sums
