# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Things as SDFormat models for Drake."""

from __future__ import annotations

import dataclasses
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from .numbers import plain

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..frames import Matrix
    from .things import Shape, Thing

_TAGS = {"surface": "mesh"}
_SIDE, _DEPTH = 20.0, 1.0  # of the box that stands for a plane [m]


class Meshes:
    """Meshes of a folder, as OBJ files."""

    def __init__(self) -> None:
        self._names: dict[str, str] = {}  # by content

    @property
    def files(self) -> dict[str, str]:
        """Content of the files by name."""
        return {name: content for content, name in self._names.items()}

    def add(self, vertices: ArrayLike, triangles: ArrayLike) -> str:
        """Adds a mesh, if it is new, and returns the name of its file."""
        lines = [f"v {numbers(p)}\n" for p in np.asarray(vertices)]
        lines += ["f {} {} {}\n".format(*t) for t in np.asarray(triangles) + 1]
        return self._names.setdefault("".join(lines), f"meshes/{len(self._names)}.obj")


def model_sdf(things: list[Thing], name: str, meshes: Meshes, is_static: bool = False) -> str:
    """Returns one model with a link for each thing."""
    root = ET.Element("sdf", {"version": "1.9", "xmlns:drake": "http://drake.mit.edu"})
    model = ET.SubElement(root, "model", name=name)
    ET.SubElement(model, "static").text = str(is_static).lower()
    for thing in things:
        link = ET.SubElement(model, "link", name=thing.name)
        if is_static:
            ET.SubElement(link, "pose").text = _pose(thing.X_WB)
        else:
            _add_inertial(link, thing)
        for k, shape in enumerate(thing.shapes):
            _add_shape(link, "visual", k, shape, meshes)
            if shape.kind != "surface":  # Drake would fill its holes
                _add_shape(link, "collision", k, shape, meshes)
    ET.indent(root)
    return ET.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _add_inertial(link: ET.Element, thing: Thing) -> None:
    inertial = ET.SubElement(link, "inertial")
    ET.SubElement(inertial, "pose").text = f"{numbers(thing.com)} 0 0 0"
    ET.SubElement(inertial, "mass").text = repr(thing.mass)
    inertia = ET.SubElement(inertial, "inertia")
    for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
        ET.SubElement(inertia, f"i{'xyz'[i]}{'xyz'[j]}").text = numbers(thing.moments[i, j])


def _add_shape(link: ET.Element, role: str, k: int, shape: Shape, meshes: Meshes) -> None:
    if shape.kind == "plane" and role == "collision":
        shape = _slab(shape)
    element = ET.SubElement(link, role, name=f"{link.get('name')}_{k}")
    ET.SubElement(element, "pose").text = _pose(shape.X_BG)
    own = ET.SubElement(ET.SubElement(element, "geometry"), _TAGS.get(shape.kind, shape.kind))
    if shape.kind == "plane":
        ET.SubElement(own, "normal").text = "0 0 1"
        ET.SubElement(own, "size").text = "1 1"
    elif shape.kind == "box":
        ET.SubElement(own, "size").text = numbers(shape.size)
    elif shape.kind in ("sphere", "capsule"):
        for tag, value in zip(("radius", "length"), shape.size, strict=False):
            ET.SubElement(own, tag).text = numbers(value)
    else:
        ET.SubElement(own, "uri").text = meshes.add(shape.vertices, shape.triangles)
    if role == "collision":
        touch = ET.SubElement(element, "drake:proximity_properties")
        for tag in ("drake:mu_dynamic", "drake:mu_static"):
            ET.SubElement(touch, tag).text = numbers(shape.friction)


def _slab(plane: Shape) -> Shape:
    """Returns a box below a plane: with half spaces, Drake 1.51 may crash in a step."""
    X_BG = plane.X_BG @ frames.translation([0.0, 0.0, -_DEPTH / 2])
    return dataclasses.replace(plane, kind="box", size=[_SIDE, _SIDE, _DEPTH], X_BG=X_BG)


def _pose(X: Matrix) -> str:
    return f"{numbers(np.asarray(X)[:3, 3])} {numbers(frames.to_rpy(X))}"


def numbers(values: ArrayLike) -> str:
    """Returns numbers as an attribute or a text of XML has them."""
    return " ".join(map(repr, plain(np.atleast_1d(values))))
