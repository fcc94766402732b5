# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""World of a fingertip task in MuJoCo: planes, object, and spheres that servos move."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ..obstacles import add_obstacle
from ..robots import apply, unused
from ..settings import Fingertip, Solver
from ..shapes import add_plane, give_inertia

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from numpy.typing import NDArray

    from ... import fingertip
    from ...frames import Matrix
    from ..variation import Variation

    FrictionAt = Callable[[Iterable[float]], float]

PLANE, OBJECT, FINGER, OBSTACLE = "plane", "object", "finger", "obstacle"

# Collision bits. Allowed contacts are explicit pairs; any other contact counts as a hit.
_ROBOT, _OBSTACLE = 1, 2  # a URDF's geoms have MuJoCo's own bit, on either side
_PLANE_TOUCHES = {"contype": _ROBOT, "conaffinity": 0}
_OBJECT_TOUCHES = {"contype": _ROBOT, "conaffinity": _OBSTACLE}
_FINGER_TOUCHES = {"contype": 0, "conaffinity": _OBSTACLE}
_OBSTACLE_TOUCHES = {"contype": _ROBOT | _OBSTACLE, "conaffinity": 0}
_NOTHING = {"contype": 0, "conaffinity": 0}


@dataclass(frozen=True)
class World:
    """A model and the indices of its parts.

    Attributes
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
    settings : settings.Fingertip
    problem : fingertip.Problem
    finger_of_geom : dict
        Which finger each of the fingers' geoms belongs to.
    """

    model: Any
    data: Any
    settings: Fingertip
    problem: fingertip.Problem
    finger_of_geom: dict[int, int]

    @cached_property
    def hull(self) -> Matrix:
        """Corners of the object [N, 3] in O [m]."""
        return np.array(self.problem.object.hull)

    @cached_property
    def kinds(self) -> NDArray[np.str_]:
        """Role of each geom [G + 1]: object, plane, finger, robot or obstacle.

        The last is what MuJoCo numbers -1, no geom: a mesh that is an obstacle.
        """
        model = self.model
        found = np.full(model.ngeom + 1, "robot", dtype="<U8")
        body, is_plane = model.geom_bodyid, model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
        found[:-1][body == 0] = OBSTACLE
        found[:-1][is_plane] = PLANE
        found[:-1][body == model.body(OBJECT).id] = OBJECT
        found[list(self.finger_of_geom)] = FINGER
        found[-1] = OBSTACLE
        return found

    @cached_property
    def fingers(self) -> int:
        """Number of fingers."""
        return self.problem.fingers.count

    @cached_property
    def radius(self) -> float:
        """Radius of the fingertips [m]."""
        return self.problem.fingers.radius

    @cached_property
    def object_qpos(self) -> Matrix:
        """Position [m] and quaternion of the object [7]; a view."""
        at = self.model.jnt_qposadr[self.model.body(OBJECT).jntadr[0]]
        qpos: Matrix = self.data.qpos[at : at + 7]
        return qpos

    @property
    def X_WO(self) -> Matrix:
        """Pose of the object."""
        return frames.from_row(self.object_qpos)

    @property
    def centers(self) -> Matrix:
        """Positions of the fingertips [n, 3] [m]."""
        centers: Matrix = self.data.qpos[7:].reshape(-1, 7)[:, :3]
        return centers

    @property
    def joint_positions(self) -> Matrix:
        """Configuration of the arm: empty, as there is none."""
        return np.zeros(0)

    def place(self, X_WO: Matrix, centers: Matrix) -> None:
        """Puts everything at the given positions, at rest; fingertips turn with the object."""
        self.object_qpos[:] = frames.to_row(X_WO)
        fingers = self.data.qpos[7:].reshape(-1, 7)
        fingers[:, :3], fingers[:, 3:] = centers, frames.to_quaternion(X_WO)
        self.data.qvel[:] = 0
        mujoco.mj_forward(self.model, self.data)

    def push(self, wrench_O: Matrix) -> None:
        """Applies a constant wrench to the object about its centre of mass, in O [N, N m]."""
        body = self.model.body(OBJECT).id
        R_WO = frames.from_quaternion(self.object_qpos[3:])[:3, :3]
        self.data.xfrc_applied[body] = np.concatenate([R_WO @ wrench_O[:3], R_WO @ wrench_O[3:]])

    def carry(self, place: Matrix, weight: float, rate: float) -> None:
        """Carries a share of the object's weight, and draws it to a place [7] by a damped spring.

        `rate` is that of the spring's oscillation [rad/s]; 0: no spring.
        """
        body, model = self.model.body(OBJECT).id, self.model
        mass, inertia = float(model.body_mass[body]), float(model.body_inertia[body].max())
        turn_O = np.zeros(3)
        mujoco.mju_subQuat(turn_O, place[3:], self.object_qpos[3:])
        R_WO = frames.from_quaternion(self.object_qpos[3:])[:3, :3]
        off = place[:3] - self.object_qpos[:3]
        force = rate**2 * off - 2 * rate * self.data.qvel[:3] - weight * model.opt.gravity
        torque_O = rate**2 * turn_O - 2 * rate * self.data.qvel[3:6]
        self.data.xfrc_applied[body] = np.concatenate([mass * force, inertia * R_WO @ torque_O])

    def stiffen(self) -> None:
        """Sets the parameters of all contacts to sticking."""
        s = self.settings
        self.model.pair_solref[:], self.model.pair_solimp[:] = s.stick_solref, s.stick_solimp

    def soften(self, *, slides: bool) -> None:
        """Sets the parameters of contacts with planes for an object that slides, or does not."""
        s, planes = self.settings, slice(0, len(self.problem.planes))
        self.model.pair_solref[planes] = s.slide_solref if slides else s.stick_solref
        self.model.pair_solimp[planes] = s.slide_solimp if slides else s.stick_solimp


