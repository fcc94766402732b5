# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same task gives the same plan file; tests/torture/determinism.py does more of it."""

import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "torture"))
import determinism

ALL_AT_ONCE = determinism.Condition(
    "all at once",
    (("PYTHONHASHSEED", "4711"), ("OMP_NUM_THREADS", "2"), ("OPENBLAS_NUM_THREADS", "2")),
    order="random",
    callers=2,
    threads=8,
    load=1,
)


@pytest.mark.parametrize(
    ("kind", "count"), [("slide", 14), ("fingertip", 7), ("clasp", 3), ("carry", 14), ("chain", 7)]
)
def test_the_same_plans_under_other_conditions(kind, count):
    assert list(determinism.compare(kind, count, (ALL_AT_ONCE,))) == [("all at once", {})]


def test_a_difference_is_seen(tmp_path):
    for name, texts in (("a", (b"1\n2", b"3")), ("b", (b"1\n2", b"4"))):
        (tmp_path / name).mkdir()
        for i, text in enumerate(texts):
            (tmp_path / name / f"{i}.json").write_bytes(text)
    found = determinism.differences(tmp_path / "a", tmp_path / "b", 2)
    assert found == {1: (b"3", b"4")}
    clock, threads = determinism.CLOCK.sub, determinism.THREADS.sub
    assert clock(rb"\1T", b'"stability_seconds": 1e-3}') == b'"stability_seconds": T}'
    assert threads(rb"\1N", b'"threads": 8, "seed": 8') == b'"threads": N, "seed": 8'
