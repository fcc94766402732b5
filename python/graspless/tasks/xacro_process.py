# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Expansion of xacro files in a process of its own, as they can run for ever.

Run as a script by path: it imports nothing of graspless.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

SECONDS = 10  # [s]
MEMORY = 2**30  # [byte]
LONGEST = 2**26  # [characters] of the expanded file


def expand(path: Path, words: dict[str, str], packages: dict[str, str]) -> str:
    """Returns the URDF of a xacro file. $(find NAME) is looked up in `packages` first.

    Raises
    ------
    ValueError
        It cannot be expanded, or needs more than SECONDS or MEMORY.
    """
    asked = {"path": str(path), "words": words, "packages": packages, "sys_path": sys.path}
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
    json.dump(answer, told)


def _expanded(asked: dict[str, Any]) -> str:
    import xacro
    from xacro import substitution_args

    find = substitution_args._eval_find
    substitution_args._eval_find = lambda name: asked["packages"].get(name) or find(name)
    text = str(xacro.process_file(asked["path"], mappings=asked["words"]).toprettyxml(indent="  "))
    if len(text) > LONGEST:
        raise ValueError(f"it becomes {len(text)} characters long, more than {LONGEST}")
    return text


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