def middle(interval: Iterable[float]) -> float:
    """Returns the middle of an interval of friction."""
    return float(np.mean(list(interval)))


def build_world(
    problem: fingertip.Problem,
    variation: Variation,
    settings: Fingertip | None = None,
    *,
    friction_at: FrictionAt = middle,
) -> World:
    """Makes the world of a problem with varied friction and mass; positions are not set yet.

    Of these only what the planner lets touch can touch: the object's hull with planes, its surface
    with fingertips. Obstacles stop both. `friction_at` says what is taken of friction's
    interval.
    """
    settings = settings or Fingertip()
    spec = mujoco.MjSpec()
    apply(spec, Solver(timestep=settings.timestep * variation.timestep))
    names = [f"{FINGER}{i}" for i in range(problem.fingers.count)]
    add_scene(spec, problem, variation, friction_at)
    for name in names:
        _add_finger(spec, name, problem.fingers.radius, settings)
    add_finger_pairs(spec, problem, variation, names, friction_at)
    model = spec.compile()
    finger_of_geom = {model.geom(name).id: i for i, name in enumerate(names)}
    world = World(model, mujoco.MjData(model), settings, problem, finger_of_geom)
    world.stiffen()
    return world


def add_scene(
    spec: Any,
    problem: fingertip.Problem,
    variation: Variation,
    friction_at: FrictionAt = middle,
) -> None:
    """Adds planes, the object, which may touch them, and obstacles."""
    spec.option.gravity = problem.gravity_W
    body = _add_object(spec, problem.object, variation.mass)
    if not problem.object.is_convex:
        _add_skin(spec, body, problem.object, Fingertip().skin * problem.fingers.radius)
    for obstacle in problem.obstacles:
        add_obstacle(spec, obstacle, Fingertip().obstacle_skin, **_OBSTACLE_TOUCHES)
    for i, plane in enumerate(problem.planes):
        add_plane(spec, plane, f"{PLANE}{i}", **_PLANE_TOUCHES)
        friction = friction_at(plane.friction or problem.friction)
        _add_pair(spec, f"{PLANE}{i}", friction * variation.support_friction)


