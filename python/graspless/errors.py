# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error for faults in files, and for packages that are not installed."""

from __future__ import annotations

import contextlib
import numbers
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator

EXTRAS = {  # that bring a package, the smallest first
    "av": ("video",),
    "collada": ("robots",),
    "dask": ("cluster",),
    "distributed": ("cluster",),
    "gymnasium": ("gym", "video"),
    "joblib": ("batch", "cluster"),
    "matplotlib": ("view",),
    "mujoco": ("sim", "rerun", "gym"),
    "pyarrow": ("gym", "video"),
    "rerun": ("rerun",),
    "rich": ("batch", "cluster"),
    "robot_descriptions": ("robots",),
    "rosbags": ("ros",),
    "scipy": ("timing", "view", "sim", "ros", "rerun", "gym"),
    "toppra": ("timing", "sim", "ros", "rerun", "gym"),
    "viser": ("view",),
}


LONGEST = 60  # characters of a value in a message


class TaskError(ValueError):
    """A task file, a file it names, or a plan file is not valid; or a package is missing.

    The message has one line per fault, ``file:line: field: value: what is allowed``.
    """


class GrasplessWarning(UserWarning):
    """A warning of this library: what is unusual or doubtful in a task, a file or a plan."""


class OutOfTimeError(TaskError):
    """The time limit was reached before the task was read."""


# What libraries raise over broken files. A warning that is an error, or an exception of the
# program that a signal handler raises meanwhile, is none of these.
LIBRARIES = (
    "PIL", "binascii", "builtins", "collada", "graspless", "gzip", "json", "lxml", "lzma", "numpy",
    "pickle", "pydantic_core", "pyexpat", "scipy", "struct", "tokenize", "trimesh", "xml", "yaml",
    "zipfile", "zlib",
)  # fmt: skip


def is_of_library(error: BaseException) -> bool:
    """Returns False of exceptions that come from the program, such as the end of a time limit."""
    if isinstance(error, Warning) or (isinstance(error, TimeoutError) and error.errno is None):
        return False
    return type(error).__module__.partition(".")[0].lstrip("_") in LIBRARIES


def explain(error: BaseException) -> str:
    """Returns one line about a fault that a library raised, for people who do not read Python."""
    if isinstance(error, MemoryError):
        return "needs more memory than there is; should be smaller, or its options coarser"
    if isinstance(error, RecursionError):
        return "nested too deeply"
    if isinstance(error, OSError) and error.strerror:
        file = "" if error.filename is None else str(error.filename)
        name = f"{file if len(file) <= 255 else file[:60] + '...' + file[-60:]!r}: " if file else ""
        return f"{name}{error.strerror}"
    first, *rest = str(error).splitlines() or [""]
    if rest and rest[0].startswith("Element name"):  # MuJoCo's second line names the body
        first += f" ({rest[0]})"
    if isinstance(error, ValueError) and first:
        return first
    return f"{type(error).__name__}: {first}" if first else type(error).__name__


def shown(value: object) -> str:
    """Returns a value in a message: in one line, and cut where it is long."""
    try:
        text = str(value) if isinstance(value, numbers.Number) else repr(value)
    except ValueError:  # more digits than Python writes
        return "a number of many digits"
    text = re.sub(r"\s*\n\s*", " ", text)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def warn(text: str) -> None:
    """Warns at the line of the user's program that called the library."""
    import warnings

    level, frame = 1, sys._getframe()
    package = __name__.partition(".")[0]
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, GrasplessWarning, stacklevel=level)


def suggestion(name: object, known: Collection[str], most: int = 1, cutoff: float = 0.6) -> str:
    """Returns "; did you mean 'slide'?" for a misspelt name, or nothing if no other is similar."""
    import difflib  # takes time, and errors alone need it

    close = difflib.get_close_matches(str(name), known, most, cutoff)
    return f"; did you mean {' or '.join(map(repr, close))}?" if close else ""


def should_be(name: object, known: Collection[str]) -> str:
    """Returns what a message asks of an unknown name: all choices, and a suggestion."""
    return f"should be one of {', '.join(known)}{suggestion(name, known)}"


def one_of(name: object, known: Collection[str]) -> str:
    """Returns the end of a message about an unknown name: a suggestion, and all choices."""
    return f"{suggestion(name, known)} (one of: {', '.join(known)})"


@contextlib.contextmanager
def told(where: str) -> Iterator[None]:
    """Turns whatever a library raises into a TaskError that begins with `where`."""
    try:
        yield
    except TaskError:
        raise
    except Exception as error:
        if not is_of_library(error):
            raise
        raise TaskError(f"{where}: {explain(error)}") from error


def missing(error: ImportError, extra: str, purpose: str = "") -> TaskError:
    """Returns the error of a package that is not installed.

    Parameters
    ----------
    error : ImportError
        Names the package.
    extra : str
        Extra that was needed; another one is named where that does not bring the package.
    purpose : str
        What the package is needed for: " to draw".
    """
    name = error.name.partition(".")[0] if error.name else str(error)
    extras = EXTRAS.get(name, (extra,))
    command = install_command(extra if extra in extras else extras[0])
    return TaskError(f"needs {name}{purpose}: {command}")


def install_command(extra: str) -> str:
    """Returns the command that installs an extra: that of a checkout, if its .venv runs."""
    checkout = Path(sys.prefix).parent
    if Path(sys.prefix).name == ".venv" and (checkout / "python" / "graspless").is_dir():
        return f"tools/install {extra}"
    packages = dict.fromkeys(_packages(extra))
    return f"pip install {' '.join(repr(package) for package in packages)}"


def _packages(extra: str) -> list[str]:
    """Returns the packages of an extra, by the metadata: graspless itself is not on PyPI."""
    from importlib.metadata import requires

    found = []
    for line in requires("graspless") or []:
        package, _, condition = (part.strip() for part in line.partition(";"))
        if f'extra == "{extra}"' not in condition:
            continue
        if inner := re.fullmatch(r"graspless\[(.+)\]", package):
            found += [name for other in inner[1].split(",") for name in _packages(other)]
        else:
            found.append(package)
    return found
