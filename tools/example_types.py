#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the types of every example and of every block of Python in the README, as users would."""

from __future__ import annotations

import json
import pathlib
import subprocess
import sys
import tempfile

from blocks import ROOT, blocks


def sources() -> dict[str, str]:
    """Text of each script, notebook and block, by a name that may be a module's."""
    found = {
        f"example_{path.stem}": path.read_text(encoding="utf-8")
        for path in ROOT.glob("examples/*.py")
    }
    for path in ROOT.glob("examples/*.ipynb"):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        found[f"notebook_{path.stem}"] = "\n\n".join(code) + "\n"
    readme = [block for block in blocks(ROOT / "README.md") if block.language == "python"]
    return found | {f"readme_{block.line}": block.text for block in readme}


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sources().items():
            pathlib.Path(folder, f"{name}.py").write_text(text, encoding="utf-8")
        # A block of the README may use what the text around it names.
        quiet = ["--disable-error-code=name-defined", "--no-error-summary"]
        command = [sys.executable, "-m", "mypy", "--config-file", "pyproject.toml", *quiet, folder]
        return subprocess.run(command, cwd=ROOT, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
