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
AXIS = 0.35  # length of an axis, relative to the hand
THICKNESS = 0.06  # radius of an axis, relative to its length


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
        draw_panel(axes, shown.picture(state), state, pad=3)
    title = proposal.name
    if shown.frames:
        title += f": X red, Y green, Z blue, of {' and '.join(shown.frames)}"
    figure.suptitle(title, x=0.02, y=0.97, ha="left", fontsize=12, color=INK)
    return figure


class _Hand:
    """Bodies of a robot, and the axes of the frames of its hand."""

    def __init__(self, proposal: Proposal) -> None:
        self.robot = proposal.robot
        self.bodies = robot_bodies(self.robot, None)
        named = (proposal.hand.get("fingertip"), proposal.hand.get("grasp_frame"))
        self.frames = [name for name in named if name is not None]
        self.hand = set(proposal.hand_links)

    def picture(self, state: str) -> Matrix:
        """Renders the hand in a state; all of the robot at home."""
        q = self.robot.state(state)
        names = self.robot.frame_names
        X_WL = [np.asarray(self.robot.pose(link, q)) for link in range(len(names))]
        wanted = [
            (body, X)
            for body, X, name in zip(self.bodies, X_WL, names, strict=True)
            if body.parts and (state == "home" or name in self.hand)
        ]
        points = vertices_of(wanted)
        size = float(np.ptp(points, axis=0).max()) if state != "home" else 0.3
        wanted += [(axes_body(AXIS * size), X_WL[names.index(name)]) for name in self.frames]
        X_WH = X_WL[names.index(self.frames[-1])] if self.frames else np.eye(4)
        camera = _camera(vertices_of(wanted), X_WH, state == "home")
        return raster.render(wanted, camera, *PANEL)


def axes_body(length: float, name: str = "axes") -> Body:
    """Axes of a frame as three bars: X red, Y green, Z blue."""
    parts: list[Part] = [
        tube(np.array([np.zeros(3), length * np.eye(3)[k]]), THICKNESS * length, AXES[k])
        for k in range(3)
    ]
    return Body(name, parts)


def _camera(points: Matrix, X_WH: Matrix, whole: bool) -> Camera:
    """Looks across the plane in which the fingers move; at the whole robot from its side."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = float(np.linalg.norm(high - low))
    direction = np.array([0.7, -1.0, 0.5]) if whole else X_WH[:3, :3] @ [1.0, 0.35, -0.25]
    if abs(direction[2]) > 0.95 * np.linalg.norm(direction):
        direction = direction + np.array([0.3, 0.2, 0.0])
    middle = (low + high) / 2
    eye = middle + 3 * size * direction / np.linalg.norm(direction)
    return Camera(eye, middle).fitted(points, *PANEL, margin=0.12)
