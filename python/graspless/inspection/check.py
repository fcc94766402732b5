# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Faults of a robot's description that was given by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import geometry, scene
from .._core import clasp, slide
from .jaws import middle
from .pairs import touching
from .points import is_inside
from .tree import Tree

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .._core.robot import Robot
    from ..frames import Matrix

NEAR = 0.003  # a fingertip frame is on the surface if it is nearer than this [m]
BESIDE = 0.015  # a grasp frame is in the middle between the tips if it is nearer than this [m]
ALONG = np.cos(np.radians(30))  # axes within this angle are right
REACH = 0.02  # length of the fingers' ends that are compared [m]


def faults(robot: Robot, hand: slide.Hand, pitch: float | None = None) -> list[str]:
    """Returns what is wrong with a hand for slides and with the states that it names.

    Parameters
    ----------
    robot : Robot
        With its SRDF.
    hand : slide.Hand
    pitch : float, optional
        Of the fingertip [rad]; the default of the options.

    Returns
    -------
    list of str
        One sentence each, which begins with the field; empty if nothing is wrong.

    Raises
    ------
    ValueError
        A link, group or state does not exist.
    """
    robot.group(hand.arm)
    examined = _Examined(robot, hand)
    found = examined.of_links() or [
        *examined.of_frames(),
        *examined.of_states(),
        *_of_home(examined.tree, hand.open),
    ]
    return found or _of_planner(robot, hand, pitch)


