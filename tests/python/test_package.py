# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What an installed graspless holds."""

import importlib.metadata
import pathlib
import subprocess
import sys

import graspless
from graspless import _core
from graspless.cli import main
from graspless.errors import install_command

PACKAGE = pathlib.Path(graspless.__file__).parent


def test_extension_stands_beside_its_library():
    assert pathlib.Path(_core.__file__).parent == PACKAGE
    assert (PACKAGE / "libgraspless.so").is_file()


def test_extension_finds_the_library_of_its_own_package():
    loaded = subprocess.run(
        [sys.executable, "-c", "import graspless._core; print(open('/proc/self/maps').read())"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert {line.split()[-1] for line in loaded.splitlines() if "libgraspless" in line} == {
        str(PACKAGE / "libgraspless.so")
    }


def test_holds_types_robots_and_examples_but_no_headers():
    assert (PACKAGE / "py.typed").is_file()
    assert (PACKAGE / "_core" / "slide.pyi").is_file()
    assert (PACKAGE / "urdf" / "wam_t42.urdf").is_file()
    assert (PACKAGE / "examples").is_dir()
    installed = [str(path) for path in importlib.metadata.files("graspless") or []]
    assert not [name for name in installed if name.endswith((".hpp", ".cmake", ".cpp"))]


def test_holds_no_benchmarks():
    installed = [str(path) for path in importlib.metadata.files("graspless") or []]
    assert not [name for name in installed if "bench" in name or "peers" in name]
    assert not hasattr(_core, "bench")
    symbols = pathlib.Path(_core.__file__).read_bytes()
    assert b"grasp_rrt" not in symbols


def test_bench_says_how_to_get_it(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "graspless_bench", None)
    for arguments in (["--help"], ["slide", "--json"]):
        assert main(["bench", *arguments]) == 2
        assert "`make bench-install`" in capsys.readouterr().err


def test_packages_of_an_extra_are_named_outside_a_checkout(monkeypatch, tmp_path):
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    command = install_command("sim")  # which includes the extra timing
    assert command.startswith("pip install 'scipy")
    assert "'toppra" in command
    assert "'mujoco" in command
    assert "graspless" not in command  # it is not on PyPI


def test_a_checkout_installs_an_extra_by_its_tool(monkeypatch, tmp_path):
    (tmp_path / "python" / "graspless").mkdir(parents=True)
    monkeypatch.setattr(sys, "prefix", str(tmp_path / ".venv"))
    assert install_command("rerun") == "tools/install rerun"


def test_version_is_that_of_the_metadata():
    assert graspless.__version__ == importlib.metadata.version("graspless")


def test_import_is_light():
    """Heavy packages load on first use."""
    program = """
import sys, numpy
before = len(sys.modules)
import graspless.slide
print(len(sys.modules) - before)
print(*(set(sys.modules) & {"pydantic", "trimesh", "yaml", "matplotlib", "viser", "scipy"}))
"""
    out = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    assert int(out[0]) < 50  # 32, with those of graspless and of Python itself
    assert out[1] == ""


def test_plan_imports_no_other_command_or_kind(tmp_path):
    program = """
import sys
from graspless.cli import main
from graspless.errors import install_command
main(["plan", sys.argv[1], "-o", sys.argv[2]])
print(*sys.modules)
"""
    card = PACKAGE / "examples" / "01_slide_card.yaml"
    arguments = [sys.executable, "-c", program, card, tmp_path / "plan.json"]
    done = subprocess.run(arguments, capture_output=True, text=True, check=True)
    modules = set(done.stdout.splitlines()[-1].split())
    assert "graspless.tasks.slide" in modules
    assert not modules & {
        *("graspless.batches", "graspless.formats", "graspless.simulation", "graspless.timing"),
        *("graspless.tasks.clasp", "graspless.tasks.fingertip", "graspless.tasks.chain"),
        *("matplotlib", "mujoco", "scipy", "trimesh", "viser", "xacro"),
    }
