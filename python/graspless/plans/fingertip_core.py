# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Between the rows of a fingertip plan's file and the planner's own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import fingertip, frames
from .joints import to_rows

if TYPE_CHECKING:
    from .fingertip import Segment


def core_rows(segment: Segment) -> list[fingertip.Row]:
    """The rows of a segment in the planner's own type."""
    modes = fingertip.FingerMode.__members__
    rows = []
    for i, touches in enumerate(segment.touches):
        fingers = [
            fingertip.FingerState(
                touches=bool(touching),
                p_OC=segment.fingers[i, k] if touching else np.zeros(3),
                n_O=segment.normals[i, k] if touching else np.array([0.0, 0.0, 1.0]),
                mode=modes[segment.modes[i][k]],
                commanded_force=segment.commanded_forces[i, k],
                nominal_force_O=segment.nominal_forces[i, k],
            )
            for k, touching in enumerate(touches)
        ]
        rows.append(
            fingertip.Row(
                X_WO=segment.object_poses[i],
                fingers=fingers,
                stability=segment.stability[i],
                compliant_stability=segment.compliant_stability[i],
                nominal_margin=segment.nominal_margin[i],
            )
        )
    return rows


def segment_document(segment: fingertip.Segment) -> dict[str, Any]:
    """A segment as it stands in a plan file."""
    rows = segment.rows
    return {
        "name": segment.name,
        "finger": segment.finger,
        "X_WO": [frames.to_row(X) for X in segment.X_WO],
        "object_poses": [frames.to_row(row.X_WO) for row in rows],
        "fingers": [[f.p_OC.tolist() if f.touches else None for f in r.fingers] for r in rows],
        "normals": [[f.n_O.tolist() if f.touches else None for f in r.fingers] for r in rows],
        "modes": [[f.mode.name for f in row.fingers] for row in rows],
        "commanded_forces": [[float(f.commanded_force) for f in row.fingers] for row in rows],
        "nominal_forces": [[f.nominal_force_O.tolist() for f in row.fingers] for row in rows],
        "stability": [float(row.stability) for row in rows],
        "compliant_stability": [float(row.compliant_stability) for row in rows],
        "nominal_margin": [float(row.nominal_margin) for row in rows],
    }


def realization_document(found: fingertip.Realization) -> dict[str, Any]:
    """Joint paths as they stand in a plan file."""
    return {
        "found": found.found,
        "reason": found.reason,
        "joint_names": list(found.joint_names),
        "finger_of_fingertip": list(found.finger_of_fingertip),
        "segments": [
            {
                "name": segment.name,
                "plan_segment": segment.plan_segment,
                "scrub": segment.scrub,
                "positions": to_rows(segment.positions),
                "object_poses": [frames.to_row(X_WO) for X_WO in segment.X_WO],
            }
            for segment in found.segments
        ],
    }
