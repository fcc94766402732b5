# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writing files and folders whole or not at all."""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import TaskError, shown

if TYPE_CHECKING:
    from collections.abc import Iterator

LONGEST = 4096  # characters of a path: longer text is no path, but perhaps the content of a file


@contextlib.contextmanager
def writing(path: str | Path) -> Iterator[None]:
    """Turns an OSError of the system, while `path` is written, into a TaskError."""
    try:
        yield
    except OSError as error:
        if error.errno is None and isinstance(error, TimeoutError):  # of the program
            raise
        raise TaskError(f"{path}: cannot be written: {error.strerror or error}") from None


def check_writable(path: str | Path) -> None:
    """Raises TaskError unless `path` can be written: asked before work that would be lost."""
    path = as_path(path)
    _check_place(path)
    with writing(path):
        if not path.exists() or path.is_file():
            handle, temporary = _make_temporary(path)
            os.close(handle)
            temporary.unlink()


def absence(path: str | Path) -> str:
    """Returns the reason why there is no file to read at a path."""
    path = Path(path)
    if path.is_dir():
        return "is a folder, not a file"
    return "is not a file" if path.exists() else "no such file"


def as_path(path: object) -> Path:
    """Returns a path; raises TaskError if it is something else."""
    if not isinstance(path, (str, os.PathLike)) or len(os.fspath(path)) > LONGEST:
        raise TaskError(f"{shown(path)}: should be the path of a file")
    return Path(path)


def _check_place(path: Path) -> None:
    """Raises TaskError unless the folder exists and the file can be written."""
    with writing(path):
        try:
            path.stat()  # fails for a loop of links, and for a name that is too long
        except FileNotFoundError:
            pass
        except ValueError as error:
            raise TaskError(f"{str(path)!r}: cannot be written: {error}") from None
    if path.is_dir():
        raise TaskError(f"{path}: cannot be written: is a folder")
    if not path.parent.is_dir():
        raise TaskError(f"{path}: cannot be written: there is no folder {path.parent}")
    if path.exists():
        with writing(path), path.open("ab"):
            pass


def _make_temporary(path: Path, mode: int = 0o600) -> tuple[int, Path]:
    """Makes a new file beside `path`, within the umask; returns its handle and path.

    Without `tempfile`, whose import takes longer than the rest of writing a plan.
    """
    temporary = path.with_name(f".{path.name}.{os.urandom(4).hex()}")
    return os.open(temporary, os.O_RDWR | os.O_CREAT | os.O_EXCL, mode), temporary


def temporaries(folder: Path, name: str) -> Iterator[Path]:
    """Yields what `_make_temporary` left below a folder for files of a name, a glob pattern."""
    return folder.rglob(f".{name}.{'[0-9a-f]' * 8}")


def write(path: str | Path, content: str | bytes) -> None:
    """Writes a file at once, through a temporary one beside it; raises TaskError."""
    path = as_path(path)
    data = content.encode() if isinstance(content, str) else content
    _check_place(path)
    with writing(path):
        if path.exists() and not path.is_file():  # a pipe or device must not be replaced
            path.write_bytes(data)
            return
        path = path.resolve()  # through a link to the file, not in its place
        mode = path.stat().st_mode & 0o7777 if path.exists() else None
        handle, temporary = _make_temporary(path, 0o666 if mode is None else 0o600)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            if mode is not None:
                temporary.chmod(mode)
            temporary.replace(path)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise


def to_stdout(text: str) -> None:
    """Writes what would be a file to stdout, in UTF-8 like all files."""
    if sys.stdout is not None:
        sys.stdout.flush()
        sys.stdout.buffer.write(text.encode())


def make_folder(path: Path) -> None:
    """Makes a folder and its parents; raises TaskError."""
    with writing(path):
        try:
            path.mkdir(parents=True, exist_ok=True)
        except FileExistsError:
            raise TaskError(f"{path}: cannot be written: is a file, not a folder") from None


def set_aside(path: Path) -> Path:
    """Renames a file, whose place another one takes, to its name with ~; raises TaskError."""
    with writing(f"{path}~"):
        return path.replace(path.with_name(f"{path.name}~"))


_places: set[Path] = set()  # folders of `beside`


@contextlib.contextmanager
def beside(path: str | Path) -> Iterator[Path]:
    """Gives a new folder beside `path`, gone at the end; an OSError becomes a TaskError."""
    import tempfile  # is not needed to write a plan

    path = Path(path)
    with (
        writing(path),
        tempfile.TemporaryDirectory(dir=path.parent, prefix=f".{path.name}.") as place,
    ):
        _places.add(Path(place))
        try:
            yield Path(place)
        finally:
            _places.discard(Path(place))


def remove_places() -> None:
    """Removes the folders of `beside` in a process that a signal ends at once."""
    import shutil

    for place in _places:
        shutil.rmtree(place, ignore_errors=True)


@contextlib.contextmanager
def new_folder(path: str | Path) -> Iterator[Path]:
    """Gives the path of a folder to be made, which becomes `path` at the end; raises TaskError."""
    import shutil

    path = Path(path)
    if path.exists():
        raise TaskError(f"{path}: cannot be written: it exists already; should be a new folder")
    with beside(path) as place:
        yield place / path.name
        shutil.move(place / path.name, path)
