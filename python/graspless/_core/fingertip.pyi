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
import graspless._core.slide
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Carrier', 'Face', 'FingerState', 'Fingers', 'Goal', 'JointSegment', 'Lattice', 'Object', 'Options', 'Path', 'Plan', 'Plane', 'Problem', 'Realization', 'RealizeOptions', 'Relaxation', 'Row', 'Search', 'Segment', 'Statistics', 'Status', 'check', 'check_realization', 'join', 'plan', 'realize', 'slide_path', 'turn_path', 'validate']
class Face:
    """
    A flat part of an object's surface.
    """
    def __repr__(self) -> str:
        ...
    @property
    def area(self) -> float:
        """
        [m^2].
        """
    @property
    def first_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) first grid axis, unit, on the face.
        """
    @property
    def n_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) into the object, unit.
        """
    @property
    def offset(self) -> float:
        """
        n_O . p of its points [m].
        """
    @property
    def second_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) second grid axis: n_O x first_O.
        """
    @property
    def triangles(self) -> list[int]:
        """
        Rows of the mesh's triangles.
        """
class Object:
    """
    A rigid polyhedron to be moved: any closed mesh, in a frame O of your choice.
    """
    @staticmethod
    def box(name: str, size: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], mass: typing.SupportsFloat | typing.SupportsIndex) -> Object:
        """
        A box centred at O, sides along the axes, (3,) [m], of uniform density, mass [kg].
        """
    @staticmethod
    def from_mesh(name: str, mesh: typing.Any, mass: typing.SupportsFloat | typing.SupportsIndex) -> Object:
        """
        A closed mesh in O [m], of uniform density, mass [kg]: a geometry.Mesh, a trimesh.Trimesh, or a
        pair of vertices (N, 3) and triangles (M, 3).
        
        Raises ValueError when it is not closed, has no volume or too many triangles.
        """
    def __repr__(self) -> str:
        ...
    def with_com(self, com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Object:
        """
        The same object with another centre of mass, (3,) in O [m].
        """
    def with_inertia(self, inertia_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Object:
        """
        The same object with another inertia about its centre of mass, (3, 3) in O [kg m^2].
        """
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) centre of mass in O [m].
        """
    @property
    def faces(self) -> list[Face]:
        """
        Faces, coplanar neighbours joined.
        """
    @property
    def hull(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) corners of the convex hull, in O [m].
        """
    @property
    def inertia(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (3, 3) about the centre of mass, in O [kg m^2].
        """
    @property
    def is_convex(self) -> bool:
        """
        Whether it is its own hull.
        """
    @property
    def mass(self) -> float:
        """
        [kg].
        """
    @property
    def mesh(self) -> graspless._core.geometry.Mesh:
        """
        Closed, outward, in O.
        """
    @property
    def name(self) -> str:
        """
        What errors and pictures call it.
        """
    @property
    def size(self) -> float:
        """
        Diagonal of the box around it [m].
        """
