# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans as pictures and replays."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from .. import files
from ..errors import TaskError
from ..kinds import part

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .. import geometry
    from ..plans import Plan
    from ..simulation import Recording


def write_png(plan: Plan, path: str | Path) -> None:
    """Draws a plan: what moves, at some moments of it, and what there is to know of it.

    Parameters
    ----------
    plan : Plan
        One without motion is drawn as it starts.
    path : str or Path
        .png file.
    """
    check_png(path)
    files.check_writable(path)
    try:
        picture: bytes = part("view", plan.kind).draw(plan)
    except ImportError as error:
        raise TaskError(_missing(error)) from None
    files.write(path, picture)


def write_loops_png(points: ArrayLike, loops: geometry.Loops, path: str | Path) -> None:
    """Draws a cloud with its loops, and how many there are at every longest edge.

    Parameters
    ----------
    points : array [N, 3]
        [m].
    loops : geometry.Loops
        Of `geometry.shortest_loops`.
    path : str or Path
        .png file.
    """
    check_png(path)
    files.check_writable(path)
    try:
        from .loops import draw
    except ImportError as error:
        raise TaskError(_missing(error)) from None
    files.write(path, draw(points, loops))


def check_png(path: str | Path) -> None:
    """Raises TaskError where the name says that another kind of picture is wanted."""
    if Path(path).suffix.lower() not in ("", ".png"):
        raise TaskError(f"{path}: unknown kind of picture (choices: .png)")


def write_html(plan: Plan, path: str | Path, recording: Recording | None = None) -> None:
    """Writes a replay with a play button and a time slider, in one file that needs no network.

    Parameters
    ----------
    plan : Plan
    path : str or Path
        .html file.
    recording : Recording, optional
        Of a simulation of the plan: shown instead of the plan, whose object is a ghost.
    """
    files.check_writable(path)
    try:
        from .replay import as_html
    except ImportError as error:
        raise TaskError(_missing(error)) from None
    files.write(path, as_html(plan, recording))


def serve(plan: Plan, port: int = 8080) -> None:
    """Serves a viewer on this machine until Ctrl-C: time slider, speed, a box for each layer."""
    try:
        from .replay import serve as run
    except ImportError as error:
        raise TaskError(_missing(error)) from None
    run(plan, port)


def _missing(error: ImportError) -> str:
    return f"needs {error.name or error} to draw: pip install 'graspless[view]'"


__all__ = ["serve", "write_html", "write_loops_png", "write_png"]
