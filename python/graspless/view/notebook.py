# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans in notebooks, and replays in the web browser."""

from __future__ import annotations

import base64
import sys
import tempfile
import webbrowser
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import report
from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure

    from .._plan import Plan

HEIGHT = 600  # of an inline replay [pixels]


def show(plan: Plan) -> None:
    """Shows a replay: inline in a notebook, otherwise in the web browser.

    The browser's file stays in the folder for temporary files: it may be read after this program.
    """
    from .replay import as_html

    page = as_html(plan)
    if _in_notebook():
        from IPython.display import HTML, display

        display(HTML(_frame(page)))
        return
    with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
        file.write(page)
    if not webbrowser.open(Path(file.name).as_uri()):
        print(f"no web browser was found; the replay is in {file.name}")


def html(plan: Plan, draw: Callable[[Plan], Figure]) -> str:
    """Returns the summary of a plan, and its picture if matplotlib is installed."""
    text = f"<pre>{escape(report.as_text(plan))}</pre>"
    try:
        from .figures import as_png

        picture = as_png(draw(plan))
    except (ImportError, TaskError):
        return text
    data = base64.b64encode(picture).decode()
    return f'{text}<img src="data:image/png;base64,{data}" style="max-width: 100%">'


def let_figures_show() -> None:
    """Makes a notebook draw figures of matplotlib, also before `%matplotlib` was run."""
    if not _in_notebook():
        return
    from IPython import get_ipython
    from IPython.core.pylabtools import select_figure_formats
    from matplotlib.figure import Figure

    shell: Any = get_ipython()
    formatters = shell.display_formatter.formatters.values()
    if not any(Figure in formatter.type_printers for formatter in formatters):
        select_figure_formats(shell, {"png"})


def _frame(page: str) -> str:
    return f'<iframe srcdoc="{escape(page)}" width="100%" height="{HEIGHT}" style="border: 0">'


def _in_notebook() -> bool:
    shell: Any = sys.modules.get("IPython") and sys.modules["IPython"].get_ipython()
    return bool(shell) and hasattr(shell, "kernel")
