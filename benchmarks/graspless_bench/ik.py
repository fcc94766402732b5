# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench ik`: closed forms of common arms, beside eaik and ssik from PyPI."""

from __future__ import annotations

import importlib
import json
import math
import tempfile
import time
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from graspless._commands import FOUND, NOT_FOUND
from graspless.robot import Ik, Robot

from .arguments import positive
from .tables import Column, aligned

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Iterator

    from numpy.typing import NDArray

    from .machine import Row

    Array = NDArray[np.float64]

RIGHT = math.pi / 2
LIMIT = math.pi  # of every joint [rad]
TOLERANCE = 1e-6  # a solution further from the pose is wrong [m, rad]
SAME = 1e-4  # solutions this close are one (sine of half the angle)
SWEEP = 16  # values of the free joint
PREBUILT = {"UR5e": "ur5e", "iiwa": "iiwa14", "Panda": "franka_panda"}  # of ssik

# Rows of Denavit and Hartenberg: a [m], alpha [rad], d [m].
ARMS: dict[str, list[tuple[float, float, float]]] = {
    "KR 5 sixx R850": [
        (0.075, -RIGHT, 0.335),
        (0.365, 0, 0),
        (0.09, -RIGHT, 0),
        (0, RIGHT, 0.405),
        (0, -RIGHT, 0),
        (0, 0, 0.08),
    ],
    "UR5e": [
        (0, RIGHT, 0.1625),
        (-0.425, 0, 0),
        (-0.3922, 0, 0),
        (0, RIGHT, 0.1333),
        (0, -RIGHT, 0.0997),
        (0, 0, 0.0996),
    ],
    "iiwa": [
        (0, -RIGHT, 0.34),
        (0, RIGHT, 0),
        (0, RIGHT, 0.4),
        (0, -RIGHT, 0),
        (0, -RIGHT, 0.4),
        (0, RIGHT, 0),
        (0, 0, 0.126),
    ],
    "Panda": [
        (0, -RIGHT, 0.333),
        (0, RIGHT, 0),
        (0.0825, RIGHT, 0.316),
        (-0.0825, -RIGHT, 0),
        (0, RIGHT, 0.384),
        (0.088, RIGHT, 0),
        (0, 0, 0.107),
    ],
}


def urdf_of(rows: list[tuple[float, float, float]]) -> str:
    """Returns a URDF of revolute joints about z, and a flange."""
    text = "<robot name='arm'><link name='l0'/>"
    origins = [(0.0, 0.0, 0.0), *rows]
    for i, (a, alpha, d) in enumerate(origins):
        kind = "fixed" if i == len(rows) else "revolute"
        text += (
            f"<link name='l{i + 1}'/><joint name='j{i + 1}' type='{kind}'>"
            f"<origin xyz='{a!r} 0 {d!r}' rpy='{alpha!r} 0 0'/><parent link='l{i}'/>"
            f"<child link='l{i + 1}'/><axis xyz='0 0 1'/>"
            f"<limit lower='{-LIMIT!r}' upper='{LIMIT!r}' velocity='1' effort='1'/></joint>"
        )
    return text + "</robot>"


class Solver(NamedTuple):
    """A solver with its own forward kinematics: bases and flanges of packages differ."""

    name: str
    forward: Callable[[Array], Array]  # (n,) to (4, 4)
    solve: Callable[[Array, Array], Any]  # of a pose, and a configuration that reaches it
    rows: Callable[[Any], Array] = np.asarray  # solutions in the answer of solve()
    is_sweep: bool = False  # samples the free joint, so that it need not find the configuration


def peer(name: str) -> Any:
    """Returns a module, or None where it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def ours(robot: Robot) -> Iterator[Solver]:
    """Yields our solver; of seven joints also a sweep over values of the free joint."""
    flange = robot.frame_names[-1]
    ik = Ik(robot, flange, list(range(robot.dof)))
    free = ik.free_joint

    def forward(q: Array) -> Array:
        return robot.pose(flange, q)

    if free is None:
        yield Solver("graspless", forward, lambda X, q: ik.solve_free(X, 0, q))
        return
    values = LIMIT * (2 * np.arange(SWEEP) + 1 - SWEEP) / SWEEP
    yield Solver("graspless, one value", forward, lambda X, q: ik.solve_free(X, q[free], q))
    yield Solver(
        f"graspless, {SWEEP} values",
        forward,
        lambda X, q: [ik.solve_free(X, value, q) for value in values],
        np.vstack,
        is_sweep=True,
    )


def eaik(robot: Robot) -> Iterator[Solver]:
    """Yields eaik's solver; it serves six joints."""
    module = peer("eaik.IK_Homogeneous")
    if module is None or robot.dof != 6:
        return
    zero = np.zeros(robot.dof)
    poses = np.stack([robot.pose(frame, zero) for frame in robot.frame_names[1:]])
    arm = module.HomogeneousRobot(poses)
    flange = robot.frame_names[-1]

    def rows(found: Any) -> Array:
        exact = ~np.asarray(found.is_LS, bool)  # the others are approximations
        return np.array(found.Q, float).reshape(-1, robot.dof)[exact, :]

    yield Solver("eaik", lambda q: robot.pose(flange, q), lambda X, q: arm.IK(X), rows)


