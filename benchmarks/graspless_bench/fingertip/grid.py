# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of the fingertip planner: the paper's four cases, and larger ones.

The paper's unit of length is 1 m here. The cork cuboid has its real size.
"""

from __future__ import annotations

import dataclasses
import math
import random
import warnings
from typing import TYPE_CHECKING, Any

from graspless.tasks import task_from_dict

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from graspless.tasks import Task

ENGINES = ("fast", "paper", "dijkstra")

# CPU minutes on a 2.8 GHz Pentium 4, Section 5: with the heuristic (11), and without.
PAPER_MINUTES = {"a": (533, 1007), "b": (203, 378), "c": (84, 1294), "d": (990, 1296)}
# What an independent implementation of the paper's graph, searched exhaustively, found [m].
REFERENCE_COSTS = {"a": 10.016453262, "b": 10.043263194, "c": 10.264282664, "d": 117.392208834}

BEHIND = {"name": "behind", "normal": [1, 0, 0], "offset": -3.0}
BESIDE = {"name": "beside", "normal": [0, -1, 0], "offset": -3.0}
LIMITS = {"fast": 60.0, "paper": 300.0, "dijkstra": 900.0}  # [s]


@dataclasses.dataclass(frozen=True)
class Trial:
    """One query.

    Attributes
    ----------
    case : str
        Name in results.
    document : dict
        Task in the form of a task file.
    engine : str
        Name in ENGINES.
    """

    case: str
    document: dict[str, Any]
    engine: str = "fast"

    def make_task(self, seconds: float | None = None) -> Task:
        """Returns the task without explanations, so that a failure takes only the search time."""
        options = self.document.get("options", {}) | {"search": self.engine, "explain": False}
        limit = seconds or LIMITS[self.engine]
        extra = {"options": options, "budget": {"seconds": limit}}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # metres for the paper's units of length
            return task_from_dict(self.document | extra, f"bench: {self.case}", resolve=True)

    @property
    def threads(self) -> int:
        return int(self.document.get("options", {}).get("threads", 1))

    @property
    def fingers(self) -> int:
        return int(self.document["fingers"].get("count", 2))


def slide(max_normal_force: float = 10.0, segments: int = 30) -> dict[str, Any]:
    """Cases a (10 N) and b (5 N): along the short side, by 10."""
    motion = {"slide": {"translation": [10.0, 0.0, 0.0], "segments": segments}}
    return _task([5.0, 10.0, 5.0], motion, max_normal_force=max_normal_force)


def tumble(*, has_side_wall: bool, segments: int = 30) -> dict[str, Any]:
    """Cases c (a wall behind) and d (another beside): over the edge in front."""
    walls = [BEHIND, BESIDE] if has_side_wall else [BEHIND]
    motion = {"tumble": {"over": "+x", "segments": segments}}
    return _task([5.0, 5.0, 10.0], motion, walls=walls)


def cork() -> dict[str, Any]:
    """Cuboid of Section 5.3. The paper gives no force limit, fingertip radius or z_min."""
    return {
        "kind": "fingertip",
        "object": {"name": "cork cuboid", "box": [0.06, 0.06, 0.10], "mass": 0.092},
        "fingers": {"radius": 0.01, "max_normal_force": 5.0, "friction": 0.15},
        "friction": 1.2,
        "motion": {"tumble": {"over": "+x", "segments": 30}},
        "options": {"min_stability": 0.05},
    }


def _task(
    size: Sequence[float],
    motion: dict[str, Any],
    *,
    max_normal_force: float = 10.0,
    walls: Sequence[dict[str, Any]] = (),
) -> dict[str, Any]:
    return {
        "kind": "fingertip",
        "object": {"name": "cuboid", "box": list(size), "mass": 1.0},
        "fingers": {"radius": 1.0, "max_normal_force": max_normal_force, "friction": 0.7},
        "friction": 0.5,
        "walls": list(walls),
        "motion": motion,
    }


def _with(document: dict[str, Any], **options: Any) -> dict[str, Any]:
    return document | {"options": document.get("options", {}) | options}


def _with_fingers(document: dict[str, Any], count: int) -> dict[str, Any]:
    return document | {"fingers": document["fingers"] | {"count": count}}


CASES: dict[str, dict[str, Any]] = {
    "a": slide(10.0),
    "b": slide(5.0),
    "c": tumble(has_side_wall=False),
    "d": tumble(has_side_wall=True),
    "cork": cork(),
}


def paper(engines: Sequence[str]) -> Iterator[Trial]:
    """The paper's experiments."""
    for name, document in CASES.items():
        for engine in engines:
            yield Trial(name, document, engine)


