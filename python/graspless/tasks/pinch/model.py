# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of task files of kind pinch; docs/task-files.md describes the fields."""

from __future__ import annotations

from typing import Literal

from ..._core import pinch
from ..options import described_by
from ..shapes import Fields
from ..slide.model import OnSupport


@described_by(pinch.Options)
class Options(Fields):
    """Options of the search: docs/reference/options.md."""


class PinchTask(OnSupport):
    """A task for the pinch planner."""

    kind: Literal["pinch"]
    options: Options = Options.model_construct()
