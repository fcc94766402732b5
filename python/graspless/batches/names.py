# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files of a batch, and their names in the output."""

from __future__ import annotations

import glob
import os
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from .. import files
from ..errors import TaskError

ENDINGS = (".yaml", ".yml")
OF_HANDS = tuple(f".{what}{ending}" for what in ("hand", "clasp") for ending in ENDINGS)


@dataclass(frozen=True)
class Entry:
    """A task file and its name in the output: a path without a suffix."""

    name: str
    path: Path


def find(tasks: str | Path | Iterable[str | Path]) -> list[Entry]:
    """Returns the task files of a batch, each once, sorted by name.

    Parameters
    ----------
    tasks : str, Path or several of them
        Files, globs (``**`` goes through folders), or folders: all .yaml and .yml below them but
        those of hands (x.hand.yaml, x.clasp.yaml).

    Returns
    -------
    list of Entry
        A name is the path below the folder that all tasks have in common, so that equal names in
        different folders stay apart.

    Raises
    ------
    TaskError
        No file is there.
    """
    given = list(tasks) if isinstance(tasks, Iterable) and not isinstance(tasks, str) else [tasks]
    if not given:
        raise TaskError("tasks: none given; should be files, globs or folders")
    folders: list[Path] = []
    paths: dict[Path, None] = {}
    for one in given:
        is_folder = files.as_path(one).is_dir()
        found = _below(Path(one)) if is_folder else _files(str(one))
        if not found:
            raise TaskError(f"{one}: no task files there")
        paths.update(dict.fromkeys(Path(os.path.abspath(path)) for path in found))
        folders += [Path(one)] if is_folder else [path.parent for path in found]
    base = Path(os.path.commonpath([os.path.abspath(folder) for folder in folders]))
    return sorted(_named(list(paths), base), key=lambda entry: entry.name)


def _below(folder: Path) -> list[Path]:
    """Returns the task files below a folder and behind its links. Hidden ones are left out."""
    found: list[Path] = []
    seen = set()  # folders, of which links may make a circle
    for root, folders, names in os.walk(folder, followlinks=True):
        if (place := os.path.realpath(root)) in seen:
            folders.clear()
            continue
        seen.add(place)
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        named = (Path(root, name) for name in names if name.endswith(ENDINGS) and name[0] != ".")
        found += [path for path in named if not path.name.endswith(OF_HANDS)]
    # A link to a file that is gone is a bad task.
    return sorted(path for path in found if path.is_file() or path.is_symlink())


def _files(text: str) -> list[Path]:
    if Path(text).exists():  # also a name that holds a bracket
        return [Path(text)]
    if not glob.has_magic(text):
        raise TaskError(f"{text}: no such file")
    return [path for path in map(Path, sorted(glob.glob(text, recursive=True))) if path.is_file()]


def _named(paths: list[Path], base: Path) -> list[Entry]:
    """Returns the paths without their suffixes, unless that is also the name of another."""
    relative = {path: path.relative_to(base).as_posix() for path in paths}
    short = {path: name.removesuffix(path.suffix) for path, name in relative.items()}
    count = Counter(short.values())
    taken = {name for name, times in count.items() if times > 1} | set(relative.values())
    return [Entry(relative[path] if name in taken else name, path) for path, name in short.items()]
