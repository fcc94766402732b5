# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A directive that writes the help of every command, as the terminal shows it."""

from __future__ import annotations

import argparse
import os
from typing import TYPE_CHECKING, Any
from unittest import mock

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from graspless import cli

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sphinx.application import Sphinx

COLUMNS = "86"  # of the help: no line is wider than the page
NOT_INSTALLED = "bench"  # is part of a checkout only


def commands(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    """Returns the parsers of a parser's commands by name."""
    found = (a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    return next((dict(action.choices) for action in found), {})


def helps(parser: argparse.ArgumentParser) -> Iterator[tuple[str, str]]:
    """Yields name and help of a command, then of those in it."""
    yield parser.prog, parser.format_help()
    for inner in commands(parser).values():
        yield from helps(inner)


class Commands(SphinxDirective):
    """Sections of all commands of graspless."""

    def run(self) -> list[nodes.Node]:
        sections: list[nodes.Node] = []
        with mock.patch.dict(os.environ, {"COLUMNS": COLUMNS}):
            for name in commands(cli.make_parser("")):
                if name == NOT_INSTALLED:
                    continue
                for title, text in helps(commands(cli.make_parser(name))[name]):
                    section = nodes.section(ids=[nodes.make_id(title)])
                    section += nodes.title(text=title)
                    section += nodes.literal_block(text, text, language="none")
                    sections.append(section)
        return sections


def setup(app: Sphinx) -> dict[str, Any]:
    """Registers the directive."""
    app.add_directive("commands", Commands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
