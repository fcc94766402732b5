# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots in MuJoCo, which reads their URDF; every joint gets a position servo."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING, Any, NamedTuple

import mujoco
import numpy as np

from .. import frames, geometry
from .._xml import parse
from ..errors import TaskError, warn
from ..tasks.meshes import mesh_path
from .settings import Servo, Solver

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..frames import Matrix
    from ..robot import Robot
    from ..tasks.robots import Robot as RobotFields


def compiled(spec: Any) -> Any:
    """Returns the mujoco.MjModel of a specification.

    Raises TaskError that names a moving link without mass, which planners do not need.
    """
    try:
        return spec.compile()
    except ValueError as error:
        link = re.search(r"mjMINVAL[^']*'(.*?)'", str(error).replace("\n", " "))
        if link is None:
            raise
        raise TaskError(
            f"link '{link[1]}' moves and has no mass or inertia, which MuJoCo needs: add an "
            "<inertial> to it in the URDF"
        ) from None


def unused(spec: Any, name: str) -> str:
    """Returns the name of a new body; raises TaskError if a link has it."""
    if spec.body(name) is not None:
        raise TaskError(
            f"link '{name}' has the name of another body of the simulation: rename it in the URDF"
        )
    return name


def placed_body(spec: Any, name: str, X_WB: Matrix) -> Any:
    """Adds a body at a pose in the world; raises TaskError if a link has its name."""
    place = {"pos": X_WB[:3, 3], "quat": frames.to_quaternion(X_WB)}
    return spec.worldbody.add_body(name=unused(spec, name), **place)


def robot_spec(
    robot: Robot,
    fields: RobotFields,
    excluded: Iterable[tuple[int, int]] | None = None,
) -> Any:
    """Returns a mujoco.MjSpec of a world with the robot alone.

    Bodies and joints have the URDF's names, an actuator that of its joint. Pairs of links that
    the planner never tests do not collide; gravity is compensated; mimic joints are coupled.

    Parameters
    ----------
    robot : Robot
        Gives the order of joints, the base and the pairs of links.
    fields : tasks.robots.Robot
        Fields of a resolved task, with the text of the URDF.
    excluded : pairs of int, optional
        Links that do not collide with each other; `untested_pairs` by default.
    """
    servo = Servo()
    _warn_of_efforts(robot, servo)
    excluded = untested_pairs(robot) if excluded is None else excluded
    xml, assets = _model(fields)
    spec = mujoco.MjSpec.from_string(xml, assets=assets)
    apply(spec)
    names = list(robot.frame_names)
    _place(spec, names[0], robot.X_WB)
    for body in spec.bodies:
        if body.name in names:
            body.gravcomp = 1.0
    for i, j in excluded:
        spec.add_exclude(bodyname1=names[i], bodyname2=names[j])
    for name, effort, weight in zip(
        robot.joint_names, robot.max_effort, robot.step_weights, strict=True
    ):
        _add_servo(spec, name, float(effort), float(weight), servo)
    for equality in spec.equalities:  # mimic joints: a light follower would yield to a touch
        follower = spec.joint(equality.name1)
        follower.armature = spec.joint(equality.name2).armature
        follower.limited = mujoco.mjtLimited.mjLIMITED_FALSE  # as in the plan: its driver's hold
        equality.solimp[:2] = servo.mimic_solimp
    return spec


def _warn_of_efforts(robot: Robot, servo: Servo) -> None:
    """Warns of joints whose effort limit is unknown: not in the URDF, or 0."""
    limits = zip(robot.joint_names, robot.max_effort, strict=True)
    unknown = [f"'{name}'" for name, effort in limits if not np.isfinite(effort)]
    if unknown:
        more = f" and {len(unknown) - 5} more" if len(unknown) > 5 else ""
        warn(
            f"joint {', '.join(unknown[:5])}{more}: the URDF has no effort limit above 0, so the "
            f"simulation takes {servo.effort:g} Nm (of sliding joints: N); give <limit effort=...>"
        )


def _place(spec: Any, root: str, X_WB: Matrix) -> None:
    """Moves a robot to its pose. A root link that is called world is MuJoCo's own world."""
    moved = [spec.body(root)]
    if root == "world":
        moved = [*spec.worldbody.bodies, *spec.worldbody.geoms]
    for part in moved:
        X_WP = X_WB @ frames.translation(part.pos) @ frames.from_quaternion(part.quat)
        part.pos, part.quat = X_WP[:3, 3], frames.to_quaternion(X_WP)


def untested_pairs(robot: Robot) -> list[tuple[int, int]]:
    """Returns the pairs of links that do not collide: those that the planner never tests.

    Also every pair with a mesh that is not a convex solid. MuJoCo puts its hull in its place, and
    hulls touch where the links do not.
    """
    hulls = {link for link, placed in robot.shapes if isinstance(placed.shape, geometry.Mesh)}
    links = range(len(robot.frame_names))
    pairs = {(min(i, j), max(i, j)) for i in hulls for j in links if i != j}
    return sorted(pairs | set(robot.ignored_pairs))


