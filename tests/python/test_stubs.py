# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The committed stubs are those of the extensions: run `make stubs` after a change of bindings."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]


def stubs_below(root):
    folders = (root / "python" / "graspless" / "_core", root / "benchmarks" / "graspless_bench")
    paths = [path for folder in folders for path in folder.glob("*.pyi")]
    return {str(path.relative_to(root)): path.read_text() for path in paths}


def test_stubs_are_those_of_the_extensions(tmp_path):
    subprocess.run([sys.executable, ROOT / "tools" / "stubs.py", tmp_path], check=True)
    made = stubs_below(tmp_path)
    assert len(made) > 10
    assert made == stubs_below(ROOT)
