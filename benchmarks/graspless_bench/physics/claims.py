# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Requirements on plans in the physics engine, each with the required share."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graspless.simulation.slide.conditions import CONDITIONS

from . import locked
from .mutants import mutants
from .work import CLOSED, OPEN

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ..machine import Row

NOMINAL, VARIED, DISTURBED, PROVEN = "nominal", "varied", "disturbed", "proven"
BROKEN = "broken"
DEGREE = math.pi / 180
SEARCHES = {"resume": "rest of the slide planned", "anew": "whole plan made anew"}


@dataclass(frozen=True)
class Claim:
    """Requirement on the share of trials, or of disturbed plans.

    Attributes
    ----------
    what : str
        Description.
    of : str
        NOMINAL or VARIED trials, a condition and a loop ("kick, closed"), a loop in all conditions
        ("closed"), DISTURBED plans, or the PROVEN best plan of a search, or BROKEN plans.
    holds : function
        Returns True if a trial fulfils it, by its failures and measures, or its disturbance. None:
        it does not apply.
    must, goal : float or None
        Required share.
    """

    what: str
    of: str
    holds: Callable[[Row], bool | None]
    must: float | None = None
    goal: float | None = None


def cases(rows: list[Row], of: str) -> Iterator[Row]:
    """Yields trials of all plans as {failures, seconds, measures by name}; or disturbances; or
    proofs with the seconds of the whole search; or what finds each mutant of each plan.
    """
    for row in rows:
        if of == BROKEN:
            for name, found in (row.get("mutants") or {}).items():
                yield {"name": name, **found}
            continue
        if of == PROVEN:
            if "proof" in row:
                yield row["proof"] | {"seconds": row["seconds"][0]}
            continue
        if of == DISTURBED:
            found = row["disturbed"] or []
            yield from found if isinstance(found, list) else [found]
            continue
        for k, failures in enumerate(row["failures"]):
            label = row["of"][k] if "of" in row else VARIED if k else NOMINAL
            if label == of or label.endswith(f", {of}"):
                figures = {name: values[k] for name, values in row["measures"].items()}
                known = {"failures": failures, "seconds": row["seconds"][k]}
                yield known | {"tube": row.get("tube")} | figures  # older files have no tube


def _at_most(limits: dict[str, float], *failures: str) -> Callable[[Row], bool]:
    def holds(case: Row) -> bool:
        known = all(case.get(name) is not None for name in limits)
        return known and all(case[n] <= most for n, most in limits.items()) and free(case)

    free = _without(*failures)
    return holds


def _without(*failures: str) -> Callable[[Row], bool]:
    return lambda case: not set(failures) & set(case["failures"])


def _where_pulled(failure: str) -> Callable[[Row], bool | None]:
    """Returns a test that does not apply to a hand that closed without the loop."""

    def holds(case: Row) -> bool | None:
        was_pulled = case.get("open_pull", 0.0) is not None
        return failure not in case["failures"] if was_pulled else None

    return holds


def _holds_but(*failures: str) -> Callable[[Row], bool]:
    return lambda case: not set(case["failures"]) - set(failures)


def _ratio(name: str, least: float, below_z: float = math.inf) -> Callable[[Row], bool | None]:
    def holds(case: Row) -> bool | None:
        if name not in case or not case["z"] < below_z:  # older files and rows lack some
            return None
        return case[name] is None or bool(case[name] >= least)  # None: nothing broke it

    return holds


def _arrives(of: str, limit: float, must: float | None = None, goal: float | None = None) -> Claim:
    """Returns the claim that slides end within a limit [mm, deg] of the planned pose."""
    holds = _at_most({"position_error": limit / 1000, "angle_error": limit * DEGREE}, "fell")
    what = f"within {limit:g} mm and {limit:g} deg of the planned pose after the slide, not fallen"
    return Claim(what, of, holds, must, goal)


