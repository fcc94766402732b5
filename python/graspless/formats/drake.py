# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Folder that Drake reads: model directives, and PiecewisePolynomials of joints and object.

Drake itself is not needed to write it.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import files, frames
from ..kinds import stages_of
from .drake_robot import ROOT, fingers_urdf, robot_urdf
from .drake_sdf import Meshes, model_sdf
from .fingers import centers
from .mujoco_scene import OBJECT, finger_names
from .numbers import plain
from .things import things

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from ..frames import Matrix
    from ..timing import Trajectory

PACKAGE = "graspless_plan"  # of the URIs in the folder
SURROUNDINGS = "surroundings"


def write(trajectory: Trajectory, path: Path | str) -> None:
    """Writes a new folder, whole or not at all."""
    with files.new_folder(path) as folder:
        folder.mkdir()
        _write_folder(trajectory, folder)


def _write_folder(trajectory: Trajectory, folder: Path) -> None:
    found, robot = things(trajectory)
    meshes = Meshes()
    tips = finger_names(trajectory)
    fingers = [thing for thing in found if thing.name in tips]
    fixed = [t for t in found if t.name != OBJECT and t not in fingers]
    written = {"object.sdf": model_sdf([t for t in found if t.name == OBJECT], OBJECT, meshes)}
    if robot is not None:
        names, X_WB = list(trajectory.joint_names), np.asarray(robot.X_WB)
        fields = stages_of(trajectory.plan)[0].task.fields.robot
        written["robot.urdf"] = robot_urdf(robot, fields, meshes)
        positions, velocities = trajectory.positions, trajectory.velocities
    else:
        names, X_WB = [f"{finger.name}_{axis}" for finger in fingers for axis in "xyz"], np.eye(4)
        written["robot.urdf"] = fingers_urdf(fingers)
        positions = np.array([centers(trajectory, k).ravel() for k in range(len(trajectory))])
        velocities = None
    if fixed:
        written[f"{SURROUNDINGS}.sdf"] = model_sdf(fixed, SURROUNDINGS, meshes, is_static=True)
    start = dict(zip(names, positions[0], strict=True))
    written["scene.dmd.yaml"] = _directives(start, X_WB, trajectory.object_poses[0], bool(fixed))
    written["joints.yaml"] = _polynomial(trajectory.times, positions, velocities)
    written["object.yaml"] = _polynomial(trajectory.times, _quaternions_first(trajectory))
    written["package.xml"] = f'<package format="2"><name>{PACKAGE}</name></package>\n'
    for name, content in (written | meshes.files).items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(content, encoding="utf-8")


def _directives(start: dict[str, float], X_WB: Matrix, X_WO: Matrix, is_surrounded: bool) -> str:
    """Returns model directives with the start as the default state."""
    lines = [f"      {json.dumps(name)}: [{plain(value)}]\n" for name, value in start.items()]
    joints = "".join(lines)
    text = (
        "directives:\n"
        f"- add_model:\n    name: robot\n    file: package://{PACKAGE}/robot.urdf\n"
        f"    default_joint_positions:\n{joints}"
        f"- add_weld:\n    parent: world\n    child: robot::{ROOT}\n    X_PC: {_transform(X_WB)}\n"
        f"- add_model:\n    name: {OBJECT}\n    file: package://{PACKAGE}/object.sdf\n"
        f"    default_free_body_pose:\n      {OBJECT}: {_transform(X_WO)}\n"
    )
    if is_surrounded:
        text += (
            f"- add_model:\n    name: {SURROUNDINGS}\n"
            f"    file: package://{PACKAGE}/{SURROUNDINGS}.sdf\n"
        )
    return text


def _transform(X: Matrix) -> str:
    """Returns a pose as Drake's directives write it: with an axis and an angle."""
    w, *v = frames.to_quaternion(X)
    length = float(np.linalg.norm(v))
    angle = 2 * np.degrees(np.arctan2(length, w))
    axis = plain(np.array(v) / length) if length > 0 else [0.0, 0.0, 1.0]
    place = plain(np.asarray(X)[:3, 3])
    return f"{{translation: {place}, rotation: !AngleAxis {{angle_deg: {angle}, axis: {axis}}}}}"


def _quaternions_first(trajectory: Trajectory) -> Matrix:
    """[N, 7] qw qx qy qz x y z, as Drake orders a free body; quaternions do not change sign."""
    rows = frames.to_rows(trajectory.object_poses)[:, [3, 4, 5, 6, 0, 1, 2]]
    turns = np.einsum("ij,ij->i", rows[:-1, :4], rows[1:, :4]) < 0
    rows[1:, :4] *= np.where(np.cumsum(turns) % 2, -1.0, 1.0)[:, None]
    return rows


def _polynomial(times: Matrix, values: Matrix, rates: Matrix | None = None) -> str:
    """Returns a PiecewisePolynomial of values [N, n]: cubic if their rates are known, else linear.

    Its coefficients count from the begin of each piece, the constant first.
    """
    steps, rise = np.diff(times)[:, None], np.diff(values, axis=0)
    pieces: NDArray[np.float64]
    if rates is None:
        pieces = np.stack([values[:-1], rise / steps], axis=-1)
    else:
        slope, before, after = rise / steps, rates[:-1], rates[1:]
        square = (3 * slope - 2 * before - after) / steps
        cube = (before + after - 2 * slope) / steps**2
        pieces = np.stack([values[:-1], before, square, cube], axis=-1)
    lines: list[Any] = [f"- {json.dumps([[row] for row in plain(piece)])}\n" for piece in pieces]
    return f"breaks: {json.dumps(plain(times))}\npolynomials:\n{''.join(lines)}"
