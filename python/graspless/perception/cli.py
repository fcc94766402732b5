# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless see`, which finds tables and objects in depth images."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._commands import FOUND, NOT_FOUND
from ..errors import TaskError
from .view_files import kind_of, read_view

if TYPE_CHECKING:
    import argparse

    from .._core.perception import Options, Scene
    from ..frames import Matrix


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `see`."""
    parser.description = (
        "Find tables and shelves in depth images, with a label for each edge, and the objects on "
        "them. Several files are several views of one still scene. The exit code is 1 if nothing "
        "trustworthy was found; the scene file then says why."
    )
    parser.add_argument(
        "files",
        metavar="FILE",
        nargs="+",
        help=".npz with the arrays depth (H, W) or frames (N, H, W) to be averaged [m], K (3, 3) "
        "[pixels] and X_WC (4, 4); a depth image (.png, .tiff, .npy) with --camera; or a cloud "
        "(.ply, .pcd, .xyz, .npy) in the world, with --viewpoint",
    )
    parser.add_argument(
        "--camera",
        metavar="YAML",
        action="append",
        help="file with the camera of a depth image: focal, center, pose, and the unit of "
        "integers; once for each image, in their order",
    )
    parser.add_argument(
        "--viewpoint",
        type=float,
        nargs=3,
        action="append",
        metavar=("X", "Y", "Z"),
        help="position of the camera that took a cloud [m]: after all files, once for each cloud, "
        "in their order",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        default="scene.yaml",
        help="scene file to write, with an .npz file beside it; another file of that name is kept "
        "as NAME~ (default: %(default)s)",
    )
    parser.add_argument(
        "--stamp",
        type=float,
        metavar="S",
        help="when the images were taken [s since 1970], so that `graspless pick --max-age` can "
        "refuse an old scene",
    )
    parser.add_argument(
        "--options",
        metavar="YAML",
        help="fields of perception.Options, such as '{max_height: 0.4, max_pixels: 2000000}'",
    )
    parser.add_argument("--png", metavar="FILE", help="write a picture to FILE")
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .. import files, perception, view
    from .front import warn_of_camera

    if Path(options.output).suffix.lower() not in (".yaml", ".yml"):
        raise TaskError(f"{options.output}: unknown kind of scene file (choices: .yaml, .yml)")
    if options.stamp is not None and not math.isfinite(options.stamp):
        raise TaskError(f"--stamp: {options.stamp}: should be a time in seconds since 1970")
    files.check_writable(options.output)
    arrays = Path(options.output).with_suffix(".npz")
    if arrays.resolve() in [Path(path).resolve() for path in options.files]:
        raise TaskError(
            f"--output: {options.output}: {arrays.name} beside it would replace an input of this "
            "command"
        )
    if options.png is not None:
        view.check_png(options.png)
        files.check_writable(options.png)
    chosen = _perception_options(options.options)
    kinds = [kind_of(Path(path)) for path in options.files]
    cameras = _each(options.files, kinds, "image", "--camera", options.camera)
    viewpoints = _each(options.files, kinds, "cloud", "--viewpoint", options.viewpoint)
    views = [
        read_view(Path(path), kinds[k], cameras.get(k), viewpoints.get(k))
        for k, path in enumerate(options.files)
    ]
    for path, given in zip(options.files, views, strict=True):
        warn_of_camera(given, path)
    try:
        scene = perception.perceive_views(views, chosen)
    except ValueError as error:
        raise TaskError(f"{', '.join(options.files)}: {error}") from None
    scene.stamp = options.stamp
    kept = perception.save_scene(scene, options.output)
    if options.png is not None:
        view.write_scene_png(scene, options.png)
    if options.json:
        print(json.dumps(_summary(scene) | {"kept": [str(kept)] if kept else []}))
    else:
        print("\n".join(_lines(scene)))
        written = [options.output, *([] if options.png is None else [options.png])]
        print(f"written: {', '.join(written)}")
        if kept is not None:
            print(f"kept: {kept}, as it was before")
    return FOUND if scene else NOT_FOUND


def _perception_options(text: str | None) -> Options:
    """Returns the options of perception that YAML gives.

    Raises TaskError that names the field unless all are known and within their ranges.
    """
    from ..perception import Options

    if text is None:
        return Options()
    from ..tasks.options import described_by
    from ..tasks.reading import parse_yaml
    from ..tasks.shapes import Fields

    @described_by(Options)
    class Given(Fields):
        """Options of perception."""

    if not text.lstrip().startswith("{") and ":" not in text:
        known = ", ".join(Given.model_fields)
        what = f"should be fields in YAML, such as '{{max_height: 0.4}}' (one of: {known})"
        raise TaskError(f"--options: {text}: {what}")
    fields: Fields = parse_yaml(text, "--options").validate(Given)
    return Options(**fields.model_dump(exclude_none=True))


def _each(
    files: list[str], kinds: list[str], kind: str, flag: str, given: list[Any] | None
) -> dict[int, Any]:
    """Returns the values of a flag by the index of their files, or none if the flag is not given.

    Raises TaskError if there are values, but not one for each file of the kind.
    """
    found = [k for k, of in enumerate(kinds) if of == kind]
    if given and not found:
        what = {"image": "depth image", "cloud": "cloud"}[kind]
        raise TaskError(f"{flag}: has no effect: none of the files is a {what}")
    if given and len(given) != len(found):
        names = ", ".join(files[k] for k in found)
        raise TaskError(
            f"{flag}: {len(given)} for {len(found)} {kind}(s) ({names}): should be given once for "
            "each, in their order"
        )
    return dict(zip(found, given or [], strict=False))


def _lines(scene: Scene) -> list[str]:
    """Returns the summary as text."""
    lines = [scene.reason]
    for support in scene.supports:
        counts = {str(label): 0 for label in support.edges}
        for label in support.edges:
            counts[str(label)] += 1
        edges = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
        least = f"objects of {1000 * support.least_thickness:.1f} mm can be seen"
        height = round(support.X_WS[2, 3], 3) + 0.0  # no minus zero
        lines.append(f"  {support.name}: height {height:.3f} m; edges: {edges}; {least}")
    for thing in scene.objects:
        long, short = 100 * _sides(np.asarray(thing.outline))
        top, error = 1000 * thing.thickness, 1000 * thing.thickness_error
        # What is not flat has a quantile of its heights, whose bias the standard error lacks.
        thick = f"{top:.1f} +- {error:.1f} mm thick, flat"
        if not thing.is_flat:
            thick = f"{top:.1f} mm thick (noise alone: +- {error:.1f} mm)"
        lines.append(f"  {thing.name} on {thing.support}: {long:.1f} cm x {short:.1f} cm, {thick}")
        lines += [f"    warning: {text}" for text in thing.warnings]
    return lines + [f"warning: {text}" for text in scene.warnings]


def _sides(outline: Matrix) -> Matrix:
    """Returns the sides of the smallest rectangle around an outline, the longer one first [m]."""
    from ..tasks.chain.lying import convex_hull

    ring = convex_hull(outline)
    along = np.roll(ring, -1, axis=0) - ring
    along /= np.linalg.norm(along, axis=1)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    sides = np.column_stack([np.ptp(ring @ along.T, axis=0), np.ptp(ring @ across.T, axis=0)])
    return np.sort(sides[np.argmin(sides.prod(axis=1))])[::-1]


def _summary(scene: Scene) -> dict[str, Any]:
    """Returns the summary as plain types."""
    return {
        "status": scene.status.name,
        "reason": scene.reason,
        "warnings": list(scene.warnings),
        "supports": [
            {
                "name": support.name,
                "height": float(support.X_WS[2, 3]),
                "edges": [label.name for label in support.edges],
                "least_thickness": support.least_thickness,
            }
            for support in scene.supports
        ],
        "objects": [
            {
                "name": thing.name,
                "support": thing.support,
                "position": thing.X_WO[:3, 3].tolist(),
                "thickness": thing.thickness,
                "thickness_error": thing.thickness_error,
                "is_flat": thing.is_flat,
                "warnings": list(thing.warnings),
            }
            for thing in scene.objects
        ],
    }
