# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joints of a robot, as a tree of bodies: links that fixed joints connect are one body."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from .._xml import parse
from .files import state_joints
from .points import link_points

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .._core.robot import Robot
    from ..frames import Matrix


@dataclass(frozen=True)
class Joint:
    """Joint of a URDF that is not fixed."""

    name: str
    kind: str
    axis_L: tuple[float, float, float]
    mimics: str | None


class Tree:
    """Links of a robot by index, as Robot.frame_names, grouped into bodies."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.links = list(robot.frame_names)
        self.parents = [robot.parent(link) for link in range(len(self.links))]
        self.joints = _moving_joints(robot.urdf)

    def joint(self, link: int) -> Joint | None:
        """Returns the moving joint that carries a link, if any."""
        return self.joints.get(self.links[link])

    def body(self, link: int) -> int:
        """Returns the first link of the body that a link belongs to."""
        while self.parents[link] >= 0 and self.joint(link) is None:
            link = self.parents[link]
        return link

    def line(self, link: int) -> list[int]:
        """Returns a link and those that carry it, down to the root."""
        found = [link]
        while self.parents[found[-1]] >= 0:
            found.append(self.parents[found[-1]])
        return found

    @cached_property
    def members(self) -> dict[int, list[int]]:
        """Links of each body."""
        found: dict[int, list[int]] = {}
        for link in range(len(self.links)):
            found.setdefault(self.body(link), []).append(link)
        return found

    @cached_property
    def children(self) -> dict[int, list[int]]:
        """Bodies that moving joints attach to each body."""
        found: dict[int, list[int]] = {body: [] for body in self.members}
        for body in self.members:
            if self.parents[body] >= 0:
                found[self.body(self.parents[body])].append(body)
        return found

    @cached_property
    def points(self) -> dict[int, Matrix]:
        """Points on the collision shapes of each link that has some, in its frame [m]."""
        return link_points(self.robot)

    @cached_property
    def drawn(self) -> set[str]:
        """Names of the links that have visual shapes and no collision shapes."""
        links = parse(self.robot.urdf).findall("link")
        has = {element.get("name", ""): {part.tag for part in element} for element in links}
        return {name for name, tags in has.items() if "visual" in tags and "collision" not in tags}

    @cached_property
    def states(self) -> dict[str, set[str]]:
        """Joints that each state of the SRDF sets, faulty states included."""
        return state_joints(self.robot.srdf)

    def state(self, name: str, joints: Iterable[str]) -> Matrix | None:
        """Returns a state of the SRDF [dof], if it sets one of these joints and has no fault."""
        if name not in self.robot.state_names or not self.states[name] & set(joints):
            return None
        return np.asarray(self.robot.state(name))

    def below(self, body: int) -> list[int]:
        """Returns a body and all bodies that it carries, base first."""
        found, waiting = [], [body]
        while waiting:
            found.append(waiting.pop())
            waiting += reversed(self.children[found[-1]])
        return found

    def links_below(self, body: int) -> list[int]:
        """Returns the links of a body and of all bodies that it carries."""
        return [link for lower in self.below(body) for link in self.members[lower]]

    def path(self, body: int) -> list[int]:
        """Returns the bodies from the root to `body`."""
        found = [body]
        while self.parents[found[0]] >= 0:
            found.insert(0, self.body(self.parents[found[0]]))
        return found

    def has_shape(self, body: int) -> bool:
        """True if the body, or one that it carries, has a collision shape."""
        return any(link in self.points for link in self.links_below(body))

    def driver(self, body: int) -> str:
        """Returns the independent joint that moves a body, directly or through mimic joints."""
        joint = self.joint(body)
        assert joint is not None
        by_name = {other.name: other for other in self.joints.values()}
        while joint.mimics is not None:
            joint = by_name[joint.mimics]
        return joint.name

    def drivers(self, bodies: list[int]) -> list[str]:
        """Returns the independent joints of bodies, each once, in the order of the robot."""
        names = {self.driver(body) for body in bodies}
        return [name for name in self.robot.joint_names if name in names]

    def cloud(self, links: list[int], X_WL: Matrix) -> Matrix:
        """Returns the points of links at the link poses [N, 4, 4]; (M, 3) in W [m]."""
        parts = [frames.transform(X_WL[i], self.points[i]) for i in links if i in self.points]
        return np.vstack([np.zeros((0, 3)), *parts])

    def poses(self, q: Matrix) -> Matrix:
        """Returns the poses of all links at q; [N, 4, 4] in W."""
        return np.asarray(self.robot.forward(q))


def _moving_joints(urdf: str) -> dict[str, Joint]:
    """Returns the moving joint of each link that has one. The robot has been read from the text."""
    found = {}
    for element in parse(urdf).findall("joint"):
        kind, child = element.get("type", ""), element.find("child")
        if kind == "fixed" or child is None:
            continue
        axis, mimic = element.find("axis"), element.find("mimic")
        words = "1 0 0" if axis is None else axis.get("xyz", "1 0 0")
        x, y, z = (float(word) for word in words.split())
        found[child.get("link", "")] = Joint(
            element.get("name", ""), kind, (x, y, z), None if mimic is None else mimic.get("joint")
        )
    return found
