# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The committed stubs are those of the extension: run `make stubs` after a change of bindings."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]
COMMITTED = ROOT / "python" / "graspless" / "_core"


def test_stubs_are_those_of_the_extension(tmp_path):
    subprocess.run([sys.executable, ROOT / "tools" / "stubs.py", tmp_path / "stubs"], check=True)
    made = {path.name: path.read_text() for path in (tmp_path / "stubs").iterdir()}
    committed = {path.name: path.read_text() for path in COMMITTED.iterdir()}
    assert made == committed
