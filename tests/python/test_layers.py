# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which room may know which (docs/architecture.md), read from the #include and import lines."""

import ast
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).parents[2]
ALLOWED = {
    "geometry": set(),
    "robot": {"geometry"},
    "collision": {"geometry"},
    "mechanics": {"geometry"},
    "planning": set(),
    "scene": {"geometry", "robot", "collision"},
    "slide": {"geometry", "robot", "collision", "mechanics", "planning", "scene"},
    "pinch": {"geometry", "robot", "collision", "mechanics", "planning", "scene", "slide"},
    "clasp": {"geometry", "robot", "collision", "mechanics", "planning", "scene"},
    "perception": {"geometry"},
    "carry": {"geometry", "robot", "collision", "planning", "scene"},
    "fingertip": {"geometry", "collision", "mechanics", "planning"},
    "realize": {"geometry", "robot", "collision", "mechanics", "planning", "scene", "fingertip"},
}
SHARED = {"export.hpp", "watch.hpp", "watch.cpp"}  # what every room may use
SOURCES = sorted(path for path in (ROOT / "cpp").rglob("*.[ch]pp") if path.name not in SHARED)


def room(path):
    parts = path.relative_to(ROOT / "cpp").parts
    return parts[1] if parts[0] == "src" else parts[2]


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_includes_only_rooms_below(path):
    own = room(path)
    allowed = ALLOWED[own] | {own}
    for include in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
        if include in (
            "graspless/export.hpp",
            "graspless/watch.hpp",
            "graspless/planning/fields.hpp",
        ):
            continue  # they include nothing of ours
        prefix, _, rest = include.partition("/")
        target = rest.split("/")[0] if prefix == "graspless" else prefix if rest else own
        assert target in allowed, f"{own} must not include {include}"


SHAPES = {"Box", "Sphere", "Capsule", "Mesh", "PlacedShape"}  # of the task that was read
PLANNING = {"slide", "pinch", "fingertip", "clasp", "carry", "planning", "collision", "scene"}


def taken(path, package):
    """What a module of Python uses of the package's top, when it runs: {module: names}."""
    found, tree = {}, ast.parse(path.read_text())
    up = len(path.relative_to(package).parts)  # dots that reach the package's top
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.level == up:
            for name in (alias.name for alias in node.names):
                top, *_ = (node.module or name).split(".")
                uses = {a.attr for a in ast.walk(tree) if is_use(a, name)}
                found.setdefault(top, set()).update({name} if node.module else uses)
    return found


def is_use(node, name):
    return isinstance(node, ast.Attribute) and getattr(node.value, "id", None) == name


def test_what_simulations_share_with_planners_is_listed():
    page = (ROOT / "docs" / "internals" / "physics.md").read_text()
    head = "## What the physics engine shares with the planners\n"
    listed = page.split(head)[1].split("\n## ")[0]
    package = ROOT / "python" / "graspless"
    shared = set()
    for path in sorted((package / "simulation").rglob("*.py")):
        used = taken(path, package)
        assert not PLANNING & set(used), path
        for module in ("geometry", "robot", "mechanics"):
            shared |= used.get(module, set())
    assert {"wrench_scale", "Ik", "PreparedLoop"} <= shared  # else nothing was found
    assert [name for name in sorted(shared - SHAPES) if name not in listed] == []


@pytest.mark.parametrize("module", ["bindings", "tests", "python"])
def test_core_includes_nothing_above_it(module):
    for path in SOURCES:
        assert f'"{module}/' not in path.read_text()