def apply(spec: Any, solver: Solver | None = None) -> None:
    """Sets the parameters of the solver in a model."""
    solver = solver or Solver()
    spec.option.timestep = solver.timestep
    spec.option.cone = getattr(mujoco.mjtCone, f"mjCONE_{solver.cone.upper()}")
    spec.option.impratio = solver.impratio
    integrator = f"mjINT_{solver.integrator.upper()}"
    spec.option.integrator = getattr(mujoco.mjtIntegrator, integrator)
    spec.option.tolerance = solver.tolerance
    spec.option.iterations = solver.iterations


def joint_addresses(model: Any, robot: Robot) -> Any:
    """Returns the indices [dof] of the joints of the robot in qpos."""
    return np.array([model.joint(name).qposadr[0] for name in robot.joint_names])


def set_positions(model: Any, data: Any, robot: Robot, q: Any) -> None:
    """Puts the robot at rest at q [dof], commanded to stay there, mimic joints included."""
    data.qpos[joint_addresses(model, robot)] = data.ctrl[:] = q
    for equality in np.flatnonzero(model.eq_type == mujoco.mjtEq.mjEQ_JOINT):
        follower, leader = model.eq_obj1id[equality], model.eq_obj2id[equality]
        offset, factor = model.eq_data[equality][:2]
        followed = data.qpos[model.jnt_qposadr[leader]]
        data.qpos[model.jnt_qposadr[follower]] = offset + factor * followed
    mujoco.mj_forward(model, data)


def lags(robot: Robot) -> Matrix:
    """Returns how long each joint [dof] lags behind its command at constant velocity [s]."""
    delays: Matrix = Servo().lag / np.sqrt(robot.step_weights)
    return delays


def _add_servo(spec: Any, name: str, effort: float, weight: float, servo: Servo) -> None:
    """Adds a position servo that deflects by `servo.sag` at its maximum effort.

    `weight` is that of steps of the joint, 10 rad/m for a prismatic one: it deflects by a tenth of
    the sag in metres. Its mass is that of a servo with the whole sag, so its bandwidth is larger.
    """
    given = gains(effort, weight, servo)
    spec.joint(name).armature = given.rotor
    actuator = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    actuator.set_to_position(kp=given.stiffness, kv=given.damping)
    actuator.forcelimited, actuator.forcerange = True, [-given.effort, given.effort]


class Gains(NamedTuple):
    """Position servo of a joint: its stiffness, damping, inertia of the rotor and largest effort.

    In N, m, s and rad.
    """

    stiffness: float
    damping: float
    rotor: float
    effort: float


def gains(effort: float, weight: float, servo: Servo) -> Gains:
    """Returns the gains of a servo. `effort` may be 0 or infinite: that of the URDF."""
    effort = effort if np.isfinite(effort) and effort > 0 else servo.effort
    stiffness = effort * weight / servo.sag
    bandwidth = servo.bandwidth * float(np.sqrt(weight))
    damping = 2 * servo.damping_ratio * stiffness / bandwidth
    return Gains(stiffness, damping, stiffness / bandwidth**2, effort)


def _require_whole_inertial(link: ET.Element) -> None:
    inertial = link.find("inertial")
    if inertial is None:
        return
    for part in ("mass", "inertia"):
        if inertial.find(part) is None:
            name = link.get("name")
            raise TaskError(f"link '{name}': its <inertial> has no {part}; the simulation needs it")


def _model(fields: RobotFields) -> tuple[str, dict[str, bytes]]:
    """Returns the URDF for MuJoCo, and its meshes as STL files, except .obj.

    Paths of meshes are absolute, all links are kept separate, shapes have no names, and nothing
    is drawn.
    """
    root = parse(fields.urdf_text or "")
    for link in root.iter("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
        _require_whole_inertial(link)
    for collision in root.iter("collision"):  # names need not differ, nor differ from ours
        collision.attrib.pop("name", None)
    assets: dict[str, bytes] = {}
    for mesh in root.iter("mesh"):
        path = mesh_path(mesh.get("filename", ""), fields.packages, fields.directory)
        name = str(path)
        if path.suffix.lower() != ".obj":  # of .stl, it reads only binary ones
            name = f"converted_{len(assets)}.stl"
            assets[name] = _as_stl(str(path))
        mesh.set("filename", name)
    for joint in root.iter("joint"):
        if joint.get("type") in ("floating", "planar"):  # at the root, where they do not move
            joint.set("type", "fixed")
    settings = {
        "fusestatic": "false",
        "strippath": "false",
        "discardvisual": "true",
        "balanceinertia": "true",
    }
    ET.SubElement(ET.SubElement(root, "mujoco"), "compiler", settings)
    return ET.tostring(root, encoding="unicode"), assets


def _as_stl(path: str) -> bytes:
    """Returns a mesh as a binary STL file."""
    mesh = geometry.read_mesh(path)
    triangles = np.asarray(mesh.vertices, dtype="<f4")[np.asarray(mesh.triangles)]
    rows = np.zeros(len(triangles), dtype=[("n", "<f4", 3), ("p", "<f4", (3, 3)), ("end", "<u2")])
    rows["p"] = triangles
    return bytes(80) + len(rows).to_bytes(4, "little") + rows.tobytes()
