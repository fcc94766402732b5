# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hand of a task: its fields, their file, and the hand itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Discriminator, Field, Tag

from ..._core import clasp
from ...files import absence
from ..blame import blamed
from ..effective_values import plain
from ..reading import read_yaml
from ..robots import stem
from ..shapes import Direction, Fields, Point3
from ..source import Source

if TYPE_CHECKING:
    from pathlib import Path

    from ..._core import robot as robots
    from ...clasp import Plan
    from ..source import Location


class Node(Fields):
    """Corner of a finger curve, fixed in a link."""

    link: str
    point: Point3 = Field(default=[0.0, 0.0, 0.0], description="position in the link's frame [m]")


Nodes = Annotated[list[Node], Field(min_length=2)]


def _kind_of_open(value: Any) -> str:
    return "list" if isinstance(value, list) else "name"


PreShapes = Annotated[
    Annotated[str, Tag("name")] | Annotated[Annotated[list[str], Field(min_length=1)], Tag("list")],
    Discriminator(_kind_of_open),
]


class Hand(Fields):
    """Description of a hand: graspless.clasp.Hand."""

    arm: str | None = Field(default=None, description="group of joints that carry the hand")
    hand: str | None = Field(default=None, description="group of the joints that close the hand")
    frame: str = Field(description="link H of the palm")
    forward: Direction = Field(
        description="direction in H from the palm towards the handle, of any length"
    )
    sideways: Direction = Field(description="direction in H along the handle")
    open: PreShapes | None = Field(
        default=None,
        description="state of the hand's joints at the start of the search, the pre-shape; or a "
        "list of several to try, the first at once",
    )
    closed: str | None = Field(default=None, description="state towards which each joint closes")
    fingers: Annotated[dict[str, Nodes], Field(min_length=1)] = Field(
        description="corners of each finger, from the palm to the tip"
    )
    thumb: Nodes = Field(
        description="corners of the part that the fingers close against, from the palm to the tip"
    )


def resolve_hand(
    hand: Hand | str | None, urdf: Path | None, source: Source, directory: Path
) -> tuple[Hand | None, Source]:
    """Returns the hand's fields and their source: the task, a file, or a file beside the URDF.

    None if they are in none of these.
    """
    if isinstance(hand, Hand):
        return hand, source
    if isinstance(hand, str):
        path = directory / hand
        if not path.is_file():
            raise source.error(("hand",), absence(path))
    else:
        beside = urdf and urdf.with_name(f"{stem(urdf)}.clasp.yaml")
        if beside is None or not beside.is_file():
            return None, source
        path = beside
    read = read_yaml(path)
    return read.validate(Hand), read


def build_hand(
    fields: Hand, robot: robots.Robot, source: Source, place: tuple[str, ...]
) -> clasp.Hand:
    """Returns the planner's hand. Error messages name the field at `place` of `source`."""
    try:
        hand = clasp.with_palm_corners(stated_hand(fields), robot)
        clasp.validate(hand, robot)
    except ValueError as error:
        raise blamed(source, str(error), _places(fields, place)) from None
    return hand


def stated_hand(fields: Hand) -> clasp.Hand:
    """Returns the hand as its file has it, without palm corners."""
    names = {
        name: value
        for name in ("arm", "hand", "closed")
        if (value := getattr(fields, name)) is not None
    }
    if fields.open is not None:
        first, *others = [fields.open] if isinstance(fields.open, str) else fields.open
        names |= {"open": first, "pre_shapes": others}
    return clasp.Hand(
        frame=fields.frame,
        forward_H=_unit(fields.forward),
        sideways_H=_unit(fields.sideways),
        fingers=[_finger(name, nodes) for name, nodes in fields.fingers.items()],
        thumb=_finger("thumb", fields.thumb),
        **names,
    )


def hand_of(plan: Plan) -> clasp.Hand:
    """Returns the hand as a plan uses it: with the fingers that clasp, from its pre-shape."""
    hand = plan.task.problem.hand  # a copy
    if plan.fingers:
        hand.fingers = [finger for finger in hand.fingers if finger.name in plan.fingers]
    hand.open, hand.pre_shapes = plan.pre_shape or hand.open, []
    return hand


def hand_in_force(hand: clasp.Hand) -> Hand:
    """Returns the fields of the planner's hand."""
    return Hand(
        arm=hand.arm,
        hand=hand.hand,
        frame=hand.frame,
        forward=plain(hand.forward_H),
        sideways=plain(hand.sideways_H),
        open=[hand.open, *hand.pre_shapes] if hand.pre_shapes else hand.open,
        closed=hand.closed,
        fingers={finger.name: _nodes(finger) for finger in hand.fingers},
        thumb=_nodes(hand.thumb),
    )


def _unit(direction: list[float]) -> np.ndarray:
    vector = np.array(direction, dtype=float)
    length = float(np.linalg.norm(vector))
    # A unit vector stays as it is, so that a plan file reads as it was written.
    return vector if abs(length - 1) < 1e-12 else np.asarray(vector / length)


def _finger(name: str, nodes: list[Node]) -> clasp.Finger:
    corners = [clasp.CurveNode(link=node.link, p_L=np.array(node.point)) for node in nodes]
    return clasp.Finger(name=name, nodes=corners)


def _nodes(finger: clasp.Finger) -> list[Node]:
    return [Node(link=node.link, point=plain(node.p_L)) for node in finger.nodes]


def _places(fields: Hand, place: Location) -> dict[str, Location]:
    """Returns the field at `place` of a file for each part of a hand of the core."""
    shapes = fields.open if isinstance(fields.open, list) else []
    curves = {f"fingers.{name}": ("fingers", name) for name in fields.fingers}
    parts: dict[str, Location] = {name: (name,) for name in Hand.model_fields}
    parts |= {f"pre_shapes[{i}]": ("open", i + 1) for i in range(len(shapes) - 1)}
    parts |= curves | {f"{name}.nodes": field for name, field in curves.items()}
    parts |= {"thumb.nodes": ("thumb",)}
    return {"": place} | {f"hand.{name}": (*place, *field) for name, field in parts.items()}
