# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench`. Modules with experiments are imported when they run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .clasp.command import add_parser as _add_clasp
from .edges.command import add_parser as _add_edges
from .fingertip.command import add_parser as _add_fingertip
from .household.command import add_parser as _add_household
from .ik import add_parser as _add_ik
from .physics.command import add_parser as _add_physics
from .robots.command import add_parser as _add_robots
from .scaling.command import add_parser as _add_scaling
from .see.command import add_parser as _add_see
from .slide.command import add_parser as _add_slide
from .speed.command import add_parsers as _add_speed

if TYPE_CHECKING:
    import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the experiments to the command."""
    experiments = parser.add_subparsers(metavar="EXPERIMENT", required=True)
    _add_slide(experiments)
    _add_fingertip(experiments)
    _add_clasp(experiments)
    _add_ik(experiments)
    _add_edges(experiments)
    _add_physics(experiments)
    _add_robots(experiments)
    _add_scaling(experiments)
    _add_speed(experiments)
    _add_see(experiments)
    _add_household(experiments)
