# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a chain: every stage has its own part of the scene, and one of them is visible."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...kinds import part
from ..raster import Camera
from ..scene import FIELD, Layers, look, plain
from .stages import stages_of

if TYPE_CHECKING:
    from ...chain import Plan


NEARER = 0.8  # a scene does not fill the sphere around it


class Stage:
    """Stages of a chain on a viser server, one after the other."""

    def __init__(self, server: Any, plan: Plan) -> None:
        self.layers = Layers(server.scene)
        self.corners: list[Any] = []
        self.stages: list[Any] = []
        seen: list[Any] = []  # the initial camera of each stage
        for k, (name, stage) in enumerate(stages_of(plan)):
            corner = f"{k} {plain(name)}"
            frame = server.scene.add_frame(f"/{corner}", show_axes=False, visible=k == 0)
            seen.append(SimpleNamespace())
            within = SimpleNamespace(scene=Corner(server.scene, corner), initial_camera=seen[-1])
            self.corners.append(frame)
            self.stages.append(part("view", stage.kind, "replay").Stage(within, stage))
            self.layers.legend |= self.stages[-1].layers.legend
            for layer, handle in self.stages[-1].layers.handles.items():
                self.layers.handles[f"{corner}: {layer}"] = handle
        view = common([Camera(np.array(c.position), np.array(c.look_at), c.fov) for c in seen])
        look(server, view)
        for shown in self.stages:
            shown.captions.place(view)
        self.rows = sum(stage.rows for stage in self.stages)
        self.at = 0

    def show(self, row: int) -> None:
        """Shows the stage that a moment belongs to, at that moment, and hides the others."""
        row = min(max(row, 0), self.rows - 1)
        k = 0
        while row >= self.stages[k].rows:
            row -= self.stages[k].rows
            k += 1
        if k != self.at:
            self.corners[self.at].visible = False
            self.corners[k].visible = True
            self.at = k
        self.stages[k].show(row)


def common(cameras: list[Camera]) -> Camera:
    """Returns a camera that sees everything each of them sees, from the side of the first."""
    radii = [np.linalg.norm(c.eye - c.target) * np.tan(c.angle / 2) for c in cameras]
    middle = np.mean([c.target for c in cameras], axis=0)
    far = NEARER * max(
        float(np.linalg.norm(c.target - middle) + radius)
        for c, radius in zip(cameras, radii, strict=True)
    )
    first = cameras[0]
    toward = (first.eye - first.target) / np.linalg.norm(first.eye - first.target)
    return Camera(middle + far / np.tan(first.angle / 2) * toward, middle, first.angle / FIELD)


class Corner:
    """A viser scene that prefixes every path with its own name."""

    def __init__(self, scene: Any, name: str) -> None:
        self._scene, self._name = scene, name

    def __getattr__(self, called: str) -> Any:
        inner = getattr(self._scene, called)

        def add(name: str, *given: Any, **named: Any) -> Any:
            return inner(f"/{self._name}{name}", *given, **named)

        return add if called.startswith("add_") else inner
