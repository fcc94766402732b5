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
from ..errors import TaskError, explain, is_of_library
from ..files import absence

if TYPE_CHECKING:
    import argparse

    from .._core.perception import Options, Scene, View
    from ..frames import Matrix

CLOUDS = (".ply", ".pcd", ".xyz")
MOST = 4_000_000_000  # bytes of the arrays in a file


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
        "[pixels] and X_WC (4, 4); or a cloud (.ply, .pcd, .xyz) in the world, with --viewpoint",
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
    viewpoints = _viewpoints(options)
    views = [read_view(Path(path), viewpoints.get(k)) for k, path in enumerate(options.files)]
    _require_cloud(options)
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


def _clouds(options: argparse.Namespace) -> list[int]:
    """Returns which of the files are clouds."""
    return [k for k, file in enumerate(options.files) if Path(file).suffix.lower() in CLOUDS]


def _viewpoints(options: argparse.Namespace) -> dict[int, list[float]]:
    """Returns the viewpoints of the clouds by the index of their files, or none.

    Raises TaskError if there are viewpoints, but not one for each cloud.
    """
    clouds, given = _clouds(options), options.viewpoint or []
    if clouds and given and len(given) != len(clouds):
        names = ", ".join(options.files[k] for k in clouds)
        raise TaskError(
            f"--viewpoint: {len(given)} for {len(clouds)} cloud(s) ({names}): should "
            "be given once for each, in their order"
        )
    return dict(zip(clouds, given, strict=False))


def _require_cloud(options: argparse.Namespace) -> None:
    """Raises TaskError if --viewpoint would have no effect."""
    if options.viewpoint is None or _clouds(options):
        return
    given = " ".join(f"{x:g}" for x in options.viewpoint[0])
    raise TaskError(
        f"--viewpoint: {given}: only for clouds ({', '.join(CLOUDS)}); the array X_WC of an .npz "
        "file says where its camera was"
    )


def read_view(path: Path, viewpoint: list[float] | None) -> View:
    """Reads one view from a file of arrays, or from a cloud and its viewpoint.

    Raises
    ------
    TaskError
        The file is missing or not valid; names file, array and shape.
    """
    from .clouds import view_of_cloud

    suffix = path.suffix.lower()
    if suffix not in (".npz", *CLOUDS):
        choices = ", ".join((".npz", *CLOUDS))
        raise TaskError(f"{path}: unknown kind of file (one of: {choices})")
    if not path.is_file():
        raise TaskError(f"{path}: {absence(path)}")
    try:
        if suffix == ".npz":
            return _view_of_arrays(path)
        from ..tasks.clouds import read_cloud, stated_viewpoint

        if viewpoint is None:
            hint = ""
            if (stated := stated_viewpoint(path)) is not None:
                shown = " ".join(f"{value:g}" for value in stated)
                hint = f"; VIEWPOINT in the file is {shown}, if that is in the points' frame"
            raise ValueError(
                "a cloud needs --viewpoint X Y Z, the position of the camera: without it nobody "
                f"knows what the points hide{hint}"
            )
        return view_of_cloud(read_cloud(path), viewpoint)
    except ValueError as error:
        raise TaskError(f"{path}: {error}") from None


def _view_of_arrays(path: Path) -> View:
    from .._core.perception import View
    from ..tasks.source import shorten
    from .arrays import read_arrays
    from .clouds import average

    try:
        found = read_arrays(path, MOST, wanted=("depth", "frames", "K", "X_WC"))
    except Exception as error:  # numpy and zipfile raise whatever they stumble over
        if not is_of_library(error):
            raise
        raise ValueError(f"cannot be read as arrays: {explain(error)}") from None
    missing, hint = [name for name in ("K", "X_WC") if name not in found], ""
    if "depth" in found and "frames" in found:
        raise ValueError("has both depth and frames; it must have one of them")
    if "depth" not in found and "frames" not in found:
        missing.insert(0, "depth (or frames)")
        hint = "; for an organised cloud use perception.view_of_organized, see docs/howto/camera.md"
    if missing:
        with np.load(path) as arrays:
            has = shorten(", ".join(arrays.files) or "none")
        what = f"array{'s' if len(missing) > 1 else ''} {', '.join(missing)}"
        raise ValueError(f"must have the {what}; it has {has}{hint}")
    for name, array in found.items():
        if array.dtype.kind not in "fiu":
            raise ValueError(f"{name} has values of type {array.dtype}, not numbers")
    if "frames" in found and found["frames"].ndim != 3:
        raise ValueError(f"frames has shape {found['frames'].shape}; it must be (N, H, W)")
    depth = found["depth"] if "depth" in found else average(list(found["frames"]))
    return View(depth, found["K"], found["X_WC"])


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
