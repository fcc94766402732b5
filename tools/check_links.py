# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every link within a built site leads somewhere: `check_links.py build/docs`.

Links of README.md and other pages outside the site to files of the checkout are checked too.
External links are not.
"""

from __future__ import annotations

import html.parser
import pathlib
import re
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).parents[1]
GENERATED = {"genindex.html", "search.html"}  # their links are Sphinx's own


class Page(html.parser.HTMLParser):
    """Links and anchors of an HTML page."""

    def __init__(self, path: pathlib.Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = {"", "top"}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collects what leads somewhere, and where something may lead."""
        for name, value in attrs:
            if name == "id" and value:
                self.anchors.add(value)
            if name in ("href", "src") and value:
                self.links.append(value)


def broken(folder: pathlib.Path) -> list[str]:
    """Returns the links of a site that lead nowhere."""
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    faults = []
    for path, page in pages.items():
        for link in page.links if path.name not in GENERATED else []:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                continue
            target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
            if not target.is_file():
                faults.append(f"{path}: {link}: no such file")
            elif (
                target in pages and urllib.parse.unquote(url.fragment) not in pages[target].anchors
            ):
                faults.append(f"{path}: {link}: no such anchor")
    return faults


def broken_in_markdown(path: pathlib.Path) -> list[str]:
    """Returns the links of a Markdown file to files that do not exist."""
    links = re.findall(r"\]\(([^)#\s]+)", path.read_text(encoding="utf-8"))
    files = [link for link in links if "://" not in link]
    return [f"{path}: {link}: no such file" for link in files if not (path.parent / link).exists()]


def main(folder: pathlib.Path) -> int:
    """Prints what is broken; returns the exit code."""
    faults = broken(folder.resolve())
    for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "urdf/README.md"):
        faults += broken_in_markdown(ROOT / name)
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
