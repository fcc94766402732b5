# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which stages can follow one another, as far as that is known before anything is planned."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .stages import Stage

HOLDING = ("slide", "clasp", "carry")  # after these the hand holds the object


def require_joined(stages: Sequence[Stage]) -> None:
    """Raises TaskError that names the stage and the field which cannot follow the one before it."""
    if stages[0].kind == "carry":
        raise stages[0].source.error(("kind",), "nothing is held: a slide or a clasp comes first")
    for before, stage in pairwise(stages):
        _require_hand(before, stage)
        if stage.kind != "carry":
            _require_same_robot(before, stage)
            _require_same_object(before, stage)


def _require_hand(before: Stage, stage: Stage) -> None:
    if before.kind in HOLDING and stage.kind != "carry":
        what = f"the hand holds the object after '{before.name}': only a carry can follow"
        raise stage.source.error(("kind",), what)
    if before.kind not in HOLDING and stage.kind == "carry":
        what = f"nothing is held after '{before.name}': a slide or a clasp comes first"
        raise stage.source.error(("kind",), what)


def _require_same_robot(before: Stage, stage: Stage) -> None:
    old, new = before.fields.robot, stage.fields.robot
    if (old is None) != (new is None):
        has = "has none" if old is None else "has one"
        what = "must not be given" if old is None else "missing"
        raise stage.source.error(("robot",), f"{what}: '{before.name}', the stage before it, {has}")
    if old is not None and _without_home(old) != _without_home(new):
        what = f"should be that of '{before.name}', the stage before it"
        raise stage.source.error(("robot",), what)


def _without_home(robot: Any) -> dict[str, Any]:
    document: dict[str, Any] = robot.model_dump()
    del document["home"]
    return document


def _require_same_object(before: Stage, stage: Stage) -> None:
    old, new = before.fields.object, stage.fields.object
    if old.name != new.name:
        what = f"'{before.name}', the stage before it, has '{old.name}'"
        raise stage.source.error(("object", "name"), what)
    if before.kind == stage.kind and _shape(old) != _shape(new):
        what = f"should be that of '{before.name}', the stage before it"
        raise stage.source.error(("object",), what)


def _shape(thing: Any) -> dict[str, Any]:
    document: dict[str, Any] = thing.model_dump(exclude={"pose"})
    return document
