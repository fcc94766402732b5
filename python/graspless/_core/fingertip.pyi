"""
Push, slide and tumble an object with bare fingertips (Maeda, Arai).
"""
from __future__ import annotations
import collections.abc
import graspless._core.collision
import graspless._core.geometry
import graspless._core.mechanics
import graspless._core.planning
import graspless._core.robot
import graspless._core.scene
import graspless._core.slide
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Carrier', 'Face', 'FingerState', 'Fingers', 'Goal', 'JointSegment', 'Lattice', 'Object', 'Options', 'Path', 'Plan', 'Plane', 'Problem', 'Realization', 'RealizeOptions', 'Relaxation', 'Row', 'Search', 'Segment', 'Statistics', 'Status', 'certify_realization', 'check', 'check_realization', 'join', 'plan', 'plan_carried', 'realize', 'resume', 'slide_path', 'turn_path', 'validate']
class Face:
    """
    Planar face of an object.
    """
    def __repr__(self) -> str:
        ...
    @property
    def area(self) -> float:
        """
        Area [m^2].
        """
    @property
    def first_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit vector of the first grid axis, along the face, in O.
        """
    @property
    def n_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal in O, pointing into the object.
        """
    @property
    def offset(self) -> float:
        """
        n_O . p of the points p on the face [m].
        """
    @property
    def second_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit vector of the second grid axis, n_O x first_O.
        """
    @property
    def triangles(self) -> list[int]:
        """
        Row indices of the face's triangles in the mesh.
        """
class Object:
    """
    Rigid polyhedron to be moved: any closed mesh, in a frame O of your choice.
    """
    @staticmethod
    def box(name: str, size: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], mass: typing.SupportsFloat | typing.SupportsIndex) -> Object:
        """
        Creates a box of uniform density, centred at O.
        
        Parameters
        ----------
        name : str
            Name in error messages and pictures.
        size : (3,) array
            Side lengths along the axes of O [m].
        mass : float
            Mass [kg].
        
        Raises
        ------
        ValueError
            A length or the mass is not positive.
        """
    @staticmethod
    def from_mesh(name: str, mesh: typing.Any, mass: typing.SupportsFloat | typing.SupportsIndex) -> Object:
        """
        Creates an object of uniform density from a closed mesh.
        
        Parameters
        ----------
        name : str
            Name in error messages and pictures.
        mesh : geometry.Mesh, trimesh.Trimesh, or pair of arrays (N, 3) and (M, 3)
            Vertices in O [m] and triangles.
        mass : float
            Mass [kg].
        
        Raises
        ------
        ValueError
            The mesh is not closed, has no volume or has too many triangles.
        """
    def __repr__(self) -> str:
        ...
    def with_com(self, com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Object:
        """
        Returns a copy with another centre of mass, (3,) in O [m].
        """
    def with_inertia(self, inertia_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Object:
        """
        Returns a copy with another inertia about its centre of mass, (3, 3) in O [kg m^2].
        """
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) centre of mass in O [m].
        """
    @property
    def faces(self) -> list[Face]:
        """
        Faces. Coplanar neighbouring triangles form one face.
        """
    @property
    def hull(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) vertices of the convex hull, in O [m].
        """
    @property
    def inertia(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (3, 3) inertia about the centre of mass, in O [kg m^2].
        """
    @property
    def is_convex(self) -> bool:
        """
        True if the object is convex.
        """
    @property
    def mass(self) -> float:
        """
        Mass [kg].
        """
    @property
    def mesh(self) -> graspless._core.geometry.Mesh:
        """
        Closed mesh with outward triangles, in O [m].
        """
    @property
    def name(self) -> str:
        """
        Name in error messages and pictures.
        """
    @property
    def size(self) -> float:
        """
        Diagonal of the bounding box [m].
        """
