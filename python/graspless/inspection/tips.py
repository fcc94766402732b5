# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames at the ends of two fingers, and the size of the pad (docs/notation.md)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import slide

if TYPE_CHECKING:
    from ..frames import Matrix
    from .jaws import Jaws
    from .palm import Finger
    from .tree import Tree

END = 0.001  # depth of the end of a finger, whose middle is the tip [m]
PAD = 0.010  # length of the pad, whose width is measured [m]
NEAR = 0.040  # links of a finger within this distance of its end may touch the object [m]
PITCHES = (slide.Options().pitch, *np.radians([50, 55, 60, 65, 70, 75, 80]))
PITCH_TOLERANCE = slide.Options().pitch_tolerance
DEEPEST = 0.003  # of the finger below F; where it is lower, F is moved to its lowest point [m]
SINK = 0.0045  # of the finger below F within the tolerance of the pitch; check() allows 5 mm [m]
AT_END = 0.0025  # the point that touches a surface is this near to the finger's end [m]
BESIDE_JAW = 0.006  # of the grasp frame from a jaw that does not move [m]
STATES = 9  # of the hand, from open to closed, in which its tips are looked at
CLEARANCE = 0.01  # of the rest of the hand over the surface [m]
SMALLEST, LARGEST_RADIUS, LARGEST_PAD = 0.0005, 0.02, 0.2  # [m]


@dataclass(frozen=True)
class Tip:
    """End of a finger with the hand open.

    Attributes
    ----------
    X_WF : array [4, 4]
        F: at the outer edge of the end, which touches a surface first when the finger is pitched.
        Z out of the tip, Y towards the other finger.
    middle_W : array [3]
        Middle of the end [m].
    inner_W : array [3]
        The same on the side of the other finger [m].
    link : int
        Link that F is fixed in.
    links : tuple of int
        Links that may touch the object.
    radius, width : float
        Of the pad: half of the end's size along Y, and its size along X, within limits [m].
    """

    X_WF: Matrix
    middle_W: Matrix
    inner_W: Matrix
    link: int
    links: tuple[int, ...]
    radius: float
    width: float


def find_tips(tree: Tree, jaws: Jaws) -> tuple[Tip, Tip]:
    """Returns the ends of both fingers."""
    turned = jaws.R_WH @ np.diag([-1.0, -1.0, 1.0])  # Y from the first finger to the second
    first, second = jaws.fingers
    return _tip(tree, first, jaws.open, turned), _tip(tree, second, jaws.open, jaws.R_WH)


def _tip(tree: Tree, finger: Finger, q: Matrix, R_WF: Matrix) -> Tip:
    X_WL = tree.poses(q)
    links = finger.links(tree)
    clouds = {link: tree.cloud([link], X_WL) @ R_WF for link in links}
    end = max(float(cloud[:, 2].max()) for cloud in clouds.values())
    near = tuple(link for link in links if clouds[link][:, 2].max() > end - NEAR)
    last = max(links, key=lambda link: float(clouds[link][:, 2].max()))
    every = np.vstack(list(clouds.values()))
    low, high = _box(every[every[:, 2] > end - END])
    X_WF = np.eye(4)
    X_WF[:3, :3] = R_WF
    middle = (low + high) / 2
    X_WF[:3, 3] = R_WF @ [middle[0], low[1], end]
    pad = _box(every[every[:, 2] > end - PAD])
    return Tip(
        X_WF,
        R_WF @ [*middle[:2], end],
        R_WF @ [middle[0], pad[1][1], end],
        last,
        near,
        float(np.clip((high - low)[1] / 2, SMALLEST, LARGEST_RADIUS)),
        float(np.clip((pad[1] - pad[0])[0], SMALLEST, LARGEST_PAD)),
    )


def _box(points: Matrix) -> tuple[Matrix, Matrix]:
    return points.min(axis=0), points.max(axis=0)


def grasp_pose(tree: Tree, jaws: Jaws, tips: tuple[Tip, Tip]) -> Matrix:
    """Returns H in W with the hand open: between the tips, where they are when they meet.

    Tips on arcs reach farther while they close. A jaw that does not move is beside the object.
    """
    links = [link for finger in jaws.fingers for link in finger.links(tree)]
    states = (jaws.open + t * (jaws.closed - jaws.open) for t in np.linspace(0, 1, STATES))
    clouds = (tree.cloud(links, tree.poses(q)) for q in states)
    out = jaws.R_WH[:, 2]
    X_WH = np.eye(4)
    X_WH[:3, :3] = jaws.R_WH
    X_WH[:3, 3] = (tips[0].middle_W + tips[1].middle_W) / 2
    if jaws.fingers[0].is_fixed:
        X_WH[:3, 3] = tips[0].inner_W + BESIDE_JAW * tips[0].X_WF[:3, 1]
    end = max(float((cloud @ out).max()) for cloud in clouds)
    X_WH[:3, 3] += out * (end - X_WH[:3, 3] @ out)
    return X_WH


def find_pitch(tree: Tree, jaws: Jaws, tip: Tip, hand: list[int]) -> tuple[float, float, Matrix]:
    """Returns the flattest pitch at which the finger's end touches a surface, and nothing else.

    Parameters
    ----------
    tree : Tree
    jaws : Jaws
    tip : Tip
        Of the finger that slides.
    hand : list of int
        Links of palm and fingers.

    Returns
    -------
    tuple of float, float and array [3]
        Pitch [rad], distance of the rest of the open hand from the surface [m], and the point in F
        that touches the surface, or 0 if F is near enough [m].
    """
    others = [link for link in hand if link not in tip.links]
    X_WL, R_WF = tree.poses(jaws.open), tip.X_WF[:3, :3]
    rest, own = (
        (tree.cloud(list(links), X_WL) - tip.X_WF[:3, 3]) @ R_WF for links in (others, tip.links)
    )
    pitch, room, touch = PITCHES[-1], 0.0, np.zeros(3)
    for pitch in PITCHES:
        touch = _lowest(own, pitch)
        if touch @ _up(pitch) > -DEEPEST:
            touch = np.zeros(3)
        least = [pitch - PITCH_TOLERANCE, pitch + PITCH_TOLERANCE]
        room = min(float(((rest - touch) @ _up(p)).min()) for p in least)
        sink = max(-float(((own - touch) @ _up(p)).min()) for p in least)
        if room > CLEARANCE and touch[2] > -AT_END and sink < SINK:
            return float(pitch), room, touch
    return float(pitch), min(room, 0.0) if touch[2] <= -AT_END else room, np.zeros(3)


def _up(pitch: float) -> Matrix:
    """Direction in F away from the surface on which the finger presses."""
    return np.array([0.0, np.cos(pitch), -np.sin(pitch)])


def _lowest(points_F: Matrix, pitch: float) -> Matrix:
    """Returns the lowest of points at a pitch, in the middle along X; (3,) in F."""
    heights = points_F @ _up(pitch)
    lowest = points_F[int(np.argmin(heights))].copy()
    lowest[0] = 0.0
    return np.asarray(lowest)
