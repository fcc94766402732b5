"""
Shapes, supports, outlines, and the loops through the holes of a cloud. Lengths in metres.
"""
from __future__ import annotations
import collections.abc
import graspless._named
import numpy
import numpy.typing
import os
import typing
__all__: list[str] = ['Band', 'BettiCurve', 'Box', 'Capsule', 'ClaspTarget', 'Complex', 'Convex', 'Edge', 'Filtration', 'HeightMap', 'Loop', 'LoopOptions', 'LoopStatus', 'Loops', 'Mesh', 'PlacedShape', 'Plateau', 'Polygon', 'PreparedLoop', 'RayImage', 'Sphere', 'VirtualLinking', 'clasp_targets', 'columns', 'downsample', 'gauss_linking', 'linking_number', 'outline', 'quaternions', 'rays_from_viewpoints', 'read_mesh', 'rotations', 'sample_grid', 'sample_surface', 'seen_heights', 'shortest_loops', 'spacing', 'virtual_linking', 'virtual_linking_gradient', 'visible_points']
class Box:
    """
    A box centred at its frame's origin, sides along the axes.
    """
    def __init__(self, size: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        size: (3,) side lengths [m], each in [1e-6, 10000].
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
        radius: radius [m], in [1e-6, 10000].
        """
    def __repr__(self) -> str:
        ...
    @property
    def radius(self) -> float:
        """
        Radius [m].
        """
class Capsule:
    """
    All points within radius of the segment from (0, 0, -length/2) to (0, 0, length/2).
    """
    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        radius, length: [m], each in [1e-6, 10000]. length: of the segment.
        """
    def __repr__(self) -> str:
        ...
    @property
    def length(self) -> float:
        """
        Length of the segment, without the two half spheres [m].
        """
    @property
    def radius(self) -> float:
        """
        Radius [m].
        """
class Convex:
    """
    The convex hull of a set of points.
    """
    def __init__(self, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        vertices: (N, 3) points that span a volume [m].
        """
    def __repr__(self) -> str:
        ...
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) points [m].
        """
class Mesh:
    """
    A triangle surface. One that is closed bounds a solid: what is wholly inside touches it. Of any other, only the surface collides.
    """
    def __init__(self, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], triangles: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        vertices: (N, 3) [m]. triangles: (M, 3) vertex indices.
        """
    def __repr__(self) -> str:
        ...
    @property
    def triangles(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, 3]"]:
        """
        (M, 3) vertex indices of the triangles.
        """
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) vertices [m].
        """
class PlacedShape:
    """
    A shape fixed in the frame of a body B.
    """
    def __init__(self, shape: Box | Sphere | Capsule | Convex | Mesh, X_BG: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        shape: Box, Sphere, Capsule, Convex or Mesh. X_BG: (4, 4) pose of its frame G in B.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_BG(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the shape's frame G in B.
        """
    @property
    def shape(self) -> Box | Sphere | Capsule | Convex | Mesh:
        """
        Box, Sphere, Capsule, Convex or Mesh.
        """
class Polygon:
    """
    A simple polygon in the plane with counter-clockwise vertices, convex or not.
    """
    def __init__(self, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], what: str = 'polygon') -> None:
        """
        vertices: (N, 2) [m]; a clockwise list is reversed. what: name used in error messages.
        
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
        True if the point p, (2,) [m], lies inside.
        """
    def convex_parts(self) -> list[Polygon]:
        """
        Convex polygons that cover this one without overlap.
        """
    def depth(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
        """
        Signed distance from p, (2,), to the boundary [m]: positive inside, negative outside.
        """
    def edge(self, index: typing.SupportsInt | typing.SupportsIndex) -> Edge:
        """
        Edge from vertex `index` to the next.
        """
    def nearest_edge(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Edge:
        """
        Edge nearest to p, (2,) [m].
        """
    @property
    def area(self) -> float:
        """
        Area [m^2], positive.
        """
    @property
    def centroid(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) centroid of the area [m].
        """
    @property
    def is_convex(self) -> bool:
        """
        True if no corner is reflex.
        """
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (N, 2) vertices, counter-clockwise [m].
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
        (2,) first end point [m].
        """
    @property
    def b(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) second end point [m].
        """
    @property
    def index(self) -> int:
        """
        Index of its first vertex.
        """
    @property
    def inward(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) unit normal pointing inside.
        """
class Band:
    """
    The points of a polygon near its edges: the polygon minus its contraction by `width`.
    
    P_g of Hang, Morgan, Dollar 2019, Section IV-B.
    """
    def __init__(self, polygon: Polygon, width: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        width: width of the band [m], in [1e-6, 10000].
        """
    def __repr__(self) -> str:
        ...
    def contains(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> bool:
        """
        True if the point p, (2,) [m], lies in the band.
        """
    def sample(self, seed: typing.SupportsInt | typing.SupportsIndex, margin: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"] | None:
        """
        Draws a random point of the band, uniform by area if `exact`.
        
        Parameters
        ----------
        seed : int
            The same seed gives the same point.
        margin : float, optional
            Smallest distance to the boundary of the polygon [m].
        
        Returns
        -------
        (2,) array or None
            [m]. None after 1000 failed draws, as when the margin leaves no room.
        """
    @property
    def core(self) -> list[Polygon]:
        """
        Pieces of the contracted polygon; empty if nothing is left.
        """
    @property
    def exact(self) -> bool:
        """
        False if the contraction failed verification. Then `core` is empty, and `contains`
        and `sample` use the distance to the boundary.
        """
    @property
    def polygon(self) -> Polygon:
        """
        The polygon.
        """
    @property
    def width(self) -> float:
        """
        Width of the band [m].
        """
class Complex:
    """
    Simplicial complex K_d of a cloud: the edges and triangles of its Delaunay triangulation
    with all edges shorter than d (Stork, Pokorny, Kragic 2013, Section IV-A).
    """
    def __repr__(self) -> str:
        ...
    @property
    def edges(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, 2]"]:
        """
        (E, 2) point indices, the smaller first; sorted.
        """
    @property
    def max_edge_length(self) -> float:
        """
        d [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) vertices [m].
        """
    @property
    def triangles(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, 3]"]:
        """
        (T, 3) point indices, ascending; sorted. Includes triangles inside the object.
        """
class BettiCurve:
    """
    Number of independent loops of K_d as a step function of d.
    
    It is loops[i] for d in (max_edge_length[i], max_edge_length[i + 1]], and 0 below.
    """
    def __repr__(self) -> str:
        ...
    @property
    def loops(self) -> list[int]:
        """
        Number of loops above each value.
        """
    @property
    def max_edge_length(self) -> list[float]:
        """
        Values of d where the number changes, ascending [m].
        """
class Plateau:
    """
    Interval of d over which the set of lasting loops does not change.
    """
    def __repr__(self) -> str:
        ...
    @property
    def loops(self) -> int:
        """
        Number of lasting loops; 0 if no plateau was selected.
        """
    @property
    def lower(self) -> float:
        """
        Lower bound of d [m], excluded.
        """
    @property
    def ratio(self) -> float:
        """
        upper / lower. A large ratio means reliable loops.
        """
    @property
    def upper(self) -> float:
        """
        Upper bound of d [m], included.
        """
class Filtration:
    """
    The Delaunay triangulation of a cloud with its simplices ordered by longest edge.
    
    It represents K_d for every d.
    """
    def __init__(self, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], what: str = 'points') -> None:
        """
        points: (N, 3) [m]; equal points count once. what: name used in error messages.
        
        Raises ValueError if there are fewer than 4 distinct points, if one is not finite, or if
        all lie in a plane.
        """
    def __repr__(self) -> str:
        ...
    def betti(self) -> BettiCurve:
        """
        Number of independent loops for every d (first Betti number).
        """
    def complex(self, max_edge_length: typing.SupportsFloat | typing.SupportsIndex) -> Complex:
        """
        Returns K_d for d = max_edge_length [m].
        
        Raises ValueError if it is negative.
        """
    def persistence(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        Persistence pairs of H_1 over Z_2: (K, 2) birth and death [m].
        
        Largest ratio death / birth first. Omits pairs that die at birth.
        """
    def plateaus(self, lasting_ratio: typing.SupportsFloat | typing.SupportsIndex = 1.12) -> list[Plateau]:
        """
        Plateaus of the Betti curve with at least one lasting loop, largest ratio first.
        
        lasting_ratio: smallest ratio death / birth of a lasting loop; 1 counts every loop.
        
        Raises ValueError if it is less than 1.
        """
    def span(self, cycle: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], max_edge_length: typing.SupportsFloat | typing.SupportsIndex) -> tuple[float, float]:
        """
        Birth and death of the homology class of a closed walk in K_d.
        
        Parameters
        ----------
        cycle : list of int
            Point indices of the walk, without repeating the first.
        max_edge_length : float
            d of K_d [m].
        
        Returns
        -------
        (float, float)
            Birth and death [m]. Equal if the walk is filled in K_d.
        
        Raises
        ------
        ValueError
            If a step of the walk is not an edge of K_d, or if it has fewer than 3.
        """
    @property
    def num_vertices(self) -> int:
        """
        Number of distinct points.
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) input points [m].
        """
class Loop:
    """
    A closed polyline on a cloud: an element of a shortest basis of H_1(K_d).
    """
    def __repr__(self) -> str:
        ...
    @property
    def birth(self) -> float:
        """
        The loop exists in K_d for d above this value [m].
        """
    @property
    def death(self) -> float:
        """
        The loop is filled in K_d for d above this value [m]. A body wider than this does not
        pass the hole.
        """
    @property
    def gap(self) -> float:
        """
        Longest step of the loop through open space [m]; 0 if it runs along the surface throughout. The object may come free there.
        """
    @property
    def jump(self) -> float:
        """
        Length of the longest step around the hole, relative to the next one. Evenly spread
        points have about 1. Large values mean that the object is open there, or was not seen.
        """
    @property
    def length(self) -> float:
        """
        Length of the closed polyline [m].
        """
    @property
    def max_edge_length(self) -> float:
        """
        d of the complex in which it is shortest [m]: the loop's own scale.
        """
    @property
    def openness(self) -> float:
        """
        Share of the directions in which a ray from the middle of the hole leaves the object, on
        the side where fewer do. The inside of a solid is closed on at least one side.
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (K, 3) corners in order [m]; the last connects to the first.
        """
    @property
    def reason(self) -> str:
        """
        Reason why it is uncertain or discarded; empty for a hole that was found.
        """
    @property
    def seen_through(self) -> float:
        """
        Area across the rays that passed through it [m^2], for the camera that saw most of it. Rays
        that end on the object prove nothing. 0 without rays.
        """
    @property
    def thickness(self) -> float:
        """
        Thickness of the handle that the loop runs along, at its thinnest cross-section [m];
        0 if unknown.
        """
    @property
    def unseen(self) -> float:
        """
        Share of its length that lies where no ray reached the object, in [0, 1]. 0 without rays.
        """
    @property
    def vertices(self) -> list[int]:
        """
        Indices of the corners in the input cloud.
        """
    @property
    def width(self) -> float:
        """
        Width of the same handle in its narrowest direction [m]; 0 if unknown. Two jaws must
        open farther.
        """
class RayImage:
    """
    Rays of a camera around an object. They show where the object is, and where it is open.
    """
    @staticmethod
    def from_depth(depth: typing.Annotated[numpy.typing.ArrayLike, numpy.float32], is_object: typing.Annotated[numpy.typing.ArrayLike, numpy.bool], K: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> RayImage:
        """
        Makes rays from a depth image.
        
        depth: (H, W) [m]; 0 or not finite: unknown. is_object: (H, W), true for the pixels of the object. K: (3, 3) camera matrix [pixels]. X_OC: (4, 4) pose of the optical frame in the frame of the object's points, z forward.
        """
    def __init__(self, ends: typing.Annotated[numpy.typing.ArrayLike, numpy.float32], K: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], clear: typing.Annotated[numpy.typing.ArrayLike, numpy.float32] | None = None) -> None:
        """
        ends: (H, W) depth at which the ray of each pixel ends, along the optical axis [m]. Negative: the ray ends on the object, at minus this depth. Infinite: it passes the object. 0: unknown. K: (3, 3) camera matrix of this image [pixels]. X_OC: (4, 4) pose of the optical frame in the frame of the object's points, z forward. clear: (H, W) depth up to which a ray of unknown end met nothing [m]; 0: nobody knows.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def K(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (3, 3) camera matrix [pixels].
        """
    @property
    def X_OC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the optical frame in the frame of the object's points.
        """
    @property
    def clear(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float32], "[m, n]"]:
        """
        (H, W) depths up to which rays of unknown end met nothing [m], float32; 0: nobody knows.
        """
    @property
    def ends(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float32], "[m, n]"]:
        """
        (H, W) depths of the ends [m], float32. Negative: on the object; infinite: passes; 0: unknown.
        """
class HeightMap:
    """
    Heights over the plane z = 0 of a frame O, one for each square cell: the solid between them and the plane.
    
    A vessel that is open at the top can be described so; an overhang is filled.
    """
    def __init__(self, corner: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], cell: typing.SupportsFloat | typing.SupportsIndex, heights: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], undersides: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"] | None = None) -> None:
        """
        corner: (2,) least x and y of the first cell [m]. cell: side of a cell [m]. heights: (nx, ny) [m], the first index along x; 0: nothing is there. undersides: (nx, ny) lowest height at which each cell was seen [m]; None: the cells are known to be solid down to the plane.
        
        Raises ValueError unless there are 1 to 10^6 cells of at least 1e-4 m, none with a negative height and one with a height of at least 1e-6 m.
        """
    def __repr__(self) -> str:
        ...
    def at(self, p_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> float:
        """
        Returns the height at a point, (2,) in O; 0 beyond the cells [m].
        """
    @property
    def cell(self) -> float:
        """
        Side of a cell [m].
        """
    @property
    def corner(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) least x and y of the first cell [m].
        """
    @property
    def heights(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (nx, ny) heights [m].
        """
    @property
    def undersides(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"] | None:
        """
        (nx, ny) lowest heights at which the cells were seen [m]; None: they are known to be solid.
        """
class LoopOptions:
    """
    Options of shortest_loops().
    """
    def __init__(self, *, max_edge_length: typing.SupportsFloat | typing.SupportsIndex = 0.0, min_ratio: typing.SupportsFloat | typing.SupportsIndex = 2.25, max_points: typing.SupportsInt | typing.SupportsIndex = 5000, polish: bool = False, drop_meridians: bool = True, threads: typing.SupportsInt | typing.SupportsIndex = 1, all_sides: bool = False) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def all_sides(self) -> bool:
        """
        The points are of all sides of the object: no loop is the edge of what a camera saw.
        No effect with rays.
        """
    @all_sides.setter
    def all_sides(self, arg0: bool) -> None:
        ...
    @property
    def drop_meridians(self) -> bool:
        """
        Discard loops that run around a thick handle instead of along it.
        """
    @drop_meridians.setter
    def drop_meridians(self, arg0: bool) -> None:
        ...
    @property
    def max_edge_length(self) -> float:
        """
        d of K_d [m], in [0, 10000]. 0: each hole has its own.
        """
    @max_edge_length.setter
    def max_edge_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_points(self) -> int:
        """
        Largest number of points without downsampling, in [100, 10^6]. A larger cloud is
        downsampled to about half of this.
        """
    @max_points.setter
    def max_points(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def min_ratio(self) -> float:
        """
        Least width of a hole that counts as found, relative to the gaps between the points
        near it: its death over the median birth of the gaps; above 1.
        """
    @min_ratio.setter
    def min_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def polish(self) -> bool:
        """
        Shorten the loops of a downsampled cloud on all its points, at most 10^6.
        """
    @polish.setter
    def polish(self, arg0: bool) -> None:
        ...
    @property
    def threads(self) -> int:
        """
        Number of threads that share the polishing, in [1, 256]. Loops do not depend on it.
        """
    @threads.setter
    def threads(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class LoopStatus(graspless._named.Named):
    """
    Outcome of shortest_loops().
    """
    found = ...
    no_reliable_hole = ...
class Loops:
    """
    Result of shortest_loops().
    """
    def __repr__(self) -> str:
        ...
    @property
    def betti(self) -> BettiCurve:
        """
        Betti curve of the same points.
        """
    @property
    def complex(self) -> Complex:
        """
        K_d of the cloud, after downsampling, for most of the holes.
        """
    @property
    def found(self) -> list[Loop]:
        """
        Loops of the holes, shortest first.
        """
    @property
    def has_rays(self) -> bool:
        """
        True if rays of cameras decided which loops are holes.
        """
    @property
    def meridians(self) -> list[Loop]:
        """
        Discarded loops: they run around a thick handle, not along it.
        """
    @property
    def noise(self) -> int:
        """
        Number of classes that do not live long enough to be listed.
        """
    @property
    def plateau(self) -> Plateau:
        """
        Values of d at which the holes of `complex` exist; zero if max_edge_length was
        given.
        """
    @property
    def reason(self) -> str:
        """
        Explanation of the status in one sentence.
        """
    @property
    def status(self) -> LoopStatus:
        """
        Outcome of the search.
        """
    @property
    def surface(self) -> Complex:
        """
        Part of K_d at the cloud's own resolution: edges no longer than twice the local spacing, and their triangles.
        """
    @property
    def uncertain(self) -> list[Loop]:
        """
        Loops that may be holes, each with a reason; shortest first.
        """
    @property
    def warnings(self) -> list[str]:
        """
        Warnings about the cloud and the result.
        """
class ClaspTarget:
    """
    A point of a loop where a hand may clasp, with its tangent.
    """
    def __init__(self, *, point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., tangent: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def point(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) point on the loop [m].
        """
    @point.setter
    def point(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def tangent(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit vector along the loop.
        """
    @tangent.setter
    def tangent(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class VirtualLinking:
    """
    Virtual linking, eq. (2) of Stork 2013, with its gradient.
    """
    def __repr__(self) -> str:
        ...
    @property
    def gradient(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (K, 3) gradient with respect to the corners of the curve [1/m].
        """
    @property
    def linking_number(self) -> int:
        """
        Linking number of the loop and the curve closed by its chord.
        """
    @property
    def value(self) -> float:
        """
        VLk of eq. (2), signed.
        """
class PreparedLoop:
    """
    A closed loop preprocessed for many linking queries.
    """
    def __init__(self, loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        loop: a Loop, or its corners (K, 3) [m].
        
        Raises ValueError if it has fewer than 3 corners or is not finite.
        """
    def __repr__(self) -> str:
        ...
    def gauss_linking(self, curves: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64]], are_closed: bool = True) -> list[float]:
        """
        Gauss linking integral of the loop with each curve, (K, 3) [m].
        """
    def linking_numbers(self, curves: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64]]) -> list[int]:
        """
        Linking number of the loop with each closed curve, (K, 3) [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (K, 3) corners [m].
        """
def clasp_targets(loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], count: typing.SupportsInt | typing.SupportsIndex) -> list[ClaspTarget]:
    """
    Places clasp targets on a loop at equal arc length (G_gamma of Stork 2013, Section IV-A).
    
    Parameters
    ----------
    loop : Loop or (K, 3) array
        Closed loop, or its corners [m].
    count : int
        Number of targets, 1 to 10^6.
    
    Returns
    -------
    list of ClaspTarget
        In the frame of the loop. The first target is at the first corner.
    
    Raises
    ------
    ValueError
        If `count` is out of range, or the loop has fewer than 3 corners or no length.
    """
def columns(map: HeightMap, step: typing.SupportsFloat | typing.SupportsIndex) -> list[PlacedShape]:
    """
    Returns boxes that fill a map, as PlacedShapes in O.
    
    Cells of nearly the same height share one: each box is as high as the next multiple of `step` [m], but not higher than the highest cell.
    
    Raises ValueError unless `step` is at least 1e-6 m.
    """
def downsample(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], cell: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.int32]:
    """
    Downsamples a cloud to one point per cubic cell: the point nearest to the cell's mean.
    
    Parameters
    ----------
    points : (N, 3) array
        [m].
    cell : float
        Side of a cell [m], in (0, 10000].
    
    Returns
    -------
    array of int
        Indices of the points kept, ascending.
    
    Raises
    ------
    ValueError
        If `cell` is out of range or a point is not finite.
    """
def gauss_linking(a: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], b: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, a_is_closed: bool = True, b_is_closed: bool = True) -> float:
    """
    Gauss linking integral of two polylines, eq. (1) of Stork, Pokorny, Kragic 2013.
    
    Parameters
    ----------
    a, b : Loop or (K, 3) array
        Corners of the polylines [m], in one frame. A closed one does not repeat its first corner.
    a_is_closed, b_is_closed : bool, optional
        True if the last corner connects to the first.
    
    Returns
    -------
    float
        An integer up to rounding if both are closed. Pairs of segments that touch or are collinear
        contribute 0, so the value is finite.
    
    Raises
    ------
    ValueError
        If a polyline has fewer than 2 corners (3 if closed) or is not finite.
    """
def linking_number(a: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], b: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> int:
    """
    Linking number of two closed polylines, by signed crossings.
    
    Parameters
    ----------
    a, b : Loop or (K, 3) array
        Corners of the closed polylines [m], in one frame, without repeating the first.
    
    Returns
    -------
    int
        Eq. (1) of Stork, Pokorny, Kragic 2013 as an exact integer.
    
    Raises
    ------
    ValueError
        If a polyline has fewer than 3 corners or is not finite.
    """
def outline(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], what: str = 'points') -> Polygon:
    """
    Outer boundary of planar points: their tightest alpha shape in one simple piece.
    
    Parameters
    ----------
    points : (N, 2) array
        [m].
    what : str, optional
        Name used in error messages.
    
    Returns
    -------
    Polygon
        Simplified by less than the point spacing. Holes are filled.
    
    Raises
    ------
    ValueError
        If there are fewer than three points, if one is not finite, if all lie on a line, or if they
        form several pieces.
    """
def quaternions(X: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
    """
    Unit quaternions (N, 4), w x y z, of rotations or poses (N, 4, 4). The first component that is not 0 is positive.
    """
def rays_from_viewpoints(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], viewpoints: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> list[RayImage]:
    """
    Makes rays of cameras of which only the positions are known.
    
    A ray ends on the object if a point is within two spacings of it in the image, and passes it
    otherwise. The cloud must have all that the cameras saw of the object, and nothing else. Depth
    images are better: a patch that a camera did not see, such as dark material, looks open here.
    
    Parameters
    ----------
    points : (N, 3) array
        Points of the object [m], in any frame.
    viewpoints : (K, 3) array
        Positions of the cameras in the same frame [m].
    
    Returns
    -------
    list of RayImage
        One for each viewpoint, for `shortest_loops`.
    
    Raises
    ------
    ValueError
        If there are fewer than 20 points, one is not finite, or a viewpoint is among the points: they
        must lie within 60 degrees of the direction to their middle.
    """
def read_mesh(path: os.PathLike[str] | str, scale: typing.SupportsFloat | typing.SupportsIndex | typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = 1.0) -> Mesh:
    """
    Reads a triangle mesh. Polygons are triangulated.
    
    Parameters
    ----------
    path : str or Path
        File of type .stl, .obj, .off or .ply; with the extra `robots` also .dae, .glb or .gltf.
    scale : float or (3,) array, optional
        Factor for all coordinates, or one per axis. Converts the unit of the file to metres.
    
    Returns
    -------
    Mesh
        Vertices in [m].
    
    Raises
    ------
    ValueError
        If the file is missing, unreadable or empty; names the path.
    """
def rotations(wxyz: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
    """
    Rotations (N, 4, 4) of quaternions (N, 4), w x y z, normalised first.
    """
def sample_grid(polygon: Polygon, spacing: typing.SupportsFloat | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
    """
    Points of a square grid inside a polygon.
    
    Parameters
    ----------
    polygon : Polygon
    spacing : float
        Distance between grid points [m], positive.
    
    Returns
    -------
    (N, 2) array
        [m]. If the grid misses the polygon: its first vertex.
    
    Raises
    ------
    ValueError
        If `spacing` is not positive or gives more than 10^7 points.
    """
def sample_surface(shapes: collections.abc.Sequence[PlacedShape], count: typing.SupportsInt | typing.SupportsIndex, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
    """
    Samples points evenly on the outer surface of a union of shapes (Yuksel 2015).
    
    Parameters
    ----------
    shapes : list of PlacedShape
        Shapes in the frame B of a body. Points inside another shape are omitted. A mesh has no inside.
    count : int
        Number of points, in [1, 10^7]. More than 100,000 are drawn by Poisson disc sampling, and are a
        little less even.
    seed : int, optional
        The same seed gives the same points.
    
    Returns
    -------
    (count, 3) array
        Points in B [m].
    
    Raises
    ------
    ValueError
        If `count` is out of range, a shape is invalid, or there is almost no outer surface.
    """
def seen_heights(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], rays: collections.abc.Sequence[RayImage], outline: Polygon, top: typing.SupportsFloat | typing.SupportsIndex, cell: typing.SupportsFloat | typing.SupportsIndex) -> HeightMap:
    """
    Returns the HeightMap of an object as cameras saw it.
    
    A cell is as high as its highest point. Where the cameras saw no point, the object is as high as it
    may be: up to the lowest of the rays that pass over the cell, one below the other, or up to the top.
    Nothing was seen of such a cell: its underside is its height.
    
    Parameters
    ----------
    points : array (N, 3)
        Points on the object, in O [m].
    rays : list of RayImage
        Rays of the cameras, in O.
    outline : Polygon
        Outline of the object in O [m]. Cells beyond its convex hull without points have the height 0.
    top : float
        Height of the object [m].
    cell : float
        Side of a cell [m].
    
    Raises
    ------
    ValueError
        If a point is not finite, or the map would have more than 1000 cells along a side, more than
        2e7 voxels of two cells' height below the top, or no height.
    """
@typing.overload
def shortest_loops(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], max_edge_length: typing.SupportsFloat | typing.SupportsIndex | None = None, *, min_ratio: typing.SupportsFloat | typing.SupportsIndex = 2.25, max_points: typing.SupportsInt | typing.SupportsIndex = 5000, polish: bool = False, drop_meridians: bool = True, threads: typing.SupportsInt | typing.SupportsIndex = 1, all_sides: bool = False, rays: collections.abc.Sequence[RayImage] = []) -> Loops:
    """
    Finds the shortest loops through the holes of the object that a cloud was taken from.
    
    They are shortest bases of H_1(K_d; Z_2) (Dey, Sun, Wang 2010; Stork, Pokorny, Kragic 2013,
    Section IV-A), where every hole has a d of its own.
    
    Parameters
    ----------
    points : (N, 3) array
        Points on the object's surface [m], in any frame.
    max_edge_length : float, optional
        d of K_d [m]. None: each hole has its own.
    min_ratio, max_points, polish, drop_meridians, threads, all_sides : optional
        See LoopOptions.
    rays : list of RayImage, optional
        Rays of the cameras that saw the points. A loop is then a hole if rays passed through it.
        Without them the distances between the points decide, which is right for points from all
        sides only: without `all_sides`, no loop is found if one camera could have seen nearly all
        points.
    
    Returns
    -------
    Loops
        In the frame of the points. Finding no loop is a status; see Loops.reason.
    
    Raises
    ------
    ValueError
        If there are fewer than 20 distinct points or more than 10^7 (10^6 with `polish`), if one is
        not finite, if all lie in a plane, or if an option is out of range.
    
    Examples
    --------
    >>> for loop in shortest_loops(points).found: print(loop.length, loop.points)
    """
@typing.overload
def shortest_loops(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], options: LoopOptions, rays: collections.abc.Sequence[RayImage] = []) -> Loops:
    """
    Same, with all options in a LoopOptions.
    """
def spacing(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
    """
    Median distance between nearest neighbours among points, (N, 3) [m]. Equal points count once.
    
    0 if no two points differ. Raises ValueError if a value is not finite.
    """
def virtual_linking(loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], curve: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> float:
    """
    Virtual linking of a closed loop and an open curve, eq. (2) of Stork, Pokorny, Kragic 2013.
    
    Parameters
    ----------
    loop : Loop or (K, 3) array
        Closed loop, or its corners [m].
    curve : (K, 3) array
        Corners of the open curve [m], in the frame of the loop.
    
    Returns
    -------
    float
        VLk, signed: 0 if the loop does not run through the closed curve, Lk if the ends meet.
    
    Raises
    ------
    ValueError
        If the loop has fewer than 3 corners, the curve fewer than 2, or one is not finite.
    """
def virtual_linking_gradient(loop: Loop | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], curve: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> VirtualLinking:
    """
    Virtual linking with its gradient with respect to the curve's corners; see virtual_linking.
    """
def visible_points(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], viewpoint: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.int32]:
    """
    Finds the points visible from a viewpoint (hidden point removal; Katz, Tal, Basri 2007).
    
    Parameters
    ----------
    points : (N, 3) array
        [m].
    viewpoint : (3,) array
        In the frame of the points [m]; must not be one of them.
    
    Returns
    -------
    array of int
        Indices of the visible points, ascending.
    
    Raises
    ------
    ValueError
        If a value is not finite or the viewpoint is one of the points.
    """
