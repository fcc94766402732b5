# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws docs/gallery.md with a picture of every example.

python tools/gallery.py [NAME...]     only these pictures, and the page
"""

from __future__ import annotations

import contextlib
import io
import pathlib
import re
import runpy
import sys
import tempfile
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image
from PIL.PngImagePlugin import PngInfo

import graspless
from graspless import frames, report, view
from graspless.view import raster
from graspless.view.raster import Camera

if TYPE_CHECKING:
    from collections.abc import Callable

ROOT = pathlib.Path(__file__).parents[1]
EXAMPLES, DOCS = ROOT / "examples", ROOT / "docs"
WIDTH = 960  # of a picture at most [pixels]
LARGEST = 120_000  # bytes of a picture
COLORS = (200, 100, 50, 25)  # of a palette, as many as fit

HEAD = """\
# Gallery

Every example in `examples/`, planned with its own seed.
In Python, `graspless.plan("examples/01_slide_card.yaml")` gives the same plan.
`tools/gallery.py` draws this page.
"""
ENTRY = """
## {name}

{about}{script}

```sh
{shell}
```
{shown}
![{name}](gallery/{name}.png)
"""
SHOWN = """
```output
{summary}
```
"""


def names() -> list[str]:
    """The numbered examples, by number."""
    found = {path.stem for path in EXAMPLES.iterdir() if path.suffix in (".yaml", ".py")}
    return sorted(name for name in found if name[:2].isdigit())


def entry(name: str) -> str:
    """Returns the section of an example: its purpose, how to run it, and what its picture shows."""
    task, script = EXAMPLES / f"{name}.yaml", EXAMPLES / f"{name}.py"
    summary = summary_of(name)
    if task.is_file():
        lines = task.read_text(encoding="utf-8").splitlines()
        about = next(line[2:] for line in lines if line.startswith("# ") and "SPDX" not in line)
        shell = f"graspless plan examples/{task.name} -o plan.json"
        also = f" Without a task file: `examples/{script.name}`." if script.is_file() else ""
    else:
        about = script.read_text(encoding="utf-8").split('"""')[1].splitlines()[0]
        shell, also = SCRIPTS[name], ""
    shown = SHOWN.format(summary=summary) if summary else ""
    return ENTRY.format(name=name, about=about, script=also, shell=shell, shown=shown)


def summary_of(name: str) -> str:
    """Returns the summary of the plan that the picture shows: the picture keeps it as a text."""
    with Image.open(DOCS / "gallery" / f"{name}.png") as picture:
        return str(picture.info.get("Description", ""))


def summary(plan: graspless.Plan) -> str:
    """Returns the summary of a plan without times and counters of the search."""
    lines = [
        re.sub(r"solved in [^,]*,", "solved in ...,", line)
        for line in report.as_text(plan).splitlines()
        if not line.strip().startswith("search:")
    ]
    return "\n".join(lines)


def picture(name: str) -> tuple[Image.Image, str]:
    """Draws an example; returns the picture and the summary of its plan."""
    if not (EXAMPLES / f"{name}.yaml").is_file():
        return (_many if name == "22_many_tasks" else _scripted)(name), ""
    plan = graspless.plan(EXAMPLES / f"{name}.yaml")
    assert plan, f"{name}: {plan.reason}"
    return _drawn(lambda path: view.write_png(plan, path)), summary(plan)


def _scripted(name: str) -> Image.Image:
    """What a script draws."""
    return _drawn(lambda path: _run(name, str(path)))


def _run(name: str, *arguments: str) -> None:
    """Runs the script of an example."""
    given, sys.argv = sys.argv, [name, *arguments]
    try:
        runpy.run_path(str(EXAMPLES / f"{name}.py"))
    finally:
        sys.argv = given


