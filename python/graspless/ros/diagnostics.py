# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Diagnostics of the node: what it lacks, and what became of its goals."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .goals import Desk


def _status(name: str, level: bytes, text: str, **values: Any) -> Any:
    pairs = [KeyValue(key=key, value=str(value)) for key, value in values.items()]
    return DiagnosticStatus(level=level, name=name, message=text, values=pairs)


def age_status(name: str, age: float | None, most: float, **values: Any) -> Any:
    """Returns the status of what is heard again and again; `most` is its largest age [s]."""
    if age is None:
        return _status(name, DiagnosticStatus.WARN, "none was heard", **values)
    level = DiagnosticStatus.OK if age <= most else DiagnosticStatus.STALE
    return _status(name, level, f"{age:.2f} s old", age=f"{age:.3f}", **values)


def controllers_status(absent: Sequence[str] | None) -> Any:
    """Returns the status of the controllers, some of them absent; None if none is configured."""
    if absent is None:
        return _status("controllers", DiagnosticStatus.WARN, "none is configured")
    level = DiagnosticStatus.WARN if absent else DiagnosticStatus.OK
    text = f"nobody serves {', '.join(absent)}" if absent else "all are there"
    return _status("controllers", level, text)


def goals_status(desk: Desk, is_active: bool, has_faults: bool, counts: dict[str, int]) -> Any:
    """Returns the status of the goals, with counts of the node and of its desk."""
    level = DiagnosticStatus.ERROR if has_faults else DiagnosticStatus.OK
    text = f"{desk.size} under way" if is_active else "not active"
    return _status("goals", level, text, under_way=desk.size, **counts, **desk.counts)


def statuses(node: Any) -> list[Any]:
    """Returns one DiagnosticStatus for each thing that a GrasplessNode depends on."""
    s, late = node.settings, node.joints.out_of_order
    counts = {
        "faults_in_callbacks": node.faults,
        "clock_jumps": node.jumps,
        "refused_transforms": node.transforms.refused,
        "refused_object_poses": node.poses.refused,
    }
    found = [
        age_status("joint states", node.joints.age(), s.joint_state_seconds, out_of_order=late),
        age_status("depth image", node.camera.age(node.seconds()), s.image_seconds),
        controllers_status(node.controllers.absent() if s.controllers else None),
        goals_status(node.desk, node.is_active, node.faults > 0, counts),
    ]
    for status in found:
        status.name = f"{node.get_name()}: {status.name}"
    return found
