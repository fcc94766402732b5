# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans in an independent physics engine: MuJoCo executes them and the object is the judge.

The engine reads the robot by its own URDF reader, and makes the object of the task's shape and
mass. No search, collision test or check() takes part; docs/internals/physics.md lists what is shared
with the planners. `settings` has the parameters.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from .._arguments import require_integer
from ..errors import TaskError
from ..kinds import part
from ..plans import as_plan
from .results import Recording, Simulation, Trial
from .variation import Variation, variations

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from ..plans import Plan
    from .settings import Spread

OLDEST = 4  # version of MuJoCo that was tested; early 3.3 lacks parts of MjSpec


class SimulationKind(Protocol):
    """What `simulation` needs of a kind."""

    FAILURES: dict[str, str]
    """What can go wrong: name, and what it means."""

    MEASURES: dict[str, str]
    """What is measured: name, and what it means with its unit."""

    # SPREAD, a settings.Spread, where trials vary otherwise than Spread() says.

    def run(self, plan: Plan, variation: Variation, *, record: bool = False) -> Trial:
        """Executes a plan that is solved."""


def simulate(
    plan: Plan | str | Path,
    trials: int = 1,
    seed: int = 0,
    *,
    record: bool = False,
    progress: Callable[[int], None] | None = None,
) -> Simulation:
    """Executes a plan in MuJoCo, and says what became of the object.

    Parameters
    ----------
    plan : Plan, str or Path
        One that is solved, or the file it stands in. It is not checked: `check` does that.
    trials : int
        The first is nominal; the others vary friction, mass, the object's place and the time step.
        Of fingertip plans: friction by 10 %, the fingers' places (with an arm the object's) by
        0.1 mm, and the time step, but no mass.
    seed : int
        Of these variations.
    record : bool
        Whether the first trial keeps what moved.
    progress : callable, optional
        Called with the number of trials that are done.

    Raises
    ------
    TaskError
        The plan is not solved, trials is no whole number from 1 or seed none from 0, or MuJoCo is
        not installed.
    """
    plan = as_plan(plan)
    if not plan:
        raise TaskError(f"the plan's status is {plan.status}, not solved: nothing to simulate")
    trials = require_integer("trials", trials, least=1)
    seed = require_integer("seed", seed, least=0)
    kind = simulation_kind(plan.kind)
    done: list[Trial] = []
    spread: Spread | None = getattr(kind, "SPREAD", None)
    for variation in variations(trials, seed, spread):
        done.append(kind.run(plan, variation, record=record and not done))
        if progress is not None:
            progress(len(done))
    return Simulation(plan, seed, done)


def simulation_kind(name: str) -> SimulationKind:
    """What is a kind's own; raises TaskError without MuJoCo."""
    try:
        require_mujoco()
        kind: SimulationKind = part("simulation", name)
    except ImportError as error:
        if error.name == f"{__name__}.{name}":
            raise TaskError(
                f"a {name} is not simulated alone: plan a chain of a slide and what is carried "
                "after it, and simulate that plan"
            ) from None
        raise TaskError(f"needs {error.name or error}: pip install 'graspless[sim]'") from None
    return kind


def require_mujoco() -> None:
    """Raises TaskError where an older MuJoCo is installed than was tested, ImportError without."""
    import mujoco

    version = str(mujoco.__version__)
    if int(version.partition(".")[0]) < OLDEST:
        raise TaskError(
            f"needs mujoco>={OLDEST}.0, {version} is installed: pip install 'graspless[sim]'"
        )


__all__ = ["Recording", "Simulation", "Trial", "Variation", "simulate"]
