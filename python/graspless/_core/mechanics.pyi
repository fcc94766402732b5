"""
Stability of objects with frictional contacts (Maeda, Arai).
"""
from __future__ import annotations
import collections.abc
import graspless._core.planning
import graspless._named
import numpy
import numpy.typing
import typing
__all__: list[str] = ['BodyState', 'Compliance', 'Contact', 'ContactMode', 'ContactPatches', 'ContactSet', 'ControlModes', 'Engine', 'Equilibrium', 'Finger', 'FingerMode', 'FrictionInterval', 'FrictionVerdict', 'Plane', 'Stability', 'Surfaces', 'best_control_modes', 'compliant_equilibrium', 'compliant_stability', 'contact_patches', 'contact_sets', 'disturbance_directions', 'friction_cone', 'gravity_wrench', 'holds_over_friction', 'interior_equilibrium', 'internal_force_is_bounded', 'max_stability', 'normalized', 'place_tolerance', 'tangent', 'validate', 'withstands', 'wrench_scale']
class ContactMode(graspless._named.Named):
    """
    Motion of the object at a contact with the environment, Eq. (1).
    """
    slide = ...
    stick = ...
class FingerMode(graspless._named.Named):
    """
    Control mode of a finger, Eq. (2).
    """
    force = ...
    position = ...