class Plane:
    """
    Solid half-space that the object may touch and fingertips may not: a floor or a wall.
    """
    def __init__(self, name: str = 'floor', n_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., offset: typing.SupportsFloat | typing.SupportsIndex = 0.0, friction: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] | None = None) -> None:
        """
        Parameters
        ----------
        name : str
            Name in error messages.
        n_W : (3,) array
            Unit normal in the world, pointing out of the solid.
        offset : float
            n_W . p of the points p on its surface [m].
        friction : float or (lower, upper), optional
            Coefficient of friction with the object. By default it is that of the problem,
            which all such planes share. The coefficient of a plane with its own interval
            varies independently.
        """
    def __repr__(self) -> str:
        ...
    @property
    def friction(self) -> tuple[float, float] | None:
        """
        (lower, upper) coefficient of friction with the object; None: that of the problem.
        """
    @property
    def n_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal in the world, pointing out of the solid.
        """
    @property
    def name(self) -> str:
        """
        Name in error messages and pictures.
        """
    @property
    def offset(self) -> float:
        """
        n_W . p of the points p on its surface [m].
        """
class Fingers:
    """
    Fingertips: equal spheres in one-point contact that neither slide nor roll.
    """
    def __init__(self, *, count: typing.SupportsInt | typing.SupportsIndex = 2, radius: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_normal_force: typing.SupportsFloat | typing.SupportsIndex = 10.0, friction: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] = (0.7, 0.7), max_span: typing.SupportsFloat | typing.SupportsIndex = ..., start: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]] = []) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def count(self) -> int:
        """
        Number of fingers, 1 to 4.
        """
    @count.setter
    def count(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def friction(self) -> tuple[float, float]:
        """
        Coefficient of friction between fingertip and object: a number, or (lower, upper).
        """
    @friction.setter
    def friction(self, arg1: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
    @property
    def max_normal_force(self) -> float:
        """
        Upper limit f_max of each finger's normal force [N].
        """
    @max_normal_force.setter
    def max_normal_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_span(self) -> float:
        """
        Largest distance between the centres of two fingertips [m].
        """
    @max_span.setter
    def max_span(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        Radius [m].
        """
    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def start(self) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], ...]:
        """
        Contact point of each finger at the start, (3,) in O [m]; empty: anywhere.
        """
    @start.setter
    def start(self, arg1: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]]) -> None:
        ...
