# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Everything public in the extensions says what it is, and no argument is nameless."""

import enum
import inspect

import pytest

from graspless import _core
from graspless_bench import _peers

ROOMS = [_peers, *(value for _, value in inspect.getmembers(_core, inspect.ismodule))]


def public(owner, prefix):
    for name, value in vars(owner).items():
        if name.startswith("_") and name != "__init__":
            continue
        yield f"{prefix}.{name}", value
        if inspect.isclass(value) and not issubclass(value, enum.Enum):
            yield from public(value, f"{prefix}.{name}")


NAMES = [pair for room in ROOMS for pair in public(room, room.__name__.split(".")[-1])]


@pytest.mark.parametrize(("name", "value"), NAMES, ids=[name for name, _ in NAMES])
def test_has_docstring(name, value):
    doc = getattr(value, "__func__", value).__doc__ or ""
    if doc.startswith(name.split(".")[-1] + "("):  # pybind11 writes the signature first
        signature, _, doc = doc.partition("\n")
        assert "arg0" not in signature
    assert doc.strip(), f"{name} has no docstring"


@pytest.mark.parametrize("room", ROOMS, ids=lambda room: room.__name__)
def test_every_struct_has_a_repr(room):
    for value in vars(room).values():
        if inspect.isclass(value):
            assert value.__repr__ is not object.__repr__
            assert "__repr__" in vars(value) or issubclass(value, (enum.Enum, BaseException))
