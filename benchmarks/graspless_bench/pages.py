# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Templates of the pages of results, and the circumstances at the end of each page."""

from __future__ import annotations

import functools
import json
import re
import string
from pathlib import Path
from typing import TYPE_CHECKING

from .tables import markdown

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from .machine import Row
    from .tables import Column


@functools.cache
def template(page: str) -> dict[str, str]:
    """Returns the sections of a template by name. `head` is the text before the first."""
    text = (Path(__file__).parent / page / "page.md.template").read_text(encoding="utf-8")
    head, *parts = re.split(r"^<!-- (\w+) -->\n", text, flags=re.MULTILINE)
    return {"head": head.rstrip() + "\n"} | {
        name: body.rstrip() + "\n" for name, body in zip(parts[::2], parts[1::2], strict=True)
    }


def write_page(
    page: str, files: Iterable[str], fields: Callable[[Row], Mapping[str, str]], directory: Path
) -> None:
    """Writes PAGE.md: a section of each result in the directory, and their circumstances.

    Parameters
    ----------
    page : str
    files : iterable of str
        Results that there may be, in the order of the page: FILE.json, whose section is FILE
        without "PAGE_".
    fields : callable
        Returns what the section of a result says.
    directory : Path
    """
    sections = template(page)
    text, results = sections["head"], []
    for file in files:
        if (path := directory / f"{file}.json").exists():
            results.append(json.loads(path.read_text(encoding="utf-8")))
            section = string.Template(sections[file.removeprefix(f"{page}_")])
            text += "\n" + section.substitute(fields(results[-1]))
    end = string.Template(sections["circumstances"]).substitute(circumstances(results))
    (directory / f"{page}.md").write_text(text + "\n" + end, encoding="utf-8")


COMPLAINTS: list[Column] = [("complaints", lambda r: str(len(r["complaints"])))]


def circumstances(results: Iterable[Row], more: Iterable[Column] = COMPLAINTS) -> dict[str, str]:
    """Returns machines, versions, a table of commands, and the complaints of all results.

    `more`: further columns of the table.
    """
    ordered = list(results)
    machines = [f"{r['machine']['cpu']}, {r['machine']['cores']} cores" for r in ordered]
    rows = [{"name": f"`{r['machine']['command']}`", **r} for r in ordered]
    shown: list[Column] = [
        ("when", lambda r: r["machine"]["date"]),
        ("load before", lambda r: f"{r['machine']['load_before'][0]:g}"),
        ("load after", lambda r: f"{r['machine']['load_after'][0]:g}"),
        *more,
    ]
    return {
        "machine": ", or ".join(dict.fromkeys(machines)),
        "versions": ", ".join(
            f"{name} {version}" for name, version in ordered[0]["versions"].items()
        ),
        "table": markdown(rows, shown, "command"),
        "complaints": "\n".join(f"- {c}" for r in ordered for c in r.get("complaints", ())),
    }
