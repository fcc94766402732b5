# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of the documentation site, which `make docs` builds into build/docs."""

from __future__ import annotations

import pathlib
import sys

ROOT = pathlib.Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "docs" / "_ext"))

project = "graspless"
author = "The graspless authors"
copyright = "2026, The graspless authors"

extensions = [
    "bindings",
    "breathe",
    "commands",
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
]
exclude_patterns = ["_ext", "_static", "Doxyfile"]
html_theme = "furo"
html_title = "graspless"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False

myst_enable_extensions = ["attrs_inline", "colon_fence", "deflist"]
myst_heading_anchors = 4

default_role = "code"  # docstrings quote code in single backticks
autoclass_content = "both"  # signature and text of the constructor too
autodoc_member_order = "groupwise"
autodoc_default_options = {"members": True}
python_use_unqualified_type_names = True
napoleon_google_docstring = False

breathe_projects = {"graspless": str(ROOT / "build" / "doxygen" / "xml")}
breathe_default_project = "graspless"
breathe_default_members = ("members", "undoc-members")
breathe_show_include = False

nitpicky = True
# Names of other libraries, names that a using-declaration or a member of that name hides, and
# words of docstrings that stand for a type.
nitpick_ignore_regex = [
    ("cpp:identifier", r"(Eigen|ompl|std|robot|collision)(::.*)?"),
    ("cpp:identifier", r"(Obstacle|FrictionInterval|FingerMode|\w+6d|Model|Data|Core)(::\w+)?"),
    ("py:.*", r"(?!graspless\.).*"),
    (
        "py:class",
        r"graspless\._any_plan\.AnyPlan|graspless\.tasks\.(\w+T|source\.Source)",
    ),  # what all plans share; type variables; what tasks tell faults by
]
suppress_warnings = ["ref.python"]  # of a name that several classes have as a property
