# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Viewer of a proposal for a robot: a slider per joint, a button per named state."""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import progress
from ..scene import Scene
from .bodies import FINGER, robot_bodies, vertices_of
from .hand import axes_body
from .raster import Camera
from .scene import Layers, add_segments, legend_html, look, move
from .server import add_boxes, open_server

if TYPE_CHECKING:
    from ..frames import Matrix
    from .bodies import Body
    from .hand import Proposal

AXIS = 0.06  # length of the axes of a frame [m]
CURVE_RADIUS = 0.003  # [m]
STEPS = 200  # of a slider
WINDOW = (4, 3)  # width and height of the view, for the first look


def serve(proposal: Proposal, port: int) -> None:
    """Serves the viewer until Ctrl-C."""
    with open_server(port) as server:
        with progress.waiting("drawing"):
            Joints(server, proposal)
        print(f"http://localhost:{server.get_port()}  (Ctrl-C ends it)", flush=True)
        while True:
            time.sleep(1.0)


class Joints:
    """Robot of a proposal on a viser server, with its frames and the curves of its fingers.

    Attributes
    ----------
    q : array [n]
        Joints that are shown [rad or m].
    sliders : list
        Handle of each joint's slider.
    touching : Any
        Handle of the text that names two links in collision.
    """

    def __init__(self, server: Any, proposal: Proposal) -> None:
        self.robot = robot = proposal.robot
        self.checked = Scene(robot)
        known = [name for name in ("home", "open") if name in robot.state_names]
        self.q = np.array(robot.state(known[0]) if known else robot.clamp(np.zeros(robot.dof)))
        poses = self._poses()
        server.scene.set_up_direction("+z")
        self.layers = Layers(server.scene)
        bodies = robot_bodies(robot, None)
        self.drawn = [i for i, body in enumerate(bodies) if body.parts]
        placed = [(bodies[i], poses[i]) for i in self.drawn]
        self.links = self.layers.add_bodies("robot", placed)
        self._add_frames(proposal, poses)
        self._add_curves(proposal, poses)
        look(server, _camera(placed))
        self.sliders = self._add_sliders(server)
        self._add_states(server)
        add_boxes(server, self.layers)
        with server.gui.add_folder("legend"):
            server.gui.add_html(legend_html(self.layers.legend))
        self.shown = poses
        self.show()

    def show(self) -> None:
        """Moves everything to `q`, and names two links that touch."""
        poses = self._poses()
        for i, handle in zip((*self.drawn, *self.marked), (*self.links, *self.marks), strict=True):
            move(handle, poses[i], self.shown[i], 0)
        for handle, nodes in self.curves:
            handle.points = _segments(nodes, poses)
        self.shown = poses
        pair = self.checked.collision(self.q)
        self.touching.value = "none" if pair is None else f"{pair[0]} and {pair[1]}"

    def set_state(self, name: str, _: Any = None) -> None:
        """Moves the joints to a named state; those that it does not give stay."""
        self.q = np.array(self.robot.state(name, self.q))
        for slider, value in zip(self.sliders, self.q, strict=True):
            slider.value = float(np.clip(value, slider.min, slider.max))
        self.show()

    def _poses(self) -> list[Matrix]:
        return list(np.asarray(self.robot.forward(self.q)))

    def _add_frames(self, proposal: Proposal, poses: list[Matrix]) -> None:
        named = (proposal.hand.get("fingertip"), proposal.hand.get("grasp_frame"))
        links = [self.robot.frame(name) for name in named if name is not None]
        bodies = [(axes_body(AXIS, self.robot.frame_names[i]), poses[i]) for i in links]
        self.marked, self.marks = links, self.layers.add_bodies("frames", bodies)

    def _add_curves(self, proposal: Proposal, poses: list[Matrix]) -> None:
        self.curves: list[tuple[Any, list[tuple[int, Matrix]]]] = []
        if not proposal.clasp:
            return
        self.layers.add("curves")
        self.layers.explain(FINGER, "finger curves for clasps")
        for name, nodes in (*proposal.clasp["fingers"].items(), ("thumb", proposal.clasp["thumb"])):
            known = [
                (self.robot.frame(node["link"]), np.array(node.get("point", np.zeros(3))))
                for node in nodes
            ]
            ends = _segments(known, poses)
            handle = add_segments(self.layers.scene, f"/curves/{name}", ends, FINGER, CURVE_RADIUS)
            self.curves.append((handle, known))

    def _add_sliders(self, server: Any) -> list[Any]:
        robot, sliders = self.robot, []
        with server.gui.add_folder("joints [rad, m]"):
            for k, name in enumerate(robot.joint_names):
                low, high = float(robot.lower[k]), float(robot.upper[k])
                low, high = max(low, -2 * np.pi), min(high, 2 * np.pi)  # of continuous joints
                slider = server.gui.add_slider(
                    name, min=low, max=high, step=(high - low) / STEPS,
                    initial_value=float(np.clip(self.q[k], low, high)),
                )  # fmt: skip
                slider.on_update(partial(self._follow, k))
                sliders.append(slider)
        return sliders

    def _add_states(self, server: Any) -> None:
        self.touching = server.gui.add_text("in collision", "none", disabled=True)
        with server.gui.add_folder("states"):
            for name in self.robot.state_names:
                server.gui.add_button(name).on_click(partial(self.set_state, name))

    def _follow(self, k: int, event: Any) -> None:
        self.q[k] = event.target.value
        self.show()


def _segments(nodes: list[tuple[int, Matrix]], poses: list[Matrix]) -> Matrix:
    """Ends of the segments of a curve, (S, 2, 3) in the world."""
    points = np.array([poses[i][:3, :3] @ p_L + poses[i][:3, 3] for i, p_L in nodes])
    return np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)


def _camera(placed: list[tuple[Body, Matrix]]) -> Camera:
    seen = vertices_of(placed)
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    size = float(np.linalg.norm(np.ptp(seen, axis=0)))
    eye = middle + 2 * size * np.array([0.7, -1.0, 0.5])
    return Camera(eye, middle).fitted(seen, *WINDOW, margin=0.2)
