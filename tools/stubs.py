"""Writes the stubs of graspless._core (.pyi) into a folder: `stubs.py python/graspless/_core`."""

from __future__ import annotations

import pathlib
import re
import shutil
import sys
import tempfile

import pybind11_stubgen

ENUMS = [  # for the defaults of arguments
    "(Search|FingerModel|Status):graspless._core.slide",
    "(ContactMode|FingerMode|Engine):graspless._core.mechanics",
]


def write_stubs(folder: pathlib.Path) -> None:
    """Replaces `folder` by stubs of the installed extension."""
    with tempfile.TemporaryDirectory() as scratch:
        enums = [word for enum in ENUMS for word in ("--enum-class-locations", enum)]
        pybind11_stubgen.main(["graspless._core", "-o", scratch, "--exit-code", *enums])
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(pathlib.Path(scratch, "graspless", "_core"), folder)
    for stub in folder.iterdir():
        text = with_enum_members(stub.read_text())
        if stub.stem == "fingertip":  # which has a Search of its own
            text = text.replace("graspless._core.slide.Search", "Search")
        stub.write_text(text)


def with_enum_members(text: str) -> str:
    """Enum members as type checkers want them: `name = ...`, not `name: ClassVar[Enum]`."""
    text = re.sub(
        r"^    (\w+): typing\.ClassVar\[\w+\]$", r"    \1 = ...", text, flags=re.MULTILINE
    )
    return re.sub(r"    @classmethod\n    def __new__\(cls, value\):\n        \.\.\.\n", "", text)


if __name__ == "__main__":
    write_stubs(pathlib.Path(sys.argv[1]))
