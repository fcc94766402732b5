"""Writes the stubs (.pyi) of the installed extensions into a checkout: `stubs.py .`."""

from __future__ import annotations

import pathlib
import re
import sys
import tempfile

import pybind11_stubgen

ENUMS = [  # for the defaults of arguments
    "(Search|FingerModel|Status):graspless._core.slide",
    "(ContactMode|FingerMode|Engine):graspless._core.mechanics",
]


FOLDERS = {  # of a checkout, by module
    "graspless._core": "python/graspless",
    "graspless_bench._peers": "benchmarks/graspless_bench",
}


def write_stubs(root: pathlib.Path) -> None:
    """Replaces the stubs below `root` by those of the installed extensions."""
    for module, folder in FOLDERS.items():
        for stub, text in made_stubs(module).items():
            path = root / folder / stub
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")


def made_stubs(module: str) -> dict[str, str]:
    """Returns the stubs of a module: their texts by path, relative to the module's package."""
    with tempfile.TemporaryDirectory() as scratch:
        enums = [word for enum in ENUMS for word in ("--enum-class-locations", enum)]
        pybind11_stubgen.main([module, "-o", scratch, "--exit-code", *enums])
        package = pathlib.Path(scratch, module.partition(".")[0])
        return {str(p.relative_to(package)): with_names(p) for p in package.rglob("*.pyi")}


def with_names(stub: pathlib.Path) -> str:
    """Text of a stub, with enums and paths as type checkers want them."""
    text = with_enum_members(stub.read_text(encoding="utf-8"))
    text = text.replace("os.PathLike | str | bytes", "os.PathLike[str] | str")
    if stub.stem == "fingertip":  # which has a Search of its own
        text = text.replace("graspless._core.slide.Search", "Search")
    return text


def with_enum_members(text: str) -> str:
    """Enum members as type checkers want them: `name = ...`, not `name: ClassVar[Enum]`."""
    text = re.sub(
        r"^    (\w+): typing\.ClassVar\[\w+\]$", r"    \1 = ...", text, flags=re.MULTILINE
    )
    return re.sub(r"    @classmethod\n    def __new__\(cls, value\):\n        \.\.\.\n", "", text)


if __name__ == "__main__":
    write_stubs(pathlib.Path(sys.argv[1]))
