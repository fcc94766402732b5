# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files of kind pick, which `graspless pick` reads: see docs/task-files.md."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from ..errors import one_of
from ..tasks.budget import Budget
from ..tasks.chain.stages import absolute
from ..tasks.obstacles import Obstacles
from ..tasks.reading import read_yaml
from ..tasks.scenes import PADDING, RESPECT, Respect
from ..tasks.shapes import Fields, Padding, Positive
from ..tasks.source import Source
from ..tasks.units import warn_of_units
from .obstacles import resolved
from .place_fields import Place
from .strategies import STRATEGIES

BUDGET = ("seconds", "seed")  # of several searches of several kinds


class PickTask(Fields):
    """A pick."""

    kind: Literal["pick"]
    scene: str = Field(description="scene file of `graspless see`")
    name: str = Field(description="name of the object in the scene")
    robot: dict[str, Any] | None = Field(default=None, description="as in all tasks")
    robots: Annotated[list[dict[str, Any]], Field(min_length=1)] | None = Field(
        default=None, description="instead: several robots, of which any may do it"
    )
    strategies: Annotated[list[str], Field(min_length=1)] = Field(
        default=list(STRATEGIES), description="strategies to try, in this order"
    )
    place: Place | None = Field(default=None, description="where the object is put down")
    lift: Positive = Field(default=0.1, description="height of the lift [m]")
    respect: Respect = Field(default="objects", description=RESPECT)
    padding: Padding = Field(default=0.0, description=PADDING)
    obstacles: Obstacles = Field(
        default=[], description="further bodies that nothing may touch, as in all tasks"
    )
    max_age: Positive | None = Field(
        default=None, description="largest age of the images of the scene [s]"
    )
    mass: Positive | None = Field(
        default=None, description="mass, which grasps must bear; needed to tumble and push [kg]"
    )
    grip_force: Annotated[float, Field(gt=0, le=1000)] | None = Field(
        default=None, description="force of each finger that pinches [N]"
    )
    best_of: Annotated[int, Field(ge=1)] = Field(
        default=1,
        description="largest number of plans, of which the one of the shortest duration is kept",
    )
    budget: Budget = Budget.model_construct()

    @model_validator(mode="after")
    def _check(self) -> PickTask:
        self.one_of("robot", "robots")
        return self


def read_pick(path: str) -> dict[str, Any] | None:
    """Returns the arguments of `pick` in a task file, or None if the file is of another kind.

    Raises TaskError with the line and field.
    """
    if not Path(path).is_file():
        return None
    source: Source = read_yaml(Path(path))
    if not isinstance(source.data, dict) or source.data.get("kind") != "pick":
        return None
    fields: PickTask = source.validate(PickTask)
    directory = Path(path).resolve().parent
    warn_of_units(fields, source)
    given = fields.model_dump(exclude={"kind", "budget", "robots"}) | {"place": fields.place}
    given["scene"] = str(directory / fields.scene)
    given["obstacles"] = resolved(fields.obstacles, fields.name, source, directory)
    given["robot"] = absolute(fields.robots or fields.robot, directory)
    budget = fields.budget.model_dump(exclude_none=True)
    for name in budget.keys() - BUDGET:
        raise source.error(("budget", name), f"not for a pick{one_of(name, BUDGET)}")
    return given | budget
