# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""XML of URDF and SRDF files."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING
from xml.parsers import expat

from . import frames

if TYPE_CHECKING:
    from .frames import Matrix


def parse(text: str) -> ET.Element:
    """Returns the root element of a URDF or SRDF.

    Prefixes such as that of ``<controller:gazebo>`` need no namespace: urdfdom knows none.

    Raises
    ------
    ValueError
        The text is not well-formed.
    """
    builder = ET.TreeBuilder()
    reader = expat.ParserCreate()
    reader.StartElementHandler = builder.start
    reader.EndElementHandler = builder.end
    reader.CharacterDataHandler = builder.data
    try:
        reader.Parse(text, True)
    except expat.ExpatError as error:
        raise ValueError(f"is not well-formed XML: {error}") from None
    return builder.close()


def origin(element: ET.Element) -> Matrix:
    """Returns the pose [4, 4] that the <origin> of a joint, visual or the like gives."""
    found = element.find("origin")
    given = {} if found is None else found.attrib
    xyz, rpy = ([float(word) for word in given.get(key, "0 0 0").split()] for key in ("xyz", "rpy"))
    return frames.translation(xyz) @ frames.from_rpy(rpy)
