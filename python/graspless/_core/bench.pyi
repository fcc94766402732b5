"""
What the planners are measured against.
"""
from __future__ import annotations
import enum
import graspless._core.planning
import graspless._core.slide
import numpy
import numpy.typing
import typing
__all__: list[str] = ['PairDraw', 'PairProblem', 'Peer', 'libraries']
class Peer(enum.Enum):
    """
    What the slide planner is measured against.
    """
    atlas_rrt_connect = ...
    cbirrt = ...
    cbirrt2 = ...
    forest = ...
    projected_biest = ...
    projected_rrt_connect = ...
    tangent_bundle_rrt_connect = ...
class PairDraw(enum.Enum):
    """
    How a goal is found for a drawn start.
    """
    fitting = ...
    independent = ...
class PairProblem:
    """
    A slide problem with one start and one goal that make a valid pair.
    """
    def __init__(self, problem: graspless._core.slide.Problem, options: graspless._core.slide.Options, draw: PairDraw, seed: typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Draws the pair; the same seed gives the same.
        """
    def __repr__(self) -> str:
        ...
    def run(self, peer: Peer, budget: graspless._core.planning.Budget) -> tuple[graspless._core.slide.Plan, float]:
        """
        (plan, seconds): what the peer found, with the pair's motions before and after, and how long the peer alone took [s].
        """
    @property
    def goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (arm dof,) [rad].
        """
    @property
    def has_pair(self) -> bool:
        """
        Whether a pair was found.
        """
    @property
    def start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (arm dof,) [rad].
        """
def libraries() -> dict[str, str]:
    """
    What this was built with, by name.
    """
