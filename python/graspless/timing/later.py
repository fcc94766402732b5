# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Modules that a library imports, and that are not needed until somebody uses them."""

from __future__ import annotations

import contextlib
import importlib
import sys
from importlib.machinery import PathFinder
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator


class _Later(ModuleType):
    """Stands for a module until something of it is asked for."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        found = PathFinder.find_spec(name) if "." not in name else None
        if found is not None:  # other threads may import what is in a package
            self.__spec__ = found
            self.__path__ = list(found.submodule_search_locations or ())

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        _forget()
        return getattr(importlib.import_module(self.__name__), name)


def _forget() -> None:
    for name in [name for name, module in sys.modules.items() if isinstance(module, _Later)]:
        del sys.modules[name]


@contextlib.contextmanager
def imported_later(*names: str) -> Iterator[None]:
    """Postpones the imports of modules in the block, each after the package that it is in.

    toppra imports matplotlib.pyplot, which takes a second and a folder that can be written.
    """
    for name in names:
        package, _, inner = name.rpartition(".")
        if name not in sys.modules:
            sys.modules[name] = module = _Later(name)
            if isinstance(sys.modules.get(package), _Later):
                vars(sys.modules[package])[inner] = module
    try:
        yield
    finally:
        _forget()
