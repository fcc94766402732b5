"""
Bodies at poses, and tests whether they touch.
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
    Fixed body that a motion must avoid.
    """
    def __init__(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape], X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., padding: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        shapes: PlacedShapes. X_WB: (4, 4) pose in the world. padding: distance that motions
        keep from the shapes [m].
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @property
    def grown_shapes(self) -> list[graspless._core.geometry.PlacedShape]:
        """
        PlacedShapes that motions must not touch: `shapes`, grown by the padding.
        """
    @property
    def name(self) -> str:
        """
        Name in errors.
        """
    @property
    def padding(self) -> float:
        """
        Distance that motions keep [m].
        """
    @property
    def shapes(self) -> list[graspless._core.geometry.PlacedShape]:
        """
        PlacedShapes in its frame B.
        """
class World:
    """
    Bodies at poses, and the pairs of them that must not touch. Independent of robots.
    
    A body is given by its name or its index. Not thread-safe: give each thread a copy.
    """
    def __copy__(self) -> World:
        """
        Returns a copy that shares the shapes.
        """
    def __init__(self) -> None:
        """
        Creates a world without bodies.
        """
    def __repr__(self) -> str:
        ...
    def add_body(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape]) -> int:
        """
        Adds a body of one or more PlacedShapes at the identity pose. Returns its index.
        
        Raises ValueError on a bad shape or a name that is already taken.
        """
    def add_pair(self, a: str | typing.SupportsInt | typing.SupportsIndex, b: str | typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Tests bodies a and b against each other from now on.
        """
    def all_collisions(self) -> list[tuple[int, int]]:
        """
        Returns every touching pair.
        """
    def allow_contact(self, a: str | typing.SupportsInt | typing.SupportsIndex, b: str | typing.SupportsInt | typing.SupportsIndex, normal_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], depth: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Allows body a to press up to depth [m] into body b along -normal_W, (3,). A depth of 0 ends the allowance.
        
        Raises ValueError on a negative depth, a pair that is not tested, or a zero normal.
        """
    def body(self, name: str) -> int:
        """
        Returns the index of a body.
        
        Raises ValueError that lists the bodies.
        """
    def collides(self) -> bool:
        """
        Returns True if any tested pair touches.
        """
    def distance_bounds(self) -> list[float]:
        """
        Returns a lower bound on the distance of each tested pair, in the order of pairs [m].
        """
    def first_collision(self) -> tuple[int, int] | None:
        """
        Returns the first touching pair found, or None.
        """
    def name(self, body: str | typing.SupportsInt | typing.SupportsIndex) -> str:
        """
        Returns the name of a body.
        """
    def pose(self, body: str | typing.SupportsInt | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        Returns the pose of a body in the world, (4, 4).
        """
    def remove_pair(self, a: str | typing.SupportsInt | typing.SupportsIndex, b: str | typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Stops testing bodies a and b against each other.
        """
    def set_pose(self, body: str | typing.SupportsInt | typing.SupportsIndex, X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Moves a body to the pose X_WB, (4, 4), in the world.
        """
    @property
    def num_bodies(self) -> int:
        """
        Number of bodies.
        """
    @property
    def num_checks(self) -> int:
        """
        Number of configurations that collides() and first_collision() have tested so far.
        """
    @property
    def pairs(self) -> list[tuple[int, int]]:
        """
        Pairs of body indices that are tested.
        """
