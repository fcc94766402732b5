# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench see`."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graspless._commands import FOUND
from graspless.errors import TaskError

from ..arguments import check_writable, positive

if TYPE_CHECKING:
    import argparse


def add_parser(experiments: Any) -> None:
    """Adds `see` to the experiments."""
    parser = experiments.add_parser(
        "see",
        help="tables and objects in depth images",
        description="Renders each mesh of a folder on a table, as a depth camera sees it from two "
        "sides with three levels of noise, and compares what is perceived with the truth.",
    )
    parser.add_argument("folder", type=Path, help="folder of meshes (.stl, .obj, .off, .ply) [m]")
    parser.add_argument(
        "--poses", type=positive(int), default=10, metavar="N", help="poses of each mesh (10)"
    )
    parser.add_argument("--mesh", action="append", metavar="NAME", help="only this one; repeat")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="seed of the poses (1)")
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.add_argument("--out", type=Path, metavar="DIR", help="write see.json and see.md there")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import report
    from .run import run

    paths = chosen(options.folder, options.mesh)
    if options.out is not None:
        check_writable(options.out)
    load = os.getloadavg()
    bar = Bar("bench see", len(paths))
    rows = run(paths, options.poses, options.seed, bar.tell)
    bar.close()
    result = report.as_result(rows, load)
    if options.out is not None:
        report.write(result, options.out)
    print(json.dumps(result) if options.json else report.as_text(result))
    return FOUND


def chosen(folder: Path, names: list[str] | None) -> list[Path]:
    """Returns the meshes of a folder, or those of the names. Raises TaskError if there is none."""
    from .scenes import meshes

    if not folder.is_dir():
        raise TaskError(f"{folder}: no such folder")
    known = {path.stem: path for path in meshes(folder)}
    if not known:
        raise TaskError(f"{folder}: has no meshes (.stl, .obj, .off, .ply)")
    for name in names or []:
        if name not in known:
            raise TaskError(f"--mesh: {name}: no such mesh (one of: {', '.join(known)})")
    return [known[name] for name in names] if names else list(known.values())
