# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Expansion of xacro files in a process of its own, as they can run for ever.

Run as a script by path: it imports nothing of graspless. Expressions in a xacro file are Python,
and xacro's own restrictions on them can be circumvented. So the process gives up everything but
reading files in a few folders, unless the user trusts the file.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

SECONDS = 10  # [s]
MEMORY = 2**30  # [byte]
LONGEST = 2**26  # [characters] of the expanded file
HINT = "not allowed; --trust (in Python trust=True of load_task and pick) allows it"
HARMLESS = frozenset(("compile", "exec", "builtins.id", "glob.glob", "glob.glob/2"))  # audit events
READING = frozenset(("open", "os.listdir", "os.scandir"))


def expand(path: Path, words: dict[str, str], packages: dict[str, str], trust: bool) -> str:
    """Returns the URDF of a xacro file.

    Parameters
    ----------
    path : Path
        The xacro file.
    words : dict
        Arguments, which $(arg NAME) reads.
    packages : dict
        Folders that $(find NAME) returns.
    trust : bool
        Allow everything that xacro can do: read any file and environment variable, find the
        packages of a ROS installation, and run code.

    Raises
    ------
    ValueError
        It cannot be expanded, needs more than SECONDS or MEMORY, or does what is not allowed.
    """
    import subprocess  # here, as the other process shall not know how to start more

    files = {"path": str(path), "packages": packages, "sys_path": sys.path}
    asked = files | {"words": words, "trust": trust}
    try:
        done = subprocess.run(
            [sys.executable, "-I", str(Path(__file__).resolve())],
            input=json.dumps(asked).encode(),
            capture_output=True,
            timeout=SECONDS,
        )
    except subprocess.TimeoutExpired:
        raise ValueError(f"xacro cannot expand it within {SECONDS} s") from None
    except OSError as error:
        if error.errno is None:  # a TimeoutError of the program
            raise
        raise ValueError(f"xacro cannot be started: {error.strerror}") from None
    try:
        told = json.loads(done.stdout)
    except ValueError:
        raise ValueError(f"xacro cannot expand it within {MEMORY >> 20} MiB") from None
    if "error" in told:
        raise ValueError(f"xacro cannot expand it: {told['error']}")
    sys.stderr.write(done.stderr.decode(errors="replace"))  # xacro's warnings
    return str(told["text"])


def _main() -> None:
    asked = json.load(sys.stdin)
    sys.path[:] = asked["sys_path"]
    told, sys.stdout = sys.stdout, sys.stderr  # {{ print() }} must not mix with our answer
    _limit_resources()
    try:
        answer = {"text": _expanded(asked)}
    except Exception as error:  # xacro raises many kinds, some of them private
        inner = getattr(error, "exc", None) or error
        told_lines = [line for line in str(error).splitlines() if line.strip()]
        answer = {"error": told_lines[0] if told_lines else type(inner).__name__}
        if isinstance(inner, MemoryError):
            answer = {"error": f"needs more than {MEMORY >> 20} MiB"}
    if _refusals:  # also if the file handled the error, as an optional include does
        answer = {"error": _refusals[0]}
    json.dump(answer, told)


def _expanded(asked: dict[str, Any]) -> str:
    import xacro
    from xacro import substitution_args

    packages, path = asked["packages"], asked["path"]
    find = substitution_args._eval_find
    if not asked["trust"]:
        find = _refuse_package
        xacro.process_doc(xacro.parse("<robot/>"))  # imports what xacro needs
        _confine([str(Path(path).parent), *packages.values()])
    look_up = lambda name: packages.get(name) or find(name)  # noqa: E731
    substitution_args._eval_find = substitution_args._eval_dict["find"] = look_up
    text = str(xacro.process_file(path, mappings=asked["words"]).toprettyxml(indent="  "))
    if len(text) > LONGEST:
        raise ValueError(f"it becomes {len(text)} characters long, more than {LONGEST}")
    return text


_refusals: list[str] = []


def _refuse(what: str) -> None:
    _refusals.append(f"{what}, which is {HINT}")
    raise PermissionError(0, _refusals[0], "")


def _refuse_package(name: str) -> None:
    _refuse(
        f"looks for package '{name}' outside of robot.packages, where its folder can be given "
        f"(--package {name}=FOLDER)"
    )


class _Environment:
    """Environment without variables. Asking for one that the user has set is refused."""

    def __init__(self, names: frozenset[str]) -> None:
        self._names = names

    def __contains__(self, name: str) -> bool:
        if name in self._names:
            _refuse(f"reads the environment variable '{name}'")
        return False

    def __getitem__(self, name: str) -> str:
        raise KeyError(name in self or name)


def _confine(folders: list[str]) -> None:
    """Gives up everything but reading files in `folders`, for the rest of this process.

    Expressions may replace functions and modules. What is called later is therefore local here, and
    the kernel resolves paths.
    """
    names = frozenset(os.environ)
    os.environ.clear()
    os.environ = _Environment(names)  # type: ignore[assignment]  # noqa: B003
    is_inside = _make_lookup(folders)
    harmless, reading, note, refusal = HARMLESS, READING, _refusals.append, PermissionError

    def refuse(event: str, arguments: tuple[Any, ...]) -> None:
        if event in harmless or (event in reading and is_inside(*arguments)):
            return
        what = f"opens {arguments[0]!r}" if event in reading else f"does {event}"
        note(f"{what}, which is {HINT}")
        raise refusal(0, what, "")

    sys.addaudithook(refuse)


def _make_lookup(folders: list[str]) -> Callable[..., bool]:
    """Returns a function that is True if a path that is opened for reading lies in a folder."""
    roots = tuple(os.path.realpath(folder).rstrip("/") + "/" for folder in folders)
    type_of, texts, reading = type, (str, bytes), os.O_RDONLY | os.O_CLOEXEC
    open_path, resolve, close, by_path, nothing = os.open, os.readlink, os.close, os.O_PATH, OSError
    is_nested = False

    def is_inside(path: Any, mode: Any = None, flags: int = 0) -> bool:
        nonlocal is_nested
        if is_nested:
            return True
        if type_of(path) not in texts or flags & ~reading:
            return False
        is_nested = True  # the next line is an event, too
        try:
            handle = open_path(path, by_path)
        except nothing:
            return True  # there is no such file
        finally:
            is_nested = False
        try:
            return (resolve(f"/proc/self/fd/{handle}") + "/").startswith(roots)
        finally:
            close(handle)

    return is_inside


def _limit_resources() -> None:
    try:
        import resource
    except ImportError:  # not on this platform
        return
    for kind, most in ((resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_CPU, SECONDS)):
        _, hard = resource.getrlimit(kind)
        if hard == resource.RLIM_INFINITY or hard > most:
            resource.setrlimit(kind, (most, hard))


if __name__ == "__main__":
    _main()