def _of_planner(robot: Robot, hand: slide.Hand, pitch: float | None) -> list[str]:
    """Returns what the planner refuses in a hand, whatever the object is."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2
    thing = slide.Object.from_polygon("object", geometry.Polygon(square), 0.5)  # as thick as can be
    support = slide.Support(geometry.Polygon(square), np.eye(4))
    home = robot.state(hand.open)
    options = slide.Options() if pitch is None else slide.Options(pitch=pitch)
    try:
        slide.validate(slide.Problem(robot, hand, thing, support, np.eye(4), home), options)
    except ValueError as error:
        return [str(error).removeprefix("hand.")]
    return []


def clasp_faults(robot: Robot, hand: clasp.Hand) -> list[str]:
    """Returns what is wrong with a hand for clasps, which has passed clasp.validate().

    The hand is that of the file, without palm corners: parts of a palm may move in it. Corners in
    links with meshes are not compared with them.
    """
    curves = {f"fingers.{finger.name}": finger for finger in hand.fingers} | {"thumb": hand.thumb}
    found = []
    for field, finger in curves.items():
        for number, node in enumerate(finger.nodes):
            if not is_inside(robot, node.link, np.asarray(node.p_L)):
                found.append(f"{field}[{number}]: lies outside the collision shapes of {node.link}")
    links = [robot.frame(node.link) for finger in curves.values() for node in finger.nodes]
    tree = Tree(robot)
    for number, state in enumerate((hand.open, *hand.pre_shapes)):
        field = f"open[{number}]" if hand.pre_shapes else "open"
        found += [f"{field}: {text}" for text in _of_open(tree, links, state)]
    return [*found, *_of_home(tree, hand.open)]


class _Examined:
    """Ends of the fingers of a hand, with the hand open, in its frame H."""

    def __init__(self, robot: Robot, hand: slide.Hand) -> None:
        self.robot, self.hand, self.tree = robot, hand, Tree(robot)
        own = list(hand.sliding_finger)
        self.own = [robot.frame(link) for link in own]
        self.other = [robot.frame(link) for link in hand.fingers if link not in own]
        self.q_open = np.asarray(robot.state(hand.open))
        self.X_WF = np.asarray(robot.pose(hand.fingertip, self.q_open))
        self.X_WH = np.asarray(robot.pose(hand.grasp_frame, self.q_open))

    def ends(self, state: str, links: list[int]) -> Matrix:
        """Points of the links within REACH of their end along Z of H; (N, 3) in W."""
        q = np.asarray(self.robot.state(state))
        cloud = self.tree.cloud(links, self.tree.poses(q))
        out = np.asarray(self.robot.pose(self.hand.grasp_frame, q))[:3, 2]
        heights = cloud @ out
        return np.asarray(cloud[heights > heights.max() - REACH])

    def of_links(self) -> list[str]:
        """Faults that leave nothing to be measured."""
        if not self.other:
            return ["fingers: must name a link besides those of sliding_finger"]
        return [
            f"{field}: no link of it has a collision shape"
            for links, field in ((self.own, "sliding_finger"), (self.other, "fingers"))
            if not any(link in self.tree.points for link in links)
        ]

    def of_frames(self) -> Iterator[str]:
        hand, R_WF, R_WH = self.hand, self.X_WF[:3, :3], self.X_WH[:3, :3]
        own, other = (self.ends(hand.open, links) for links in (self.own, self.other))
        yield from self._of_surface()
        across = middle(other) - middle(own)
        across /= max(float(np.linalg.norm(across)), 1e-9)
        if R_WF[:, 1] @ across < ALONG:
            angle = np.degrees(np.arccos(np.clip(R_WF[:, 1] @ across, -1, 1)))
            yield f"fingertip: Y of {hand.fingertip} is {angle:.0f} deg off the other finger"
        if abs(R_WH[:, 1] @ across) < ALONG:
            yield f"grasp_frame: Y of {hand.grasp_frame} does not run from finger to finger"
        if R_WH[:, 2] @ R_WF[:, 2] < ALONG:
            yield f"grasp_frame: Z of {hand.grasp_frame} and Z of {hand.fingertip} differ"
        off = min(self._beside(state) for state in (hand.open, hand.closed))
        if off > BESIDE:
            what = f"{hand.grasp_frame} is {1000 * off:.0f} mm beside the middle of the tips"
            yield f"grasp_frame: {what}, open and closed"

    def _beside(self, state: str) -> float:
        """Distance of H from the middle between the tips in a state, along its Y [m]."""
        own, other = (self.ends(state, links) for links in (self.own, self.other))
        X_WH = np.asarray(self.robot.pose(self.hand.grasp_frame, self.robot.state(state)))
        return abs(float((X_WH[:3, 3] - (middle(own) + middle(other)) / 2) @ X_WH[:3, 1]))

    def _of_surface(self) -> Iterator[str]:
        """Compares F with the surface of the finger that slides, along its Z and across."""
        name, p = self.hand.fingertip, self.X_WF[:3, 3]
        cloud = self.tree.cloud(self.own, self.tree.poses(self.q_open))
        seen = (cloud - p) @ self.X_WF[:3, :3]
        beyond = float(seen[:, 2].max())
        if abs(beyond) > NEAR:
            way = "behind" if beyond > 0 else "in front of"
            what = f"{name} lies {1000 * abs(beyond):.1f} mm {way} the end of the finger"
            yield f"fingertip: {what}, along its Z"
            return
        end = seen[seen[:, 2] > beyond - NEAR]
        for axis, letter in enumerate("XY"):
            low, high = end[:, axis].min() - NEAR, end[:, axis].max() + NEAR
            if not low < 0 < high:
                off = 1000 * min(abs(low), abs(high))
                what = f"{name} lies {off:.1f} mm beside the end of the finger"
                yield f"fingertip: {what}, along its {letter}"

    def of_states(self) -> Iterator[str]:
        hand = self.hand
        gaps = [self._gap(state) for state in (hand.open, hand.closed)]
        if gaps[1] >= gaps[0]:
            shown = " and ".join(f"{1000 * gap:.1f} mm" for gap in gaps)
            yield f"closed: the tips are not nearer than when open: {shown} apart, closed and open"
        for text in _of_open(self.tree, [*self.own, *self.other], hand.open):
            yield f"open: {text}"

    def _gap(self, state: str) -> float:
        own, other = (self.ends(state, links) for links in (self.own, self.other))
        return float(np.linalg.norm(middle(other) - middle(own)))


def _of_open(tree: Tree, links: list[int], state: str) -> Iterator[str]:
    """Names links of the open hand that touch each other, wherever the arm is."""
    lines = [tree.line(tree.body(link)) for link in links]
    palm = next(link for link in lines[0] if all(link in line for line in lines))
    hand = {tree.links[link] for link in tree.links_below(tree.body(palm))}
    robot = tree.robot
    for a, b in sorted(touching(scene.Scene(robot), hand, np.asarray(robot.state(state)))):
        yield f"{a} and {b} touch"


def _of_home(tree: Tree, state: str) -> Iterator[str]:
    """Names links that touch at home with the hand open, as at the start of a task."""
    if "home" not in tree.states:
        return
    robot = tree.robot
    try:
        q = np.asarray(robot.state("home", robot.state(state)))
    except ValueError as error:
        yield f"home: {error}; set robot.home in tasks, or mend or remove this state"
        return
    pair = scene.Scene(robot).collision(q)
    if pair is not None:
        yield f"home: {pair[0]} and {pair[1]} touch"
