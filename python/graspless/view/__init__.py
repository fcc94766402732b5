# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans as pictures and replays."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING

from .. import files
from ..errors import TaskError
from ..kinds import part

if TYPE_CHECKING:
    from collections.abc import Iterator

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
    with _told():
        picture: bytes = part("view", plan.kind).draw(plan)
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
    with _told():
        from .loops import draw

        picture = draw(points, loops)
    files.write(path, picture)


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
    check_html(path)
    with _told():
        from .replay import as_html

        page = as_html(plan, recording)
    files.write(path, page)


def check_html(path: str | Path) -> None:
    """Raises TaskError where no replay could be written, for want of viser too: before the work
    that it is to show.
    """
    files.check_writable(path)
    with _told():
        import viser  # noqa: F401


def serve(plan: Plan, port: int = 8080) -> None:
    """Serves a viewer on this machine until Ctrl-C: time slider, speed, a box for each layer."""
    with _told():
        from .replay import serve as run

        run(plan, port)


@contextlib.contextmanager
def _told() -> Iterator[None]:
    """What is not installed is a TaskError; only where drawing begins is it looked for."""
    try:
        yield
    except ImportError as error:
        what = f"needs {error.name or error} to draw: pip install 'graspless[view]'"
        raise TaskError(what) from None


__all__ = ["serve", "write_html", "write_loops_png", "write_png"]
