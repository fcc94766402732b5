# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Demonstrations of the planner as a LeRobotDataset, version 3.0, of states and actions."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from .. import files
from .._arguments import require_integer
from ..errors import TaskError
from .draws import SENTENCES
from .env import RATE, PlanEnv

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

_MISSES = 20  # episodes in a row that may fail
_DATA = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
_FIRST = "chunk-000/file-000.parquet"
_QUANTILES = (0.01, 0.10, 0.50, 0.90, 0.99)
_LABELS = {  # how pandas knows the sentence of a task as its index
    "index_columns": ["task"],
    "column_indexes": [],
    "columns": [
        {"name": "task_index", "field_name": "task_index", "pandas_type": "int64",
         "numpy_type": "int64", "metadata": None},
        {"name": "task", "field_name": "task", "pandas_type": "unicode",
         "numpy_type": "object", "metadata": None},
    ],
    "pandas_version": "2.0.0",
}  # fmt: skip

Columns = dict[str, "NDArray[Any]"]


def demonstrate(
    name: str,
    folder: str | Path,
    episodes: int,
    *,
    seed: int = 0,
    varied: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> int:
    """Runs the planner's actions in an environment and writes the episodes that held.

    Parameters
    ----------
    name : str
        Which tasks: SlideToEdge, Tumble, Clasp or Pick.
    folder : str or Path
        A new folder, for a LeRobotDataset v3.0 without images: `observation.state`, `action` and
        `next.reward`, 50 frames a second. Written whole or not at all.
    episodes : int
        Number of episodes with reward 1.
    seed : int
        Seed of the first episode; the next one has the next seed.
    varied : bool
        As of PlanEnv.
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
        written, or 20 episodes in a row did not hold.
    """
    episodes = require_integer("episodes", episodes, least=1)
    seed, folder = require_integer("seed", seed, least=0), Path(folder)
    files.check_writable(folder)
    if folder.exists():
        raise TaskError(f"{folder}: cannot be written: it exists already; should be a new folder")
    env, tried, misses = PlanEnv(name, varied=varied), 0, 0
    kept: list[Columns] = []
    while len(kept) < episodes:
        found = _episode(env, seed + tried)
        tried, misses = tried + 1, misses + 1
        if found is not None:
            kept.append(found)
            misses = 0
        if misses == _MISSES:
            raise TaskError(f"{name}: {_MISSES} episodes in a row did not hold")
        if progress is not None:
            progress(len(kept), tried)
    with files.new_folder(folder) as made:
        _write(env, kept, SENTENCES[name], made)
    return tried


def _episode(env: PlanEnv, seed: int) -> Columns | None:
    """Returns the columns of an episode of the planner; None if it did not hold."""
    observation, _ = env.reset(seed=seed)
    rows: list[tuple[Any, Any, float]] = []
    has_ended = False
    info: dict[str, Any] = {}
    while not has_ended:
        action = env.expert()
        after, reward, has_ended, _, info = env.step(action)
        rows.append((observation, action, reward))
        observation = after
    if not info["is_success"]:
        return None
    states, actions, rewards = zip(*rows, strict=True)
    return {
        "observation.state": np.array(states),
        "action": np.array(actions),
        "next.reward": np.array(rewards, dtype=np.float32),
    }


def _write(env: PlanEnv, episodes: list[Columns], sentence: str, folder: Path) -> None:
    lengths = [len(episode["action"]) for episode in episodes]
    columns = {name: np.concatenate([e[name] for e in episodes]) for name in episodes[0]}
    frames = np.concatenate([np.arange(length) for length in lengths])
    columns |= {
        "timestamp": (frames / RATE).astype(np.float32),
        "frame_index": frames,
        "episode_index": np.repeat(np.arange(len(episodes)), lengths),
        "index": np.arange(len(frames)),
        "task_index": np.zeros(len(frames), dtype=np.int64),
    }
    for place in ("data/chunk-000", "meta/episodes/chunk-000"):
        (folder / place).mkdir(parents=True)
    table = pa.table({name: _array(values) for name, values in columns.items()})
    pq.write_table(table, folder / "data" / _FIRST)
    rows = pa.Table.from_pylist(_rows(columns, lengths, sentence))
    pq.write_table(rows, folder / "meta/episodes" / _FIRST)
    tasks = pa.table({"task_index": pa.array([0]), "task": pa.array([sentence])})
    labels = {"pandas": json.dumps(_LABELS)}
    pq.write_table(tasks.replace_schema_metadata(labels), folder / "meta/tasks.parquet")
    info = _info(env, columns, len(episodes))
    (folder / "meta/info.json").write_text(json.dumps(info, indent=2))
    stats = {name: _statistics(values) for name, values in columns.items()}
    (folder / "meta/stats.json").write_text(json.dumps(stats, indent=2))


def _array(values: NDArray[Any]) -> Any:
    if values.ndim == 1:
        return pa.array(values)
    return pa.FixedSizeListArray.from_arrays(pa.array(values.ravel()), values.shape[1])


def _rows(columns: Columns, lengths: list[int], sentence: str) -> list[dict[str, Any]]:
    """Returns the row of each episode: where it is, and its statistics."""
    found, begin = [], 0
    for k, length in enumerate(lengths):
        row: dict[str, Any] = {"episode_index": k, "tasks": [sentence], "length": length}
        row |= {"data/chunk_index": 0, "data/file_index": 0}
        row |= {"dataset_from_index": begin, "dataset_to_index": begin + length}
        row |= {"meta/episodes/chunk_index": 0, "meta/episodes/file_index": 0}
        for name, values in columns.items():
            of_episode = _statistics(values[begin : begin + length])
            row |= {f"stats/{name}/{what}": value for what, value in of_episode.items()}
        found.append(row)
        begin += length
    return found


def _statistics(values: NDArray[Any]) -> dict[str, list[float]]:
    rows = np.asarray(values, dtype=float).reshape(len(values), -1)
    found = {what: getattr(rows, what)(axis=0).tolist() for what in ("min", "max", "mean", "std")}
    found["count"] = [len(rows)]
    for q in _QUANTILES:
        found[f"q{round(100 * q):02}"] = np.quantile(rows, q, axis=0).tolist()
    return found


def _info(env: PlanEnv, columns: Columns, episodes: int) -> dict[str, Any]:
    names = {"observation.state": env.names, "action": env.joint_names}
    features = {
        name: {
            "dtype": str(values.dtype),
            "shape": [*values.shape[1:]] or [1],
            "names": names.get(name),
        }
        for name, values in columns.items()
    }
    return {
        "codebase_version": "v3.0",
        "robot_type": "graspless",
        "total_episodes": episodes,
        "total_frames": len(columns["action"]),
        "total_tasks": 1,
        "chunks_size": 1000,
        "data_files_size_in_mb": 100,
        "video_files_size_in_mb": 500,
        "fps": RATE,
        "splits": {"train": f"0:{episodes}"},
        "data_path": _DATA,
        "video_path": None,
        "features": features,
    }
