# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Signals at any moment: the exit code tells, and never a traceback."""

import pathlib
import signal
import subprocess
import sys

import pytest

from tasks_common import GOOD
from timing_common import planned

# Sends a signal to itself when a module is about to be imported.
SCRIPT = """
import os, runpy, sys
_, module, number, *arguments = sys.argv

class Sender:
    def find_spec(self, name, path=None, target=None):
        if name == module:
            os.kill(os.getpid(), int(number))

sys.argv[1:] = arguments
sys.meta_path.insert(0, Sender())
runpy.run_module("graspless", run_name="__main__", alter_sys=True)
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize(
    "module", ["graspless.cli", "argparse", "numpy", "pydantic", "graspless._core", "yaml"]
)
def test_signal_while_a_module_is_imported(tmp_path, module, number):
    pathlib.Path(tmp_path / "task.yaml").write_text(GOOD)
    command = [sys.executable, "-c", SCRIPT, module, str(int(number)), "plan", "task.yaml"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, timeout=60)
    assert (done.returncode, done.stderr) == (128 + number, "interrupted\n")
    assert not (tmp_path / "plan.json").exists()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("output", ["e.mcap", "bag"])
def test_signal_during_an_import_leaves_no_folder(tmp_path, output, number):
    planned("slide").save(tmp_path / "plan.json")
    module = "rosbags.serde.primitives"  # imported when the first message is written
    asked = ["export", "plan.json", "--to", "mcap", "-o", output]
    command = [sys.executable, "-c", SCRIPT, module, str(int(number)), *asked]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, timeout=60)
    assert (done.returncode, done.stderr) == (128 + number, "interrupted\n")
    assert [path.name for path in tmp_path.iterdir()] == ["plan.json"]
