# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Imports for the process that workers are forked from: what planning a task of any kind needs."""

from .. import carry, chain, clasp, fingertip, pinch, slide
from ..kinds import KINDS, part
from . import work

ROOMS = [part(room, kind) for room in ("tasks", "timing", "plan_files", "report") for kind in KINDS]

__all__ = ["ROOMS", "carry", "chain", "clasp", "fingertip", "pinch", "slide", "work"]
