"""
Depth images: tables and objects in them, and images of known scenes.
"""
from __future__ import annotations
import collections.abc
import graspless._core.geometry
import graspless._core.planning
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Body', 'Camera', 'EdgeLabel', 'Object', 'Options', 'Rendering', 'Scene', 'Status', 'Support', 'Unseen', 'View', 'cast_rays', 'perceive']
class Camera:
    """
    A pinhole camera without distortion. Its frame C has x right, y down and z forward.
    
    Whole numbers of pixels are centres of pixels.
    """
    @staticmethod
    def from_matrix(K: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], width: typing.SupportsInt | typing.SupportsIndex, height: typing.SupportsInt | typing.SupportsIndex) -> Camera:
        """
        Creates a camera from its matrix K, (3, 3) [pixels].
        
        Raises ValueError if K is not that of a pinhole camera of this size.
        """
    def __init__(self, width: typing.SupportsInt | typing.SupportsIndex = 640, height: typing.SupportsInt | typing.SupportsIndex = 480, angle: typing.SupportsFloat | typing.SupportsIndex = 1.0471975511965976) -> None:
        """
        width, height: size of the image [pixels], in [16, 20000]. angle: horizontal field of view [rad].
        
        Raises ValueError unless both fields of view lie in [5, 170] degrees.
        """
    def __repr__(self) -> str:
        ...
    @property
    def K(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (3, 3) camera matrix [pixels].
        """
    @property
    def height(self) -> int:
        """
        Number of rows.
        """
    @property
    def width(self) -> int:
        """
        Number of columns.
        """
class Body:
    """
    A body of a rendered scene: boxes, convex hulls and meshes.
    """
    def __init__(self, shapes: collections.abc.Sequence[graspless._core.geometry.PlacedShape], X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        shapes: PlacedShapes in the body's frame B. X_WB: (4, 4) pose in the world.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @property
    def shapes(self) -> list[graspless._core.geometry.PlacedShape]:
        """
        PlacedShapes in the body's frame B.
        """
class Rendering:
    """
    First hits of the rays through the centres of all pixels.
    """
    def __repr__(self) -> str:
        ...
    @property
    def cosine(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float32], "[m, n]"]:
        """
        (H, W) cosines of the angles between ray and surface normal, in [0, 1].
        """
    @property
    def depth(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float32], "[m, n]"]:
        """
        (H, W) depths along the optical axis [m]; 0 if a ray meets nothing.
        """
    @property
    def label(self) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[m, n]"]:
        """
        (H, W) indices of the bodies; -1 if a ray meets nothing.
        """
class Options:
    """
    Options of perceive().
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __copy__(self) -> Options:
        """
        Returns a copy.
        """
    def __deepcopy__(self, memo: typing.Any) -> Options:
        """
        Returns a copy.
        """
    def __init__(self, *, noise_constant: typing.SupportsFloat | typing.SupportsIndex = 0.001, noise_quadratic: typing.SupportsFloat | typing.SupportsIndex = 0.002, max_tilt: typing.SupportsFloat | typing.SupportsIndex = 0.6, min_support_area: typing.SupportsFloat | typing.SupportsIndex = 0.06, min_object_area: typing.SupportsFloat | typing.SupportsIndex = 0.0001, min_thickness: typing.SupportsFloat | typing.SupportsIndex = 0.002, max_height: typing.SupportsFloat | typing.SupportsIndex = 0.6, unseen_height: typing.SupportsFloat | typing.SupportsIndex = 0.15, max_pixels: typing.SupportsInt | typing.SupportsIndex = 500000, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def max_height(self) -> float:
        """
        Largest height above the support at which points belong to objects.
        
        Unit: m. Range: [0.01, 3]. Default: 0.6.
        """
    @max_height.setter
    def max_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_pixels(self) -> int:
        """
        Larger images are read at every second, third, ... pixel.
        
        Range: [10000, 2.5e+07]. Default: 500000.
        """
    @max_pixels.setter
    def max_pixels(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def max_tilt(self) -> float:
        """
        Largest angle between the normal of a support and the vertical.
        
        Unit: rad. Range: [0.01, 1]. Default: 0.6.
        """
    @max_tilt.setter
    def max_tilt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_object_area(self) -> float:
        """
        Least visible area of an object. What is smaller counts as noise.
        
        Unit: m^2. Range: [1e-06, 1]. Default: 0.0001.
        """
    @min_object_area.setter
    def min_object_area(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_support_area(self) -> float:
        """
        Least visible area of a support. Smaller level faces belong to objects.
        
        Unit: m^2. Range: [0.001, 100]. Default: 0.06.
        """
    @min_support_area.setter
    def min_support_area(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_thickness(self) -> float:
        """
        Least thickness of an object, even where the noise would allow less.
        
        Unit: m. Range: [0.0001, 0.1]. Default: 0.002.
        """
    @min_thickness.setter
    def min_thickness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def noise_constant(self) -> float:
        """
        Expected standard deviation of the depth z is noise_constant + noise_quadratic z^2. The image tells by which factor it differs.
        
        Unit: m. Range: (0, 0.05]. Default: 0.001.
        """
    @noise_constant.setter
    def noise_constant(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def noise_quadratic(self) -> float:
        """
        Growth of the standard deviation with the squared depth.
        
        Unit: 1/m. Range: [0, 0.05]. Default: 0.002.
        """
    @noise_quadratic.setter
    def noise_quadratic(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def seed(self) -> int:
        """
        Seed of the search for planes.
        
        Range: [0, inf). Default: 1.
        """
    @seed.setter
    def seed(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def unseen_height(self) -> float:
        """
        Height of the obstacle over a patch of a support without depth, such as one under glass.
        
        Unit: m. Range: [0.001, 3]. Default: 0.15.
        """
    @unseen_height.setter
    def unseen_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Status(graspless._named.Named):
    """
    Outcome of perceive().
    """
    camera_below = ...
    found = ...
    no_depth = ...
    no_support = ...
    not_metres = ...
class EdgeLabel(graspless._named.Named):
    """
    Reason why a support ends at an edge.
    """
    image_border = ...
    occluded = ...
    real = ...
class View:
    """
    A depth image and the camera that took it.
    """
    def __init__(self, depth: typing.Annotated[numpy.typing.ArrayLike, numpy.float32], K: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        depth: (H, W) depths along the optical axis [m]; 0 or not finite: none. K: (3, 3) camera matrix [pixels]. X_WC: (4, 4) pose of the optical frame in the world, z forward.
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
    def X_WC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the optical frame in the world.
        """
    @property
    def depth(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float32], "[m, n]"]:
        """
        (H, W) depths [m], float32.
        """
class Support:
    """
    A level or tilted plane that objects lie on, with a label for each edge.
    
    Its frame S has z out of the plane.
    """
    def __init__(self, *, name: str, polygon: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], edges: collections.abc.Sequence[EdgeLabel], X_WS: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], height_error: typing.SupportsFloat | typing.SupportsIndex = 0.0, angle_error: typing.SupportsFloat | typing.SupportsIndex = 0.0, noise: typing.SupportsFloat | typing.SupportsIndex = 0.0, least_thickness: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def X_WS(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @property
    def angle_error(self) -> float:
        """
        Standard error of its tilt [rad].
        """
    @property
    def edges(self) -> tuple[EdgeLabel, ...]:
        """
        Label of each edge: edge i runs from corner i to the next.
        """
    @property
    def height_error(self) -> float:
        """
        Standard error of the plane's height at its centre [m].
        """
    @property
    def least_thickness(self) -> float:
        """
        Least thickness of an object that would have been seen on it [m].
        """
    @property
    def name(self) -> str:
        """
        Name: support_0 is the largest.
        """
    @property
    def noise(self) -> float:
        """
        Standard deviation of the depth that was measured on it [m].
        """
    @property
    def polygon(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (N, 2) corners in S [m], counter-clockwise.
        """
class Object:
    """
    A thing that stands on a support or lies on it.
    
    Its frame O has its origin in the support's plane, below the centroid of the outline, z out of the plane, and x along its longest extent.
    """
    def __init__(self, *, name: str, support: str, outline: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], thickness: typing.SupportsFloat | typing.SupportsIndex, thickness_error: typing.SupportsFloat | typing.SupportsIndex, is_flat: bool, position_error: typing.SupportsFloat | typing.SupportsIndex, yaw_error: typing.SupportsFloat | typing.SupportsIndex, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], rays: collections.abc.Sequence[graspless._core.geometry.RayImage] = [], touches_border: bool = False, warnings: collections.abc.Sequence[str] = []) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @property
    def is_flat(self) -> bool:
        """
        True if all that was seen of the top is equally high.
        """
    @property
    def name(self) -> str:
        """
        Name: object_0 is nearest to the first camera.
        """
    @property
    def outline(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (N, 2) corners of the projection of what was seen onto the support, in O [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) points of all pixels of the object, in O [m].
        """
    @property
    def position_error(self) -> float:
        """
        Standard error of the outline's position along the support [m].
        """
    @property
    def rays(self) -> tuple[graspless._core.geometry.RayImage, ...]:
        """
        Rays of each camera that saw it, around it, in O. They tell holes from rims and from
        edges of what was seen.
        """
    @property
    def support(self) -> str:
        """
        Name of the support.
        """
    @property
    def thickness(self) -> float:
        """
        Height of the top above the support [m].
        """
    @property
    def thickness_error(self) -> float:
        """
        Standard error of the thickness [m].
        """
    @property
    def touches_border(self) -> bool:
        """
        True if the image cuts the object off.
        """
    @property
    def warnings(self) -> tuple[str, ...]:
        """
        Reasons to doubt the outline, one sentence each.
        """
    @property
    def yaw_error(self) -> float:
        """
        Standard error of the direction of x [rad].
        """
class Unseen:
    """
    Space over a support that no ray reached.
    """
    def __init__(self, *, behind: str, vertices: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def behind(self) -> str:
        """
        Name of the object that hides it; empty: a patch without depth.
        """
    @property
    def vertices(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) corners of a convex hull in the world [m].
        """
class Scene:
    """
    Supports, objects and unseen space in depth images. False if nothing trustworthy was found.
    """
    def __bool__(self) -> bool:
        """
        True if at least one support was found.
        """
    def __init__(self, *, status: Status, reason: str, supports: collections.abc.Sequence[Support], objects: collections.abc.Sequence[Object], unseen: collections.abc.Sequence[Unseen], warnings: collections.abc.Sequence[str], stamp: typing.SupportsFloat | typing.SupportsIndex | None = None) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def objects(self) -> tuple[Object, ...]:
        """
        Objects, the nearest to the first camera first.
        """
    @property
    def reason(self) -> str:
        """
        Result, or the reason why there is none and what to do; one sentence or two.
        """
    @property
    def stamp(self) -> float | None:
        """
        Time at which the images were taken [s since 1970]; None if unknown.
        """
    @stamp.setter
    def stamp(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def status(self) -> Status:
        """
        Outcome.
        """
    @property
    def supports(self) -> tuple[Support, ...]:
        """
        Supports, from the largest to the smallest.
        """
    @property
    def unseen(self) -> tuple[Unseen, ...]:
        """
        Space that no ray reached.
        """
    @property
    def warnings(self) -> tuple[str, ...]:
        """
        Doubts about what was found, one sentence each.
        """
def cast_rays(bodies: collections.abc.Sequence[Body], X_WC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], camera: Camera = ...) -> Rendering:
    """
    Casts one ray through the centre of each pixel (CGAL's AABB trees).
    
    Parameters
    ----------
    bodies : list of Body
    X_WC : (4, 4) array
        Pose of the camera's optical frame C in the world.
    camera : Camera, optional
        By default 640 x 480 pixels with a horizontal field of view of 60 degrees.
    
    Returns
    -------
    Rendering
        Exact depths, without noise.
    
    Raises
    ------
    ValueError
        If a shape is a sphere or a capsule, or a pose or shape is not valid.
    """
def perceive(views: collections.abc.Sequence[View], options: Options = ...) -> Scene:
    """
    Finds supports and objects in depth images of a still scene, a list of Views. Finding nothing is a status.
    
    Raises ValueError if a camera, pose or option is not valid.
    """
