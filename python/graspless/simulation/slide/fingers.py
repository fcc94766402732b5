# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingers of a slide, and what yields when they press.

`flexure`: each finger turns about one flexure behind its tip, held by a spring. `impedance`: the
wrist gives way in translation. `rigid_guarded`: the same, stiffer, and the finger is pressed down
with the force of the hand. `none`: nothing yields.

Frame F is the sliding finger's: X along the line contact, Z out of the tip, Y towards the other
finger. The other finger is its mirror image in the hand's frame H.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames, geometry
from ...errors import TaskError
from ..parts import REPLACED
from ..robots import untested_pairs

if TYPE_CHECKING:
    from ... import slide
    from ...frames import Matrix
    from ...robot import Robot
    from ..settings import Slide

SLIDING, OTHER = "sliding finger", "other finger"
WRIST = "wrist "
PAD = "pad"
_MIRROR = np.diag([1.0, -1.0, 1.0, 1.0])


@dataclass(frozen=True)
class Bits:
    """Collision bits of a geom: contype and conaffinity of MuJoCo."""

    contype: int
    conaffinity: int


def add_fingers(
    spec: Any, robot: Robot, hand: slide.Hand, settings: Slide, bits: dict[str, Bits]
) -> None:
    """Makes the fingers of a robot in `spec` yield, and gives the sliding one its pad.

    The shapes of a finger's link move to a body of the finger's mass, which turns about the
    flexure, if there is one. The pad is a row of spheres, so that a line evenly pressed resists
    turning.
    """
    _soften_wrist(spec, robot, hand, settings)
    q = np.array(robot.state(hand.open))
    X_WF, X_WH = robot.pose(hand.fingertip, q), robot.pose(hand.grasp_frame, q)
    X_HF = np.linalg.inv(X_WH) @ X_WF
    flexing = _flexing_links(robot, hand)
    for name, link in flexing.items():
        # A mirrored frame is left-handed: its X axis is turned round to make a frame of it.
        X_HT = X_HF if name == SLIDING else _MIRROR @ X_HF @ np.diag([-1.0, 1.0, 1.0, 1.0])
        X_LT = np.linalg.inv(robot.pose(link, q)) @ X_WH @ X_HT
        flex = _add_flexure(spec, name, link, X_LT, hand, settings)
        X_XL = np.asarray(np.linalg.inv(_behind(X_LT, hand.flexure_length)), dtype=float)
        _move_shapes(spec.body(link), flex, X_XL)
        for geom in flex.geoms:
            geom.contype, geom.conaffinity = bits[name].contype, bits[name].conaffinity
            geom.condim, geom.priority = 6, 1
            rub(geom, hand, settings)
        _exclude_as(spec, robot, link, name)
    _add_pad(spec.body(SLIDING), hand, settings)


def whole_fingers(robot: Robot, hand: slide.Hand) -> set[str]:
    """Returns the links of the fingers that hold objects with a convex shape.

    Their other links, such as the bars behind the pads of a Robotiq, need no slices.
    """
    convex = {
        robot.frame_names[link]
        for link, placed in robot.shapes
        if not isinstance(placed.shape, geometry.Mesh)
    }
    holding, sliding = _flexing_links(robot, hand), set(hand.sliding_finger)
    of = {SLIDING: sliding, OTHER: set(hand.fingers) - sliding}
    return {link for name, last in holding.items() if last in convex for link in of[name]}


def wrist_stiffness(hand: slide.Hand, settings: Slide) -> float | None:
    """Returns the stiffness of the wrist in translation [N/m]; None if it does not yield."""
    if hand.finger_model == "impedance":
        return hand.wrist_stiffness
    return settings.guarded_stiffness if hand.finger_model == "rigid_guarded" else None


def _soften_wrist(spec: Any, robot: Robot, hand: slide.Hand, settings: Slide) -> None:
    """Lets the last link of the arm give way along three axes, each with a spring."""
    stiffness = wrist_stiffness(hand, settings)
    if stiffness is None:
        return
    last = robot.joint_names[robot.group(hand.arm)[-1]]
    wrist = spec.joint(last).parent
    damping = 2 * settings.wrist_damping_ratio * np.sqrt(stiffness * settings.wrist_mass)
    for name, axis in zip("xyz", np.eye(3), strict=True):
        joint = wrist.add_joint(name=f"{WRIST}{name}", type=mujoco.mjtJoint.mjJNT_SLIDE, axis=axis)
        joint.stiffness = [stiffness, 0, 0]
        joint.damping = [damping, 0, 0]


