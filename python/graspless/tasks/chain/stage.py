# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stage of a chain as a task of its kind."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .. import build_task
from ..documents import document_of
from ..source import Source

if TYPE_CHECKING:
    from .. import Task
    from ..source import Location


@dataclass
class StageSource(Source):
    """Source of the fields of a stage, which can come from several places of one or two files."""

    parts: list[tuple[Source, Location]] = field(default_factory=list)

    @property
    def name(self) -> str:
        """Name of the stage; its kind by default."""
        source, above = self.parts[0]
        return str(source.data["stages"][above[1]].get("name", self.data["kind"]))

    def where(self, place: Location) -> str:
        """Returns the part that contains most of the path to a field; of several, the first."""

        def known(of: tuple[Source, Location]) -> int:
            source, above = of
            return source.depth((*above, *place)) - len(above)

        source, above = max(self.parts, key=known)
        return source.where((*above, *place))


@dataclass(frozen=True)
class Stage:
    """Stage whose start is not known yet.

    Attributes
    ----------
    name : str
    fields : SlideTask, FingertipTask, ClaspTask or CarryTask
        Resolved fields. Those that the stage before it decides are placeholders.
    source, other : Source
        Sources of the fields and of those from another file, for error messages.
    """

    name: str
    fields: Any
    source: Source
    other: Source

    @property
    def kind(self) -> str:
        """Planner that it is for: slide, pinch, fingertip, clasp or carry."""
        return str(self.fields.kind)

    def task(self, fields: Any) -> Task:
        """Returns the task, with the fields that the stage before it decided."""
        return build_task(fields, self.source, self.other)

    def document(self) -> dict[str, Any]:
        """Returns the stage as in a plan file."""
        return {"name": self.name, **document_of(self.fields)}
