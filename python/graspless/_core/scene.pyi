"""
A robot among bodies.
"""
from __future__ import annotations
import collections.abc
import graspless._core.collision
import graspless._core.geometry
import graspless._core.robot
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Scene']
class Scene:
    """
    A robot among bodies. Not for several threads at once: copy it.
    
    Bodies are named by their index in the world or their name; links with shapes are bodies.
    """
    def __copy__(self) -> Scene:
        """
        A copy that shares the shapes.
        """
    def __init__(self, robot: graspless._core.robot.Robot) -> None:
        """
        A scene with this robot alone.
        """
    def __repr__(self) -> str:
        ...
    def add_object(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape]) -> int:
        """
        Adds a body that moves and that no link may touch; returns its index in the world.
        """
    def add_obstacle(self, name: str, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape], X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., touches_base: bool = True) -> int:
        """
        Adds a body fixed in the world that no link may touch; returns its index in the world.
        
        touches_base: the root link, and links rigid with it, may touch it.
        """
    def attach(self, body: str | typing.SupportsInt | typing.SupportsIndex, link: str | typing.SupportsInt | typing.SupportsIndex, X_LO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], touching: collections.abc.Sequence[str | typing.SupportsInt | typing.SupportsIndex]) -> None:
        """
        The object follows a link from now on, at X_LO, (4, 4), in its frame; links in touching may touch it.
        """
    def collision(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> tuple[str, str] | None:
        """
        The first touching pair at q, (dof,), by name, or None. Limits are not looked at.
        """
    def detach(self, body: str | typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        The object stays where it is from now on.
        """
    @typing.overload
    def is_free(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> bool:
        """
        Whether the robot at q, (dof,), is within its limits and nothing touches.
        """
    @typing.overload
    def is_free(self, q1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q2: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01) -> bool:
        """
        Whether the straight motion from q1 to q2, (dof,), is free, at joint steps of resolution [rad or m].
        """
    def link_body(self, link: str | typing.SupportsInt | typing.SupportsIndex) -> int:
        """
        Index in the world of a link's body; -1 for a link without shapes.
        """
    def move_object(self, body: str | typing.SupportsInt | typing.SupportsIndex, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Moves an object to X_WO, (4, 4), in the world; detaches it.
        """
    @property
    def poses(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (num_frames, 4, 4) link poses at the configuration last asked for.
        """
    @property
    def robot(self) -> graspless._core.robot.Robot:
        """
        The robot.
        """
    @property
    def world(self) -> graspless._core.collision.World:
        """
        The world behind the scene.
        """
