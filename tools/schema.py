# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the JSON schemas of plan files and of trajectory files from their models."""

import json
import pathlib

from graspless.formats.json_model import schema as trajectory_schema
from graspless.plan_files.table import schema

PACKAGE = pathlib.Path(__file__).parents[1] / "python" / "graspless"
TARGET = PACKAGE / "plan.schema.json"
TRAJECTORY = PACKAGE / "trajectory.schema.json"


def text() -> str:
    """The JSON schema of plan files, with one definition a line."""
    published = schema()
    definitions = published.pop("$defs")
    lines = ",\n".join(f"  {json.dumps({name: d})[1:-1]}" for name, d in definitions.items())
    return f'{{\n "$defs": {{\n{lines}\n }},\n {json.dumps(published)[1:-1]}\n}}\n'


def trajectory_text() -> str:
    """The JSON schema of trajectory files."""
    return json.dumps(trajectory_schema(), indent=1) + "\n"


if __name__ == "__main__":
    TARGET.write_text(text(), encoding="utf-8")
    TRAJECTORY.write_text(trajectory_text(), encoding="utf-8")
