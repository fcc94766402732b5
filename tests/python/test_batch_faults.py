# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Batches under faults of the machine; tests/torture/batch.py does it with more tasks."""

import importlib.util
import pathlib
import subprocess
import sys

import pytest

from graspless import TaskError
from graspless.batches import manifest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "torture"))
import batch

CASES = [case for case in batch.CASES if case != "dask" or importlib.util.find_spec("distributed")]


def test_nothing_is_lost_or_done_twice(tmp_path):
    for case, told, faults, _ in batch.torture(tmp_path, 20, CASES):
        assert faults == [], f"{case}: {told}"


def test_loss_and_double_work_are_seen(tmp_path):
    (tmp_path / "plans").mkdir()
    given = batch.Batch(tmp_path, 2)
    log = tmp_path / "plans" / "batch.jsonl"
    log.write_text('{"name": "card_0000", "status": "solved"}\n' * 2)
    (tmp_path / "plans" / ".card_0000.plan.json.abc").write_text("")
    given.before = {"card_0000": {"name": "card_0000", "status": "solved", "seconds": 1}}
    assert given.faults({"card_0000": b"a plan", "card_0001": b"a plan"}) == [
        "1 rows twice",
        "card_0000 has another plan",
        "card_0001 is lost",
        "card_0000 was planned again",
        ".card_0000.plan.json.abc is left",
    ]


def test_row_on_a_full_disk(tmp_path):
    """A row is cut short; the message names the file, and the next batch goes on after it."""
    path, code = tmp_path / "batch.jsonl", (
        "import sys, resource, pathlib; from graspless.batches import manifest\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n"
        "with manifest.opened(pathlib.Path(sys.argv[1])) as log:\n"
        "    for i in range(9): log.add({'name': f'card_{i}', 'status': 'solved'})\n"
    )  # fmt: skip
    done = subprocess.run([sys.executable, "-c", code, path], capture_output=True, text=True)
    assert done.stderr.endswith(f"TaskError: {path}: cannot be written: File too large\n")
    assert len(path.read_bytes()) == 100
    assert list(manifest.read(path)) == ["card_0", "card_1"]
    with manifest.opened(path) as log:
        log.add({"name": "card_2"})
    assert list(manifest.read(path)) == ["card_0", "card_1", "card_2"]


def test_rows_with_any_text_are_read(tmp_path):
    path = tmp_path / "batch.jsonl"
    rows = [{"name": f"card_{i}", "reason": f"a{end}b"} for i, end in enumerate("\n\r\x85\u2028")]
    manifest.rewrite(path, rows)
    assert list(manifest.read(path).values()) == rows


def test_manifest_that_is_a_device_is_not_read(tmp_path):
    (tmp_path / "batch.jsonl").symlink_to("/dev/full")
    assert manifest.read(tmp_path / "batch.jsonl") == {}
    with (
        pytest.raises(TaskError, match="cannot be written: No space left on device"),
        manifest.opened(tmp_path / "batch.jsonl") as log,
    ):
        log.add({"name": "a"})
