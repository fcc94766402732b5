# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots, and bare fingertips, as URDFs for Drake: meshes as OBJ, each joint with a servo."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import geometry
from .._xml import parse
from ..simulation.robots import Gains, gains, untested_pairs
from ..simulation.settings import Fingertip, Servo
from ..tasks.meshes import mesh_path
from ..view.visuals import UnreadableError, read_visual, warn_once
from .drake_sdf import Meshes, numbers

if TYPE_CHECKING:
    from ..robot import Robot
    from ..tasks.robots import Robot as RobotFields
    from .things import Thing

ROOT = "graspless_base"  # frame that is welded to the world
_REACH = 10.0  # of a bare fingertip from the origin [m]


def robot_urdf(robot: Robot, fields: RobotFields, meshes: Meshes) -> str:
    """Returns the URDF of a robot below a link ROOT, with the servos of `simulate`."""
    root = parse(fields.urdf_text or "")
    root.set("xmlns:drake", "http://drake.mit.edu")
    for element in [*root.findall("transmission"), *root.findall("gazebo")]:
        root.remove(element)
    names = _name_root(root, list(robot.frame_names))
    for link in root.iter("link"):
        for visual in link.findall("visual"):
            _convert_visual(link, visual, fields, meshes)
        for mesh in link.iterfind("collision/geometry/mesh"):
            path = mesh_path(mesh.get("filename", ""), fields.packages, fields.directory)
            read = geometry.read_mesh(str(path))
            mesh.set("filename", meshes.add(read.vertices, read.triangles))
    for joint in root.iter("joint"):
        if joint.get("type") in ("floating", "planar"):  # at the root, where they do not move
            joint.set("type", "fixed")
    weights = zip(robot.joint_names, robot.max_effort, robot.step_weights, strict=True)
    for name, effort, weight in weights:
        _add_servo(root, name, gains(float(effort), float(weight), Servo()))
    _add_filters(root, names, untested_pairs(robot))
    ET.indent(root)
    return ET.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def fingers_urdf(fingers: list[Thing]) -> str:
    """Returns a URDF of spheres that three sliding joints each, along x, y and z, move."""
    root = ET.Element("robot", {"name": "fingers", "xmlns:drake": "http://drake.mit.edu"})
    ET.SubElement(root, "link", name=ROOT)
    settings = Fingertip()
    damping = 2 * settings.damping_ratio * (settings.stiffness * settings.mass) ** 0.5
    servo = Gains(settings.stiffness, damping, 0.0, Servo().effort)
    for finger in fingers:
        parent = ROOT
        for axis, direction in zip("xyz", np.eye(3), strict=True):
            name = f"{finger.name}_{axis}"
            child = finger.name if axis == "z" else f"{name}_slider"
            joint = ET.SubElement(root, "joint", name=name, type="prismatic")
            ET.SubElement(joint, "parent", link=parent)
            ET.SubElement(joint, "child", link=child)
            ET.SubElement(joint, "axis", xyz=numbers(direction))
            ET.SubElement(joint, "limit", lower=repr(-_REACH), upper=repr(_REACH), velocity="1")
            parent = child
            link = ET.SubElement(root, "link", name=child)
            _add_servo(root, name, servo)
        _add_ball(link, finger, settings.mass)
    ET.indent(root)
    return ET.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _add_ball(link: ET.Element, finger: Thing, mass: float) -> None:
    (ball,) = finger.shapes
    (radius,) = ball.size
    moment = repr(0.4 * mass * radius**2)
    inertial = ET.SubElement(link, "inertial")
    ET.SubElement(inertial, "mass", value=repr(mass))
    inertia = dict.fromkeys(("ixx", "iyy", "izz"), moment)
    ET.SubElement(inertial, "inertia", inertia | dict.fromkeys(("ixy", "ixz", "iyz"), "0"))
    for role in ("visual", "collision"):
        element = ET.SubElement(link, role)
        ET.SubElement(ET.SubElement(element, "geometry"), "sphere", radius=repr(radius))
    touch = ET.SubElement(element, "drake:proximity_properties")
    for tag in ("drake:mu_dynamic", "drake:mu_static"):
        ET.SubElement(touch, tag, value=repr(ball.friction))


def _name_root(root: ET.Element, names: list[str]) -> list[str]:
    """Puts a link ROOT above the robot; returns the names of its links, of which none is world.

    Drake would take a link that is called world for its own world.
    """
    known = {"world": f"{ROOT}_world"}
    for link in root.iter("link"):
        link.set("name", known.get(link.get("name", ""), link.get("name", "")))
    for tag in ("parent", "child"):
        for end in root.iterfind(f"joint/{tag}"):
            end.set("link", known.get(end.get("link", ""), end.get("link", "")))
    renamed = [known.get(name, name) for name in names]
    ET.SubElement(root, "link", name=ROOT)
    joint = ET.SubElement(root, "joint", name=ROOT, type="fixed")
    ET.SubElement(joint, "parent", link=ROOT)
    ET.SubElement(joint, "child", link=renamed[0])
    return renamed


def _convert_visual(link: ET.Element, visual: ET.Element, fields: RobotFields, to: Meshes) -> None:
    """Puts a mesh as OBJ in the place of a visual's mesh; removes a visual that is unreadable."""
    mesh = visual.find("geometry/mesh")
    if mesh is None:
        return
    try:
        read: Any = read_visual(mesh.get("filename", ""), fields)
    except UnreadableError as error:
        link.remove(visual)
        warn_once(f"{link.get('name')}: a visual is left out: {error}")
        return
    mesh.set("filename", to.add(read.vertices, read.faces))
    for texture in visual.iterfind("material/texture"):
        texture.set("filename", "")


def _add_servo(root: ET.Element, name: str, servo: Gains) -> None:
    """Adds an actuator of the joint's name with gains; the joint gets its largest effort."""
    joint = next(joint for joint in root.findall("joint") if joint.get("name") == name)
    limit = joint.find("limit")
    if limit is None:
        limit = ET.SubElement(joint, "limit", velocity="1e9")
    limit.set("effort", repr(servo.effort))
    transmission = ET.SubElement(root, "transmission", name=name)
    ET.SubElement(transmission, "type").text = "transmission_interface/SimpleTransmission"
    ET.SubElement(transmission, "joint", name=name)
    actuator = ET.SubElement(transmission, "actuator", name=name)
    ET.SubElement(actuator, "drake:rotor_inertia", value=repr(servo.rotor))
    ET.SubElement(actuator, "drake:gear_ratio", value="1")
    damping, stiffness = repr(servo.damping), repr(servo.stiffness)
    ET.SubElement(actuator, "drake:controller_gains", p=stiffness, d=damping)


def _add_filters(root: ET.Element, names: list[str], pairs: list[tuple[int, int]]) -> None:
    """Lets no pair of links collide that the planner never tests."""
    for i in sorted({i for pair in pairs for i in pair}):
        group = ET.SubElement(root, "drake:collision_filter_group", name=f"only_{names[i]}")
        ET.SubElement(group, "drake:member", link=names[i])
        for a, b in pairs:
            if a == i:
                other = f"only_{names[b]}"
                ET.SubElement(group, "drake:ignored_collision_filter_group", name=other)
