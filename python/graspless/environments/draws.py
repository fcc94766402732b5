# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random tasks, one function for each environment."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.random import Generator

_TABLE = {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}}
_BUDGET = {"seconds": 20}


def slide_to_edge(random: Generator) -> dict[str, Any]:
    """A card of random size anywhere on a table: it is slid to the edge, grasped and lifted."""
    return {
        "kind": "slide",
        "robot": {"urdf": "wam_t42"},
        "object": {
            "name": "card",
            "rectangle": {"size": random.uniform([0.10, 0.06], [0.14, 0.10]).tolist()},
            "thickness": float(random.uniform(0.002, 0.004)),
            "pose": _pose(random, [0.50, -0.20, -np.pi], [0.80, 0.20, np.pi]),
        },
        "support": _TABLE,
        "budget": _BUDGET,
    }


def tumble(random: Generator) -> dict[str, Any]:
    """A block of random size on the floor: two fingertips of a hand tip it over."""
    width, height = random.uniform([0.038, 0.075], [0.042, 0.085]).tolist()
    x, y = random.uniform([0.57, -0.03], [0.63, 0.03]).tolist()
    return {
        "kind": "fingertip",
        "object": {"name": "block", "box": [width, width, height], "mass": 0.15},
        "fingers": {"count": 2, "radius": 0.013, "max_normal_force": 10, "friction": 0.8},
        "friction": 0.8,
        "motion": {
            "tumble": {"over": "+x", "pose": {"position": [x, y, height / 2]}, "segments": 18}
        },
        "robot": {"urdf": "wam_t42_tips"},
        "carrier": {
            "fingertips": ["left_tip_center", "right_tip_center"],
            "links": [["left_finger"], ["right_finger"]],
        },
        "options": {"min_stability": 0.1},
        "budget": _BUDGET,
    }


def clasp(random: Generator) -> dict[str, Any]:
    """A purse, known as a cloud of points, in front of the arm: the hand closes on its handle."""
    x, y, yaw = random.uniform([0.66, -0.06, 0.9], [0.74, 0.06, 1.5]).tolist()
    return {
        "kind": "clasp",
        "robot": {"urdf": "wam_t42"},
        "object": {
            "name": "purse",
            "sample": "purse",
            "pose": {"position": [x, y, -0.2], "rpy": [0, 0, yaw]},
        },
        "budget": _BUDGET,
    }


def pick(random: Generator) -> dict[str, Any]:
    """A box to be pinched where it stands, or a card to be slid to the edge; then a lift."""
    is_box = random.uniform() < 0.5
    size, low, high = (
        ([0.09, float(random.uniform(0.03, 0.05))], 0.08, 0.12)
        if is_box
        else ([0.12, 0.08], 0.002, 0.004)
    )
    return {
        "kind": "chain",
        "robot": {"urdf": "wam_t42"},
        "object": {
            "name": "box" if is_box else "card",
            "rectangle": {"size": size},
            "thickness": float(random.uniform(low, high)),
            "pose": _pose(random, [0.55, -0.15, -np.pi], [0.75, 0.15, np.pi]),
        },
        "support": _TABLE,
        "stages": [
            {"name": "grasp", "kind": "pinch" if is_box else "slide"},
            {
                "name": "lift",
                "kind": "carry",
                "line": {"direction": [0, 0, 1], "distance": 0.10},
            },
        ],
        "budget": _BUDGET,
    }


def _pose(random: Generator, low: list[float], high: list[float]) -> dict[str, float]:
    return dict(zip(("x", "y", "yaw"), random.uniform(low, high).tolist(), strict=True))


DRAWS: dict[str, Callable[[Generator], dict[str, Any]]] = {
    "SlideToEdge": slide_to_edge,
    "Tumble": tumble,
    "Clasp": clasp,
    "Pick": pick,
}

_LIFTED = ("close", "squeeze", "raise", "hold")
_SLIDE = ("approach", "press", "slide", "lift", "reach", "grasp", *_LIFTED)
PHASES: dict[str, tuple[str, ...]] = {  # of the simulation
    "SlideToEdge": _SLIDE,
    "Tumble": ("approach", "touch", "load", "tumble", "release", "retreat", "rest"),
    "Clasp": ("settle", "reach", "close", "grip"),
    "Pick": _SLIDE,  # a pinch has no others
}
SENTENCES = {
    "SlideToEdge": "slide the card to the edge of the table, grasp it there and lift it",
    "Tumble": "tip the block over with two fingertips",
    "Clasp": "put the hand through the handle and close it",
    "Pick": "pick up the object",
}
