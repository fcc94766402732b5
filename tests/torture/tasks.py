# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random tasks of all kinds, small and absurdly large, drawn from a seed."""

from __future__ import annotations

import json
import math
import random
from pathlib import Path
from typing import Any

Document = dict[str, Any]
Random = random.Random


def circle(rng: Random, corners: int, radius: float, x: float = 0.0) -> list[list[float]]:
    """Returns a round outline, convex or a little rough."""
    rough = rng.choice([0, 0, 1e-3])
    angles = (2 * math.pi * i / corners for i in range(corners))
    return [
        [round(x + r * math.cos(a), 9), round(r * math.sin(a), 9)]
        for a in angles
        for r in [radius * (1 + rough * rng.random())]
    ]


def ring(rng: Random, points: int) -> list[list[float]]:
    """Returns points on a torus: a cloud with a hole."""
    found = []
    for _ in range(points):
        a, b = rng.uniform(0, 2 * math.pi), rng.uniform(0, 2 * math.pi)
        r = 0.12 + 0.02 * math.cos(b)
        found.append([r * math.cos(a), r * math.sin(a), 0.02 * math.sin(b)])
    return found


def boxes(rng: Random) -> list[Document]:
    """Returns obstacles out of the way, in any number."""
    return [
        {
            "name": f"box{i}",
            "box": [0.02, 0.02, 0.02],
            "pose": {"position": [rng.uniform(-1, 0), rng.uniform(2, 3), rng.uniform(0, 1)]},
        }
        for i in range(rng.choice([0, 0, 2, 50, 800]))
    ]


def sphere(rings: int) -> tuple[list[list[float]], list[list[int]]]:
    """Returns vertices and triangles of a ball of radius 0.05 m."""
    n = 2 * rings
    vertices = [[0.0, 0.0, 0.05], [0.0, 0.0, -0.05]]
    for i in range(1, rings):
        polar = math.pi * i / rings
        for j in range(n):
            r, a = 0.05 * math.sin(polar), 2 * math.pi * j / n
            vertices.append([r * math.cos(a), r * math.sin(a), 0.05 * math.cos(polar)])
    triangles = []
    for j in range(n):
        k = (j + 1) % n
        triangles += [[0, 2 + j, 2 + k], [1, len(vertices) - n + k, len(vertices) - n + j]]
        for i in range(rings - 2):
            a, b = 2 + i * n, 2 + (i + 1) * n
            triangles += [[a + j, b + j, b + k], [a + j, b + k, a + k]]
    return vertices, triangles


def slide(rng: Random, folder: Path) -> Document:
    """Returns a slide: outlines of many corners, clouds of many points, tiny steps."""
    thing: Document = {"name": "card", "thickness": 0.003}
    shape = rng.choice(["rectangle", "rectangle", "circle", "polygon", "cloud"])
    if shape == "cloud":
        points = [[rng.uniform(-0.06, 0.06), rng.uniform(-0.04, 0.04), 0.003]
                  for _ in range(rng.choice([500, 20_000, 200_000]))]  # fmt: skip
        thing["cloud"] = _cloud(folder, points)
    else:
        thing[shape] = {
            "rectangle": {"size": [0.12, 0.08]},
            "circle": {"radius": 0.06, "points": rng.choice([12, 500, 4000, 10_000])},
            "polygon": circle(rng, rng.choice([12, 500, 4000]), 0.06),
        }[shape]
        thing["spacing"] = rng.choice([0.006, 0.006, 5e-5])
    thing["pose"] = {"x": 0.62, "y": 0.08, "yaw": 0.4}
    support = rng.choice([
        {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}},
        {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}},
        {"polygon": circle(rng, rng.choice([20, 1000, 20_000]), 0.35, 0.65)},
    ])  # fmt: skip
    options = {
        "search": rng.choice(["fast", "paper"]),
        "range": rng.choice([0.1, 0.1, 1e-4, 1e-12]),
        "resolution": rng.choice([0.01, 0.01, 1e-4]),
        "min_overhang": rng.choice([0.02, 0.02, 0.2]),
    }
    return {
        "kind": "slide",
        "robot": {"urdf": rng.choice(["wam_t42", "kr5_t42"])},
        "object": thing,
        "support": support,
        "obstacles": boxes(rng),
        "options": options,
    }


