# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Examples that come with graspless, and a function that plans, checks and draws one."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from .. import _api, _data, files, progress, report, view
from .._load import load_task
from ..errors import TaskError, one_of
from ..kinds import KINDS


def names() -> dict[str, str]:
    """Returns each example with the line that describes it."""
    return {path.stem: _about(path) for path in sorted(_data.directory("examples").glob("*.yaml"))}


def find(name: str | None) -> Path:
    """Returns the task file of an example by kind, name, number or part of it; None: the first."""
    known = list(names())
    if name in KINDS:
        folder = _data.directory("examples")
        return next(path for path in sorted(folder.glob("*.yaml")) if _kind(path) == name)
    fits = [known[0]] if name is None else [stem for stem in known if name in stem]
    if name in known:
        fits = [str(name)]
    if not fits:
        raise TaskError(f"example: {name}: there is no such example{one_of(name, known)}")
    return _data.directory("examples") / f"{fits[0]}.yaml"


def run(name: str | None, directory: Path | None = None) -> bool:
    """Plans, checks and draws an example into a folder, and prints a summary.

    Parameters
    ----------
    name : str, optional
        As for `find`.
    directory : Path, optional
        Default: graspless_NAME in the working folder. Gets the task with the files it names,
        plan.json, and KIND.png and KIND.html of the task's kind.

    Returns
    -------
    bool
        True if a plan was found and holds.
    """
    source = find(name)
    directory = directory or Path(f"graspless_{source.stem}")
    task_file = _copy(source, directory)
    task = load_task(task_file)
    with progress.waiting("planning"):
        plan = _api.plan(task)
    faults = _api.check(plan) if plan else []
    plan.save(directory / "plan.json")
    with progress.waiting("drawing"):
        view.write_png(plan, directory / f"{plan.kind}.png")
        view.write_html(plan, directory / f"{plan.kind}.html")
    print(f"{source.stem}: {_about(source)}")
    print(report.as_text(plan))
    print(report.verdict(plan, faults))
    pictures = f"{plan.kind}.png, {plan.kind}.html"
    print(f"written: {directory}/ with {task_file.name}, plan.json, {pictures}")
    return bool(plan) and not faults


def _copy(source: Path, directory: Path) -> Path:
    """Copies a task, and the data files of the same name, into a folder of the user."""
    files.make_folder(directory)
    with files.writing(directory):
        for path in source.parent.glob(f"{source.stem}.*"):
            if path.suffix != ".py":
                shutil.copy(path, directory / path.name)
    return directory / source.name


def _kind(path: Path) -> str:
    """Returns the kind of a task file."""
    stated = re.search(r"^kind: (\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)
    return stated[1] if stated else ""


def _about(path: Path) -> str:
    lines = path.read_text(encoding="utf-8").splitlines()
    about = (line[2:] for line in lines if line.startswith("# ") and "SPDX" not in line)
    return next(about, "")
