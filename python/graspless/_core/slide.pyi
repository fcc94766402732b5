"""
Slide a thin object to the edge of its support and grasp it.
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
import typing
__all__: list[str] = ['FingerModel', 'Hand', 'Interruption', 'Object', 'Options', 'Plan', 'Problem', 'Search', 'Segment', 'Statistics', 'Status', 'Support', 'Surroundings', 'Tube', 'Turning', 'center_of_mass', 'certify', 'check', 'depth_band', 'plan', 'restart', 'resume', 'tube', 'turning', 'validate']
class Object:
    """
    An object that lies or stands on a support: a prism over its outline. Slides take thin ones only.
    
    Its frame O has z up, the underside in the plane z = 0.
    """
    @staticmethod
    def from_cloud(name: str, p_OP: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], thickness: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> Object:
        """
        Creates an object from points on its top surface, (N, 3) in O [m]: P_o of Hang et al. 2019, Section IV-A. The thickness [m] is their median height unless given. The centre of mass is their mean, at half the thickness. The mass is 0.05 kg: see with_mass.
        
        Raises ValueError if there are fewer than three points, if they are not finite or lie on a line, or if the object is not thin.
        """
    @staticmethod
    def from_polygon(name: str, outline: graspless._core.geometry.Polygon | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], thickness: typing.SupportsFloat | typing.SupportsIndex, spacing: typing.SupportsFloat | typing.SupportsIndex = 0.006) -> Object:
        """
        Creates an object from its outline, a Polygon or (N, 2) in O [m], and its thickness [m].
        
        Contact points form a grid of `spacing` [m]. The centre of mass is the centroid of the outline, at half the thickness. The mass is 0.05 kg: see with_mass.
        
        Raises ValueError on a bad outline, or on a thickness over three quarters of the object's width.
        """
    @staticmethod
    def prism(name: str, outline: graspless._core.geometry.Polygon | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], thickness: typing.SupportsFloat | typing.SupportsIndex, spacing: typing.SupportsFloat | typing.SupportsIndex = 0.006) -> Object:
        """
        Creates an object of any height, which may be pinched. Arguments as those of from_polygon.
        
        Raises ValueError on a bad outline or thickness.
        """
    def __repr__(self) -> str:
        ...
    def scaled(self, scale: typing.SupportsFloat | typing.SupportsIndex) -> Object:
        """
        Returns a copy scaled in its plane. Thickness and mass stay the same.
        """
    def with_com(self, com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Object:
        """
        Returns a copy with another centre of mass, (3,) in O [m].
        
        Raises ValueError outside the object: beside the convex hull of its outline, below 0 or above the thickness.
        """
    def with_heights(self, heights_O: graspless._core.geometry.HeightMap) -> Object:
        """
        Returns a copy that is as high as a geometry.HeightMap in O, and no longer a prism.
        
        Raises ValueError if the map is higher than the thickness.
        """
    def with_hollow(self, is_hollow: bool) -> Object:
        """
        Returns a copy whose underside may be hollow, or is flat.
        """
    def with_mass(self, mass: typing.SupportsFloat | typing.SupportsIndex) -> Object:
        """
        Returns a copy with another mass [kg].
        """
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) centre of mass in O [m].
        """
    @property
    def heights(self) -> graspless._core.geometry.HeightMap | None:
        """
        geometry.HeightMap of the object in O; None if it is a prism.
        """
    @property
    def is_hollow(self) -> bool:
        """
        True if the underside may be hollow: the object may rest on the rim of its outline alone.
        """
    @property
    def is_thin(self) -> bool:
        """
        True if the thickness is at most three quarters of the least width.
        """
    @property
    def mass(self) -> float:
        """
        Mass [kg]; 0.05 by default.
        """
    @property
    def name(self) -> str:
        """
        Name in errors and pictures.
        """
    @property
    def outline(self) -> graspless._core.geometry.Polygon:
        """
        Polygon in O [m].
        """
    @property
    def points(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (N, 2) contact points, x-y in O [m].
        """
    @property
    def shapes(self) -> list[graspless._core.geometry.PlacedShape]:
        """
        PlacedShapes in O: prisms over the outline's convex parts, or columns of the heights.
        """
    @property
    def thickness(self) -> float:
        """
        Thickness, that of the highest part [m].
        """
    @property
    def top(self) -> float:
        """
        Height of the face on which a finger presses [m]: the thickness of a prism, or that of the level part of the heights that has the most points.
        """
class Support:
    """
    A flat surface to slide on: a polygon in the plane z = 0 of its frame S, z up.
    """
    def __init__(self, polygon: graspless._core.geometry.Polygon | typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WS: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], slab: typing.SupportsFloat | typing.SupportsIndex = 0.04, band_width: typing.SupportsFloat | typing.SupportsIndex = 0.06, friction: typing.SupportsFloat | typing.SupportsIndex = 0.3, usable_edges: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] | None = None) -> None:
        """
        polygon: a Polygon or (N, 2) [m]. X_WS: (4, 4) pose in the world, tilted by at most 60 degrees.
        slab: thickness of the table top [m]. band_width: width of the band along the edges where slides may end [m]. friction: coefficient of friction between object and support, in [1e-6, 10000].
        usable_edges: indices of the polygon's edges over which objects may stick out; by default all. Edge i runs from vertex i to the next, counter-clockwise.
        
        Raises ValueError that names the argument.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WS(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @property
    def friction(self) -> float:
        """
        Coefficient of friction between object and support.
        """
    @property
    def goal_band(self) -> graspless._core.geometry.Band:
        """
        Band of the polygon where slides may end, in S: P_g of the paper.
        """
    @property
    def normal_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal in the world, out of the surface.
        """
    @property
    def polygon(self) -> graspless._core.geometry.Polygon:
        """
        Polygon of the surface in S [m]: Q of the paper.
        """
    @property
    def shapes(self) -> list[graspless._core.geometry.PlacedShape]:
        """
        PlacedShapes in S, below z = 0.
        """
    @property
    def slab(self) -> float:
        """
        Thickness of the table top [m].
        """
    @property
    def usable_edges(self) -> tuple[int, ...]:
        """
        Indices of the polygon's edges over which objects may stick out.
        """
class FingerModel(graspless._named.Named):
    """
    Model of how the sliding finger yields when it presses on the object.
    """
    flexure = ...
    impedance = ...
    none = ...
    rigid_guarded = ...
class Hand:
    """
    Description of the hand: links, frames, groups and states of the robot, and its sliding pad.
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __copy__(self) -> Hand:
        """
        Returns a copy.
        """
    def __deepcopy__(self, memo: typing.Any) -> Hand:
        """
        Returns a copy.
        """
    def __init__(self, *, arm: str = 'arm', fingertip: str = 'left_fingertip', sliding_finger: collections.abc.Sequence[str] = ['left_finger'], fingers: collections.abc.Sequence[str] = ['left_finger', 'right_finger'], grasp_frame: str = 'grasp', open: str = 'open', closed: str = 'closed', finger_model: FingerModel = FingerModel.flexure, flexure_length: typing.SupportsFloat | typing.SupportsIndex = 0.11, tip_radius: typing.SupportsFloat | typing.SupportsIndex = 0.005, flexure_stiffness: typing.SupportsFloat | typing.SupportsIndex = 4.6, wrist_stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, press_force: typing.SupportsFloat | typing.SupportsIndex = 9.0, pad_width: typing.SupportsFloat | typing.SupportsIndex = 0.032, pad_friction: typing.SupportsFloat | typing.SupportsIndex = 1.16) -> None:
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
        Group of joints that carry the hand, base to wrist.
        """
    @arm.setter
    def arm(self, arg0: str) -> None:
        ...
    @property
    def closed(self) -> str:
        """
        State that the hand closes towards, until it touches the object.
        """
    @closed.setter
    def closed(self, arg0: str) -> None:
        ...
    @property
    def finger_model(self) -> FingerModel:
        """
        Model of how the sliding finger yields when it presses on the object.
        """
    @finger_model.setter
    def finger_model(self, arg0: FingerModel) -> None:
        ...
    @property
    def fingers(self) -> tuple[str, ...]:
        """
        Links that close on the object.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def fingertip(self) -> str:
        """
        Frame F: X along the line contact, Z out of the tip, Y towards the other finger.
        """
    @fingertip.setter
    def fingertip(self, arg0: str) -> None:
        ...
    @property
    def flexure_length(self) -> float:
        """
        Distance from the flexure to the tip.
        
        Unit: m. Range: (0, 1]. Default: 0.11.
        """
    @flexure_length.setter
    def flexure_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def flexure_stiffness(self) -> float:
        """
        Stiffness of the flexure.
        
        Unit: Nm/rad. Range: (0, 1000]. Default: 4.6.
        """
    @flexure_stiffness.setter
    def flexure_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def grasp_frame(self) -> str:
        """
        Frame H: origin between the open tips, Z out of the hand, Y from finger to finger.
        """
    @grasp_frame.setter
    def grasp_frame(self, arg0: str) -> None:
        ...
    @property
    def open(self) -> str:
        """
        State of the hand's joints while it slides and reaches.
        """
    @open.setter
    def open(self, arg0: str) -> None:
        ...
    @property
    def pad_friction(self) -> float:
        """
        Coefficient of friction between pad and object.
        
        Range: (0, 10]. Default: 1.16.
        """
    @pad_friction.setter
    def pad_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pad_width(self) -> float:
        """
        Length of the line contact.
        
        Unit: m. Range: (0, 0.2]. Default: 0.032.
        """
    @pad_width.setter
    def pad_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def press_force(self) -> float:
        """
        Normal force that a finger without a flexure presses with.
        
        Unit: N. Range: (0, 1000]. Default: 9.0.
        """
    @press_force.setter
    def press_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def sliding_finger(self) -> tuple[str, ...]:
        """
        Links that may press into object and support.
        """
    @sliding_finger.setter
    def sliding_finger(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def tip_radius(self) -> float:
        """
        Radius of the pad that rolls on the object.
        
        Unit: m. Range: (0, 0.1]. Default: 0.005.
        """
    @tip_radius.setter
    def tip_radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def wrist_stiffness(self) -> float:
        """
        Stiffness of the arm's impedance control in translation. finger_model impedance needs it.
        
        Unit: N/m. Range: [0, 100000]. Default: 0.0.
        """
    @wrist_stiffness.setter
    def wrist_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Problem:
    """
    Task of the planner: slide the object to an edge of the support and grasp it there; or to X_WO_end, and leave it there.
    """
    def __init__(self, robot: graspless._core.robot.Robot, hand: Hand, object: Object, support: Support, X_WO_start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q_home: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], obstacles: collections.abc.Sequence[graspless._core.collision.Obstacle] = [], X_WO_end: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        X_WO_start: (4, 4) pose of the object, flat on the support. q_home: (dof,) configuration at the start [rad or m]. obstacles: bodies that neither arm nor object may touch. X_WO_end: (4, 4) pose at which the object is left, flat on the support; by default it is grasped over an edge.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO_end(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"] | None:
        """
        (4, 4) pose in the world at which the object is left; None: it is grasped.
        """
    @property
    def X_WO_start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the object in the world.
        """
    @property
    def hand(self) -> Hand:
        """
        Hand of the robot; a copy.
        """
    @property
    def object(self) -> Object:
        """
        Thin object to slide.
        """
    @property
    def obstacles(self) -> list[graspless._core.collision.Obstacle]:
        """
        Bodies that neither the arm nor the sliding object may touch.
        """
    @property
    def q_home(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) configuration at the start [rad or m].
        """
    @property
    def robot(self) -> graspless._core.robot.Robot:
        """
        Robot that moves.
        """
    @property
    def support(self) -> Support:
        """
        Surface that the object lies on.
        """
class Search(graspless._named.Named):
    """
    Search algorithms.
    """
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
    def __init__(self, *, search: Search = Search.fast, pitch: typing.SupportsFloat | typing.SupportsIndex = 0.7853981633974483, pitch_tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.1, min_depth: typing.SupportsFloat | typing.SupportsIndex | None = None, max_depth: typing.SupportsFloat | typing.SupportsIndex | None = None, root_scale: typing.SupportsFloat | typing.SupportsIndex = 100.0, min_overhang: typing.SupportsFloat | typing.SupportsIndex = 0.02, com_margin: typing.SupportsFloat | typing.SupportsIndex = 0.01, tip_margin: typing.SupportsFloat | typing.SupportsIndex = 0.01, rim_margin: typing.SupportsFloat | typing.SupportsIndex = 0.005, lift_height: typing.SupportsFloat | typing.SupportsIndex = 0.08, grasp_approach: typing.SupportsFloat | typing.SupportsIndex = 0.06, deep_grasp: bool = False, refuse_lag: bool = True, friction_spread: typing.SupportsFloat | typing.SupportsIndex = 0.3, mass_spread: typing.SupportsFloat | typing.SupportsIndex = 0.2, com_spread: typing.SupportsFloat | typing.SupportsIndex = 0.005, pad_spread: typing.SupportsFloat | typing.SupportsIndex = 0.0, thickness_spread: typing.SupportsFloat | typing.SupportsIndex = 0.2, height_spread: typing.SupportsFloat | typing.SupportsIndex = 0.003, flexure_spread: typing.SupportsFloat | typing.SupportsIndex = 0.2, position_spread: typing.SupportsFloat | typing.SupportsIndex = 0.003, angle_spread: typing.SupportsFloat | typing.SupportsIndex = 0.0349, tracking_spread: typing.SupportsFloat | typing.SupportsIndex = 0.001, range: typing.SupportsFloat | typing.SupportsIndex = 0.1, resolution: typing.SupportsFloat | typing.SupportsIndex = 0.01, max_memory: typing.SupportsFloat | typing.SupportsIndex = 4000000000.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def angle_spread(self) -> float:
        """
        Uncertainty of the object's orientation at the start.
        
        Unit: rad. Range: [0, inf). Default: 0.0349.
        """
    @angle_spread.setter
    def angle_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def com_margin(self) -> float:
        """
        Least distance of the centre of mass from the edge, on the support. In simulation the lift tipped some objects at 2 mm and none at 10 mm; the paper uses 0.
        
        Unit: m. Range: [0, inf). Default: 0.01.
        """
    @com_margin.setter
    def com_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def com_spread(self) -> float:
        """
        Uncertainty of the object's centre of mass.
        
        Unit: m. Range: [0, inf). Default: 0.005.
        """
    @com_spread.setter
    def com_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def deep_grasp(self) -> bool:
        """
        Grasp as near to the support's edge as the hand can, where the weight turns the object least in it. The paper's hand closes in the middle of what sticks out.
        
        Default: False.
        """
    @deep_grasp.setter
    def deep_grasp(self, arg0: bool) -> None:
        ...
    @property
    def flexure_spread(self) -> float:
        """
        Uncertainty of hand.flexure_length and hand.flexure_stiffness, each: a fraction of it.
        
        Range: [0, 1). Default: 0.2.
        """
    @flexure_spread.setter
    def flexure_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def friction_spread(self) -> float:
        """
        Uncertainty of hand.pad_friction and of support.friction, each: a fraction of it.
        
        Range: [0, 1). Default: 0.3.
        """
    @friction_spread.setter
    def friction_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def grasp_approach(self) -> float:
        """
        Length of the hand's straight final motion.
        
        Unit: m. Range: (0, 1]. Default: 0.06.
        """
    @grasp_approach.setter
    def grasp_approach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def height_spread(self) -> float:
        """
        Uncertainty of the height of the support.
        
        Unit: m. Range: [0, inf). Default: 0.003.
        """
    @height_spread.setter
    def height_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def lift_height(self) -> float:
        """
        Clearance above the object before the hand moves around to grasp it.
        
        Unit: m. Range: (0, 1]. Default: 0.08.
        """
    @lift_height.setter
    def lift_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mass_spread(self) -> float:
        """
        Uncertainty of the object's mass: a fraction of it.
        
        Range: [0, 1). Default: 0.2.
        """
    @mass_spread.setter
    def mass_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_depth(self) -> float | None:
        """
        Largest depth of the commanded fingertip below the object's top face. At least min_depth. By default that of hand.finger_model.
        
        Unit: m. Range: [0, 0.1). Paper: Delta_Z^+.
        """
    @max_depth.setter
    def max_depth(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
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
    def min_depth(self) -> float | None:
        """
        Least depth of the commanded fingertip below the object's top face. By default that of hand.finger_model.
        
        Unit: m. Range: [0, 0.1). Paper: Delta_Z^-.
        """
    @min_depth.setter
    def min_depth(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def min_overhang(self) -> float:
        """
        Least length of the object beyond the edge that the hand can grasp.
        
        Unit: m. Range: (0, inf). Default: 0.02. Paper: u*.
        """
    @min_overhang.setter
    def min_overhang(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pad_spread(self) -> float:
        """
        Part of the pad's length that may not bear, because the object is uneven or tilted: the rest of it may be at either end.
        
        Range: [0, 1). Default: 0.0.
        """
    @pad_spread.setter
    def pad_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pitch(self) -> float:
        """
        Angle between the finger and the surface.
        
        Unit: rad. Range: (0, 1.5708). Default: 0.7853981633974483. Paper: beta_0.
        """
    @pitch.setter
    def pitch(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pitch_tolerance(self) -> float:
        """
        Largest deviation from the pitch while the object slides. The pitch must stay within (0, pi/2).
        
        Unit: rad. Range: (0, 0.785398). Default: 0.1. Paper: Delta_beta.
        """
    @pitch_tolerance.setter
    def pitch_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def position_spread(self) -> float:
        """
        Uncertainty of the object's position at the start.
        
        Unit: m. Range: [0, inf). Default: 0.003.
        """
    @position_spread.setter
    def position_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def range(self) -> float:
        """
        Longest step of ConstrainedExtend, as the Euclidean norm over the joints.
        
        Unit: rad. Range: (0, 1]. Default: 0.1.
        """
    @range.setter
    def range(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def refuse_lag(self) -> bool:
        """
        Refuse slides in which the object may lag so far behind the finger, by the friction of pad and support, that the hand does not grasp it or the support does not hold it.
        
        Default: True.
        """
    @refuse_lag.setter
    def refuse_lag(self, arg0: bool) -> None:
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
    def rim_margin(self) -> float:
        """
        Least distance of the contact from the object's outline at the start, at most half of the largest that the object allows. In simulation a pad that pressed on a rim lost the object.
        
        Unit: m. Range: [0, inf). Default: 0.005.
        """
    @rim_margin.setter
    def rim_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def root_scale(self) -> float:
        """
        Scale of the number of roots: larger values add roots more often.
        
        Range: (0, inf). Default: 100.0. Paper: N*, Eq. (5).
        """
    @root_scale.setter
    def root_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def search(self) -> Search:
        """
        Search algorithm.
        """
    @search.setter
    def search(self, arg0: Search) -> None:
        ...
    @property
    def thickness_spread(self) -> float:
        """
        Uncertainty of the object's thickness: a fraction of it.
        
        Range: [0, 1). Default: 0.2.
        """
    @thickness_spread.setter
    def thickness_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def tip_margin(self) -> float:
        """
        Least distance of the fingertip's contact from the edge, on the support.
        
        Unit: m. Range: [0, inf). Default: 0.01.
        """
    @tip_margin.setter
    def tip_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def tracking_spread(self) -> float:
        """
        Error with which the arm follows the plan while it presses.
        
        Unit: m. Range: [0, inf). Default: 0.001.
        """
    @tracking_spread.setter
    def tracking_spread(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
        approach, press, slide, lift, reach, grasp, close or retreat.
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
    def __init__(self, *, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, iterations: typing.SupportsInt | typing.SupportsIndex = 0, nodes: typing.SupportsInt | typing.SupportsIndex = 0, start_roots: typing.SupportsInt | typing.SupportsIndex = 0, goal_roots: typing.SupportsInt | typing.SupportsIndex = 0, collision_checks: typing.SupportsInt | typing.SupportsIndex = 0, projections: typing.SupportsInt | typing.SupportsIndex = 0, ik_calls: typing.SupportsInt | typing.SupportsIndex = 0, pairs: typing.SupportsInt | typing.SupportsIndex = 0, refusals: collections.abc.Mapping[str, typing.SupportsInt | typing.SupportsIndex] = {}) -> None:
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
    def goal_roots(self) -> int:
        """
        Roots of the goal forest.
        
        Paper: N_g.
        """
    @goal_roots.setter
    def goal_roots(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
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
        Iterations of Algorithm 1.
        """
    @iterations.setter
    def iterations(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def nodes(self) -> int:
        """
        Nodes in both forests.
        """
    @nodes.setter
    def nodes(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def pairs(self) -> int:
        """
        Start-goal pairs validated.
        """
    @pairs.setter
    def pairs(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def projections(self) -> int:
        """
        Projections of a configuration onto the contact constraint.
        """
    @projections.setter
    def projections(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def refusals(self) -> dict[str, int]:
        """
        Rejected roots and pairs by reason: "start: reach", "pair: overhang".
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
    @property
    def start_roots(self) -> int:
        """
        Roots of the start forest.
        
        Paper: N_s.
        """
    @start_roots.setter
    def start_roots(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Status(graspless._named.Named):
    """
    Outcome of a query.
    """
    cannot_drag = ...
    contact_lost = ...
    interrupted = ...
    no_goal_root = ...
    no_start_root = ...
    no_valid_pair = ...
    not_connected = ...
    off_support = ...
    out_of_memory = ...
    solved = ...
    start_in_collision = ...
class Interruption:
    """
    State in which a slide was interrupted, with the finger pressed on the object.
    """
    def __init__(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WO_goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        q: (dof,) commanded joints [rad or m]. X_WO: (4, 4) measured pose of the object in the world. X_WO_goal: (4, 4) pose at the goal of the plan that was interrupted.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) measured pose of the object in the world.
        """
    @property
    def X_WO_goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"] | None:
        """
        (4, 4) pose of the object at the goal of the plan that was interrupted, or None.
        """
    @property
    def q(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) commanded joints [rad or m].
        """
class Tube:
    """
    Bounds on where the object can be, relative to the plan, at each row of the slide.
    """
    def __init__(self, *, position: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [], angle: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = []) -> None:
        """
        Sets any field by keyword; the others are empty.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def angle(self) -> tuple[float, ...]:
        """
        Largest angles of the object from its planned orientation [rad].
        """
    @angle.setter
    def angle(self, arg1: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
    @property
    def position(self) -> tuple[float, ...]:
        """
        Largest distances of the object's origin from its planned position [m].
        """
    @position.setter
    def position(self, arg1: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
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
        (4, 4) pose of the grasp frame H in the world at the grasp; the identity for a problem with an end, which has no grasp.
        """
    @X_WH_grasp.setter
    def X_WH_grasp(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def X_WO_goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the object in the world after the slide.
        """
    @X_WO_goal.setter
    def X_WO_goal(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
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
        Largest mass that the fingers bear when they lift the object [kg]. None for a problem with an end, and if a joint that must bear it has no effort limit, or one that is a placeholder: a finger would press with more than 500 N.
        """
    @max_mass.setter
    def max_mass(self, arg1: typing.SupportsFloat | typing.SupportsIndex | None) -> None:
        ...
    @property
    def overhang(self) -> float:
        """
        Length of the object beyond the edge at the goal [m]; 0 for a problem with an end.
        """
    @overhang.setter
    def overhang(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
    def resumed(self) -> Interruption | None:
        """
        Interruption from which the plan goes on; None if it begins at the problem's q_home.
        """
    @resumed.setter
    def resumed(self, arg1: Interruption | None) -> None:
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
    @property
    def tube(self) -> Tube:
        """
        Bounds on where the object can be at each row of the slide; empty: not stated.
        """
    @tube.setter
    def tube(self, arg0: Tube) -> None:
        ...
    @property
    def warnings(self) -> tuple[str, ...]:
        """
        Warnings about the plan.
        """
    @warnings.setter
    def warnings(self, arg1: collections.abc.Sequence[str]) -> None:
        ...
class Turning:
    """
    Turn rates of a plan's slide, per distance that the object moves.
    """
    def __init__(self, *, max_turn_rate: typing.SupportsFloat | typing.SupportsIndex = 0.0, allowed_turn_rate: typing.SupportsFloat | typing.SupportsIndex = 0.0, lag: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Sets any field by keyword; the others are zero.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def allowed_turn_rate(self) -> float:
        """
        Turn rate that the pad can impose everywhere [rad/m].
        """
    @allowed_turn_rate.setter
    def allowed_turn_rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def lag(self) -> float:
        """
        Angle by which the object may lag behind the finger in total [rad].
        """
    @lag.setter
    def lag(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_turn_rate(self) -> float:
        """
        Largest turn rate of the slide [rad/m].
        """
    @max_turn_rate.setter
    def max_turn_rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Surroundings:
    """
    Bodies that a robot must not touch while it follows a slide: support, obstacles, and itself.
    
    Contacts between robot and object are not looked at. The object must not touch obstacles.
    """
    def __init__(self, problem: Problem, options: Options = ...) -> None:
        """
        The finger may press on the support as deep as in a plan with these options.
        
        Raises ValueError that names the field of a bad problem.
        """
    def __repr__(self) -> str:
        ...
    def touching(self, segment: str, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], rise: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> list[str]:
        """
        Returns the names of touching pairs, "a - b".
        
        segment: of a plan; decides which contacts are allowed. q: (dof,) joints [rad or m]. X_WO: (4, 4) pose of the object. rise: of the support along its normal [m].
        
        Raises ValueError that names the argument.
        """
def center_of_mass(points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], masses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
    """
    Returns the centre of mass, (3,) [m], of point masses at points, (N, 3) [m], with masses (N,).
    
    Raises ValueError unless the masses are not negative and have a positive sum.
    """
def certify(problem: Problem, plan: Plan, options: Options = ...) -> graspless._core.scene.EdgeCertificate:
    """
    Proves what check() samples between the rows: nothing touches that may not, and the fingertip, its contact and the hand keep their bands.
    
    Returns a scene.EdgeCertificate. Raises ValueError if the plan is not solved or malformed.
    """
def check(problem: Problem, plan: Plan, options: Options = ...) -> list[str]:
    """
    Checks a plan against its problem by an independent replay.
    
    Returns one fault per entry, with segment and row; an empty list if the plan is valid.
    """
def depth_band(hand: Hand, options: Options = ...) -> tuple[float, float]:
    """
    Returns the least and the largest depth of the commanded fingertip below the object's top face [m]: those of the options, or of the finger's model.
    """
def plan(problem: Problem, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans the motion: approach, press, slide, lift, reach, grasp and close (Hang et al. 2019, Section IV-C).
    
    Finding no plan is a status, not an error.
    
    Releases the GIL: other Python threads can run. Ctrl-C raises KeyboardInterrupt; budget.stop() ends the query, which then returns the best result so far.
    
    Raises ValueError on a bad problem or bad options.
    """
def restart(problem: Problem, at: Interruption, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans an interrupted slide anew: retreat, approach, press, slide, lift, reach, grasp and close.
    
    A state from which no slide can begin is a status.
    
    Raises ValueError on a bad problem, options or interruption.
    """
def resume(problem: Problem, at: Interruption, options: Options = ..., budget: graspless._core.planning.Budget = ...) -> Plan:
    """
    Plans the rest of an interrupted slide, without lifting the finger: slide, lift, reach, grasp and close.
    
    A state from which no slide can go on is a status: off_support, contact_lost or start_in_collision.
    
    Raises ValueError on a bad problem, options or interruption.
    """
def tube(problem: Problem, plan: Plan, options: Options = ...) -> Tube:
    """
    Returns where the object can be during a plan's slide: a Tube.
    
    Model: its motion under ellipsoidal limit surfaces of pad and support (Howe, Cutkosky 1996) is integrated for the friction, press, mass and centre of mass that the spreads of the options allow. Empty if there is no slide.
    """
def turning(problem: Problem, plan: Plan) -> Turning:
    """
    Returns how fast a plan's slide turns, and how fast the pad's friction can turn the object.
    
    Model: ellipsoidal limit surfaces of pad and support (Howe, Cutkosky 1996).
    """
@typing.overload
def validate(problem: Problem, options: Options) -> None:
    """
    Also requires that the finger can yield by the depth, and that its shapes fit its tip frame.
    
    Raises ValueError that names the field.
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
