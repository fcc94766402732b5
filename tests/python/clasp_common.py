# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A purse before a KR5 with an SDH hand, as the tests of clasps need it."""

import functools

import numpy as np

import graspless
import tasks_common
from graspless import _data, clasp, frames, geometry, tasks
from graspless.robot import Robot

X_WO = frames.planar(0.62, 0.05, 0.3)  # [m, m, rad]

PURSE = """\
kind: clasp
robot: {urdf: kr5_sdh}
object:
  name: purse
  sample: purse
  pose: {position: [0.62, 0.05, 0], rpy: [0, 0, 0.3]}
budget: {seconds: 20, seed: 3}
"""


@functools.cache
def purse_plan():
    """The plan of PURSE."""
    plan = graspless.plan(tasks.read_task(PURSE, "purse.yaml"))
    assert plan, plan.reason
    return plan


def changed(old, new, text=PURSE):
    """The good task with one part replaced; the part must be there once."""
    return tasks_common.changed(old, new, text)


@functools.cache
def arm_and_hand():
    """kr5_sdh, its hand and where it stands."""
    stem = str(_data.directory("urdf") / "kr5_sdh")
    robot = Robot.from_urdf_file(f"{stem}.urdf")
    return robot, clasp.hand_from_yaml_file(f"{stem}.clasp.yaml"), np.array(robot.state("home"))


@functools.cache
def purse():
    """The object of 2000 points."""
    cloud = geometry.sample_surface(clasp.sample_object("purse"), 2000)
    return clasp.Object.from_cloud("purse", cloud)


def problem(**changes):
    """The purse in reach."""
    robot, hand, q_start = arm_and_hand()
    given = {"robot": robot, "hand": hand, "object": purse(), "X_WO": X_WO, "q_start": q_start}
    return clasp.Problem(**given | changes)
