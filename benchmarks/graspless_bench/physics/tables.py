# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of plans in the physics engine."""

from __future__ import annotations

import itertools
import math
import re
from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import statistics
from ..tables import plain
from .claims import (
    BROKEN,
    CLAIMS,
    DISTURBED,
    NOMINAL,
    PROVEN,
    SEARCHES,
    VARIED,
    cases,
    is_proven,
    used_of_tube,
)
from .mutants import mutants
from .work import CLOSED

if TYPE_CHECKING:
    from ..machine import Row
    from ..tables import Column as Column

    Table = tuple[list[Row], list[Column]]  # named rows, and the columns to show

UNITS = {"m": (1e3, "mm"), "rad": (180 / np.pi, "deg")}  # as people read them
LOST = ("crashed", "failed")  # an error, and nothing is known of the plan
KNOWN = ("solved", *LOST)
MEANING = "meaning"  # a column for pages, too wide for a terminal
SHOWN = {"median": 0.5, "95 %": 0.95, "max": 1.0}
EDGES = (0, 0.5, 0.7, 0.9, 1.0, 1.1, 1.25, 1.5, 2.0, 3.0, math.inf)  # of broke / promised
ONE_SIDED = 1.645  # one-sided 95 % of the normal distribution
SLOW = {"median": 0.5, "99 %": 0.99, "max": 1.0}
LOW = {"min": 0.0, "5 %": 0.05, "median": 0.5}
DISTURBANCES = {
    "ratio": "smallest disturbance that breaks the motion / z",
    "compliant_ratio": "smallest disturbance that breaks the motion / compliant index",
    "withstands_ratio": "smallest disturbance that breaks the motion / what the row withstands",
    "promised_ratio": "the same, with the fingers as far beside their places as they were",
    "lost_ratio": "smallest disturbance that moves a corner by 5 mm / z",
    "smallest": "smallest disturbance that breaks the motion [N]",
    "z": "[N]",
}


def totals(rows: list[Row]) -> Row:
    """Returns the counts of a result."""
    nominal, varied = list(cases(rows, NOMINAL)), list(cases(rows, VARIED))
    seconds = [s for row in rows for s in row["seconds"]]
    return {
        "tasks": len(rows),
        "planned": sum(row["status"] == "solved" for row in rows),
        "not_planned": dict(Counter(r["status"] for r in rows if r["status"] not in KNOWN)),
        "lost": sum(row["status"] in LOST for row in rows),
        "failed_checks": sum(bool(row["faults"]) for row in rows),
        "warned": sum(bool(row.get("warnings")) for row in rows),  # older files have none
        "nominal": len(nominal),
        "nominal_held": sum(not case["failures"] for case in nominal),
        "varied": len(varied),
        "varied_held": sum(not case["failures"] for case in varied),
        "disturbed": sum(1 for _ in cases(rows, DISTURBED)),
        "broken": sum(1 for _ in cases(rows, BROKEN)),
        "searched": sum(1 for _ in cases(rows, PROVEN)),
        "tube_width": _tube_width(varied),
        "median_seconds": _quantile(seconds, 0.5),
        "max_seconds": _quantile(seconds, 1.0),
    }


def _tube_width(varied: list[Row]) -> dict[str, float] | None:
    """Returns how many times as wide as 99 % of the trials need the tubes of the plans are."""
    used = [share for case in varied if (share := used_of_tube(case)) is not None]
    if not used:
        return None
    position, angle = (1 / np.quantile(part, 0.99, method="higher") for part in np.transpose(used))
    return {"position": float(position), "angle": float(angle)}


def claims(result: Row) -> Table:
    """Returns the requirements and their results."""
    found = []
    for claim in CLAIMS[result["part"]]:
        answers = [claim.holds(case) for case in cases(result["rows"], claim.of)]
        asked = [answer for answer in answers if answer is not None]
        if asked:
            row = {"name": claim.what, "of": claim.of, "held": sum(asked), "asked": len(asked)}
            found.append(row | {"must": claim.must, "goal": claim.goal})
    return found, CLAIM_COLUMNS


def failures(result: Row) -> Table:
    """Returns the count of every kind of failure, also if 0; None if there was no trial."""
    trials = {of: list(cases(result["rows"], of)) for of in (NOMINAL, VARIED)}
    counts = {
        of: Counter(f for case in seen for f in case["failures"]) for of, seen in trials.items()
    }
    rows = [
        {
            "name": name.replace("_", " "),
            "means": means,
            **{of: c[name] if trials[of] else None for of, c in counts.items()},
        }
        for name, means in result["failures"].items()
    ]
    return rows, FAILURE_COLUMNS


def measures(result: Row) -> Table:
    """Returns quantiles of each measure, nominal and varied."""
    rows = []
    for name, means in result["measures"].items():
        factor, unit, means = _in_units(means)
        row: Row = {"name": name.replace("_", " ") + unit, "means": means}
        for of in (NOMINAL, VARIED):
            values = [c[name] for c in cases(result["rows"], of) if c.get(name) is not None]
            row[of] = {q: _quantile(values, f, factor) for q, f in SHOWN.items()}
        rows.append(row)
    return rows, MEASURE_COLUMNS


