# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of plans."""

from __future__ import annotations

import contextlib
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from .. import _plan, files
from ..errors import TaskError, missing, shown
from ..kinds import part, require_motion

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

    from .. import geometry
    from .._plan import Plan
    from ..perception import Scene
    from ..simulation.results import Recording
    from .hand import Proposal


def write_png(plan: Plan, path: str | Path) -> None:
    """Draws a plan: the robot or object at some moments, and the measures of its quality.

    Parameters
    ----------
    plan : Plan
        If it has no motion, the start is drawn.
    path : str or Path
        .png file to write.

    Raises
    ------
    TaskError
        The file cannot be written, has another ending, or a package of `graspless[view]` is
        missing.
    """
    with _png(path) as write:
        from .figures import as_png

        write(as_png(figure(plan)))


def figure(plan: Plan) -> Figure:
    """Returns the picture of a plan, as `write_png` draws it, as a figure of matplotlib.

    Raises TaskError if a solved plan has no rows to draw.
    """
    _require_plan(plan)
    if plan:
        require_motion(plan, "draw")
    with _told():
        from . import notebook

        notebook.let_figures_show()
        drawn: Figure = part("view", plan.kind, "picture").draw(plan)
    return drawn


def show(plan: Plan) -> None:
    """Shows a replay: inline in a notebook, otherwise in the web browser."""
    _require_plan(plan)
    with _told():
        from . import notebook

        notebook.show(plan)


def html(plan: Plan) -> str:
    """Returns the view of a plan in a notebook: its summary and its picture."""
    _require_plan(plan)
    from . import notebook

    return notebook.html(plan, figure)


def write_loops_png(points: ArrayLike, loops: geometry.Loops, path: str | Path) -> None:
    """Draws a point cloud with its loops, and its Betti curve.

    Parameters
    ----------
    points : array [N, 3]
        Point cloud [m].
    loops : geometry.Loops
        Result of `geometry.shortest_loops`.
    path : str or Path
        .png file to write.

    Raises
    ------
    TaskError
        The file cannot be written, has another ending, or a package of `graspless[view]` is
        missing.
    """
    with _png(path) as write:
        from .loops import draw

        write(draw(points, loops))


def write_scene_png(scene: Scene, path: str | Path) -> None:
    """Draws a scene from above: supports with their edges by label, objects, and unseen space.

    Parameters
    ----------
    scene : perception.Scene
    path : str or Path
        .png file to write.

    Raises
    ------
    TaskError
        The file cannot be written, has another ending, or a package of `graspless[view]` is
        missing.
    """
    with _png(path) as write:
        from .perceived import draw

        write(draw(scene))


@contextlib.contextmanager
def _png(path: str | Path) -> Iterator[Callable[[bytes], None]]:
    """Yields what writes a picture. Faults of the path are found before it is drawn."""
    check_png(path)
    files.check_writable(path)
    with _told():
        yield partial(files.write, path)


def check_png(path: str | Path) -> None:
    """Raises TaskError unless the file's ending is .png or missing."""
    if Path(path).suffix.lower() not in ("", ".png"):
        raise TaskError(f"{path}: unknown kind of picture (choices: .png)")


def write_html(plan: Plan, path: str | Path, recording: Recording | None = None) -> None:
    """Writes a replay with a play button, a time slider and a legend: one file, without network.

    Parameters
    ----------
    plan : Plan
    path : str or Path
        .html file to write.
    recording : Recording, optional
        Recording of a simulation. It is shown instead of the plan; the planned object is a ghost.

    Raises
    ------
    TaskError
        The file cannot be written, or a package of `graspless[view]` is missing.
    """
    _require_plan(plan)
    check_html(path)
    with _told():
        from .replay import as_html

        page = as_html(plan, recording)
    files.write(path, page)


def check_html(path: str | Path) -> None:
    """Raises TaskError if a replay could not be written, also because viser is missing.

    Called before the work that the replay is to show. The file's ending is .html or .htm, or
    missing.
    """
    if Path(path).suffix.lower() not in ("", ".html", ".htm"):
        raise TaskError(f"{path}: unknown kind of replay (choices: .html)")
    files.check_writable(path)
    with _told():
        import viser  # noqa: F401


def check_viewer(port: int) -> None:
    """Raises TaskError if a viewer could not be served, also because viser is missing."""
    with _told():
        import viser  # noqa: F401

    from .server import check_port

    check_port(port)


def serve(plan: Plan, port: int = 8080) -> None:
    """Serves a viewer on this machine until Ctrl-C.

    It has a time slider, a speed, a legend, and a check box for each layer.

    Parameters
    ----------
    plan : Plan
    port : int
        Port on localhost, in [1, 65535].

    Raises
    ------
    TaskError
        The port cannot be used, or a package of `graspless[view]` is missing.
    """
    _require_plan(plan)
    with _told():
        from .replay import serve as run

        run(plan, port)


def serve_proposal(proposal: Proposal, port: int = 8080) -> None:
    """Serves a proposed robot on this machine until Ctrl-C, as `Proposal.serve` does."""
    with _told():
        from .joints import serve as run

        run(proposal, port)


def _require_plan(plan: object) -> None:
    if not isinstance(plan, _plan.Plan):
        what = "should be a graspless.Plan; graspless.load_plan reads one from its file"
        raise TaskError(f"plan: {shown(plan)}: {what}")


@contextlib.contextmanager
def _told() -> Iterator[None]:
    """Turns an ImportError into a TaskError that names the extra to install."""
    try:
        yield
    except ImportError as error:
        raise missing(error, "view", " to draw") from None


__all__ = [
    "figure",
    "serve",
    "show",
    "write_html",
    "write_loops_png",
    "write_png",
    "write_scene_png",
]


def __dir__() -> list[str]:
    return __all__
