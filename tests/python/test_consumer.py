# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A C++ project of somebody else finds an installed graspless and uses it."""

import os
import pathlib
import platform
import subprocess

import pytest

ROOT = pathlib.Path(__file__).parents[2]
BUILD = ROOT / "build" / "make"


def run(*command):
    done = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    if not (BUILD / "CMakeCache.txt").exists():
        pytest.skip("no build/make: make test")
    where = tmp_path_factory.mktemp("installed") / "prefix"
    run("cmake", "--install", BUILD, "--component", "cpp", "--prefix", where)
    return where


def configure(prefix, build, flags):
    launcher = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", "")
    run(
        "cmake", "-S", ROOT / "tests" / "consumer", "-B", build, "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}",
        f"-DCMAKE_CXX_FLAGS={flags}",
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("flags", ["-Wall -Wextra -Werror", "-fsanitize=address"])
def test_consumer_builds_and_runs(prefix, tmp_path, flags):
    configure(prefix, tmp_path, flags)
    run("cmake", "--build", tmp_path)
    urdf = prefix / "share" / "graspless" / "urdf" / "wam_t42.urdf"
    name, segments, cost = run(tmp_path / "consumer", urdf).split()
    assert (name, segments) == ("wam_t42", "7")
    assert 0.1 < float(cost) < 0.11  # the way of the fingers, and a little for stability


@pytest.mark.slow
@pytest.mark.skipif(platform.machine() != "x86_64", reason="-mavx is a flag of x86")
def test_other_vector_instructions_are_refused(prefix, tmp_path):
    configure(prefix, tmp_path, "-mavx")
    built = subprocess.run(
        ["cmake", "--build", tmp_path], capture_output=True, text=True, check=False
    )
    assert built.returncode != 0
    assert "compile both with the same -m flags" in built.stdout + built.stderr