def ssik(name: str, urdf: str) -> Iterator[Solver]:
    """Yields ssik's solver: generated code where it ships with it, otherwise made from the URDF."""
    module = peer("ssik")
    if module is None:
        return
    if name in PREBUILT:
        arm, title = module.Manipulator.from_prebuilt(PREBUILT[name]), "ssik, prebuilt"
    else:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "arm.urdf"
            path.write_text(urdf, encoding="utf-8")
            arm, title = module.Manipulator.from_urdf(path), "ssik, from URDF"

    def rows(found: Any) -> Array:
        return np.array([solution.q for solution in found]).reshape(-1, arm.dof)

    yield Solver(
        title, arm.fk, lambda X, q: arm.solve(X, respect_limits=False), rows, is_sweep=arm.dof == 7
    )


def distinct(rows: Array, solver: Solver, X_WF: Array) -> list[Array]:
    """Returns the rows that reach the pose, without repetitions."""
    kept: list[Array] = []
    for q in rows:
        if np.abs(solver.forward(q) - X_WF).max() > TOLERANCE:
            continue
        if all(np.abs(np.sin((q - other) / 2)).max() > SAME for other in kept):
            kept.append(q)
    return kept


def measure(solver: Solver, dof: int, poses: int) -> Row:
    """Returns time, solutions and errors of a solver, over random reachable poses."""
    rng = np.random.default_rng(1)
    times, counts, refused, missed = [], [], 0, 0
    for q in rng.uniform(-LIMIT, LIMIT, (poses, dof)):
        X_WF = solver.forward(q)
        least = math.inf
        for _ in range(3):
            begin = time.perf_counter()
            answer = solver.solve(X_WF, q)
            least = min(least, time.perf_counter() - begin)
        times.append(least)
        rows = solver.rows(answer)
        right = distinct(rows, solver, X_WF)
        counts.append(len(right))
        refused += len(rows) - len(right)
        missed += all(np.abs(np.sin((row - q) / 2)).max() > SAME for row in right)
    return {
        "median_us": float(np.median(times)) * 1e6,
        "solutions": sum(counts) / poses,
        "wrong": refused,
        "missed": None if solver.is_sweep else missed,
    }


def add_parser(experiments: Any) -> None:
    """Adds `ik` to the experiments."""
    parser = experiments.add_parser(
        "ik",
        help="closed forms of inverse kinematics",
        description="Solves for all branches at random reachable poses of common arms, called from "
        "Python: ours, and eaik and ssik where they are installed (pip install eaik ssik). The "
        "least time of three calls counts. Exit 1 when one of our solutions is wrong or missed.",
    )
    parser.add_argument("--poses", type=positive(int), default=1000, metavar="N", help="(1000)")
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    rows: list[Row] = []
    failures = 0
    for name, dh in ARMS.items():
        urdf = urdf_of(dh)
        robot = Robot.from_urdf(urdf)
        for solver in chain(ours(robot), eaik(robot), ssik(name, urdf)):
            row = measure(solver, robot.dof, options.poses)
            rows.append({"name": f"{name}: {solver.name}", **row})
            if solver.name.startswith("graspless"):
                failures += row["wrong"] + (row["missed"] or 0)
    shown: list[Column] = [
        ("median [us]", lambda r: f"{r['median_us']:.1f}"),
        ("solutions", lambda r: f"{r['solutions']:.2f}"),
        ("wrong or repeated", lambda r: str(r["wrong"])),
        ("missed", lambda r: "–" if r["missed"] is None else str(r["missed"])),
    ]
    print(json.dumps(rows) if options.json else aligned("arm: solver", rows, shown))
    return NOT_FOUND if failures else FOUND
