# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summary of a batch: counts, times, and the reasons of tasks without a plan."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..report import duration

Row = dict[str, Any]
QUANTILES = {"p50": 0.5, "p90": 0.9, "p99": 0.99, "max": 1.0}
MOST_REASONS = 5  # of each status that are printed
LONGEST = 160  # characters of a reason


@dataclass(frozen=True)
class Summary:
    """Result of a batch. True if all tasks have a plan that passes its check and its trials.

    Attributes
    ----------
    rows : list of dict
        Finished tasks, sorted by name, with the keys name, task (file), hash, status, reason,
        seconds (planning time), seed, plan (file), plan_hash (sha256 of the file), holds, faults,
        warnings and total_seconds (reading and checking included).
    tasks : int
        Number of tasks; more than rows if the batch was interrupted.
    kept : int
        Number of rows that were kept from an earlier run.
    jobs : int
        Number of workers.
    seconds : float
        Wall clock of this run [s].
    """

    rows: list[Row]
    tasks: int
    kept: int
    jobs: int
    seconds: float

    def __bool__(self) -> bool:
        return self.held == self.tasks

    @property
    def is_complete(self) -> bool:
        """True if every task was carried out."""
        return len(self.rows) == self.tasks

    @property
    def solved(self) -> int:
        """Number of tasks with a plan."""
        return self.statuses.get("solved", 0)

    @property
    def held(self) -> int:
        """Number of plans that pass their check, and their trials if there were any."""
        return sum(row["holds"] for row in self.rows)

    @property
    def statuses(self) -> dict[str, int]:
        """Number of tasks by status, the most frequent first."""
        return dict(Counter(row["status"] for row in self.rows).most_common())

    @property
    def planning_seconds(self) -> dict[str, float]:
        """Quantiles p50, p90, p99 and max of the planning time of all tasks, solved or not [s]."""
        seconds = [row["seconds"] for row in self.rows if row["seconds"] is not None]
        if not seconds:
            return {}
        found = np.quantile(seconds, list(QUANTILES.values()), method="inverted_cdf")
        return dict(zip(QUANTILES, map(float, found), strict=True))

    @property
    def reasons(self) -> dict[str, dict[str, int]]:
        """Number of tasks by status and reason; of solved tasks those that fail check or trials."""
        reasons: dict[str, Counter[str]] = {}
        for row in self.rows:
            if row["faults"]:
                reasons.setdefault("does not hold", Counter())[row["faults"][0]] += 1
            elif row["status"] == "solved" and not row["holds"]:
                reasons.setdefault("not proven", Counter())[row["reason"]] += 1
            elif row["status"] != "solved":
                reasons.setdefault(row["status"], Counter())[row["reason"]] += 1
        return {status: dict(counts.most_common()) for status, counts in reasons.items()}

    def as_dict(self) -> dict[str, Any]:
        """Returns the summary in plain types and without its rows, as in summary.json."""
        new = len(self.rows) - self.kept
        return {
            "tasks": self.tasks,
            "complete": self.is_complete,
            "solved": self.solved,
            "held": self.held,
            "kept": self.kept,
            "statuses": self.statuses,
            "planning_seconds": self.planning_seconds,
            "jobs": self.jobs,
            "seconds": self.seconds,
            "tasks_per_second": new / self.seconds if self.seconds > 0 else None,
            "reasons": self.reasons,
            "failed": [row["name"] for row in self.rows if not row["holds"]],
        }

    def as_text(self) -> str:
        """Returns the summary as a few lines of text."""
        new = len(self.rows) - self.kept
        lines = [
            f"{len(self.rows)} of {self.tasks} tasks done, {self.kept} of them before; "
            f"{new} in {self.seconds:.1f} s with {self.jobs} "
            + ("worker" if self.jobs == 1 else "workers")
            + (f", {new / self.seconds:.1f} a second" if new and self.seconds > 0 else ""),
            f"  {'solved':16}{self.solved:6}",
            f"  {'held by check':16}{self.held:6}",
        ]
        if times := self.planning_seconds:
            shown = ", ".join(f"{name} {duration(value)}" for name, value in times.items())
            lines.append(f"  planning         {shown}")
        for status, reasons in self.reasons.items():
            lines.append(f"  {status:16}{sum(reasons.values()):6}")
            lines += _lines(reasons)
        return "\n".join(lines)


def _lines(reasons: dict[str, int]) -> list[str]:
    shown = list(reasons.items())[:MOST_REASONS]
    lines = [f"  {count:>22}  {_shortened(reason)}" for reason, count in shown]
    if len(reasons) > MOST_REASONS:
        lines.append(f"  {'':>22}  {len(reasons) - MOST_REASONS} other reasons")
    return lines


def _shortened(reason: str) -> str:
    first, _, rest = reason.partition("\n")
    return first[:LONGEST] + (" ..." if rest or len(first) > LONGEST else "")
