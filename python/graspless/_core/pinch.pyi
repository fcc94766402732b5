"""
Pinch an object where it stands.
"""
from __future__ import annotations
import collections.abc
import graspless._core.planning
import graspless._core.scene
import graspless._core.slide
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Options', 'Plan', 'Segment', 'Statistics', 'Status', 'certify', 'check', 'plan', 'validate']
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
    def __init__(self, *, friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, margin: typing.SupportsFloat | typing.SupportsIndex = 0.002, clearance: typing.SupportsFloat | typing.SupportsIndex = 0.0015, max_lever: typing.SupportsFloat | typing.SupportsIndex = 0.08, grip_force: typing.SupportsFloat | typing.SupportsIndex | None = None, patch: typing.SupportsFloat | typing.SupportsIndex = 0.008, depth: typing.SupportsFloat | typing.SupportsIndex = 0.01, height: typing.SupportsFloat | typing.SupportsIndex | None = None, opening: typing.SupportsFloat | typing.SupportsIndex | None = None, approach: typing.SupportsFloat | typing.SupportsIndex = 0.08, grasps: typing.SupportsInt | typing.SupportsIndex = 300, resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_memory: typing.SupportsFloat | typing.SupportsIndex = 4000000000.0) -> None:
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
        Length of the straight motion of the open hand onto the object. Half of it, where the arm cannot follow all of it.
        
        Unit: m. Range: (0, 0.5]. Default: 0.08.
        """
    @approach.setter
    def approach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def clearance(self) -> float:
        """
        Least height of the fingers above the support, and of the object's top above the contacts.
        
        Unit: m. Range: [0, 0.05]. Default: 0.0015.
        """
    @clearance.setter
    def clearance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def depth(self) -> float:
        """
        Distance of the contacts from the ends of the pads, at most half the length of a pad. With 0.003, low objects can be pinched.
        
        Unit: m. Range: (0, 0.1]. Default: 0.01.
        """
    @depth.setter
    def depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def friction(self) -> float:
        """
        Largest coefficient of friction that the pinch may need: the tangent of the angle between the closing direction and a face's normal.
        
        Range: (0, 10]. Default: 0.5.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def grasps(self) -> int:
        """
        Largest number of hand poses that are tried.
        
        Range: [1, 100000]. Default: 300.
        """
    @grasps.setter
    def grasps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def grip_force(self) -> float | None:
        """
        Force of each finger once the hand has closed. By default that of half the effort limits of the joints that close the hand.
        
        Unit: N. Range: (0, 1000].
        """
    @grip_force.setter
    def grip_force(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def height(self) -> float | None:
        """
        Height of the contacts over the support that is tried first, or the nearest to it at which the fingers fit. By default half the thickness. Those of walls are found.
        
        Unit: m. Range: [0, 10].
        """
    @height.setter
    def height(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def margin(self) -> float:
        """
        Least gap between the object and each finger of the open hand that comes to it. Where a jaw opens less, the hand comes aside by what is missing and goes sideways at the end.
        
        Unit: m. Range: [0, 0.05]. Default: 0.002.
        """
    @margin.setter
    def margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_lever(self) -> float:
        """
        Largest distance of the centre of mass from the line through both contacts, seen from above, of an object without heights.
        
        Unit: m. Range: [0, 1]. Default: 0.08.
        """
    @max_lever.setter
    def max_lever(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
    def opening(self) -> float | None:
        """
        Distance between the fingers of the hand that comes to the object: less room is needed beside a wall. By default, and at most, as far as the hand opens.
        
        Unit: m. Range: (0, 1].
        """
    @opening.setter
    def opening(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def patch(self) -> float:
        """
        Half length of a pad's contact, which bears the weight. A wall of an object with heights rises by as much above the contacts.
        
        Unit: m. Range: (0, 0.1]. Default: 0.008.
        """
    @patch.setter
    def patch(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
        approach, grasp or close.
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
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, iterations: typing.SupportsInt | typing.SupportsIndex = 0, faces: typing.SupportsInt | typing.SupportsIndex = 0, ik_calls: typing.SupportsInt | typing.SupportsIndex = 0, collision_checks: typing.SupportsInt | typing.SupportsIndex = 0, refusals: collections.abc.Mapping[str, typing.SupportsInt | typing.SupportsIndex] = {}) -> None:
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
    def faces(self) -> int:
        """
        Pairs of opposite faces that fit the hand.
        """
    @faces.setter
    def faces(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
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
        Hand poses that were tried.
        """
    @iterations.setter
    def iterations(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def refusals(self) -> dict[str, int]:
        """
        Number of rejected hand poses by reason.
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
    no_room = ...
    not_reached = ...
    out_of_memory = ...
    solved = ...
    start_in_collision = ...
    too_flat = ...
    too_heavy = ...
    too_slippery = ...
    too_wide = ...
    unknown_force = ...
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
    def X_WH_grasp(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the grasp frame H in the world at the pinch.
        """
    @X_WH_grasp.setter
    def X_WH_grasp(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def contacts_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (2, 3) contacts of the fingers in O [m]; (0, 3) unless solved.
        """
    @contacts_O.setter
    def contacts_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def friction(self) -> float:
        """
        Coefficient of friction that the pinch needs: the tangent of the larger angle between the closing direction and the normal of a face.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
    def max_mass(self) -> float | None:
        """
        Largest mass that the pads hold [kg]; None if nobody knows the force of the hand.
        """
    @max_mass.setter
    def max_mass(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def opening(self) -> float:
        """
        Distance between the fingers of the open hand [m].
        """
    @opening.setter
    def opening(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
def certify(problem: graspless._core.slide.Problem, plan: Plan, options: Options = ...) -> graspless._core.scene.EdgeCertificate:
    """
    Proves what check() samples between the rows: nothing touches that may not.
    
    Returns a scene.EdgeCertificate. Raises ValueError if the plan is not solved or malformed.
    """
def check(problem: graspless._core.slide.Problem, plan: Plan, options: Options = ...) -> list[str]:
    """
    Checks a plan against its problem by an independent replay.
    
    Returns one fault per entry, with segment and row; an empty list if the plan is valid.
    """
def plan(problem: graspless._core.slide.Problem, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans the motion: approach, grasp and close.
    
    Finding no plan is a status, not an error.
    
    Releases the GIL: other Python threads can run. Ctrl-C raises KeyboardInterrupt; budget.stop() ends the query, which then returns the best result so far.
    
    Raises ValueError on a bad problem or bad options.
    """
@typing.overload
def validate(problem: graspless._core.slide.Problem) -> None:
    """
    Raises ValueError that names the first bad field, its value and what is allowed.
    """
@typing.overload
def validate(options: Options) -> None:
    """
    Raises ValueError that names the first bad option, its value and what is allowed.
    """
