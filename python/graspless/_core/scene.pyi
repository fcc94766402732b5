"""
A robot among bodies.
"""
from __future__ import annotations
import collections.abc
import graspless._core.collision
import graspless._core.geometry
import graspless._core.robot
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Doubt', 'EdgeCertificate', 'Scene', 'Verdict', 'sample_contacts']
class Verdict(graspless._named.Named):
    """
    Reasons why an edge is not proven.
    """
    refuted = ...
    undecided = ...
class Doubt:
    """
    An edge of a plan that is not proven. str() is one sentence.
    """
    def __getstate__(self) -> tuple[str, int, float, Verdict, str, float, str]:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[str, typing.SupportsInt | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex, Verdict, str, typing.SupportsFloat | typing.SupportsIndex, str]) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def amount(self) -> float:
        """
        Refuted: depth of the collision, or how far the quantity is outside its band. Undecided: the distance that is proven for a pair, or how far the bounds reach out of the band.
        """
    @property
    def condition(self) -> str:
        """
        Pair of bodies that touches, or quantity that leaves its band.
        """
    @property
    def row(self) -> int:
        """
        The edge leads to this row from the one before; 0: from the last row of the segment before.
        """
    @property
    def segment(self) -> str:
        """
        Name of the segment.
        """
    @property
    def t(self) -> float:
        """
        Place on the edge: 0 at the row before, 1 at `row`.
        """
    @property
    def unit(self) -> str:
        """
        Unit of `amount`: m or rad.
        """
    @property
    def verdict(self) -> Verdict:
        """
        Refuted or undecided.
        """
class EdgeCertificate:
    """
    Result of a proof over the edges of a plan: straight motions in joint space from row to row. True if every edge is proven.
    """
    def __bool__(self) -> bool:
        """
        True if every edge is proven.
        """
    def __getstate__(self) -> tuple[int, list[Doubt]]:
        ...
    def __init__(self) -> None:
        """
        A certificate of no edges.
        """
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.SupportsInt | typing.SupportsIndex, collections.abc.Sequence[Doubt]]) -> None:
        ...
    @property
    def doubts(self) -> list[Doubt]:
        """
        Doubts in the order of the edges.
        """
    @property
    def num_certified(self) -> int:
        """
        Number of edges without a doubt.
        """
    @property
    def num_edges(self) -> int:
        """
        Number of edges.
        """
class Scene:
    """
    A robot among obstacles and objects. Not thread-safe: give each thread a copy.
    
    A body is given by its name or its index in the world. Links with shapes are bodies.
    """
    def __copy__(self) -> Scene:
        """
        Returns a copy that shares the shapes.
        """
    def __init__(self, robot: graspless._core.robot.Robot) -> None:
        """
        Creates a scene with this robot alone.
        """
    def __repr__(self) -> str:
        ...
    def add_object(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape]) -> int:
        """
        Adds a movable body that no link may touch. Returns its index in the world.
        
        It is tested against obstacles and other objects only where `world.add_pair` says so.
        """
    def add_obstacle(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape], X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., touches_base: bool = True) -> int:
        """
        Adds a fixed body that no link may touch. Returns its index in the world.
        
        X_WB: (4, 4) pose in the world. touches_base: True if the root link, and links rigid with it, may touch it.
        """
    def attach(self, body: str | typing.SupportsInt | typing.SupportsIndex, link: str | typing.SupportsInt | typing.SupportsIndex, X_LO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], touching: collections.abc.Sequence[str | typing.SupportsInt | typing.SupportsIndex]) -> None:
        """
        Lets an object move with a link, at the pose X_LO, (4, 4), in the link's frame. Links in touching may touch it meanwhile.
        """
    def collision(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> tuple[str, str] | None:
        """
        Returns the names of the first pair that touches at q, (dof,), or None. Joint limits are not checked.
        """
    def detach(self, body: str | typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Detaches an object from its link; it stays where it is.
        """
    @typing.overload
    def is_free(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> bool:
        """
        Returns True if q, (dof,) [rad or m], is within the joint limits and nothing touches.
        """
    @typing.overload
    def is_free(self, q1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q2: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01) -> bool:
        """
        Returns True if the straight motion from q1 to q2, (dof,) [rad or m], is free, checked at joint steps of resolution [rad or m].
        """
    def link_body(self, link: str | typing.SupportsInt | typing.SupportsIndex) -> int:
        """
        Returns the index in the world of a link's body; -1 for a link without shapes.
        """
    def move_object(self, body: str | typing.SupportsInt | typing.SupportsIndex, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Moves an object to the pose X_WO, (4, 4), in the world, and detaches it.
        """
    @property
    def poses(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (num_frames, 4, 4) link poses in the world at the configuration checked last.
        """
    @property
    def robot(self) -> graspless._core.robot.Robot:
        """
        Robot of the scene.
        """
    @property
    def world(self) -> graspless._core.collision.World:
        """
        World that holds the scene's bodies.
        """
def sample_contacts(robot: graspless._core.robot.Robot, samples: typing.SupportsInt | typing.SupportsIndex = 10000, seed: typing.SupportsInt | typing.SupportsIndex = 1, links: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = []) -> tuple[list[tuple[int, int]], list[tuple[int, int]]]:
    """
    Tests a robot's links against each other in random configurations within its limits.
    
    Returns two lists of pairs of link indices: those that touch in at least 95 % of the samples, and those for which no contact was found, neither in the samples nor, with more than three joints between the links, by minimizing their distance from twelve configurations. links: indices; only pairs with one of them are tested. Raises ValueError unless 0 < samples <= 10^6 and the links exist.
    """
