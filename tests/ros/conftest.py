# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests with ROS 2: `tools/install-ros`, then build/ros/bin/python -m pytest tests/ros.

Nothing leaves this computer, and every run has a domain of its own.
"""

import os

import pytest

os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
os.environ["ROS_DOMAIN_ID"] = str(1 + os.getpid() % 100)
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command does: workers are forked
rclpy = pytest.importorskip("rclpy")
pytest.importorskip("graspless_msgs")

from rig import Bench  # noqa: E402


def pytest_configure(config):
    for what in ("module 'sre_", "Deprecated in favor of"):  # in lark, in rclpy
        config.addinivalue_line("filterwarnings", f"ignore:{what}:DeprecationWarning")


@pytest.fixture(scope="session")
def bench():
    """A node, and a robot that it moves, in one process; the clock is that of the robot."""
    made = Bench()
    yield made
    made.close()


@pytest.fixture
def bus(bench):
    """The bench with a robot that is at rest at home and does as it is told."""
    bench.rest()
    yield bench
    assert bench.node.faults == 0
    assert bench.node.desk.size == 0