def conditions(result: Row) -> Table:
    """Returns the trials of each condition in open and in closed loop."""
    of = dict.fromkeys(name for row in result["rows"] for name in row.get("of", ()))
    rows = []
    for name in of:
        seen = list(cases(result["rows"], name))
        kinds = Counter(f.replace("_", " ") for case in seen for f in case["failures"])
        row: Row = {
            "name": name,
            "trials": len(seen),
            "held": sum(not case["failures"] for case in seen),
            "plans": sum(int(case.get(n) or 0) for case in seen for n in ("resumes", "restarts")),
            "failures": ", ".join(f"{kind} {count}" for kind, count in kinds.most_common()),
        }
        for measure, unit in (("position_error", "m"), ("angle_error", "rad")):
            known = [case[measure] for case in seen if case[measure] is not None]
            row[measure] = {q: _quantile(known, f, UNITS[unit][0]) for q, f in SHOWN.items()}
        rows.append(row)
    return rows, CONDITION_COLUMNS


def replans(result: Row) -> Table:
    """Returns the processor times of the longest searches of the trials in closed loop."""
    closed = list(cases(result["rows"], CLOSED))
    rows = []
    for kind, what in SEARCHES.items():
        known = [c[f"{kind}_seconds"] for c in closed if c.get(f"{kind}_seconds") is not None]
        row: Row = {"name": what, "count": len(known)}
        rows.append(row | {q: _quantile(known, f, 1e3) for q, f in SLOW.items()})
    return rows, REPLAN_COLUMNS


def proofs(result: Row) -> Table:
    """Returns how many plans were simulated for each task, and what fails in the best ones."""
    seen = list(cases(result["rows"], PROVEN))
    rows = []
    for name, group in (("proven", True), ("not proven", False)):
        of = [case for case in seen if is_proven(case) == group]
        kinds = Counter(f.replace("_", " ") for c in of for trial in c["failures"] for f in trial)
        row: Row = {
            "name": name,
            "count": len(of),
            "failures": ", ".join(f"{kind} {count}" for kind, count in kinds.most_common()),
        }
        for figure in ("plans", "seconds"):
            values = [case[figure] for case in of]
            row[figure] = {q: _quantile(values, f) for q, f in SHOWN.items()}
        rows.append(row)
    return rows, PROOF_COLUMNS


def broken(result: Row) -> Table:
    """Returns what finds each mutant."""
    seen = list(cases(result["rows"], BROKEN))
    rows = []
    for mutant in mutants(result["kind"]):
        of = [case for case in seen if case["name"] == mutant.name]
        kinds = Counter(name for case in of for name in _names(case["simulate"]))
        rows.append(
            {
                "name": mutant.name,
                "breaks": mutant.breaks,
                "plans": len(of),
                **{by: sum(bool(case[by]) for case in of) for by in ("check", "simulate")},
                "failures": ", ".join(f.replace("_", " ") for f, _ in kinds.most_common(3)),
                "benign": mutant.benign,
            }
        )
    return rows, BROKEN_COLUMNS


def _names(found: str) -> list[str]:
    """Returns the names of failures; "refused" if a plan was not executed to its end."""
    names = found.split(", ") if found else []
    return names if all(name.isidentifier() for name in names) else ["refused"]


def disturbances(result: Row) -> Table:
    """Returns quantiles of the smallest disturbances, without plans that nothing broke."""
    rows = []
    for name, means in DISTURBANCES.items():
        values = [c[name] for c in cases(result["rows"], DISTURBED) if c.get(name) is not None]
        if not values:  # older results lack some
            continue
        rows.append({"name": means if name != "z" else f"z {means}", "count": len(values)})
        rows[-1] |= {q: _quantile(values, fraction) for q, fraction in LOW.items()}
    return rows, DISTURBANCE_COLUMNS


def promises(result: Row) -> Table:
    """Returns the histogram of the smallest disturbance over what z and `withstands` promise."""
    of = {
        "promised": "promised_ratio",
        "withstands": "withstands_ratio",
        "compliant index": "compliant_ratio",
        "z": "ratio",
    }
    found = {
        name: [
            math.inf if case[ratio] is None else case[ratio]
            for case in cases(result["rows"], DISTURBED)
            if ratio in case  # rows that promise nothing, and older files, lack some
        ]
        for name, ratio in of.items()
    }
    found = {name: ratios for name, ratios in found.items() if ratios}
    rows = []
    for low, high in itertools.pairwise(EDGES):
        label = f"{low:g} to {high:g}" if high < math.inf else f"{low:g} or more, or not broken"
        counts = {
            name: sum(low <= ratio < high or ratio == high == math.inf for ratio in ratios)
            for name, ratios in found.items()
        }
        rows.append({"name": label} | counts)
    return rows, plain(*found)


