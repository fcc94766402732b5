"""
Put a hand through a hole of an object and close it (Stork, Pokorny, Kragic).
"""
from __future__ import annotations
import collections.abc
import graspless._core.collision
import graspless._core.geometry
import graspless._core.planning
import graspless._core.robot
import graspless._core.scene
import graspless._named
import numpy
import numpy.typing
import os
import typing
__all__: list[str] = ['Certificate', 'CertificateOptions', 'CurveNode', 'Finger', 'Hand', 'Hang', 'Object', 'Options', 'Pinch', 'Plan', 'Problem', 'Segment', 'Stability', 'StabilityOptions', 'Statistics', 'Status', 'Tree', 'certificate', 'certify', 'check', 'find_hang', 'hand_from_yaml', 'hand_from_yaml_file', 'plan', 'sample_object', 'sample_object_names', 'test_pinch', 'test_stability', 'validate', 'with_palm_corners']
class CurveNode:
    """
    A corner of a finger curve, fixed to a link.
    """
    def __init__(self, *, link: str = '', p_L: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def link(self) -> str:
        """
        Name of a link of the robot.
        """
    @link.setter
    def link(self, arg0: str) -> None:
        ...
    @property
    def p_L(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) position in the link's frame [m].
        """
    @p_L.setter
    def p_L(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class Finger:
    """
    A finger: the corners of its part of the finger curve, from the palm to the tip.
    """
    def __init__(self, *, name: str = '', nodes: collections.abc.Sequence[CurveNode] = []) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def name(self) -> str:
        """
        Name used in error messages and pictures.
        """
    @name.setter
    def name(self, arg0: str) -> None:
        ...
    @property
    def nodes(self) -> tuple[CurveNode, ...]:
        """
        CurveNodes from the palm to the tip.
        """
    @nodes.setter
    def nodes(self, arg1: collections.abc.Sequence[CurveNode]) -> None:
        ...
class Hand:
    """
    Description of a hand for the planner (Stork, Pokorny, Kragic 2013, Section IV-B).
    
    Names of links, groups and states refer to the robot. Every finger opposes the thumb:
    finger curve i runs from the tip of finger i to the palm and along the thumb to its tip.
    """
    def __init__(self, *, arm: str = 'arm', hand: str = 'hand', frame: str = 'palm', forward_H: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., sideways_H: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., fingers: collections.abc.Sequence[Finger] = [], thumb: Finger = ..., open: str = 'open', pre_shapes: collections.abc.Sequence[str] = [], closed: str = 'closed') -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def arm(self) -> str:
        """
        Group of the joints that carry the hand, base to wrist.
        """
    @arm.setter
    def arm(self, arg0: str) -> None:
        ...
    @property
    def closed(self) -> str:
        """
        State towards which the joints close.
        """
    @closed.setter
    def closed(self, arg0: str) -> None:
        ...
    @property
    def fingers(self) -> tuple[Finger, ...]:
        """
        Fingers that oppose the thumb.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[Finger]) -> None:
        ...
    @property
    def forward_H(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit vector towards the handle, in H (v_fwd).
        """
    @forward_H.setter
    def forward_H(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def frame(self) -> str:
        """
        Link of the palm, H.
        """
    @frame.setter
    def frame(self, arg0: str) -> None:
        ...
    @property
    def hand(self) -> str:
        """
        Group of the joints that close the hand.
        """
    @hand.setter
    def hand(self, arg0: str) -> None:
        ...
    @property
    def open(self) -> str:
        """
        State of the hand's joints at the start of the search: pre-shape.
        """
    @open.setter
    def open(self, arg0: str) -> None:
        ...
    @property
    def pre_shapes(self) -> tuple[str, ...]:
        """
        States of further pre-shapes. The search tries them, in turn with the first, if it has clasped nothing in 20 cycles a loop.
        """
    @pre_shapes.setter
    def pre_shapes(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def sideways_H(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit vector along the handle, in H (v_swd).
        """
    @sideways_H.setter
    def sideways_H(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def thumb(self) -> Finger:
        """
        Finger that the others oppose.
        """
    @thumb.setter
    def thumb(self, arg0: Finger) -> None:
        ...
class Object:
    """
    An object known from a point cloud: its loops (Stork, Pokorny, Kragic 2013,
    Section IV-A), and its surface at the cloud's own resolution as collision model.
    """
    @staticmethod
    def from_cloud(name: str, p_OP: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], options: graspless._core.geometry.LoopOptions = ..., rays: collections.abc.Sequence[graspless._core.geometry.RayImage] = []) -> Object:
        """
        Finds the loops of a cloud and builds its collision model.
        
        Parameters
        ----------
        name : str
            Name used in error messages and pictures.
        p_OP : (N, 3) array
            Points on the surface, in O [m].
        options : geometry.LoopOptions, optional
        rays : list of geometry.RayImage, optional
            Rays of the cameras that saw the points, in O. See geometry.shortest_loops.
        
        Returns
        -------
        Object
            An object without a reliable hole is valid; plan() reports it as a status.
        
        Raises
        ------
        ValueError
            As geometry.shortest_loops.
        """
    def __repr__(self) -> str:
        ...
    @property
    def loop_options(self) -> graspless._core.geometry.LoopOptions:
        """
        geometry.LoopOptions used to find the loops; a copy.
        """
    @property
    def loops(self) -> graspless._core.geometry.Loops:
        """
        geometry.Loops in O; a copy.
        """
    @property
    def name(self) -> str:
        """
        Name used in error messages and pictures.
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) input cloud, in O [m].
        """
    @property
    def rays(self) -> list[graspless._core.geometry.RayImage]:
        """
        geometry.RayImages that decided which loops are holes, in O; a copy.
        """
    @property
    def spacing(self) -> float:
        """
        Median distance of neighbouring points of the surface [m].
        """
    @property
    def surface(self) -> graspless._core.geometry.Mesh:
        """
        Collision surface, in O [m]: the triangles of loops.surface, and narrow ones for edges and points without a triangle.
        """
class Problem:
    """
    A clasp planning problem: put the hand through a hole of the object and close it.
    """
    def __init__(self, robot: graspless._core.robot.Robot, hand: Hand, object: Object, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], obstacles: collections.abc.Sequence[graspless._core.collision.Obstacle] = [], loops: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], marks: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, pull_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        Parameters
        ----------
        robot : robot.Robot
        hand : Hand
        object : Object
        X_WO : (4, 4) array
            Pose of the object in W.
        q_start : (dof,) array
            Start configuration of all joints [rad or m].
        obstacles : list of Obstacle, optional
        loops : list of int, optional
            Indices in object.loops.found of the loops that may be clasped; empty: all.
        marks : (N, 3) array, optional
            Points in O [m]. The hand clasps at the loop points nearest to them; none: anywhere.
        pull_W : (3,) array, optional
            Direction in W in which the clasped object will be pulled. Unsuitable targets are excluded.
        
        Raises
        ------
        ValueError
            If a shape is wrong. plan() validates the values.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the object in W.
        """
    @property
    def hand(self) -> Hand:
        """
        A copy of the hand.
        """
    @property
    def loops(self) -> list[int]:
        """
        Indices of the loops that may be clasped; empty: all.
        """
    @property
    def marks(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) points in O near which to clasp [m]; none: anywhere.
        """
    @property
    def object(self) -> Object:
        """
        The object to clasp.
        """
    @property
    def obstacles(self) -> list[graspless._core.collision.Obstacle]:
        """
        Obstacles in W.
        """
    @property
    def pull_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"] | None:
        """
        (3,) direction of the later pull in W, or None.
        """
    @property
    def q_start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) start configuration [rad or m].
        """
    @property
    def robot(self) -> graspless._core.robot.Robot:
        """
        The robot.
        """
class StabilityOptions:
    """
    Options of the stability test (Stork, Pokorny, Kragic 2013, Section V-A).
    
    The hand does not move. The object makes random moves, each until it hits the hand.
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __copy__(self) -> StabilityOptions:
        """
        Returns a copy.
        """
    def __deepcopy__(self, memo: typing.Any) -> StabilityOptions:
        """
        Returns a copy.
        """
    def __init__(self, *, sequences: typing.SupportsInt | typing.SupportsIndex = 10, moves: typing.SupportsInt | typing.SupportsIndex = 500, step: typing.SupportsFloat | typing.SupportsIndex = 0.002, turn: typing.SupportsFloat | typing.SupportsIndex = 0.01, penetration: typing.SupportsFloat | typing.SupportsIndex = 0.003, escape_distance: typing.SupportsFloat | typing.SupportsIndex = 0.0, force: typing.SupportsFloat | typing.SupportsIndex = 2.5, torque: typing.SupportsFloat | typing.SupportsIndex = 0.15, seed: typing.SupportsInt | typing.SupportsIndex = 1, threads: typing.SupportsInt | typing.SupportsIndex = 1) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def escape_distance(self) -> float:
        """
        The object has escaped when every point of the loop is farther than this from the hand's centre. 0: half the length of the longest finger curve, the reach of any hand.
        
        Unit: m. Range: [0, 10]. Default: 0.0.
        """
    @escape_distance.setter
    def escape_distance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def force(self) -> float:
        """
        Force on the object, in any direction, that the motors of the hand should withstand when it acts suddenly. A hand of two fingers must. At least the object's weight; the default is that of 250 g.
        
        Unit: N. Range: [0, 1e+06]. Default: 2.5.
        """
    @force.setter
    def force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def moves(self) -> int:
        """
        Number of moves in a sequence: translations and rotations in turn.
        
        Range: [1, 10000]. Default: 500.
        """
    @moves.setter
    def moves(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def penetration(self) -> float:
        """
        Depth of penetration that does not count as a collision.
        
        Unit: m. Range: [0, 0.05]. Default: 0.003.
        """
    @penetration.setter
    def penetration(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def seed(self) -> int:
        """
        Seed of the random moves.
        
        Range: [0, inf). Default: 1.
        """
    @seed.setter
    def seed(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def sequences(self) -> int:
        """
        Number of sequences of random moves, each starting from the clasp.
        
        Range: [1, 1000]. Default: 10.
        """
    @sequences.setter
    def sequences(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def step(self) -> float:
        """
        Length of a translation between two collision tests.
        
        Unit: m. Range: [0.0001, 0.1]. Default: 0.002.
        """
    @step.setter
    def step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def threads(self) -> int:
        """
        Number of threads that share sequences and loads. Results do not depend on it.
        
        Range: [1, 256]. Default: 1.
        """
    @threads.setter
    def threads(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def torque(self) -> float:
        """
        Moment about the mean of the object's points that they should withstand together with the force. Where both are 0, forces are not tested.
        
        Unit: Nm. Range: [0, 1e+06]. Default: 0.15.
        """
    @torque.setter
    def torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def turn(self) -> float:
        """
        Angle of a rotation about the hand's centre between two collision tests.
        
        Unit: rad. Range: [0.001, 1]. Default: 0.01.
        """
    @turn.setter
    def turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Stability:
    """
    Result of the stability test.
    """
    def __init__(self, *, secure: bool = False, escapes: typing.SupportsInt | typing.SupportsIndex = 0, withstands: typing.SupportsFloat | typing.SupportsIndex = 0.0, opens_first: str = '', margin: typing.SupportsFloat | typing.SupportsIndex = 0.0, checks: typing.SupportsInt | typing.SupportsIndex = 0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def checks(self) -> int:
        """
        Number of poses checked.
        """
    @checks.setter
    def checks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def escapes(self) -> int:
        """
        Number of sequences in which the loop escaped.
        """
    @escapes.setter
    def escapes(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def margin(self) -> float:
        """
        1: the object cannot move; 0 or less: it escaped.
        """
    @margin.setter
    def margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def opens_first(self) -> str:
        """
        The joint that gives way first; empty if none does.
        """
    @opens_first.setter
    def opens_first(self, arg0: str) -> None:
        ...
    @property
    def secure(self) -> bool:
        """
        True if the loop escaped in no sequence and, for a hand of two fingers, if its motors withstand the load.
        """
    @secure.setter
    def secure(self, arg0: bool) -> None:
        ...
    @property
    def withstands(self) -> float:
        """
        Largest force that may act suddenly in any direction, with moments in proportion as in the options, before a joint of the hand gives way at its effort limit [N]; 1e6 if none does, 0 if that was not tested or the loop escaped.
        """
    @withstands.setter
    def withstands(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Pinch:
    """
    Result of the test of a pinch.
    """
    def __init__(self, *, holds: bool = False, strength: typing.SupportsFloat | typing.SupportsIndex = 0.0, press: typing.SupportsFloat | typing.SupportsIndex = 0.0, load: typing.SupportsFloat | typing.SupportsIndex = 0.0, gap: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def gap(self) -> float:
        """
        Gap between the object and the finger that is farther from it [m].
        """
    @gap.setter
    def gap(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def holds(self) -> bool:
        """
        True if both fingers touch, and their forces resist every wrench, and the whole load.
        """
    @holds.setter
    def holds(self, arg0: bool) -> None:
        ...
    @property
    def load(self) -> float:
        """
        Largest multiple of the load, acting suddenly, that friction resists at that force.
        """
    @load.setter
    def load(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def press(self) -> float:
        """
        Normal force of each finger at half the effort limits of the joints [N].
        """
    @press.setter
    def press(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def strength(self) -> float:
        """
        Largest force in any direction that is resisted for each newton of a finger.
        """
    @strength.setter
    def strength(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Hang:
    """
    Pose in which an object hangs in a closed hand that carries it.
    """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world where it comes to rest.
        """
    @property
    def drop(self) -> float:
        """
        Distance by which the mean of its surface is lower there [m].
        """
    @property
    def holds(self) -> bool:
        """
        True if the hand holds it up.
        """
    @property
    def swing(self) -> float:
        """
        Angle by which it is turned there [rad].
        """
class CertificateOptions:
    """
    Options of certificate().
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __copy__(self) -> CertificateOptions:
        """
        Returns a copy.
        """
    def __deepcopy__(self, memo: typing.Any) -> CertificateOptions:
        """
        Returns a copy.
        """
    def __init__(self, *, tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.002, moves: typing.SupportsInt | typing.SupportsIndex = 1000, seed: typing.SupportsInt | typing.SupportsIndex = 1) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def moves(self) -> int:
        """
        Largest number of moves of the object in the search for a way out. 0: no search; the upper bound needs none.
        
        Range: [0, 100000]. Default: 1000.
        """
    @moves.setter
    def moves(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def seed(self) -> int:
        """
        Seed of the moves.
        
        Range: [0, inf). Default: 1.
        """
    @seed.setter
    def seed(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def tolerance(self) -> float:
        """
        Width of the interval at which the search for a way out ends.
        
        Unit: m. Range: [0.0001, 0.1]. Default: 0.002.
        """
    @tolerance.setter
    def tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Certificate:
    """
    Bounds on the opening through which a loop can leave a hand that does not move.
    
    The opening is the largest clearance that the object can keep from the hand on its way out
    [m]. If it is negative, the object must enter the hand as deep as that.
    """
    def __init__(self, *, caged: bool = False, lower: typing.SupportsFloat | typing.SupportsIndex = 0.0, upper: typing.SupportsFloat | typing.SupportsIndex = 0.0, thickness: typing.SupportsFloat | typing.SupportsIndex = 0.0, gap: typing.SupportsFloat | typing.SupportsIndex = 0.0, between: typing.Annotated[collections.abc.Sequence[str], "FixedSize(2)"] = ['', ''], moves: typing.SupportsInt | typing.SupportsIndex = 0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def between(self) -> typing.Annotated[list[str], "FixedSize(2)"]:
        """
        Links on both sides of the gap.
        """
    @between.setter
    def between(self, arg0: typing.Annotated[collections.abc.Sequence[str], "FixedSize(2)"]) -> None:
        ...
    @property
    def caged(self) -> bool:
        """
        True if upper is below 0: no motion takes the loop out of the hand.
        """
    @caged.setter
    def caged(self, arg0: bool) -> None:
        ...
    @property
    def gap(self) -> float:
        """
        Widest gap in the ring of the hand [m]; negative where its balls overlap.
        """
    @gap.setter
    def gap(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def lower(self) -> float:
        """
        Clearance on a way out that was found [m].
        """
    @lower.setter
    def lower(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def moves(self) -> int:
        """
        Number of moves that were tried.
        """
    @moves.setter
    def moves(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def thickness(self) -> float:
        """
        Diameter of a ball that fits into the object all along the loop [m]; 0: nothing is known to be inside the object there.
        """
    @thickness.setter
    def thickness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def upper(self) -> float:
        """
        Proven bound [m]; 1e6 if no ring of the hand is linked with the loop.
        """
    @upper.setter
    def upper(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
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
    def __init__(self, *, min_linking: typing.SupportsFloat | typing.SupportsIndex = 0.0, targets: typing.SupportsInt | typing.SupportsIndex = 0, attract: bool = False, resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01, friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, stability: StabilityOptions = ..., certificate: CertificateOptions = ..., must_be_secure: bool = True, max_memory: typing.SupportsFloat | typing.SupportsIndex = 4000000000.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def attract(self) -> bool:
        """
        Attract an open hand by the Gauss integral of the open curves while it is not linked.
        
        Default: False.
        """
    @attract.setter
    def attract(self, arg0: bool) -> None:
        ...
    @property
    def certificate(self) -> CertificateOptions:
        """
        Options of the bounds on the opening through which the loop could leave the closed hand.
        """
    @certificate.setter
    def certificate(self, arg0: CertificateOptions) -> None:
        ...
    @property
    def friction(self) -> float:
        """
        Coefficient of friction between the object and a hand of two fingers. Such a hand may also pinch a bar that could slip out without friction. 0: it may not.
        
        Range: [0, 10]. Default: 0.5.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
    def min_linking(self) -> float:
        """
        Virtual linking in (0, 1) that every finger curve must reach before the hand closes, and must keep. 0: the hand closes as soon as every curve is linked, and the closed hand must come half way from its open state to what it reaches around a bar as thick as the loop's handle. The plan reports the value used.
        
        Range: [0, 1). Default: 0.0.
        """
    @min_linking.setter
    def min_linking(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def must_be_secure(self) -> bool:
        """
        Accept a clasp only if it passes the stability test or is a pinch that friction holds; otherwise the search continues.
        
        Default: True.
        """
    @must_be_secure.setter
    def must_be_secure(self, arg0: bool) -> None:
        ...
    @property
    def resolution(self) -> float:
        """
        Largest joint step between checked configurations. At most 0.01, the step of check().
        
        Unit: rad. Range: [0.0001, 0.01]. Default: 0.01.
        """
    @resolution.setter
    def resolution(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stability(self) -> StabilityOptions:
        """
        Options of the stability test.
        
        Paper: Section V-A.
        """
    @stability.setter
    def stability(self, arg0: StabilityOptions) -> None:
        ...
    @property
    def targets(self) -> int:
        """
        Number of clasp targets on a loop. 0: one every half width of the hand, from 4 to 64.
        
        Range: [0, 10000]. Default: 0.
        """
    @targets.setter
    def targets(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Segment:
    """
    Part of a motion. No joint moves by more than 0.05 rad from one row to the next.
    """
    def __init__(self, name: str, positions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], virtual_linking: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        positions: (N, dof) [rad or m]. virtual_linking: (N, curves).
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
        reach or close.
        """
    @property
    def positions(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (N, dof) all joints [rad or m].
        """
    @property
    def virtual_linking(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (N, curves) |VLk| of every finger curve with the loop clasped, at each row.
        """
class Tree:
    """
    The search tree that contains the clasp, for visualisation.
    """
    def __init__(self, p_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, parents: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], path: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = []) -> None:
        """
        p_W: (N, 3) [m]. parents: (N,) node indices. path: node indices from the root to the clasp.
        """
    def __len__(self) -> int:
        """
        Number of nodes.
        """
    def __repr__(self) -> str:
        ...
    @property
    def p_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3) centre of the finger curves at every node, in W [m].
        """
    @property
    def parents(self) -> list[int]:
        """
        Index of every node's parent; the root is its own parent.
        """
    @property
    def path(self) -> list[int]:
        """
        Indices of the nodes from the root to the clasp.
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
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, stability_seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, certificate_seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, cycles: typing.SupportsInt | typing.SupportsIndex = 0, nodes: typing.SupportsInt | typing.SupportsIndex = 0, restarts: typing.SupportsInt | typing.SupportsIndex = 0, control_steps: typing.SupportsInt | typing.SupportsIndex = 0, collision_checks: typing.SupportsInt | typing.SupportsIndex = 0, fcl_checks: typing.SupportsInt | typing.SupportsIndex = 0, stability_tests: typing.SupportsInt | typing.SupportsIndex = 0, refusals: collections.abc.Mapping[str, typing.SupportsInt | typing.SupportsIndex] = {}) -> None:
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
    def certificate_seconds(self) -> float:
        """
        Part of the wall-clock time that was spent on the certificate.
        
        Unit: s.
        """
    @certificate_seconds.setter
    def certificate_seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def collision_checks(self) -> int:
        """
        Configurations checked.
        """
    @collision_checks.setter
    def collision_checks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def control_steps(self) -> int:
        """
        TS-CONTROL steps.
        
        Paper: Algorithm 4.
        """
    @control_steps.setter
    def control_steps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def cycles(self) -> int:
        """
        Cycles of Algorithm 1 after the pre-expansions, over all trees.
        """
    @cycles.setter
    def cycles(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def fcl_checks(self) -> int:
        """
        Checks of a link against the object by FCL, where the clearance left it open.
        """
    @fcl_checks.setter
    def fcl_checks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def nodes(self) -> int:
        """
        Nodes of all trees.
        """
    @nodes.setter
    def nodes(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def refusals(self) -> dict[str, int]:
        """
        Number of rejected targets, connections and clasps by reason.
        """
    @refusals.setter
    def refusals(self, arg0: collections.abc.Mapping[str, typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
    @property
    def restarts(self) -> int:
        """
        Number of trees given up.
        """
    @restarts.setter
    def restarts(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
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
    def stability_seconds(self) -> float:
        """
        Part of the wall-clock time that was spent in stability tests.
        
        Unit: s.
        """
    @stability_seconds.setter
    def stability_seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stability_tests(self) -> int:
        """
        Stability tests run.
        """
    @stability_tests.setter
    def stability_tests(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Status(graspless._named.Named):
    """
    Outcome of a query.
    """
    hole_too_narrow = ...
    interrupted = ...
    no_reliable_hole = ...
    no_target_in_reach = ...
    not_found = ...
    not_secure = ...
    out_of_memory = ...
    solved = ...
    start_in_collision = ...
    too_thick = ...
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
    def certificate(self) -> Certificate | None:
        """
        Certificate of the last row, or None if no time was left; a copy.
        """
    @certificate.setter
    def certificate(self, arg1: Certificate | None) -> None:
        ...
    @property
    def fingers(self) -> tuple[str, ...]:
        """
        Names of the fingers that clasp the loop together with the thumb.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[str]) -> None:
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
    def loop(self) -> int:
        """
        Index of the clasped loop in object.loops.found; -1 without a plan.
        """
    @loop.setter
    def loop(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def min_linking(self) -> float:
        """
        Threshold of virtual linking that the plan fulfils.
        """
    @min_linking.setter
    def min_linking(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pinch(self) -> Pinch | None:
        """
        Result of the test of a pinch at the last row, if only friction holds; or None.
        """
    @pinch.setter
    def pinch(self, arg1: Pinch | None) -> None:
        ...
    @property
    def pre_shape(self) -> str:
        """
        Pre-shape with which the search began, a state of the hand's joints; empty in old plans: hand.open. The hand may be partly closed when it arrives.
        """
    @pre_shape.setter
    def pre_shape(self, arg0: str) -> None:
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
    def stability(self) -> Stability:
        """
        Result of the stability test at the last row; a copy.
        """
    @stability.setter
    def stability(self, arg0: Stability) -> None:
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
    def target(self) -> graspless._core.geometry.ClaspTarget:
        """
        Clasped geometry.ClaspTarget, in O; a copy.
        """
    @target.setter
    def target(self, arg0: graspless._core.geometry.ClaspTarget) -> None:
        ...
    @property
    def tree(self) -> Tree:
        """
        Search tree that contains the clasp; a copy.
        """
    @tree.setter
    def tree(self, arg0: Tree) -> None:
        ...
    @property
    def warnings(self) -> tuple[str, ...]:
        """
        Warnings about the plan.
        """
    @warnings.setter
    def warnings(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
def certificate(problem: Problem, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], loop: typing.SupportsInt | typing.SupportsIndex, options: CertificateOptions = ...) -> Certificate:
    """
    Bounds the opening through which a loop can leave the hand, which does not move.
    
    The upper bound is proven: a ring of the hand is linked with the loop, and the object is thicker
    than the widest gap of the ring by twice the amount below 0. The lower bound is the clearance on
    a way out that random moves found.
    
    Parameters
    ----------
    problem : Problem
    q : (dof,) array
        Configuration of all joints [rad or m].
    loop : int
        Index in problem.object.loops.found.
    options : CertificateOptions, optional
    
    Returns
    -------
    Certificate
    
    Raises
    ------
    ValueError
        If the problem, the loop, the configuration or an option is invalid.
    """
def certify(problem: Problem, plan: Plan, options: Options = ...) -> graspless._core.scene.EdgeCertificate:
    """
    Proves what check() samples between the rows: nothing touches.
    
    Returns a scene.EdgeCertificate. Raises ValueError if the plan is not solved or malformed.
    """
def check(problem: Problem, plan: Plan, options: Options = ...) -> list[str]:
    """
    Replays a plan without the code of the search, and returns its faults: joint limits,
    collisions, linking by the double integral, closing until contact, and the stability test.
    
    Returns one fault per entry, with segment and row; an empty list if the plan is valid.
    """
def find_hang(problem: Problem, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], loop: typing.SupportsInt | typing.SupportsIndex) -> Hang:
    """
    Lets the object sink by its own weight, without friction, until the closed hand holds it up.
    
    The weight acts on the mean of the points of the object's surface. Nothing else touches the object, and no joint
    gives way.
    
    Parameters
    ----------
    problem : Problem
    q : (dof,) array
        Configuration of all joints [rad or m].
    loop : int
        Index in problem.object.loops.found.
    
    Returns
    -------
    Hang
    
    Raises
    ------
    ValueError
        If the problem, the loop or the configuration is invalid.
    """
def hand_from_yaml(text: str, what: str = 'hand') -> Hand:
    """
    Reads a hand from YAML. docs/task-files.md has the grammar.
    
    Parameters
    ----------
    text : str
        YAML document.
    what : str, optional
        Name used in error messages.
    
    Returns
    -------
    Hand
    
    Raises
    ------
    ValueError
        Names the line, the field, the value and the choices.
    """
def hand_from_yaml_file(path: os.PathLike[str] | str) -> Hand:
    """
    Reads a hand from a YAML file; see hand_from_yaml. The folder urdf/ has examples.
    """
def plan(problem: Problem, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans a motion of arm and hand that ends in a clasp: reach, then close until contact
    (Stork, Pokorny, Kragic 2013, Section IV). Failure to find a plan is a status.
    
    Releases the GIL: other Python threads can run. Ctrl-C raises KeyboardInterrupt; budget.stop() ends the query, which then returns the best result so far.
    
    Raises ValueError on a bad problem or bad options.
    """
def sample_object(name: str, scale: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> list[graspless._core.geometry.PlacedShape]:
    """
    Shapes of a sample object, standing on the floor z = 0 of O.
    
    Parameters
    ----------
    name : str
        One of sample_object_names().
    scale : float, optional
        Factor on the real size, in (0, 1000].
    
    Returns
    -------
    list of geometry.PlacedShape
        In O [m].
    
    Raises
    ------
    ValueError
        Lists the names, or states the range of `scale`.
    """
def sample_object_names() -> list[str]:
    """
    Names of the sample objects with holes: purse, bag, travel_bag, lawn_mower, chair.
    """
def test_pinch(problem: Problem, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, options: StabilityOptions = ...) -> Pinch:
    """
    Tests if friction holds the object between the two fingers of a hand.
    
    Each finger presses with 1 N on two points of its contact with the object's surface.
    
    Parameters
    ----------
    problem : Problem
        Its hand has one finger besides the thumb.
    q : (dof,) array
        Configuration of all joints [rad or m].
    friction : float, optional
        Coefficient of friction, in [0, 10].
    options : StabilityOptions, optional
        Force and torque of the load.
    
    Returns
    -------
    Pinch
    
    Raises
    ------
    ValueError
        If the problem, the hand, the configuration, the friction or the load is invalid, or a
        joint of the hand has no effort limit.
    """
def test_stability(problem: Problem, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], loop: typing.SupportsInt | typing.SupportsIndex, options: StabilityOptions = ...) -> Stability:
    """
    Tests if a loop stays in the hand: random moves try to separate object and hand.
    
    Stork, Pokorny, Kragic 2013, Section V-A.
    
    Parameters
    ----------
    problem : Problem
    q : (dof,) array
        Configuration of all joints [rad or m].
    loop : int
        Index in problem.object.loops.found.
    options : StabilityOptions, optional
    
    Returns
    -------
    Stability
    
    Raises
    ------
    ValueError
        If the problem, the loop, the configuration or an option is invalid.
    """
@typing.overload
def validate(hand: Hand, robot: graspless._core.robot.Robot) -> None:
    """
    Raises ValueError if the hand does not fit the robot; names the field, the value and the choices.
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
def with_palm_corners(hand: Hand, robot: graspless._core.robot.Robot) -> Hand:
    """
    Adds corners in the palm to fingers whose joints move their first corners against it.
    
    Fingers of a parallel gripper need them. Other hands are returned as they are.
    
    Parameters
    ----------
    hand : Hand
    robot : robot.Robot
    
    Returns
    -------
    Hand
    
    Raises
    ------
    ValueError
        If a link, group or state is unknown.
    """
