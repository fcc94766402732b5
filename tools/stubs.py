"""Writes the stubs of graspless._core (.pyi) into a folder: `stubs.py python/graspless/_core`."""

from __future__ import annotations

import pathlib
import shutil
import sys
import tempfile

import pybind11_stubgen


ENUMS = "(Search|FingerModel|Status):graspless._core.slide"  # for the defaults of arguments


def write_stubs(folder: pathlib.Path) -> None:
    """Replaces `folder` by stubs of the installed extension."""
    with tempfile.TemporaryDirectory() as scratch:
        pybind11_stubgen.main(
            ["graspless._core", "-o", scratch, "--exit-code", "--enum-class-locations", ENUMS]
        )
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(pathlib.Path(scratch, "graspless", "_core"), folder)


if __name__ == "__main__":
    write_stubs(pathlib.Path(sys.argv[1]))
