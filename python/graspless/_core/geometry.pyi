"""
Shapes, supports and outlines. Lengths in metres.
"""
from __future__ import annotations
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Band', 'Box', 'Capsule', 'Convex', 'Edge', 'Mesh', 'PlacedShape', 'Polygon', 'Sphere', 'outline', 'read_mesh', 'sample_grid']
class Box:
    """
    A box centred at its frame's origin, sides along the axes.
    """
    def __init__(self, size: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        size: (3,) side lengths [m], positive.
        """
    def __repr__(self) -> str:
        ...
    @property
    def size(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) side lengths [m].
        """
class Sphere:
    """
    A sphere centred at its frame's origin.
    """
    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        radius: [m], positive.
        """
    def __repr__(self) -> str:
        ...
    @property
    def radius(self) -> float:
        """
        [m].
        """
class Capsule:
    """
    All points within radius of the segment from (0, 0, -length/2) to (0, 0, length/2).
    """
    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        radius, length: [m], positive.
        """
    def __repr__(self) -> str:
        ...
    @property
    def length(self) -> float:
        """
        Of the segment, without the two half spheres [m].
        """
    @property
    def radius(self) -> float:
        """
        [m].
        """
class Convex:
    """
    The convex hull of a set of points.
    """
    def __init__(self, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        vertices: (N, 3) points [m] that span a volume.
        """
    def __repr__(self) -> str:
        ...
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) [m].
        """
class Mesh:
    """
    A triangle surface. Only the surface collides: a body wholly inside does not touch it.
    """
    def __init__(self, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], triangles: typing.Annotated[numpy.typing.ArrayLike, numpy.int32]) -> None:
        """
        vertices: (N, 3) [m]. triangles: (M, 3) indices of vertices.
        """
    def __repr__(self) -> str:
        ...
    @property
    def triangles(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, 3]"]:
        """
        (M, 3) indices of vertices.
        """
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) [m].
        """
class PlacedShape:
    """
    A shape fixed in the frame of a body B.
    """
    def __init__(self, shape: Box | Sphere | Capsule | Convex | Mesh, X_BG: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        X_BG: (4, 4) pose of the shape's own frame G in the body.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_BG(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the shape's own frame G in the body.
        """
    @property
    def shape(self) -> Box | Sphere | Capsule | Convex | Mesh:
        """
        Box, Sphere, Capsule, Convex or Mesh.
        """
class Polygon:
    """
    A simple polygon in the plane, counter-clockwise, convex or not.
    """
    def __init__(self, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], what: str = 'polygon') -> None:
        """
        vertices: (N, 2) [m]; a clockwise list is reversed. what: its name in errors.
        
        Raises ValueError on fewer than three vertices, a value that is not finite, a repeated
        vertex, or a boundary that crosses or touches itself.
        """
    def __len__(self) -> int:
        """
        Number of vertices.
        """
    def __repr__(self) -> str:
        ...
    def contains(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> bool:
        """
        Whether the point p, (2,) [m], lies inside.
        """
    def convex_parts(self) -> list[Polygon]:
        """
        Convex polygons that cover this one without overlap.
        """
    def depth(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
        """
        Distance from p, (2,), to the boundary [m]; positive inside, negative outside.
        """
    def edge(self, index: typing.SupportsInt | typing.SupportsIndex) -> Edge:
        """
        The edge from vertex `index` to the next.
        """
    def nearest_edge(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Edge:
        """
        The edge nearest to p, (2,) [m].
        """
    @property
    def area(self) -> float:
        """
        [m^2], positive.
        """
    @property
    def centroid(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) centroid of the area [m].
        """
    @property
    def is_convex(self) -> bool:
        """
        Whether no corner is reflex.
        """
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (N, 2) [m], counter-clockwise.
        """
class Edge:
    """
    An edge of a polygon.
    """
    def __repr__(self) -> str:
        ...
    @property
    def a(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) first end [m].
        """
    @property
    def b(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) second end [m].
        """
    @property
    def index(self) -> int:
        """
        It leads from vertex `index` to the next.
        """
    @property
    def inward(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) unit normal that points inside.
        """
class Band:
    """
    The points of a polygon near its edges: what its contraction leaves out.
    """
    def __init__(self, polygon: Polygon, width: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        width: how far the band reaches from the edges [m], positive.
        """
    def __repr__(self) -> str:
        ...
    def contains(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> bool:
        """
        Whether the point p, (2,) [m], lies in the band.
        """
    def sample(self, seed: typing.SupportsInt | typing.SupportsIndex, margin: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"] | None:
        """
        A point of the band, (2,), at least margin [m] inside the boundary, or None when none was found.
        
        Uniform by area where exact; the same seed gives the same point.
        """
    @property
    def core(self) -> list[Polygon]:
        """
        The contracted polygon, in pieces; empty where nothing is left.
        """
    @property
    def exact(self) -> bool:
        """
        False where the contraction failed verification.
        """
    @property
    def polygon(self) -> Polygon:
        """
        The polygon it was made from.
        """
    @property
    def width(self) -> float:
        """
        [m].
        """
def outline(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], what: str = 'points') -> Polygon:
    """
    The outer boundary of planar points (N, 2) [m]: their tightest alpha shape in one simple piece.
    
    Holes are filled. Raises ValueError when the points are fewer than three, not finite or on a line.
    """
def read_mesh(path: str, scale: typing.SupportsFloat | typing.SupportsIndex | typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = 1.0) -> Mesh:
    """
    Reads a triangle mesh (.stl, .obj, .off, .ply); scale is one factor or one per axis.
    
    Raises ValueError that names the path when it is missing, unreadable or empty.
    """
def sample_grid(polygon: Polygon, spacing: typing.SupportsFloat | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
    """
    Points (N, 2) on a square grid of `spacing` [m] inside a polygon; never empty.
    """
