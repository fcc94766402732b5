# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writer of a LeRobotDataset, version 3.0."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from .. import files
from . import video
from .env import RATE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .env import PlanEnv

_DATA = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
_VIDEO = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
_CHUNK = 1000  # files in a folder
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

_FILM = {  # feature of the video
    "dtype": "video",
    "shape": [video.HEIGHT, video.WIDTH, 3],
    "names": ["height", "width", "channels"],
    "info": {
        "video.height": video.HEIGHT,
        "video.width": video.WIDTH,
        "video.codec": "av1",
        "video.pix_fmt": video.PIXELS,
        "video.is_depth_map": False,
        "video.fps": RATE,
        "video.channels": 3,
        "has_audio": False,
    },
}

Columns = dict[str, "NDArray[Any]"]


def write(env: PlanEnv, takes: Sequence[Path], sentence: str, folder: Path) -> None:
    """Writes a dataset.

    Parameters
    ----------
    env : PlanEnv
        Its names are those of the columns.
    takes : sequence of Path
        Files of the episodes: the arrays of `observation.state`, `action` and `next.reward`, and
        with a video beside them, of the same name, the histogram of its pixels.
    sentence : str
        The task in words.
    folder : Path
        Is made.
    """
    episodes = [dict(np.load(take)) for take in takes]
    films = [episode.pop(video.KEY) for episode in episodes if video.KEY in episode]
    lengths = [len(episode["action"]) for episode in episodes]
    columns = _columns(episodes, lengths)
    for place in ("data/chunk-000", "meta/episodes/chunk-000"):
        (folder / place).mkdir(parents=True)
    table = pa.table({name: _array(values) for name, values in columns.items()})
    pq.write_table(table, folder / "data" / _FIRST)
    rows = _rows(columns, lengths, sentence)
    stats = {name: _statistics(values) for name, values in columns.items()}
    info = _info(env, columns, len(episodes))
    if films:
        _add_films(takes, films, lengths, rows, folder)
        stats[video.KEY] = _statistics_of_pixels(sum(films), sum(lengths))
        info |= {"video_path": _VIDEO, "features": info["features"] | {video.KEY: _FILM}}
    pq.write_table(pa.Table.from_pylist(rows), folder / "meta/episodes" / _FIRST)
    tasks = pa.table({"task_index": pa.array([0]), "task": pa.array([sentence])})
    labels = {"pandas": json.dumps(_LABELS)}
    pq.write_table(tasks.replace_schema_metadata(labels), folder / "meta/tasks.parquet")
    files.write(folder / "meta/info.json", json.dumps(info, indent=2))
    files.write(folder / "meta/stats.json", json.dumps(stats, indent=2))


def _columns(episodes: list[Columns], lengths: list[int]) -> Columns:
    """Returns the columns of all episodes, and those that number their frames."""
    columns = {name: np.concatenate([e[name] for e in episodes]) for name in episodes[0]}
    frames = np.concatenate([np.arange(length) for length in lengths])
    return columns | {
        "timestamp": (frames / RATE).astype(np.float32),
        "frame_index": frames,
        "episode_index": np.repeat(np.arange(len(episodes)), lengths),
        "index": np.arange(len(frames)),
        "task_index": np.zeros(len(frames), dtype=np.int64),
    }


def _add_films(
    takes: Sequence[Path],
    films: list[NDArray[np.int64]],
    lengths: list[int],
    rows: list[dict[str, Any]],
    folder: Path,
) -> None:
    """Copies the videos, one file an episode, and tells the rows of the episodes where they are."""
    for k, (take, film, length, row) in enumerate(zip(takes, films, lengths, rows, strict=True)):
        place = {"chunk_index": k // _CHUNK, "file_index": k % _CHUNK}
        target = folder / _VIDEO.format(video_key=video.KEY, **place)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(take.with_suffix(".mp4"), target)
        span = {"from_timestamp": 0.0, "to_timestamp": length / RATE}
        row |= {f"videos/{video.KEY}/{what}": value for what, value in (place | span).items()}
        of_episode = _statistics_of_pixels(film, length)
        row |= {f"stats/{video.KEY}/{what}": value for what, value in of_episode.items()}


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


def _statistics_of_pixels(counts: NDArray[np.int64], frames: int) -> dict[str, list[Any]]:
    """Returns the statistics of a histogram [3, 256], values from 0 to 1, each [3, 1, 1]."""
    values = np.arange(256) / 255
    shares = counts / counts.sum(axis=1, keepdims=True)
    mean = shares @ values
    found = {"mean": mean, "std": np.sqrt(np.maximum(shares @ values**2 - mean**2, 0))}
    found["min"] = values[np.argmax(counts > 0, axis=1)]
    found["max"] = values[255 - np.argmax(counts[:, ::-1] > 0, axis=1)]
    below = np.cumsum(shares, axis=1)
    for q in _QUANTILES:
        found[f"q{round(100 * q):02}"] = values[np.argmax(below >= q, axis=1)]
    return {what: v.reshape(3, 1, 1).tolist() for what, v in found.items()} | {"count": [frames]}


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
        "chunks_size": _CHUNK,
        "data_files_size_in_mb": 100,
        "video_files_size_in_mb": 500,
        "fps": RATE,
        "splits": {"train": f"0:{episodes}"},
        "data_path": _DATA,
        "video_path": None,
        "features": features,
    }
