"""
Robots read from URDF, and their inverse kinematics.
"""
from __future__ import annotations
import collections.abc
import graspless._core.geometry
import numpy
import numpy.typing
import typing
__all__: list[str] = ['Ik', 'Robot']
class Robot:
    """
    A rigid-body tree read from a URDF. Immutable; may be used from several threads.
    
    A configuration q holds its independent joints [rad or m]; mimic joints follow theirs.
    """
    @staticmethod
    def from_urdf(xml: str, srdf: str = '', packages: collections.abc.Mapping[str, str] = {}, directory: str = '', X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> Robot:
        """
        Reads URDF text. srdf: SRDF text with groups, states and disabled collisions. packages: where
        package://NAME/ points. directory: what relative mesh paths start from. X_WB: (4, 4) pose of the root.
        
        Raises ValueError that names the element at fault.
        """
    @staticmethod
    def from_urdf_file(path: str, srdf: str = '', packages: collections.abc.Mapping[str, str] = {}, X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> Robot:
        """
        Reads a .urdf file; a .srdf of the same name beside it is read too unless srdf (text) is given.
        """
    def __repr__(self) -> str:
        ...
    def clamp(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        q, (dof,), brought within the limits.
        """
    def forward(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        (num_frames, 4, 4) poses of all links in the world at q, (dof,) [rad or m].
        """
    def frame(self, name: str) -> int:
        """
        Index of a link; ValueError lists the links.
        """
    def group(self, name: str) -> list[int]:
        """
        Joint indices of a group; ValueError lists the groups.
        """
    def is_within(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-09) -> bool:
        """
        Whether q, (dof,), is within the limits, with a slack of tolerance [rad or m].
        """
    def jacobian(self, frame: str | typing.SupportsInt | typing.SupportsIndex, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (6, dof) Jacobian of a link's origin in the world at q, (dof,); linear rows first.
        """
    def joint(self, name: str) -> int:
        """
        Index of an independent joint; ValueError lists the joints.
        """
    def parent(self, frame: str | typing.SupportsInt | typing.SupportsIndex) -> int:
        """
        Index of the parent link; -1 for the root.
        """
    def pose(self, frame: str | typing.SupportsInt | typing.SupportsIndex, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of a link, by name or index, in the world at q, (dof,).
        """
    def reach(self, link: str | typing.SupportsInt | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) upper bound on how far any point of a link moves per unit of each joint [m/rad or 1].
        """
    def state(self, name: str) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) configuration of a group state; joints it does not name are 0, clamped to their limits.
        """
    @property
    def X_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the root link in the world.
        """
    @property
    def dof(self) -> int:
        """
        Number of independent joints.
        """
    @property
    def frame_names(self) -> list[str]:
        """
        Every link, in the order of forward().
        """
    @property
    def group_names(self) -> list[str]:
        """
        Groups of the SRDF.
        """
    @property
    def ignored_pairs(self) -> set[tuple[int, int]]:
        """
        Pairs of link indices, smaller first, that are never tested for collision.
        """
    @property
    def joint_names(self) -> list[str]:
        """
        The independent joints, in the order of q.
        """
    @property
    def lower(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) lower limits [rad or m]; a continuous joint has -pi.
        """
    @property
    def max_effort(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) [Nm or N].
        """
    @property
    def max_velocity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) [rad/s or m/s]; inf where the URDF has none.
        """
    @property
    def name(self) -> str:
        """
        The URDF's name.
        """
    @property
    def shapes(self) -> list[tuple[int, graspless._core.geometry.PlacedShape]]:
        """
        Collision shapes: pairs of a link's index and a shape placed in its frame.
        """
    @property
    def state_names(self) -> list[str]:
        """
        Group states of the SRDF.
        """
    @property
    def upper(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) upper limits [rad or m]; a continuous joint has pi.
        """
class Ik:
    """
    Inverse kinematics of one frame by the joints of one serial group; other joints stay.
    
    Closed form for arms like the Barrett WAM, damped least squares for any other chain.
    """
    def __init__(self, robot: Robot, frame: str | typing.SupportsInt | typing.SupportsIndex, group: str | collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], *, tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-09, max_iterations: typing.SupportsInt | typing.SupportsIndex = 60, restarts: typing.SupportsInt | typing.SupportsIndex = 12, free_samples: typing.SupportsInt | typing.SupportsIndex = 16) -> None:
        """
        frame: a link's name or index. group: a group's name, or joint indices from the base outwards.
        tolerance: largest pose error of an answer [m, rad]. max_iterations: of least squares, per attempt.
        restarts: random seeds of least squares. free_samples: values of the free joint tried.
        """
    def __repr__(self) -> str:
        ...
    def solve_all(self, X_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], seed: typing.SupportsInt | typing.SupportsIndex = 1) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (K, dof) all solutions found that put the frame at X_WF, (4, 4), nearest to q, (dof,), first.
        """
    def solve_free(self, X_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], free_joint: typing.SupportsFloat | typing.SupportsIndex, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (K, dof) all solutions within the limits for one value of the free joint, the group's third [rad].
        
        Raises ValueError for a chain without closed form.
        """
    def solve_near(self, X_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"] | None:
        """
        (dof,) the one solution that continues from q, or None when it does not converge within the limits.
        """
    @property
    def group(self) -> list[int]:
        """
        Joint indices, from the base outwards.
        """
    @property
    def is_closed_form(self) -> bool:
        """
        Whether the chain has a closed form.
        """
