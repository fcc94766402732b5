# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip tasks that are good, as text, for tests that break them."""

import tasks_common

PUSH = """\
kind: fingertip
object:
  name: block
  box: [0.05, 0.10, 0.05]
  mass: 1.0
fingers: {count: 2, radius: 0.01, max_normal_force: 10, friction: 0.7}
friction: 0.5
motion:
  slide: {translation: [0.05, 0, 0], segments: 6}
options: {locations_per_side: 5}
budget: {seconds: 20, seed: 3}
"""

# Along a wall with friction of its own, on the side of -y.
ALONG_WALL = PUSH.replace(
    "motion:",
    "walls:\n  - {name: rail, normal: [0, 1, 0], offset: -0.05, friction: 0.2}\nmotion:",
)

TUMBLE = """\
kind: fingertip
object: {name: block, box: [0.05, 0.05, 0.10], mass: 1.0}
walls:
  - {name: behind, normal: [1, 0, 0], offset: -0.03}
  - {name: beside, normal: [0, -1, 0], offset: -0.03}
motion:
  tumble: {over: +x, segments: 30}
budget: {seconds: 20}
"""


def changed(old, new, text=PUSH):
    """The good task with one part replaced; the part must be there once."""
    return tasks_common.changed(old, new, text)