class Contact:
    """
    Point contact between the object and its environment.
    """
    def __init__(self, *, p_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, mode: ContactMode = ContactMode.stick, t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        Parameters
        ----------
        p_OC : array (3,)
            Contact point in the object's frame O [m].
        n_O : array (3,)
            Unit normal in O, pointing into the object.
        friction : float
            Coefficient of friction, not negative.
        mode : ContactMode
            Sticking or sliding.
        t_O : array (3,), optional
            Direction along the surface, in O, of any length. For a sliding contact it is the direction
            in which the object moves and must be given. For a sticking contact it is the direction of
            the first edge of the friction cone; `tangent` chooses one by default.
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
        Sticking or sliding.
        """
    @mode.setter
    def mode(self, arg0: ContactMode) -> None:
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
    def p_OC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) contact point in O [m].
        """
    @p_OC.setter
    def p_OC(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def t_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) direction of sliding, or of the first edge of the cone, in O. Zero lets `tangent` choose.
        """
    @t_O.setter
    def t_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class Finger:
    """
    Fingertip in one-point contact with the object. It does not slide, Eq. (2).
    """
    def __init__(self, *, p_OC: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex = 0.5, max_normal_force: typing.SupportsFloat | typing.SupportsIndex = 10.0, t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> None:
        """
        Parameters
        ----------
        p_OC : array (3,)
            Contact point in the object's frame O [m].
        n_O : array (3,)
            Unit normal in O, pointing into the object.
        friction : float
            Coefficient of friction, not negative.
        max_normal_force : float
            Upper limit f_max of the normal force [N].
        t_O : array (3,), optional
            Direction of the first edge of the friction cone, in O; `tangent` chooses one by default.
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
        Upper limit f_max of the normal force [N].
        """
    @max_normal_force.setter
    def max_normal_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
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
    def p_OC(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) contact point in O [m].
        """
    @p_OC.setter
    def p_OC(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def t_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) direction of the first edge of the cone, in O. Zero lets `tangent` choose.
        """
    @t_O.setter
    def t_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class ContactSet:
    """
    All contacts of an object at one instant of a quasi-static motion, in its frame O.
    """
    def __init__(self, *, contacts: collections.abc.Sequence[Contact], fingers: collections.abc.Sequence[Finger], com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, known_wrench_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, wrench_scale: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, cone_edges: typing.SupportsInt | typing.SupportsIndex = 6) -> None:
        """
        Parameters
        ----------
        contacts : sequence of Contact
            Contacts with the environment.
        fingers : sequence of Finger
            Fingertips, four at most.
        com_O : array (3,), optional
            Centre of mass in O, about which moments are taken [m]. Zero by default.
        known_wrench_O : array (6,), optional
            Q_known of Eq. (3): known force and moment about the centre of mass, in O [N, N m], for
            instance `gravity_wrench`. Zero by default.
        wrench_scale : array (6, 6), optional
            R^1/2 of Eq. (7): the matrix that scales wrenches before they are measured, for instance
            `wrench_scale`. The identity by default.
        cone_edges : int
            Number of edges of each polyhedral friction cone, 3 to 1000.
        
        Raises
        ------
        ValueError
            An array has the wrong shape or is not finite. `validate` checks the other rules.
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
        Number of edges of each polyhedral friction cone.
        """
    @cone_edges.setter
    def cone_edges(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def contacts(self) -> tuple[Contact, ...]:
        """
        Contacts with the environment. The tuple holds copies.
        """
    @contacts.setter
    def contacts(self, arg1: collections.abc.Sequence[Contact]) -> None:
        ...
    @property
    def fingers(self) -> tuple[Finger, ...]:
        """
        Fingertips. The tuple holds copies.
        """
    @fingers.setter
    def fingers(self, arg1: collections.abc.Sequence[Finger]) -> None:
        ...
    @property
    def known_wrench_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        (6,) known wrench Q_known in O about the centre of mass [N, N m].
        """
    @known_wrench_O.setter
    def known_wrench_O(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def wrench_scale(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"]:
        """
        (6, 6) matrix R^1/2 that scales a wrench in O about the centre of mass before it is measured.
        """
    @wrench_scale.setter
    def wrench_scale(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
class Plane:
    """
    Solid half-space that the object rests on or leans against: a floor or a wall.
    """
    def __init__(self, *, name: str = 'floor', n_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, offset: typing.SupportsFloat | typing.SupportsIndex = 0.0, friction: typing.SupportsFloat | typing.SupportsIndex = 0.5) -> None:
        """
        Parameters
        ----------
        name : str
            Name in error messages.
        n_W : array (3,), optional
            Unit normal in the world W, pointing out of the solid. Upwards by default.
        offset : float
            n_W . p of the points p on its surface [m].
        friction : float
            Coefficient of friction.
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
        (3,) unit normal in the world, pointing out of the solid.
        """
    @n_W.setter
    def n_W(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        Name in error messages.
        """
    @name.setter
    def name(self, arg0: str) -> None:
        ...
    @property
    def offset(self) -> float:
        """
        n_W . p of the points p on its surface [m].
        """
    @offset.setter
    def offset(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class BodyState:
    """
    Pose and velocity of an object at one instant.
    """
    def __init__(self, *, X_WO: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., twist_W: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, at_rest: bool = False) -> None:
        """
        Parameters
        ----------
        X_WO : array (4, 4)
            Pose of the object in the world W. The identity by default.
        twist_W : array (6,), optional
            Velocity of O's origin, then angular velocity, in W per unit of the motion's parameter.
            Zero by default.
        at_rest : bool
            The object stands still. Every contact then sticks, and the twist only determines the
            directions of the cones.
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
        True if the object stands still.
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
    Contacts of a polyhedron with planes.
    """
    def __init__(self, *, contacts: collections.abc.Sequence[Contact] = [], plane: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], fault: str = '', turns_in_plane: bool = False) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def contacts(self) -> tuple[Contact, ...]:
        """
        Vertices of the contact patches, in O. The tuple holds copies.
        """
    @contacts.setter
    def contacts(self, arg1: collections.abc.Sequence[Contact]) -> None:
        ...
    @property
    def fault(self) -> str:
        """
        Reason why the vertices do not represent the patches; empty if they do.
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
        True if a face turns about its normal while it slides. Its vertices then understate friction.
        """
    @turns_in_plane.setter
    def turns_in_plane(self, arg0: bool) -> None:
        ...
class Engine(graspless._named.Named):
    """
    Solver of the linear programs.
    """
    fast = ...
    reference = ...
class Stability:
    """
    Largest disturbance that a contact set withstands, the answer to Problem (6).
    """
    def __init__(self, *, z: typing.SupportsFloat | typing.SupportsIndex = 0.0, commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] = ..., binding_directions: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = []) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def binding_directions(self) -> tuple[int, ...]:
        """
        Row indices of the directions that limit z.
        """
    @binding_directions.setter
    def binding_directions(self, arg1: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
    @property
    def commanded_forces(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (n,) commanded normal forces f_com of fingers in force control, 0 for the others [N].
        """
    @commanded_forces.setter
    def commanded_forces(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None:
        ...
    @property
    def z(self) -> float:
        """
        Largest z such that the disturbance z l_i can be balanced for every direction l_i [N].
        
        0 if there is no equilibrium or it has no margin; inf if the contacts can balance anything.
        """
    @z.setter
    def z(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ControlModes:
    """
    Control modes of greatest stability that cannot jam, Section 3.4.
    """
    def __bool__(self) -> bool:
        """
        Returns `found`.
        """
    def __init__(self, *, found: bool = False, modes: collections.abc.Sequence[FingerMode] = [], stability: Stability = ...) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def found(self) -> bool:
        """
        True if some combination cannot jam and has z > 0.
        """
    @found.setter
    def found(self, arg0: bool) -> None:
        ...
    @property
    def modes(self) -> tuple[FingerMode, ...]:
        """
        One control mode for each finger.
        """
    @modes.setter
    def modes(self, arg1: collections.abc.Sequence[FingerMode]) -> None:
        ...
    @property
    def stability(self) -> Stability:
        """
        Stability under these modes.
        """
    @stability.setter
    def stability(self, arg0: Stability) -> None:
        ...
class Equilibrium:
    """
    Contact forces that balance a contact set, well inside their cones and limits.
    """
    def __init__(self, contact_forces_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_forces_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], margin: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Forces of one's own, for instance measured ones.
        
        Parameters
        ----------
        contact_forces_O : array (m, 3)
            Force on the object at each contact, in O [N].
        finger_forces_O : array (n, 3)
            Force on the object at each finger, in O [N].
        margin : float
            As below [N].
        
        Raises
        ------
        ValueError
            An array has another shape.
        """
    def __repr__(self) -> str:
        ...
    @property
    def contact_forces_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (m, 3) force on the object at each contact, in O [N].
        """
    @property
    def finger_forces_O(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (n, 3) force on the object at each finger, in O [N].
        """
    @property
    def margin(self) -> float:
        """
        Largest t such that all cone coefficients are at least t, and fingers in position control
        stay at least t below their limits [N].
        """
class Compliance:
    """
    Stiffness of the springs that model the contacts. Only ratios matter to the stability.
    """
    @staticmethod
    def fields() -> list[graspless._core.planning.Field]:
        """
        Returns name, unit, range, text and source of every field.
        """
    def __copy__(self) -> Compliance:
        """
        Returns a copy.
        """
    def __deepcopy__(self, memo: typing.Any) -> Compliance:
        """
        Returns a copy.
        """
    def __init__(self, *, environment_normal: typing.SupportsFloat | typing.SupportsIndex = 50000.0, environment_tangential: typing.SupportsFloat | typing.SupportsIndex = 40000.0, finger_normal: typing.SupportsFloat | typing.SupportsIndex = 10000.0, finger_tangential: typing.SupportsFloat | typing.SupportsIndex = 10000.0) -> None:
        """
        Any field by keyword; the others keep their defaults.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def environment_normal(self) -> float:
        """
        Stiffness of contacts with the environment along the normal.
        
        Unit: N/m. Range: [1e-09, 1e+09]. Default: 50000.0.
        """
    @environment_normal.setter
    def environment_normal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def environment_tangential(self) -> float:
        """
        Stiffness of sticking contacts with the environment along the surface.
        
        Unit: N/m. Range: [1e-09, 1e+09]. Default: 40000.0.
        """
    @environment_tangential.setter
    def environment_tangential(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def finger_normal(self) -> float:
        """
        Stiffness of fingers in position control along the normal.
        
        Unit: N/m. Range: [1e-09, 1e+09]. Default: 10000.0.
        """
    @finger_normal.setter
    def finger_normal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def finger_tangential(self) -> float:
        """
        Stiffness of all fingers along the surface.
        
        Unit: N/m. Range: [1e-09, 1e+09]. Default: 10000.0.
        """
    @finger_tangential.setter
    def finger_tangential(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class FrictionInterval:
    """
    Bounds of an uncertain coefficient of friction.
    """
    def __init__(self, lower: typing.SupportsFloat | typing.SupportsIndex, upper: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Parameters
        ----------
        lower, upper : float
            Bounds with 0 <= lower <= upper.
        """
    def __repr__(self) -> str:
        ...
    @property
    def lower(self) -> float:
        """
        Lower bound.
        """
    @lower.setter
    def lower(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def upper(self) -> float:
        """
        Upper bound.
        """
    @upper.setter
    def upper(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Surfaces:
    """
    Surfaces of the environment, such as the floor and a wall.
    
    All contacts with a surface share its coefficient of friction. The coefficients of different
    surfaces vary independently.
    """
    def __init__(self, *, friction: collections.abc.Sequence[FrictionInterval] = [], of_contact: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = []) -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def friction(self) -> tuple[FrictionInterval, ...]:
        """
        Bounds of the coefficient of each surface. At most 6 may have lower < upper.
        """
    @friction.setter
    def friction(self, arg1: collections.abc.Sequence[FrictionInterval]) -> None:
        ...
    @property
    def of_contact(self) -> tuple[int, ...]:
        """
        Index of each contact's surface.
        """
    @of_contact.setter
    def of_contact(self, arg1: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
class FrictionVerdict:
    """
    Verdict on a contact set over intervals of friction.
    """
    def __bool__(self) -> bool:
        """
        Returns `holds`.
        """
    def __init__(self, *, holds: bool = False, least_stability: typing.SupportsFloat | typing.SupportsIndex = 0.0, environment: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [], fingers: typing.SupportsFloat | typing.SupportsIndex = 0.0, reason: str = '') -> None:
        """
        Any field by keyword.
        """
    def __reduce__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def environment(self) -> tuple[float, ...]:
        """
        Coefficient of each surface of the environment at which the set fails, if it does.
        """
    @environment.setter
    def environment(self, arg1: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
    @property
    def fingers(self) -> float:
        """
        Coefficient of the fingers at which the set fails, if it does.
        """
    @fingers.setter
    def fingers(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def holds(self) -> bool:
        """
        True if z >= needed is proven and nothing can jam, for all coefficients.
        """
    @holds.setter
    def holds(self, arg0: bool) -> None:
        ...
    @property
    def least_stability(self) -> float:
        """
        Proven lower bound on z over the intervals [N], if the set holds.
        """
    @least_stability.setter
    def least_stability(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def reason(self) -> str:
        """
        Reason of the failure in words.
        """
    @reason.setter
    def reason(self, arg0: str) -> None:
        ...
@typing.overload
def best_control_modes(set: ContactSet, *, previous: collections.abc.Sequence[FingerMode] = [], directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, engine: Engine = Engine.fast) -> ControlModes:
    """
    Finds the control modes of greatest stability that cannot jam, Section 3.4.
    
    `previous` wins ties. Other ties go to force control of fingers that press into the environment
    and position control of fingers that oppose the motion. `directions` (N, 6) are those of
    `max_stability`. Normals that are not unit vectors are normalised with a UserWarning. Raises
    ValueError if the contact set, `previous` or the directions are invalid.
    """
@typing.overload
def best_control_modes(sets: collections.abc.Sequence[ContactSet], *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, engine: Engine = Engine.fast) -> list[ControlModes]:
    """
    Finds the best control modes of many contact sets, each on its own.
    """
def compliant_equilibrium(set: ContactSet, modes: collections.abc.Sequence[FingerMode], commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], compliance: Compliance = ..., *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> Equilibrium | None:
    """
    Finds the equilibrium whose `compliant_stability` is as large as possible.
    
    Like `interior_equilibrium`, but each contact keeps as much reserve as disturbances take from it
    when the contacts are springs. Not in the paper.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    commanded_forces : array (n,)
        Commanded normal forces [N]. Entries of fingers in position control are ignored.
    compliance : Compliance
        Stiffness of the contacts.
    directions : array (N, 6), optional
        Directions of disturbances in scaled wrench space. By default `disturbance_directions`.
    
    Returns
    -------
    Equilibrium or None
        None if there is no equilibrium.
    
    Raises
    ------
    ValueError
        The contact set, the modes, the forces, the stiffness or the directions are invalid.
    """
def compliant_stability(set: ContactSet, modes: collections.abc.Sequence[FingerMode], nominal: Equilibrium, compliance: Compliance = ..., *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> float:
    """
    Computes a stability margin with contacts as springs about their nominal forces.
    
    Unlike z of Problem (6), it does not assume that passive friction redistributes freely. Not in
    the paper.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    nominal : Equilibrium
        Nominal forces, for instance from `compliant_equilibrium`.
    compliance : Compliance
        Stiffness of the contacts.
    directions : array (N, 6), optional
        Directions of disturbances in scaled wrench space. By default `disturbance_directions`.
    
    Returns
    -------
    float
        Largest disturbance [N] under which no contact slips or lets go and no finger exceeds its
        limit. 0 if the springs do not hold the object.
    
    Raises
    ------
    ValueError
        The contact set, the modes, the nominal forces, the stiffness or the directions are invalid.
    """
def contact_patches(vertices_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], com_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], planes: collections.abc.Sequence[Plane], state: BodyState, tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-06) -> ContactPatches:
    """
    Finds the contacts of a convex hull with planes, Section 5.
    
    A vertex within the tolerance of a plane touches it. A touching vertex that leaves its plane is
    ignored, one that moves along it slides, and one that does not move sticks.
    
    Parameters
    ----------
    vertices_O : array (N, 3)
        Points whose convex hull is the object, in O [m].
    com_O : array (3,)
        Centre of mass in O [m].
    planes : sequence of Plane
        Floor and walls.
    state : BodyState
        Pose and velocity of the object.
    tolerance : float
        Distance from a plane within which a vertex touches it [m].
    
    Returns
    -------
    ContactPatches
        Contacts, the plane of each, and a fault if vertices cannot represent the patches.
    
    Raises
    ------
    ValueError
        An array has the wrong shape or is not finite, a plane is invalid, or the pose is not rigid.
    """
def contact_sets(common: ContactSet, *, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], normals: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], sliding: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_normals: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], finger_friction: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], max_normal_force: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> list[ContactSet]:
    """
    Makes N contact sets of m contacts and n fingers each from arrays, all in the object's frame O.
    
    Parameters
    ----------
    common : ContactSet
        Contact set whose other fields all sets share.
    points, normals : array (N, m, 3)
        Contacts with the environment [m], and their normals, which point into the object.
    friction : array (N, m)
        Coefficients of friction.
    sliding : array (N, m, 3)
        Direction in which the object slides at each contact; zero where it sticks.
    finger_points, finger_normals : array (N, n, 3)
        Fingertips [m], and their normals, which point into the object.
    finger_friction : array (N, n)
        Coefficients of friction of the fingers.
    max_normal_force : array (N, n)
        Upper limits f_max of the normal forces [N].
    
    Returns
    -------
    list of ContactSet
        N contact sets.
    
    Raises
    ------
    ValueError
        An array has the wrong shape.
    """
def disturbance_directions() -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 6]"]:
    """
    Returns the directions of disturbances l_1 ... l_N of Problem (6), with N = 76 as in Section 5.
    
    Returns
    -------
    array (76, 6)
        Vertices of a polyhedron around the unit sphere in scaled wrench space.
    """
def friction_cone(n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], friction: typing.SupportsFloat | typing.SupportsIndex, edges: typing.SupportsInt | typing.SupportsIndex = 6, t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
    """
    Returns the edges of the polyhedral cone inscribed in Coulomb's cone, Section 2.2.
    
    Parameters
    ----------
    n_O : array (3,)
        Unit normal in O.
    friction : float
        Coefficient of friction, not negative.
    edges : int
        Number of edges, at least 3.
    t_O : array (3,), optional
        Direction in O towards which the first edge leans, as in `tangent`.
    
    Returns
    -------
    array (edges, 3)
        Unit vectors c_1 ... c_s in O, counter-clockwise about n_O at equal angles.
    
    Raises
    ------
    ValueError
        There are fewer than three edges, or an array has the wrong shape or is not finite.
        The length of n_O and the sign of friction are not checked.
    """
def gravity_wrench(mass: typing.SupportsFloat | typing.SupportsIndex, gravity_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
    """
    Returns the wrench of gravity about the centre of mass.
    
    Parameters
    ----------
    mass : float
        Mass [kg].
    gravity_O : array (3,)
        Acceleration of gravity in O [m/s^2].
    
    Returns
    -------
    array (6,)
        Force and moment in O [N, N m]. The moment is zero.
    
    Raises
    ------
    ValueError
        The mass is not in [1e-9, 1e5] kg, or a value of gravity_O is beyond 1000 m/s^2.
    """
def holds_over_friction(set: ContactSet, modes: collections.abc.Sequence[FingerMode], commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], *, environment: FrictionInterval | Surfaces, fingers: FrictionInterval, needed: typing.SupportsFloat | typing.SupportsIndex, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> FrictionVerdict:
    """
    Proves that a contact set holds over intervals of friction, or finds where it fails.
    
    The set holds if z >= needed and nothing can jam, for all coefficients in the intervals. All
    fingers share one coefficient. The coefficients in `set` are ignored. Not in the paper.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    commanded_forces : array (n,)
        Commanded normal forces [N]. Entries of fingers in position control are ignored.
    environment : FrictionInterval or Surfaces
        Bounds of the coefficient that all contacts share, or of the coefficient of each surface.
    fingers : FrictionInterval
        Bounds of the coefficient of the fingers.
    needed : float
        Stability that is needed, not negative [N].
    directions : array (N, 6), optional
        Directions of disturbances in scaled wrench space. By default `disturbance_directions`.
    
    Returns
    -------
    FrictionVerdict
        Proven bound on z, or the coefficients at which the set fails.
    
    Raises
    ------
    ValueError
        The contact set, the modes, the forces, an interval, `needed` or the directions are invalid.
    """
def interior_equilibrium(set: ContactSet, modes: collections.abc.Sequence[FingerMode], commanded_forces: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> Equilibrium | None:
    """
    Finds contact forces that balance without disturbance, deep inside all cones and limits.
    
    The paper leaves these nominal forces open. Among the equilibria with at least 0.9 of the
    largest margin, this one has the least sum of squares of cone coefficients beyond that margin.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    commanded_forces : array (n,)
        Commanded normal forces [N]. Entries of fingers in position control are ignored.
    
    Returns
    -------
    Equilibrium or None
        None if there is no equilibrium.
    
    Raises
    ------
    ValueError
        The contact set, the modes or the forces are invalid.
    """
def internal_force_is_bounded(set: ContactSet, modes: collections.abc.Sequence[FingerMode], *, engine: Engine = Engine.fast) -> bool:
    """
    Tests whether contacts and position-controlled fingers cannot jam, Problem (5).
    
    They jam if contact forces of arbitrary size can cancel each other.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    engine : Engine
        Solver of the linear programs.
    
    Returns
    -------
    bool
        True if nothing can jam.
    
    Raises
    ------
    ValueError
        The contact set or the number of modes is invalid.
    """
def max_stability(set: ContactSet, modes: collections.abc.Sequence[FingerMode], *, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, engine: Engine = Engine.fast) -> Stability:
    """
    Computes the stability of a contact set under given control modes, Problem (6).
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    directions : array (N, 6), optional
        Directions of disturbances in scaled wrench space, which positively span it. By default
        `disturbance_directions`.
    engine : Engine
        Solver of the linear programs.
    
    Returns
    -------
    Stability
        z and the commanded normal forces [N].
    
    Raises
    ------
    ValueError
        The contact set, the number of modes or the directions are invalid.
    """
def normalized(set: ContactSet) -> ContactSet:
    """
    Scales all normals of a contact set to unit length.
    
    Parameters
    ----------
    set : ContactSet
        Contact set with normals of any length but zero.
    
    Returns
    -------
    ContactSet
        Copy of the set with unit normals.
    
    Raises
    ------
    ValueError
        A normal has length zero or is not finite.
    """
def place_tolerance(set: ContactSet, modes: collections.abc.Sequence[FingerMode], nominal: Equilibrium, compliance: Compliance = ..., *, points_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, max_yield: typing.SupportsFloat | typing.SupportsIndex = 0.001, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> float:
    """
    Computes an error of the fingers' places that the contacts tolerate.
    
    In its place relative to the object, a finger has its nominal force; out of it, its spring
    presses or pulls more. With errors of up to e, the contacts still withstand `withstands`
    (1 - e / `place_tolerance`). Not in the paper; see docs/internals/withstands.md.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    nominal : Equilibrium
        Nominal forces, for instance from `compliant_equilibrium`.
    compliance : Compliance
        Stiffness of the contacts.
    points_O : array (N, 3), optional
        Points of the object in O that must not yield by more than `max_yield` [m]. By default
        there are none.
    max_yield : float
        Distance by which the springs may let these points move [m].
    directions : array (N, 6), optional
        Directions of disturbances in scaled wrench space. By default `disturbance_directions`.
    
    Returns
    -------
    float
        Distance [m] by which every finger may be out of its place, in any direction, without a
        disturbance; often more is tolerated. At most 1; 0 if nothing is withstood.
    
    Raises
    ------
    ValueError
        The contact set, the modes, the nominal forces, the stiffness, the points or the directions are
        invalid.
    """
def tangent(n_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], t_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
    """
    Returns a unit tangent at a contact.
    
    Parameters
    ----------
    n_O : array (3,)
        Unit normal in O.
    t_O : array (3,), optional
        Direction whose part along the surface is used, in O. Where that part vanishes, or by
        default, the first grid axis of a face with this normal takes its place.
    
    Returns
    -------
    array (3,)
        Unit vector in O, perpendicular to n_O.
    """
def validate(set: ContactSet) -> None:
    """
    Checks a contact set.
    
    Parameters
    ----------
    set : ContactSet
        Contact set to check.
    
    Raises
    ------
    ValueError
        A value is not finite, a coefficient of friction is not in [0, 1e4], a force limit is
        not in [1e-6, 1e6] N,
        a normal is not a unit vector, a sliding contact has no direction along the surface, a cone
        has fewer than three edges, there are more than four fingers, or the scale is singular. The
        message names the field and its value.
    """
def withstands(set: ContactSet, modes: collections.abc.Sequence[FingerMode], nominal: Equilibrium, compliance: Compliance = ..., *, points_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None, max_yield: typing.SupportsFloat | typing.SupportsIndex = 0.001, directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> float:
    """
    Computes the largest disturbance that the contacts withstand.
    
    Fingers are springs about their nominal forces, so they cannot choose how to share a
    disturbance. The environment sticks, or its friction gives way. Fingers are in their places:
    see `place_tolerance`. Not in the paper; see docs/internals/withstands.md.
    
    Parameters
    ----------
    set : ContactSet
        Contacts with the environment and n fingers. Normals that are not unit vectors are
        normalised with a UserWarning.
    modes : sequence of FingerMode
        One control mode for each finger.
    nominal : Equilibrium
        Nominal forces, for instance from `compliant_equilibrium`.
    compliance : Compliance
        Stiffness of the contacts.
    points_O : array (N, 3), optional
        Points of the object in O that must not yield by more than `max_yield` [m]. By default
        there are none.
    max_yield : float
        Distance by which the springs may let these points move [m].
    directions : array (N, 6), optional
        Directions of disturbances in scaled wrench space. By default `disturbance_directions`.
    
    Returns
    -------
    float
        Largest disturbance [N] in every direction. 0 if the springs do not hold the object.
    
    Raises
    ------
    ValueError
        The contact set, the modes, the nominal forces, the stiffness, the points or the directions are
        invalid.
    """
def wrench_scale(mass: typing.SupportsFloat | typing.SupportsIndex, inertia_O: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"]:
    """
    Returns the scale of wrenches R^1/2 of Eqs. (7) and (8).
    
    It keeps forces and divides moments by sqrt(J_i / M), both along the principal axes of the
    inertia.
    
    Parameters
    ----------
    mass : float
        Mass M [kg].
    inertia_O : array (3, 3)
        Inertia J about the centre of mass, in O [kg m^2].
    
    Returns
    -------
    array (6, 6)
        Matrix that scales a wrench in O about the centre of mass.
    
    Raises
    ------
    ValueError
        The mass is not positive, or the inertia is not symmetric, not positive definite or violates
        the triangle inequality.
    """