def add_finger_pairs(
    spec: Any,
    problem: fingertip.Problem,
    variation: Variation,
    names: Sequence[str],
    friction_at: FrictionAt = middle,
) -> None:
    """Adds the contact pairs of fingers with the object, then with the planes."""
    friction = friction_at(problem.fingers.friction) * variation.friction
    surface = [OBJECT]
    if not problem.object.is_convex:
        surface = [f"{OBJECT} {i}" for i in range(len(problem.object.mesh.triangles))]
    for name in names:
        for part in surface:
            _add_pair(spec, name, friction, part)


def _add_object(spec: Any, thing: fingertip.Object, factor: float) -> Any:
    body = spec.worldbody.add_body(name=unused(spec, OBJECT))
    body.add_freejoint()
    give_inertia(body, thing.mass * factor, thing.com, np.asarray(thing.inertia) * factor)
    spec.add_mesh(name="hull", uservert=np.asarray(thing.hull).ravel())
    size = _box_size(np.asarray(thing.hull))
    touches = _OBJECT_TOUCHES if thing.is_convex else _NOTHING
    geom = body.add_geom(name=OBJECT, mass=0, **touches)
    if size is not None:
        center = (thing.hull.max(axis=0) + thing.hull.min(axis=0)) / 2
        geom.type, geom.size, geom.pos = mujoco.mjtGeom.mjGEOM_BOX, size / 2, center
    else:
        geom.type, geom.meshname = mujoco.mjtGeom.mjGEOM_MESH, "hull"
    return body


def _add_skin(spec: Any, body: Any, thing: fingertip.Object, depth: float) -> None:
    """Adds a prism under every triangle of the surface, so that the object need not be convex."""
    for i, triangle in enumerate(np.asarray(thing.mesh.triangles)):
        corners = np.asarray(thing.mesh.vertices)[triangle]
        out = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        inner = corners - depth * out / np.linalg.norm(out)
        name = f"{OBJECT} {i}"
        spec.add_mesh(name=name, uservert=np.concatenate([corners, inner]).ravel())
        body.add_geom(
            name=name, type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, mass=0, **_OBJECT_TOUCHES,
        )  # fmt: skip


def _box_size(hull: Matrix) -> Matrix | None:
    """Returns the side lengths if the corners are those of a box along the axes of O, else None."""
    lower, upper = hull.min(axis=0), hull.max(axis=0)
    at_corner = np.minimum(np.abs(hull - lower), np.abs(hull - upper)).max() < 1e-9
    return upper - lower if len(hull) == 8 and at_corner else None


def _add_finger(spec: Any, name: str, radius: float, settings: Fingertip) -> None:
    """Adds a sphere on three sliding joints along the world axes and a ball joint with servos."""
    body = spec.worldbody.add_body(name=name, gravcomp=1)
    damping = 2 * settings.damping_ratio * np.sqrt(settings.stiffness * settings.mass)
    for axis in np.eye(3):
        body.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE, axis=axis, damping=[damping, 0, 0])
    # The same natural frequency for rotation, at the given stiffness.
    share = settings.turning * radius**2
    body.add_joint(type=mujoco.mjtJoint.mjJNT_BALL, damping=[damping * share, 0, 0])
    body.explicitinertial, body.mass = True, settings.mass
    body.inertia = [settings.mass * share] * 3
    body.add_geom(
        name=name, type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[radius, 0, 0], mass=0,
        **_FINGER_TOUCHES,
    )  # fmt: skip


def _add_pair(spec: Any, name: str, friction: float, part: str = OBJECT) -> None:
    """Adds a contact pair with the object; otherwise MuJoCo takes the larger friction of two."""
    spec.add_pair(geomname1=name, geomname2=part, condim=3, friction=[friction] * 5)
