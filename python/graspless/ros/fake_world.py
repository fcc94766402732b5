# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""World of the simulated robot: a robot with position servos, and boxes, in MuJoCo. No ROS."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import mujoco
import numpy as np

from .. import frames, geometry, perception
from ..simulation.robots import compiled, joint_addresses, robot_spec, set_positions, unused
from ..simulation.shapes import add_placed
from ..tasks.robot_files import resolve_robot
from ..tasks.robots import Robot as RobotFields
from ..tasks.robots import build_robot
from ..tasks.source import Source

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix


@dataclass(frozen=True)
class Block:
    """A box in the world.

    Attributes
    ----------
    name : str
    size : tuple of float
        Lengths of its sides [m].
    center : tuple of float
        Its centre in the world [m].
    mass : float
        [kg]; 0: it is fixed.
    """

    name: str
    size: tuple[float, float, float]
    center: tuple[float, float, float]
    mass: float = 0.0


SCENE = (
    Block("floor", (6.0, 6.0, 0.02), (0.65, 0.0, -0.75)),
    Block("table", (0.7, 0.7, 0.04), (0.65, 0.0, -0.02)),
    Block("carton", (0.14, 0.12, 0.2), (0.72, -0.24, 0.1)),
    Block("bar", (0.1, 0.035, 0.06), (0.62, 0.0, 0.03), mass=0.15),
)
X_WC = perception.look_at([-0.05, 0.0, 0.75], [0.65, 0.0, 0.0])
FRICTION = [0.6, 0.005, 0.0001]  # of blocks that move


class World:
    """A robot among blocks.

    Parameters
    ----------
    robot : str
        A robot that comes with graspless, or the path of a URDF.
    blocks : sequence of Block
    """

    def __init__(self, robot: str, blocks: Sequence[Block] = SCENE) -> None:
        source = Source("robot", {"robot": {"urdf": robot}})
        self.fields, _ = resolve_robot(RobotFields(urdf=robot), source, Path.cwd())
        self.robot = build_robot(self.fields, source, warn=False)
        self.blocks = tuple(blocks)
        spec = robot_spec(self.robot, self.fields)
        for block in blocks:
            body = spec.worldbody.add_body(name=unused(spec, block.name), pos=list(block.center))
            given = {}
            if block.mass > 0:
                body.add_freejoint()
                given = {"mass": block.mass, "friction": FRICTION, "condim": 4}
            add_placed(spec, body, _shape(block), name=block.name, **given)
        self.model = compiled(spec)
        self.data = mujoco.MjData(self.model)
        self._addresses = joint_addresses(self.model, self.robot)
        self.joint_names = list(self.robot.joint_names)
        home = np.array(self.robot.state("home"))
        set_positions(self.model, self.data, self.robot, home)
        self.data.ctrl[:] = home
        mujoco.mj_forward(self.model, self.data)

    @property
    def time(self) -> float:
        """Time since the start [s]."""
        return float(self.data.time)

    @property
    def positions(self) -> Matrix:
        """Positions of the joints [rad or m]."""
        q: Matrix = self.data.qpos[self._addresses].copy()
        return q

    @property
    def command(self) -> Matrix:
        """Targets of the servos [rad or m]; the array itself."""
        ctrl: Matrix = self.data.ctrl
        return ctrl

    def step(self) -> None:
        """Goes on by one time step."""
        mujoco.mj_step(self.model, self.data)

    def pose(self, name: str) -> Matrix:
        """Returns the pose [4, 4] of a block in the world."""
        body = self.data.body(name)
        return frames.translation(body.xpos) @ frames.from_quaternion(body.xquat)

    def bodies(self) -> list[perception.Body]:
        """Returns the blocks as a camera would see them. It does not see the robot."""
        return [perception.Body([_shape(block)], self.pose(block.name)) for block in self.blocks]


def _shape(block: Block) -> geometry.PlacedShape:
    return geometry.PlacedShape(geometry.Box(list(block.size)))
