# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A chain as a replay: every stage has a corner of the scene, and one of them is seen."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from ...kinds import part
from ..scene import Layers, plain

if TYPE_CHECKING:
    from ...plans.chain import Plan
    from ..replay import Stage as AnyStage


class Stage:
    """The stages of a chain on a viser server, one after the other."""

    def __init__(self, server: Any, plan: Plan) -> None:
        self.layers = Layers(server.scene)
        self.corners: list[Any] = []
        self.stages: list[AnyStage] = []
        for k, (name, stage) in enumerate(zip(plan.names, plan.stages, strict=True)):
            corner = f"{k + 1} {plain(name)}"
            frame = server.scene.add_frame(f"/{corner}", show_axes=False, visible=k == 0)
            camera = server.initial_camera if k == 0 else SimpleNamespace()
            within = SimpleNamespace(scene=Corner(server.scene, corner), initial_camera=camera)
            self.corners.append(frame)
            self.stages.append(part("view", stage.kind).set_stage(within, stage))
            for layer, handle in self.stages[-1].layers.handles.items():
                self.layers.handles[f"{corner}: {layer}"] = handle
        self.rows = sum(stage.rows for stage in self.stages)
        self.at = 0

    def show(self, row: int) -> None:
        """Moves the stage that a moment belongs to, and hides the others."""
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


class Corner:
    """A viser scene whose every path begins with a name of its own."""

    def __init__(self, scene: Any, name: str) -> None:
        self._scene, self._name = scene, name

    def __getattr__(self, called: str) -> Any:
        inner = getattr(self._scene, called)

        def add(name: str, *given: Any, **named: Any) -> Any:
            return inner(f"/{self._name}{name}", *given, **named)

        return add if called.startswith("add_") else inner
