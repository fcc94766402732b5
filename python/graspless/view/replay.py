# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plan as a replay in viser: one HTML file, or a viewer on this machine."""

from __future__ import annotations

import contextlib
import io
import socket
import time
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from .. import frames, kinds
from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ..frames import Matrix
    from ..plans import Plan
    from .bodies import Body, Color
    from .raster import Camera

RATE = 20.0  # rows a second
HOLD = 1.5  # at the end, before the replay starts again [s]
DIM = 0.82  # viser's lights are bright


class Stage(Protocol):
    """The scene of a plan on a viser server."""

    rows: int
    """Moments, RATE a second."""

    def show(self, row: int) -> None:
        """Moves what moves to a moment; what stays is not sent again."""


def as_html(plan: Plan) -> str:
    """The replay as the text of one HTML file, a time slider below."""
    with _server(_free_port()) as server:
        stage = _stage(server, plan)
        stage.show(0)
        serializer = server.get_scene_serializer()
        for row in range(1, stage.rows):
            serializer.insert_sleep(1 / RATE)
            stage.show(row)
        serializer.insert_sleep(HOLD if stage.rows > 2 else 0.0)
        text: str = serializer.as_html()
    title = f"<title>graspless: {plan.task.problem.object.name}, {plan.status}</title>"
    return text.replace("<title>Viser</title>", title, 1)


def serve(plan: Plan, port: int) -> None:
    """Serves the replay with a slider until Ctrl-C."""
    _check_port(port)  # before the work of drawing
    with _server(port) as server:
        stage = _stage(server, plan)
        stage.show(0)
        playing = server.gui.add_checkbox("play", initial_value=True)
        last = (stage.rows - 1) / RATE
        now = server.gui.add_slider(
            "time [s]", min=0.0, max=max(last, 0.05), step=0.05, initial_value=0.0
        )
        now.on_update(lambda _: stage.show(round(now.value * RATE)))
        print(f"http://localhost:{server.get_port()}  (Ctrl-C ends it)", flush=True)
        while True:
            time.sleep(1 / RATE)
            if playing.value:
                now.value = 0.0 if now.value >= last else min(now.value + 1 / RATE, last)


def _stage(server: Any, plan: Plan) -> Stage:
    server.scene.set_up_direction("+z")
    server.scene.configure_default_lights(cast_shadow=True)
    make: Callable[[Any, Plan], Stage] = kinds.part("view", plan.kind).set_stage
    return make(server, plan)


def look(server: Any, view: Camera) -> None:
    """Where the viewer stands at first."""
    server.initial_camera.position = tuple(view.eye)
    server.initial_camera.look_at = tuple(view.target)
    server.initial_camera.fov = 1.08 * view.angle


class Captions:
    """One line of text at a time, like a subtitle."""

    def __init__(self, scene: Any, view: Camera, texts: list[str]) -> None:
        reach = np.linalg.norm(view.target - view.eye)
        at = tuple(view.target - 0.88 * reach * np.tan(view.angle / 2) * view.axes()[1])
        self.labels = {
            text: scene.add_label(
                f"/captions/{plain(text)}", text, position=at, visible=False, font_screen_scale=1.6
            )
            for text in dict.fromkeys(texts)
        }
        self.shown: str | None = None

    def show(self, text: str) -> None:
        """Shows one of the texts and hides the others."""
        if text != self.shown:
            if self.shown is not None:
                self.labels[self.shown].visible = False
            self.labels[text].visible = True
            self.shown = text


def add(scene: Any, name: str, body: Body, X_WB: Matrix, opacity: float | None = None) -> Any:
    """A frame with one mesh a colour under it."""
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
    """Bars between pairs of points [N, 2, 3]; its `points` move them."""
    return scene.add_arrows(
        name,
        ends.astype(np.float32),
        shade(color),
        shaft_radius=radius,
        head_radius=radius,  # arrows whose heads are not seen
        head_length=1e-4,
    )


def shade(color: Color) -> tuple[int, int, int]:
    """A colour as viser takes it, dimmed to its lights."""
    red, green, blue = (round(255 * DIM * value) for value in color)
    return red, green, blue


def _placed(X_WB: Matrix) -> dict[str, Any]:
    return {"wxyz": tuple(frames.to_quaternion(X_WB)), "position": tuple(X_WB[:3, 3])}


def move(handle: Any, X: Matrix, X_before: Matrix, before: int) -> None:
    """Moves a frame from where it was in row `before`, which is negative at first."""
    if before >= 0 and np.array_equal(X, X_before):
        return
    if before < 0 or not np.array_equal(X[:3, :3], X_before[:3, :3]):
        handle.wxyz = tuple(np.round(frames.to_quaternion(X), 6))
    if before < 0 or not np.array_equal(X[:3, 3], X_before[:3, 3]):
        handle.position = tuple(np.round(X[:3, 3], 6))


def plain(name: str) -> str:
    """A name that is one step of a scene's path."""
    return name.replace("/", "_")


def _check_port(port: int) -> None:
    """Raises TaskError unless the port is free: viser waits for ever on one that it cannot have,
    and takes the next when it is busy.
    """
    if not 1 <= port <= 65535:
        raise TaskError(f"--port: {port}: should be from 1 to 65535")
    try:
        with socket.socket() as probe:
            # As servers do, so that a port is free again as soon as its last server has ended.
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            probe.bind(("127.0.0.1", port))
    except OSError as error:
        raise TaskError(f"--port: {port}: cannot be served: {error.strerror}") from None


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextlib.contextmanager
def _server(port: int) -> Iterator[Any]:
    """A viser server that only this machine sees."""
    import viser

    _check_port(port)
    try:
        with contextlib.redirect_stdout(io.StringIO()):  # its banner is not ours
            server = viser.ViserServer(host="127.0.0.1", port=port, verbose=False)
    except OSError as error:
        raise TaskError(f"--port: {port}: cannot be served: {error.strerror}") from None
    try:
        yield server
    finally:
        with contextlib.redirect_stdout(io.StringIO()):
            server.stop()