def below(result: Row) -> str:
    """Returns how many tests broke below what the plan promised, with Wilson's bound of 95 %, and
    how large the promise is. Empty for other experiments.
    """
    seen = list(cases(result["rows"], DISTURBED))
    if not seen or not result["part"].endswith("_withstands"):
        return ""
    by_law = _broke_below(seen, "withstands_ratio")
    shares = [
        0.0 if c["smallest"] is None else c["withstands"] / max(c["smallest"], 1e-12) for c in seen
    ]
    most = 100 * statistics.wilson(by_law, len(seen), ONE_SIDED)[1]
    text = (
        f"Of {len(seen)} tests, {by_law} broke below what the row withstands with fingers in place "
        f"(95 %: fewer than {most:.2g} %); the median of that is "
        f"{np.median(shares):.2g} of what breaks it"
    )
    if "promised" not in seen[0]:  # older files lack it
        return text
    promising = [c for c in seen if "promised_ratio" in c]
    over = _broke_below(promising, "promised_ratio")
    bound = 100 * statistics.wilson(over, max(len(promising), 1), ONE_SIDED)[1]
    return (
        f"{text}. Of {len(promising)} tests with a promise, {over} broke below it (95 %: fewer "
        f"than {bound:.2g} %); in {len(seen) - len(promising)}, the fingers' springs were bent by "
        "more than the row tolerates"
    )


def _broke_below(seen: list[Row], ratio: str) -> int:
    return sum(not (case[ratio] is None or case[ratio] >= 1) for case in seen)


def _quantile(values: list[Any], fraction: float, factor: float = 1.0) -> float | None:
    """Returns the least value that at least this fraction does not exceed."""
    return factor * statistics.quantile(values, fraction) if values else None


def _in_units(means: str) -> tuple[float, str, str]:
    """Returns a factor, its unit, and the meaning without the unit at its end."""
    found = re.fullmatch(r"(.*) \[(.*)\]", means)
    if found is None:
        return 1.0, "", means
    factor, unit = UNITS.get(found[2], (1.0, found[2]))
    return factor, f" [{unit}]", found[1]


def _figure(value: float | None) -> str:
    return "–" if value is None else f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"


def _share(part: float, whole: float) -> str:
    """Returns a share, rounded down so that a missed goal never looks met."""
    return f"{np.floor(1000 * part / whole + 1e-9) / 10:g} %"


def _asked(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:g} %"


def _met(row: Row) -> str:
    """Returns the highest requirement that a share meets, or "missed"."""
    asked = {"goal": row["goal"], "must": row["must"]}
    reached = [name for name, share in asked.items() if share is not None]
    kept = [name for name in reached if row["held"] >= asked[name] * row["asked"] - 1e-9]
    return "–" if not reached else kept[0] if kept else "missed"


def _of(of: str, quantile: str) -> Column:
    return f"{of} {quantile}", lambda r: _figure(r[of][quantile])


CLAIM_COLUMNS: list[Column] = [
    ("", lambda r: r["of"]),
    ("share", lambda r: _share(r["held"], r["asked"])),
    ("count", lambda r: f"{r['held']}/{r['asked']}"),
    ("must", lambda r: _asked(r["must"])),
    ("goal", lambda r: _asked(r["goal"])),
    ("met", _met),
]
FAILURE_COLUMNS: list[Column] = [
    (NOMINAL, lambda r: _figure(r[NOMINAL])),
    (VARIED, lambda r: _figure(r[VARIED])),
    (MEANING, lambda r: r["means"]),
]
MEASURE_COLUMNS: list[Column] = [
    *(_of(of, quantile) for of in (NOMINAL, VARIED) for quantile in SHOWN),
    (MEANING, lambda r: r["means"]),
]


def _error(measure: str, quantile: str, unit: str) -> Column:
    title = f"{measure.partition('_')[0]} {quantile} [{unit}]"
    return title, lambda r: _figure(r[measure][quantile])


CONDITION_COLUMNS: list[Column] = [
    *plain("trials", "held"),
    *(_error("position_error", quantile, "mm") for quantile in SHOWN),
    *(_error("angle_error", quantile, "deg") for quantile in SHOWN),
    ("new plans", lambda r: str(r["plans"])),
    ("failures", lambda r: r["failures"] or "–"),
]


REPLAN_COLUMNS: list[Column] = [
    ("trials", lambda r: str(r["count"])),
    *((f"{quantile} [ms]", lambda r, q=quantile: _figure(r[q])) for quantile in SLOW),
]


PROOF_COLUMNS: list[Column] = [
    ("tasks", lambda r: str(r["count"])),
    *(_of("plans", quantile) for quantile in SHOWN),
    *((f"{title} [s]", show) for title, show in (_of("seconds", q) for q in ("median", "max"))),
    ("failed trials of the best plan", lambda r: r["failures"] or "–"),
]


BROKEN_COLUMNS: list[Column] = [
    *plain("plans", "check", "simulate"),
    ("fails by", lambda r: r["failures"] or "–"),
    (MEANING, lambda r: r["breaks"] + (f". Benign: {r['benign']}" if r["benign"] else "")),
]


DISTURBANCE_COLUMNS: list[Column] = [
    ("plans", lambda r: str(r["count"])),
    *((quantile, lambda r, q=quantile: _figure(r[q])) for quantile in LOW),
]
