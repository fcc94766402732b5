# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a plan in viser: one HTML file, or a viewer on this machine."""

from __future__ import annotations

import html
import time
from typing import TYPE_CHECKING, Any, Protocol

from .. import kinds, progress
from .scene import legend_html
from .server import add_boxes, free_port, open_server

if TYPE_CHECKING:
    from .._plan import Plan
    from ..simulation.results import Recording
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
    with open_server(free_port()) as server:
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
    with open_server(port) as server:
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
        add_boxes(server, stage.layers)
        with server.gui.add_folder("legend"):
            server.gui.add_html(legend_html(stage.layers.legend))
        print(f"http://localhost:{server.get_port()}  (Ctrl-C ends it)", flush=True)
        while True:
            time.sleep(1 / RATE)
            if playing.value:
                step = float(speed.value[:-1]) / RATE
                now.value = 0.0 if now.value >= last else min(now.value + step, last)


def _stage(server: Any, plan: Plan, recording: Recording | None) -> Stage:
    if plan and recording is None:
        kinds.require_motion(plan, "show")
    server.scene.set_up_direction("+z")
    server.scene.configure_default_lights(cast_shadow=True)
    given = () if recording is None else (recording,)
    shown = plan if recording is None else kinds.stages_of(plan)[0]
    stage: Stage = kinds.part("view", shown.kind, "replay").Stage(server, shown, *given)
    return stage
