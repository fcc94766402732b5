"""
Bodies at poses, and which of them touch.
"""
from __future__ import annotations
import collections.abc
import graspless._core.geometry
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Obstacle', 'World']
class Obstacle:
    """
    Something that stands in the way.
    """
    def __init__(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape], X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        shapes: PlacedShapes. X_WB: (4, 4) pose in the world.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @property
    def name(self) -> str:
        """
        What errors call it.
        """
    @property
    def shapes(self) -> list[graspless._core.geometry.PlacedShape]:
        """
        PlacedShapes in its frame B.
        """
class World:
    """
    Bodies at poses, and which pairs of them must not touch. Knows no robot.
    
    Bodies are named by their index or their name. Not for several threads at once: copy it.
    """
    def __copy__(self) -> World:
        """
        A copy that shares the shapes.
        """
    def __init__(self) -> None:
        """
        A world without bodies.
        """
    def __repr__(self) -> str:
        ...
    def add_body(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape]) -> int:
        """
        Adds a body of one or more PlacedShape, at the identity; returns its index.
        
        Raises ValueError on a bad shape or a name already taken.
        """
    def add_pair(self, a: str | typing.SupportsInt | typing.SupportsIndex, b: str | typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Tests bodies a and b against each other from now on.
        """
    def all_collisions(self) -> list[tuple[int, int]]:
        """
        Every touching pair.
        """
    def allow_contact(self, a: str | typing.SupportsInt | typing.SupportsIndex, b: str | typing.SupportsInt | typing.SupportsIndex, normal_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], depth: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Lets a press up to depth [m] into b along -normal_W, (3,); depth 0 ends the allowance.
        
        Raises ValueError on a negative depth, a pair not tested or a zero normal.
        """
    def body(self, name: str) -> int:
        """
        Index of a body; ValueError lists the bodies.
        """
    def collides(self) -> bool:
        """
        Whether any tested pair touches.
        """
    def distance_bounds(self) -> list[float]:
        """
        For each tested pair, in the order of pairs, a lower bound on its distance [m].
        """
    def first_collision(self) -> tuple[int, int] | None:
        """
        The first touching pair found, or None.
        """
    def name(self, body: str | typing.SupportsInt | typing.SupportsIndex) -> str:
        """
        Name of a body.
        """
    def pose(self, body: str | typing.SupportsInt | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of a body in the world.
        """
    def remove_pair(self, a: str | typing.SupportsInt | typing.SupportsIndex, b: str | typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        No longer tests bodies a and b against each other.
        """
    def set_pose(self, body: str | typing.SupportsInt | typing.SupportsIndex, X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Moves a body to the pose X_WB, (4, 4), in the world.
        """
    @property
    def num_bodies(self) -> int:
        """
        How many bodies there are.
        """
    @property
    def num_checks(self) -> int:
        """
        Configurations tested so far.
        """
    @property
    def pairs(self) -> list[tuple[int, int]]:
        """
        Pairs of body indices that are tested.
        """
