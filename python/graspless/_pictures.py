# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture and replay that a command writes."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import argparse

    from ._plan import Plan


def add_pictures(parser: argparse.ArgumentParser) -> None:
    """Adds the flags --png and --html."""
    parser.add_argument("--png", metavar="FILE", help="write a picture to FILE")
    parser.add_argument(
        "--html", metavar="FILE", help="write a replay to FILE: a single page for any browser"
    )


def check_pictures(options: argparse.Namespace) -> None:
    """Raises TaskError, before any planning, if a picture could not be written."""
    from . import files, view

    if options.png is not None:
        view.check_png(options.png)
        files.check_writable(options.png)
    if options.html is not None:
        view.check_html(options.html)


def draw(plan: Plan, options: argparse.Namespace) -> list[str]:
    """Writes the requested pictures; returns their paths."""
    from . import progress, view

    asked = ((options.png, view.write_png), (options.html, view.write_html))
    for path, write in asked:
        if path is not None:
            with progress.waiting(f"drawing {path}"):
                write(plan, path)
    return [path for path, _ in asked if path is not None]
