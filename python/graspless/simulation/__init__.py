# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of plans in an independent physics engine, judged by the motion of the object.

The engine reads the robot by its own URDF reader, and makes the object of the task's shape and
mass. No search, collision test or check() takes part; docs/internals/physics.md lists what is
shared with the planners. `settings` has the parameters.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from .._arguments import require_choice, require_integer
from ..errors import TaskError, install_command, missing
from ..kinds import part
from ..plan_files import as_motion
from .results import Recording, Simulation, Trial
from .settings import Spread
from .variation import Variation, variations

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from .._plan import Plan

MOST_TRIALS = 10_000
OLDEST = 4  # tested major version of MuJoCo; early 3.3 lacks parts of MjSpec


class SimulationKind(Protocol):
    """Interface that `simulation` needs of each kind of plan."""

    FAILURES: dict[str, str]
    """Possible failures: meaning by name."""

    MEASURES: dict[str, str]
    """Measured quantities: meaning and unit by name."""

    # Optional: SPREAD, a settings.Spread, if trials vary by other amounts than Spread();
    # failures_of(plan), if what failures mean depends on the plan;
    # require_simulated(task), which raises TaskError if no plan of the task can be executed. Kinds
    # that can be followed in closed loop have follow(), FOLLOWED_FAILURES, FOLLOWED_MEASURES,
    # CONDITIONS and draw().

    def run(self, plan: Plan, variation: Variation, *, record: bool = False) -> Trial:
        """Executes a solved plan."""


def simulate(
    plan: Plan | str | Path,
    trials: int = 1,
    seed: int = 0,
    *,
    closed_loop: bool = False,
    condition: str | None = None,
    record: bool = False,
    progress: Callable[[int], None] | None = None,
) -> Simulation:
    """Executes a plan in MuJoCo and judges it by the motion of the object.

    Parameters
    ----------
    plan : Plan, str or Path
        Solved plan, or the path of its file. It is not checked first; `check` does that.
    trials : int
        Number of trials. The first is nominal. The others vary friction, mass, the pose of
        the object and the time step. For fingertip plans they vary friction by 10 %, the positions
        of the fingers (with an arm: of the object) by 0.1 mm, and the time step. For slides,
        pinches, and chains that begin with them, they also vary thickness and centre of mass of
        the object, the height of the support, and the flexures of the fingers.
    seed : int
        Seed of the variations, and of the camera; at least 0.
    closed_loop : bool
        Execute a slide by a `following.Follower` with a camera that is late, noisy and biased.
    condition : str, optional
        A single difference from the plan for all trials of a slide: none, friction, start, kick,
        mass, thickness or table. Default: variations of everything, after a nominal trial.
    record : bool
        Keep a recording of the first trial.
    progress : callable, optional
        Called with the number of finished trials.

    Returns
    -------
    Simulation
        True if all trials held.

    Raises
    ------
    TaskError
        The plan is not solved or has a segment without rows, trials is not a whole number from 1
        to 10000, seed is not one of at least 0, the plan is no slide but closed_loop or condition
        is given, there is no such condition, or MuJoCo is not installed.
    """
    plan = as_motion(plan, "simulate")
    trials = require_integer("trials", trials, least=1, most=MOST_TRIALS)
    seed = require_integer("seed", seed, least=0)
    kind: Any = simulation_kind(plan.kind)
    drawn = _drawn(kind, plan, trials, seed, condition)
    if closed_loop and not hasattr(kind, "follow"):
        raise TaskError(f"closed_loop: {plan.kind} plans cannot be followed (slide plans can)")
    done: list[Trial] = []
    for trial, variation in enumerate(drawn):
        wanted = record and not done
        if closed_loop:
            done.append(kind.follow(plan, variation, [seed, trial], record=wanted))
        else:
            done.append(kind.run(plan, variation, record=wanted))
        if progress is not None:
            progress(len(done))
    return Simulation(plan, seed, done)


def _drawn(kind: Any, plan: Plan, trials: int, seed: int, condition: str | None) -> list[Variation]:
    """Returns one variation per trial."""
    if condition is None:
        return variations(trials, seed, getattr(kind, "SPREAD", None))
    known = getattr(kind, "CONDITIONS", None)
    if known is None:
        raise TaskError(f"condition: {plan.kind} plans have none (slide plans have)")
    require_choice("condition", condition, known)
    randoms = (np.random.default_rng([seed, trial]) for trial in range(1, trials + 1))
    return [kind.draw(condition, plan, random) for random in randoms]


def simulation_kind(name: str) -> SimulationKind:
    """Returns the simulation of a kind of plan; raises TaskError without MuJoCo."""
    try:
        require_mujoco()
        kind: SimulationKind = part("simulation", name)
    except ImportError as error:
        if error.name == f"{__name__}.{name}":
            raise TaskError(
                f"a {name} is not simulated alone: plan a chain of a slide or a pinch and what is "
                "carried after it, and simulate that plan"
            ) from None
        raise missing(error, "sim") from None
    return kind


def require_simulated(task: Any) -> SimulationKind:
    """Returns the simulation of a task's plans; raises TaskError if there is none."""
    kind: Any = simulation_kind(task.kind)
    if hasattr(kind, "require_simulated"):
        kind.require_simulated(task)
    return kind  # type: ignore[no-any-return]


def engine() -> str:
    """Returns name and version of the physics engine."""
    import mujoco

    return f"MuJoCo {mujoco.__version__}"


def require_mujoco() -> None:
    """Raises TaskError if MuJoCo is older than the tested version, ImportError if it is missing."""
    import mujoco

    version = str(mujoco.__version__)
    if int(version.partition(".")[0]) < OLDEST:
        raise TaskError(
            f"needs mujoco>={OLDEST}.0, {version} is installed: {install_command('sim')}"
        )


__all__ = [
    "Recording",
    "Simulation",
    "SimulationKind",
    "Spread",
    "Trial",
    "Variation",
    "engine",
    "require_simulated",
    "simulate",
    "simulation_kind",
    "variations",
]
