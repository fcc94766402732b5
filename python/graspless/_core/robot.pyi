"""
Robots read from URDF, and their inverse kinematics.
"""
from __future__ import annotations
import collections.abc
import graspless._core.geometry
import numpy
import numpy.typing
import os
import typing
__all__: list[str] = ['Description', 'Ik', 'Robot', 'find_packages', 'join']
class Robot:
    """
    A rigid-body tree read from a URDF. Immutable and thread-safe.
    
    A configuration q holds the independent joints [rad or m]; mimic joints follow the joints that they mimic.
    """
    @staticmethod
    def from_urdf(xml: str, srdf: str = '', packages: collections.abc.Mapping[str, str] = {}, directory: str = '', X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> Robot:
        """
        Reads URDF text. srdf: SRDF text with groups, states and disabled collisions. packages: directory of each
        package://NAME/. directory: that relative mesh paths start from. X_WB: (4, 4) pose of the root in the world.
        
        Raises ValueError that names the faulty element.
        """
    @staticmethod
    def from_urdf_file(path: os.PathLike[str] | str, srdf: str = '', packages: collections.abc.Mapping[str, str] = {}, X_WB: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ...) -> Robot:
        """
        Reads a .urdf file. Unless srdf (text) is given, also reads a .srdf file of the same name in the same directory.
        
        Raises ValueError that names the faulty element.
        """
    def __repr__(self) -> str:
        ...
    def clamp(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Returns q, (dof,), clamped to the joint limits.
        """
    def forward(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Returns the poses of all links in the world, (num_frames, 4, 4), at q, (dof,) [rad or m].
        """
    def frame(self, name: str) -> int:
        """
        Returns the index of a link.
        
        Raises ValueError that lists the links.
        """
    def group(self, name: str) -> list[int]:
        """
        Returns the joint indices of a group.
        
        Raises ValueError that lists the groups, or says what is wrong with this one.
        """
    def is_within(self, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-09) -> bool:
        """
        Returns True if q, (dof,), is within the joint limits, up to tolerance [rad or m].
        """
    def jacobian(self, frame: str | typing.SupportsInt | typing.SupportsIndex, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Returns the Jacobian of a link's origin in the world, (6, dof), at q, (dof,); linear rows first. At many configurations, (N, dof), it is (N, 6, dof).
        """
    def joint(self, name: str) -> int:
        """
        Returns the index of an independent joint.
        
        Raises ValueError that lists the joints.
        """
    def parent(self, frame: str | typing.SupportsInt | typing.SupportsIndex) -> int:
        """
        Returns the index of the parent link; -1 for the root.
        """
    def pose(self, frame: str | typing.SupportsInt | typing.SupportsIndex, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        Returns the pose of a link, given by name or index, in the world, (4, 4), at q, (dof,) [rad or m].
        """
    def reach(self, link: str | typing.SupportsInt | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Returns an upper bound on how far any point of a link's shapes moves per unit of each joint, (dof,) [m/rad or 1]; of a link without shapes, its origin.
        """
    def state(self, name: str, others: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Returns the configuration of a group state, (dof,). Joints that it does not name are as in others, or 0, clamped to their limits.
        
        Raises ValueError that lists the states, or says what is wrong with this one.
        """
    @property
    def X_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (4, 4) pose of the root link in the world.
        """
    @property
    def directory(self) -> str:
        """
        Folder that relative mesh paths start from.
        """
    @property
    def dof(self) -> int:
        """
        Number of independent joints.
        """
    @property
    def frame_names(self) -> list[str]:
        """
        All links, in the order of forward().
        """
    @property
    def group_names(self) -> list[str]:
        """
        Names of the SRDF's groups.
        """
    @property
    def ignored_pairs(self) -> set[tuple[int, int]]:
        """
        Pairs of link indices, smaller first, that are never tested for collision.
        """
    @property
    def joint_names(self) -> list[str]:
        """
        Independent joints, in the order of q.
        """
    @property
    def lower(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) lower limits [rad or m]; a continuous joint has -pi.
        """
    @property
    def max_effort(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) largest efforts [Nm or N]; inf if the URDF has none, or 0.
        """
    @property
    def max_velocity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) largest velocities [rad/s or m/s]; inf if the URDF has none, or 0.
        """
    @property
    def name(self) -> str:
        """
        Name in the URDF.
        """
    @property
    def packages(self) -> dict[str, str]:
        """
        Folders that package://NAME/ points to; a copy.
        """
    @property
    def shapes(self) -> list[tuple[int, graspless._core.geometry.PlacedShape]]:
        """
        Collision shapes: pairs of a link's index and a shape placed in the link's frame.
        """
    @property
    def srdf(self) -> str:
        """
        SRDF text that the robot was read with; empty: none.
        """
    @property
    def state_names(self) -> list[str]:
        """
        Names of the SRDF's group states.
        """
    @property
    def step_weights(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) factors of the joints in the length of a step: 1 for a revolute joint, 10 rad/m for a prismatic one.
        """
    @property
    def upper(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (dof,) upper limits [rad or m]; a continuous joint has pi.
        """
    @property
    def urdf(self) -> str:
        """
        URDF text that the robot was read from.
        """
    @property
    def warnings(self) -> list[str]:
        """
        Parts of URDF and SRDF that were ignored or changed, one sentence each: for instance
        links without a collision shape, or an entry of the SRDF that names an unknown link.
        """
class Description:
    """
    Texts of a robot's files.
    """
    def __init__(self, urdf: str, srdf: str = '', packages: collections.abc.Mapping[str, str] = {}, directory: str = '') -> None:
        """
        urdf, srdf: texts. packages: directory of each package://NAME/. directory: that relative mesh paths start from.
        """
    def __repr__(self) -> str:
        ...
    @property
    def directory(self) -> str:
        """
        Directory that relative mesh paths start from.
        """
    @directory.setter
    def directory(self, arg0: str) -> None:
        ...
    @property
    def packages(self) -> dict[str, str]:
        """
        Directory of each package://NAME/.
        """
    @packages.setter
    def packages(self, arg0: collections.abc.Mapping[str, str]) -> None:
        ...
    @property
    def srdf(self) -> str:
        """
        SRDF text; empty: none.
        """
    @srdf.setter
    def srdf(self, arg0: str) -> None:
        ...
    @property
    def urdf(self) -> str:
        """
        URDF text.
        """
    @urdf.setter
    def urdf(self, arg0: str) -> None:
        ...
class Ik:
    """
    Inverse kinematics of one frame with the joints of one serial group; all other joints stay as given.
    
    Closed form for most arms of six or seven revolute joints, damped least squares for any other chain.
    """
    def __init__(self, robot: Robot, frame: str | typing.SupportsInt | typing.SupportsIndex, group: str | collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], *, tolerance: typing.SupportsFloat | typing.SupportsIndex = 1e-09, lean: typing.SupportsFloat | typing.SupportsIndex = 0.0, max_iterations: typing.SupportsInt | typing.SupportsIndex = 60, restarts: typing.SupportsInt | typing.SupportsIndex = 12, free_samples: typing.SupportsInt | typing.SupportsIndex = 16) -> None:
        """
        frame: a link's name or index. group: a group's name, or joint indices from the base outwards.
        tolerance: largest pose error of a solution [m, rad]. lean: angle error that is allowed where least squares cannot turn the frame further, as with five joints; at most 0.1 [rad].
        max_iterations: of least squares, per attempt. restarts: random restarts of least squares. free_samples: values of the free joint tried in closed form, at most 10000.
        
        Raises ValueError if a joint of the group does not move the frame.
        """
    def __repr__(self) -> str:
        ...
    def solve_all(self, X_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], seed: typing.SupportsInt | typing.SupportsIndex = 1) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        Returns all solutions found that put the frame at X_WF, (4, 4), in the world: (K, dof), nearest to q, (dof,), first.
        """
    def solve_free(self, X_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], free_joint: typing.SupportsFloat | typing.SupportsIndex, q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        Returns all solutions within the limits for one value of the free joint [rad]: (K, dof). Without a free joint, the value is ignored.
        
        Raises ValueError for a chain without closed form.
        """
    def solve_near(self, X_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"] | None:
        """
        Returns the solution that continues from q, (dof,), or None if it does not converge within the limits.
        """
    @property
    def free_joint(self) -> int | None:
        """
        Index of the joint whose value solve_free() takes. None for six joints, and for a chain without closed form.
        """
    @property
    def group(self) -> list[int]:
        """
        Joint indices, from the base outwards.
        """
    @property
    def is_closed_form(self) -> bool:
        """
        True if the chain has a closed form.
        """
def find_packages(description: Description) -> dict[str, str]:
    """
    Returns the packages of a description, and those that its meshes name as package://NAME/...
    
    Looks in ROS_PACKAGE_PATH, in AMENT_PREFIX_PATH (share/NAME), and in the folders above the directory: one called NAME,
    one that contains NAME or, failing that, one that contains the mesh itself. The first folder that contains the mesh is used.
    
    Raises ValueError that says where a collision mesh's package was looked for.
    """
def join(arm: Description, gripper: Description, mount: str, X_MG: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., prefix: str = '', root: str = '') -> Description:
    """
    Returns the description of an arm with a gripper. A fixed joint carries the root link of the gripper.
    
    arm, gripper: descriptions. mount: link M of the arm. X_MG: (4, 4) pose of the gripper's root link in M.
    prefix: put before all names of the gripper; empty: ``gripper_``, before names that the arm has too. Paths of meshes
    become absolute. States of the same name are merged.
    root: link of the gripper to mount, with all that it carries and without its SRDF; empty: all links.
    
    Raises ValueError that names the faulty description, the unknown link, or names that clash.
    """
