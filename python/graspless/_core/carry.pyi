"""
Carry a held object along a straight path.
"""
from __future__ import annotations
import collections.abc
import graspless._core.collision
import graspless._core.planning
import graspless._core.robot
import graspless._core.scene
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Options', 'Places', 'Plan', 'Problem', 'Segment', 'Statistics', 'Status', 'certify', 'check', 'plan', 'validate']
class Places:
    """
    Places on an obstacle where a held object may be put down.
    """
    def __init__(self, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], on: str, q_open: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], normal_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = (0, 0, 1), way_out: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64]] = [], down_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = (0, 0, 0)) -> None:
        """
        X_WO: (N, 4, 4) poses of the object in the world, the best first. on: obstacle on which it then stands. q_open: (dof,) configuration
        whose joints outside the arm's group open the hand [rad or m]. normal_W: (3,) unit normal of the obstacle's surface in the world.
        way_out: (N, dof) configurations along which the hand can leave the object, the first with the hand open around it; it leaves it
        along the same way relative to the object, with the same fingers. Without them, it goes straight. down_O: (3,) direction in O in which the object comes down; zero: against the normal.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (N, 4, 4) poses of the object in the world, the best first.
        """
    @property
    def down_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) direction in O in which the object comes down; zero: against the normal.
        """
    @property
    def normal_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal of the obstacle's surface in the world.
        """
    @property
    def on(self) -> str:
        """
        Obstacle on which the object then stands.
        """
    @property
    def q_open(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) configuration whose joints outside the arm's group open the hand [rad or m].
        """
    @property
    def way_out(self) -> list[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]]:
        """
        List of (dof,) configurations along which the hand can leave the object [rad or m]; empty: it goes straight.
        """
class Problem:
    """
    Task of the planner: carry a held object along a straight path to another pose, or put it down.
    """
    def __init__(self, robot: graspless._core.robot.Robot, frame: str, object: graspless._core.collision.Obstacle, X_WO_goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None, q_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], obstacles: collections.abc.Sequence[graspless._core.collision.Obstacle] = [], rests_on: collections.abc.Mapping[str, typing.Annotated[numpy.typing.ArrayLike, numpy.float64]] = {}, arm: str = 'arm', places: Places | None = None, X_WO_hanging: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        frame: link that holds the object. object: its shapes, and its pose at the start.
        X_WO_goal: (4, 4) pose in the world at the end. q_start: (dof,) configuration at the start [rad or m]. rests_on: obstacles that
        the object rests on at the start and may be dragged over, each with its unit normal (3,) in the world. arm: group of the joints that move. places: where the object is put down; X_WO_goal is then None.
        X_WO_hanging: (4, 4) pose of a loose object at the start, as it hangs in the hand.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO_goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"] | None:
        """
        (4, 4) pose of the object in the world at the end; None with places.
        """
    @property
    def X_WO_hanging(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"] | None:
        """
        (4, 4) pose of a loose object at the start, as it hangs in the hand; else None.
        """
    @property
    def arm(self) -> str:
        """
        Group of the joints that move.
        """
    @property
    def frame(self) -> str:
        """
        Link that holds the object.
        """
    @property
    def object(self) -> graspless._core.collision.Obstacle:
        """
        Held object, with its pose at the start.
        """
    @property
    def obstacles(self) -> list[graspless._core.collision.Obstacle]:
        """
        Bodies that neither the arm nor the object may touch.
        """
    @property
    def places(self) -> Places | None:
        """
        Places where the object is put down, or None.
        """
    @property
    def q_start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) configuration at the start [rad or m].
        """
    @property
    def rests_on(self) -> dict[str, typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]]:
        """
        Obstacles that the object rests on at the start, each with its unit normal (3,) in the world; a copy.
        """
    @property
    def robot(self) -> graspless._core.robot.Robot:
        """
        Robot that moves.
        """
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
    def __init__(self, *, step: typing.SupportsFloat | typing.SupportsIndex = 0.005, tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.0005, angle_tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.002, max_twist: typing.SupportsFloat | typing.SupportsIndex = 0.0, contact_depth: typing.SupportsFloat | typing.SupportsIndex = 0.001, height: typing.SupportsFloat | typing.SupportsIndex = 0.06, retreat: typing.SupportsFloat | typing.SupportsIndex = 0.08, max_tilt: typing.SupportsFloat | typing.SupportsIndex = 0.35, resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_memory: typing.SupportsFloat | typing.SupportsIndex = 4000000000.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def angle_tolerance(self) -> float:
        """
        Largest rotation of the object away from the planned attitude.
        
        Unit: rad. Range: [0.0001, 0.5]. Default: 0.002.
        """
    @angle_tolerance.setter
    def angle_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def contact_depth(self) -> float:
        """
        Largest penetration of the object into the obstacles that it rests on.
        
        Unit: m. Range: (0, 0.02]. Default: 0.001.
        """
    @contact_depth.setter
    def contact_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def height(self) -> float:
        """
        With places: length of the straight motion down onto the support.
        
        Unit: m. Range: (0, 0.5]. Default: 0.06.
        """
    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_memory(self) -> float:
        """
        Largest memory that the search may take.
        
        Unit: bytes. Range: (0, inf). Default: 4000000000.0.
        """
    @max_memory.setter
    def max_memory(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_tilt(self) -> float:
        """
        With places: largest angle between the object's vertical on the way and that at the start or at the place, whichever is nearer.
        
        Unit: rad. Range: (0, 3.2]. Default: 0.35.
        """
    @max_tilt.setter
    def max_tilt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_twist(self) -> float:
        """
        Largest rotation of hand and object about the direction of the path, also at its end. 0: none.
        
        Unit: rad. Range: [0, 3.2]. Default: 0.0.
        """
    @max_twist.setter
    def max_twist(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def resolution(self) -> float:
        """
        Largest joint step between checked configurations. check() uses 0.01.
        
        Unit: rad. Range: [0.0001, 0.01]. Default: 0.01.
        """
    @resolution.setter
    def resolution(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def retreat(self) -> float:
        """
        With places: length of the straight motion of the open hand away from the object.
        
        Unit: m. Range: (0, 0.5]. Default: 0.08.
        """
    @retreat.setter
    def retreat(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def step(self) -> float:
        """
        Distance between checked poses along the path.
        
        Unit: m. Range: [0.0001, 0.1]. Default: 0.005.
        """
    @step.setter
    def step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def tolerance(self) -> float:
        """
        Largest distance of the object's origin from the straight path.
        
        Unit: m. Range: [1e-05, 0.05]. Default: 0.0005.
        """
    @tolerance.setter
    def tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Segment:
    """
    Part of a motion. No joint moves by more than 0.05 rad from one row to the next.
    """
    def __init__(self, name: str, positions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], object_poses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        positions: (N, dof) [rad or m]. object_poses: (N, 4, 4) poses of the object in the world.
        """
    def __len__(self) -> int:
        """
        Number of rows.
        """
    def __repr__(self) -> str:
        ...
    @property
    def name(self) -> str:
        """
        carry; with places transfer, lower, open or retreat.
        """
    @property
    def object_poses(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (N, 4, 4) pose of the object in the world at each row.
        """
    @property
    def positions(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (N, dof) all joints [rad or m].
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
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, iterations: typing.SupportsInt | typing.SupportsIndex = 0, ik_calls: typing.SupportsInt | typing.SupportsIndex = 0, collision_checks: typing.SupportsInt | typing.SupportsIndex = 0, refusals: collections.abc.Mapping[str, typing.SupportsInt | typing.SupportsIndex] = {}) -> None:
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
    def collision_checks(self) -> int:
        """
        Configurations checked against every body.
        """
    @collision_checks.setter
    def collision_checks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def ik_calls(self) -> int:
        """
        Calls of the inverse kinematics.
        """
    @ik_calls.setter
    def ik_calls(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def iterations(self) -> int:
        """
        Configurations expanded by the search.
        """
    @iterations.setter
    def iterations(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def refusals(self) -> dict[str, int]:
        """
        Number of rejected steps by reason.
        """
    @refusals.setter
    def refusals(self, arg0: collections.abc.Mapping[str, typing.SupportsInt | typing.SupportsIndex]) -> None:
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
class Status(graspless._named.Named):
    """
    Outcome of a query.
    """
    interrupted = ...
    no_place = ...
    not_found = ...
    out_of_memory = ...
    solved = ...
    start_in_collision = ...
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
    def joint_names(self) -> tuple[str, ...]:
        """
        The robot's joints, in the order of positions.
        """
    @joint_names.setter
    def joint_names(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def place(self) -> int:
        """
        Index of the place where the object is put down; -1: none.
        """
    @place.setter
    def place(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def reached(self) -> float:
        """
        Fraction of the path that was reached, in [0, 1].
        """
    @reached.setter
    def reached(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
    def segments(self) -> tuple[Segment, ...]:
        """
        Segments of the motion, in order.
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
def certify(problem: Problem, plan: Plan, options: Options = ...) -> graspless._core.scene.EdgeCertificate:
    """
    Proves what check() samples between the rows: nothing touches that may not, and the object keeps to its straight path, or tilts no more than it may.
    
    Returns a scene.EdgeCertificate. Raises ValueError if the plan is not solved or malformed.
    """
def check(problem: Problem, plan: Plan, options: Options = ...) -> list[str]:
    """
    Checks a plan against its problem by an independent replay.
    
    Returns one fault per entry, with segment and row; an empty list if the plan is valid.
    """
def plan(problem: Problem, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans a motion of the arm that carries the object along a straight path to its goal, or puts it down at a place.
    
    Finding no plan is a status, not an error.
    
    Releases the GIL: other Python threads can run. Ctrl-C raises KeyboardInterrupt; budget.stop() ends the query, which then returns the best result so far.
    
    Raises ValueError on a bad problem or bad options.
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