def _many(name: str) -> Image.Image:
    """Cards of a batch where they start, with the ways of the fingertip, and a legend."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    from graspless.view.bodies import OBJECT, TRAIL
    from graspless.view.figures import as_png, draw_panel, new_figure
    from graspless.view.slide import bodies
    from graspless.view.slide.film import film
    from graspless.view.slide.picture import OUTLINE

    with tempfile.TemporaryDirectory() as folder:
        with contextlib.suppress(SystemExit):
            _run(name, folder, "8")
        plans: list[Any] = [graspless.plan(path) for path in sorted(pathlib.Path(folder).iterdir())]
    assert all(plans)
    table, X_WS = plans[0].task, np.asarray(plans[0].task.problem.support.X_WS)
    placed = [(bodies.table_body(table), X_WS)]
    for k, plan in enumerate(plans):  # each on those before it, where they would overlap
        X_WW = frames.translation([0, 0, 0.002 * k])
        X_WO = X_WW @ np.asarray(plan.task.problem.X_WO_start)
        placed.append((bodies.object_body(plan.task), X_WO))
        placed.append((bodies.trail_body(film(plan)), X_WW))
    corners = placed[0][0].parts[0].vertices @ X_WS[:3, :3].T + X_WS[:3, 3]
    middle = corners.mean(axis=0)
    shape = (WIDTH, 560)
    camera = Camera(middle + [1.0, -1.6, 1.8], middle).fitted(corners, *shape)
    figure = new_figure(9.6, 6.0, dpi=100)
    draw_panel(figure.add_axes((0, 0.07, 1, 0.93)), raster.render(placed, camera, *shape), "")
    handles = {
        "a card of each task where it starts": Patch(fc=OBJECT, ec=OUTLINE),
        "path of the fingertip on it, to the edge": Line2D([], [], color=TRAIL, lw=2.4),
    }
    figure.legend(list(handles.values()), list(handles), loc="lower center", ncols=2, frameon=False)
    return Image.open(io.BytesIO(as_png(figure))).convert("RGB")


def _drawn(write: Callable[[pathlib.Path], None]) -> Image.Image:
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "a.png")
        write(path)
        return Image.open(io.BytesIO(path.read_bytes())).convert("RGB")


def shrunk(drawn: Image.Image, text: str) -> bytes:
    """Returns a PNG that is not too large, with as many colours as fit, and a text inside."""
    notes = PngInfo()
    notes.add_text("Description", text)
    height = round(drawn.height * WIDTH / drawn.width)
    small = drawn.resize((WIDTH, height), Image.Resampling.LANCZOS)
    for count in COLORS:
        written = io.BytesIO()
        palette = small.quantize(count, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        palette.save(written, "png", optimize=True, pnginfo=notes)
        if written.tell() <= LARGEST:
            break
    return written.getvalue()


def write_page() -> None:
    """Writes docs/gallery.md."""
    (DOCS / "gallery.md").write_text(
        HEAD + "".join(entry(name) for name in names()), encoding="utf-8"
    )


SCRIPTS = {
    "18_shortest_loops": "python examples/18_shortest_loops.py loops.png",
    "27_set_the_table": "python examples/27_set_the_table.py table.png",
    "28_see_table": "python examples/28_see_table.py scene.png",
    "29_box_between_walls": "python examples/29_box_between_walls.py tumble.png",
    "30_carry_luggage": "python examples/30_carry_luggage.py bag.png bag.html",
    "22_many_tasks": (
        "python examples/22_many_tasks.py tasks 8\ngraspless batch tasks -o plans --jobs 2"
    ),
}


def main(asked: list[str]) -> None:
    """Draws what is asked for, or all."""
    (DOCS / "gallery").mkdir(exist_ok=True)
    for name in asked or names():
        data = shrunk(*picture(name))
        (DOCS / "gallery" / f"{name}.png").write_bytes(data)
        print(f"{name}: {len(data) // 1000} kB", flush=True)
    write_page()


if __name__ == "__main__":
    main(sys.argv[1:])
