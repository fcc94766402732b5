"""
Planners that ours are compared with.
"""
from __future__ import annotations
import collections.abc
import enum
import graspless._core.clasp
import graspless._core.planning
import graspless._core.slide
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Grasp', 'PairDraw', 'PairProblem', 'Peer', 'grasp_rrt', 'libraries']
class Grasp:
    """
    Result of the Grasp-RRT. False unless it found a grasp.
    """
    def __bool__(self) -> bool:
        """
        True if a grasp was found.
        """
    def __repr__(self) -> str:
        ...
    @property
    def approaches(self) -> int:
        """
        Number of approaches that were tried.
        """
    @property
    def contacts(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) in O [m].
        """
    @property
    def envelops(self) -> bool:
        """
        True if a finger curve is linked with a loop.
        """
    @property
    def grasps(self) -> int:
        """
        Number of approaches that closed on the object.
        """
    @property
    def linking(self) -> list[int]:
        """
        Linking number of each closed finger curve with the loop that it is most linked with.
        """
    @property
    def nodes(self) -> int:
        """
        Number of nodes of the tree.
        """
    @property
    def q(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) configuration with the hand closed [rad or m].
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
    Planners that the slide planner is compared with.
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
    Ways to draw the goal for a start that was drawn.
    """
    fitting = ...
    independent = ...
class PairProblem:
    """
    A slide problem with one start and one goal that make a valid pair.
    """
    def __init__(self, problem: graspless._core.slide.Problem, options: graspless._core.slide.Options, draw: PairDraw, seed: typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Draws the pair. The same seed gives the same pair.
        """
    def __repr__(self) -> str:
        ...
    def completed(self, path: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]]) -> graspless._core.slide.Plan:
        """
        Returns the plan whose slide is a path of the arm's joints from start to goal. `path`: list of (arm dof,) [rad].
        """
    def is_valid(self, arm: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> bool:
        """
        Returns True if the arm's joints keep the contact of the slide, and nothing collides.
        """
    def run(self, peer: Peer, budget: graspless._core.planning.Budget) -> tuple[graspless._core.slide.Plan, float]:
        """
        Plans with a peer.
        
        Returns (plan, seconds): the peer's path with the pair's motions before and after, and the time that the peer alone took [s].
        """
    @property
    def goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (arm dof,) [rad].
        """
    @property
    def has_pair(self) -> bool:
        """
        True if a pair was found.
        """
    @property
    def start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (arm dof,) [rad].
        """
def grasp_rrt(problem: graspless._core.clasp.Problem, budget: graspless._core.planning.Budget) -> Grasp:
    """
    Runs a plain Grasp-RRT (Vahrenkamp, Asfour and Dillmann 2012). It knows contacts, and no loops.
    """
def libraries() -> dict[str, str]:
    """
    Versions of the libraries and the compiler, by name.
    """
