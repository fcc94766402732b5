# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Templates of the pages of results, and the circumstances at the end of each page."""

from __future__ import annotations

import functools
import re
from pathlib import Path
from typing import TYPE_CHECKING

from .tables import markdown

if TYPE_CHECKING:
    from collections.abc import Iterable

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


def circumstances(results: Iterable[Row]) -> dict[str, str]:
    """Returns machines, versions, a table of commands, and the complaints of all results."""
    ordered = list(results)
    machines = [f"{r['machine']['cpu']}, {r['machine']['cores']} cores" for r in ordered]
    rows = [{"name": f"`{r['machine']['command']}`", **r} for r in ordered]
    shown: list[Column] = [
        ("when", lambda r: r["machine"]["date"]),
        ("load before", lambda r: f"{r['machine']['load_before'][0]:g}"),
        ("load after", lambda r: f"{r['machine']['load_after'][0]:g}"),
        ("complaints", lambda r: str(len(r["complaints"]))),
    ]
    return {
        "machine": ", or ".join(dict.fromkeys(machines)),
        "versions": ", ".join(
            f"{name} {version}" for name, version in ordered[0]["versions"].items()
        ),
        "table": markdown(rows, shown, "command"),
        "complaints": "\n".join(f"- {c}" for r in ordered for c in r["complaints"]),
    }
