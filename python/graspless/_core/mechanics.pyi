"""
Contacts with friction: forces that balance, and how much more they can.
"""
from __future__ import annotations
import collections.abc
import enum
import numpy
import numpy.typing
import typing
__all__: list[str] = ['BodyState', 'Compliance', 'Contact', 'ContactMode', 'ContactPatches', 'ContactSet', 'ControlModes', 'Engine', 'Equilibrium', 'Finger', 'FingerMode', 'FrictionInterval', 'FrictionVerdict', 'Plane', 'Stability', 'best_control_modes', 'compliant_equilibrium', 'compliant_stability', 'contact_patches', 'contact_sets', 'disturbance_directions', 'friction_cone', 'gravity_wrench', 'holds_over_friction', 'interior_equilibrium', 'internal_force_is_bounded', 'max_stability', 'normalized', 'tangent', 'validate', 'wrench_scale']
class ContactMode(enum.Enum):
    """
    How the object moves at a contact.
    """
    slide = ...
    stick = ...
class FingerMode(enum.Enum):
    """
    How a finger is controlled.
    """
    force = ...
    position = ...
class Contact:
    """
    A point where the object touches its environment.
    """
    def __init__(self, *, p_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, mode: ContactMode = ContactMode.stick, t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        p_OC: (3,) [m]. n_O: (3,) normal into the object. friction: coefficient.
        
        t_O: (3,) along the surface. Sliding: where the object moves to there. Sticking: the first edge of the friction cone.
        """
    def __repr__(self) -> str:
        ...
    @property
    def friction(self) -> float:
        """
        Coefficient of friction.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mode(self) -> ContactMode:
        """
        Whether it sticks or slides.
        """
    @mode.setter
    def mode(self, arg0: ContactMode) -> None:
        ...
    @property
    def n_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal into the object, in O.
        """
    @n_O.setter
    def n_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def p_OC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) where, in O [m].
        """
    @p_OC.setter
    def p_OC(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def t_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) direction of sliding or of the cone's first edge, in O; zero: any.
        """
    @t_O.setter
    def t_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class Finger:
    """
    A fingertip that does not slide on the object.
    """
    def __init__(self, *, p_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, max_normal_force: typing.SupportsFloat | typing.SupportsIndex = 10.0, t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        p_OC: (3,) [m]. n_O: (3,) normal into the object. friction: coefficient. max_normal_force: [N].
        
        t_O: (3,) first edge of the friction cone, along the surface.
        """
    def __repr__(self) -> str:
        ...
    @property
    def friction(self) -> float:
        """
        Coefficient of friction.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_normal_force(self) -> float:
        """
        Limit of the normal force [N].
        """
    @max_normal_force.setter
    def max_normal_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def n_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal into the object, in O.
        """
    @n_O.setter
    def n_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def p_OC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) where, in O [m].
        """
    @p_OC.setter
    def p_OC(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def t_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) the cone's first edge, in O; zero: any.
        """
    @t_O.setter
    def t_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class ContactSet:
    """
    All that touches an object at one instant of a slow motion, in its frame O.
    """
    def __init__(self, *, contacts: collections.abc.Sequence[Contact], fingers: collections.abc.Sequence[Finger], com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, known_wrench_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, wrench_scale: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, cone_edges: typing.SupportsInt | typing.SupportsIndex = 6) -> None:
        """
        contacts, fingers: Contacts and Fingers, at most four of these. com_O: (3,) centre of mass [m], zero unless given.
        known_wrench_O: (6,) force and moment about the centre of mass, such as gravity_wrench() [N, N m], zero unless given.
        wrench_scale: (6, 6) what wrenches are measured by, wrench_scale(); the identity unless given. cone_edges: of each friction cone.
        """
    def __repr__(self) -> str:
        ...
    @property
    def com_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) centre of mass in O [m].
        """
    @com_O.setter
    def com_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def cone_edges(self) -> int:
        """
        Edges of each friction cone.
        """
    @cone_edges.setter
    def cone_edges(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def contacts(self) -> tuple[Contact, ...]:
        """
        With the environment; copies.
        """
    @contacts.setter
    def contacts(self, arg1: collections.abc.Sequence[Contact]) -> None:
        ...
    @property
    def fingers(self) -> tuple[Finger, ...]:
        """
        Copies.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[Finger]) -> None:
        ...
    @property
    def known_wrench_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        (6,) known wrench in O about the centre of mass [N, N m].
        """
    @known_wrench_O.setter
    def known_wrench_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def wrench_scale(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"]:
        """
        (6, 6) what a wrench in O about the centre of mass is multiplied with to be measured.
        """
    @wrench_scale.setter
    def wrench_scale(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class Plane:
    """
    A half-space that the object rests on: floor or wall.
    """
    def __init__(self, *, name: str = 'floor', n_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, offset: typing.SupportsFloat | typing.SupportsIndex = 0.0, friction: typing.SupportsFloat | typing.SupportsIndex = 0.5) -> None:
        """
        n_W: (3,) unit normal out of the solid, upward unless given. offset: n_W . p of its points [m]. friction: coefficient.
        """
    def __repr__(self) -> str:
        ...
    @property
    def friction(self) -> float:
        """
        Coefficient of friction.
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def n_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) unit normal out of the solid, in the world.
        """
    @n_W.setter
    def n_W(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        What errors call it.
        """
    @name.setter
    def name(self, arg0: str) -> None:
        ...
    @property
    def offset(self) -> float:
        """
        n_W . p of its points [m].
        """
    @offset.setter
    def offset(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class BodyState:
    """
    How an object stands and moves at one instant.
    """
    def __init__(self, *, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., twist_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, at_rest: bool = False) -> None:
        """
        X_WO: (4, 4). twist_W: (6,) velocity of O's origin, then angular velocity, in the world.
        
        at_rest: it stands still, every contact sticks, and the twist only turns the cones.
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_WO(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose in the world.
        """
    @X_WO.setter
    def X_WO(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def at_rest(self) -> bool:
        """
        Whether it stands still.
        """
    @at_rest.setter
    def at_rest(self, arg0: bool) -> None:
        ...
    @property
    def twist_W(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        (6,) velocity of O's origin, then angular velocity, in the world.
        """
    @twist_W.setter
    def twist_W(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class ContactPatches:
    """
    Where a polyhedron touches planes.
    """
    def __init__(self, *, contacts: collections.abc.Sequence[Contact] = [], plane: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], fault: str = '', turns_in_plane: bool = False) -> None:
        """
        Any field by keyword.
        """
    def __repr__(self) -> str:
        ...
    @property
    def contacts(self) -> tuple[Contact, ...]:
        """
        Corners of the patches; copies.
        """
    @contacts.setter
    def contacts(self, arg1: collections.abc.Sequence[Contact]) -> None:
        ...
    @property
    def fault(self) -> str:
        """
        Why the corners cannot stand for the patches; empty when they can.
        """
    @fault.setter
    def fault(self, arg0: str) -> None:
        ...
    @property
    def plane(self) -> tuple[int, ...]:
        """
        Index of each contact's plane.
        """
    @plane.setter
    def plane(self, arg1: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
    @property
    def turns_in_plane(self) -> bool:
        """
        Whether a face turns about its normal: its corners understate friction.
        """
    @turns_in_plane.setter
    def turns_in_plane(self, arg0: bool) -> None:
        ...
class Engine(enum.Enum):
    """
    Who solves the linear programs.
    """
    fast = ...
    reference = ...
class Stability:
    """
    How much disturbance an instant withstands.
    """
    def __init__(self, *, z: typing.SupportsFloat | typing.SupportsIndex = 0.0, commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] = ..., binding_directions: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = []) -> None:
        """
        Any field by keyword.
        """
    def __repr__(self) -> str:
        ...
    @property
    def binding_directions(self) -> tuple[int, ...]:
        """
        Rows of the directions that keep z from growing.
        """
    @binding_directions.setter
    def binding_directions(self, arg1: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
    @property
    def commanded_forces(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (n,) normal force of each finger in force control, 0 for the others [N].
        """
    @commanded_forces.setter
    def commanded_forces(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None:
        ...
    @property
    def z(self) -> float:
        """
        Largest z such that every z times a direction is balanced [N]; 0 without equilibrium or margin, inf when contacts can balance anything.
        """
    @z.setter
    def z(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ControlModes:
    """
    The control modes of greatest stability that cannot jam.
    """
    def __bool__(self) -> bool:
        """
        Whether found.
        """
    def __init__(self, *, found: bool = False, modes: collections.abc.Sequence[FingerMode] = [], stability: Stability = ...) -> None:
        """
        Any field by keyword.
        """
    def __repr__(self) -> str:
        ...
    @property
    def found(self) -> bool:
        """
        Whether there are any, with z > 0.
        """
    @found.setter
    def found(self, arg0: bool) -> None:
        ...
    @property
    def modes(self) -> tuple[FingerMode, ...]:
        """
        One FingerMode a finger.
        """
    @modes.setter
    def modes(self, arg1: collections.abc.Sequence[FingerMode]) -> None:
        ...
    @property
    def stability(self) -> Stability:
        """
        With these modes.
        """
    @stability.setter
    def stability(self, arg0: Stability) -> None:
        ...
class Equilibrium:
    """
    Contact forces that balance, as far inside their limits as they go.
    """
    def __repr__(self) -> str:
        ...
    @property
    def contact_forces_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (m, 3) on the object, in O [N].
        """
    @property
    def finger_forces_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (n, 3) on the object, in O [N].
        """
    @property
    def margin(self) -> float:
        """
        What every cone coefficient, and what is left to every limit, is at least [N].
        """
class Compliance:
    """
    Springs at the contacts, of which only ratios matter.
    """
    def __init__(self, *, environment_normal: typing.SupportsFloat | typing.SupportsIndex = 1.0, environment_tangential: typing.SupportsFloat | typing.SupportsIndex = 0.8, finger_normal: typing.SupportsFloat | typing.SupportsIndex = 0.2, finger_tangential: typing.SupportsFloat | typing.SupportsIndex = 0.2) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __repr__(self) -> str:
        ...
    @property
    def environment_normal(self) -> float:
        """
        Along the normal.
        """
    @environment_normal.setter
    def environment_normal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def environment_tangential(self) -> float:
        """
        Along the surface, where contacts stick.
        """
    @environment_tangential.setter
    def environment_tangential(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def finger_normal(self) -> float:
        """
        Of fingers in position control.
        """
    @finger_normal.setter
    def finger_normal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def finger_tangential(self) -> float:
        """
        Of all fingers.
        """
    @finger_tangential.setter
    def finger_tangential(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class FrictionInterval:
    """
    Bounds of a coefficient of friction.
    """
    def __init__(self, lower: typing.SupportsFloat | typing.SupportsIndex, upper: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        0 < lower <= upper.
        """
    def __repr__(self) -> str:
        ...
    @property
    def lower(self) -> float:
        """
        Least.
        """
    @lower.setter
    def lower(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def upper(self) -> float:
        """
        Greatest.
        """
    @upper.setter
    def upper(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class FrictionVerdict:
    """
    Whether a contact set holds for all coefficients of an interval.
    """
    def __bool__(self) -> bool:
        """
        Whether it holds.
        """
    def __init__(self, *, holds: bool = False, least_stability: typing.SupportsFloat | typing.SupportsIndex = 0.0, environment: typing.SupportsFloat | typing.SupportsIndex = 0.0, fingers: typing.SupportsFloat | typing.SupportsIndex = 0.0, reason: str = '') -> None:
        """
        Any field by keyword.
        """
    def __repr__(self) -> str:
        ...
    @property
    def environment(self) -> float:
        """
        Coefficient of the environment at which it fails.
        """
    @environment.setter
    def environment(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fingers(self) -> float:
        """
        Coefficient of the fingers at which it fails.
        """
    @fingers.setter
    def fingers(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def holds(self) -> bool:
        """
        Whether it does, shown.
        """
    @holds.setter
    def holds(self, arg0: bool) -> None:
        ...
    @property
    def least_stability(self) -> float:
        """
        A proven lower bound on z when it holds [N].
        """
    @least_stability.setter
    def least_stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def reason(self) -> str:
        """
        How it fails, for people.
        """
    @reason.setter
    def reason(self, arg0: str) -> None:
        ...
@typing.overload
def best_control_modes(set: ContactSet, *, previous: collections.abc.Sequence[FingerMode] = [], directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, engine: Engine = Engine.fast) -> ControlModes:
    """
    The control modes of greatest stability that cannot jam; ties go to `previous`, then to force control of the fingers that press into the environment.
    """
@typing.overload
def best_control_modes(sets: collections.abc.Sequence[ContactSet], *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, engine: Engine = Engine.fast) -> list[ControlModes]:
    """
    The same for many contact sets.
    """
def compliant_equilibrium(set: ContactSet, modes: collections.abc.Sequence[FingerMode], commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], compliance: Compliance = ..., *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> Equilibrium | None:
    """
    The Equilibrium with room where springs at the contacts will ask for it, so that compliant_stability() is large; None when there is none.
    
    commanded_forces: (n,) [N], looked at for fingers in force control.
    directions: (N, 6); disturbance_directions() unless given.
    """
def compliant_stability(set: ContactSet, modes: collections.abc.Sequence[FingerMode], nominal: Equilibrium, compliance: Compliance = ..., *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> float:
    """
    The largest disturbance [N] that springs at the contacts carry from the nominal forces before one slips, lets go or passes its limit.
    
    Unlike z, it does not assume that passive friction redistributes freely.
    """
def contact_patches(vertices_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], planes: collections.abc.Sequence[Plane], state: BodyState, tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-06) -> ContactPatches:
    """
    Contacts of the convex hull of vertices_O, (N, 3) [m], with planes. com_O: (3,) [m].
    
    A vertex within tolerance [m] of a plane touches it; one that leaves does not count, one that moves along slides.
    """
def contact_sets(common: ContactSet, *, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], normals: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], sliding: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_normals: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_friction: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], max_normal_force: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> list[ContactSet]:
    """
    N ContactSets of m contacts and n fingers each from arrays; whatever else they hold is that of `common`.
    
    points, normals: (N, m, 3). friction: (N, m). sliding: (N, m, 3) where the object slides to, zero where it sticks.
    finger_points, finger_normals: (N, n, 3). finger_friction, max_normal_force: (N, n).
    """
def disturbance_directions() -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 6]"]:
    """
    (76, 6) vertices of a polyhedron about the unit sphere of scaled wrenches.
    """
def friction_cone(n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex, edges: typing.SupportsInt | typing.SupportsIndex = 6, t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
    """
    (edges, 3) unit edges of the cone inscribed in Coulomb's about a unit normal; the first lies over tangent(n_O, t_O).
    """
def gravity_wrench(mass: typing.SupportsFloat | typing.SupportsIndex, gravity_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
    """
    (6,) gravity's wrench on a mass [kg], for an acceleration (3,) in O [m/s^2].
    """
def holds_over_friction(set: ContactSet, modes: collections.abc.Sequence[FingerMode], commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, environment: FrictionInterval, fingers: FrictionInterval, needed: typing.SupportsFloat | typing.SupportsIndex, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> FrictionVerdict:
    """
    Whether z >= needed [N], without jamming, for all coefficients within the intervals.
    
    All contacts share one coefficient, and so do all fingers; those of `set` are not looked at.
    """
def interior_equilibrium(set: ContactSet, modes: collections.abc.Sequence[FingerMode], commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Equilibrium | None:
    """
    The Equilibrium deepest inside all cones and limits; None when there is none.
    
    commanded_forces: (n,) [N], looked at for fingers in force control.
    """
def internal_force_is_bounded(set: ContactSet, modes: collections.abc.Sequence[FingerMode], *, engine: Engine = Engine.fast) -> bool:
    """
    Problem (5): whether contacts and position-controlled fingers cannot jam.
    """
def max_stability(set: ContactSet, modes: collections.abc.Sequence[FingerMode], *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, engine: Engine = Engine.fast) -> Stability:
    """
    Problem (6): the stability of a contact set under these control modes, one a finger.
    
    directions: (N, 6) that positively span the space; disturbance_directions() unless given.
    """
def normalized(set: ContactSet) -> ContactSet:
    """
    The same set with unit normals. Raises ValueError on one without a direction.
    """
def tangent(n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
    """
    (3,) unit tangent at a unit normal n_O: t_O without its normal part, or a grid axis of the face when that vanishes.
    """
def validate(set: ContactSet) -> None:
    """
    Raises ValueError that names the field at fault and its value.
    """
def wrench_scale(mass: typing.SupportsFloat | typing.SupportsIndex, inertia_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"]:
    """
    (6, 6) that leaves forces as they are and divides moments by sqrt(J_i / M) along the principal axes.
    
    mass: [kg]. inertia_O: (3, 3) about the centre of mass [kg m^2].
    """
