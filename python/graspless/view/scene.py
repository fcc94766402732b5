# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies, captions, layers and legend of a viser scene."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..frames import Matrix
    from .bodies import Body, Color
    from .raster import Camera

DIM = 0.82  # viser's lights are bright
FIELD = 1.08  # field of view over what the camera must see, for a margin


def look(server: Any, view: Camera) -> None:
    """Sets the initial camera."""
    server.initial_camera.position = tuple(view.eye)
    server.initial_camera.look_at = tuple(view.target)
    server.initial_camera.fov = FIELD * view.angle


class Captions:
    """Line of text below the scene, like a subtitle."""

    def __init__(self, layers: Layers, view: Camera, first: str) -> None:
        layers.add("caption")
        self.label = layers.scene.add_label(
            "/caption/text", first, position=_below(view), font_screen_scale=1.6
        )
        self.shown = first

    def place(self, view: Camera) -> None:
        """Moves the text into the view of another camera."""
        self.label.position = _below(view)

    def show(self, text: str) -> None:
        """Shows another text."""
        if text != self.shown:
            self.label.text = self.shown = text


def _below(view: Camera) -> tuple[float, ...]:
    """Returns the position of the subtitle in the world."""
    reach = np.linalg.norm(view.target - view.eye)
    return tuple(view.target - 0.88 * reach * np.tan(view.angle / 2) * view.axes()[1])


class Layers:
    """Parts of a scene that can be hidden, and the legend of its colours.

    Each layer is the first step of a path in the scene.

    Attributes
    ----------
    handles : dict
        Handles of the layers by name, in the order of the viewer's check boxes.
    legend : dict
        Colours by what they mean.
    """

    def __init__(self, scene: Any) -> None:
        self.scene = scene
        self.handles: dict[str, Any] = {}
        self.legend: dict[str, Color] = {}

    def explain(self, color: Color, meaning: str) -> None:
        """Adds a colour to the legend."""
        self.legend[meaning] = color

    def add(self, name: str, X_WB: Matrix | None = None) -> Any:
        """Adds an empty layer: a frame for bodies."""
        pose = {} if X_WB is None else _placed(X_WB)
        self.handles[name] = self.scene.add_frame(f"/{name}", show_axes=False, **pose)
        return self.handles[name]

    def add_body(self, body: Body, X_WB: Matrix, opacity: float | None = None) -> Any:
        """Adds a layer of one body, named after the body."""
        self.handles[body.name] = add(self.scene, f"/{body.name}", body, X_WB, opacity)
        return self.handles[body.name]

    def add_bodies(
        self, name: str, placed: Iterable[tuple[Body, Matrix]], opacity: float | None = None
    ) -> list[Any]:
        """Adds a layer of several bodies; none if there are no bodies."""
        some = list(placed)
        if some:
            self.add(name)
        return [
            add(self.scene, f"/{name}/{plain(body.name)}", body, X_WB, opacity)
            for body, X_WB in some
        ]


def add(scene: Any, name: str, body: Body, X_WB: Matrix, opacity: float | None = None) -> Any:
    """Adds a frame with one mesh per colour."""
    frame = scene.add_frame(name, show_axes=False, **_placed(X_WB))
    colors = list(dict.fromkeys(part.color for part in body.parts))
    for k, color in enumerate(colors):
        vertices: list[Matrix] = []
        triangles: list[Any] = []
        count = 0
        for part in body.parts:
            if part.color == color:
                vertices.append(part.vertices)
                triangles.append(part.triangles + count)
                count += len(part.vertices)
        scene.add_mesh_simple(
            f"{name}/{k}",
            np.concatenate(vertices).astype(np.float32),
            np.concatenate(triangles).astype(np.uint32),
            color=shade(color),
            flat_shading=body.is_flat,
            opacity=opacity,
        )
    return frame


def add_segments(scene: Any, name: str, ends: Matrix, color: Color, radius: float) -> Any:
    """Adds bars between pairs of points, [N, 2, 3]; setting `points` of the handle moves them."""
    return scene.add_arrows(
        name,
        ends.astype(np.float32),
        shade(color),
        shaft_radius=radius,
        head_radius=radius,  # arrows whose heads are not seen
        head_length=1e-4,
    )


def shade(color: Color) -> tuple[int, int, int]:
    """Returns a colour for viser, dimmed to suit its lights."""
    red, green, blue = (round(255 * DIM * value) for value in color)
    return red, green, blue


def _placed(X_WB: Matrix) -> dict[str, Any]:
    return {"wxyz": tuple(frames.to_quaternion(X_WB)), "position": tuple(X_WB[:3, 3])}


def move(handle: Any, X: Matrix, X_before: Matrix, before: int) -> None:
    """Moves a frame from its pose in row `before`, which is negative at first."""
    if before >= 0 and np.array_equal(X, X_before):
        return
    if before < 0 or not np.array_equal(X[:3, :3], X_before[:3, :3]):
        handle.wxyz = tuple(np.round(frames.to_quaternion(X), 6))
    if before < 0 or not np.array_equal(X[:3, 3], X_before[:3, 3]):
        handle.position = tuple(np.round(X[:3, 3], 6))


def plain(name: str) -> str:
    """Returns a name that is one step of a scene's path."""
    return name.replace("/", "_")


def legend_html(legend: dict[str, Color]) -> str:
    """Returns a legend of colours as HTML."""
    lines = []
    for meaning, color in legend.items():
        shown = "#" + "".join(f"{round(255 * value):02x}" for value in color)
        box = f"display:inline-block;width:12px;height:12px;margin-right:8px;background:{shown};"
        edge = "border:1px solid #555;vertical-align:-1px"
        lines.append(f'<div><span style="{box}{edge}"></span>{html.escape(meaning)}</div>')
    return "".join(lines)
