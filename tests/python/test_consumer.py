# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A C++ project of somebody else finds an installed graspless and uses it."""

import os
import pathlib
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


@pytest.mark.slow
@pytest.mark.skipif(not (BUILD / "CMakeCache.txt").exists(), reason="no build/make: make test")
def test_consumer_builds_and_runs(tmp_path):
    prefix, build = tmp_path / "prefix", tmp_path / "build"
    run("cmake", "--install", BUILD, "--component", "cpp", "--prefix", prefix)
    launcher = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", "")
    run(
        "cmake", "-S", ROOT / "tests" / "consumer", "-B", build, "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}",
    )  # fmt: skip
    run("cmake", "--build", build)
    urdf = prefix / "share" / "graspless" / "urdf" / "wam_t42.urdf"
    name, segments, cost = run(build / "consumer", urdf).split()
    assert (name, segments) == ("wam_t42", "7")
    assert 0.1 < float(cost) < 0.11  # the way of the fingers, and a little for stability
