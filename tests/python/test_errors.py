# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exceptions of libraries and of the program, and warnings."""

import errno
import subprocess
import sys
import warnings
import zipfile

import pytest

import graspless
from graspless import perception
from graspless.cli import main
from graspless.errors import told, warn
from graspless.perception import scene_files
from graspless.tasks import clouds, reading
from tasks_common import GOOD


class JobTimeoutError(Exception):
    """Raised by a signal handler, as job queues do."""


def late(*given, **named):
    raise JobTimeoutError("too long")


@pytest.mark.parametrize("error", [JobTimeoutError("x"), TimeoutError("x"), UserWarning("x")])
def test_exceptions_of_the_program_pass(error):
    with pytest.raises(type(error), match="^x$"), told("task.yaml"):
        raise error


@pytest.mark.parametrize("error", [RuntimeError("x"), zipfile.BadZipFile("x"), MemoryError()])
def test_exceptions_of_libraries_name_the_file(error):
    with pytest.raises(graspless.TaskError, match=r"^task.yaml: "), told("task.yaml"):
        raise error


@pytest.mark.parametrize(
    ("module", "name"), [(reading, "_load"), (reading, "_require_value"), (reading, "check_yaml")]
)
def test_a_timeout_while_a_task_is_read_is_no_fault_of_the_task(
    tmp_path, monkeypatch, module, name
):
    (tmp_path / "task.yaml").write_text(GOOD)
    monkeypatch.setattr(module, name, late)
    with pytest.raises(JobTimeoutError):
        graspless.load_task(tmp_path / "task.yaml")


def test_a_timeout_while_points_are_read_is_no_fault_of_the_points(tmp_path, monkeypatch):
    (tmp_path / "points.xyz").write_text("0 0 0")
    monkeypatch.setattr(clouds, "_read_xyz", late)
    with pytest.raises(JobTimeoutError):
        clouds.read_cloud(tmp_path / "points.xyz")
    monkeypatch.setattr(scene_files, "read_arrays", late)
    fields = scene_files.SceneFields.model_construct(points="points.xyz")
    with pytest.raises(JobTimeoutError):
        scene_files._clouds(fields, None, tmp_path)


def test_warnings_have_a_class_of_their_own():
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        warn("odd")
    assert [warning.category for warning in caught] == [graspless.GrasplessWarning]


TIMING = """
import sys, threading
from graspless.timing import fastest
assert "matplotlib" not in sys.modules
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from toppra import parametrizer
assert parametrizer.plt.figure is plt.figure
"""


def test_timing_does_without_matplotlib():
    """Which needs a folder to write to. Who asks toppra for a plot gets it."""
    subprocess.run([sys.executable, "-c", TIMING], check=True)


LATER = """
import sys
from graspless.timing.later import imported_later
with imported_later("wave", "xml", "xml.dom"):
    import wave
    import xml.dom as dom
    assert type(sys.modules["wave"]).__name__ == "_Later"
    assert callable(wave.open)   # is imported now, for the others too
    assert dom.Node.ELEMENT_NODE == 1
assert type(sys.modules["wave"]).__name__ == "module"
import xml
assert type(xml.dom).__name__ == "module"
"""


def test_modules_are_imported_when_they_are_used():
    subprocess.run([sys.executable, "-c", LATER], check=True)


@pytest.mark.parametrize("error", [OSError("no folder"), OSError(errno.EROFS, "read-only")])
def test_errors_of_libraries_are_not_those_of_stdout(error, monkeypatch, capsys):
    def fail(*given, **named):
        raise error

    monkeypatch.setattr(perception, "perceive_views", fail)
    monkeypatch.setattr("graspless.perception.cli.kind_of", lambda path: "arrays")
    monkeypatch.setattr("graspless.perception.cli.read_view", lambda *given: None)
    monkeypatch.setattr("graspless.perception.front.warn_of_camera", lambda *given: None)
    assert main(["see", "image.npz", "--json"]) == 2
    told = capsys.readouterr().err
    assert told.startswith("see: ")
    assert "stdout" not in told
