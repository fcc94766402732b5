# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text of a proposed URDF and SRDF."""

from __future__ import annotations

import re
from collections import defaultdict
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr, unescape

from .. import frames
from .._xml import parse
from ..tasks.meshes import mesh_path, package_of

if TYPE_CHECKING:
    import xml.etree.ElementTree as ET
    from collections.abc import Iterable, Mapping

    from .._core.robot import Robot
    from ..frames import Matrix

# Frames without a body weigh 1 g, because MuJoCo refuses links without inertia.
_FRAME = """  <link name={link}>
    <inertial><mass value="0.001"/><inertia ixx="1e-07" iyy="1e-07" izz="1e-07" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name={joint} type="fixed">
    <origin xyz="{xyz}" rpy="{rpy}"/><parent link={parent}/><child link={link}/>
  </joint>
"""  # noqa: E501
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_MESH = re.compile(r"""(<mesh\b[^>]*?\bfilename\s*=\s*)("[^"]*"|'[^']*')""")


def free_name(name: str, taken: Iterable[str]) -> str:
    """Returns a name that is not taken yet: the one given, or with a number behind it."""
    known, count, found = set(taken), 2, name
    while found in known:
        found, count = f"{name}_{count}", count + 1
    return found


def with_frames(urdf: str, placed: Mapping[str, tuple[str, Matrix]]) -> str:
    """Returns a URDF with additional links without shapes.

    `placed` maps each to its parent link and its pose in it, X_PL [4, 4].
    """
    joints = [element.get("name", "") for element in parse(urdf).iter("joint")]
    added = ""
    for link, (parent, X_PL) in placed.items():
        added += _FRAME.format(
            link=quoteattr(link),
            joint=quoteattr(free_name(f"{link}_mount", joints)),
            parent=quoteattr(parent),
            xyz=_numbers(X_PL[:3, 3]),
            rpy=_numbers(frames.to_rpy(X_PL)),
        )
    return _at_end(urdf, f"\n{added}")


def with_absolute_meshes(robot: Robot, urdf: str) -> str:
    """Returns a URDF whose meshes are found from any folder."""

    def replaced(found: re.Match[str]) -> str:
        entities = {"&quot;": '"', "&apos;": "'"}
        name = unescape(found[2][1:-1], entities)
        package = package_of(name)
        if package is not None and package not in robot.packages:
            return found[0]  # of a visual shape that is not there
        path = mesh_path(name, robot.packages, robot.directory).resolve()
        return found[1] + quoteattr(str(path))

    return _MESH.sub(replaced, urdf)


def make_srdf(
    name: str,
    groups: Mapping[str, Iterable[str]],
    states: Iterable[tuple[str, str, Mapping[str, float]]],
    pairs: Mapping[tuple[str, str], str],
    given: str = "",
) -> str:
    """Returns an SRDF; definitions in `given` take precedence.

    Parameters
    ----------
    name : str
        Name of the robot.
    groups : mapping
        Joints of each group.
    states : tuples
        Name of a state, its group, and its joints' values.
    pairs : mapping
        Reason why each pair of links is not tested.
    given : str
        SRDF that is completed.
    """
    root = _root(given)
    groups_given, states_given = _names(root), _joints(root)
    lines = []
    for group, joints in groups.items():
        if group not in groups_given:
            inner = "".join(f"<joint name={quoteattr(joint)}/>" for joint in joints)
            lines.append(f"  <group name={quoteattr(group)}>{inner}</group>")
    # States of the same name are merged: a home of the arm gets one of the hand.
    lines += [_state(*state) for state in states if not states_given[state[0]] & set(state[2])]
    for (a, b), reason in pairs.items():
        lines.append(
            f"  <disable_collisions link1={quoteattr(a)} link2={quoteattr(b)} "
            f"reason={quoteattr(reason)}/>"
        )
    if not len(root):  # <robot/> has no end to write before
        given = f'<?xml version="1.0"?>\n<robot name={quoteattr(name)}>\n</robot>\n'
    return _at_end(given, "\n".join(lines) + "\n")


def _at_end(text: str, added: str) -> str:
    """Returns XML with more elements at the end of <robot>."""
    without = _COMMENT.sub(lambda found: " " * len(found[0]), text)
    end = without.rindex("</robot")
    return text[:end] + added + text[end:]


def _state(name: str, group: str, values: Mapping[str, float]) -> str:
    inner = "\n".join(
        f'    <joint name={quoteattr(joint)} value="{value:.9g}"/>'
        for joint, value in values.items()
    )
    head = f"  <group_state name={quoteattr(name)} group={quoteattr(group)}>"
    return f"{head}\n{inner}\n  </group_state>"


def state_joints(srdf: str) -> defaultdict[str, set[str]]:
    """Returns the joints that the states of each name give a value."""
    return _joints(_root(srdf))


def group_names(srdf: str) -> set[str]:
    """Returns the names of the groups, faulty ones included."""
    return _names(_root(srdf))


def _root(srdf: str) -> ET.Element:
    return parse(srdf or "<robot/>")


def _names(root: ET.Element) -> set[str]:
    return {group.get("name", "") for group in root.findall("group")}


def _joints(root: ET.Element) -> defaultdict[str, set[str]]:
    found: defaultdict[str, set[str]] = defaultdict(set)
    for state in root.findall("group_state"):
        found[state.get("name", "")] |= {joint.get("name", "") for joint in state.findall("joint")}
    return found


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{round(float(value), 9) + 0.0:.9g}" for value in values)
