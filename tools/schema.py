# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes python/graspless/plan.schema.json from the models of plan files."""

import json
import pathlib

from graspless.plans.model import schema

TARGET = pathlib.Path(__file__).parents[1] / "python" / "graspless" / "plan.schema.json"


def text() -> str:
    """The JSON schema of plan files."""
    return json.dumps(schema(), indent=1) + "\n"


if __name__ == "__main__":
    TARGET.write_text(text())
