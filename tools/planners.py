# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws docs/planners.gif: slide, fingertip and clasp at work, side by side.

python tools/planners.py
"""

from __future__ import annotations

import pathlib
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import graspless
from graspless import frames
from graspless.view import raster
from graspless.view.bodies import robot
from graspless.view.film import spread
from graspless.view.film import timed as timed_film

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = pathlib.Path(__file__).parents[1]
TARGET = ROOT / "docs" / "planners.gif"
SHAPE = (340, 290)  # of a panel [pixels]
COUNT = 56  # frames
PERIOD, HOLD = 90, 1200  # of a frame, and of the last one [ms]
TITLE = 26  # [pixels]
COLORS = 200


def slide() -> Iterator[Any]:
    """A card to the table's edge, and the grasp there."""
    from graspless.view.slide import bodies, stage
    from graspless.view.slide.film import film

    plan: Any = graspless.plan(ROOT / "examples" / "01_slide_card.yaml")
    shown = _even(timed_film(film(plan)))
    camera = stage.camera(shown, *SHAPE, spread(shown))
    still = [
        (bodies.table_body(plan.task), np.asarray(plan.task.problem.support.X_WS)),
        (bodies.trail_body(shown), np.eye(4)),
    ]
    thing, links = bodies.object_body(plan.task), robot(plan.task)
    for row in range(COUNT):
        arm = [
            (body, X) for body, X in zip(links, shown.link_poses[row], strict=True) if body.parts
        ]
        yield raster.render([*still, *arm, (thing, shown.object_poses[row])], camera, *SHAPE)


def fingertip() -> Iterator[Any]:
    """A block over its edge, with a change of grip."""
    from graspless.view.fingertip import bodies
    from graspless.view.fingertip.film import timed
    from graspless.view.fingertip.stage import camera, swept

    plan: Any = graspless.plan(ROOT / "examples" / "07_tumble_regrasp.yaml")
    every, _ = timed(plan, 20.0)
    moments = [every[round(k)] for k in np.linspace(0, len(every) - 1, COUNT)]
    task = plan.task
    points = swept(task, moments)
    floor, thing = bodies.floor_body(task, points), bodies.object_body(task)
    walls = [(wall, np.eye(4)) for wall in bodies.wall_bodies(task, points)]
    radius = task.problem.fingers.radius
    tips = {mode: bodies.fingertip_body(radius, color) for mode, color in bodies.MODES.items()}
    largest = max(float(np.linalg.norm(m.forces, axis=1).max()) for m in moments)
    ends = np.concatenate([bodies.arrow_ends(task, m, largest).reshape(-1, 3) for m in moments])
    whole = np.concatenate([points, ends[ends.any(axis=1)], floor.parts[0].vertices])
    view = camera(task, moments, whole, SHAPE)
    for moment in moments:
        fingers = [
            (tips[mode], frames.translation(center))
            for mode, center in zip(moment.modes, moment.centers_W, strict=True)
            if np.isfinite(center).all()
        ]
        front = [*fingers, *bodies.arrows(task, moment, largest)]
        scene = [(floor, np.eye(4)), (thing, moment.X_WO), *front]
        plain, walled = (raster.render([*scene, *more], view, *SHAPE) for more in ([], walls))
        picture = 0.5 * (plain + walled)  # the walls are transparent
        yield raster.over(raster.render(front, view, *SHAPE), picture, 0.3)


def clasp() -> Iterator[Any]:
    """A hand through the handle of a purse."""
    from graspless.view.clasp import stage
    from graspless.view.clasp.film import film

    plan: Any = graspless.plan(ROOT / "examples" / "13_clasp_purse.yaml")
    shown = _even(timed_film(film(plan)))
    scene = stage.Scene(plan, shown)
    view = stage.camera(scene, spread(shown, 8), SHAPE)
    for row in range(COUNT):
        lines = scene.lines(row)
        whole = raster.render([*scene.solid(row), *lines], view, *SHAPE)
        yield raster.over(raster.render(lines, view, *SHAPE), whole, 0.75)


def _even(shown: Any) -> Any:
    return shown.resampled((COUNT - 1) / shown.times[-1])


def main() -> None:
    """Draws the picture."""
    titles = ("slide", "fingertip", "clasp")
    font = ImageFont.load_default(17)
    pages = []
    for panels in zip(slide(), fingertip(), clasp(), strict=False):
        page = Image.new("RGB", (3 * SHAPE[0], SHAPE[1] + TITLE), "white")
        for k, (title, rgba) in enumerate(zip(titles, panels, strict=True)):
            rgb = rgba[..., :3] * rgba[..., 3:] + 1 - rgba[..., 3:]
            panel = Image.fromarray(np.round(255 * rgb).astype(np.uint8))
            page.paste(panel, (k * SHAPE[0], TITLE))
            ImageDraw.Draw(page).text((k * SHAPE[0] + 12, 4), title, (40, 44, 52), font)
        pages.append(page)
    palette = _palette(pages)
    drawn = [page.quantize(palette=palette, dither=Image.Dither.NONE) for page in pages]
    periods = [PERIOD] * (len(drawn) - 1) + [HOLD]
    drawn[0].save(
        TARGET, save_all=True, append_images=drawn[1:], duration=periods, loop=0, optimize=True
    )
    print(f"{TARGET.name}: {len(drawn)} frames, {TARGET.stat().st_size // 1000} kB")


def _palette(pages: list[Image.Image]) -> Image.Image:
    """One for all frames, so that what stands still stays the same."""
    some = pages[:: max(1, len(pages) // 6)]
    tall = Image.new("RGB", (some[0].width, sum(page.height for page in some)))
    for k, page in enumerate(some):
        tall.paste(page, (0, k * page.height))
    return tall.quantize(COLORS, method=Image.Quantize.MAXCOVERAGE)


if __name__ == "__main__":
    main()
