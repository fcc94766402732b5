# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Manifest of a batch: JSON lines, one row per task, written as results arrive."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
from typing import TYPE_CHECKING, Any

from .. import files
from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

Row = dict[str, Any]
NAME = "batch.jsonl"


def read(path: Path, key: str = "name") -> dict[str, Row]:
    """Returns the rows by name, the last one of each; truncated lines are skipped."""
    if not path.is_file():
        return {}
    rows = {}
    for line in path.read_text(encoding="utf-8", errors="replace").split("\n"):
        with contextlib.suppress(ValueError):
            row = json.loads(line)
            if isinstance(row, dict) and isinstance(row.get(key), str):
                rows[row[key]] = row
    return rows


class Log:
    """A file of rows that grows."""

    def __init__(self, path: Path) -> None:
        """Raises TaskError if the file cannot be written, or another process is writing it."""
        files.check_writable(path)
        self._path = path
        self._file = path.open("ab", buffering=0)  # what is left unwritten shall not be tried again
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            is_ours = os.path.samestat(os.fstat(self._file.fileno()), path.stat())  # not replaced
        except BlockingIOError:
            is_ours = False
        except OSError:  # a file system without locks
            is_ours = True
        if not is_ours:
            self._file.close()
            raise TaskError(f"{path}: another run is writing it")
        if self._file.tell() and not path.read_bytes().endswith(b"\n"):
            self._write(b"\n")  # after a line that was cut short

    def add(self, row: Row) -> None:
        """Writes a row at once, so that no result is lost; raises TaskError."""
        self._write(encoded(row))

    def _write(self, data: bytes) -> None:
        with files.writing(self._path):
            while data:
                data = data[self._file.write(data) :]

    def close(self) -> None:
        self._file.close()


@contextlib.contextmanager
def opened(path: Path) -> Iterator[Log]:
    log = Log(path)
    try:
        yield log
    finally:
        log.close()


def rewrite(path: Path, rows: Iterable[Row]) -> None:
    """Rewrites all rows, atomically: the last act of the one who has the file opened."""
    files.write(path, b"".join(map(encoded, rows)))


def encoded(row: Row, indent: int | None = None) -> bytes:
    """Returns a row as JSON in UTF-8. Names of files that are not UTF-8 become escapes."""
    text = json.dumps(row, ensure_ascii=False, indent=indent) + "\n"
    return text.encode(errors="backslashreplace")
