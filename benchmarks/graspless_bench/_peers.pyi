"""
What the planners are measured against.
"""
from __future__ import annotations
import enum
import graspless._core.clasp
import graspless._core.planning
import graspless._core.slide
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Grasp', 'GraspRrtOptions', 'PairDraw', 'PairProblem', 'Peer', 'grasp_rrt', 'libraries']
class GraspRrtOptions:
    """
    How the Grasp-RRT searches.
    """
    def __init__(self, *, max_step: typing.SupportsFloat | typing.SupportsIndex = 0.2, approach_probability: typing.SupportsFloat | typing.SupportsIndex = 0.1, friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, min_quality: typing.SupportsFloat | typing.SupportsIndex = 0.003) -> None:
        """
        Any field by keyword.
        """
    def __repr__(self) -> str:
        ...
    @property
    def approach_probability(self) -> float:
        """
        Share of the iterations that try to approach.
        """
    @approach_probability.setter
    def approach_probability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def friction(self) -> float:
        """
        Of the contacts.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_step(self) -> float:
        """
        Of an extension, of any joint [rad].
        """
    @max_step.setter
    def max_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_quality(self) -> float:
        """
        Of a grasp that is good enough.
        """
    @min_quality.setter
    def min_quality(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Grasp:
    """
    What the Grasp-RRT found. False unless it found a grasp.
    """
    def __bool__(self) -> bool:
        """
        Whether it found one.
        """
    def __repr__(self) -> str:
        ...
    @property
    def approaches(self) -> int:
        """
        Tried.
        """
    @property
    def contacts(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) in O [m].
        """
    @property
    def envelops(self) -> bool:
        """
        Some finger curve is linked with a loop.
        """
    @property
    def grasps(self) -> int:
        """
        Of these, closed on something.
        """
    @property
    def linking(self) -> list[int]:
        """
        Of every closed finger curve, with the loop that it is most linked with.
        """
    @property
    def nodes(self) -> int:
        """
        Of the tree.
        """
    @property
    def q(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) the hand closed [rad or m].
        """
    @property
    def quality(self) -> float:
        """
        Epsilon of the contacts.
        """
    @property
    def seconds(self) -> float:
        """
        Wall clock [s].
        """
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
def grasp_rrt(problem: graspless._core.clasp.Problem, options: GraspRrtOptions, budget: graspless._core.planning.Budget) -> Grasp:
    """
    A plain Grasp-RRT (Vahrenkamp, Asfour and Dillmann 2012): it knows contacts, and no loops.
    """
def libraries() -> dict[str, str]:
    """
    What this was built with, by name.
    """