def used_of_tube(case: Row) -> tuple[float, float] | None:
    """Returns position and angle error over the bounds of the plan; None without either."""
    tube, position, angle = case.get("tube"), case.get("position_error"), case.get("angle_error")
    if tube is None or position is None or angle is None:
        return None
    return position / tube["position"], angle / tube["angle"]


def _in_tube(case: Row) -> bool | None:
    if case.get("tube") is None:
        return None
    used = used_of_tube(case)  # None: the object fell
    return used is not None and max(used) <= 1


def _vertices(of: str, limit: float, must: float | None, goal: float | None) -> Claim:
    holds = _at_most({"vertex_error": limit / 1000})
    return Claim(f"vertices within {limit:g} mm", of, holds, must, goal)


_LIFTED = _without("fell", "not_grasped", "dropped", "out_of_reach")
_COMPLIANT = _ratio("compliant_ratio", 1.0)
_WITHSTOOD = _ratio("withstands_ratio", 1.0)
_CLASPED = _holds_but("open_hand_holds")
_CLASPED_LOCKED = _holds_but("open_hand_holds", "forced_open")
_LOST_OPEN = _where_pulled("open_hand_holds")


def _clasped_dragged(case: Row) -> bool | None:
    held = case.get("held_dragged")
    return None if held is None else _CLASPED_LOCKED(case) and held == case["sequences"]


def _held_if_caged(case: Row) -> bool | None:
    return not case["failures"] if case["caged"] else None


def _is_narrow(case: Row) -> bool:
    return bool(case["upper"] - case["lower"] <= 0.002 + 1e-6)


def _in_closed_loop(condition: str) -> list[Claim]:
    """Returns the claims on a condition."""
    of = f"{condition}, {CLOSED}"
    return [
        Claim("held and lifted", f"{condition}, {OPEN}", lambda case: not case["failures"]),
        Claim("held and lifted", of, lambda case: not case["failures"], 0.98, 0.995),
        _within(of, 5, 3, 0.95, None),
        _within(of, 3, 2, None, 0.95),
    ]


def _within(
    of: str, position: float, angle: float, must: float | None, goal: float | None
) -> Claim:
    limits = {"position_error": position / 1000, "angle_error": angle * DEGREE}
    return Claim(f"within {position:g} mm and {angle:g} deg", of, _at_most(limits), must, goal)


def _replanned() -> list[Claim]:
    """Returns the claims on the longest search of each trial in closed loop."""

    def within(name: str, most: float) -> Callable[[Row], bool | None]:
        return lambda case: None if case.get(name) is None else bool(case[name] <= most)

    return [
        Claim(f"{what} within {ms:g} ms", CLOSED, within(f"{kind}_seconds", ms / 1000), must, goal)
        for kind, what in SEARCHES.items()
        for ms, must, goal in ((10, 0.99, None), (3, None, 0.99))
    ]


def is_proven(case: Row) -> bool:
    """Returns True if all trials of a proof held."""
    return bool(case["held"] == case["asked"])


def _at_first(case: Row) -> bool:
    return is_proven(case) and case["plans"] == 1


def _found(kind: str, *by: str) -> Callable[[Row], bool | None]:
    """Returns a test whether any of these finds a mutant. It does not apply to benign ones."""
    benign = {mutant.name for mutant in mutants(kind) if mutant.benign}
    return lambda case: None if case["name"] in benign else any(case[name] for name in by)


def _broken(kind: str) -> list[Claim]:
    return [
        Claim("`check` finds what matters", BROKEN, _found(kind, "check"), 0.95),
        Claim("`simulate` finds what matters", BROKEN, _found(kind, "simulate"), 0.95),
        Claim("either finds what matters", BROKEN, _found(kind, "check", "simulate"), 0.95),
    ]


_PROVEN = [
    Claim("the first plan holds in all trials", PROVEN, _at_first),
    Claim("a plan holds in all trials", PROVEN, is_proven, 0.99),
]


