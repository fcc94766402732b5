#!/usr/bin/env python3
"""Prints what is over the budget of CONTRIBUTING.md; a reviewer judges it."""

from __future__ import annotations

import pathlib
import re
import subprocess

LINES = {".hpp": 150, ".cpp": 300, ".py": 300}
FUNCTION = 80  # lines


def long_functions(text: str) -> list[tuple[str, int]]:
    """Functions at column 0 of clang-formatted C++, by their first line."""
    found = []
    start: tuple[int, str] | None = None
    for number, line in enumerate(text.splitlines(), 1):
        if line and not line[0].isspace() and line.endswith("{") and "namespace" not in line:
            start = number, line
        elif line.startswith("}") and start:
            if number - start[0] > FUNCTION and re.search(r"\)( const)? \{$", start[1]):
                found.append((start[1].rstrip(" {"), number - start[0]))
            start = None
    return found


def main() -> None:
    names = subprocess.run(
        ["git", "ls-files", "*.cpp", "*.hpp", "*.py"], capture_output=True, text=True, check=True
    )
    for name in names.stdout.split():
        path = pathlib.Path(name)
        if path.parts[0] in ("tests", "bindings") or not path.exists():
            continue  # tables
        text = path.read_text(encoding="utf-8")
        lines = text.count("\n")
        if lines > LINES[path.suffix]:
            print(f"over budget: {name} has {lines} lines ({LINES[path.suffix]})")
        if path.suffix != ".py":
            for function, length in long_functions(text):
                print(f"over budget: {name}: {function} has {length} lines ({FUNCTION})")


if __name__ == "__main__":
    main()
