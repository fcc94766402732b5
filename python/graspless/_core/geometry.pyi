"""
Shapes, supports, outlines, and the loops through the holes of a cloud. Lengths in metres.
"""
from __future__ import annotations
import collections.abc
import enum
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Band', 'BettiCurve', 'Box', 'Capsule', 'ClaspTarget', 'Complex', 'Convex', 'Edge', 'Filtration', 'Loop', 'LoopOptions', 'LoopStatus', 'Loops', 'Mesh', 'PlacedShape', 'Plateau', 'Polygon', 'PreparedLoop', 'Sphere', 'VirtualLinking', 'clasp_targets', 'gauss_linking', 'linking_number', 'outline', 'read_mesh', 'sample_grid', 'sample_surface', 'shortest_loops', 'spacing', 'thin', 'virtual_linking', 'virtual_linking_gradient', 'visible_points']
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
class Complex:
    """
    K_d of a cloud: the edges and triangles of its Delaunay triangulation whose edges are all shorter than d.
    """
    def __repr__(self) -> str:
        ...
    @property
    def edges(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, 2]"]:
        """
        (E, 2) indices of points, the smaller first; sorted.
        """
    @property
    def max_edge_length(self) -> float:
        """
        d [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) [m].
        """
    @property
    def triangles(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, 3]"]:
        """
        (T, 3) indices of points, ascending; sorted. Those inside the object too.
        """
class BettiCurve:
    """
    How many independent loops K_d has: a step function of d.
    
    loops[i] for d above max_edge_length[i] up to the next, that included.
    """
    def __repr__(self) -> str:
        ...
    @property
    def loops(self) -> list[int]:
        """
        How many there are.
        """
    @property
    def max_edge_length(self) -> list[float]:
        """
        Where the number changes, ascending [m].
        """
class Plateau:
    """
    A stretch of d over which the same loops live.
    """
    def __repr__(self) -> str:
        ...
    @property
    def loops(self) -> int:
        """
        How many; 0 where no plateau was chosen.
        """
    @property
    def lower(self) -> float:
        """
        The least d [m].
        """
    @property
    def ratio(self) -> float:
        """
        upper / lower: how sure the loops are.
        """
    @property
    def upper(self) -> float:
        """
        The greatest d [m].
        """
