# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a proposal for a robot."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..inspection import Finding, Proposal

WIDTH = 44  # letters of a column


def as_text(proposal: Proposal) -> str:
    """Returns a table with a row per finding, and the fields to check."""
    fields = max(len(finding.field) for finding in proposal.findings)
    rows = [f"{'field':{fields}}  {'value':{WIDTH}}  {'reason':{WIDTH}}"]
    for finding in proposal.findings:
        rows += _row(finding, fields)
    unsure = ", ".join(finding.field for finding in proposal.unsure)
    rows.append(f"unsure, please check: {unsure}" if unsure else "nothing is unsure")
    return "\n".join(line.rstrip() for line in rows)


def _row(finding: Finding, fields: int) -> list[str]:
    values = textwrap.wrap(finding.value, WIDTH) or [""]
    reason = finding.reason if finding.is_sure else f"UNSURE: {finding.reason}"
    reasons = textwrap.wrap(reason, WIDTH) or [""]
    count = max(len(values), len(reasons))
    values += [""] * (count - len(values))
    reasons += [""] * (count - len(reasons))
    names = [finding.field] + [""] * (count - 1)
    return [
        f"{name:{fields}}  {value:{WIDTH}}  {why:{WIDTH}}"
        for name, value, why in zip(names, values, reasons, strict=True)
    ]
