# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot, a table and a card, as the tests of several rooms need them."""

import pathlib

import numpy as np
import pytest

from graspless.geometry import HeightMap
from graspless.robot import Robot
from graspless.slide import Hand, Object, Problem, Support

ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture
def write(tmp_path):
    """Writes a task file and returns its path."""

    def write(text, name="task.yaml"):
        path = tmp_path / name
        path.write_text(text)
        return path

    return write


@pytest.fixture(scope="session")
def wam():
    return Robot.from_urdf_file(str(ROOT / "urdf" / "wam_t42.urdf"))


@pytest.fixture(scope="session")
def q_home(wam):
    q = wam.state("open").copy()
    q[3] = np.pi / 2  # the forearm points forward, high above the table
    return q


@pytest.fixture(scope="session")
def card_problem(wam, q_home):
    """A card 10 cm wide on a square table of 0.7 m in front of the arm."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    X_WS = np.eye(4)
    X_WS[0, 3] = 0.65
    X_WO = X_WS.copy()
    X_WO[:2, 3] = 0.60, 0.05
    card = Object.from_polygon("card", 0.05 * square, thickness=0.004)
    return Problem(wam, Hand(), card, Support(0.35 * square, X_WS), X_WO, q_home)


@pytest.fixture(scope="session")
def bowl_problem(card_problem):
    """A bowl in place of the card: 15 cm wide, its bottom 4 mm and its rim 30 mm high."""
    cells = 0.005 * (np.arange(32) + 0.5) - 0.08
    away = np.hypot(*np.meshgrid(cells, cells, indexing="ij"))
    heights = np.where(away > 0.07, np.where(away > 0.078, 0.0, 0.03), 0.004)
    ring = np.linspace(0, 2 * np.pi, 41)[:-1]
    outline = 0.075 * np.column_stack([np.cos(ring), np.sin(ring)])
    bowl = Object.from_polygon("bowl", outline, 0.03)
    bowl = bowl.with_heights(HeightMap([-0.08, -0.08], 0.005, heights))
    card = card_problem
    return Problem(card.robot, card.hand, bowl, card.support, card.X_WO_start, card.q_home)
