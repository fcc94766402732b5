# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Certificates of clasps against a hand with locked motors in the physics engine."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import clasp
from graspless.kinds import part

from ..tables import milliseconds, or_dash, plain

if TYPE_CHECKING:
    from collections.abc import Callable

    from graspless.clasp import Plan
    from graspless.frames import Matrix

    from ..machine import Row
    from ..tables import Column

CLOSED, OPENED = "closed", "opened"
OPENINGS = 2  # partly open hands for each plan
SHARES = 0.05, 0.7  # how far these are opened, of the way to the open state
SEQUENCES = 3  # of random wrenches
LOST = "lost"
SCORES: dict[str, Callable[[Row], float]] = {
    "certificate, upper bound": lambda case: -case["upper"],
    "certificate, middle of the interval": lambda case: -case["upper"] - case["lower"],
    "random moves, margin": lambda case: case["margin"],
    "virtual linking, least finger": lambda case: case["linking"],
}
FAILURES = {LOST: "random wrenches took the loop out of the locked hand"}
MEASURES = {
    "caged": "1 if the certificate proves that the loop cannot leave",
    "upper": "upper bound on the opening [m]",
    "lower": "lower bound on the opening [m]",
    "margin": "margin of the stability test of random moves",
    "linking": "least virtual linking of a finger",
    "certificate_seconds": "time of the certificate [s]",
    "moves_seconds": "time of the random moves [s]",
}


def measure(plan: Plan, seed: int) -> Row:
    """Returns the trials of a plan: its closed hand, then partly open ones, all locked."""
    random = np.random.default_rng(seed)
    shares = [0.0, *random.uniform(*SHARES, OPENINGS)]
    cases = [_case(plan, _opened(plan, share), [seed, k]) for k, share in enumerate(shares)]
    return {
        "of": [CLOSED, *[OPENED] * OPENINGS],
        "failures": [case.pop("failures") for case in cases],
        "seconds": [case.pop("seconds") for case in cases],
        "measures": {name: [case[name] for case in cases] for name in MEASURES},
    }


def _opened(plan: Plan, share: float) -> Matrix:
    robot, hand = plan.task.problem.robot, plan.task.problem.hand
    q = np.array(plan.segments[-1].positions[-1])
    joints = robot.group(hand.hand)
    q[joints] += share * (np.asarray(robot.clamp(robot.state(hand.open))) - q)[joints]
    return q


def _case(plan: Plan, q: Matrix, seed: list[int]) -> Row:
    simulation: Any = part("simulation", "clasp")
    problem, loop, options = plan.task.problem, plan.loop, plan.task.options
    assert loop is not None
    shape = clasp.StabilityOptions(force=0.0, torque=0.0)
    times = [time.perf_counter()]
    found = clasp.certificate(problem, q, loop, options.certificate)
    times.append(time.perf_counter())
    margin = clasp.test_stability(problem, q, loop, shape).margin
    times.append(time.perf_counter())
    held, linking = simulation.held_locked(plan, q, [[*seed, k] for k in range(SEQUENCES)])
    times.append(time.perf_counter())
    return {
        "failures": [] if held else [LOST],
        "seconds": times[3] - times[2],
        "caged": float(found.caged),
        "upper": found.upper,
        "lower": found.lower,
        "margin": margin,
        "linking": linking,
        "certificate_seconds": times[1] - times[0],
        "moves_seconds": times[2] - times[1],
    }


def area(scores: list[float], held: list[bool]) -> float | None:
    """Returns the area under the ROC curve; None if all held or none did."""
    good = np.array([s for s, h in zip(scores, held, strict=True) if h])
    bad = np.array([s for s, h in zip(scores, held, strict=True) if not h])
    if good.size == 0 or bad.size == 0:
        return None
    above = good[:, None] > bad[None]
    return float((above + 0.5 * (good[:, None] == bad[None])).mean())


def scores(cases: list[Row]) -> tuple[list[Row], list[Column]]:
    """Returns how well each number tells the hands that held from those that lost the loop."""
    held = [not case["failures"] for case in cases]
    rows = [
        {"name": name, "area": area([score(case) for case in cases], held)}
        for name, score in SCORES.items()
    ]
    return rows, [("area under the curve", lambda r: or_dash(r["area"], ".3g"))]


def intervals(cases: list[Row]) -> tuple[list[Row], list[Column]]:
    """Returns what the certificate says of the hands that are caged, and of the others."""
    rows = []
    for name, caged in (("caged", 1.0), ("not proven", 0.0)):
        of = [case for case in cases if case["caged"] == caged]
        widths = [case["upper"] - case["lower"] for case in of]
        rows.append(
            {
                "name": name,
                "hands": len(of),
                "held": sum(not case["failures"] for case in of),
                "narrow": sum(width <= 0.002 + 1e-9 for width in widths),
                "width": 1000 * float(np.median(widths)) if of else None,
                "ms": [1000 * case["certificate_seconds"] for case in of],
                "moves": [1000 * case["moves_seconds"] for case in of],
            }
        )
    return rows, [
        *plain("hands", "held"),
        ("interval of 2 mm", lambda r: str(r["narrow"])),
        ("width, median [mm]", lambda r: or_dash(r["width"], ".3g")),
        ("certificate, median [ms]", lambda r: milliseconds(_middle(r["ms"]))),
        ("max [ms]", lambda r: milliseconds(max(r["ms"], default=None))),
        ("random moves, median [ms]", lambda r: milliseconds(_middle(r["moves"]))),
    ]


def _middle(values: list[float]) -> float | None:
    return float(np.median(values)) if values else None
