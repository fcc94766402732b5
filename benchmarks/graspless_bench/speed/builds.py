# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds of graspless, each in a process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graspless.errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Mapping

# The queries are always those of this package, also where a folder has an older one of its own.
_START = """
import sys
import graspless
sys.path.sort(key=lambda path: path == {folder!r})  # now the last
"""
_WORK = """
from graspless_bench.speed.worker import main
main()
"""


class NoAnswerError(Exception):
    """A build lacks something that a query needs, or its process ended."""


class Build:
    """A worker with the installed graspless, or with that of a folder.

    Parameters
    ----------
    folder : Path or None
        Folder that contains the package `graspless`. None: the installed one.
    """

    def __init__(self, folder: Path | None) -> None:
        self._folder = folder
        self._process = _start(folder)

    def ask(self, **request: Any) -> dict[str, Any]:
        """Returns the worker's answer. Raises NoAnswerError.

        A worker that has ended is started again for the next query.
        """
        if "open" in request and self._process.poll() is not None:
            self.__exit__()
            self._process = _start(self._folder)
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            print(json.dumps(request), file=self._process.stdin, flush=True)
            line = self._process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            raise NoAnswerError(f"its process ended with code {self._process.wait()}")
        answer: dict[str, Any] = json.loads(line)
        if "error" in answer:
            raise NoAnswerError(answer["error"])
        return answer

    def __enter__(self) -> Build:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.communicate()


def _start(folder: Path | None) -> subprocess.Popen[str]:
    command, env = python(_WORK, folder)
    return subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=env,
        start_new_session=True,  # Ctrl-C ends the command, which ends its workers
    )


def python(code: str, folder: Path | None) -> tuple[list[str], Mapping[str, str]]:
    """Returns a command that runs Python code with a build, and its environment."""
    env = os.environ if folder is None else os.environ | {"PYTHONPATH": str(folder)}
    return [sys.executable, "-c", _START.format(folder=str(folder)) + code], env


def unpacked(given: Path, folder: Path) -> Path:
    """Returns a folder with the package `graspless` of a wheel, or of a folder.

    Parameters
    ----------
    given : Path
        As the user gave it.
    folder : Path
        A wheel is installed there.
    """
    if (given / "graspless" / "__init__.py").exists():
        return given.absolute()
    if given.suffix != ".whl" or not given.is_file():
        raise TaskError(
            f"--against: {given}: should be a wheel of graspless, or a folder that contains the "
            "package graspless"
        )
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target"]
    done = subprocess.run([*command, str(folder), str(given)], capture_output=True, text=True)
    if done.returncode != 0:
        raise TaskError(f"--against: {given}: cannot be installed: {done.stderr.strip()}")
    return folder
