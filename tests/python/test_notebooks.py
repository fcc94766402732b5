# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks of examples/ run from top to bottom, and are saved without output."""

import ast
import json
import pathlib
import sys
import webbrowser
from types import SimpleNamespace

import pytest

NOTEBOOKS = sorted((pathlib.Path(__file__).parents[2] / "examples").glob("*.ipynb"))


def code_cells(path):
    cells = json.loads(path.read_text())["cells"]
    return [cell for cell in cells if cell["cell_type"] == "code"]


def test_there_is_one_per_planner():
    assert [path.stem for path in NOTEBOOKS] == ["clasp", "fingertip", "slide"]


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_runs(path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    pytest.importorskip("viser")
    opened = []
    monkeypatch.setattr(webbrowser, "open", lambda url: opened.append(url) or True)
    names, shown = {}, []
    for cell in code_cells(path):
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, path.name, "exec"), names)
        if last is not None:  # what a notebook shows below the cell
            shown.append(eval(compile(ast.Expression(last.value), path.name, "eval"), names))
    pictures = [value._repr_html_() for value in shown if hasattr(value, "_repr_html_")]
    assert len(pictures) == 1
    assert "data:image/png;base64," in pictures[0]
    assert len(opened) == 1
    pathlib.Path(opened[0].removeprefix("file://")).unlink()
    assert capsys.readouterr().out


@pytest.mark.parametrize("known", [False, True])
def test_a_notebook_that_ran_no_magic_shows_figures(monkeypatch, known):
    from matplotlib.figure import Figure

    from graspless.view import notebook

    printers = {Figure: print} if known else {}
    formatters = {"image/png": SimpleNamespace(type_printers=printers)}
    shell = SimpleNamespace(kernel=1, display_formatter=SimpleNamespace(formatters=formatters))
    asked = []
    tools = SimpleNamespace(select_figure_formats=lambda *given: asked.append(given))
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setitem(sys.modules, "IPython.core", SimpleNamespace(pylabtools=tools))
    monkeypatch.setitem(sys.modules, "IPython.core.pylabtools", tools)
    notebook.let_figures_show()
    assert asked == ([] if known else [(shell, {"png"})])


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_is_saved_without_output(path):
    for cell in code_cells(path):
        assert (cell["outputs"], cell["execution_count"]) == ([], None)
