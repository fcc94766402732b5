# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the sliding planner."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

import numpy as np

from ..._core import slide
from ..documents import rows_of
from ..effective_values import in_force as _in_force
from ..effective_values import plain
from ..robots import require_text
from ..scenes import planar_pose
from ..statement import obstacle_fields, pose_fields, robot_fields, struct_fields
from .build import build as build_problem
from .build import build_options
from .model import CoreHand, OnSupport, SlideTask
from .resolve import resolve

if TYPE_CHECKING:
    from ..source import Source

SEARCHES = ("paper", "fast")
Fields = SlideTask


def require_resolved(fields: OnSupport, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    require_text(fields.robot, source)
    for name in ("cloud", "scene"):
        if getattr(fields.object, name) is not None:
            raise source.error(("object", name), "must be part of the plan file")
    if isinstance(fields.hand, str):
        raise source.error(("hand",), "must be part of the plan file")


def build(fields: SlideTask, source: Source, other: Source) -> tuple[slide.Problem, None]:
    """Returns the problem of resolved fields. `other` is the source of the hand."""
    return build_problem(fields, source, other, slide.Problem), None


def options(fields: SlideTask, problem: slide.Problem, source: Source) -> slide.Options:
    """Returns the options of the search."""
    return build_options(fields, problem, source)


def in_force(fields: SlideTask, problem: slide.Problem, options: slide.Options) -> dict[str, Any]:
    """Fields with every value that was in force."""
    bounds = ("min_depth", "max_depth")
    depths = dict(zip(bounds, slide.depth_band(problem.hand, options), strict=True))
    support = {name: getattr(problem.support, name) for name in ("slab", "friction")}
    return {
        "support": fields.support.model_copy(update=support),
        "hand": _in_force(fields.hand, problem.hand),
        "options": _in_force(fields.options, options).model_copy(update=depths),
    }


def state(problem: slide.Problem, arm: None) -> dict[str, Any]:
    """Returns the task file of a problem, without options and budget."""
    thing, support = problem.object, problem.support
    end = problem.X_WO_end
    return {
        "robot": robot_fields(problem.robot, problem.q_home),
        "hand": struct_fields(problem.hand, list(CoreHand.model_fields)),
        "object": {
            **struct_fields(thing, ["name", "thickness", "com", "mass"]),
            **_outline(thing),
            **_heights(thing),
            **({"hollow": True} if thing.is_hollow else {}),
            "pose": planar_pose(support.X_WS, problem.X_WO_start),
        },
        **({} if end is None else {"end": planar_pose(support.X_WS, end)}),
        "support": {
            "polygon": plain(support.polygon.vertices),
            "pose": pose_fields(support.X_WS),
            "band_width": support.goal_band.width,
            **_usable_edges(support),
            **struct_fields(support, ["slab", "friction"]),
        },
        "obstacles": obstacle_fields(problem.obstacles),
    }


def _usable_edges(support: slide.Support) -> dict[str, Any]:
    """Returns the field of a support that has edges that are not usable."""
    if len(support.usable_edges) == len(support.polygon.vertices):
        return {}
    return {"usable_edges": list(support.usable_edges)}


def _heights(thing: slide.Object) -> dict[str, Any]:
    """Returns the field of an object that is no prism."""
    if thing.heights is None:
        return {}
    given = struct_fields(thing.heights, ["corner", "cell", "undersides"])
    return {"heights": {**given, "rows": plain(thing.heights.heights)}}


def _outline(thing: slide.Object) -> dict[str, Any]:
    """Its polygon and the spacing of the grid of contact points; of a cloud its points."""
    steps = np.concatenate([np.diff(np.unique(np.round(p, 12))) for p in thing.points.T])
    spacing = float(steps.min() if len(steps) else np.ptp(thing.outline.vertices, axis=0).max())
    given = {"polygon": plain(thing.outline.vertices), "spacing": spacing}
    with contextlib.suppress(ValueError):
        made = slide.Object.prism(thing.name, thing.outline, thing.thickness, spacing=spacing)
        if made.points.shape == thing.points.shape and np.allclose(made.points, thing.points):
            return given
    heights = np.full(len(thing.points), thing.thickness)
    return {"points": rows_of(np.column_stack([thing.points, heights]))}


__all__ = [
    "SEARCHES",
    "Fields",
    "build",
    "in_force",
    "options",
    "require_resolved",
    "resolve",
    "state",
]