class Filtration:
    """
    The Delaunay triangulation of a cloud, its simplices in order of their longest edge: every K_d at once.
    """
    def __init__(self, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], what: str = 'points') -> None:
        """
        points: (N, 3) [m]; equal points count once. what: their name in errors.
        
        Raises ValueError when there are fewer than 4 distinct points, one is not finite, or all lie in a plane.
        """
    def __repr__(self) -> str:
        ...
    def betti(self) -> BettiCurve:
        """
        The whole Betti-1 curve.
        """
    def complex(self, max_edge_length: typing.SupportsFloat | typing.SupportsIndex) -> Complex:
        """
        K_d for d [m].
        """
    def persistence(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (K, 2) birth and death [m] of every class of H_1 over Z_2, longest ratio first.
        """
    def plateaus(self, lasting: typing.SupportsFloat | typing.SupportsIndex = 1.12) -> list[Plateau]:
        """
        Stretches of d with at least one lasting loop, widest ratio first.
        
        A loop lasts whose ratio death / birth is at least `lasting`; 1 counts all.
        """
    def span(self, cycle: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], max_edge_length: typing.SupportsFloat | typing.SupportsIndex) -> tuple[float, float]:
        """
        Birth and death [m] of the class in K_d of a closed walk: indices of points, the first not repeated.
        
        Equal where it is filled in K_d. Raises ValueError on a step that is no edge.
        """
    @property
    def num_vertices(self) -> int:
        """
        Distinct points.
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) as given [m].
        """
class Loop:
    """
    A closed polyline on a cloud: one of the shortest that tell its holes apart.
    """
    def __repr__(self) -> str:
        ...
    @property
    def birth(self) -> float:
        """
        The hole is there for d above this [m].
        """
    @property
    def death(self) -> float:
        """
        The hole is filled for d above this [m].
        """
    @property
    def length(self) -> float:
        """
        [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (K, 3) corners in order; the last is joined to the first [m].
        """
    @property
    def thickness(self) -> float:
        """
        Of what the loop runs along, at its thinnest place [m].
        """
    @property
    def vertices(self) -> list[int]:
        """
        The same, as indices of the cloud given.
        """
class LoopOptions:
    """
    How to look for loops.
    """
    def __init__(self, *, max_edge_length: typing.SupportsFloat | typing.SupportsIndex = 0.0, lowest_plateau: bool = False, lowest_ratio: typing.SupportsFloat | typing.SupportsIndex = 1.4, min_ratio: typing.SupportsFloat | typing.SupportsIndex = 1.2, max_points: typing.SupportsInt | typing.SupportsIndex = 5000, polish: bool = False, drop_meridians: bool = True) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def drop_meridians(self) -> bool:
        """
        Leave out loops that run around a thick handle instead of along it.
        """
    @drop_meridians.setter
    def drop_meridians(self, arg0: bool) -> None:
        ...
    @property
    def lowest_plateau(self) -> bool:
        """
        Instead, the lowest plateau with at least lowest_ratio: splits less sure holes off, and takes patches that the camera missed for holes.
        """
    @lowest_plateau.setter
    def lowest_plateau(self, arg0: bool) -> None:
        ...
    @property
    def lowest_ratio(self) -> float:
        """
        See lowest_plateau.
        """
    @lowest_ratio.setter
    def lowest_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_edge_length(self) -> float:
        """
        d [m]; 0 takes the widest plateau of the Betti curve.
        """
    @max_edge_length.setter
    def max_edge_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_points(self) -> int:
        """
        Clouds with more points are thinned to about half of this.
        """
    @max_points.setter
    def max_points(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def min_ratio(self) -> float:
        """
        Below this ratio of the plateau there is no reliable hole.
        """
    @min_ratio.setter
    def min_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def polish(self) -> bool:
        """
        After thinning: shorten the loops on the whole cloud.
        """
    @polish.setter
    def polish(self, arg0: bool) -> None:
        ...
class LoopStatus(enum.Enum):
    """
    How a search for loops ended.
    """
    found = ...
    no_reliable_hole = ...
class Loops:
    """
    The loops of a cloud, and what they were taken from.
    """
    def __repr__(self) -> str:
        ...
    @property
    def betti(self) -> BettiCurve:
        """
        The Betti curve of the same cloud.
        """
    @property
    def complex(self) -> Complex:
        """
        K_d, of the thinned cloud where it was thinned.
        """
    @property
    def loops(self) -> list[Loop]:
        """
        Shortest first.
        """
    @property
    def meridians(self) -> list[Loop]:
        """
        Left out: they run around a thick handle, not along it.
        """
    @property
    def plateau(self) -> Plateau:
        """
        The one chosen; zero where d was given.
        """
    @property
    def reason(self) -> str:
        """
        One sentence, for people.
        """
    @property
    def status(self) -> LoopStatus:
        """
        Whether loops were found.
        """
    @property
    def warnings(self) -> list[str]:
        """
        For people.
        """
class ClaspTarget:
    """
    A place on a loop where a hand may clasp.
    """
    def __init__(self, *, point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., tangent: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def point(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m].
        """
    @point.setter
    def point(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def tangent(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit, along the loop.
        """
    @tangent.setter
    def tangent(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class VirtualLinking:
    """
    Virtual linking with its derivative.
    """
    def __repr__(self) -> str:
        ...
    @property
    def gradient(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (K, 3): row i by corner i of the curve [1/m].
        """
    @property
    def linking_number(self) -> int:
        """
        Of the loop and the closed curve.
        """
    @property
    def value(self) -> float:
        """
        Eq. (2), signed.
        """
class PreparedLoop:
    """
    A closed loop prepared for many questions.
    """
    def __init__(self, loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        loop: a Loop, or its corners (K, 3) [m].
        """
    def __repr__(self) -> str:
        ...
    def gauss_linking(self, curves: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64]], are_closed: bool = True) -> list[float]:
        """
        The Gauss integral of the loop with each curve, (K, 3) [m].
        """
    def linking_numbers(self, curves: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64]]) -> list[int]:
        """
        The linking number of the loop with each closed curve, (K, 3) [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (K, 3) [m].
        """
def clasp_targets(loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], count: typing.SupportsInt | typing.SupportsIndex) -> list[ClaspTarget]:
    """
    `count` ClaspTargets at equal arc length of a Loop or of corners (K, 3), the first at the first corner.
    """
def gauss_linking(a: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], b: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, a_is_closed: bool = True, b_is_closed: bool = True) -> float:
    """
    The Gauss linking integral of two polylines, (K, 3) [m]; an integer where both are closed.
    
    Segments that touch or lie on one line count 0: the value is finite.
    """
def linking_number(a: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], b: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> int:
    """
    How often two closed polylines, (K, 3) [m], wind around one another: by signed crossings.
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
def sample_surface(shapes: collections.abc.Sequence[PlacedShape], count: typing.SupportsInt | typing.SupportsIndex, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
    """
    `count` points (N, 3) [m] spread evenly over the outer surface of the shapes' union.
    
    The same seed gives the same points.
    """
@typing.overload
def shortest_loops(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], max_edge_length: typing.SupportsFloat | typing.SupportsIndex | None = None, *, lowest_plateau: bool = False, lowest_ratio: typing.SupportsFloat | typing.SupportsIndex = 1.4, min_ratio: typing.SupportsFloat | typing.SupportsIndex = 1.2, max_points: typing.SupportsInt | typing.SupportsIndex = 5000, polish: bool = False, drop_meridians: bool = True) -> Loops:
    """
    The shortest loops through the holes of what a cloud was taken from: a shortest basis of H_1(K_d; Z_2).
    
    points: (N, 3) [m]. max_edge_length: d [m]; None takes the widest plateau of the Betti curve. The keywords are those of LoopOptions.
    
    Not found is a status, see Loops.reason. Raises ValueError on fewer than 20 distinct points, values that are not finite, points in a plane, or more than 10^7 points.
    
    >>> for loop in shortest_loops(points).loops: print(loop.length, loop.points)
    """
@typing.overload
def shortest_loops(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], options: LoopOptions) -> Loops:
    """
    The same with all options in one.
    """
def spacing(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
    """
    The median distance from a point to its nearest other point [m].
    """
def thin(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], cell: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.int32]:
    """
    Indices of one point (N, 3) a cubic cell of side `cell` [m]; ascending.
    """
def virtual_linking(loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], curve: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
    """
    Virtual linking (Stork, Pokorny, Kragic 2013, eq. 2) of a closed loop and an open curve, (K, 3) [m]; signed.
    """
def virtual_linking_gradient(loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], curve: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> VirtualLinking:
    """
    Virtual linking with its derivative by the corners.
    """
def visible_points(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], viewpoint: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.int32]:
    """
    Indices of the points (N, 3) that are seen from viewpoint, (3,) [m]; ascending.
    """
