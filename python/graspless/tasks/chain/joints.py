# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rules for the order of stages that can be checked before planning."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..source import Source
    from .stage import Stage

ON_SUPPORT = ("slide", "pinch")  # kinds whose object is an outline on a support
HOLDING = (*ON_SUPPORT, "clasp", "carry")  # after these the hand holds the object


def require_held(stages: Sequence[tuple[str, str, Source]]) -> None:
    """Raises TaskError if a stage needs a holding or an empty hand and does not get it.

    Parameters
    ----------
    stages : sequence of (name, kind, source)
    """
    held, last, put, left = False, "", "", ""
    for name, kind, source in stages:
        leaves = kind == "slide" and source.data.get("end") is not None
        what = ""
        if put and not leaves:
            what = f"'{put}' puts the object down: only a slide with an `end` can follow"
        elif kind == "carry" and not held:
            after = f" after '{last}'" if last else ""
            what = f"nothing is held{after}: a slide, a pinch or a clasp comes first"
        elif kind != "carry" and held:
            what = f"the hand holds the object after '{last}': only a carry can follow"
        elif left and kind not in ON_SUPPORT:
            what = f"'{left}' leaves the object on its support: only a slide or a pinch can follow"
        if what:
            raise source.error(("kind",), what)
        put = name if source.data.get("place") is not None else ""
        left = name if leaves else ""
        held, last = kind in HOLDING and not put and not left, name


def require_joined(stages: Sequence[Stage]) -> None:
    """Raises TaskError that names the stage and the field which cannot follow the one before it."""
    require_held([(stage.name, stage.kind, stage.source) for stage in stages])
    own = [stage for stage in stages if stage.kind != "carry"]  # a carry has what it is given
    for before, stage in pairwise(own):
        _require_same_robot(before, stage)
        _require_same_object(before, stage)
        _require_same_fingers(before, stage)


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
    if before.kind == "clasp":
        what = f"must be an outline, but '{before.name}', before it, clasps a cloud"
        raise stage.source.error(("object",), what)
    are_outlines = before.kind in ON_SUPPORT and stage.kind in ON_SUPPORT
    if (before.kind == stage.kind or are_outlines) and _shape(old) != _shape(new):
        what = f"should be that of '{before.name}', the stage before it"
        raise stage.source.error(("object",), what)


def _require_same_fingers(before: Stage, stage: Stage) -> None:
    if not before.kind == stage.kind == "fingertip":
        return
    for name in ("count", "radius"):
        if getattr(before.fields.fingers, name) != getattr(stage.fields.fingers, name):
            what = f"should be that of '{before.name}', the stage before it"
            raise stage.source.error(("fingers", name), what)


def _shape(thing: Any) -> dict[str, Any]:
    document: dict[str, Any] = thing.model_dump(exclude={"pose"})
    return document
