# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists the code blocks of README.md and the site; tests/python/test_docs.py runs them."""

from __future__ import annotations

import pathlib
import re
from typing import NamedTuple

ROOT = pathlib.Path(__file__).parents[1]
FENCE = re.compile(
    r"(?P<note><!-- not run: (?P<reason>[^>]+) -->\n)?^(?P<indent> *)```(?P<language>\w+)\n"
    r"(?P<text>.*?)^(?P=indent)```$",
    re.MULTILINE | re.DOTALL,
)


class Block(NamedTuple):
    """A fenced block of code."""

    page: pathlib.Path
    line: int
    language: str
    text: str
    reason: str | None  # why it is not run, or None

    @property
    def file(self) -> str | None:
        """Name of the file that the block shows: its first line is a comment with that name."""
        found = re.match(r"(?:#|//|<!--) ([\w./-]+\.\w+)(?: -->)?\n", self.text)
        return found[1] if found else None


def pages() -> list[pathlib.Path]:
    """Returns README.md, CONTRIBUTING.md and every page of the site."""
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def blocks(page: pathlib.Path) -> list[Block]:
    """Returns the fenced blocks of a page that name a language, in order."""
    text = page.read_text(encoding="utf-8")
    return [
        Block(
            page,
            text.count("\n", 0, found.start("text")) + 1,
            found["language"],
            re.sub(f"^{found['indent']}", "", found["text"], flags=re.MULTILINE),
            found["reason"],
        )
        for found in FENCE.finditer(text)
    ]