class Path:
    """
    Poses that the object passes through. It moves along a screw from each pose to the next.
    """
    def __init__(self, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        X_WO: (K, 4, 4) poses of O in the world, two or more.
        """
    def __len__(self) -> int:
        """
        Number of poses.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (K, 4, 4) poses of O in the world.
        """
class Lattice:
    """
    Motion on the floor from start to goal through a lattice of positions and yaws.
    """
    def __init__(self, *, X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., X_WO_goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., lower: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., upper: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., counts: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [30, 30, 30]) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def X_WO_goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of O in the world.
        """
    @X_WO_goal.setter
    def X_WO_goal(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def X_WO_start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of O in the world.
        """
    @X_WO_start.setter
    def X_WO_start(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def counts(self) -> typing.Annotated[list[int], "FixedSize(3)"]:
        """
        Numbers of values of x, y and yaw.
        """
    @counts.setter
    def counts(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        ...
    @property
    def lower(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) least x, y, yaw relative to the start [m, m, rad].
        """
    @lower.setter
    def lower(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def upper(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) largest x, y, yaw relative to the start [m, m, rad].
        """
    @upper.setter
    def upper(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class Goal:
    """
    Goal pose of the object, on any face. The planner finds the slides, turns and tumbles.
    """
    def __init__(self, *, X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., X_WO_goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., slide_step: typing.SupportsFloat | typing.SupportsIndex = 0.01, turn_step: typing.SupportsFloat | typing.SupportsIndex = 0.05236, max_tumbles: typing.SupportsInt | typing.SupportsIndex = 3) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def X_WO_goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of O in the world.
        """
    @X_WO_goal.setter
    def X_WO_goal(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def X_WO_start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of O in the world.
        """
    @X_WO_start.setter
    def X_WO_start(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def max_tumbles(self) -> int:
        """
        Maximum number of tumbles.
        """
    @max_tumbles.setter
    def max_tumbles(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def slide_step(self) -> float:
        """
        Longest step of a slide [m].
        """
    @slide_step.setter
    def slide_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def turn_step(self) -> float:
        """
        Largest step of a turn or a tumble [rad].
        """
    @turn_step.setter
    def turn_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Problem:
    """
    Task of the planner: bring an object through a motion with fingertips alone.
    """
    def __init__(self, *, object: Object, motion: Path | Lattice | Goal, fingers: Fingers = ..., planes: collections.abc.Sequence[Plane] = ..., friction: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] = (0.5, 0.5), obstacles: collections.abc.Sequence[graspless._core.collision.Obstacle] = [], gravity_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = [0, 0, -9.8]) -> None:
        """
        planes: the floor first, then walls. friction: coefficient between object and planes, a number or
        (lower, upper); a plane may have its own. gravity_W: (3,) acceleration of gravity in the
        world [m/s^2].
        """
    def __repr__(self) -> str:
        ...
    @property
    def fingers(self) -> Fingers:
        """
        A copy of the fingers.
        """
    @property
    def friction(self) -> tuple[float, float]:
        """
        (lower, upper) coefficient of friction between object and planes without their own.
        """
    @property
    def gravity_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) acceleration of gravity in the world [m/s^2].
        """
    @property
    def motion(self) -> Path | Lattice | Goal:
        """
        A Path, Lattice or Goal; a copy.
        """
    @property
    def object(self) -> Object:
        """
        Object to move.
        """
    @property
    def obstacles(self) -> list[graspless._core.collision.Obstacle]:
        """
        Obstacles in the world.
        """
    @property
    def planes(self) -> list[Plane]:
        """
        The floor first, then walls.
        """
class Search(graspless._named.Named):
    """
    Search algorithms. All find the same cost, except on lattices with regrasps.
    """
    dijkstra = ...
    fast = ...
    paper = ...
class Options:
    """
    Options of the search.
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
    def __init__(self, *, search: Search = Search.fast, locations_per_side: typing.SupportsInt | typing.SupportsIndex = 7, location_spacing: typing.SupportsFloat | typing.SupportsIndex = 0.0, cone_edges: typing.SupportsInt | typing.SupportsIndex = 6, samples_per_arc: typing.SupportsInt | typing.SupportsIndex = 3, min_stability: typing.SupportsFloat | typing.SupportsIndex = 0.5, regrasp_cost: typing.SupportsFloat | typing.SupportsIndex = 100.0, stability_weight: typing.SupportsFloat | typing.SupportsIndex = 0.01, disturbance_directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., compliance: graspless._core.mechanics.Compliance = ..., max_yield: typing.SupportsFloat | typing.SupportsIndex = 0.001, max_regrasps: typing.SupportsInt | typing.SupportsIndex = 8, threads: typing.SupportsInt | typing.SupportsIndex = 1, max_memory: typing.SupportsFloat | typing.SupportsIndex = 4000000000.0, explain: bool = True) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def compliance(self) -> graspless._core.mechanics.Compliance:
        """
        Springs at the contacts, for nominal forces, compliant_stability and withstands.
        """
    @compliance.setter
    def compliance(self, arg0: graspless._core.mechanics.Compliance) -> None:
        ...
    @property
    def cone_edges(self) -> int:
        """
        Number of edges of a friction cone.
        
        Range: [3, 64]. Default: 6. Paper: s.
        """
    @cone_edges.setter
    def cone_edges(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def disturbance_directions(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 6]"]:
        """
        Directions of the disturbances in scaled wrench space, forces first: a column each in C++, a row each in Python. They must positively span that space.
        
        Paper: l_i.
        """
    @disturbance_directions.setter
    def disturbance_directions(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def explain(self) -> bool:
        """
        On failure, find by bisection which single relaxation of friction, force limit or min_stability helps.
        
        Default: True.
        """
    @explain.setter
    def explain(self, arg0: bool) -> None:
        ...
    @property
    def location_spacing(self) -> float:
        """
        Distance between locations, instead of locations_per_side. 0: use locations_per_side.
        
        Unit: m. Range: [0, inf). Default: 0.0.
        """
    @location_spacing.setter
    def location_spacing(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def locations_per_side(self) -> int:
        """
        Number of fingertip locations along each side of a face's rectangle, centred in cells.
        
        Range: [1, 10000]. Default: 7.
        """
    @locations_per_side.setter
    def locations_per_side(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def max_memory(self) -> float:
        """
        Largest memory of the search's tables; a larger search is refused.
        
        Unit: bytes. Range: (0, inf]. Default: 4000000000.0.
        """
    @max_memory.setter
    def max_memory(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_regrasps(self) -> int:
        """
        Maximum number of regrasps.
        
        Range: [0, 1000]. Default: 8.
        """
    @max_regrasps.setter
    def max_regrasps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def max_yield(self) -> float:
        """
        Largest distance by which the springs may let a corner of the object yield to a disturbance that `withstands` counts.
        
        Unit: m. Range: (0, inf). Default: 0.001.
        """
    @max_yield.setter
    def max_yield(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_stability(self) -> float:
        """
        Least disturbance that every instant must withstand.
        
        Unit: N. Range: (0, 1e+09]. Default: 0.5. Paper: z_min.
        """
    @min_stability.setter
    def min_stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def regrasp_cost(self) -> float:
        """
        Cost of one regrasp, as a displacement of the object.
        
        Unit: m. Range: (0, inf). Default: 100.0. Paper: X_regr, Eq. (10).
        """
    @regrasp_cost.setter
    def regrasp_cost(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def samples_per_arc(self) -> int:
        """
        Number of instants checked between two poses of the object.
        
        Range: [1, 1000]. Default: 3. Paper: P.
        """
    @samples_per_arc.setter
    def samples_per_arc(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def search(self) -> Search:
        """
        Search algorithm. All find the same cost, but fast may find a higher one on a lattice with regrasps: `lower_bound` says so.
        """
    @search.setter
    def search(self, arg0: Search) -> None:
        ...
    @property
    def stability_weight(self) -> float:
        """
        Weight of stability in the cost of a motion: its displacement times 1 + stability_weight / stability. 0: displacement alone.
        
        Unit: N. Range: [0, inf). Default: 0.01. Paper: X_stab, Eq. (9).
        """
    @stability_weight.setter
    def stability_weight(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def threads(self) -> int:
        """
        Number of threads.
        
        Range: [1, 256]. Default: 1.
        """
    @threads.setter
    def threads(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class FingerState:
    """
    State of a finger at one instant.
    """
    def __init__(self, *, touches: bool = True, p_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., mode: graspless._core.mechanics.FingerMode = graspless._core.mechanics.FingerMode.position, commanded_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, nominal_force_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def commanded_force(self) -> float:
        """
        Commanded normal force f_com in force control, else 0 [N].
        """
    @commanded_force.setter
    def commanded_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mode(self) -> graspless._core.mechanics.FingerMode:
        """
        Control mode: position or force.
        """
    @mode.setter
    def mode(self, arg0: graspless._core.mechanics.FingerMode) -> None:
        ...
    @property
    def n_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal in O, pointing into the object.
        """
    @n_O.setter
    def n_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def nominal_force_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) nominal force on the object, in O, for feed-forward [N].
        """
    @nominal_force_O.setter
    def nominal_force_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def p_OC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) contact point in O [m].
        """
    @p_OC.setter
    def p_OC(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def touches(self) -> bool:
        """
        False while the finger regrasps.
        """
    @touches.setter
    def touches(self, arg0: bool) -> None:
        ...
class Row:
    """
    One instant of a plan: a sample of an arc, or a regrasp.
    """
    def __init__(self, *, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., fingers: collections.abc.Sequence[FingerState] = [], stability: typing.SupportsFloat | typing.SupportsIndex = 0.0, compliant_stability: typing.SupportsFloat | typing.SupportsIndex = 0.0, nominal_margin: typing.SupportsFloat | typing.SupportsIndex = 0.0, withstands: typing.SupportsFloat | typing.SupportsIndex = 0.0, place_tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of O in the world.
        """
    @X_WO.setter
    def X_WO(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def compliant_stability(self) -> float:
        """
        Margin by mechanics.compliant_stability [N].
        """
    @compliant_stability.setter
    def compliant_stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fingers(self) -> tuple[FingerState, ...]:
        """
        One FingerState for each finger.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[FingerState]) -> None:
        ...
    @property
    def nominal_margin(self) -> float:
        """
        Margin of the nominal forces, as in mechanics.Equilibrium [N].
        """
    @nominal_margin.setter
    def nominal_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def place_tolerance(self) -> float:
        """
        Error of every finger's place that the row tolerates, by
        mechanics.place_tolerance [m].
        """
    @place_tolerance.setter
    def place_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stability(self) -> float:
        """
        Stability z [N]. If friction is an interval, it is the least over the evaluated coefficients; for
        the whole interval, only min_stability is proven.
        """
    @stability.setter
    def stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def withstands(self) -> float:
        """
        Largest disturbance that the row withstands while fingers are in their places, by
        mechanics.withstands [N].
        """
    @withstands.setter
    def withstands(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Segment:
    """
    Part of the plan during which no finger changes its place, or one regrasp.
    """
    def __init__(self, name: str, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], rows: collections.abc.Sequence[Row], finger: typing.SupportsInt | typing.SupportsIndex = -1) -> None:
        """
        X_WO: (K, 4, 4) poses of the lattice, first to last. rows: instants. finger: index of the finger
        that regrasps.
        """
    def __len__(self) -> int:
        """
        Number of rows.
        """
    def __repr__(self) -> str:
        ...
    def _to_arrays(self) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
        """
        Returns object_poses, margins and fingers as _rows() takes them.
        """
    @property
    def X_WO(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (K, 4, 4) poses of the lattice in the world, first to last.
        """
    @property
    def finger(self) -> int:
        """
        Index of the finger that regrasps; -1 for a motion of the object.
        """
    @property
    def name(self) -> str:
        """
        slide, turn, tumble or regrasp.
        """
    @property
    def rows(self) -> list[Row]:
        """
        Instants, in order.
        """
class Statistics:
    """
    Counters of the search.
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, locations: typing.SupportsInt | typing.SupportsIndex = 0, z_evaluations: typing.SupportsInt | typing.SupportsIndex = 0, bounded_tests: typing.SupportsInt | typing.SupportsIndex = 0, pivots: typing.SupportsInt | typing.SupportsIndex = 0, ill_conditioned: typing.SupportsInt | typing.SupportsIndex = 0, nodes: typing.SupportsInt | typing.SupportsIndex = 0, placements: typing.SupportsInt | typing.SupportsIndex = 0, supports: typing.SupportsInt | typing.SupportsIndex = 0, candidates: typing.SupportsInt | typing.SupportsIndex = 0, memory: typing.SupportsInt | typing.SupportsIndex = 0) -> None:
        """
        Any field by keyword; the others are zero.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, typing.Any]:
        """
        Returns all fields by name.
        """
    @property
    def bounded_tests(self) -> int:
        """
        Tests whether internal forces are bounded.
        
        Paper: Problem (5).
        """
    @bounded_tests.setter
    def bounded_tests(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def candidates(self) -> int:
        """
        Motions of the object tried on the way to a Goal.
        """
    @candidates.setter
    def candidates(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def ill_conditioned(self) -> int:
        """
        Problems (5) and (6) with ill-conditioned contacts, solved by the reference engine.
        """
    @ill_conditioned.setter
    def ill_conditioned(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def locations(self) -> int:
        """
        Fingertip locations on the object.
        """
    @locations.setter
    def locations(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def memory(self) -> int:
        """
        Largest memory of the search's tables.
        
        Unit: bytes.
        """
    @memory.setter
    def memory(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def nodes(self) -> int:
        """
        Nodes that the search of a graph expanded; 0 for the fast search of a path.
        """
    @nodes.setter
    def nodes(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def pivots(self) -> int:
        """
        Pivots of the simplex method.
        """
    @pivots.setter
    def pivots(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def placements(self) -> int:
        """
        Placements of the fingers that the fast search of a path considered.
        """
    @placements.setter
    def placements(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def seconds(self) -> float:
        """
        Wall-clock time.
        
        Unit: s.
        """
    @seconds.setter
    def seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def supports(self) -> int:
        """
        Wrench functionals that bound the stability from above.
        """
    @supports.setter
    def supports(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def z_evaluations(self) -> int:
        """
        Evaluations of the stability, each over all directions.
        
        Paper: Problem (6).
        """
    @z_evaluations.setter
    def z_evaluations(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Relaxation:
    """
    Smallest change of one parameter that makes a failed search succeed.
    """
    def __init__(self, *, field: str = '', value: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def field(self) -> str:
        """
        Name of the parameter: fingers.friction, fingers.max_normal_force, friction,
        planes[1] 'wall'.friction and the like, or min_stability.
        """
    @field.setter
    def field(self, arg0: str) -> None:
        ...
    @property
    def value(self) -> float:
        """
        Value nearest to the given one that helps, to 1 %.
        """
    @value.setter
    def value(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Status(graspless._named.Named):
    """
    Outcome of a query.
    """
    at_goal = ...
    interrupted = ...
    no_location = ...
    not_realized = ...
    off_path = ...
    out_of_memory = ...
    out_of_time = ...
    solved = ...
    unstable = ...
class Plan:
    """
    Result of a query. False unless it is solved.
    """
    def __bool__(self) -> bool:
        """
        True if the query is solved.
        """
    def __init__(self) -> None:
        """
        A plan without segments, to be filled from a file.
        """
    def __repr__(self) -> str:
        ...
    @property
    def cost(self) -> float:
        """
        Cost by Eqs. (9) and (10) [m].
        """
    @cost.setter
    def cost(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def limit(self) -> str:
        """
        Obstacles to a plan, if not solved.
        """
    @limit.setter
    def limit(self, arg0: str) -> None:
        ...
    @property
    def lower_bound(self) -> float:
        """
        Lower bound on the cost of every plan on this lattice [m]; equals `cost` if the plan is optimal.
        """
    @lower_bound.setter
    def lower_bound(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def place_tolerance(self) -> float:
        """
        Error of every finger's place that every row tolerates [m].
        """
    @place_tolerance.setter
    def place_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def reason(self) -> str:
        """
        Explanation of the outcome in one sentence.
        """
    @reason.setter
    def reason(self, arg0: str) -> None:
        ...
    @property
    def regrasps(self) -> int:
        """
        Number of regrasps.
        """
    @regrasps.setter
    def regrasps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def relaxations(self) -> tuple[Relaxation, ...]:
        """
        Single changes that would help, if not solved.
        """
    @relaxations.setter
    def relaxations(self, arg1: collections.abc.Sequence[Relaxation]) -> None:
        ...
    @property
    def segments(self) -> tuple[Segment, ...]:
        """
        Motions and regrasps, in order.
        """
    @segments.setter
    def segments(self, arg1: collections.abc.Sequence[Segment]) -> None:
        ...
    @property
    def statistics(self) -> Statistics:
        """
        Counters of the search.
        """
    @statistics.setter
    def statistics(self, arg0: Statistics) -> None:
        ...
    @property
    def status(self) -> Status:
        """
        Outcome of the query.
        """
    @status.setter
    def status(self, arg0: Status) -> None:
        ...
    @property
    def warnings(self) -> tuple[str, ...]:
        """
        Warnings about the plan.
        """
    @warnings.setter
    def warnings(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def weakest_row(self) -> int:
        """
        Index of the row of least stability in that segment; -1 without a plan.
        """
    @weakest_row.setter
    def weakest_row(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def weakest_segment(self) -> int:
        """
        Index of the segment of least stability; -1 without a plan.
        """
    @weakest_segment.setter
    def weakest_segment(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def withstands(self) -> float:
        """
        Largest disturbance that every row withstands [N].
        """
    @withstands.setter
    def withstands(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Carrier:
    """
    Parts of a robot that carry the fingertips.
    """
    def __init__(self, *, fingertips: collections.abc.Sequence[str] = ['left_tip_center', 'right_tip_center'], links: collections.abc.Sequence[collections.abc.Sequence[str]] = [['left_finger'], ['right_finger']]) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def fingertips(self) -> tuple[str, ...]:
        """
        Frames at the centres of the spheres, one for each finger.
        """
    @fingertips.setter
    def fingertips(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def links(self) -> tuple[list[str], ...]:
        """
        Links that may touch the object, for each fingertip.
        """
    @links.setter
    def links(self, arg1: collections.abc.Sequence[collections.abc.Sequence[str]]) -> None:
        ...
class RealizeOptions:
    """
    Options of realize().
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __copy__(self) -> RealizeOptions:
        """
        Returns a copy.
        """
    def __deepcopy__(self, memo: typing.Any) -> RealizeOptions:
        """
        Returns a copy.
        """
    def __init__(self, *, approach: typing.SupportsFloat | typing.SupportsIndex = 0.03, resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_jump: typing.SupportsFloat | typing.SupportsIndex = 0.05, position_tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.0001, restarts: typing.SupportsInt | typing.SupportsIndex = 40, solutions: typing.SupportsInt | typing.SupportsIndex = 8, plans: typing.SupportsInt | typing.SupportsIndex = 8, max_scrub: typing.SupportsFloat | typing.SupportsIndex = 0.0003) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def approach(self) -> float:
        """
        Distance over which a finger approaches and leaves the surface along its normal. Where the hand does not open so far, a half, a quarter or an eighth of it.
        
        Unit: m. Range: (0, inf). Default: 0.03.
        """
    @approach.setter
    def approach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_jump(self) -> float:
        """
        Largest joint step between two rows.
        
        Unit: rad or m. Range: (0, inf). Default: 0.05.
        """
    @max_jump.setter
    def max_jump(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_scrub(self) -> float:
        """
        Slip of a fingertip on its contact in a segment, above which further fingertip plans are tried. If all slip as far, that with the least scrub is kept.
        
        Unit: m. Range: [0, inf). Default: 0.0003.
        """
    @max_scrub.setter
    def max_scrub(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def plans(self) -> int:
        """
        Number of fingertip plans to try: the best one, then those with fingertips nearer to each other.
        
        Range: [1, 1e+06]. Default: 8.
        """
    @plans.setter
    def plans(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def position_tolerance(self) -> float:
        """
        Largest distance of a fingertip from its planned position, at rows and between them.
        
        Unit: m. Range: (0, inf). Default: 0.0001.
        """
    @position_tolerance.setter
    def position_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def resolution(self) -> float:
        """
        Largest joint step between checked configurations.
        
        Unit: rad. Range: [0.0001, inf). Default: 0.01.
        """
    @resolution.setter
    def resolution(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def restarts(self) -> int:
        """
        Number of rounds of initial configurations to search from.
        
        Range: [1, 1e+06]. Default: 40.
        """
    @restarts.setter
    def restarts(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def solutions(self) -> int:
        """
        Number of solutions to find; the one with the least scrub is kept.
        
        Range: [1, 1e+06]. Default: 8.
        """
    @solutions.setter
    def solutions(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class JointSegment:
    """
    Part of a joint motion.
    """
    def __init__(self, name: str, positions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], plan_segment: typing.SupportsInt | typing.SupportsIndex = -1, scrub: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        positions: (N, dof) [rad or m]. X_WO: (N, 4, 4) poses of O in the world.
        """
    def __len__(self) -> int:
        """
        Number of rows.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (N, 4, 4) pose of O in the world at each row.
        """
    @property
    def name(self) -> str:
        """
        approach, touch, slide, turn, tumble, release, reach or retreat.
        """
    @property
    def plan_segment(self) -> int:
        """
        Index of the plan's segment that it carries out, or -1.
        """
    @property
    def positions(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (N, dof) all joints [rad or m].
        """
    @property
    def scrub(self) -> float:
        """
        Largest distance by which a turning fingertip slips on its contact [m].
        """
class Realization:
    """
    Joint paths that carry a plan's fingertips, or the reason why there are none.
    """
    def __bool__(self) -> bool:
        """
        True if there are joint paths.
        """
    def __init__(self, *, found: bool = False, reason: str = '', joint_names: collections.abc.Sequence[str] = [], finger_of_fingertip: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], segments: collections.abc.Sequence[JointSegment] = []) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def finger_of_fingertip(self) -> tuple[int, ...]:
        """
        Index of the plan's finger for each fingertip.
        """
    @finger_of_fingertip.setter
    def finger_of_fingertip(self, arg1: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
    @property
    def found(self) -> bool:
        """
        True if there are joint paths.
        """
    @found.setter
    def found(self, arg0: bool) -> None:
        ...
    @property
    def joint_names(self) -> tuple[str, ...]:
        """
        Names of the joints, in the order of the columns of positions.
        """
    @joint_names.setter
    def joint_names(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def reason(self) -> str:
        """
        Segment, row and finger that fail, and the reason.
        """
    @reason.setter
    def reason(self, arg0: str) -> None:
        ...
    @property
    def segments(self) -> tuple[JointSegment, ...]:
        """
        Parts of the joint motion, in order.
        """
    @segments.setter
    def segments(self, arg1: collections.abc.Sequence[JointSegment]) -> None:
        ...
def _rows(object_poses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], margins: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], fingers: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> list[Row]:
    """
    Returns rows: poses (N, 4, 4), margins (N, 5), and 12 numbers per finger (N, n, 12).
    """
def certify_realization(problem: Problem, plan: Plan, robot: graspless._core.robot.Robot, carrier: Carrier, realization: Realization, options: RealizeOptions = ...) -> graspless._core.scene.EdgeCertificate:
    """
    Proves what check_realization() samples between the rows: nothing touches that may not, and the fingertips keep their tolerances.
    
    Returns a scene.EdgeCertificate. Raises ValueError if the paths were not found or are malformed.
    """
def check(problem: Problem, plan: Plan, options: Options = ...) -> list[str]:
    """
    Checks a plan: derives every row anew from its problem, without the code of the search.
    
    Returns one fault per entry, with segment and row; an empty list if the plan is valid.
    """
def check_realization(problem: Problem, plan: Plan, robot: graspless._core.robot.Robot, carrier: Carrier, realization: Realization, options: RealizeOptions = ...) -> list[str]:
    """
    Checks joint paths against problem and plan: limits, steps, fingertips, collisions.
    
    Returns one fault per entry; an empty list if the paths are valid.
    """
def join(paths: collections.abc.Sequence[Path]) -> Path:
    """
    Joins paths into one. Each must start where the one before it ends.
    """
def plan(problem: Problem, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans the places, control modes and regrasps of the fingers (Maeda, Arai 2005, Section 4).
    
    Finding no plan is a status, not an error.
    
    Releases the GIL: other Python threads can run. Ctrl-C raises KeyboardInterrupt; budget.stop() ends the query, which then returns the best result so far.
    
    Raises ValueError on a bad problem or bad options.
    """
def plan_carried(problem: Problem, options: Options, robot: graspless._core.robot.Robot, carrier: Carrier, q_home: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], realize_options: RealizeOptions = ..., budget: graspless._core.planning.Budget = ...) -> tuple[Plan, Realization]:
    """
    Plans the fingertips and the joint paths that carry them.
    
    If the robot cannot carry the best plan out, plans whose fingertips are nearer together are tried.
    A plan that is not the best has a warning. If there are joint paths for none, the best plan is
    returned with the status not_realized. Releases the GIL: other Python threads can run. Ctrl-C
    raises KeyboardInterrupt.
    
    Parameters
    ----------
    problem : Problem
    options : Options
    robot : robot.Robot
    carrier : Carrier
        Parts of the robot that carry the fingertips.
    q_home : (dof,) array
        Configuration at the start [rad or m].
    realize_options : RealizeOptions, optional
    budget : planning.Budget, optional
    
    Returns
    -------
    (Plan, Realization)
    
    Raises
    ------
    ValueError
        As plan() and realize() do.
    """
def realize(problem: Problem, plan: Plan, robot: graspless._core.robot.Robot, carrier: Carrier, q_home: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], options: RealizeOptions = ..., budget: graspless._core.planning.Budget = ...) -> Realization:
    """
    Finds joint paths of a robot that carry a plan's fingertips.
    
    They lead from q_home to the first grip, through every row and regrasp, and away. Failure to find
    them is a Realization with a reason, not an error. Releases the GIL: other Python threads can run.
    Ctrl-C raises KeyboardInterrupt.
    
    Parameters
    ----------
    problem : Problem
    plan : Plan
        Solved plan of the problem.
    robot : robot.Robot
    carrier : Carrier
        Parts of the robot that carry the fingertips.
    q_home : (dof,) array
        Configuration at the start [rad or m].
    options : RealizeOptions, optional
    budget : planning.Budget, optional
    
    Returns
    -------
    Realization
    
    Raises
    ------
    ValueError
        A frame is unknown, the home lies outside the joint limits, or the plan is not solved.
    """
def resume(problem: Problem, plan: Plan, segment: typing.SupportsInt | typing.SupportsIndex, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], options: Options, budget: graspless._core.planning.Budget) -> tuple[Problem, Plan]:
    """
    Plans the rest of a plan from a measured pose of the object, with the fingers where they are.
    
    Returns the rest as a problem of its own, and its plan. A state from which the plan does not go on is a status.
    
    Raises ValueError on a bad problem, plan, segment, pose or options.
    """
def slide_path(X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], translation_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], segments: typing.SupportsInt | typing.SupportsIndex) -> Path:
    """
    Returns a straight slide from X_WO_start, (4, 4), by translation_W, (3,) in the world [m], in equal
    segments.
    """
def turn_path(X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], point_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], axis_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], angle: typing.SupportsFloat | typing.SupportsIndex, segments: typing.SupportsInt | typing.SupportsIndex) -> Path:
    """
    Returns a tumble over an edge or a turn on the floor, in equal segments.
    
    It starts at X_WO_start, (4, 4), and turns by angle [rad, right-handed] about the line through
    point_W [m] along axis_W, both (3,) in the world.
    """
@typing.overload
def validate(problem: Problem) -> None:
    """
    Raises ValueError that names the first bad field, its value and what is allowed.
    """
@typing.overload
def validate(options: Options) -> None:
    """
    Raises ValueError that names the first bad option, its value and what is allowed.
    """
@typing.overload
def validate(problem: Problem, options: Options) -> None:
    """
    Raises ValueError like the other two.
    """
