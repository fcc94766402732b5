# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A task that is good, as text, for tests that break it."""

GOOD = """\
kind: slide
robot:
  urdf: wam_t42
  home: {wam_joint_2: 0.2, wam_joint_4: 1.6, wam_joint_6: 1.2}
object:
  name: card
  rectangle: {size: [0.10, 0.08]}
  thickness: 0.004
  pose: {x: 0.60, y: 0.10, yaw: 0.3}
support:
  rectangle: {center: [0.65, 0.0], size: [0.7, 0.7]}
  height: 0.0
budget: {seconds: 20, seed: 3}
"""


def changed(old: str, new: str, text: str = GOOD) -> str:
    """The good task with one part replaced; the part must be there once."""
    assert text.count(old) == 1, old
    return text.replace(old, new)