def weak(engines: Sequence[str]) -> Iterator[Trial]:
    """Slide with decreasing force limits: from pressing and pushing to pushing alone."""
    for engine in engines:
        for force in (20.0, 10.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0):
            yield Trial(f"slide, {force:g} N", slide(force), engine)


def scaling(engines: Sequence[str]) -> Iterator[Trial]:
    """Finer lattices, and two threads."""
    for engine in engines:
        for name in ("a", "b"):
            yield Trial(f"{name}, 21 x 21", _with(CASES[name], locations_per_side=21), engine)
        yield Trial("c, 90 segments", tumble(has_side_wall=False, segments=90), engine)
        yield Trial("d, 90 segments", tumble(has_side_wall=True, segments=90), engine)
        for name in ("c", "d"):
            for threads in (1, 2):
                document = _with(CASES[name], threads=threads)
                yield Trial(f"{name}, {threads} thread{'s'[: threads - 1]}", document, engine)


def fingers(engines: Sequence[str]) -> Iterator[Trial]:
    """One to four fingers."""
    for engine in engines:
        for name in ("a", "c"):
            for count in (1, 2, 3, 4):
                plural = "" if count == 1 else "s"
                document = _with_fingers(CASES[name], count)
                yield Trial(f"{name}, {count} finger{plural}", document, engine)


def slide_and_turn(side: int) -> dict[str, Any]:
    """A slide with a turn, from one corner of a lattice of x, y and yaw to the other.

    The lattice has this many poses a side. With 30, steps are 1/3 and 3 degrees.
    """
    upper = [29 / 3, 29 / 3, math.radians(29 * 3)]
    goal = {"position": [upper[0], upper[1], 2.5], "rpy": [0.0, 0.0, upper[2]]}
    lattice = {"goal": goal, "lower": [0.0] * 3, "upper": upper, "counts": [side] * 3}
    return _task([5.0, 10.0, 5.0], {"lattice": lattice})


def se2(engines: Sequence[str]) -> Iterator[Trial]:
    """A slide with a turn over 30 x 30 x 30 poses."""
    for engine in engines:
        yield Trial("slide and turn, 30^3", slide_and_turn(30), engine)


def faces(engines: Sequence[str]) -> Iterator[Trial]:
    """Goals on another face. The planner finds the slides and tumbles."""
    poses = {
        "slide, tumble, slide": {"position": [12.0, 0.0, 2.5], "rpy": [0.0, math.pi / 2, 0.0]},
        "two tumbles": {"position": [15.0, 0.0, 5.0], "rpy": [0.0, math.pi, 0.0]},
    }
    for engine in engines:
        for name, pose in poses.items():
            motion = {"goal": {"pose": pose, "slide_step": 1 / 3, "turn_step": math.pi / 60 + 1e-9}}
            yield Trial(name, _task([5.0, 5.0, 10.0], motion), engine)


def arm(engines: Sequence[str]) -> Iterator[Trial]:
    """Tumbles of blocks of several sizes and places by the fingertips of a WAM."""
    for engine in engines:
        draw = random.Random(0).uniform
        for number in range(20):
            size = [round(draw(*side), 3) for side in ((0.03, 0.08), (0.03, 0.08), (0.05, 0.12))]
            place = [round(draw(0.4, 0.75), 3), round(draw(-0.3, 0.3), 3), size[2] / 2]
            pose = {"position": place, "rpy": [0.0, 0.0, round(draw(-math.pi, math.pi), 3)]}
            text = " x ".join(f"{1000 * side:.0f}" for side in size)
            document = {
                "kind": "fingertip",
                "object": {"name": "block", "box": size, "mass": round(draw(0.1, 0.4), 3)},
                "fingers": {"radius": 0.013, "friction": 0.8},
                "friction": 0.8,
                "motion": {"tumble": {"over": "+x", "pose": pose, "segments": 18}},
                "options": {"min_stability": 1.0},
                "robot": {"urdf": "wam_t42_tips"},
            }
            yield Trial(f"{number}: {text} mm", document, engine)


GRIDS: dict[str, tuple[Callable[[Sequence[str]], Iterator[Trial]], Sequence[str]]] = {
    "paper": (paper, ENGINES),
    "weak": (weak, ("fast",)),
    "scaling": (scaling, ("fast",)),
    "fingers": (fingers, ("fast",)),
    "se2": (se2, ("fast",)),
    "faces": (faces, ("fast",)),
    "arm": (arm, ("fast",)),
}
"""What makes the trials of a grid, and the engines it compares unless told otherwise."""
