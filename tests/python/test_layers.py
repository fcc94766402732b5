# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which room may know which (docs/architecture.md), read from the #include and import lines."""

import ast
import graphlib
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PACKAGE = ROOT / "python" / "graspless"
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
# What every room may use. It includes nothing of ours but itself.
SHARED = {"crew.cpp", "crew.hpp", "export.hpp", "once.hpp", "text.hpp", "watch.cpp", "watch.hpp"}
SOURCES = sorted(path for path in (ROOT / "cpp").rglob("*.[ch]pp") if path.name not in SHARED)


def room(path):
    parts = path.relative_to(ROOT / "cpp").parts
    return parts[1] if parts[0] == "src" else parts[2]


@pytest.mark.parametrize("folder", ["python", "benchmarks", "tools", "examples"])
def test_no_text_file_depends_on_the_locale(folder):
    encoding = {"read_text": 0, "write_text": 1}  # place among the arguments
    for path in (ROOT / folder).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            name = getattr(node.func, "attr", "") if isinstance(node, ast.Call) else ""
            if name in encoding:
                given = {keyword.arg for keyword in node.keywords}
                has_one = "encoding" in given or len(node.args) > encoding[name]
                assert has_one, f"{path}:{node.lineno}: {name} without encoding"


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_includes_only_rooms_below(path):
    own = room(path)
    allowed = ALLOWED[own] | {own}
    for include in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
        if include == "graspless/planning/fields.hpp" or include.split("/")[-1] in SHARED:
            continue
        prefix, _, rest = include.partition("/")
        target = rest.split("/")[0] if prefix == "graspless" else prefix if rest else own
        assert target in allowed, f"{own} must not include {include}"


SHAPES = {"Box", "Sphere", "Capsule", "Mesh", "PlacedShape"}  # of the task that was read
PLANNING = {"slide", "pinch", "fingertip", "clasp", "carry", "planning", "collision", "scene"}


def taken(path):
    """What a module of Python uses of the package's top, when it runs: {module: names}."""
    found, tree = {}, ast.parse(path.read_text())
    up = len(path.relative_to(PACKAGE).parts)  # dots that reach the package's top
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
    shared = set()
    for path in sorted((PACKAGE / "simulation").rglob("*.py")):
        used = taken(path)
        assert not PLANNING & set(used), path
        for module in ("geometry", "robot", "mechanics"):
            shared |= used.get(module, set())
    assert {"wrench_scale", "Ik", "PreparedLoop"} <= shared  # else nothing was found
    assert [name for name in sorted(shared - SHAPES) if name not in listed] == []


def imported(path):
    """Files of the package that a module imports: on top, in a function, or for types alone."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = path.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            for name in (alias.name for alias in node.names):
                inside = base / f"{name}.py", base / name / "__init__.py", base / "__init__.py"
                files = (*inside, base.with_suffix(".py"))
                yield from [file for file in files if file.exists()][:1]


def test_no_modules_of_python_import_each_other_in_a_circle():
    face = PACKAGE / "__init__.py"  # names everything, at the first use
    graph = {path: set(imported(path)) - {face} for path in PACKAGE.rglob("*.py") if path != face}
    assert PACKAGE / "tasks" / "__init__.py" in graph[PACKAGE / "_load.py"]
    assert PACKAGE / "kinds.py" in graph[PACKAGE / "chain" / "search.py"]
    graphlib.TopologicalSorter(graph).prepare()  # raises with the circle


@pytest.mark.parametrize("module", ["bindings", "tests", "python"])
def test_core_includes_nothing_above_it(module):
    for path in SOURCES:
        assert f'"{module}/' not in path.read_text()
