# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which room may know which (docs/architecture.md), read from the #include and import lines."""

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
    "clasp": {"geometry", "robot", "collision", "mechanics", "planning", "scene"},
    "carry": {"geometry", "robot", "collision", "planning", "scene"},
    "fingertip": {"geometry", "collision", "mechanics", "planning"},
}
REALIZE = {"robot", "scene"}  # what only fingertip/realize* may know besides
SOURCES = sorted(path for path in (ROOT / "cpp").rglob("*.[ch]pp") if path.name != "export.hpp")


def room(path):
    parts = path.relative_to(ROOT / "cpp").parts
    return parts[1] if parts[0] == "src" else parts[2]


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_includes_only_rooms_below(path):
    own = room(path)
    allowed = ALLOWED[own] | {own}
    if own == "fingertip" and path.name.startswith("realize"):
        allowed |= REALIZE
    for include in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
        if include == "graspless/export.hpp":
            continue
        prefix, _, rest = include.partition("/")
        target = rest.split("/")[0] if prefix == "graspless" else prefix if rest else own
        assert target in allowed, f"{own} must not include {include}"


@pytest.mark.parametrize("module", ["bindings", "tests", "python"])
def test_core_includes_nothing_above_it(module):
    for path in SOURCES:
        assert f'"{module}/' not in path.read_text()
