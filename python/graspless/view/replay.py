# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a plan in viser: one HTML file, or a viewer on this machine."""

from __future__ import annotations

import contextlib
import html
import io
import socket
import time
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

from .. import kinds, progress
from ..errors import TaskError
from .scene import legend_html

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .._plan import Plan
    from ..simulation import Recording
    from .scene import Layers

RATE = 20.0  # rows a second
HOLD = 1.5  # pause at the end before the replay repeats [s]
SPEEDS = ("0.25x", "0.5x", "1x", "2x", "4x")
LEGEND = (
    '<div id="legend" style="position:fixed;right:12px;top:12px;padding:8px 12px;z-index:9;'
    "background:rgba(255,255,255,0.7);border-radius:6px;font:13px/1.6 sans-serif;color:#222;"
    'pointer-events:none">{}</div>'
)


class Stage(Protocol):
    """Scene of a plan on a viser server."""

    rows: int
    """Number of moments, RATE per second."""

    layers: Layers
    """Layers that can be hidden, and the legend."""

    def show(self, row: int) -> None:
        """Moves everything to a moment; sends only what has changed."""


def as_html(plan: Plan, recording: Recording | None = None) -> str:
    """Returns the replay as the text of one HTML file.

    The page has a time slider, a legend, and a scene tree that hides and shows layers.
    """
    with _server(_free_port()) as server:
        stage = _stage(server, plan, recording)
        stage.show(0)
        serializer = server.get_scene_serializer()
        for row in range(1, stage.rows):
            serializer.insert_sleep(1 / RATE)
            stage.show(row)
        serializer.insert_sleep(HOLD if stage.rows > 2 else 0.0)
        text: str = serializer.as_html()
    what = str(plan.status) if recording is None else "simulated"
    title = f"<title>graspless: {html.escape(plan.task.problem.object.name)}, {what}</title>"
    legend = LEGEND.format(legend_html(stage.layers.legend))
    text = text.replace("<title>Viser</title>", title, 1)
    return text.replace("</body>", f"{legend}</body>", 1)


def serve(plan: Plan, port: int) -> None:
    """Serves the replay with a time slider, a legend and a check box per layer until Ctrl-C."""
    _check_port(port)  # before the work of drawing
    with _server(port) as server:
        with progress.waiting("drawing"):
            stage = _stage(server, plan, None)
            stage.show(0)
        playing = server.gui.add_checkbox("play", initial_value=True)
        last = (stage.rows - 1) / RATE
        now = server.gui.add_slider(
            "time [s]", min=0.0, max=max(last, 0.05), step=0.05, initial_value=0.0
        )
        now.on_update(lambda _: stage.show(round(now.value * RATE)))
        speed = server.gui.add_dropdown("speed", SPEEDS, initial_value="1x")
        _add_boxes(server, stage.layers)
        with server.gui.add_folder("legend"):
            server.gui.add_html(legend_html(stage.layers.legend))
        print(f"http://localhost:{server.get_port()}  (Ctrl-C ends it)", flush=True)
        while True:
            time.sleep(1 / RATE)
            if playing.value:
                step = float(speed.value[:-1]) / RATE
                now.value = 0.0 if now.value >= last else min(now.value + step, last)


def _add_boxes(server: Any, layers: Layers) -> None:
    """Adds a check box for each layer, which hides and shows it."""
    with server.gui.add_folder("layers"):
        for name, handle in layers.handles.items():
            box = server.gui.add_checkbox(name, initial_value=handle.visible)
            box.on_update(partial(_follow, box, handle))


def _follow(box: Any, handle: Any, _: Any) -> None:
    handle.visible = box.value


def _stage(server: Any, plan: Plan, recording: Recording | None) -> Stage:
    server.scene.set_up_direction("+z")
    server.scene.configure_default_lights(cast_shadow=True)
    kind = kinds.part("view", plan.kind)
    given = () if recording is None else (recording,)
    stage: Stage = kind.set_stage(server, plan, *given)
    return stage


def _check_port(port: int) -> None:
    """Raises TaskError unless the port is free.

    viser waits for ever for a port that it may not use, and takes the next one if it is busy.
    """
    if not 1 <= port <= 65535:
        raise TaskError(f"--port: {port}: should be from 1 to 65535")
    try:
        with socket.socket() as probe:
            # Like servers do, so that a port counts as free as soon as its last server has ended.
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
    """Starts a viser server that only this machine can reach."""
    import viser

    _check_port(port)
    try:
        with contextlib.redirect_stdout(io.StringIO()):  # suppresses viser's banner
            server = viser.ViserServer(host="127.0.0.1", port=port, verbose=False)
    except OSError as error:
        raise TaskError(f"--port: {port}: cannot be served: {error.strerror}") from None
    try:
        yield server
    finally:
        with contextlib.redirect_stdout(io.StringIO()):
            server.stop()