def fingertip(rng: Random, _: Path) -> Document:
    """Returns a push, a tumble, a lattice or a goal, with up to 4 fingers and 10^6 locations."""
    thing: Document = {"name": "block", "box": [0.05, 0.05, 0.10], "mass": 1.0}
    if rng.random() < 0.2:
        vertices, triangles = sphere(rng.choice([4, 30, 120]))
        thing = {"name": "ball", "vertices": vertices, "triangles": triangles, "mass": 1.0}
    step = rng.choice([30, 30, 3000, 20_000])
    side = rng.choice([9, 41, 301])  # 0.05 is a value of each
    motion = rng.choice([
        {"slide": {"translation": [0.1, 0, 0], "segments": step}},
        {"tumble": {"over": "+x", "segments": step}},
        {"turn": {"angle": 1.0, "segments": step}},
        {"lattice": {"goal": {"position": [0.1, 0.05, 0.05]}, "lower": [-0.1, -0.1, 0],
                     "upper": [0.1, 0.1, 0], "counts": [side, side, 1]}},
        {"goal": {"pose": {"position": [0.15, 0.1, 0.05]}, "max_tumbles": rng.randint(0, 6),
                  "slide_step": rng.choice([0.01, 1e-4]), "turn_step": 0.05}},
    ])  # fmt: skip
    if "box" not in thing:
        motion = {"slide": {"translation": [0.1, 0, 0], "segments": step}}
    far = [{"name": "far", "normal": [1, 0, 0], "offset": -3.0}]
    walls = [
        {"name": "behind", "normal": [1, 0, 0], "offset": -0.03},
        {"name": "beside", "normal": [0, -1, 0], "offset": -0.03},
    ]
    return {
        "kind": "fingertip",
        "object": thing,
        "fingers": {"count": rng.randint(1, 4), "radius": rng.choice([0.01, 0.002])},
        "friction": rng.choice([0.5, 0.5, [0.4, 0.6]]),
        "walls": rng.choice([[], walls if "tumble" in motion and "box" in thing else far]),
        "motion": motion,
        "options": {
            "search": rng.choice(["fast", "fast", "fast", "paper", "dijkstra"]),
            "locations_per_side": rng.choice([5, 7, 20, 31, 400]),
            "samples_per_arc": rng.choice([3, 3, 100]),
            "cone_edges": rng.choice([6, 6, 64]),
            "max_memory": rng.choice([4e9, 1e8, 2e7]),
        },
    }


def clasp(rng: Random, folder: Path) -> Document:
    """Returns a clasp of a sample, or of a cloud of up to 100,000 points."""
    thing: Document = {"name": "thing", "pose": {"position": [0.62, 0.05, 0.0]}}
    if rng.random() < 0.5:
        thing["sample"] = rng.choice(["purse", "bag", "travel_bag", "chair", "lawn_mower"])
        thing["points"] = rng.choice([500, 2000, 50_000])
    else:
        points = ring(rng, rng.choice([500, 5000, 50_000, 100_000]))
        thing["cloud"] = _cloud(folder, points)
    thing["loops"] = {"max_points": rng.choice([2000, 10_000, 200_000])}
    if rng.random() < 0.2:
        thing["views"] = [[1.0, 0.5, 1.0], [-1.0, 0.5, 1.0]]
    return {
        "kind": "clasp",
        "robot": {"urdf": rng.choice(["kr5_sdh", "kr5_dlr", "wam_t42"])},
        "object": thing,
        "obstacles": boxes(rng),
        "options": {
            "targets": rng.choice([0, 0, 10_000]),
            "resolution": rng.choice([0.01, 1e-4]),
            "stability": {"sequences": rng.choice([10, 100, 1000])},
            "max_memory": rng.choice([4e9, 5e7]),
        },
    }


def carry(rng: Random, _: Path) -> Document:
    """Returns a carry: short or out of reach, in steps of any size."""
    return {
        "kind": "carry",
        "robot": {
            "urdf": "wam_t42",
            "home": {"wam_joint_2": 0.7, "wam_joint_4": 1.6, "wam_joint_6": 0.84},
        },
        "frame": "grasp",
        "object": {"name": "bar", "box": [0.02, 0.02, 0.10]},
        "pose": {"position": [0.65, 0.0, 0.29]},
        "offset": rng.choice([[0, 0.2, 0.08], [0, 0.4, 0.3], [0, 0, 500.0]]),
        "obstacles": boxes(rng),
        "options": {
            "step": rng.choice([0.01, 0.01, 1e-4]),
            "resolution": rng.choice([0.01, 1e-4]),
            "max_twist": rng.choice([0.0, 0.5, 3.0]),
            "max_memory": rng.choice([4e9, 5e7]),
        },
    }


def chain(rng: Random, folder: Path) -> Document:
    """Returns a slide with a carry after it."""
    first = slide(rng, folder)
    first.pop("kind")
    options = first.pop("options")
    lift = {"direction": [0, 0, 1], "distance": rng.choice([0.1, 1.0])}
    steps = {"step": rng.choice([0.01, 1e-4])}
    return first | {
        "kind": "chain",
        "stages": [
            {"name": "slide", "kind": "slide", "options": options},
            {"name": "lift", "kind": "carry", "line": lift, "options": steps},
        ],
        "options": {"attempts": rng.choice([1, 5])},
    }


KINDS = {"slide": slide, "fingertip": fingertip, "clasp": clasp, "carry": carry, "chain": chain}


def draw(seed: int, index: int, folder: Path) -> tuple[str, Path, float]:
    """Writes a task to the folder; returns its kind, its file and its time limit [s]."""
    rng = Random(f"{seed} {index}")
    kind = list(KINDS)[index % len(KINDS)]
    seconds = round(math.exp(rng.uniform(math.log(0.05), math.log(2))), 3)
    path = folder / f"{index}.yaml"
    path.write_text(json.dumps(KINDS[kind](rng, folder)))
    return kind, path, seconds


def _cloud(folder: Path, points: list[list[float]]) -> str:
    path = folder / f"{len(points)}_{sum(points[0]):.6f}.xyz"
    path.write_text("\n".join(f"{x:.6f} {y:.6f} {z:.6f}" for x, y, z in points))
    return path.name
