# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Diagnostics of the node: what it lacks, and what became of its goals."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

if TYPE_CHECKING:
    from .node import GrasplessNode


def diagnostics_of(node: GrasplessNode) -> list[Any]:
    """Returns one DiagnosticStatus for each thing that the node depends on."""
    oldest, late = node.settings.joint_state_seconds, node.joints.out_of_order
    return [
        _age(node, "joint states", node.joints.age(), oldest, out_of_order=late),
        _age(node, "depth image", node.camera.age(node.seconds()), node.settings.image_seconds),
        _controllers(node),
        _goals(node),
    ]


def _status(node: GrasplessNode, name: str, level: bytes, text: str, **values: Any) -> Any:
    pairs = [KeyValue(key=key, value=str(value)) for key, value in values.items()]
    return DiagnosticStatus(
        level=level, name=f"{node.get_name()}: {name}", message=text, values=pairs
    )


def _age(node: GrasplessNode, name: str, age: float | None, most: float, **values: Any) -> Any:
    if age is None:
        return _status(node, name, DiagnosticStatus.WARN, "none was heard", **values)
    level = DiagnosticStatus.OK if age <= most else DiagnosticStatus.STALE
    return _status(node, name, level, f"{age:.2f} s old", age=f"{age:.3f}", **values)


def _controllers(node: GrasplessNode) -> Any:
    absent = node.controllers.absent()
    if not node.settings.controllers:
        return _status(node, "controllers", DiagnosticStatus.WARN, "none is configured")
    level = DiagnosticStatus.WARN if absent else DiagnosticStatus.OK
    text = f"nobody serves {', '.join(absent)}" if absent else "all are there"
    return _status(node, "controllers", level, text)


def _goals(node: GrasplessNode) -> Any:
    values = {
        "under_way": node.desk.size,
        "faults_in_callbacks": node.faults,
        "clock_jumps": node.jumps,
        "refused_transforms": node.transforms.refused,
        "refused_object_poses": node.poses.refused,
        **node.desk.counts,
    }
    level = DiagnosticStatus.ERROR if node.faults else DiagnosticStatus.OK
    text = f"{node.desk.size} under way" if node.is_active else "not active"
    return _status(node, "goals", level, text, **values)