class Plane:
    """
    Floor or wall: a half-space that the object may touch and fingertips may not.
    """
    def __init__(self, name: str = 'floor', n_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., offset: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        n_W: (3,) unit, out of the solid, in the world. offset: n_W . p of its points [m].
        """
    def __repr__(self) -> str:
        ...
    @property
    def n_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit, out of the solid, in the world.
        """
    @property
    def name(self) -> str:
        """
        What errors and pictures call it.
        """
    @property
    def offset(self) -> float:
        """
        n_W . p of its points [m].
        """
class Fingers:
    """
    The fingertips: equal spheres in one-point contact that do not slide or roll.
    """
    def __init__(self, *, count: typing.SupportsInt | typing.SupportsIndex = 2, radius: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_normal_force: typing.SupportsFloat | typing.SupportsIndex = 10.0, friction: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] = (0.7, 0.7), max_span: typing.SupportsFloat | typing.SupportsIndex = ...) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def count(self) -> int:
        """
        1 to 4.
        """
    @count.setter
    def count(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def friction(self) -> tuple[float, float]:
        """
        Between fingertip and object: a number, or (lower, upper).
        """
    @friction.setter
    def friction(self, arg1: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
    @property
    def max_normal_force(self) -> float:
        """
        f_max of each [N].
        """
    @max_normal_force.setter
    def max_normal_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_span(self) -> float:
        """
        The farthest that two fingertips' centres may be apart [m].
        """
    @max_span.setter
    def max_span(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        [m].
        """
    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Path:
    """
    Poses that the object passes through, along a screw from each to the next.
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
    The object slides and turns on the floor from start to goal, through a lattice of positions and yaws.
    """
    def __init__(self, *, X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., X_WO_goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., lower: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., upper: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., counts: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [30, 30, 30]) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
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
        How many values of x, y and yaw.
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
    The object shall stand at a pose, any face down: the planner finds where to slide it, turn it and
    tumble it over which edges.
    """
    def __init__(self, *, X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., X_WO_goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., slide_step: typing.SupportsFloat | typing.SupportsIndex = 0.01, turn_step: typing.SupportsFloat | typing.SupportsIndex = 0.05236, max_tumbles: typing.SupportsInt | typing.SupportsIndex = 3) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
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
        At most so many.
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
    What is given: bring an object through a motion with fingertips alone.
    """
    def __init__(self, *, object: Object, motion: Path | Lattice | Goal, fingers: Fingers = ..., planes: collections.abc.Sequence[Plane] = ..., friction: typing.SupportsFloat | typing.SupportsIndex | tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] = (0.5, 0.5), obstacles: collections.abc.Sequence[graspless._core.collision.Obstacle] = [], gravity_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = [0, 0, -9.8]) -> None:
        """
        planes: the floor first, then walls. friction: between object and planes, a number or (lower, upper).
        gravity_W: (3,) in the world [m/s^2].
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
        Between object and planes, (lower, upper).
        """
    @property
    def gravity_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) in the world [m/s^2].
        """
    @property
    def motion(self) -> Path | Lattice | Goal:
        """
        A Path, Lattice or Goal; a copy.
        """
    @property
    def object(self) -> Object:
        """
        What is moved.
        """
    @property
    def obstacles(self) -> list[graspless._core.collision.Obstacle]:
        """
        What else stands around.
        """
    @property
    def planes(self) -> list[Plane]:
        """
        The floor first, then walls.
        """
class Search(graspless._named.Named):
    """
    Search algorithms. All find the same cost.
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
    def __init__(self, *, search: Search = Search.fast, locations_per_side: typing.SupportsInt | typing.SupportsIndex = 7, location_spacing: typing.SupportsFloat | typing.SupportsIndex = 0.0, cone_edges: typing.SupportsInt | typing.SupportsIndex = 6, samples_per_arc: typing.SupportsInt | typing.SupportsIndex = 3, min_stability: typing.SupportsFloat | typing.SupportsIndex = 0.5, regrasp_cost: typing.SupportsFloat | typing.SupportsIndex = 100.0, stability_weight: typing.SupportsFloat | typing.SupportsIndex = 0.01, disturbance_directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., compliance: graspless._core.mechanics.Compliance = ..., max_regrasps: typing.SupportsInt | typing.SupportsIndex = 8, threads: typing.SupportsInt | typing.SupportsIndex = 1, max_memory: typing.SupportsFloat | typing.SupportsIndex = 4000000000.0, explain: bool = True) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def compliance(self) -> graspless._core.mechanics.Compliance:
        """
        Springs at the contacts, for nominal forces and compliant_stability.
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
        Search algorithm. All find the same cost.
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
    A finger at one instant.
    """
    def __init__(self, *, touches: bool = True, p_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., mode: graspless._core.mechanics.FingerMode = graspless._core.mechanics.FingerMode.position, commanded_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, nominal_force_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def commanded_force(self) -> float:
        """
        Normal force in force control, else 0 [N].
        """
    @commanded_force.setter
    def commanded_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mode(self) -> graspless._core.mechanics.FingerMode:
        """
        Position or force control.
        """
    @mode.setter
    def mode(self, arg0: graspless._core.mechanics.FingerMode) -> None:
        ...
    @property
    def n_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) into the object, unit.
        """
    @n_O.setter
    def n_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def nominal_force_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) on the object, in O: to feed forward [N].
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
        False while it regrasps.
        """
    @touches.setter
    def touches(self, arg0: bool) -> None:
        ...
class Row:
    """
    One instant of a plan: a sample of an arc, or a regrasp.
    """
    def __init__(self, *, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., fingers: collections.abc.Sequence[FingerState] = [], stability: typing.SupportsFloat | typing.SupportsIndex = 0.0, compliant_stability: typing.SupportsFloat | typing.SupportsIndex = 0.0, nominal_margin: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
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
        See mechanics.compliant_stability [N].
        """
    @compliant_stability.setter
    def compliant_stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fingers(self) -> tuple[FingerState, ...]:
        """
        A FingerState each.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[FingerState]) -> None:
        ...
    @property
    def nominal_margin(self) -> float:
        """
        Of the nominal forces [N].
        """
    @nominal_margin.setter
    def nominal_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stability(self) -> float:
        """
        z [N]; where friction is an interval, the least over the coefficients looked at: min_stability is what is proven for all of it.
        """
    @stability.setter
    def stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Segment:
    """
    A stretch of the plan with the fingers where they are, or one regrasp.
    """
    def __init__(self, name: str, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], rows: collections.abc.Sequence[Row], finger: typing.SupportsInt | typing.SupportsIndex = -1) -> None:
        """
        X_WO: (K, 4, 4) poses of the lattice, first to last. rows: the instants. finger: of a regrasp, who moves.
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
        (K, 4, 4) poses of the lattice in the world, first to last.
        """
    @property
    def finger(self) -> int:
        """
        Of a regrasp: who moves; else -1.
        """
    @property
    def name(self) -> str:
        """
        slide, turn, tumble or regrasp.
        """
    @property
    def rows(self) -> list[Row]:
        """
        The instants, in order.
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
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, locations: typing.SupportsInt | typing.SupportsIndex = 0, z_evaluations: typing.SupportsInt | typing.SupportsIndex = 0, bounded_tests: typing.SupportsInt | typing.SupportsIndex = 0, pivots: typing.SupportsInt | typing.SupportsIndex = 0, ill_conditioned: typing.SupportsInt | typing.SupportsIndex = 0, nodes: typing.SupportsInt | typing.SupportsIndex = 0, supports: typing.SupportsInt | typing.SupportsIndex = 0, candidates: typing.SupportsInt | typing.SupportsIndex = 0, memory: typing.SupportsInt | typing.SupportsIndex = 0) -> None:
        """
        Any field by keyword; the others are zero.
        """
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, typing.Any]:
        """
        All fields by name.
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
        Nodes expanded by the search; for the fast search of a path, placements considered.
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
    What a failed search says of the way out.
    """
    def __init__(self, *, field: str = '', value: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def field(self) -> str:
        """
        fingers.friction, fingers.max_normal_force, friction or min_stability.
        """
    @field.setter
    def field(self, arg0: str) -> None:
        ...
    @property
    def value(self) -> float:
        """
        The least change that helps, to 1 %.
        """
    @value.setter
    def value(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Status(graspless._named.Named):
    """
    How a query ended.
    """
    interrupted = ...
    no_location = ...
    not_realized = ...
    out_of_time = ...
    solved = ...
    unstable = ...
class Plan:
    """
    What was found, or why not. False unless solved.
    """
    def __bool__(self) -> bool:
        """
        Whether it is solved.
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
        By Eqs. (9) and (10) [m].
        """
    @cost.setter
    def cost(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def limit(self) -> str:
        """
        Not solved: what blocks.
        """
    @limit.setter
    def limit(self, arg0: str) -> None:
        ...
    @property
    def lower_bound(self) -> float:
        """
        No plan on this lattice is cheaper [m]; equals cost when optimal.
        """
    @lower_bound.setter
    def lower_bound(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def reason(self) -> str:
        """
        One sentence, for people.
        """
    @reason.setter
    def reason(self, arg0: str) -> None:
        ...
    @property
    def regrasps(self) -> int:
        """
        How often a finger moves to another place.
        """
    @regrasps.setter
    def regrasps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def relaxations(self) -> tuple[Relaxation, ...]:
        """
        Not solved: what would help, alone.
        """
    @relaxations.setter
    def relaxations(self, arg1: collections.abc.Sequence[Relaxation]) -> None:
        ...
    @property
    def segments(self) -> tuple[Segment, ...]:
        """
        Stretches of motion and regrasps, in order.
        """
    @segments.setter
    def segments(self, arg1: collections.abc.Sequence[Segment]) -> None:
        ...
    @property
    def statistics(self) -> Statistics:
        """
        What the search did.
        """
    @statistics.setter
    def statistics(self, arg0: Statistics) -> None:
        ...
    @property
    def status(self) -> Status:
        """
        How the query ended.
        """
    @status.setter
    def status(self, arg0: Status) -> None:
        ...
    @property
    def warnings(self) -> tuple[str, ...]:
        """
        What to be careful of.
        """
    @warnings.setter
    def warnings(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def weakest_row(self) -> int:
        """
        Where z is least; -1 without a plan.
        """
    @weakest_row.setter
    def weakest_row(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def weakest_segment(self) -> int:
        """
        Where z is least; -1 without a plan.
        """
    @weakest_segment.setter
    def weakest_segment(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Carrier:
    """
    Which parts of a robot carry the fingertips.
    """
    def __init__(self, *, fingertips: collections.abc.Sequence[str] = ['left_tip_center', 'right_tip_center'], links: collections.abc.Sequence[collections.abc.Sequence[str]] = [['left_finger'], ['right_finger']]) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def fingertips(self) -> tuple[str, ...]:
        """
        Frames at the centres of the spheres, one a finger.
        """
    @fingertips.setter
    def fingertips(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def links(self) -> tuple[list[str], ...]:
        """
        Of each fingertip: links that may touch the object.
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
    def __init__(self, *, approach: typing.SupportsFloat | typing.SupportsIndex = 0.03, resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_jump: typing.SupportsFloat | typing.SupportsIndex = 0.05, position_tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.0001, restarts: typing.SupportsInt | typing.SupportsIndex = 40, solutions: typing.SupportsInt | typing.SupportsIndex = 8) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
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
        
        Unit: rad. Range: (0, inf). Default: 0.01.
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
    A stretch of joint motion.
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
        The segment of the plan that it carries out, or -1.
        """
    @property
    def positions(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (N, dof) all joints [rad or m].
        """
    @property
    def scrub(self) -> float:
        """
        How far a fingertip that turns slips on its contact, at worst [m].
        """
class Realization:
    """
    Joint paths that carry a plan's fingertips, or where it is impossible.
    """
    def __bool__(self) -> bool:
        """
        Whether there are joint paths.
        """
    def __init__(self, *, found: bool = False, reason: str = '', joint_names: collections.abc.Sequence[str] = [], finger_of_fingertip: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], segments: collections.abc.Sequence[JointSegment] = []) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def finger_of_fingertip(self) -> tuple[int, ...]:
        """
        Which finger of the plan each fingertip plays.
        """
    @finger_of_fingertip.setter
    def finger_of_fingertip(self, arg1: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
    @property
    def found(self) -> bool:
        """
        Whether there are joint paths.
        """
    @found.setter
    def found(self, arg0: bool) -> None:
        ...
    @property
    def joint_names(self) -> tuple[str, ...]:
        """
        The columns of positions.
        """
    @joint_names.setter
    def joint_names(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def reason(self) -> str:
        """
        Which segment, row and finger fails, and why.
        """
    @reason.setter
    def reason(self, arg0: str) -> None:
        ...
    @property
    def segments(self) -> tuple[JointSegment, ...]:
        """
        Stretches of joint motion, in order.
        """
    @segments.setter
    def segments(self, arg1: collections.abc.Sequence[JointSegment]) -> None:
        ...
def check(problem: Problem, plan: Plan, options: Options = ...) -> list[str]:
    """
    Derives every row of a plan anew from its problem, with none of the search's code.
    
    Returns one fault per entry, with segment and row; an empty list if the plan is valid.
    """
def check_realization(problem: Problem, plan: Plan, robot: graspless._core.robot.Robot, carrier: Carrier, realization: Realization, options: RealizeOptions = ...) -> list[str]:
    """
    Replays joint paths against problem and plan: limits, steps, fingertips, collisions.
    
    Each entry says what fails; an empty list means that they hold.
    """
def join(paths: collections.abc.Sequence[Path]) -> Path:
    """
    One path after another; each must start where the last one ended.
    """
def plan(problem: Problem, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans where the fingers press, which holds its position and which its force, and when to change grip.
    Not finding a plan is a status.
    
    Releases the GIL: other Python threads can run. Ctrl-C raises KeyboardInterrupt; budget.stop() ends the query, which then returns the best result so far.
    
    Raises ValueError on a bad problem or bad options.
    """
def realize(problem: Problem, plan: Plan, robot: graspless._core.robot.Robot, carrier: Carrier, q_home: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], options: RealizeOptions = ..., budget: graspless._core.planning.Budget = ...) -> Realization:
    """
    Joint paths that carry a plan's fingertips: from q_home, (dof,), to the first grip, through every row,
    through regrasps, and away; or where that is impossible.
    
    Other Python threads run meanwhile; Ctrl-C raises KeyboardInterrupt.
    Raises ValueError on unknown frames, a home outside the limits or a plan not solved.
    """
def slide_path(X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], translation_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], segments: typing.SupportsInt | typing.SupportsIndex) -> Path:
    """
    A straight slide from X_WO_start, (4, 4), by translation_W, (3,) in the world [m], in equal segments.
    """
def turn_path(X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], point_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], axis_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], angle: typing.SupportsFloat | typing.SupportsIndex, segments: typing.SupportsInt | typing.SupportsIndex) -> Path:
    """
    A turn from X_WO_start, (4, 4), about the line through point_W along axis_W, both (3,) in the world,
    by angle [rad, right hand] in equal segments: a tumble over an edge, or a turn on the floor.
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
    Both, and that the search fits into options.max_memory.
    """
