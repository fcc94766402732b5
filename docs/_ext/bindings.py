# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes autodoc's pages of a pybind11 extension readable: signatures, overloads, plain text."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sphinx.application import Sphinx

SIMPLER = [
    (r"typing\.Annotated\[numpy\.typing\.ArrayLike, [^\]]*\]", "ArrayLike"),
    (r"typing\.Annotated\[numpy\.typing\.NDArray\[[^\]]*\], [^\]]*\"\]", "NDArray"),
    (r"numpy\.typing\.NDArray\[[^\]]*\]", "NDArray"),
    (r"typing\.SupportsFloat \| typing\.SupportsIndex", "float"),
    (r"typing\.SupportsInt \| typing\.SupportsIndex", "int"),
    (r"(typing|collections\.abc)\.(?=[A-Z])", ""),
    (r"graspless\._core\.(?=\w+\.)", "graspless."),
    (r"<(\w+\.\w+): -?\d+>", r"\1"),
    (r"self: [\w.]+(, )?", ""),
]
OVERLOAD = re.compile(r"^\d+\. (\w+\(.*\).*)$")


def simpler(signature: str) -> str:
    """Returns a signature of pybind11 with the types that a reader would write."""
    for pattern, text in SIMPLER:
        signature = re.sub(pattern, text, signature)
    return signature


def is_bound(thing: Any) -> bool:
    """Returns True for everything that comes from the extension."""
    return "graspless._core" in str(getattr(thing, "__module__", "")) or (
        type(thing).__name__ in ("builtin_function_or_method", "instancemethod")
    )


def on_signature(
    app: Sphinx, what: str, name: str, thing: Any, options: Any, signature: Any, returned: Any
) -> tuple[str | None, str | None] | None:
    """Simplifies a signature."""
    if signature is None:
        return None
    return simpler(signature), None if what == "class" else simpler(returned or "")


def on_docstring(
    app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]
) -> None:
    """Protects plain text from being read as markup."""
    if what == "property":
        lines[:0] = ["..", ""]  # a comment, or napoleon takes words before a colon for a type
    if not is_bound(getattr(thing, "fget", thing)):
        return
    for k, line in enumerate(lines):
        overload = OVERLOAD.match(line.strip())
        if overload:
            lines[k] = f"``{simpler(overload[1])}``"
        else:
            lines[k] = re.sub(r"(?<!\\)([*|])", r"\\\1", line)


def setup(app: Sphinx) -> dict[str, Any]:
    """Registers both hooks, before napoleon's."""
    app.setup_extension("sphinx.ext.autodoc")
    app.connect("autodoc-process-signature", on_signature)
    app.connect("autodoc-process-docstring", on_docstring, priority=100)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
