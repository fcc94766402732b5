# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless demonstrate`. Gymnasium is imported when it runs."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from .._commands import FOUND

if TYPE_CHECKING:
    import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `demonstrate`."""
    parser.description = (
        "Record episodes of the planner in MuJoCo, for learners: a LeRobotDataset v3 of those that "
        "held. An interrupted recording goes on when the same command runs again. See "
        "docs/howto/learn.md."
    )
    parser.add_argument("name", metavar="NAME", help="SlideToEdge, Tumble, Clasp or Pick")
    parser.add_argument("-o", "--output", metavar="DIR", required=True, help="new folder")
    parser.add_argument(
        "--episodes",
        type=int,
        default=10,
        metavar="N",
        help="successful episodes to record (default: %(default)s)",
    )
    parser.add_argument(
        "--seed",
        type=int,
        default=0,
        metavar="S",
        help="seed of the first episode (default: %(default)s)",
    )
    parser.add_argument(
        "--varied", action="store_true", help="vary friction, mass and poses in the simulation"
    )
    parser.add_argument(
        "--video", action="store_true", help="add pictures of a camera; needs the extra video"
    )
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    if options.video and not os.environ.get("DISPLAY"):
        os.environ.setdefault("MUJOCO_GL", "egl")  # before MuJoCo is imported
    from ..environments import demonstrate

    tried = demonstrate(
        options.name,
        options.output,
        options.episodes,
        seed=options.seed,
        varied=options.varied,
        images=options.video,
        progress=_tell if sys.stderr.isatty() else None,
    )
    print(f"{options.episodes} of {tried} episodes held: {options.output}")
    return FOUND


def _tell(held: int, tried: int) -> None:
    print(f"\r{held} held of {tried} ", end="", file=sys.stderr, flush=True)
