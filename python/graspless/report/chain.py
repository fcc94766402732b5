# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of chains, made from those of their stages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import as_dict, as_text

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator

    from ..chain import Plan


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    named = zip(plan.names, plan.stages, strict=True)
    return {
        "stages": [{"name": name, "kind": stage.kind} | as_dict(stage) for name, stage in named],
        "segments": [
            {"name": s.name, "stage": s.stage, "segment": s.segment} for s in plan.contents
        ],
    }


def lines(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns the lines of each stage."""
    return list(_stages(plan, told))


def lines_not_found(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns the lines of the stages that were planned; the last one may have failed."""
    return list(_stages(plan, told))


def _stages(plan: Plan, told: Collection[str]) -> Iterator[str]:
    for name, stage in zip(plan.names, plan.stages, strict=True):
        first, *rest = as_text(stage, told).splitlines()
        yield f"{name} ({stage.kind}): {first}"
        yield from (f"  {line}" for line in rest)
