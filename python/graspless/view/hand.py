# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a proposed hand: open and closed with its frames, and the robot at home."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from . import raster
from .bodies import Body, Part, robot_bodies, vertices_of
from .figures import INK, draw_panel, new_figure
from .raster import Camera
from .tubes import tube

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .._core.robot import Robot
    from ..frames import Matrix
    from .bodies import Color

AXES: tuple[Color, ...] = ((0.85, 0.15, 0.15), (0.15, 0.6, 0.2), (0.15, 0.3, 0.85))
PANEL = (460, 460)  # pixels
AXIS = 0.2  # length of an axis, relative to the hand
LETTER = 0.4  # distance of a frame's letter behind its origin along each axis, relative to that
THICKNESS = 0.08  # radius of an axis, relative to its length


class Proposal(Protocol):
    """Part of an `inspection.Proposal` that is drawn."""

    @property
    def name(self) -> str: ...
    @property
    def robot(self) -> Robot: ...
    @property
    def hand(self) -> dict[str, Any]: ...
    @property
    def clasp(self) -> dict[str, Any]: ...
    @property
    def hand_links(self) -> tuple[str, ...]: ...


def draw(proposal: Proposal) -> Figure:
    """Returns the picture of a proposal."""
    shown = _Hand(proposal)
    own = {"open": "open", "closed": "closed"} | (proposal.hand or proposal.clasp)
    states = [own["open"], own["closed"], "home"]
    states = [state for state in states if state in proposal.robot.state_names]
    figure = new_figure(4.6 * len(states), 5.0)
    for k, state in enumerate(states):
        axes = figure.add_axes((k / len(states), 0.0, 1 / len(states), 0.84))
        picture, letters = shown.picture(state)
        draw_panel(axes, picture, state, pad=3)
        for letter, (x, y) in letters.items():
            axes.text(x, y, letter, color=INK, fontsize=11, weight="bold", ha="center", va="center")
    title = proposal.name
    if shown.frames:
        named = ", ".join(f"{letter} {name}" for letter, name in shown.frames.items())
        title += f": {named}; X red, Y green, Z blue"
    figure.suptitle(title, x=0.02, y=0.97, ha="left", fontsize=12, color=INK)
    return figure


class _Hand:
    """Bodies of a robot, and the axes of the frames of its hand."""

    def __init__(self, proposal: Proposal) -> None:
        self.robot = proposal.robot
        self.bodies = robot_bodies(self.robot, None)
        fields = {"F": "fingertip", "H": "grasp_frame"}
        given = proposal.hand
        self.frames = {k: given[field] for k, field in fields.items() if field in given}
        self.hand = set(proposal.hand_links)
        self.clasp = proposal.clasp

    def picture(self, state: str) -> tuple[Matrix, dict[str, Matrix]]:
        """Renders the hand in a state, all of the robot at home; and where F and H are [pixels]."""
        q = self.robot.state(state)
        names = self.robot.frame_names
        X_WL = np.asarray(self.robot.forward(q))
        wanted = [
            (body, X)
            for body, X, name in zip(self.bodies, X_WL, names, strict=True)
            if body.parts and (state == "home" or name in self.hand)
        ]
        points = vertices_of(wanted)
        size = float(np.ptp(points, axis=0).max()) if state != "home" else 0.3
        frames = {letter: X_WL[names.index(name)] for letter, name in self.frames.items()}
        wanted += [(axes_body(AXIS * size), X_WF) for X_WF in frames.values()]
        camera = _camera(vertices_of(wanted), self._across(X_WL), state == "home")
        ends = {letter: X_WF @ [*[-LETTER * AXIS * size] * 3, 1] for letter, X_WF in frames.items()}
        letters = {k: camera.project(p[None, :3], *PANEL)[0, :2] for k, p in ends.items()}
        return raster.render(wanted, camera, *PANEL), letters

    def _across(self, X_WL: Matrix) -> Matrix:
        """Columns: along the axes that the fingers bend about, across them, and to their tips."""
        if not self.clasp:
            return np.eye(3)
        R_WP = X_WL[self.robot.frame_names.index(self.clasp["frame"])][:3, :3]
        sideways, forward = R_WP @ self.clasp["sideways"], R_WP @ self.clasp["forward"]
        return np.column_stack([sideways, np.cross(forward, sideways), forward])


def axes_body(length: float, name: str = "axes") -> Body:
    """Axes of a frame as three bars: X red, Y green, Z blue."""
    parts: list[Part] = [
        tube(np.array([np.zeros(3), length * np.eye(3)[k]]), THICKNESS * length, AXES[k])
        for k in range(3)
    ]
    return Body(name, parts)


def _camera(points: Matrix, R_WH: Matrix, whole: bool) -> Camera:
    """Looks across the plane in which the fingers move; at the whole robot from its side."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = float(np.linalg.norm(high - low))
    direction = np.array([0.7, -1.0, 0.5]) if whole else R_WH @ [1.0, 0.2, -0.15]
    if abs(direction[2]) > 0.95 * np.linalg.norm(direction):
        direction = direction + np.array([0.3, 0.2, 0.0])
    middle = (low + high) / 2
    eye = middle + 3 * size * direction / np.linalg.norm(direction)
    return Camera(eye, middle).fitted(points, *PANEL, margin=0.12)
