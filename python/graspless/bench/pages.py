# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pages of results share: templates in sections, and the circumstances at their end."""

from __future__ import annotations

import functools
import re
from pathlib import Path
from typing import TYPE_CHECKING

from .report import markdown

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .report import Column
    from .summary import Row


@functools.cache
def template(page: str) -> dict[str, str]:
    """Sections of PAGE.md.template by name; head is what comes before the first."""
    text = (Path(__file__).parent / f"{page}.md.template").read_text()
    head, *parts = re.split(r"^<!-- (\w+) -->\n", text, flags=re.MULTILINE)
    return {"head": head.rstrip() + "\n"} | {
        name: body.rstrip() + "\n" for name, body in zip(parts[::2], parts[1::2], strict=True)
    }


def circumstances(results: Iterable[Row]) -> dict[str, str]:
    """When, where and with what results were measured, and what of them does not hold."""
    ordered = list(results)
    machine = ordered[0]["machine"]
    rows = [{"name": f"`{r['machine']['command']}`", **r} for r in ordered]
    shown: list[Column] = [
        ("when", lambda r: r["machine"]["date"]),
        ("load before", lambda r: f"{r['machine']['load_before'][0]:g}"),
        ("load after", lambda r: f"{r['machine']['load_after'][0]:g}"),
        ("does not hold", lambda r: str(len(r["complaints"]))),
    ]
    return {
        "machine": f"{machine['cpu']}, {machine['cores']} cores",
        "versions": ", ".join(
            f"{name} {version}" for name, version in ordered[0]["versions"].items()
        ),
        "table": markdown(rows, shown, "command"),
        "complaints": "\n".join(f"- {c}" for r in ordered for c in r["complaints"]),
    }
