# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Demonstrations of the planner: episodes that held, recorded one by one and written together."""

from __future__ import annotations

import json
import shutil
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import __version__, files
from .._arguments import require_integer
from ..errors import TaskError
from ..perception.arrays import packed
from . import lerobot, video
from .draws import SENTENCES
from .env import RATE, PlanEnv

if TYPE_CHECKING:
    from collections.abc import Callable

_MISSES = 20  # episodes in a row that may fail


def demonstrate(
    name: str,
    folder: str | Path,
    episodes: int,
    *,
    seed: int = 0,
    varied: bool = False,
    images: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> int:
    """Runs the planner's actions in an environment and writes the episodes that held.

    Episodes are kept in the folder `FOLDER.part` until all are there. After an interruption, the
    same call goes on from there. Which episodes are written depends on the seed alone.

    Parameters
    ----------
    name : str
        Which tasks: SlideToEdge, Tumble, Clasp or Pick.
    folder : str or Path
        A new folder, for a LeRobotDataset v3.0: `observation.state`, `action` and `next.reward`,
        50 frames a second. Written whole or not at all.
    episodes : int
        Number of episodes with reward 1.
    seed : int
        Seed of the first episode; the next one has the next seed.
    varied : bool
        As of PlanEnv.
    images : bool
        Add a video, `observation.images.front`: what `PlanEnv.render` returns.
    progress : callable, optional
        Called with the numbers of episodes that held and that were tried.

    Returns
    -------
    int
        Number of episodes that were tried.

    Raises
    ------
    TaskError
        There are no such tasks, a number is not whole or too small, the folder exists or cannot be
        written, `FOLDER.part` is of another call, 20 episodes in a row did not hold, or images
        cannot be rendered.
    """
    episodes = require_integer("episodes", episodes, least=1)
    seed, folder = require_integer("seed", seed, least=0), Path(folder)
    if (folder / "meta" / "info.json").is_file():
        raise TaskError(f"{folder}: is a complete recording: should be a new folder")
    if folder.exists():
        raise TaskError(f"{folder}: cannot be written: it exists already; should be a new folder")
    files.check_writable(folder)
    if images:
        video.encoder()  # before a folder is made
    env = PlanEnv(name, varied=varied, render_mode="rgb_array" if images else None)
    settings = {"name": name, "varied": varied, "images": images, "version": __version__}
    takes = _Takes(env, folder.with_name(f"{folder.name}.part"), settings)
    kept: list[Path] = []
    tried = misses = 0
    while len(kept) < episodes:
        take = takes.path(seed + tried)
        tried, misses = tried + 1, misses + 1
        if take is not None:
            kept.append(take)
            misses = 0
        if misses == _MISSES:
            raise TaskError(f"{name}: {_MISSES} episodes in a row did not hold")
        if progress is not None:
            progress(len(kept), tried)
    with files.new_folder(folder) as made:
        lerobot.write(env, kept, SENTENCES[name], made)
    shutil.rmtree(takes.folder)
    return tried


def _is_whole(path: Path) -> bool:
    """False if an episode is to be recorded: there is no file, or a crash has left a part of it."""
    try:
        with path.open("rb") as file, np.load(file):
            return True
    except (EOFError, OSError, ValueError, zipfile.BadZipFile):
        return False


class _Takes:
    """Episodes of the planner in a folder of their own, each recorded once.

    Parameters
    ----------
    env : PlanEnv
    folder : Path
        Made if it is missing.
    settings : dict
        What the episodes depend on besides their seeds. Raises TaskError if the folder has others.
    """

    def __init__(self, env: PlanEnv, folder: Path, settings: dict[str, Any]) -> None:
        self._env, self.folder = env, folder
        note = folder / "settings.json"
        files.make_folder(folder)
        if not any(folder.iterdir()):
            files.write(note, json.dumps(settings))
        found = json.loads(note.read_text(encoding="utf-8")) if note.is_file() else None
        if found != settings:
            raise TaskError(
                f"{folder}: has episodes of other settings, {found}: should be removed, or the "
                f"dataset be given another name"
            )

    def path(self, seed: int) -> Path | None:
        """Returns the file of an episode, recorded now or before; None if it did not hold."""
        path = self.folder / f"{seed}.npz"
        if not _is_whole(path):
            files.write(path, packed(self._record(seed, path.with_suffix(".mp4")) or {}))
        with np.load(path) as found:
            return path if found.files else None

    def _record(self, seed: int, film: Path) -> lerobot.Columns | None:
        """Returns the columns of an episode of the planner; None if it did not hold."""
        env = self._env
        observation, _ = env.reset(seed=seed)
        rows: list[tuple[Any, Any, float]] = []
        pictures = []
        has_ended = False
        info: dict[str, Any] = {}
        while not has_ended:
            if env.render_mode is not None:
                pictures.append(env.render())
            action = env.expert()
            after, reward, has_ended, _, info = env.step(action)
            rows.append((observation, action, reward))
            observation = after
        if not info["is_success"]:
            return None
        states, actions, rewards = zip(*rows, strict=True)
        columns = {
            "observation.state": np.array(states),
            "action": np.array(actions),
            "next.reward": np.array(rewards, dtype=np.float32),
        }
        if pictures:
            video.write(film, pictures, RATE)
            columns[video.KEY] = video.histogram(pictures)
        return columns