def _flexing_links(robot: Robot, hand: slide.Hand) -> dict[str, str]:
    """Returns the link that carries the fingertip, and the last one of the other finger."""
    index = robot.frame(hand.fingertip)
    while robot.frame_names[index] not in hand.sliding_finger and robot.parent(index) >= 0:
        index = robot.parent(index)
    own = robot.frame_names[index]
    others = [link for link in hand.fingers if link not in hand.sliding_finger]
    return {SLIDING: own if own in hand.sliding_finger else hand.sliding_finger[-1]} | (
        {OTHER: others[-1]} if others else {}
    )


def _behind(X_LT: Matrix, length: float) -> Matrix:
    X_LX: Matrix = X_LT @ frames.translation([0.0, 0.0, -length])
    return X_LX


def _add_flexure(
    spec: Any, name: str, link: str, X_LT: Matrix, hand: slide.Hand, settings: Slide
) -> Any:
    body = spec.body(link)
    X_LX = _behind(X_LT, hand.flexure_length)
    flex = body.add_body(name=name, pos=X_LX[:3, 3], quat=frames.to_quaternion(X_LX), gravcomp=1.0)
    mass, own = float(body.mass), float(np.max(body.fullinertia[:3]))
    if not mass > 0 and hand.finger_model != "flexure" and not body.joints:
        return flex  # a pad without mass, fixed to a finger that has some
    # The mass of the finger turns about the flexure; the link keeps hardly any.
    p_XC = np.linalg.inv(X_LX)[:3] @ [*body.ipos, 1.0]
    if not mass > 0:
        raise TaskError(f"link '{link}' has no mass; the simulation needs its <inertial>")
    flex.mass, flex.ipos, flex.inertia = mass, p_XC, [own, own, own]
    flex.explicitinertial = True
    body.mass, body.fullinertia = settings.link_mass, [*3 * [settings.link_inertia], 0, 0, 0]
    inertia = own + mass * float(p_XC[1] ** 2 + p_XC[2] ** 2)
    if hand.finger_model != "flexure":
        return flex
    k = hand.flexure_stiffness
    joint = flex.add_joint(name=name, type=mujoco.mjtJoint.mjJNT_HINGE, axis=[1, 0, 0])
    joint.stiffness = [k, 0, 0]
    joint.damping = [2 * settings.flexure_damping_ratio * np.sqrt(k * inertia), 0, 0]
    return flex


def _move_shapes(link: Any, flex: Any, X_XL: Matrix) -> None:
    """Moves the geoms of the link to the flexing body."""
    for geom in [geom for geom in link.geoms if geom.group != REPLACED]:
        X_XG = X_XL @ frames.translation(geom.pos) @ frames.from_quaternion(geom.quat)
        flex.add_geom(
            type=geom.type,
            size=geom.size,
            meshname=geom.meshname,
            pos=X_XG[:3, 3],
            quat=frames.to_quaternion(X_XG),
        )
        geom.contype = geom.conaffinity = 0
        geom.group = REPLACED


def _exclude_as(spec: Any, robot: Any, link: str, name: str) -> None:
    """Excludes the flexing body from the pairs from which its link is excluded."""
    names, own = robot.frame_names, robot.frame(link)
    for pair in untested_pairs(robot):
        if own in pair:
            other = pair[0] if pair[1] == own else pair[1]
            spec.add_exclude(bodyname1=name, bodyname2=names[other])


def rub(geom: Any, hand: slide.Hand, settings: Slide) -> None:
    """Adds a soft pad, whose patch withstands moments about the normal and across it."""
    mu, a = hand.pad_friction, settings.pad_softness
    geom.friction = [mu, 2 / 3 * mu * a, a]
    geom.solref = [settings.tip_solref, 1.0]
    geom.solimp = [*settings.grip_solimp, 0.5, 2.0]


def _add_pad(flex: Any, hand: slide.Hand, settings: Slide) -> None:
    for i, x in enumerate(pad_offsets(hand.pad_width, settings.pad_points)):
        flex.add_geom(
            name=f"{PAD}{i}",
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            size=[hand.tip_radius, 0, 0],
            pos=[x, 0.0, hand.flexure_length - hand.tip_radius],
            contype=0,
            conaffinity=0,
        )


def pad_offsets(width: float, n: int) -> Matrix:
    """Returns the positions of the points of the pad along X_F [n] [m]: centres of equal parts."""
    offsets: Matrix = ((np.arange(n) + 0.5) / n - 0.5) * width
    return offsets