CLAIMS: dict[str, list[Claim]] = {
    "slide": [
        _arrives(NOMINAL, 5, 0.95, 0.995),
        Claim("lifted", NOMINAL, _LIFTED, 0.90, 0.99),
        _arrives(VARIED, 10, 0.85, 0.95),
        Claim("lifted", VARIED, _LIFTED, 0.80, 0.95),
        Claim("within the plan's tube after the slide", NOMINAL, _in_tube),
        Claim("within the plan's tube after the slide", VARIED, _in_tube, 0.99),
        Claim("simulated within 20 s", NOMINAL, _at_most({"seconds": 20}), 1.0),
        Claim("simulated within 5 s", NOMINAL, _at_most({"seconds": 5}), None, 1.0),
    ],
    "slide_ablation": [
        _arrives(NOMINAL, 5),
        Claim("lifted", NOMINAL, _LIFTED),
        _arrives(VARIED, 10),
        Claim("lifted", VARIED, _LIFTED),
    ],
    "slide_closed_loop": [
        *(claim for condition in CONDITIONS for claim in _in_closed_loop(condition)),
        *_replanned(),
    ],
    "slide_prove": _PROVEN,
    "slide_mutants": _broken("slide"),
    "fingertip": [
        _vertices(NOMINAL, 1, 0.95, None),
        _vertices(NOMINAL, 0.6, None, 0.99),
        _vertices(VARIED, 1.5, 0.95, None),
        _vertices(VARIED, 0.7, None, 0.99),
    ],
    "fingertip_disturb": [
        Claim("holds without a disturbance", DISTURBED, lambda case: case["smallest"] != 0),
        Claim("breaks at 0.7 z or more", DISTURBED, _ratio("ratio", 0.7), 0.95),
        Claim(
            "breaks at 0.9 z or more, if z < 5 N", DISTURBED, _ratio("ratio", 0.9, 5.0), None, 0.95
        ),
        Claim("breaks at the compliant index or more", DISTURBED, _COMPLIANT, None, 0.99),
        Claim("breaks at what it withstands or more", DISTURBED, _WITHSTOOD, 0.99),
    ],
    "fingertip_withstands": [
        Claim("holds without a disturbance", DISTURBED, lambda case: case["smallest"] != 0),
        Claim("breaks at the promise or more", DISTURBED, _ratio("promised_ratio", 1.0), 0.99),
        Claim("breaks at what it withstands or more", DISTURBED, _WITHSTOOD, 0.99),
        Claim("breaks at z or more", DISTURBED, _ratio("ratio", 1.0)),
        Claim("breaks at the compliant index or more", DISTURBED, _COMPLIANT),
    ],
    "fingertip_prove": _PROVEN,
    "fingertip_mutants": _broken("fingertip"),
    "clasp": [
        Claim("holds", NOMINAL, _CLASPED, 0.95, 1.0),
        Claim("the open hand loses the object", NOMINAL, _LOST_OPEN, 0.95, 1.0),
        Claim("holds, with drag on the object", NOMINAL, _clasped_dragged),
        Claim("holds, with locked motors", NOMINAL, _CLASPED_LOCKED),
        Claim("holds", VARIED, _CLASPED),
        Claim("holds, with drag on the object", VARIED, _clasped_dragged),
        Claim("holds, with locked motors", VARIED, _CLASPED_LOCKED),
        Claim("the open hand loses the object", VARIED, _LOST_OPEN),
    ],
    "clasp_prove": _PROVEN,
    "clasp_mutants": _broken("clasp"),
    "clasp_locked": [
        Claim("held", locked.CLOSED, lambda case: not case["failures"]),
        Claim("caged", locked.CLOSED, lambda case: bool(case["caged"])),
        Claim("held if caged", locked.CLOSED, _held_if_caged, 1.0),
        Claim("held if caged", locked.OPENED, _held_if_caged, 1.0),
        Claim("interval of 2 mm", locked.CLOSED, _is_narrow, 1.0),
        Claim("certificate within 1 s", locked.CLOSED, _at_most({"certificate_seconds": 1}), 1.0),
    ],
}
